"""The answer in one sentence, and the table under it."""

from __future__ import annotations

import numpy as np

from orbearing.blocks import MISSING, Table, format_change, format_number, format_quantity, is_number
from orbearing.figures.carrier_revolution import shortest_life
from orbearing.figures.load_spectrum import in_words, of_set, spectrum_of, worst_key, worst_life
from orbearing.lives import LUNDBERG_PALMGREN, name_of_worst
from orbearing.result_folder import Report, curve
from orbearing.style import a_life, life_name

# By which rung of the ladder: the answer's own words, and what the rung computes.
HOW = {
    "quasi-static": ", by the quasi-static model",
    "dynamic": ", with the bearing in motion, driven by the gears",
    "co-simulated": ", with gears and bearings in motion, by exchange",
    "monolithic": ", with gears and bearings in motion as one system",
}
FIDELITIES = {
    "quasi-static": ": rollers and cage turn at their kinematic speeds under the mean loads",
    "dynamic": ": rollers and cage in motion, shaken by the gears one way",
    "co-simulated": ": gears and all bearings act on each other, by exchange in windows",
    "monolithic": ": gears and all bearings act on each other as one system of equations",
}


def best(report: Report) -> tuple[float | None, float | None]:
    """Speed [rpm] and life [h] of the peak: the refined one, else the grid's."""
    peak = report.record("peak")
    for prefix in ("refined_", ""):
        speed, life = peak.get(f"{prefix}speed_rpm"), peak.get(f"{prefix}life_h")
        if is_number(speed) and is_number(life):
            return speed, life
    return None, None


def headline(report: Report) -> str:
    """Peak speed and life in words, or why there are none."""
    report, others = report.along_speed(), f" with {report.line}" if report.line else ""
    speed, life = best(report)
    if speed is None:
        return f"No point of this sweep gave {a_life(report.life_key)}, so there is no peak to report."
    where = f"at {format_number(speed, 4)} rpm input speed{others}"
    missing, spectrum = report.record("missing"), spectrum_of(report)
    if missing.get("points"):
        shard = f", shard {missing['shard']}" if missing.get("shard") else ""
        return (f"Incomplete sweep, {missing.get('found')} of {missing.get('of')} points{shard}: the longest {life_name(report.life_key)} of these points is {format_number(life, 3)} hours, "
                f"{where}; the missing points may have longer ones.")
    if missing:
        return f"Peak not yet refined: the longest {life_name(report.life_key)} of the points so far is {format_number(life, 3)} hours, {where}{HOW.get(report.fidelity, '')}."
    if is_number(worst_life(spectrum)):
        return f"Load spectrum{others}: {in_words(worst_key(spectrum))} of the planet bearing{of_set(spectrum)}: {format_number(worst_life(spectrum), 3)} hours{HOW.get(report.fidelity, '')}."
    if len(report.records("points")) == 1:
        point = report.records("points")[0]
        key = name_of_worst(point, report.life_key)
        return (f"Operating point: {in_words(key)} of the planet bearing{of_set(point)} {where}: {format_number(point.get(key, life), 3)} hours (a single point, no peak).")
    return f"Longest {report.life_key} of the planet bearing {where}: {format_number(life, 3)} hours{HOW.get(report.fidelity, '')}."


def summary_table(report: Report) -> Table:
    """What was computed and what came out."""
    points, failed = report.records("points"), report.failed_points
    report, line = report.along_speed(), report.line
    case, peak = report.record("case"), report.record("peak")
    rows = [
        ("Case", f"{case.get('name') or MISSING} ({case.get('model') or 'model not named'})"),
        ("Source", case.get("source")),
        ("Fidelity", f"{report.fidelity}{FIDELITIES.get(report.fidelity, '')}"),
        ("Points of the sweep", f"{len(points)}, of which {len(failed)} without {a_life(report.life_key)}{_added(points)}"),
        *([("Missing", _capital(str(report.record("missing").get("text"))))] if report.record("missing") else []),
        *([("Shown over speed", f"the points with {line}, nearest to the case's own")] if line else []),
        ("Governing life", report.life_key),
        *_spectrum_rows(report),
        ("Peak of the grid", _speed_and_life(peak.get("speed_rpm"), peak.get("life_h"))),
        ("Peak of all points", _speed_and_life(*best(report)) + _edge_note(report)),
        *_published_rows(report),
        *_least_load_rows(report),
        *_carrier_rows(report),
        ("Assumptions and warnings", f"{len(report.records('assumptions'))} and {_count(report.content.get('warnings'))}, listed below"),
    ]
    return Table(("Result", "Value"), rows)


def _spectrum_rows(report: Report) -> list[tuple[str, str]]:
    """The life that requirements are judged by where the case has a load spectrum."""
    spectrum = spectrum_of(report)
    if not is_number(worst_life(spectrum)):
        return []
    return [("Life under the load spectrum", f"{in_words(worst_key(spectrum))}{of_set(spectrum)} {format_quantity(worst_life(spectrum), 'h')}")]


def _carrier_rows(report: Report) -> list[tuple[str, str]]:
    """The worst planet bearing over a revolution of a carrier whose bearings are stated."""
    carrier = report.record("carrier")
    if not carrier:
        return []
    found = shortest_life(report)
    life = f"{report.life_key} {format_quantity(found[1], 'h', 4)}, " if found else ""
    worst = (f"{format_number(carrier.get('largest_load_share'), 4)} of the load shared evenly, {life}"
             f"at the case's own operating point")
    return [("Worst bearing over a revolution of the carrier", worst)]


def _published_rows(report: Report) -> list[tuple[str, str]]:
    changed = report.content.get("changed_inputs")
    by = "" if report.life_key == LUNDBERG_PALMGREN else ", Lundberg-Palmgren"
    rows = [("Published numbers", f"not compared, since this case is another than the published one: {'; '.join(map(str, changed))}")] if changed else []
    for item in report.records("published"):
        speed, life = item.get("speed_rpm"), item.get("life_h")
        if is_number(speed) and is_number(life):
            ours = item.get("ours_h")
            text = f"{_speed_and_life(speed, life)}{by}; " + (
                f"ours there {format_quantity(ours, 'h')}, {format_change(ours, life)} ({item.get('ours_by') or 'computed'})" if is_number(ours)
                else "ours there is not computed: the sweep has no point at that speed")
            rows.append((f"Published, {item.get('source') or 'unnamed source'}", text))
    return rows


def _least_load_rows(report: Report) -> list[tuple[str, str]]:
    speed, load = curve(report.record("fine"), "speed_rpm", "planet_load_N")
    if np.isfinite(load).sum() < 3:
        return []
    least = int(np.nanargmin(load))
    return [("Least planet load", f"{format_quantity(load[least], 'N', 4)} at {format_quantity(speed[least], 'rpm', 4)} (one bearing, quasi-static)")]


def _edge_note(report: Report) -> str:
    """A best point at the end of the sweep need not be the peak."""
    speeds = report.point_column("input_speed_rpm")
    speeds = speeds[np.isfinite(speeds)]
    speed = best(report)[0]
    if len(speeds) > 1 and is_number(speed) and speed in (speeds.min(), speeds.max()):
        return "; at the edge of the sweep, so the true peak may lie beyond it"
    return ""


def _speed_and_life(speed: object, life: object) -> str:
    if not (is_number(speed) and is_number(life)):
        return MISSING
    return f"{format_number(speed)} rpm, {format_number(life)} h"


def _added(points: list[dict]) -> str:
    added = sum(point.get("refined") is True for point in points)
    return f"; {added} of them added around the peak" if added else ""


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _count(value: object) -> int:
    return len(value) if isinstance(value, list) else 0
