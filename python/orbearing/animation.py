"""One page for each dynamic point that plays its last stored orbit: rollers, cage and rings in the carrier frame."""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import Any, Iterator

import numpy as np

from orbearing.blocks import format_number, is_number
from orbearing.figures.cage_orbit import clearance
from orbearing.lives import LUNDBERG_PALMGREN
from orbearing.point_file import PointFile, read_point
from orbearing.result_folder import Report

HERE = Path(__file__).parent
FOLDER = "animations"
MOST_PAGES = 60  # more points than anyone opens one by one
MOST_VALUES = 50_000  # of all rollers together, so that a page stays well below 2 MB
RAD_PER_S = np.pi / 30  # of 1 rpm
FACTORS = [base * 10**power for power in range(5) for base in (1, 2, 5)]
SHOWN_SHIFT = 0.03  # largest drawn shift of the cage over the outside diameter
PACES = (4, 8, 16, 40)  # [s] for one orbit
SIZES = {"bore": "bore_mm", "innerRaceway": "inner_raceway_diameter_mm", "pitch": "pitch_diameter_mm", "roller": "roller_diameter_mm",
         "outerRaceway": "outer_raceway_diameter_mm", "outside": "outside_mm"}
CAGE_SIZES = {"cageInner": "cage_inner_mm", "cageOuter": "cage_outer_mm"}
NEEDED = ("roller_angle", "roller_inner_load", "roller_outer_load", "roller_spin")
NOTES = (
    "Frame of the carrier: x points outward from the sun, y along carrier rotation; the carrier turns counter-clockwise. Everything is to "
    "scale except the shift of the cage, which is drawn {factor} times as large as it is, and the clearances, too small to be seen. Bars "
    "outside are loads on the outer race, bars inside those on the inner race; rollers are the darker the more they carry. The line in a "
    "roller shows its rotation, the long marks on the outer ring and on the cage theirs; arrows show their sense. The small circle is the "
    "clearance of the cage in its guidance, with the path of its centre. Slip is measured against pure rolling."
)
NOTES_WITHOUT_CAGE = (
    "Frame of the carrier: x points outward from the sun, y along carrier rotation; the carrier turns counter-clockwise. Everything is to "
    "scale except the clearances, and the gaps between rollers where they are too small to be seen. Bars outside are loads on the outer "
    "race, bars inside those on the inner race; rollers are the darker the more they carry. The line in a roller shows its rotation, the "
    "long mark on the outer ring its; arrows show their sense. Slip is that of the rollers' mean orbital speed against pure rolling."
)


def file_name(speed_rpm: float) -> str:
    """animations/6000rpm.html"""
    return f"{FOLDER}/{speed_rpm:.6g}rpm.html"


def speeds(report: Report) -> list[float]:
    """Input speeds [rpm] that get a page: those computed on the line of speeds that is shown, also without a life by the standards."""
    alive = [p["input_speed_rpm"] for p in report.records("points")
             if is_number(p.get("input_speed_rpm")) and is_number(p.get(LUNDBERG_PALMGREN))] if report.is_dynamic else []
    return sorted(set(alive))[:MOST_PAGES]


def pages(report: Report) -> Iterator[tuple[str, str]]:
    """Name below the result folder and text of each page; points whose files lack the motion have none."""
    for speed in speeds(report):
        content = content_of(report, read_point(report, speed), speed)
        if content:
            yield file_name(speed), page(report, speed, content)


def content_of(report: Report, point: PointFile, speed_rpm: float) -> dict[str, Any] | None:
    """What the page plays, in mm, µm, N, rad and s; None where something is missing."""
    drawing, rolling = report.record("drawing"), report.record("kinematics")
    caged = point.get("time", "orbit_speed") is None
    size = {name: drawing.get(key) for name, key in {**SIZES, **(CAGE_SIZES if caged else {})}.items()}
    of_cage = ("cage_position", "cage_angle", "cage_speed") if caged else ("orbit_speed",)
    series = point.get("time", *of_cage, *NEEDED)
    if series is None or not all(is_number(value) and value > 0 for value in size.values()) or not is_number(rolling.get("outer_race")):
        return None
    instants, rollers = len(series[0]), len(series[-1])
    of_set = [(2, instants), (instants,), (instants,)] if caged else [(instants,)]
    shapes = [(instants,), *of_set, *[(rollers, instants)] * len(NEEDED)]
    if instants < 2 or [values.shape for values in series] != shapes or not all(np.isfinite(values).all() for values in series):
        return None
    stride = -(-instants * rollers // MOST_VALUES)
    time, *of_set, angle, inner, outer, spin = (values[..., ::stride] for values in series)
    return {
        "size": size, **(cage_motion(*of_set[:2], drawing) if caged else {}), "orbitSpeed": rounded(of_set[-1], 3),
        "largest": float(max(inner.max(), outer.max(), 1e-9)), "outerSpeed": rolling["outer_race"] * speed_rpm * RAD_PER_S,
        "orbitRolling": rolling["cage"] * speed_rpm * RAD_PER_S if is_number(rolling.get("cage")) else None,
        "time": rounded(time, 8), "angle": rounded(np.unwrap(angle, axis=1), 4), "inner": rounded(inner, 1), "outer": rounded(outer, 1),
        "turned": rounded(rotation(time, spin), 3),
    }


def cage_motion(place: np.ndarray, angle: np.ndarray, drawing: dict[str, Any]) -> dict[str, Any]:
    """Path [µm] and rotation [rad] of the cage, and how much larger its shift is drawn."""
    return {
        "factor": exaggeration(1e6 * np.hypot(*place).max(), drawing["outside_mm"]), "clearance": clearance(drawing) or 0.0,
        "cageX": rounded(1e6 * place[0], 2), "cageY": rounded(1e6 * place[1], 2),
        "cageAngle": rounded(angle - 2 * np.pi * np.floor(angle[0] / (2 * np.pi)), 4),
    }


def exaggeration(shift_um: float, outside_mm: float) -> int:
    """How many times as large as it is the cage's shift is drawn: the roundest factor that keeps it visible and small."""
    room = SHOWN_SHIFT * outside_mm * 1e3
    return max((factor for factor in FACTORS if factor * shift_um <= room), default=1)


def rotation(time: np.ndarray, speed: np.ndarray) -> np.ndarray:
    """Angle [rad] from zero that follows from speeds [rad/s] at these instants, by trapezoids."""
    steps = np.diff(time) * (speed[:, 1:] + speed[:, :-1]) / 2
    return np.concatenate([np.zeros((len(speed), 1)), np.cumsum(steps, axis=1)], axis=1)


def rounded(values: np.ndarray, digits: int) -> list:
    return np.round(values, digits).tolist()


def page(report: Report, speed_rpm: float, content: dict[str, Any]) -> str:
    """The whole document, which needs nothing from outside."""
    name = report.record("case").get("name") or "unnamed case"
    title = f"{name}, {format_number(speed_rpm)} rpm input speed" + (f", {report.line}" if report.line else "")
    carrier = report.record("kinematics").get("carrier")
    caged = "factor" in content
    what = "the cage" if caged else "the rollers"
    rows = [("now-time", "time"), ("now-orbit", f"speed of {what} in the carrier frame" + ("" if caged else ", mean")),
            ("now-slip", f"slip of {what}"), ("now-load", "largest load of a roller"), ("now-carrying", "rollers that carry"),
            *([("now-shift", "shift of the cage")] if caged else [])]
    cells = "\n".join(f'<tr><th scope="row">{label}</th><td id="{key}"></td></tr>' for key, label in rows)
    cells += ('\n<tr><th scope="row">speed of the planet in the carrier frame</th>'
              f'<td>{format_number(content["outerSpeed"] / RAD_PER_S, 5)} rpm</td></tr>')
    if is_number(carrier):
        cells += f'\n<tr><th scope="row">speed of the carrier</th><td>{format_number(carrier * speed_rpm, 5)} rpm</td></tr>'
    paces = "".join(f'<option value="{value}"{" selected" if value == PACES[1] else ""}></option>' for value in PACES)
    data = json.dumps(content, separators=(",", ":")).replace("</", "<\\/")
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(title)}</title>
<style>
{_part("animation.css")}</style>
</head>
<body>
<main>
<h1>{escape(title)}: one orbit of {what}</h1>
<div class="stage">
<div class="drawing"><canvas id="bearing" role="img" aria-label="Rollers, {"cage and " if caged else ""}rings in motion, loads as bars"></canvas></div>
<div class="side">
<div class="controls"><button id="play" type="button">Play</button>
<select id="pace" aria-label="pace">{paces}</select>
<input id="instant" type="range" min="0" max="1" step="any" value="0" aria-label="instant of the orbit"></div>
<table>
{cells}
</table>
<canvas id="trace" role="img" aria-label="Loads of the marked roller over the orbit"></canvas>
</div>
</div>
<p>{escape(NOTES.format(factor=content["factor"]) if caged else NOTES_WITHOUT_CAGE)}</p>
</main>
<script type="application/json" id="data">{data}</script>
<script>
{_part("animation.js")}</script>
</body>
</html>
"""


def _part(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8")
