"""What pictures of gears draw, from teeth, modes and runs as the program gives them."""

from __future__ import annotations

import numpy as np

from orbearing.result_folder import record, records

ORDERS = 8  # of the spectrum


def arranged(gears: dict) -> dict:
    """`gears` of report.json."""
    speeds = records(gears.get("speeds"))
    return {"tooth_pairs": [_placed(pair, number == 0) for number, pair in enumerate(records(gears.get("tooth_pairs")))],
            "meshes": _one_of_each_kind(records(gears.get("meshes"))), "mode_shapes": gears.get("mode_shapes"), "campbell": _campbell(speeds), "meetings": gears.get("meetings"),
            "runs": [_run(row, gears["swept_rpm"]) for row in speeds], "spectrum": _spectrum(record(gears.get("load_series")))}


def _one_of_each_kind(meshes: list[dict]) -> list[dict]:
    """Those of the first planet: meshes of a kind differ in their phase only."""
    first: dict[str, dict] = {}
    for mesh in meshes:
        first.setdefault(mesh["name"].rsplit(" ", 1)[0], mesh)
    return list(first.values())


def _placed(pair: dict, external: bool) -> dict:
    """Lengths in mm from the pitch point, y along the line of centres towards the second axis (sun mesh) or away from both (ring mesh); the tooth on the left
    pushes to the right and, as teeth grow thinner outward, outward.

        centre_y, sense   a point at radius R, angle phi from the line of centres is (R sin phi, centre_y + sense R cos phi)
        axis_deg          phi of the axis of symmetry of the touching tooth
        radius_mm, half_angle_deg   its flank from root to tip
    """
    angle = np.radians(pair["working_pressure_angle_deg"])
    contact = pair["contact_from_pitch_point_mm"] * np.array([np.cos(angle), np.sin(angle)])
    pitch_radii = [gear["base_radius_mm"] / np.cos(angle) for gear in pair["gears"]]
    axes = ((-pitch_radii[0], 1.0), (pitch_radii[1], -1.0) if external else (-pitch_radii[1], 1.0))
    gears = [_gear(gear, *axis, contact, side, external or side < 0) for gear, axis, side in zip(pair["gears"], axes, (-1.0, 1.0))]
    return {"mesh": pair["mesh"], "working_pressure_angle_deg": pair["working_pressure_angle_deg"], "contact_x_mm": float(contact[0]),
            "contact_y_mm": float(contact[1]), "gears": gears}


def _gear(gear: dict, centre: float, sense: float, contact: np.ndarray, side: float, external: bool) -> dict:
    """`side`: -1 for the tooth left of the contact, +1 for the one on its right."""
    radius = np.hypot(contact[0], contact[1] - centre)
    working = np.arccos(min(1.0, gear["base_radius_mm"] / radius))
    involute = np.degrees(np.tan(working) - working)
    half = gear["base_half_angle_deg"] + (-involute if external else involute)
    return {**gear, "centre_y_mm": centre, "sense": sense,
            "axis_deg": float(np.degrees(np.arctan2(contact[0], sense * (contact[1] - centre))) + side * half)}


def _campbell(speeds: list[dict]) -> dict:
    """Frequencies of each single mode over speed, gathered by kind and rank."""
    lines: dict[tuple, dict] = {}
    for i, row in enumerate(speeds):
        for mode in row["modes"]:
            line = lines.setdefault((mode["kind"], mode["rank"]), {"name": mode["name"], "frequency_Hz": [None] * len(speeds)})
            line["frequency_Hz"][i] = mode["frequency_Hz"]
    return {"speed_rpm": [row["speed_rpm"] for row in speeds], "mesh_frequency_Hz": [row["mesh_frequency_Hz"] for row in speeds],
            "modes": [line for _, line in sorted(lines.items())]}


def _run(row: dict, swept: list[float]) -> dict:
    found = {"speed_rpm": row["speed_rpm"], "swept": row["speed_rpm"] in swept, "status": row["status"]}
    if run := record(row.get("run")):
        found |= {"steady": run["steady"], "acceleration_m_per_s2": {axis: run["planet_acceleration_m_per_s2"][axis] for axis in ("x", "y")},
                  "load_sharing": run["load_sharing"], "parted_share": run["separated_fraction"]}
    return found


def _spectrum(series: dict) -> dict:
    """Amplitudes of the tangential load on the first planet over orders of the mesh frequency."""
    if "load_N" not in series:
        return series
    load, time, periods = np.array(series["load_N"]), np.array(series["time_s"]), series["periods"]
    angle = 2 * np.pi * series["mesh_frequency_Hz"] / periods * (time - time[0])
    lines = np.arange(1, ORDERS * periods + 1)
    turned = np.exp(1j * np.outer(lines, angle)) @ (load - load.mean())
    return {**{name: series[name] for name in ("speed_rpm", "status", "mesh_frequency_Hz")}, "mean_N": float(load.mean()),
            "order": (lines / periods).tolist(), "amplitude_N": (2 / len(load) * np.abs(turned)).tolist()}
