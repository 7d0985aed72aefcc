"""Figures of vibroimpact results. One module per analysis type, listed in figure_list.py."""
