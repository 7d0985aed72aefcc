"""Figures of studies in the look of vibroimpact-plot, beside the page that shows them."""
import sys


def panels(study, rows, **more):
    """A figure with panels below each other, and the colours of curves."""
    sys.path.insert(0, str(study.arguments.source / "postprocess"))
    from vibroimpact.plots import style

    style.plt.rcParams.update(style.SETTINGS)
    figure, axes = style.panels(rows, **more)
    return figure, axes, style.COLOURS


def save(study, figure, name):
    """In the folder images/ beside the page, or nowhere without a page."""
    if study.arguments.page:
        figure.savefig(study.arguments.page.parent / "images" / name, dpi=110)
