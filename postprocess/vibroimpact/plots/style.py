"""The look of all figures, in one place."""

from __future__ import annotations

import re
import textwrap

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.ticker import FuncFormatter, MaxNLocator

WIDTH = 6.3  # inches, a page's text width
PANEL_HEIGHT = 1.9

# Okabe and Ito's palette: eight colours that the common colour-vision deficiencies keep apart;
# yellow is left out, it is too light for a line.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]
# Contacts have colours of their own, apart from those of the first points; shaded lightly behind. More of them
# share a sequence.
CONTACT_COLOURS = ["#CC79A7", "#E69F00", "#56B4E9", "#000000"]
CONTACT_SEQUENCE = "turbo"
POINT_COLOURS = ["#0072B2", "#D55E00", "#009E73", "#7F5539", "#6A4C93", "#000000"]
LONG_LEGEND = 11  # entries; more are set smaller
SHADE = 0.28  # opacity
DARK_SHADE = 0.5
SEQUENCE = "viridis"  # of fields
LINE_SEQUENCE = "plasma"  # of ordered families of lines,
LINE_RANGE = 0.78  # as far as it is dark enough on white
HIGHLIGHT = "#C00000"  # one member of a family,
BEHIND = "Blues"  # before the others
DIRECTION_LINES = ["-", "--"]
GREY = "#555555"

SETTINGS = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 10,
    "axes.labelsize": 10,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.titley": 1.0,  # not to be found from all tick labels, time and again
    "legend.fontsize": 9,
    "legend.frameon": False,
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.major.pad": 6,  # keeps the labels at a corner apart
    "ytick.major.pad": 5,
    "xtick.top": True,
    "ytick.right": True,
    "axes.linewidth": 0.7,
    "axes.grid": True,
    "grid.color": "#DDDDDD",
    "grid.linewidth": 0.5,
    "axes.axisbelow": True,
    "lines.linewidth": 1.1,
    "lines.markersize": 3.2,
    "axes.formatter.useoffset": False,
    "axes.xmargin": 0.02,
    "figure.constrained_layout.use": True,
    "savefig.dpi": 300,
}


def panels(rows: int, height: float = PANEL_HEIGHT, share_x: bool = True):
    """A figure with panels below each other; always a list of axes."""
    figure, axes = plt.subplots(
        rows, 1, figsize=(WIDTH, 0.7 + height * rows), sharex=share_x, squeeze=False
    )
    figure.align_ylabels()
    return figure, list(axes[:, 0])


def legend_beside(axes, handles=None, title=None) -> None:
    """Outside, on the right, where it hides nothing."""
    if handles is None:
        handles, _ = axes.get_legend_handles_labels()
    if handles:
        small = dict(fontsize=7.5, labelspacing=0.3) if len(handles) > LONG_LEGEND else {}
        axes.legend(
            handles=handles, loc="upper left", bbox_to_anchor=(1.01 + room_of_marks(axes), 1.02),
            borderaxespad=0.0, title=title, alignment="left", **small,
        )


def room_of_marks(axes) -> float:
    """What the labels of marked values beside the axes take, in widths of the axes."""
    beside = [re.sub(r"\\[a-z]+|[${}_^]", "", text.get_text()) for text in axes.texts if text.get_position()[0] > 1]
    return 0.016 * max(map(len, beside), default=0)


def legend_inside(axes, handles) -> None:
    """For axes with a colour bar on the right and room above their curves."""
    if handles:
        axes.legend(handles=handles, loc="best")


def legend_below(axes, handles) -> None:
    """For axes that have a colour bar on the right."""
    axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.0, -0.17), borderaxespad=0.0,
                ncols=2)


def colours_along(count: int, behind: bool = False):
    """Colours for an ordered family of curves: the palette for few, a sequence for many; blue ones behind a
    highlighted member."""
    if behind:
        return [plt.get_cmap(BEHIND)(0.45 + 0.55 * i / max(1, count - 1)) for i in range(count)]
    if count <= 3:
        return COLOURS[:count]
    sequence = plt.get_cmap(LINE_SEQUENCE)
    return [sequence(LINE_RANGE * i / (count - 1)) for i in range(count)]


def contact_colour(number: int, count: int):
    """Of one of `count` contacts, distinct from the others."""
    if count <= len(CONTACT_COLOURS):
        return CONTACT_COLOURS[number]
    return plt.get_cmap(CONTACT_SEQUENCE)(0.05 + 0.9 * number / (count - 1))


def colour_bar(figure, axes, values, label: str) -> None:
    """For families too large for a legend; colours as in colours_along()."""
    sequence = plt.get_cmap(LINE_SEQUENCE)
    shown = matplotlib.colors.ListedColormap([sequence(LINE_RANGE * i / 255) for i in range(256)])
    mappable = ScalarMappable(Normalize(min(values), max(values)), shown)
    figure.colorbar(mappable, ax=axes, label=label, pad=0.015)


def is_logarithmic(values) -> bool:
    """Whether coordinates are spaced by equal factors rather than equal steps, over a wide range."""
    values = np.asarray(values, dtype=float)
    if len(values) < 3 or np.any(values <= 0) or values.max() < 5 * values.min():
        return False
    steps, factors = np.diff(values), np.diff(np.log(values))
    return np.ptp(factors) / abs(factors.mean()) < 0.5 * np.ptp(steps) / abs(steps.mean())


def label_between_decades(axis) -> None:
    """Labels at 2 and 5 of each decade of a logarithmic axis where fewer than two powers of ten are in view; numbers of
    common size are then written out."""
    def few() -> bool:
        low, high = np.log10(np.sort(axis.get_view_interval()))
        return np.floor(high) - np.ceil(low) < 1

    def text(value: float, _) -> str:
        power = np.floor(np.log10(value) + 1e-9)
        digit = round(value / 10**power)
        if few() and abs(power) < 3:
            return f"{value:g}" if digit in (1, 2, 5) else ""
        if digit == 1:
            return rf"$10^{{{power:.0f}}}$"
        return rf"${digit}\cdot10^{{{power:.0f}}}$" if few() and digit in (2, 5) else ""
    axis.set_major_formatter(FuncFormatter(text))
    axis.set_minor_formatter(FuncFormatter(text))


def panel_grid(count: int, columns: int = 3, height: float = 2.0, share: bool = True,
               share_x: bool = True):
    """Panels side by side and below each other that may share both axes; unused ones are removed."""
    columns = min(columns, count)
    rows = -(-count // columns)
    figure, axes = plt.subplots(
        rows, columns, figsize=(WIDTH if columns > 1 else 4.2, 0.7 + height * rows),
        sharex=share and share_x, sharey=share, squeeze=False,
    )
    for used in axes.flat[:count]:
        used.xaxis.set_major_locator(MaxNLocator(4 if columns > 1 else 7))
    for unused in axes.flat[count:]:
        unused.remove()
    for unused in range(count, rows * columns):
        axes.flat[unused - columns].xaxis.set_tick_params(labelbottom=True)
    return figure, list(axes.flat[:count])


def panel_title(axes, text: str, panels, **look) -> None:
    """A title that stays above its own panel of a grid."""
    columns = max(panel.get_subplotspec().colspan.stop for panel in panels)
    text = re.sub(r" (?==)|(?<==) |(?<=\d) (?=[^\W\d])", "\N{NO-BREAK SPACE}", text)
    width = [60, 36, 24][min(columns, 3) - 1]
    shown = re.sub(r"[$\\{}_^]", "", text)
    axes.set_title(text if len(shown) <= width else textwrap.fill(text, width), **look)


def upper_right(panels):
    """The last panel of the first row of a grid, beside which a legend has room."""
    return [axes for axes in panels if axes.get_subplotspec().is_first_row()][-1]


def label_grid(panels, x_label: str, y_label: str) -> None:
    """Labels of a grid of panels at its left and lower edge."""
    columns = max(axes.get_subplotspec().colspan.stop for axes in panels)
    for number, axes in enumerate(panels):
        if axes.get_subplotspec().is_first_col():
            axes.set_ylabel(y_label)
        if number + columns >= len(panels):
            axes.set_xlabel(x_label)
