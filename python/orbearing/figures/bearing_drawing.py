"""The bearing to scale: rings, cage, rollers coloured by load, contact loads as bars."""

from __future__ import annotations

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.patches import Annulus, Circle

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, format_quantity, is_number
from orbearing.figures.polar_loads import load_direction
from orbearing.result_folder import Report, curve

TITLE = "The bearing, to scale"
NEEDED = ("inner_raceway_diameter_mm", "outer_raceway_diameter_mm", "roller_diameter_mm", "pitch_diameter_mm", "outside_mm")
SIZES = {
    "bore_mm": "bore (mm)",
    "inner_raceway_diameter_mm": "inner raceway diameter (mm)",
    "pitch_diameter_mm": "pitch diameter (mm)",
    "outer_raceway_diameter_mm": "outer raceway diameter (mm)",
    "outside_mm": "outside diameter (mm)",
    "rollers": "number of rollers",
    "roller_diameter_mm": "roller diameter (mm)",
    "cage_inner_mm": "cage inside diameter (mm)",
    "cage_outer_mm": "cage outside diameter (mm)",
    "guide_land_mm": "diameter of the cage's guide land (mm)",
    "clearance_um": "radial clearance, diametral measure (µm)",
}
BAR = 0.26  # longest load bar over the outside radius
STEEL, CAGE = "#d5dade", "#e8d8b0"


def block(report: Report) -> FigureBlock:
    """The drawing, or which dimensions it lacks."""
    drawing = report.record("drawing")
    lacking = [name for name in NEEDED if not is_number(drawing.get(name)) or drawing[name] <= 0]
    if lacking:
        reason = "The drawing needs dimensions this result does not have: " + ", ".join(lacking) + "."
        return FigureBlock("drawing", TITLE, missing=reason)
    angle, inner, outer = curve(drawing, "roller_angle_deg", "inner_load_N", "outer_load_N")
    head = ("place (deg)", "inner race (N)", "outer race (N)")
    table = Table(head, list(zip(angle, inner, outer)))
    sizes = Table(("dimension", "value"), [(label, drawing.get(name)) for name, label in SIZES.items()])
    return FigureBlock("drawing", TITLE, _caption(drawing), (_draw(drawing),), summary=sizes, data=table)


def _draw(drawing: dict) -> str:
    figure, axes = style.panel((6.2, 6.6))
    angle, inner, outer = curve(drawing, "roller_angle_deg", "inner_load_N", "outer_load_N")
    loads = np.nan_to_num(np.concatenate([inner, outer]))
    scale = Normalize(0, max(loads.max(initial=0), 1e-9))
    _draw_rings(axes, drawing)
    _draw_rollers(axes, drawing, angle, np.fmax(inner, outer), scale)
    _draw_bars(axes, drawing, angle, inner, outer, scale)
    _draw_directions(axes, drawing)
    _set_frame(axes, drawing)
    bar = figure.colorbar(ScalarMappable(scale, style.LOAD_MAP), ax=axes, orientation="horizontal", shrink=0.7, pad=0.02)
    bar.solids.set(rasterized=False, edgecolor="face")  # shapes, not a bitmap inside the SVG
    bar.set_label("contact load: rollers by the greater of both races, bars by their own (N)")
    style.thousands(bar.ax.xaxis)
    return style.to_svg(figure, "drawing", "Planet bearing to scale with rollers coloured by load")


def _draw_rings(axes: Axes, drawing: dict) -> None:
    outside = drawing["outside_mm"] / 2
    axes.add_patch(_ring(outside, drawing["outer_raceway_diameter_mm"] / 2, STEEL))
    bore = drawing.get("bore_mm")
    axes.add_patch(_ring(drawing["inner_raceway_diameter_mm"] / 2, bore / 2 if is_number(bore) else 0.0, STEEL))
    cage_inner, cage_outer = drawing.get("cage_inner_mm"), drawing.get("cage_outer_mm")
    if is_number(cage_inner) and is_number(cage_outer) and cage_outer > cage_inner:
        axes.add_patch(_ring(cage_outer / 2, cage_inner / 2, CAGE))


def _ring(outer: float, inner: float, colour: str):
    look = {"facecolor": colour, "edgecolor": style.GREY, "linewidth": 0.8}
    if 0 < inner < outer:
        return Annulus((0, 0), outer, outer - inner, **look)
    return Circle((0, 0), outer, **look)


def _place(radius, angle_deg) -> tuple[np.ndarray, np.ndarray]:
    """Page coordinates (y, x) of a place in the carrier frame; the page's horizontal axis runs to the left."""
    return radius * np.sin(np.radians(angle_deg)), radius * np.cos(np.radians(angle_deg))


def _draw_rollers(axes: Axes, drawing: dict, angle: np.ndarray, load: np.ndarray, scale: Normalize) -> None:
    radius, colours = drawing["roller_diameter_mm"] / 2, colormaps[style.LOAD_MAP]
    for place, value in zip(angle, load):
        if np.isfinite(place):
            face = colours(scale(value)) if np.isfinite(value) and value > 0 else "white"
            centre = _place(drawing["pitch_diameter_mm"] / 2, place)
            axes.add_patch(Circle(centre, radius, facecolor=face, edgecolor=style.BLACK, linewidth=0.8, zorder=3))


def _draw_bars(axes: Axes, drawing: dict, angle, inner, outer, scale: Normalize) -> None:
    """Outer loads stand on the outside of the outer ring, inner loads reach inward from the inner raceway."""
    outside, raceway = drawing["outside_mm"] / 2, drawing["inner_raceway_diameter_mm"] / 2
    colours = colormaps[style.LOAD_MAP]
    for loads, foot, sign in ((outer, 1.03 * outside, 1), (inner, 0.98 * raceway, -1)):
        for place, load in zip(angle, loads):
            if np.isfinite(place) and np.isfinite(load) and load > 0:
                tip = foot + sign * BAR * outside * load / scale.vmax
                across, up = _place(np.array([foot, tip]), place)
                axes.plot(across, up, color=style.GREY, linewidth=6.6, solid_capstyle="butt", zorder=4)
                axes.plot(across, up, color=colours(scale(load)), linewidth=5.2, solid_capstyle="butt", zorder=4)


def _draw_directions(axes: Axes, drawing: dict) -> None:
    edge = (1.06 + BAR) * drawing["outside_mm"] / 2
    look = {"arrowstyle": "-|>", "color": style.BLACK, "linewidth": 1.2}
    axes.annotate("", xy=(0, -1.2 * edge), xytext=(0, -1.03 * edge), arrowprops=look)
    axes.text(-0.04 * edge, -1.13 * edge, "to the sun", va="center", ha="left")
    axes.annotate("", xy=(0.3 * edge, 1.1 * edge), xytext=(-0.3 * edge, 1.1 * edge), arrowprops=look)
    axes.text(0, 1.13 * edge, "carrier rotation (y)", va="bottom", ha="center")
    direction = load_direction({"angle_deg": drawing.get("roller_angle_deg"), "outer_load_N": drawing.get("outer_load_N")})
    if direction is not None:
        across, up = _place(0.6 * drawing["inner_raceway_diameter_mm"] / 2, np.degrees(direction))
        axes.annotate("", xy=(across, up), xytext=(0, 0), zorder=6,
                      arrowprops={**look, "color": style.VERMILION, "linewidth": 2.4, "mutation_scale": 16})


def _set_frame(axes: Axes, drawing: dict) -> None:
    reach = 1.22 * (1.06 + BAR) * drawing["outside_mm"] / 2
    axes.set_xlim(reach, -reach)
    axes.set_ylim(-reach, reach)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("place y along carrier rotation (mm)")
    axes.set_ylabel("place x outward from the sun (mm)")
    clearance = format_quantity(drawing.get("clearance_um"), "µm")
    axes.set_title(f"{format_number(drawing.get('speed_rpm'))} rpm, radial clearance {clearance} (diametral measure)", loc="left")


def _caption(drawing: dict) -> str:
    clearance = drawing.get("clearance_um")
    speed = drawing.get("speed_rpm")
    where = f", quasi-static at {format_number(speed, 4)} rpm" if is_number(speed) else ""
    text = (f"All dimensions are to scale. Loads are those of one bearing{where}. Rollers are coloured by their load and white where they carry none; bars outside are loads "
            "on the outer race, bars inside on the inner race; a thin strip is a roller held there by its inertia alone. "
            "The orange-red arrow is the direction of the load on the planet; "
            "the load zone lies opposite. ")
    if not is_number(clearance):
        return text + "The clearance is not given."
    if clearance == 0:
        return text + "The clearance is zero: without load every roller just touches both races."
    return text + f"The clearance of {format_number(clearance)} µm is in the computation but too small to be seen at this scale."
