"""Teeth in contact, to scale, and how stiff a mesh is over its period."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.result_folder import curve, numbers, record, records

PAIR_SLUG, PAIR_TITLE = "gear-teeth", "Gears: teeth in contact, to scale"
STIFFNESS_SLUG, STIFFNESS_TITLE = "gear-stiffness", "Gears: stiffness of the meshes"
NEIGHBOURS = (-1, 0, 1)  # teeth that are drawn, counted from the one in contact
BODY = 3.0  # depth of the drawn part of the body, in modules: beyond the edge of the picture
ARC = 9  # points of the tip circle on a tooth
FACES = ("#d5dade", "#e8d8b0")
PARTS = ("bending_N_per_m", "shear_N_per_m", "axial_N_per_m", "foundation_N_per_m")


def pair_block(gears: dict) -> FigureBlock:
    """One picture for each kind of mesh."""
    pairs = [pair for pair in records(gears.get("tooth_pairs")) if _is_whole(pair)]
    if not pairs:
        return FigureBlock(PAIR_SLUG, PAIR_TITLE, missing="This result holds no form of the teeth.")
    caption = ("Involutes and, at the feet of teeth cut by a rack, trochoids, as the stiffness of the mesh is computed from; the root of "
               "the ring's teeth is left unrounded. Dot: contact at the pitch point, or at the nearest place the teeth reach. Dashed: line "
               "of action, along which the teeth push; grey: line of centres; dotted: base circles.")
    pictures = tuple(_draw_pair(pair, f"{PAIR_SLUG}-{number}") for number, pair in enumerate(pairs, start=1))
    rows = [(g.get("name"), pair.get("mesh"), g.get("teeth"), g.get("module_mm"), g.get("base_radius_mm"),
             *(_ends(g)), pair.get("working_pressure_angle_deg")) for pair in pairs for g in records(pair.get("gears"))]
    head = ("gear", "mesh", "teeth", "module (mm)", "base radius (mm)", "root radius (mm)", "tip radius (mm)", "working pressure angle (deg)")
    return FigureBlock(PAIR_SLUG, PAIR_TITLE, caption, pictures, summary=Table(head, rows))


def _is_whole(pair: dict) -> bool:
    gears = records(pair.get("gears"))
    singles = ("centre_y_mm", "sense", "axis_deg", "module_mm", "base_radius_mm", "teeth")
    return (len(gears) == 2 and all(is_number(pair.get(name)) for name in ("contact_x_mm", "contact_y_mm", "working_pressure_angle_deg"))
            and all(is_number(g.get(name)) for g in gears for name in singles) and all(g["teeth"] > 0 for g in gears)
            and all(len(c) > 1 and np.isfinite(c).all() for g in gears for c in curve(g, "radius_mm", "half_angle_deg")))


def _ends(gear: dict) -> tuple[float, float]:
    radius = numbers(gear.get("radius_mm"))
    return float(radius[0]), float(radius[-1])


def _place(gear: dict, radius, angle_deg) -> tuple[np.ndarray, np.ndarray]:
    angle = np.radians(angle_deg)
    return radius * np.sin(angle), gear["centre_y_mm"] + gear["sense"] * radius * np.cos(angle)


def outline(gear: dict) -> tuple[np.ndarray, np.ndarray]:
    """The teeth in contact and beside it with the body they stand on: one closed line."""
    radius, half = curve(gear, "radius_mm", "half_angle_deg")
    pitch, axis = 360.0 / gear["teeth"], gear["axis_deg"]
    tip = np.linspace(-half[-1], half[-1], ARC)
    radii = np.concatenate([np.concatenate([radius, np.full(ARC, radius[-1]), radius[::-1]]) for _ in NEIGHBOURS])
    angles = np.concatenate([axis + n * pitch + np.concatenate([-half, tip, half[::-1]]) for n in NEIGHBOURS])
    inward = 1.0 if radius[-1] > radius[0] else -1.0
    ends = axis + pitch * (NEIGHBOURS[0] - 0.5), axis + pitch * (NEIGHBOURS[-1] + 0.5)
    foot = radius[0] - inward * BODY * gear["module_mm"]
    back = np.linspace(ends[1], ends[0], 40)
    return _place(gear, np.concatenate([[radius[0]], radii, [radius[0]], np.full(40, foot)]),
                  np.concatenate([[ends[0]], angles, [ends[1]], back]))


def _draw_pair(pair: dict, slug: str) -> str:
    figure, axes = style.panel((5.2, 4.4))
    reach = 2.6 * max(g["module_mm"] for g in pair["gears"])
    for gear, face in zip(pair["gears"], FACES):
        axes.fill(*outline(gear), facecolor=face, edgecolor=style.BLACK, linewidth=1.0)
        turn = np.degrees(2 * reach / gear["base_radius_mm"])
        axes.plot(*_place(gear, gear["base_radius_mm"], np.linspace(-turn, turn, 80)), color=style.GREY, linestyle=":", linewidth=1.0)
    _draw_lines(axes, pair, reach)
    _name_gears(axes, pair, reach)
    axes.set_xlim(-1.25 * reach, 1.25 * reach)
    axes.set_ylim(-reach, reach)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("across the line of centres (mm)")
    axes.set_ylabel("from the pitch point (mm)")
    angle = format_number(pair["working_pressure_angle_deg"], 4)
    axes.set_title(f"{pair.get('mesh')}, working pressure angle {angle}°", loc="left")
    return style.to_svg(figure, slug, "A pair of teeth in contact, drawn to scale")


def _draw_lines(axes: Axes, pair: dict, reach: float) -> None:
    angle = np.radians(pair["working_pressure_angle_deg"])
    along = np.array([-2.0 * reach, 2.0 * reach])
    axes.axvline(0, color=style.GREY, linewidth=0.8)
    axes.plot(along * np.cos(angle), along * np.sin(angle), color=style.BLUE, linestyle="--", linewidth=1.2)
    axes.plot(pair["contact_x_mm"], pair["contact_y_mm"], "o", color=style.VERMILION, markersize=6, zorder=5)


def _name_gears(axes: Axes, pair: dict, reach: float) -> None:
    lower, upper = sorted(pair["gears"], key=lambda g: np.mean(outline(g)[1]))
    look = {"ha": "left", "bbox": {"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 1.5}}
    axes.text(-1.2 * reach, -0.95 * reach, lower.get("name"), va="bottom", **look)
    axes.text(-1.2 * reach, 0.95 * reach, upper.get("name"), va="top", **look)


def stiffness_block(gears: dict) -> FigureBlock:
    """Both kinds of mesh over one period, the parts at the pitch point beside."""
    meshes = [m for m in records(gears.get("meshes")) if len(_curve(m))]
    if not meshes:
        return FigureBlock(STIFFNESS_SLUG, STIFFNESS_TITLE, missing="This result holds no stiffness of the meshes.")
    caption = ("Stiffness along the line of action over one mesh period, from the moment a pair of teeth comes into contact; it jumps where "
               "a pair comes or goes. Dashed: mean. Right: the parts of one pair of teeth at the pitch point as compliances, which add "
               "up to that of the pair; the table gives them as stiffnesses. Meshes of other planets differ in their phase only.")
    rows = [row for mesh in meshes for row in _parts(mesh)]
    table = Table(("mesh", "part at the pitch point", "stiffness (N/µm)", "share of the compliance (%)"), rows)
    head = ("mesh period", *(f"{_name(m)} (N/µm)" for m in meshes))
    fraction = _curve(meshes[0])[:, 0]
    same = [m for m in meshes if len(_curve(m)) == len(fraction)]
    data = Table(head, list(zip(fraction, *(_curve(m)[:, 1] / 1e6 for m in same)))) if len(same) == len(meshes) else None
    return FigureBlock(STIFFNESS_SLUG, STIFFNESS_TITLE, caption, (_draw_stiffness(meshes),), summary=table, data=data)


def _curve(mesh: dict) -> np.ndarray:
    points = mesh.get("curve") if isinstance(mesh.get("curve"), list) else []
    pairs = [p for p in points if isinstance(p, list) and len(p) == 2 and all(map(is_number, p))]
    return np.array(pairs, dtype=float).reshape(-1, 2)


def _name(mesh: dict) -> str:
    return str(mesh.get("name", "")).rsplit(" ", 1)[0] or "mesh"


def _parts(mesh: dict) -> list[tuple]:
    point = record(mesh.get("at_pitch_point"))
    found = [("contact", point.get("hertz_N_per_m"))]
    found += [(f"{g.get('gear')}, {part.split('_')[0]}", g.get(part)) for g in records(point.get("gears")) for part in PARTS]
    whole = point.get("pair_N_per_m")
    rows = [(_name(mesh), name, value / 1e6, round(100 * whole / value, 2) if is_number(whole) else None)
            for name, value in found if is_number(value) and value > 0]
    return rows + ([(_name(mesh), "one pair of teeth", whole / 1e6, 100.0)] if is_number(whole) else [])


def _draw_stiffness(meshes: list[dict]) -> str:
    figure = Figure(figsize=(8.6, 3.9))
    left, right = figure.subplots(1, 2, width_ratios=(1.25, 1.0))
    for mesh, colour, dash in zip(meshes, (style.BLUE, style.VERMILION), ("-", "-")):
        points = _curve(mesh)
        left.plot(np.append(points[:, 0], 1.0), np.append(points[:, 1], points[0, 1]) / 1e6, color=colour, linestyle=dash, label=_name(mesh))
        if is_number(mesh.get("mean_N_per_m")):
            left.axhline(mesh["mean_N_per_m"] / 1e6, color=colour, linestyle="--", linewidth=0.9)
    left.set_ylim(bottom=0)
    left.set_xlim(0, 1)
    left.set_xlabel("time since a pair came into contact (mesh period)")
    left.set_ylabel("mesh stiffness (N/µm)")
    style.legend_above(left)
    _draw_parts(right, meshes)
    return style.to_svg(figure, STIFFNESS_SLUG, "Mesh stiffness over the mesh period and its parts at the pitch point")


def _draw_parts(axes: Axes, meshes: list[dict]) -> None:
    rows = [row for mesh in meshes for row in _parts(mesh) if row[1] != "one pair of teeth"]
    colours = {_name(mesh): colour for mesh, colour in zip(meshes, (style.BLUE, style.VERMILION))}
    places = np.arange(len(rows), dtype=float)
    axes.barh(places, [1e3 / row[2] for row in rows], color=[colours[row[0]] for row in rows], height=0.7)
    axes.set_yticks(places, [row[1] for row in rows], fontsize=8)
    axes.invert_yaxis()
    axes.grid(False, axis="y")
    axes.set_xlabel("compliance at the pitch point (nm/N)")
