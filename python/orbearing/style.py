"""One look for all figures: palette, sizes, fonts, and the way a figure becomes an SVG element."""

from __future__ import annotations

import html
import io
import re
import textwrap
import warnings
from pathlib import Path

import matplotlib
from cycler import cycler
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from orbearing.drawn import Panel, panels_of

# Palette of Okabe and Ito, distinguished with every common colour vision deficiency.
BLUE, ORANGE, GREEN, VERMILION = "#0072B2", "#E69F00", "#009E73", "#D55E00"
PURPLE, SKY, BLACK, GREY = "#CC79A7", "#56B4E9", "#1a1a1a", "#767676"
SERIES = (BLACK, BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY)
DASHES = ("-", "--", "-.", (0, (1, 1.2)), (0, (6, 1.5, 1, 1.5, 1, 1.5)), (0, (3, 1)), (0, (8, 3)))
LOAD_MAP = "Blues"

# A curve of more points than this is drawn without markers.
MOST_MARKERS = 60

# [inch]: at these sizes 9.5 pt text stays legible on a phone 360 pixels wide and on paper.
PANEL = (4.6, 3.7)
STACK = (5.6, 6.6)

SHEET = Path(__file__).resolve().with_name("orbearing.mplstyle")
RC = matplotlib.rc_params_from_file(SHEET, use_default_template=False)

# [dot/inch] of pictures in documents, which are as wide as a page: 7.2 inch.
DOTS = 130
WIDTH = 7.2  # [inch]


def use() -> None:
    """For scripts that draw pictures of documents: the same look, without a screen; each curve has its own dashes, so that it survives grey print."""
    matplotlib.rcdefaults()
    matplotlib.use("agg")
    matplotlib.rcParams.update(RC)
    matplotlib.rcParams.update({"axes.prop_cycle": cycler(color=SERIES) + cycler(linestyle=DASHES), "savefig.dpi": DOTS,
                               "text.parse_math": True})  # powers of ten on logarithmic axes


def tilt_text(tilt) -> str:
    """Heading of a panel for a stated tilt in mrad; None: it was computed."""
    return "tilt as computed" if tilt is None else f"tilt {tilt:.4g} mrad"


def context():
    """The settings above, for as long as the context lasts, on top of matplotlib's own defaults."""
    return matplotlib.rc_context({**matplotlib.rcParamsDefault, **RC, "backend": "agg"})


def thousands(axis) -> None:
    """Plain numbers with the thousands apart, also on a logarithmic axis."""
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.10g}".replace("-", "\u2212")))


def life_name(life_key: str = "life_h") -> str:
    """In a sentence: "life" of Lundberg and Palmgren, "L10mh"."""
    return "life" if life_key == "life_h" else life_key


def a_life(life_key: str = "life_h") -> str:
    """The same with its article."""
    return f"{'a' if life_key == 'life_h' else 'an'} {life_name(life_key)}"


def life_label(life_key: str = "life_h") -> str:
    """Of an axis of lives: "life of one bearing (h)", "L10mh of one bearing (h)"."""
    return f"{life_name(life_key)} of one bearing (h)"


def life_axis(axes: Axes, life_key: str = "life_h") -> None:
    """Logarithmic, with labels at 1, 2 and 5 of each decade where they have room."""
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    labelled = (1, 2, 5) if high < 1e3 * low else (1,)
    axes.yaxis.set_major_locator(LogLocator(subs=labelled, numticks=20))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_ylabel(life_label(life_key))
    thousands(axes.yaxis)


def panel(size: tuple[float, float] = PANEL) -> tuple[Figure, Axes]:
    """A figure with one pair of axes; `size` in inch."""
    figure = Figure(figsize=size)
    return figure, figure.add_subplot()


MOST_SPEEDS = 6  # labels that stand apart at half the width of a page


def speed_axis(axes: Axes) -> None:
    axes.set_xlabel("input speed (rpm)")
    if axes.get_xscale() == "linear":
        axes.xaxis.set_major_locator(MaxNLocator(MOST_SPEEDS))
    thousands(axes.xaxis)


def legend_above(axes: Axes, columns: int = 2, height: float = 1.02) -> None:
    """The legend stands above the axes, where it cannot cover data; `height` in heights of the axes."""
    axes.legend(loc="lower left", bbox_to_anchor=(0, height), borderaxespad=0, ncol=columns, columnspacing=1.4)


def legend_on_top(figure: Figure, axes: Axes, columns: int, height: float = 0.09) -> None:
    """One legend for all axes of a figure above them; `height` in heights of the figure."""
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - height))
    figure.legend(*axes.get_legend_handles_labels(), loc="upper center", ncols=columns)


def shade(axes: Axes, across, where, label: str) -> None:
    """A pale background over the stretches of `across` that `where` marks, if any; the limits are those of the data so far."""
    if any(where):
        limits = axes.get_ylim()
        axes.fill_between(across, 0, 1, where=where, transform=axes.get_xaxis_transform(), color=ORANGE, alpha=0.16,
                          linewidth=0, zorder=0, label=label)
        axes.set_ylim(limits)


def legend_label(text: str) -> str:
    """Wrapped, so that a long one cannot squeeze the axes; matplotlib leaves out labels that begin with an underscore."""
    wrapped = textwrap.fill(textwrap.shorten(text, 150, placeholder=" ..."), 50)
    return f" {wrapped}" if wrapped.startswith("_") else wrapped


def points_look(count: int, with_curve: bool = False) -> dict:
    """Points of a sweep: markers while they can be distinguished, joined where no finer curve runs through them."""
    few = count <= MOST_MARKERS
    return {} if few and with_curve else {"linestyle": "-", "linewidth": 0.9, **({} if few else {"marker": ""})}


class Picture(str):
    """An SVG element, with what it draws in numbers: `name` and `panels`, one for each pair of axes."""

    name: str
    panels: tuple[Panel, ...]


def to_svg(figure: Figure, slug: str, description: str) -> Picture:
    """The figure as an inline SVG element: no outside names, no date, identifiers unique by `slug`."""
    target = io.StringIO()
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Glyph .* missing")
        # Not by savefig, which draws all of it once more beforehand.
        FigureCanvasSVG(figure).print_svg(target, metadata={"Date": None, "Creator": None})
    picture = Picture(_inline(target.getvalue(), slug, description))
    picture.name, picture.panels = slug, panels_of(figure)
    return picture


def _inline(text: str, slug: str, description: str) -> str:
    """Strip what an HTML page neither needs nor may have twice."""
    text = text[text.index("<svg"):]
    text = re.sub(r"<!--.*?-->\n?|<metadata>.*?</metadata>\n?", "", text, flags=re.S)
    text = re.sub(r'\sxmlns(:xlink)?="[^"]*"', "", text).replace("xlink:href", "href")
    # matplotlib names clip paths by their address in memory: number them by first use instead.
    names = dict.fromkeys(re.findall(r'\bid="(p[0-9a-f]{10})"', text))
    for number, name in enumerate(names):
        text = text.replace(name, f"clip{number}")
    text = re.sub(r'\bid="', f'id="{slug}-', text)
    text = re.sub(r'href="#', f'href="#{slug}-', text)
    text = re.sub(r"url\(#", f"url(#{slug}-", text)
    # The width in points becomes the natural width; the page scales it down where it must.
    label = html.escape(description, quote=True)
    return text.replace("<svg", f'<svg role="img" aria-label="{label}"', 1).strip()
