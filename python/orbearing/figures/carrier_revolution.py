"""Loads of the planet bearings over a revolution of the carrier, and the load of the meshes over their face."""

from __future__ import annotations

import numpy as np

from orbearing import style
from orbearing.blocks import FigureBlock, Table, columns_table, format_number, format_quantity, is_number
from orbearing.result_folder import Report, numbers, records

SLUG, TITLE = "carrier-revolution", "Loads over a revolution of the carrier"


def block(report: Report) -> FigureBlock:
    """At the case's own operating point: a line for each bearing, and for each kind of mesh its load over the face."""
    carrier = report.record("carrier")
    bearings, angle = carrier.get("bearings") or [], numbers(carrier.get("carrier_angle_deg"))
    loads = np.array(carrier.get("bearing_loads_N") or [], dtype=float)
    if not bearings or loads.shape != (len(angle), len(bearings)):
        return FigureBlock(SLUG, TITLE, missing="This case states no bearings of the carrier (gearset.carrier.bearing_positions).")
    expected = carrier.get("expected_load_N")
    caption = (f"Load of each planet bearing over the angle of the carrier, which its own bearings hold in the housing under weight and rotor (left), and load per width of "
               f"the most loaded mesh of sun and ring over the face (right). Largest load of one bearing: {format_quantity(loads.max(), 'N', 4)}, "
               f"{format_number(carrier.get('largest_load_share'), 4)} times the expected load of {format_quantity(expected, 'N', 4)} (torque shared evenly). "
               f"{_shortest_in_words(report)}").rstrip()
    data = columns_table(("carrier angle (deg)", *(f"{_name(one)} (N)" for one in bearings)), angle, *loads.T)
    return FigureBlock(SLUG, TITLE, caption, (_draw_loads(angle, loads, bearings, expected), _draw_face(carrier)), summary=_summary(bearings), data=data)


def shortest_life(report: Report) -> tuple[dict, float] | None:
    """The bearing with the shortest governing life, and that life [h]."""
    column = "L10h_h" if report.life_key == "L10h" else report.life_key
    alive = [one for one in records(report.record("carrier").get("bearings")) if is_number(one.get(column))]
    worst = min(alive, key=lambda one: one[column], default=None)
    return worst and (worst, worst[column])


def _shortest_in_words(report: Report) -> str:
    found = shortest_life(report)
    return f"Shortest {report.life_key}: {format_quantity(found[1], 'h', 4)}, {_name(found[0])}." if found else ""


def _name(bearing: dict) -> str:
    return f"planet {format_number(bearing['planet'], 3)}, at {format_number(bearing['position_mm'], 4)} mm"


def _summary(bearings: list[dict]) -> Table:
    lives = [key for key in ("L10h_h", "L10rh", "L10mh", "L10mrh", "life_h") if any(one.get(key) is not None for one in bearings)]
    head = ("bearing", "least load (N)", "largest load (N)", "P (N)", "largest tilt (mrad)", *(f"{key.removesuffix('_h') if key != 'life_h' else key} (h)" for key in lives))
    return Table(head, [(_name(one), *(one.get(key) for key in ("load_min_N", "load_max_N", "equivalent_load_N", "tilt_max_mrad", *lives))) for one in bearings])


def _draw_loads(angle: np.ndarray, loads: np.ndarray, bearings: list[dict], expected: float | None) -> str:
    figure, axes = style.panel((5.6, 4.0))
    places = sorted({one["position_mm"] for one in bearings})
    for line, one in zip(loads.T, bearings):
        axes.plot(np.append(angle, 360.0), np.append(line, line[0]), color=style.SERIES[int(one["planet"] - 1) % len(style.SERIES)],
                  linestyle=style.DASHES[places.index(one["position_mm"]) % len(style.DASHES)], label=_name(one))
    if is_number(expected):
        axes.axhline(expected, color=style.GREY, linestyle=":", label="torque shared evenly")
    axes.set_xlim(0, 360)
    axes.set_xticks(np.arange(0, 361, 60))
    axes.set_xlabel("angle of the carrier (deg)")
    axes.set_ylabel("load of the bearing (N)")
    style.thousands(axes.yaxis)
    style.legend_above(axes)
    return style.to_svg(figure, SLUG, "Load of each planet bearing over a revolution of the carrier")


def _draw_face(carrier: dict) -> str:
    figure, axes = style.panel((4.2, 4.0))
    place = numbers(carrier.get("face_position_mm"))
    for wheel, colour, line in (("sun", style.BLUE, "-"), ("ring", style.VERMILION, "--")):
        meshes = [one for one in carrier.get("meshes") or [] if one["with"] == wheel]
        if meshes:
            most = max(meshes, key=lambda one: max(one["face_load_N_per_mm"]))
            axes.plot(place, numbers(most["face_load_N_per_mm"]), color=colour, linestyle=line, label=f"{wheel}, K_Hβ {format_number(most['K_Hbeta'], 3)}")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("position on the face (mm)")
    axes.set_ylabel("load per width (N/mm)")
    style.legend_above(axes)
    return style.to_svg(figure, f"{SLUG}-face", "Load per width of the most loaded meshes over their face")
