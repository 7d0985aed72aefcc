#!/usr/bin/env bash
# Runs and draws the figures of the gallery: scripts/draw-gallery.sh [--list] [--draw-only] [--jobs N] [--build DIR] [SYSTEM...]
# See scripts/draw_gallery.py.
exec /usr/bin/python3 -B "$(dirname "${BASH_SOURCE[0]}")/draw_gallery.py" "$@"
