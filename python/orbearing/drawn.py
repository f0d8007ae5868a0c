"""What a figure draws, in numbers: read from matplotlib's objects, so that it is what stands in the picture and not what was meant to."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PathCollection, PolyCollection, QuadMesh
from matplotlib.container import BarContainer
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure
from matplotlib.patches import Annulus, Circle, Polygon, Rectangle


@dataclass(frozen=True)
class Series:
    """One artist. Columns of numbers by its kind, in the units of the axes; none of a kind that is not listed:

    line, points: x, y; of points also sizes and what their colours show (empty without); band: x, low, high; shade: x; level: y; place: x;
    bars: places, lengths; segments: x, y of one end, x, y of the other; map: x, y, z (y, x), of contours also their levels; circle: x, y, radius, inner radius; area: corners' x, y.
    """

    kind: str
    label: str
    columns: tuple[np.ndarray, ...]
    marked: bool = False  # of a line: whether its points have markers


@dataclass(frozen=True)
class Panel:
    """One pair of axes, or a colour bar."""

    title: str
    x_label: str
    y_label: str
    x_limits: tuple[float, float]
    y_limits: tuple[float, float]
    texts: tuple[str, ...]
    ticks: tuple[tuple[str, ...], tuple[str, ...]]  # stated names along x and y
    legend: tuple[str, ...]
    series: tuple[Series, ...] = field(default=())


def states_map(drawn, x, y, z):
    """Keeps what contours were drawn from, which matplotlib does not; returns them."""
    drawn.orbearing_map = tuple(np.ma.filled(np.ma.asarray(values, float), np.nan) for values in (x, y, z, drawn.levels))
    vars(drawn.axes).setdefault("orbearing_contours", []).append(drawn)
    return drawn


def panels_of(figure: Figure) -> tuple[Panel, ...]:
    """Every pair of axes in the order of their making; those within others follow them."""
    found: list[Panel] = []
    for axes in figure.axes:
        found += [_panel(axes), *(_panel(child) for child in axes.child_axes if isinstance(child, Axes) and child.has_data())]
    return tuple(found)


def _panel(axes: Axes) -> Panel:
    title = next((text for text in (axes.get_title(loc) for loc in ("center", "left", "right")) if text), "")
    legend = axes.get_legend()
    ticks = tuple(tuple(label.get_text() for label in axis.get_majorticklabels()) for axis in (axes.xaxis, axes.yaxis))
    return Panel(title, axes.get_xlabel(), axes.get_ylabel(), axes.get_xlim(), axes.get_ylim(), tuple(text.get_text() for text in axes.texts),
                 ticks, tuple(text.get_text() for text in legend.get_texts()) if legend else (),
                 () if hasattr(axes, "_colorbar") else tuple(_series(axes)))


def _series(axes: Axes):
    maps: list[ContourSet] = []
    contours = vars(axes).get("orbearing_contours", [])
    bars = [container for container in axes.containers if isinstance(container, BarContainer)]
    for line in axes.lines:
        x, y = (np.ma.filled(np.ma.asarray(values, float), np.nan) for values in line.get_data(orig=False))
        across, up = line.get_transform().contains_branch_seperately(axes.transData)
        kind, columns = ("line", (x, y)) if across and up else ("place", (x,)) if across else ("level", (y,))
        yield Series(kind, _label(line), columns, line.get_marker() not in ("", " ", "None", None))
    for container in bars:
        boxes = np.array([(bar.get_x(), bar.get_y(), bar.get_width(), bar.get_height()) for bar in container.patches]).reshape(-1, 4)
        lying = container.orientation == "horizontal"
        yield Series("bars", _label(container), (boxes[:, 1] + boxes[:, 3] / 2, boxes[:, 2]) if lying else (boxes[:, 0] + boxes[:, 2] / 2, boxes[:, 3]))
    for patch in axes.patches:
        if not any(patch in container.patches for container in bars):
            yield _of_patch(axes, patch)
    for one in axes.collections:
        if owner := next((drawn for drawn in contours if one is drawn or one in getattr(drawn, "collections", ())), None):
            if owner not in maps:
                maps.append(owner)
                yield Series("map", _label(one), owner.orbearing_map)
        else:
            yield _of_collection(axes, one)


def _label(artist) -> str:
    text = str(artist.get_label() or "")
    return "" if text.startswith("_") else text


def _of_patch(axes: Axes, patch) -> Series:
    across, up = patch.get_transform().contains_branch_seperately(axes.transData)
    if isinstance(patch, Annulus):
        return Series("circle", _label(patch), tuple(np.array([value]) for value in (*patch.get_center(), patch.get_radii()[0], patch.get_radii()[0] - patch.get_width())))
    if isinstance(patch, Circle):
        return Series("circle", _label(patch), tuple(np.array([value]) for value in (*patch.get_center(), patch.get_radius(), 0.0)))
    if isinstance(patch, Rectangle):
        corners = patch.get_bbox().get_points()
    elif isinstance(patch, Polygon):
        corners = patch.get_xy()
    else:
        return Series(type(patch).__name__, _label(patch), ())
    return Series("area", _label(patch), (corners[:, 0], corners[:, 1])) if across and up else Series("shade", _label(patch), (corners[:, 0],))


def _of_collection(axes: Axes, one) -> Series:
    if isinstance(one, PathCollection):
        offsets = np.ma.filled(np.ma.asarray(one.get_offsets(), float), np.nan)
        colours = one.get_array()
        return Series("points", _label(one), (offsets[:, 0], offsets[:, 1], one.get_sizes(), np.empty(0) if colours is None else np.asarray(colours, float)))
    if isinstance(one, QuadMesh):
        return Series("map", _label(one), (*_centres(one), np.ma.filled(np.ma.asarray(one.get_array(), float), np.nan).reshape(one.get_coordinates().shape[0] - 1, -1)))
    if isinstance(one, LineCollection):
        segments = np.array([ends for ends in one.get_segments() if len(ends) == 2], float)
        return Series("segments", _label(one), tuple(segments.reshape(-1, 4).T))
    if isinstance(one, PolyCollection):
        corners = np.concatenate([path.vertices for path in one.get_paths()]) if one.get_paths() else np.empty((0, 2))
        if not all(one.get_transform().contains_branch_seperately(axes.transData)):
            return Series("shade", _label(one), (np.unique(corners[:, 0]),))
        x = np.unique(corners[:, 0])
        ends = [corners[corners[:, 0] == place, 1] for place in x]
        return Series("band", _label(one), (x, np.array([min(values) for values in ends]), np.array([max(values) for values in ends])))
    return Series(type(one).__name__, _label(one), ())


def _centres(mesh: QuadMesh) -> tuple[np.ndarray, np.ndarray]:
    corners = mesh.get_coordinates()
    x, y = corners[0, :, 0], corners[:, 0, 1]
    return (x[1:] + x[:-1]) / 2, (y[1:] + y[:-1]) / 2
