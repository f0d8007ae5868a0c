"""Modes of the gear set: how its members move, and where mesh harmonics meet them over speed."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number, is_number
from orbearing.result_folder import curve, numbers, record, records

SHAPE_SLUG, SHAPE_TITLE = "gear-modes", "Gears: mode shapes"
CAMPBELL_SLUG, CAMPBELL_TITLE = "gear-campbell", "Gears: Campbell diagram"
KINDS = {"R": ("rotational", style.BLUE, "-"), "T": ("translational", style.GREEN, "--"), "P": ("planet", style.VERMILION, "-.")}
NEEDED = ("centre_distance_mm", "sun_radius_mm", "ring_radius_mm", "planet_radius_mm")
ORDERS = (1, 2, 3, 4)  # with four planets each kind of mode has a harmonic among these
DRAWN = 0.16  # largest displacement in the picture over the centre distance


def kind_of(name) -> tuple[str, str, str]:
    """Kind, colour and dash of a mode by its name, as T2."""
    return KINDS.get(str(name)[:1], ("other", style.GREY, ":"))


def shape_block(gears: dict) -> FigureBlock:
    """The lowest modes of each kind, each in a panel."""
    content = record(gears.get("mode_shapes"))
    lacking = [name for name in NEEDED if not is_number(content.get(name)) or content[name] <= 0]
    size = 0 if lacking else 9 + 3 * len(numbers(content.get("places_rad")))
    modes = [m for m in records(content.get("modes")) if is_number(m.get("frequency_Hz")) and _shape(m).size == size > 0]
    if not modes:
        return FigureBlock(SHAPE_SLUG, SHAPE_TITLE, missing="This result holds no mode shapes.")
    caption = ("The lowest modes of each kind of the set at rest, with mean mesh stiffness and the bearings as loaded at the middle speed; displacements are enlarged, the largest to the "
               "same size in each picture. Grey: members at rest; coloured: displaced, the spoke shows how far each has turned, on its base "
               "circle. Rotational (R): central members turn, all planets do the same; translational (T, in pairs): central "
               "members shift; planet (P): central members rest.")
    rows = [(m.get("name"), m.get("kind"), m["frequency_Hz"], m.get("multiplicity")) for m in modes]
    table = Table(("mode", "kind", "frequency (Hz)", "multiplicity"), rows)
    return FigureBlock(SHAPE_SLUG, SHAPE_TITLE, caption, (_draw_shapes(content, modes),), summary=table)


def _shape(mode: dict) -> np.ndarray:
    values = numbers(mode.get("shape"))
    return values if np.isfinite(values).all() else np.array([])


def _draw_shapes(content: dict, modes: list[dict]) -> str:
    columns = min(3, len(modes))
    rows = -(-len(modes) // columns)
    figure = Figure(figsize=(2.9 * columns, 3.1 * rows))
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes in grid[len(modes):]:
        axes.set_axis_off()
    for axes, mode in zip(grid, modes):
        _draw_shape(axes, content, mode)
    return style.to_svg(figure, SHAPE_SLUG, "Mode shapes of the gear set as displaced members")


def members(content: dict, shape: np.ndarray) -> list[tuple]:
    """Name, place at rest, radius, displacement (x, y) on the page and u, for each drawn member."""
    distance = content["centre_distance_mm"]
    rows = [("ring", (0.0, 0.0), content["ring_radius_mm"], shape[3:5], shape[5]),
            ("sun", (0.0, 0.0), content["sun_radius_mm"], shape[0:2], shape[2]),
            ("carrier", (0.0, 0.0), 0.22 * distance, shape[6:8], shape[8] * 0.22)]
    for n, angle in enumerate(content["places_rad"]):
        out, along = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        x, y, turn = shape[9 + 3 * n:12 + 3 * n]
        rows.append((f"planet {n + 1}", tuple(distance * out), content["planet_radius_mm"], x * out + y * along, turn))
    return rows


def _draw_shape(axes: Axes, content: dict, mode: dict) -> None:
    rows = members(content, _shape(mode))
    largest = max(max(float(np.hypot(*shift)), abs(float(turn))) for _, _, _, shift, turn in rows) or 1.0
    enlarged = DRAWN * content["centre_distance_mm"] / largest
    colour = kind_of(mode.get("name"))[1]
    for name, place, radius, shift, turn in rows:
        dash = ":" if name == "carrier" else "-"
        axes.add_patch(Circle(place, radius, fill=False, edgecolor="#c4c4c4", linewidth=1.0, linestyle=dash))
        centre = np.asarray(place) + enlarged * np.asarray(shift)
        axes.add_patch(Circle(centre, radius, fill=False, edgecolor=colour, linewidth=1.3, linestyle=dash))
        angle = np.arctan2(place[1], place[0]) + enlarged * turn / radius
        spoke = np.array([0.0 if radius < content["ring_radius_mm"] else 0.93, 1.0])
        axes.plot(centre[0] + spoke * radius * np.cos(angle), centre[1] + spoke * radius * np.sin(angle), color=colour, linewidth=1.3)
    reach = 1.12 * content["ring_radius_mm"] + DRAWN * content["centre_distance_mm"]
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set_aspect("equal")
    axes.set_axis_off()
    twice = ", pair" if mode.get("multiplicity") == 2 else ""
    axes.set_title(f"{mode.get('name')}: {mode.get('kind')}{twice}\n{format_number(mode['frequency_Hz'])} Hz", fontsize=9.5)


def campbell_lines(gears: dict) -> tuple[np.ndarray, np.ndarray, list[dict]]:
    """Speeds, mesh frequencies and modes; no modes where there are too few speeds for a diagram."""
    content = record(gears.get("campbell"))
    speed, mesh = curve(content, "speed_rpm", "mesh_frequency_Hz")
    modes = [m for m in records(content.get("modes")) if len(numbers(m.get("frequency_Hz"))) == len(speed)]
    return speed, mesh, modes if np.isfinite(speed).sum() >= 2 else []


def campbell_beside_life(gears: dict, low: float, high: float, size: tuple[float, float]) -> str | None:
    """The same diagram between two speeds, at the size of the picture of life that stands beside it."""
    speed, mesh, modes = campbell_lines(gears)
    if not modes:
        return None
    return _draw_campbell(speed, mesh, modes, excited_meetings(gears), "life-campbell", size, (low, high))


def campbell_block(gears: dict) -> FigureBlock:
    """Natural frequencies and mesh harmonics over the speeds of the sweep."""
    speed, mesh, modes = campbell_lines(gears)
    if not modes:
        return FigureBlock(CAMPBELL_SLUG, CAMPBELL_TITLE, missing="A Campbell diagram needs natural frequencies at two speeds or more.")
    caption = ("Natural frequencies in the frame of the carrier, gyroscopic and centrifugal terms included, and the harmonics 1 to 4 of the "
               "mesh frequency. Pairs of translational modes split with speed. Rings: a harmonic meets a mode that it can excite, for with "
               "equal planets harmonic l of the meshes moves only modes of one kind, recognised by l times the sun's teeth modulo the number of "
               "planets; other crossings stay without effect.")
    head = ("input speed (rpm)", "mesh frequency (Hz)", *(f"{m.get('name')} (Hz)" for m in modes))
    data = Table(head, list(zip(speed, mesh, *(numbers(m["frequency_Hz"]) for m in modes))))
    return FigureBlock(CAMPBELL_SLUG, CAMPBELL_TITLE, caption, (_draw_campbell(speed, mesh, modes, excited_meetings(gears), CAMPBELL_SLUG, (7.2, 5.4)),), data=data)


def excited_meetings(gears: dict) -> list[dict]:
    """Meetings of a mesh harmonic and a mode it can excite."""
    return [m for m in records(gears.get("meetings")) if m.get("excited") is True
            and all(is_number(m.get(name)) for name in ("order", "speed_rpm", "frequency_Hz"))]


def _draw_campbell(speed: np.ndarray, mesh: np.ndarray, modes: list[dict], meetings: list[dict], slug: str,
                   size: tuple[float, float], speeds: tuple[float, float] | None = None) -> str:
    figure, axes = style.panel(size)
    top = 1.06 * max(np.nanmax(np.append(numbers(m["frequency_Hz"]), 0.0)) for m in modes) / 1e3
    seen = set()
    for mode in modes:
        kind, colour, dash = kind_of(mode.get("name"))
        axes.plot(speed, numbers(mode["frequency_Hz"]) / 1e3, color=colour, linestyle=dash, linewidth=1.2, label=None if kind in seen else kind)
        seen.add(kind)
    for order in ORDERS:
        axes.plot(speed, order * mesh / 1e3, color=style.GREY, linewidth=1.0, zorder=1, label=None if order > 1 else "mesh harmonics")
        _name_harmonic(axes, order, speed, mesh / 1e3, modes, top)
    axes.plot([m["speed_rpm"] for m in meetings], [m["frequency_Hz"] / 1e3 for m in meetings], "o", color=style.BLACK, markersize=6,
              markerfacecolor="none", linestyle="", label="excited meeting", zorder=5)
    axes.set_xlim(*(speeds or (np.nanmin(speed), np.nanmax(speed))))
    axes.set_ylim(0, max(top, 1e-6))
    _name_modes(axes, speed, modes, top)
    axes.set_ylabel("frequency (kHz)")
    style.speed_axis(axes)
    style.legend_above(axes, columns=5 if size[0] > 6 else 2)
    return style.to_svg(figure, slug, "Natural frequencies and mesh harmonics over input speed")


def _name_harmonic(axes: Axes, order: int, speed: np.ndarray, mesh: np.ndarray, modes: list[dict], top: float) -> None:
    """On its line, in the upper half of what is seen of it, as far from the modes as it goes."""
    inside = np.flatnonzero(order * mesh < 0.95 * top)
    inside = inside[len(inside) // 2:]
    if not len(inside):
        return
    lines = np.array([numbers(mode["frequency_Hz"])[inside] / 1e3 for mode in modes])
    room = np.nanmin(np.where(np.isfinite(lines), np.abs(lines - order * mesh[inside]), np.inf), axis=0)
    at = inside[int(np.argmax(room))]
    axes.text(speed[at], order * mesh[at], f"{order} ×", ha="center", va="center", color=style.BLACK, fontsize=8.5,
              bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0}, zorder=4)


def _name_modes(axes: Axes, speed: np.ndarray, modes: list[dict], top: float) -> None:
    """At the right edge, pushed apart where they would cover each other, each with a thread to its line."""
    ends: dict[str, list[float]] = {}
    for mode in modes:
        value = numbers(mode["frequency_Hz"])[-1]
        if np.isfinite(value):
            ends.setdefault(str(mode.get("name")), []).append(value / 1e3)
    last = -np.inf
    for name, values in sorted(ends.items(), key=lambda item: np.mean(item[1])):
        last = max(float(np.mean(values)), last + 0.032 * top)
        axes.annotate(name, (1.0, float(np.mean(values))), xycoords=axes.get_yaxis_transform(), xytext=(1.035, last),
                      textcoords=axes.get_yaxis_transform(), va="center", fontsize=8, color=kind_of(name)[1], annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": kind_of(name)[1], "linewidth": 0.6, "shrinkA": 0, "shrinkB": 0})
