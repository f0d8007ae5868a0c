"""Pressure of a roller on its race: along the roller for each profile, and over the whole contact.

Records as they stand in JSON. `curves`: [{profile, tilt_mrad, x_mm: [...], pressure_MPa: [...], edge_ratio,
peak_pressure_MPa}]. `contact`: {profile, tilt_mrad, x_mm: [...], y_um: [...] from 0 outwards, pressure_MPa: one list
for each x}. `hertz_MPa`: pressure of an even line contact under the same load, or None.
"""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.drawn import states_map

SLUG, TITLE = "roller-pressure", "Pressure along the roller"
MAP_SLUG, MAP_TITLE = "pressure-map", "Pressure over the contact"
HEADROOM = 1.6  # of the axis over the line contact's pressure: sharp corners reach out of it
LEVELS = 12
COLOURS = (*style.SERIES, style.GREY)
LEGEND_LINE = 0.19  # [inch]  height of one line of a legend


def block(curves: list[dict], hertz_MPa: float | None = None) -> FigureBlock:
    """One panel for each tilt, one line for each profile."""
    drawn = [curve for curve in curves if _lengths(curve)]
    if not drawn:
        return FigureBlock(SLUG, TITLE, missing="This result holds no pressure along a roller.")
    caption = ("Pressure in the middle of the contact, along the roller, with both bodies as elastic half-spaces and the roller's ends free. "
               "A sharp corner's pressure has no limit: its line leaves the picture, and peaks are means over a hundredth of the length. "
               "Edge ratio: the greatest such mean within a tenth of the length from an end, over the pressure at mid-length. "
               "Positive tilt closes the contact on the right.")
    head = ("profile", "tilt (mrad)", "peak pressure (MPa)", "edge ratio")
    rows = [(c.get("profile"), c.get("tilt_mrad"), c.get("peak_pressure_MPa"), c.get("edge_ratio")) for c in drawn]
    data = [(c.get("profile"), c.get("tilt_mrad"), x, p) for c in drawn for x, p in zip(c["x_mm"], c["pressure_MPa"])]
    return FigureBlock(SLUG, TITLE, caption, (_draw(drawn, hertz_MPa),), summary=Table(head, rows),
                       data=Table(("profile", "tilt (mrad)", "place (mm)", "pressure (MPa)"), data))


def _lengths(curve: dict) -> int:
    """How many places a curve has; none where its lists differ."""
    x, pressure = curve.get("x_mm") or [], curve.get("pressure_MPa") or []
    return len(x) if len(x) == len(pressure) else 0


def _draw(curves: list[dict], hertz: float | None) -> str:
    tilts = list(dict.fromkeys(curve.get("tilt_mrad") for curve in curves))
    profiles = list(dict.fromkeys(curve.get("profile") for curve in curves))
    figure = Figure(figsize=(4.4 * len(tilts), 4.1))
    panels = figure.subplots(1, len(tilts), sharey=True, squeeze=False)[0]
    for axes, tilt in zip(panels, tilts):
        for curve in curves:
            if curve.get("tilt_mrad") == tilt:
                _line(axes, curve, profiles.index(curve.get("profile")))
        _frame(axes, hertz)
        axes.set_title(style.tilt_text(tilt), loc="left")
    top = _top(curves, hertz)
    panels[0].set_ylim(0, top)
    panels[0].set_ylabel("pressure at mid-width (MPa)")
    style.thousands(panels[0].yaxis)
    handles, labels = panels[0].get_legend_handles_labels()
    columns = 2 * len(tilts)
    lines = -(-len(labels) // columns)
    figure.legend(handles, labels, loc="upper left", ncol=columns, columnspacing=1.4)
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - (LEGEND_LINE * lines + 0.1) / figure.get_figheight()))
    return style.to_svg(figure, SLUG, "Pressure along the roller for each profile and tilt")


def _line(axes: Axes, curve: dict, number: int) -> None:
    x, pressure = np.asarray(curve["x_mm"], float), np.asarray(curve["pressure_MPa"], float)
    dash = style.DASHES[(number + number // len(style.DASHES)) % len(style.DASHES)]
    axes.plot(x, pressure, color=COLOURS[number % len(COLOURS)], linestyle=dash,
              label=style.legend_label(str(curve.get("profile"))))


def _frame(axes: Axes, hertz: float | None) -> None:
    if is_number(hertz):
        axes.axhline(hertz, color=style.GREY, linewidth=0.9, linestyle=":", label="even line contact (Hertz)")
    axes.margins(x=0.02)
    axes.set_xlabel("place along the roller (mm)")


def _top(curves: list[dict], hertz: float | None) -> float:
    """Peaks as means are inside; what only single elements at a sharp corner reach is not."""
    peaks = [c["peak_pressure_MPa"] for c in curves if is_number(c.get("peak_pressure_MPa"))]
    peaks = peaks or [np.nanmax(np.asarray(c["pressure_MPa"], float)) for c in curves]
    return 1.08 * max(peaks + ([HEADROOM / 1.08 * hertz] if is_number(hertz) else []))


def map_block(contacts: list[dict]) -> FigureBlock:
    """The contact seen from above, once for each record, all on one scale."""
    drawn = [contact for contact in contacts if _is_grid(contact)]
    if not drawn:
        return FigureBlock(MAP_SLUG, MAP_TITLE, missing="This result holds no pressure over the contact.")
    caption = ("Pressure between roller and race from the solution over the whole contact, without any assumption across it. The scale "
               "across is stretched. Where an end is sharp the contact widens there, and its outermost elements may lie beyond the colours.")
    rows = [(c.get("profile"), c.get("tilt_mrad"), float(np.max(c["pressure_MPa"])), _width(c)) for c in drawn]
    head = ("profile", "tilt (mrad)", "greatest in one element (MPa)", "greatest width (µm)")
    return FigureBlock(MAP_SLUG, MAP_TITLE, caption, (_draw_maps(drawn),), summary=Table(head, rows))


def _is_grid(contact: dict) -> bool:
    shape = np.shape(contact.get("pressure_MPa") or [])
    return len(shape) == 2 and shape == (len(contact.get("x_mm") or []), len(contact.get("y_um") or [])) and min(shape) > 1


def _width(contact: dict) -> float:
    """Of the rows that carry, both sides."""
    y = np.asarray(contact["y_um"], float)
    rows = int(np.count_nonzero(np.max(contact["pressure_MPa"], axis=0) > 0))
    return round(float((2 * rows - 1) * (y[1] - y[0])), 1)


def _draw_maps(contacts: list[dict]) -> str:
    figure = Figure(figsize=(6.4, 1.0 + 1.75 * len(contacts)))
    panels = figure.subplots(len(contacts), 1, sharex=True, sharey=True, squeeze=False)[:, 0]
    levels = np.linspace(0.0, _map_top(contacts), LEVELS + 1)
    levels[0] = 0.02 * levels[1]  # what carries nothing stays white
    for axes, contact in zip(panels, contacts):
        filled = _draw_map(axes, contact, levels)
        axes.set_title(f"{contact.get('profile')}, tilt {format_number(contact.get('tilt_mrad'))} mrad", loc="left")
        axes.set_ylabel("across (µm)")
    panels[-1].set_xlabel("place along the roller (mm)")
    bar = figure.colorbar(filled, ax=list(panels), pad=0.02, aspect=12 * len(contacts))
    bar.set_label("pressure (MPa)")
    bar.set_ticks(levels[2::2])
    style.thousands(bar.ax.yaxis)
    return style.to_svg(figure, MAP_SLUG, "Pressure over the contact of roller and race")


def _map_top(contacts: list[dict]) -> float:
    """The colours end above all but the outermost elements, which at a sharp corner stand far out."""
    pressures = np.concatenate([np.ravel(np.asarray(c["pressure_MPa"], float)[2:-2]) for c in contacts])
    return float(np.ceil(pressures.max() / 200.0) * 200.0) or 1.0


def _draw_map(axes: Axes, contact: dict, levels: np.ndarray):
    y, pressure = np.asarray(contact["y_um"], float), np.asarray(contact["pressure_MPa"], float)
    whole = np.concatenate([-y[:0:-1], y])
    values = np.concatenate([pressure[:, :0:-1], pressure], axis=1).T
    axes.grid(False)
    return states_map(axes.contourf(contact["x_mm"], whole, values, levels=levels, cmap="viridis", extend="max"), contact["x_mm"], whole, values)
