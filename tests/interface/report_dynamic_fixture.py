"""A made-up dynamic result: report.json, manifest and point files, of rollers that carry just as quasi-static ones.

One cage revolution is stored; every roller passes the loads of `report_fixture.distribution`, and the cage's centre
runs round a circle of half its clearance. Cage and rollers turn a little slower than at pure rolling.
"""

import json
from pathlib import Path

import numpy as np
import report_fixture as fixture

CAGE_OUTER, GUIDE_LAND = 40.2, 40.6  # [mm]
CLEARANCE = 1e-3 * (GUIDE_LAND - CAGE_OUTER) / 2  # [m] radial
INSTANTS, PLACES = 240, 72
CAGE_SLIP, ROLLER_SLIP = 0.01, 0.05
# Speeds relative to the carrier over the input speed; the planet turns against the carrier.
ROLLING = {"inner_race": 0.0, "outer_race": -1.06, "cage": -0.6 / (1 - CAGE_SLIP), "roller_spin": -4.1, "carrier": 0.319}
CAUSES = ("race_damping", "inner_traction", "outer_traction", "rolling", "drag", "pockets", "guidance", "support")
EFFECTS = {"all effects": 1.0, "no Coriolis": 0.996, "no carrier centrifugal": 40.0, "film in the approach": 1.1}


def losses(speed_rpm):
    """Watts by cause; the support's share is far too small to be drawn."""
    return {f"power_loss_{name}_W": (speed_rpm / 1000) ** 2 * (0.1 + 0.2 * i) * (1e-5 if name == "support" else 1.0)
            for i, name in enumerate(CAUSES)}


def make_report():
    content = fixture.make_report()
    content["fidelity"] = "dynamic"
    content.update(axes=[], slice=None, branches=None, kinematics=ROLLING)
    peak = content["peak"]  # the best of all points is one of the grid's
    peak.update(refined_speed_rpm=peak["speed_rpm"], refined_life_h=peak["life_h"])
    content["drawing"].update(cage_outer_mm=CAGE_OUTER, guide_land_mm=GUIDE_LAND)
    for point in content["points"]:
        point.update(losses(point["input_speed_rpm"]), roller_slip=0.05, cage_slip=0.01 - 1e-6 * point["input_speed_rpm"])
    content["dynamic"] = {"ablation": [ablation(name, worth) for name, worth in EFFECTS.items()],
                          "quasi_static": {"polar": content["polar"]}}
    return content


def ablation(name, worth):
    # The speeds carry the round-off of a conversion to rad/s and back.
    rows = [{"speed_rpm": speed * (1 + 2e-16), "status": "ok", "life_h": worth * float(fixture.life(speed)), "cage_slip": -0.002,
             "roller_slip": 0.06 / worth, "power_loss_W": 66.0, "outer_load_rms_N": 160.0} for speed in (1000, 6000, 12000)]
    return {"name": name, "points": rows}


def loads_at(speed_rpm, angle):
    """Inner and outer load [N] at places [rad], from those of the quasi-static polar figure."""
    place, inner, outer = fixture.distribution(speed_rpm)
    return [np.interp(np.degrees(angle), place, load, period=360.0) for load in (inner, outer)]


def variables(speed_rpm):
    """Name -> (dimensions, unit, values) as a point file holds them."""
    revolution = 2 * np.pi / (0.6 * speed_rpm * np.pi / 30)
    time = 0.1 + np.linspace(0, revolution, INSTANTS)
    start = 2 * np.pi * np.arange(fixture.ROLLERS)[:, None] / fixture.ROLLERS
    turn = 2 * np.pi * np.linspace(0, 1, INSTANTS)
    angle, places = np.mod(start - turn, 2 * np.pi), 2 * np.pi * np.arange(PLACES) / PLACES
    inner, outer = loads_at(speed_rpm, angle)
    rollers = {"angle": angle, "inner_load": inner, "outer_load": outer, "inner_sliding": 1 / (1 + inner),
               "spin": (1 - ROLLER_SLIP) * ROLLING["roller_spin"] * speed_rpm * np.pi / 30 + 0 * angle, "outer_sliding": -1 / (1 + outer), "inner_film": 2e-7 + 0 * angle, "outer_film": 3e-7 + 0 * angle}
    mean = loads_at(speed_rpm, places)
    return {
        "time": (("time",), "s", time),
        **{f"roller_{name}": (("roller", "time"), "SI", values) for name, values in rollers.items()},
        "cage_angle": (("time",), "rad", 40 * np.pi - turn),
        "cage_speed": (("time",), "rad s-1", np.full(INSTANTS, -0.6 * speed_rpm * np.pi / 30)),
        "cage_position": (("direction", "time"), "m", CLEARANCE / 2 * np.array([np.cos(turn), np.sin(turn)])),
        "angle": (("place",), "rad", places),
        "inner_load": (("place",), "N", mean[0]),
        "outer_load": (("place",), "N", mean[1]),
    }


def write_results(folder, content, change=lambda name, values: values):
    """Everything the report reads; `change` may alter a variable's values or leave it out by None."""
    import netCDF4

    fixture.write_report(folder, content)
    points = Path(folder, "points")
    points.mkdir()
    lines = [{"orbearing_results": 1, "fidelity": "dynamic", "points": len(fixture.GRID)}]
    for index, speed in enumerate(fixture.GRID):
        lines.append({"point": index, "file": f"points/{index:05}.nc", "row": {"input_speed_rpm": speed * (1 + 2e-16)}})
        with netCDF4.Dataset(points / f"{index:05}.nc", "w") as data:
            for name, size in (("time", INSTANTS), ("roller", fixture.ROLLERS), ("direction", 2), ("place", PLACES)):
                data.createDimension(name, size)
            for name, (dimensions, unit, values) in variables(speed).items():
                changed = change(name, values)
                if changed is not None:
                    variable = data.createVariable(name, "f8", dimensions)
                    variable.units = unit
                    variable[...] = changed
    # A killed run may leave a torn last line.
    text = "\n".join(json.dumps(line) for line in lines) + '\n{"point": 12, "fi'
    Path(folder, "manifest.jsonl").write_text(text, encoding="utf-8")
