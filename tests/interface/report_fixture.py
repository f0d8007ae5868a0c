"""A made-up but plausible report.json, from the closed forms of a planet at constant power.

Per bearing, n the input speed in units of 1000 rpm: tangential load A/n, radial mesh force C/n inward,
centrifugal load B n^2. The rollers carry as at zero clearance, load ~ deflection^(10/9).
"""

import json
from pathlib import Path

import numpy as np

A, B, C = 6390.0, 19.1, 281.0  # [N] at 1000 rpm
ROLLERS = 15
LIFE = 4.6e4 * 6 * 1243.0**4  # [h N^4 krpm], places the life near 46,000 h at 6000 rpm
OUTER_EXTRA = 0.11  # [N/krpm^2] centrifugal force of one roller
GRID = list(range(1000, 13000, 1000))


def loads(speed_rpm, own=1.0):
    n = np.asarray(speed_rpm, dtype=float) / 1000
    tangential, radial, centrifugal = A / n, -C / n, own * B * n**2
    return tangential, radial, centrifugal, np.hypot(tangential, radial + centrifugal)


def life(speed_rpm, own=1.0, worth=1.0):
    return worth * LIFE / (loads(speed_rpm, own)[3] ** 4 * np.asarray(speed_rpm) / 1000)


def distribution(speed_rpm, clearance=0.0):
    """Angle [deg], inner and outer loads [N]: the rollers opposite to the load on the planet carry."""
    tangential, radial, centrifugal, total = (float(v) for v in loads(speed_rpm))
    angle = np.arange(ROLLERS) * 360 / ROLLERS
    zone = np.arctan2(tangential, radial + centrifugal) + np.pi
    shape = np.maximum(np.cos(np.radians(angle) - zone) - clearance, 0) ** (10 / 9)
    inner = shape * total / np.sum(shape * np.cos(np.radians(angle) - zone))
    return angle.tolist(), inner.tolist(), (inner + OUTER_EXTRA * (speed_rpm / 1000) ** 2).tolist()


def point(speed_rpm):
    tangential, radial, centrifugal, total = (float(v) for v in loads(speed_rpm))
    _, inner, outer = distribution(speed_rpm)
    hours = float(life(speed_rpm))
    return {
        "input_speed_rpm": speed_rpm, "carrier_speed_rpm": speed_rpm / 3.135, "planet_load_N": total,
        "tangential_load_N": tangential, "centrifugal_load_N": centrifugal,
        "inner_load_max_N": max(inner), "inner_load_rms_N": float(np.sqrt(np.mean(np.square(inner)))),
        "outer_load_max_N": max(outer), "outer_load_rms_N": float(np.sqrt(np.mean(np.square(outer)))),
        "inner_life_Mrev": hours * 0.12, "outer_life_Mrev": hours * 0.2, "life_h": hours,
        "system_life_h": hours * 8 ** (-8 / 9), "cage_slip": 0.0, "film_inner_um": None, "film_outer_um": None,
        "status": "ok", "radial_mesh_load_N": radial,
    }


def ablation_entry(name, own=1.0, worth=1.0):
    speeds = np.linspace(1000, 12000, 56)
    lives = life(speeds, own, worth)
    best = int(np.argmax(lives))
    return {"name": name, "speed_rpm": speeds.tolist(), "life_h": lives.tolist(),
            "peak_speed_rpm": float(speeds[best]), "peak_life_h": float(lives[best])}


def polar(speed_rpm):
    angle, inner, outer = distribution(speed_rpm)
    tangential, radial, centrifugal, _ = (float(v) for v in loads(speed_rpm))
    return {"speed_rpm": speed_rpm, "angle_deg": angle, "inner_load_N": inner, "outer_load_N": outer,
            "planet_load_x_N": radial + centrifugal, "planet_load_y_N": tangential}


def drawing():
    angle, inner, outer = distribution(6000)
    return {"speed_rpm": 6000, "inner_raceway_diameter_mm": 30.4, "outer_raceway_diameter_mm": 40.88,
            "roller_diameter_mm": 5.24, "pitch_diameter_mm": 35.64, "rollers": ROLLERS, "cage_inner_mm": 35.9,
            "cage_outer_mm": 40.2, "bore_mm": 25.0, "outside_mm": 47.0, "clearance_um": 0.0,
            "roller_angle_deg": angle, "inner_load_N": inner, "outer_load_N": outer}


def fine():
    speeds = np.linspace(1000, 12000, 221)
    tangential, radial, centrifugal, total = loads(speeds)
    return {"speed_rpm": speeds.tolist(), "life_h": life(speeds).tolist(), "planet_load_N": total.tolist(),
            "tangential_load_N": tangential.tolist(), "radial_mesh_load_N": radial.tolist(),
            "centrifugal_load_N": centrifugal.tolist()}


def ablation():
    return [
        ablation_entry("all effects"),
        ablation_entry("no carrier centrifugal (rollers and cage)", own=0.953),
        ablation_entry("no carrier centrifugal (planet)", own=0.047),
        ablation_entry("no own orbit", own=0.9995),
        ablation_entry("no Coriolis", own=1.004),
        ablation_entry("clearance 10 µm", worth=0.5),
        ablation_entry("clearance 37 µm", worth=0.2),
        ablation_entry("with film", worth=1.07),
    ]


def make_report():
    content = fine()
    best = int(np.argmax(content["life_h"]))
    return {
        "case": {"name": "reducer_150kW", "source": "[Gai2025], Tables 1 and 2", "model": "planetary-drivetrain"},
        "versions": {"orbearing": "0.1.0", "compiler": "g++ 12.2.0", "instruction set": "x86-64"},
        "warnings": ["gearset.profile_shift: the planet's teeth are undercut (shift \u22120.4594, least \u22120.2865)"],
        "assumptions": [
            {"key": "bearing.radial_clearance", "reason": "the raceway diameters leave none, though 37 µm is listed",
             "value": "0 um", "worth_h": -36800.0, "worth_text": "with 37 µm a fifth is left"},
            {"key": "bearing.cage.material", "reason": "not given", "value": "polyamide", "worth_h": None, "worth_text": ""},
        ],
        "fidelity": "quasi-static",
        "points": [point(speed) for speed in GRID],
        "peak": {"speed_rpm": 6000, "life_h": float(life(6000)), "refined_speed_rpm": content["speed_rpm"][best],
                 "refined_life_h": content["life_h"][best]},
        "published": [{"source": "[Gai2025]", "quantity": "life at the peak", "speed_rpm": 6000, "life_h": 43869}],
        "fine": content, "polar": [polar(speed) for speed in (1000, 6000, 12000)], "drawing": drawing(),
        "ablation": ablation(),
        "validation": [{"source": "[Gai2025]", "quantity": "life at 6000 rpm [h]", "published": 43869, "ours": float(life(6000)),
                    "deviation": "+4.9 %", "tolerance": "15 %", "verdict": "reproduced"}],
        "dynamic": None,
    }


def write_report(folder, content):
    Path(folder, "report.json").write_text(json.dumps(content, ensure_ascii=False), encoding="utf-8")
