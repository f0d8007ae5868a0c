"""All that a figure of matplotlib holds, as a value to record: each artist with its numbers and looks, axes with limits, scales, ticks and legends."""

import numpy as np
from matplotlib.collections import Collection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.spines import Spine
from matplotlib.text import Annotation, Text


def colour(value):
    return "none" if value is None or (isinstance(value, str) and value == "none") else to_hex(value, keep_alpha=True)


def colours(values):
    """Each once, in the order of their first use, with how often it stands in a row."""
    found = []
    for one in map(colour, values):
        if found and found[-1][0] == one:
            found[-1][1] += 1
        else:
            found.append([one, 1])
    return [one if count == 1 else f"{one} x {count}" for one, count in found]


def numbers(values):
    return np.ma.filled(np.ma.asarray(values, float), np.nan).ravel()


def dash(value):
    """A pattern of dashes or its name."""
    return value if isinstance(value, str) else plain_dash(value)


def plain_dash(value):
    offset, pattern = value
    return [float(offset or 0.0), [] if pattern is None else [float(one) for one in pattern]]


def label(artist):
    text = str(artist.get_label() or "")
    return "" if text.startswith("_") else text


def coordinates(axes, artist):
    """Of x and y: whether they are those of the data."""
    return "".join("d" if one else "-" for one in artist.get_transform().contains_branch_seperately(axes.transData))


def line_of(axes, line):
    x, y = line.get_data(orig=False)
    marker = line.get_marker()
    looks = [colour(line.get_color()), dash(line.get_linestyle()), list(line._unscaled_dash_pattern[1] or []), line.get_linewidth(), line.get_alpha(), line.get_clip_on()]
    if marker not in ("", " ", "None", None):
        looks += [str(marker), line.get_markersize(), colour(line.get_markerfacecolor()), colour(line.get_markeredgecolor())]
    return {"line": label(line), "in": coordinates(axes, line), "x": numbers(x), "y": numbers(y), "looks": looks}


def patch_of(axes, patch):
    corners = patch.get_patch_transform().transform(patch.get_path().vertices)
    return {"patch": type(patch).__name__, "label": label(patch), "in": coordinates(axes, patch), "x": numbers(corners[:, 0]), "y": numbers(corners[:, 1]),
            "looks": [colour(patch.get_facecolor()), colour(patch.get_edgecolor()), patch.get_linewidth(), dash(patch.get_linestyle()), patch.get_hatch(), patch.get_fill()]}


def collection_of(axes, one):
    found = {"collection": type(one).__name__, "label": label(one), "in": coordinates(axes, one)}
    contours = vars(axes).get("orbearing_contours", [])
    if not any(one in getattr(drawn, "collections", ()) for drawn in contours):  # what contours show is told below
        corners = [path.vertices for path in one.get_paths()]
        corners = np.concatenate(corners) if corners else np.empty((0, 2))
        offsets = np.ma.filled(np.ma.asarray(one.get_offsets(), float), np.nan)
        found |= {"x": numbers(corners[:, 0]), "y": numbers(corners[:, 1]), "at": [numbers(offsets[:, 0]), numbers(offsets[:, 1])]}
        found["values"] = None if one.get_array() is None else numbers(one.get_array())
        found["ends of colours"] = None if one.get_array() is None else list(one.get_clim())
        found["sizes"] = numbers(one.get_sizes()) if hasattr(one, "get_sizes") else None
    if one.get_array() is not None:
        found["colours"] = one.get_cmap().name
    else:
        found["colours"] = [colours(one.get_facecolor()), colours(one.get_edgecolor())]
    found["lines"] = [numbers(one.get_linewidths()), [plain_dash(each) for each in one.get_linestyles()]]
    return found


def text_of(axes, text):
    found = {"text": text.get_text(), "at": [float(one) for one in text.get_position()], "in": coordinates(axes, text) if axes else "",
             "looks": [colour(text.get_color()), text.get_rotation(), text.get_horizontalalignment(), text.get_verticalalignment()]}
    if isinstance(text, Annotation):
        found |= {"of": [float(one) for one in text.xy], "coordinates": [str(type(one).__name__) if not isinstance(one, str) else one for one in (text.xycoords, text.anncoords)]}
        if text.arrow_patch is not None:
            found["arrow"] = [colour(text.arrow_patch.get_edgecolor()), text.arrow_patch.get_linewidth(), str(type(text.arrow_patch.get_arrowstyle()).__name__)]
    return found


def legend_of(legend):
    if legend is None:
        return None
    handles = [colour(one.get_color()) if hasattr(one, "get_color") and not isinstance(one, Collection) else type(one).__name__ for one in legend.legendHandles]
    return {"entries": [text.get_text() for text in legend.get_texts()], "of": handles, "title": legend.get_title().get_text(), "columns": legend._ncols, "where": legend._loc,
            "anchor": numbers(legend.get_bbox_to_anchor().bounds if legend._bbox_to_anchor is None else legend._bbox_to_anchor._bbox.bounds
                              if hasattr(legend._bbox_to_anchor, "_bbox") else [])}


def axis_of(axis):
    kind = lambda one: type(one).__name__  # noqa: E731
    at = axis.get_majorticklocs()
    return {"ticks": numbers(at), "names": axis.get_major_formatter().format_ticks(at), "scale": axis.get_scale(),
            "by": [kind(axis.get_major_locator()), kind(axis.get_minor_locator()), kind(axis.get_major_formatter()), kind(axis.get_minor_formatter())],
            "grid": bool(axis._major_tick_kw.get("gridOn")), "label": axis.get_label().get_text(), "side": axis.get_label_position()}


def second_axis_of(axes):
    """One that names the positions of another in its own way, with the ticks that are set."""
    axis = axes.xaxis if axes._orientation == "x" else axes.yaxis
    return {"kind": type(axes).__name__, "limits": list(axes.get_xlim()), "axis": axis_of(axis)}


def axes_of(axes):
    found = {"kind": axes.name, "title": [axes.get_title(loc=place) for place in ("left", "center", "right")], "limits": [list(axes.get_xlim()), list(axes.get_ylim())],
             "aspect": str(axes.get_aspect()), "shown": [axes.get_visible(), axes.axison], "x axis": axis_of(axes.xaxis), "y axis": axis_of(axes.yaxis),
             "spines": [name for name, spine in axes.spines.items() if spine.get_visible()], "legend": legend_of(axes.get_legend())}
    if axes.name == "polar":
        found["turned"] = [axes.get_theta_offset(), axes.get_theta_direction(), axes.get_rlabel_position()]
    drawn = []
    for artist in axes.get_children():
        if isinstance(artist, Line2D):
            drawn.append(line_of(axes, artist))
        elif isinstance(artist, Patch) and not isinstance(artist, Spine) and artist is not axes.patch:
            drawn.append(patch_of(axes, artist))
        elif isinstance(artist, Collection):
            drawn.append(collection_of(axes, artist))
        elif isinstance(artist, Text) and artist.get_text() and artist not in (axes.title, axes._left_title, axes._right_title):
            drawn.append(text_of(axes, artist))
        elif isinstance(artist, Text) and isinstance(artist, Annotation):  # an arrow alone
            drawn.append(text_of(axes, artist))
    found["artists"] = drawn
    found["contours"] = [[numbers(values) for values in one.orbearing_map] for one in vars(axes).get("orbearing_contours", [])]
    found["within"] = [axes_of(child) if hasattr(child, "get_title") else second_axis_of(child) for child in axes.child_axes]
    return found


def whole(figure: Figure):
    """The figure as dicts, lists, numbers and texts."""
    return {"inch": list(figure.get_size_inches()), "axes": [axes_of(axes) for axes in figure.axes], "legends": [legend_of(one) for one in figure.legends],
            "texts": [text_of(None, one) for one in figure.texts if one.get_text()], "heading": figure._suptitle.get_text() if figure._suptitle else ""}
