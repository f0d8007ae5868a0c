#!/usr/bin/env python3
"""What each figure draws, read from matplotlib's objects, is what the results say, in the unit of its label.

Every artist of every picture has to be expected here, and everything expected has to be drawn: a figure that is not covered fails.
Exit code 77 (skipped) where matplotlib or netCDF4 is missing.
"""

import re
import sys
import tempfile
import types
import unittest
import unittest.mock
from pathlib import Path

try:
    import matplotlib  # noqa: F401
    import netCDF4  # noqa: F401
    import numpy as np
except ImportError:
    print("skipped: matplotlib, numpy or netCDF4 is missing")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import figures_fixture as made  # noqa: E402
import report_dynamic_fixture as dynamic  # noqa: E402
import report_fixture as fixture  # noqa: E402
from orbearing import report, style  # noqa: E402
from orbearing.drawn import Panel, panels_of  # noqa: E402
from orbearing.figures import cage_orbit as orbit_figure, carrier_revolution, gear_modes, roller_pressure, static_loads  # noqa: E402
from orbearing.point_file import PointFile  # noqa: E402
from orbearing.result_folder import Report, read_report  # noqa: E402

# Quantity of a unit, and its size in the SI unit.
UNITS = {"rpm": ("speed", np.pi / 30), "rad/s": ("speed", 1.0), "h": ("time", 3600.0), "s": ("time", 1.0), "ms": ("time", 1e-3), "N": ("force", 1.0), "kN": ("force", 1e3),
         "MPa": ("pressure", 1e6), "GPa": ("pressure", 1e9), "m": ("length", 1.0), "mm": ("length", 1e-3), "µm": ("length", 1e-6), "Hz": ("frequency", 1.0),
         "kHz": ("frequency", 1e3), "%": ("ratio", 0.01), "1": ("ratio", 1.0), "rad": ("angle", 1.0), "mrad": ("angle", 1e-3), "deg": ("angle", np.pi / 180),
         "degree": ("angle", np.pi / 180), "°": ("angle", np.pi / 180), "N m": ("torque", 1.0), "W": ("power", 1.0), "N/m": ("stiffness", 1.0),
         "N/µm": ("stiffness", 1e6), "m/N": ("compliance", 1.0), "nm/N": ("compliance", 1e-9), "m/s": ("velocity", 1.0), "m/s²": ("acceleration", 1.0),
         "kW": ("power", 1e3), "N/mm/µm": ("line stiffness", 1e9), "order": ("order", 1.0)}


class Q:
    """Numbers of the results in the unit that their key states."""

    def __init__(self, values, unit):
        self.values = np.array([np.nan if value is None else value for value in np.ravel(values)], float).reshape(np.shape(values))
        self.unit = unit

    def given_in(self, unit):
        (what, size), (other, shown) = UNITS[self.unit], UNITS[unit]
        assert what == other, f"a {what} on an axis of {unit}"
        return self.values * size / shown


def named(record, key, *more):
    """A number or a list of a record, with the unit that the end of its key states."""
    ends = (("_rpm", "rpm"), ("_h", "h"), ("L10mrh", "h"), ("_N_per_m", "N/m"), ("_N_m", "N m"), ("_N", "N"), ("_MPa", "MPa"), ("_mm", "mm"), ("_um", "µm"), ("_us", "s"), ("_Hz", "Hz"),
            ("_mrad", "mrad"), ("_deg", "deg"), ("_rad", "rad"), ("_W", "W"), ("_m_per_s2", "m/s²"), ("slip", "1"), ("share", "1"), ("residual", "1"), ("error", "1"))
    unit = next(unit for end, unit in ends if key.endswith(end))
    values = [one.get(key) for one in record] if isinstance(record, list) else record[key]
    return Q(np.array(values, float) * 1e-6 if unit == "s" and key.endswith("_us") else values, unit)


def line(x, y, label=""):
    return "line", label, (x, y)


def rows(points, x, y, label=""):
    return line(named(points, x), named(points, y), label)


def number(value, digits=5):
    """As people read it: so many significant digits, thousands apart, no digit before the point left out."""
    before = int(np.floor(np.log10(abs(value)))) + 1 if value else 1  # digits before the point
    text = f"{value:,.{max(digits - before, 0) if before < 4 else 0}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def unit_of(label):
    found = re.findall(r"\(([^()]*)\)$", label.strip())
    return found[-1].removesuffix(" of the longest").strip() if found else ""


class Expected:
    """One pair of axes: what must stand there. Units are those that the labels state, but where others are given."""

    def __init__(self, *series, x=None, y=None, z="", title=None, x_label=None, y_label=None, texts=None, legend=None, x_limits=(), y_limits=()):
        """Limits are in the axes' units; None for an end that data alone decide."""
        self.series, self.units, self.x_limits, self.y_limits = list(series), (x, y, z), x_limits, y_limits
        self.title, self.x_label, self.y_label, self.texts, self.legend = title, x_label, y_label, texts, legend


def same_numbers(one, other):
    """Rows of numbers, whatever their order and how often each is there."""
    def plain(columns):
        whole = np.array(np.broadcast_arrays(*[np.ravel(column) for column in columns]), float).T
        whole = whole[np.isfinite(whole).all(axis=1)]
        return whole[np.lexsort(np.round(whole, 9).T[::-1])]

    def once(whole):
        kept = [row for number, row in enumerate(whole) if number == 0 or not np.allclose(row, whole[number - 1], rtol=1e-7, atol=1e-12)]
        return np.array(kept)

    a, b = once(plain(one)), once(plain(other))
    return a.shape == b.shape and (a.size == 0 or bool(np.allclose(a, b, rtol=2e-6, atol=1e-9 * np.abs(a).max(axis=0))))


def in_units(kind, columns, units):
    """The expected numbers in the units that the axes' labels state."""
    x, y, z = units
    way = {"line": (x, y), "band": (x, y, y), "bars": (None, x or y), "level": (y,), "place": (x,), "segments": (x, y, x, y), "circle": (x, y, x, x), "area": (x, y),
           "shade": (x,), "points": (x, y, None, z), "map": (x, y, z, z)}[kind]
    return tuple(column.given_in(unit) if isinstance(column, Q) and unit else column.values if isinstance(column, Q) else np.asarray(column, float)
                 for column, unit in zip(columns, way))


def close(kind, drawn, wanted):
    if kind in ("bars", "map", "points"):  # order and place matter
        return all(a.shape == b.shape and np.allclose(a, b, rtol=1e-6, atol=1e-12, equal_nan=True) for a, b in zip(drawn, wanted) if a.size or b.size)
    return same_numbers(drawn, wanted)


def faults(name, panels, expected):
    """Everything that stands in a picture and not in the results, or the other way round."""
    found = [] if len(panels) == len(expected) else [f"{name}: {len(panels)} pairs of axes for {len(expected)}"]
    for number_of, (panel, wanted) in enumerate(zip(panels, expected)):
        where = f"{name}, axes {number_of}"
        units = tuple(unit_of(label) if unit is None else unit for unit, label in zip(wanted.units, (panel.x_label, panel.y_label, "")))
        for what in ("title", "x_label", "y_label", "texts", "legend"):
            if getattr(wanted, what) is not None and getattr(panel, what) != getattr(wanted, what):
                found.append(f"{where}: {what} {getattr(panel, what)!r} for {getattr(wanted, what)!r}")
        for what in ("x_limits", "y_limits"):
            for drawn, end in zip(getattr(panel, what), getattr(wanted, what)):
                if end is not None and abs(drawn - end) > 1e-6 * max(abs(end), 1e-9):
                    found.append(f"{where}: {what} {getattr(panel, what)} for {getattr(wanted, what)}")
        for what, names in (("column_names", panel.ticks[0]), ("row_names", panel.ticks[1])):
            if getattr(wanted, what, names) != names:
                found.append(f"{where}: {what} {names} for {getattr(wanted, what)}")
        left = list(wanted.series)
        for one in panel.series:
            if one.kind in ("level", "place") and not np.any(one.columns[0]):
                continue  # an axis through zero
            match = next((w for w in left if w[:2] == (one.kind, one.label) and close(one.kind, one.columns, in_units(w[0], w[2], units))), None)
            if match:
                left = [w for w in left if w is not match]
            else:
                found.append(f"{where}: {one.kind} {one.label!r} is not what the results say: {[np.round(c[:3], 4).tolist() for c in one.columns]}")
        for w in left:
            found.append(f"{where}: {w[0]} {w[1]!r} is not drawn: {[np.round(np.ravel(c)[:3], 4).tolist() for c in in_units(w[0], w[2], units)]}")
    return found


def speed_axes(*series, **more):
    return Expected(*series, x_label="input speed (rpm)", **more)


LIFE = "life of one bearing (h)"


def life_lines(content, fine_label="quasi-static, fine grid"):
    """Of both pictures of life over speed."""
    points, peak = content["points"], content["peak"]
    grid, added = ([p for p in points if (p.get("refined") is True) is wanted] for wanted in (False, True))
    published = content["published"][0]
    return [rows(content["fine"], "speed_rpm", "life_h", fine_label), rows(points, "input_speed_rpm", "life_h"),
            rows(added, "input_speed_rpm", "life_h", "points added until the peak is known"),
            rows(grid, "input_speed_rpm", "life_h", f"points of the sweep ({content['fidelity']})"),
            rows(peak, "speed_rpm", "life_h", f"grid peak: {number(peak['speed_rpm'])} rpm, {number(peak['life_h'])} h"),
            rows(peak, "refined_speed_rpm", "refined_life_h", f"refined peak: {number(peak['refined_speed_rpm'])} rpm, {number(peak['refined_life_h'])} h"),
            rows(published, "speed_rpm", "life_h", f"published: {published['source']}, {number(published['life_h'])} h")]


def near_peak(content):
    """An eighth of the heights that are in view on both sides, nearly."""
    peak, fine, published = content["peak"], content["fine"], content["published"][0]
    points = [(p["input_speed_rpm"], p["life_h"]) for p in content["points"]] + list(zip(fine["speed_rpm"], fine["life_h"]))
    points += [(peak["speed_rpm"], peak["life_h"]), (peak["refined_speed_rpm"], peak["refined_life_h"]), (published["speed_rpm"], published["life_h"])]
    seen = [life for speed, life in points if life and 0.7 * peak["refined_speed_rpm"] <= speed <= 1.3 * peak["refined_speed_rpm"]]
    return min(seen) - 0.12 * (max(seen) - min(seen)), max(seen) + 0.12 * (max(seen) - min(seen))


def campbell(gears, ends=None, **more):
    content = gears["campbell"]
    kinds = {"R": "rotational", "T": "translational", "P": "planet"}
    lines = [line(named(content, "speed_rpm"), named(mode, "frequency_Hz"), kinds[mode["name"][0]]) for mode in content["modes"]]
    mesh = np.array(content["mesh_frequency_Hz"])
    lines += [line(named(content, "speed_rpm"), Q(order * mesh, "Hz"), "mesh harmonics" if order == 1 else "") for order in (1, 2, 3, 4)]
    lines.append(rows([m for m in gears["meetings"] if m["excited"]], "speed_rpm", "frequency_Hz", "excited meeting"))
    top = 1.06e-3 * max(max(mode["frequency_Hz"]) for mode in content["modes"])
    return [speed_axes(*lines, y_label="frequency (kHz)", x_limits=ends or (content["speed_rpm"][0], content["speed_rpm"][-1]), y_limits=(0.0, top), **more)]


def changes(entry, reference):
    """Change of life in per cent where both curves reach: the fixture has both at the same speeds."""
    return Q(np.array(entry["life_h"]) / np.array(reference["life_h"]) - 1.0, "1")


def ablations(entries):
    upper = [part for e in entries for part in (rows(e, "speed_rpm", "life_h", e["name"]), rows(e, "peak_speed_rpm", "peak_life_h"))]
    lower = [line(named(e, "speed_rpm"), changes(e, entries[0])) for e in entries[1:]]
    return [Expected(*upper, x="rpm", y_label=LIFE), speed_axes(*lower, y_label="change of life (%)")]


def ring_of(angle_deg, load, label):
    return line(Q(angle_deg, "deg"), Q(load, "N"), label)


def polar(entry):
    series = [ring_of(entry["angle_deg"], entry[f"{race}_load_N"], f"{race} race") for race in ("inner", "outer")]
    area = ("area", "", (Q(entry["angle_deg"], "deg"), Q(entry["inner_load_N"], "N")))
    return [Expected(*series, area, x="rad", y="N", y_limits=(0.0, 1.12 * max(*entry["inner_load_N"], *entry["outer_load_N"])),
                     title=f"{number(entry['speed_rpm'])} rpm, load in N", legend=("outer race", "inner race"))]


def dynamic_polars(content, speed):
    """Rings of both models and their difference; quasi-static loads are straight between their places."""
    file = {name: made.variable(speed, name) for name in ("angle", "inner_load", "outer_load")}
    still = next((e for e in content["dynamic"]["quasi_static"]["polar"] if e["speed_rpm"] == speed), None)  # none where the sweep added the point
    place, races = np.degrees(file["angle"]), ("outer", "inner")
    rings = [ring_of(place, file[f"{race}_load"], f"{race}, dynamic") for race in races]
    rings += [ring_of(still["angle_deg"], still[f"{race}_load_N"], f"{race}, quasi-static") for race in races if still]
    gaps = [line(Q(place, "deg"), Q(file[f"{race}_load"] - (np.interp(place, still["angle_deg"], still[f"{race}_load_N"], period=360.0) if still else np.nan), "N"))
            for race in races]
    most = max(max(file[f"{race}_load"].max(), max(still[f"{race}_load_N"]) if still else 0.0) for race in races)
    return [Expected(*rings, x="rad", y="N", title=f"{number(speed)} rpm, load in N", y_limits=(0.0, 1.12 * most)),
            Expected(*gaps, x="deg", y_label="difference (N)", x_limits=(0.0, 360.0))]


def of_first_roller(speed):
    """Time, place and the roller variables of the first roller; it turns once in the stored time."""
    time = made.variable(speed, "time")
    angle = made.variable(speed, "roller_angle")[0]
    mean = made.variable(speed, "inner_load")
    zone = np.interp(angle, made.variable(speed, "angle"), mean, period=2 * np.pi) > mean.max() / 20
    return types.SimpleNamespace(time=Q(time - time[0], "s"), angle=Q(angle, "rad"), zone=zone, of=lambda name, unit: Q(made.variable(speed, name)[0], unit))


def shade(along, zone, label):
    return "shade", label, (Q(along.values[zone], along.unit),)


def drawing(content):
    d = content["drawing"]
    angle, most = np.radians(d["roller_angle_deg"]), max(*d["inner_load_N"], *d["outer_load_N"])
    mm = lambda *values: tuple(Q(np.atleast_1d(value), "mm") for value in values)  # noqa: E731
    circles = [(0, 0, d["outside_mm"] / 2, d["outer_raceway_diameter_mm"] / 2), (0, 0, d["inner_raceway_diameter_mm"] / 2, d["bore_mm"] / 2),
               (0, 0, d["cage_outer_mm"] / 2, d["cage_inner_mm"] / 2)]
    circles += [(d["pitch_diameter_mm"] / 2 * np.sin(a), d["pitch_diameter_mm"] / 2 * np.cos(a), d["roller_diameter_mm"] / 2, 0) for a in angle]
    bars = []
    for loads, foot, sign in ((d["outer_load_N"], 1.03 * d["outside_mm"] / 2, 1), (d["inner_load_N"], 0.98 * d["inner_raceway_diameter_mm"] / 2, -1)):
        for a, load in zip(angle, loads):
            ends = np.array([foot, foot + sign * 0.26 * d["outside_mm"] / 2 * load / most])
            bars += [line(*mm(ends * np.sin(a), ends * np.cos(a))) for _ in range(2 if load > 0 else 0)]  # with a grey edge
    title = f"{number(d['speed_rpm'])} rpm, radial clearance {number(d['clearance_um'])} µm (diametral measure)"
    reach = 1.22 * (1.06 + 0.26) * d["outside_mm"] / 2
    colours = Expected(x_limits=(0.0, most), x_label="contact load: rollers by the greater of both races, bars by their own (N)")
    return [Expected(*(("circle", "", mm(*circle)) for circle in circles), *bars, title=title, x_label="place y along carrier rotation (mm)",
                     y_label="place x outward from the sun (mm)", x_limits=(reach, -reach), y_limits=(-reach, reach)), colours]


LOSSES = {"rolling": "rolling resistance", "pockets": "cage pockets", "drag": "oil drag", "guidance": "cage guidance", "neighbours": "between rollers",
          "outer_traction": "sliding, outer race", "inner_traction": "sliding, inner race", "race_damping": "contact damping"}  # the support's is too small


def losses(points, shares):
    """Stacked in this order, watts or parts of the whole."""
    speed = named(points, "input_speed_rpm")
    all_of_them = np.array([[p[f"power_loss_{cause}_W"] or 0.0 for p in points] for cause in (*LOSSES, "support")])
    parts = all_of_them[:-1] / (all_of_them.sum(axis=0) if shares else 1.0)
    unit, below = "1" if shares else "W", np.concatenate([np.zeros((1, len(points))), np.cumsum(parts, axis=0)])
    bands = [("band", label, (speed, Q(low, unit), Q(high, unit))) for label, low, high in zip(LOSSES.values(), below, below[1:])]
    ends = min(speed.values), max(speed.values)
    return [speed_axes(*bands, y_label="share of the loss (%)" if shares else "power lost in one bearing (W)", x_limits=ends, y_limits=(0.0, 100.0 if shares else None))]


def effects(content):
    runs = content["dynamic"]["ablation"]
    speeds = (1000, 6000, 12000)
    panels = [[], [], []]
    for i, speed in enumerate(speeds):
        at = [next(p for p in run["points"] if abs(p["speed_rpm"] - speed) < 1) for run in runs]
        places = np.arange(len(runs)) + 0.8 * ((i + 0.5) / 3 - 0.5)
        for panel, values in zip(panels, ([0.0, *(p["life_h"] / at[0]["life_h"] - 1 for p in at[1:])], [p["roller_slip"] for p in at], [p["cage_slip"] for p in at])):
            panel.append(("bars", f"{number(speed)} rpm", (places, Q(values, "1"))))
    return [Expected(*panel, x_label=label) for panel, label in zip(panels, ("change of life (%)", "roller slip (%)", "cage slip (%)"))]


def rolling(speed, name):
    """Speed at pure rolling [rad/s]."""
    return dynamic.ROLLING[name] * speed * np.pi / 30


def slips_over_time(speed):
    one, spins = of_first_roller(speed), made.variable(speed, "roller_spin")
    slip = lambda value, name: Q(1 - value / rolling(speed, name), "1")  # noqa: E731
    return [Expected(line(one.time, slip(spins[0], "roller_spin"), "one roller"), line(one.time, slip(spins.mean(axis=0), "roller_spin"), "mean of all"),
                     shade(one.time, one.zone, "load zone of the one"), x="ms", y_label="slip of rollers (%)"),
            Expected(line(one.time, slip(made.variable(speed, "cage_speed"), "cage")), x_label=f"time at {number(speed)} rpm input speed (ms)",
                     y_label="slip of the cage (%)", x_limits=(0.0, 1e3 * one.time.values[-1]))]


def cage_orbit(content, speed):
    """x outward is up, y along rotation is left; a dot at the first instant, a cross at the mean, the clearance as a circle."""
    x, y = made.variable(speed, "cage_position")
    m = lambda *values: tuple(Q(np.atleast_1d(value), "m") for value in values)  # noqa: E731
    radius = 1e-3 * (content["drawing"]["guide_land_mm"] - content["drawing"]["cage_outer_mm"]) / 2
    reach = 1.15e6 * max(radius, np.abs([x, y]).max())
    return [Expected(("circle", "", m(0, 0, radius, 0)), line(*m(0, 0)), line(*m(y, x)), line(*m(y[0], x[0])), line(*m(y.mean(), x.mean())),
                     title=f"{number(speed)} rpm", x_label="y, along carrier rotation (µm)", y_label="x, outward from the sun (µm)", x_limits=(reach, -reach), y_limits=(-reach, reach))]


def gear_vibration(gears):
    runs, meetings = gears["runs"], gears["meetings"]
    swept = [run for run in runs if run["swept"]]
    joined = [("T1", 2, [m for m in meetings if m["mode"] == "T1"]), ("P1", 1, [m for m in meetings if m["mode"] == "P1"])]
    names = []
    for _, order, group in joined:
        at = [m["speed_rpm"] for m in group]
        names += [line(Q([min(at), max(at)], "rpm"), np.array([order, order])), line(Q([np.mean(at)], "rpm"), np.array([order]))]
    panels = [Expected(*names, x="rpm", y_label="mesh harmonic", texts=("P1", "T1"))]
    for way in "xy":
        series = []
        for key, label in (("rms", "rms"), ("max", "largest")):
            for some, shown in ((runs, label), (swept, "")):
                series.append(line(named(some, "speed_rpm"), Q([run["acceleration_m_per_s2"][way][key] for run in some], "m/s²"), shown))
        series += [("place", "", (Q(np.full(2, np.mean([m["speed_rpm"] for m in group])), "rpm"),)) for _, _, group in joined]
        panels.append(Expected(*series, x="rpm", y_label=f"acceleration {way} (m/s²)", y_limits=(0.0, None)))
    panels[2].x_label = "input speed (rpm)"
    spectrum = gears["spectrum"]
    order, amplitude = np.array(spectrum["order"]), np.array(spectrum["amplitude_N"])
    frequency, floor = Q(order * spectrum["mesh_frequency_Hz"], "Hz"), max(1e-6 * amplitude.max(), amplitude.min() / 2)
    lines = [("segments", "", (frequency, Q(np.full(5, floor), "N"), frequency, Q(amplitude, "N")))]
    lines += [("place", "", (Q(np.full(2, n * spectrum["mesh_frequency_Hz"]), "Hz"),)) for n in (1, 2, 3)]
    shares = [[line(named(runs, "speed_rpm"), Q([run["load_sharing"][key][n] for run in runs], "1"), f"planet {n + 1}") for n in range(3)]
              + [("level", "", (Q(np.ones(2), "1"),))] for key in ("mean", "largest")]
    return {"gear-acceleration": panels,
            "gear-spectrum": [Expected(*lines, x_label="frequency (kHz)", y_label="amplitude (N)", texts=("1 ×", "2 ×", "3 ×"),
                                       x_limits=(0.0, None), y_limits=(floor, 8 * amplitude.max()))],
            "gear-sharing": [speed_axes(*series, y_label=label) for series, label in zip(shares, ("mean share (1)", "largest share in time (1)"))]}


def gear_shapes(gears):
    """Members at rest and displaced: rings, sun, carrier, planets; a spoke of each shows its rotation."""
    content, panels = gears["mode_shapes"], []
    distance, ring = content["centre_distance_mm"], content["ring_radius_mm"]
    for mode in content["modes"]:
        q = np.array(mode["shape"])
        parts = [((0, 0), ring, q[3:5], q[5]), ((0, 0), content["sun_radius_mm"], q[:2], q[2]), ((0, 0), 0.22 * distance, q[6:8], 0.22 * q[8])]
        for n, a in enumerate(content["places_rad"]):
            x, y, turn = q[9 + 3 * n:12 + 3 * n]
            turned = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
            parts.append((distance * turned[:, 0], content["planet_radius_mm"], turned @ [x, y], turn))
        times = 0.16 * distance / max(max(np.hypot(*shift), abs(turn)) for _, _, shift, turn in parts)
        series = []
        for place, radius, shift, turn in parts:
            centre = np.array(place) + times * shift
            series += [("circle", "", tuple(np.atleast_1d(v) for v in (*at, radius, 0.0))) for at in (place, centre)]
            angle, spoke = np.arctan2(place[1], place[0]) + times * turn / radius, np.array([0.93 if radius == ring else 0.0, 1.0]) * radius
            series.append(line(centre[0] + spoke * np.cos(angle), centre[1] + spoke * np.sin(angle)))
        twice = ", pair" if mode["multiplicity"] == 2 else ""
        reach = 1.12 * ring + 0.16 * distance
        panels.append(Expected(*series, x_limits=(-reach, reach), y_limits=(-reach, reach), title=f"{mode['name']}: {mode['kind']}{twice}\n{number(mode['frequency_Hz'])} Hz"))
    return {"gear-modes": panels}


def gear_teeth(gears):
    pair, series = gears["tooth_pairs"][0], []
    reach = 2.6 * max(g["module_mm"] for g in pair["gears"])
    for g in pair["gears"]:
        def at(radius, angle_deg, g=g):
            a = np.radians(np.asarray(angle_deg, float))
            return radius * np.sin(a), g["centre_y_mm"] + g["sense"] * radius * np.cos(a)

        radius, half, pitch = np.array(g["radius_mm"]), np.array(g["half_angle_deg"]), 360 / g["teeth"]
        corners = [at(radius[0], [g["axis_deg"] - 1.5 * pitch]), at(radius[0], [g["axis_deg"] + 1.5 * pitch])]
        for n in (-1, 0, 1):
            middle = g["axis_deg"] + n * pitch
            corners += [at(radius, middle - half), at(np.full(9, radius[-1]), middle + np.linspace(-half[-1], half[-1], 9)), at(radius, middle + half)]
        corners.append(at(np.full(40, radius[0] - 3 * g["module_mm"]), np.linspace(g["axis_deg"] + 1.5 * pitch, g["axis_deg"] - 1.5 * pitch, 40)))
        series.append(("area", "", tuple(Q(np.concatenate([c[i] for c in corners]), "mm") for i in (0, 1))))
        turn = np.degrees(2 * reach / g["base_radius_mm"])
        series.append(line(*(Q(v, "mm") for v in at(g["base_radius_mm"], np.linspace(-turn, turn, 80)))))
    angle, along = np.radians(pair["working_pressure_angle_deg"]), np.array([-2 * reach, 2 * reach])
    series += [line(Q(along * np.cos(angle), "mm"), Q(along * np.sin(angle), "mm")), line(Q([pair["contact_x_mm"]], "mm"), Q([pair["contact_y_mm"]], "mm"))]
    return {"gear-teeth-1": [Expected(*series, title=f"{pair['mesh']}, working pressure angle {number(pair['working_pressure_angle_deg'], 4)}°",
                                      x_limits=(-1.25 * reach, 1.25 * reach), y_limits=(-reach, reach),
                                      x_label="across the line of centres (mm)", y_label="from the pitch point (mm)", texts=("sun", "planet"))]}


def mesh_stiffness(gears):
    left, parts = [], []
    for mesh in gears["meshes"]:
        curve, name = np.array(mesh["curve"]), mesh["name"].removesuffix(" 1")
        left += [line(np.append(curve[:, 0], 1.0), Q(np.append(curve[:, 1], curve[0, 1]), "N/m"), name), ("level", "", (Q(np.full(2, mesh["mean_N_per_m"]), "N/m"),))]
        point = mesh["at_pitch_point"]
        parts += [("contact", point["hertz_N_per_m"])]
        parts += [(f"{g['gear']}, {part}", g[f"{part}_N_per_m"]) for g in point["gears"] for part in ("bending", "shear", "axial", "foundation")]
    right = Expected(("bars", "", (np.arange(len(parts)), Q([1 / k for _, k in parts], "m/N"))), x_label="compliance at the pitch point (nm/N)")
    right.row_names = tuple(name for name, _ in parts)
    return {"gear-stiffness": [Expected(*left, x="", y_label="mesh stiffness (N/µm)", x_label="time since a pair came into contact (mesh period)"), right]}


def branches(content):
    runs = content["branches"]["runs"]
    keys = (("outer_load_rms_N", "rms load (N)"), ("outer_load_max_N", "largest load (N)"), ("cage_slip", "cage slip (%)"))
    up, down = (run["points"] for run in runs)
    apart = [p["input_speed_rpm"] for p, q in zip(up, down)
             if max(abs(p[k] - q[k]) / max(p[k], q[k]) for k in ("inner_load_rms_N", "outer_load_rms_N")) > content["branches"]["load_drift"]]
    marks = [("place", "states that differ" if n == 0 else "", (Q(np.full(2, speed), "rpm"),)) for n, speed in enumerate(apart)]
    return {"branches": [Expected(*(rows(run["points"], "input_speed_rpm", key, run["name"]) for run in runs), *marks, x="rpm", y_label=label)
                         for key, label in keys]}


def moving(content):
    """All pictures of a sweep in motion."""
    points, gears = content["points"], content["gears"]
    shown = (1000, 6500, 12000)
    peak = content["peak"]["refined_speed_rpm"]
    loads = (("outer_load_max_N", "outer race, largest"), ("inner_load_max_N", "inner race, largest"), ("outer_load_rms_N", "outer race, rms"),
             ("inner_load_rms_N", "inner race, rms"))
    parts = (("planet_load_N", "total (magnitude)"), ("tangential_load_N", "tangential, both meshes (y)"), ("radial_mesh_load_N", "radial, both meshes (x)"),
             ("centrifugal_load_N", "centrifugal (x)"))
    effects_of = content["ablation"]
    inertial = [e for e in effects_of if e["name"].startswith("no ")]
    bare = [p for p in points if p.get("status") != "ok"]
    meeting_lines = [("place", "", (Q(np.full(2, m["speed_rpm"]), "rpm"),)) for m in gears["meetings"] if m["excited"] and 0.7 * peak < m["speed_rpm"] < 1.3 * peak]
    found = {
        "life-range": [speed_axes(*life_lines(content), ("place", "point without a life", (named(bare, "input_speed_rpm"),)), y_label=LIFE)],
        "life-peak": [speed_axes(*life_lines(content), *meeting_lines, y_label=LIFE, title="near the peak, linear scale", texts=(" 2 × T1", " 1 × P1"),
                                 x_limits=(0.7 * peak, 1.3 * peak), y_limits=near_peak(content))],
        "life-campbell": campbell(gears, (1000, 12000)), "gear-campbell": campbell(gears),
        "planet-load": [speed_axes(*(rows(content["fine"], "speed_rpm", key, label) for key, label in parts),
                                   *(rows(points, "input_speed_rpm", key) for key, _ in parts), y_label="load on one bearing (N)")],
        **{f"polar-{n}": polar(entry) for n, entry in enumerate(content["polar"], 1)},
        "drawing": drawing(content),
        "ablation-inertia": ablations([effects_of[0], *inertial]),
        "ablation-clearance": ablations([effects_of[0], *(e for e in effects_of[1:] if e not in inertial)]),
        "roller-loads": [speed_axes(*(rows(points, "input_speed_rpm", key, label) for key, label in loads), y_label="contact load of one roller (N)",
                                    y_limits=(0.0, None))],
        "slip": [Expected(rows(points, "input_speed_rpm", "roller_slip"), x="rpm", y_label="slip of the rollers (%)"),
                 speed_axes(rows(points, "input_speed_rpm", "cage_slip"), y_label="slip of the cage (%)")],
        "power-loss-watts": losses(points, False), "power-loss-shares": losses(points, True),
        **{f"dynamic-polar-{n}": dynamic_polars(content, speed) for n, speed in enumerate(shown, 1)},
        **{f"cage-orbit-{n}": cage_orbit(content, speed) for n, speed in enumerate(shown, 1)},
        "slip-traces": slips_over_time(peak), "dynamic-ablation": effects(content),
        **branches(content), **gear_vibration(gears), **gear_shapes(gears), **gear_teeth(gears), **mesh_stiffness(gears)}
    one = of_first_roller(peak)
    inner, outer = (one.of(f"roller_{race}_load", "N") for race in ("inner", "outer"))
    most, last = max(inner.values.max(), outer.values.max()), 1e3 * one.time.values[-1]
    found["roller-history"] = [
        Expected(line(one.time, outer, "outer race"), line(one.time, inner, "inner race"), shade(one.time, one.zone, "load zone"), x="ms",
                 y_label="contact load (N)", x_limits=(0.0, last), y_limits=(0.0, 1.06 * most)),
        Expected(line(one.time, outer), line(one.time, inner), shade(one.time, one.zone, "load zone"), y_label="enlarged (N)", y_limits=(-0.0018 * most, 0.06 * most),
                 x_label=f"time at {number(peak)} rpm input speed (ms)")]
    found["roller-history-round"] = [Expected(line(one.angle, outer, "outer race"), line(one.angle, inner, "inner race"), x="rad", y="N",
                                              title=f"{number(peak)} rpm, load in N")]
    films, slides = ([line(one.angle, one.of(f"roller_{race}_{what}", unit), f"{race} race") for race in ("outer", "inner")]
                     for what, unit in (("film", "m"), ("sliding", "m/s")))
    found["roller-orbit"] = [Expected(*slides, shade(one.angle, one.zone, "load zone"), x="°", y_label="sliding speed (m/s)"),
                             Expected(*films, shade(one.angle, one.zone, "load zone"), x="°", y_label="least film (µm)", x_limits=(0.0, 360.0), y_limits=(0.0, None),
                                      x_label=f"place of the roller, at {number(peak)} rpm input speed")]
    return found


def coupled(content):
    """Besides those of a sweep in motion."""
    one, points = content["coupled"]["one_way"], content["points"]
    found = {"two-way": [speed_axes(rows(one, "speed_rpm", "life_h", "one way"), rows(points, "input_speed_rpm", "life_h", "two ways (co-simulated)"), y_label=LIFE)],
             "interface-energy": [speed_axes(rows(points, "input_speed_rpm", "interface_energy_residual"), y_label="energy residual / energy passed (%)", y_limits=(0.0, None))]}
    return found


def slip_maps(content):
    """Cells at the grid's places; each has its slip and, below it, its load as a text."""
    points, found = content["points"], {}
    speeds, powers = (sorted({p[key] for p in points}) for key in ("input_speed_rpm", "input.power_kW"))
    at = {(p["input_speed_rpm"], p["input.power_kW"]): p for p in points}
    few = len(points) <= 80
    for key, name in (("cage_slip", "cage"), ("roller_slip", "rollers")):
        places = np.arange(len(speeds)), np.arange(len(powers))
        grid = np.array([[at[s, p][key] for s in speeds] for p in powers])
        series = [("map", "", (*places, Q(grid, "1")))]
        if not few:
            series.append(("map", "", (*places, [[at[s, p]["planet_load_N"] for s in speeds] for p in powers])))
        texts = tuple(text for p in powers for s in speeds for text in (f"{100 * at[s, p][key]:.2g}", f"{at[s, p]['planet_load_N']:,.0f}")) if few else None
        cells = Expected(*series, x="", y="", z="%", texts=texts, x_label="input speed (rpm)", y_label="input.power (kW)")
        cells.column_names, cells.row_names = tuple(map(number, speeds)), tuple(map(number, powers))
        found[f"slip-map-{name}"] = [cells, Expected(y_label=f"slip of the {name} (%)")]
    return found


def spectrum(content):
    """Circles by time and colours by damage; bars of both, the most damaging first."""
    bins = content["spectrum"]["bins"][:-1]  # the last one rests
    size = np.array([b["share"] for b in bins])
    order = np.argsort(-size)
    picked = [bins[i] for i in order]
    circles = ("points", "", (named(picked, "speed_rpm"), named(picked, "torque_N_m"), 900.0 * size[order] / size.max(), named(picked, "damage_share")))
    worst = sorted(range(len(bins)), key=lambda i: -bins[i]["damage_share"])
    bars = Expected(*(("bars", label, (np.arange(4) + shift, Q([bins[i][key] for i in worst], "1"))) for label, key, shift in
                      (("time", "share", -0.2), ("damage", "damage_share", 0.2))), x_label="share (%)", y_label="bin, in the order of the spectrum")
    bars.row_names = tuple(str(i + 1) for i in worst)
    return {"load-spectrum-map": [speed_axes(circles, z="%", y_label="input torque (N m)"), Expected(y_label="share of the damage (%)")],
            "load-spectrum-bars": [bars]}


DROP = "drop of one roller at the outermost of 40 laminae (µm)"


def point(x, y, label="", x_unit="µm", y_unit="1"):
    return line(Q(np.atleast_1d(x), x_unit), Q(np.atleast_1d(y), y_unit), label)


def crown(content):
    study, figures = content["crown"], content["figures"]
    advice, computed = study["recommended"], study["tilt"] == "computed"
    straight, best = study["straight"], study["optimum"]
    marks = [point(0.0, advice["straight_life_share"], "straight rollers"), point(advice["drop_um"], 1.0, "recommended"),
             *(point(p["drop_um"], p["life_share"], "missed by one tolerance" if n == 0 else "") for n, p in enumerate(advice["missed"])),
             point(advice["by_laminae"]["drop_um"], advice["by_laminae"]["life_share"], "by laminae")]
    band = ("shade", f"at least {number(100 * advice['life_kept_in_band'])} % is left", (Q([advice["least_drop_um"], advice["most_drop_um"]], "µm"),))
    found = {"crown-drop": [Expected(rows(advice["curve"], "drop_um", "life_share"), *marks, band, x_label=DROP, y_label="life left (% of the longest)", y="%",
                                      x_limits=(0.0, max(p["drop_um"] for p in advice["curve"])), y_limits=(0.0, 105.0))]}

    by = figures["map"]
    drop, tilt, life = np.array(by["drop_um"]), np.array(by["tilt_mrad"]), np.array(by["governing_life_h"])
    ridge = []
    for column in np.log(life).T:  # the top of a parabola in ln life, where the middle drop is the best of the three
        i = int(column.argmax())
        fit = np.polyfit([-1.0, 0.0, 1.0], column, 2)
        ridge.append(drop[1] - fit[1] / (2 * fit[0]) * (drop[1] - drop[0]) if i == 1 else drop[i])
    wide, high = by["drop_tolerance_um"], by["tilt_tolerance_mrad"]
    tilts = [0.0] if computed else [0.0, 0.4]
    series = [("map", "", (drop, tilt, Q(life.T, "h"), Q(np.geomspace(life.min(), life.max(), 15), "h"))), point(ridge, tilt, "best drop at each tilt", "µm", "mrad"),
              point([best["drop_um"]] * len(tilts), tilts, "optimum by laminae" if computed else "optimum, at the tilts studied", "µm", "mrad")]
    if computed:
        series += [point(advice["drop_um"], 0.0, "recommended", "µm", "mrad"),
                   ("area", "its tolerances", (Q([max(advice["drop_um"] - wide, 0), advice["drop_um"] + wide], "µm"), Q([0.0, high], "mrad")))]
    else:
        middle = study["robust"]["drop_um"]
        series.append(("area", "best within the tolerances, with its band", (Q([middle - wide, middle + wide], "µm"), Q([0.0, 0.4 + high], "mrad"))))
    found["crown-map"] = [Expected(*series, z="h", x_label=DROP, y_label="inclination of the pin ahead (mrad)" if computed else "tilt of the bore on its pin (mrad)"),
                          Expected(y_label="L10mrh of one bearing (h)")]

    lines = [part for f in figures["fronts"] for part in
             (rows(f["points"], "peak_pressure_MPa", "governing_life_h", f["profile"]),
              rows([p for p in f["points"] if p["efficient"]], "peak_pressure_MPa", "governing_life_h"))]
    lines += [rows(straight, "peak_pressure_MPa", "governing_life_h", "straight"), rows(best, "peak_pressure_MPa", "governing_life_h", "optimum")]
    found["crown-front"] = [Expected(*lines, x_label="greatest peak pressure over the tilts (MPa)", y_label="shortest L10mrh over the tilts (h)")]

    outlines, radius, chief = [], figures["roller_diameter_mm"] / 2, figures["profiles"][:3]
    deepest = max(max(p["drop_um"][1:-1]) for p in chief)
    most = 0.1 * 2 * radius / (1e-3 * deepest)  # the deepest drop takes a tenth of the diameter, or a little less
    times = next(step * 10**power for power in (4, 3, 2, 1, 0) for step in (5, 2, 1) if step * 10**power <= most)
    for factor in (1, times):
        for n, p in enumerate(chief):
            edge = np.maximum(radius - 1e-3 * factor * np.array(p["drop_um"]), 0.0)
            heading = p["profile"] if factor == 1 else ""
            label = ("to scale (mm)" if factor == 1 else f"drop × {number(times)}") if n == 0 else None
            outlines.append(Expected(("band", "", (named(p, "x_mm"), Q(-edge, "mm"), Q(edge, "mm"))), x="mm", y="mm", title=heading, y_label=label,
                                     x_label="mm" if factor != 1 else None))
    found["crown-outlines"] = outlines
    for slug, those, heading in (("chief", chief, "compared in this study"), ("kinds", figures["profiles"][3:], "every kind at the recommended drop")):
        deep = max(max(p["drop_um"][3:-3]) for p in those)  # logarithms end far below
        found[f"crown-{slug}"] = [Expected(*(line(named(p, "x_mm"), named(p, "drop_um"), p["profile"]) for p in those), texts=(heading,), y_limits=(1.15 * deep, -0.03 * deep),
                                           x_label="place along the roller (mm)", y_label="drop of one roller (µm)")]
    top = 1.08 * max(c["peak_pressure_MPa"] for c in figures["pressure"])
    found["roller-pressure"] = [Expected(*(line(named(c, "x_mm"), named(c, "pressure_MPa"), c["profile"]) for c in figures["pressure"] if c["tilt_mrad"] == tilt),
                                         y="MPa", x_label="place along the roller (mm)", y_label="pressure at mid-width (MPa)" if tilt == 0 else "",
                                         y_limits=(0.0, top), title=f"tilt {tilt:g} mrad") for tilt in (0.0, 0.5)]
    # Steps of whole hundreds, a dozen at most below the greatest pressure but at the outermost elements; what carries nothing stays white.
    most = max(max(place["pressure_MPa"][2:-2]) for zone in figures["zone"] for place in zone["places"])
    step = 100.0 * np.ceil(most / 1200.0)
    levels = Q([1.0, *(step * n for n in range(1, int(np.ceil(most / step)) + 1))], "MPa")
    found["crown-zone"] = [Expected(("map", "", (Q([p["angle_deg"] for p in z["places"]], "deg"), named(z, "x_mm"),
                                                 Q(np.array([p["pressure_MPa"] for p in z["places"]]).T, "MPa"), levels)), x="degree", y="mm", z="MPa",
                                    title=f"{z['profile']}, tilt {z['tilt_mrad']:g} mrad", x_label="place around the pin (degree)" if n > 1 else "",
                                    y_label="along the roller (mm)" if n % 2 == 0 else "") for n, z in enumerate(figures["zone"])]
    found["crown-zone"].append(Expected(y_label="pressure (MPa)"))
    found["crown-speeds"] = [speed_axes(*(rows(one, "speed_rpm", "governing_life_h", one["profile"]) for one in figures["speeds"]), y_label="L10mrh of one bearing (h)", title="tilt 0 mrad")]
    return found


def scratch(content, values):
    study, orders = content["defect"], "orders" in content["defect"]
    brief = values["time"] <= 5 / study["shaft_Hz"]
    time = Q(values["time"][brief], "s")
    over_time = lambda name, unit: Q(values[name][brief], unit)  # noqa: E731
    x_label = "order of the shaft" if orders else "frequency (Hz)"
    along, key, per = (values["order"], "order", study["shaft_Hz"]) if orders else (values["frequency"], "frequency_Hz", 1.0)

    def lines(name, peaks, highest, lowest=None):
        kept = (along > 0) & (along <= highest / per)
        unit = "order" if orders else "Hz"
        marked = [p for p in study[peaks[orders]] if p[key] <= highest / per]
        return [Expected(line(Q(along[kept], unit), Q(values[name][kept], "m/s²")), *(line(Q([p[key]], unit), Q([p["amplitude"]], "m/s²")) for p in marked),
                         x="order" if orders else None, x_label=x_label, y_label="amplitude (m/s²)", texts=tuple(p["is"] for p in marked),
                         y_limits=(lowest * values[name][kept].max(), 3 * values[name][kept].max()) if lowest else ())]

    return {"defect-vibration": [Expected(line(time, Q(values["acceleration"][0][brief], "m/s²"), "along the load"),
                                          line(time, over_time("envelope", "m/s²"), "envelope in the band"), x_label="time (ms)", y_label="acceleration (m/s²)")],
            "defect-envelope": lines("envelope_spectrum", ("envelope_peaks", "orders"), 8 * study["inner_pass_Hz"]),
            "defect-spectrum": lines("acceleration_spectrum", ("spectrum_peaks", "spectrum_orders"), 2 * study["natural_frequency_Hz"], 1e-5),
            "defect-ball-deflection": [Expected(line(time, Q(np.maximum(values["ball_deflection"][brief], 0.0), "m")), x_label="time (ms)",
                                                y_label="deflection of both contacts (µm)")],
            "defect-ball-load": [Expected(line(time, over_time("ball_load", "N")), x_label="time (ms)", y_label="contact load (N)")]}


def balls(content, values):
    heat, time = content["balls"]["heat_W"], values["time"]
    late = time >= 0.8 * time[-1]
    causes = (("sliding", "sliding in the contacts"), ("differential_slip", "curved ellipses"), ("spin", "spin"), ("rolling", "rolling resistance"),
              ("contact_damping", "contact damping"), ("cage", "pockets and lands"), ("churning", "drag and churning"))
    bars = Expected(("bars", "", (np.arange(7), Q([heat[key] for key, _ in causes], "W"))), x_label="mean power lost (W)")
    bars.row_names = tuple(label for _, label in causes)
    over = lambda name, unit, label, kept=slice(None): [Expected(line(Q(time[kept], "s"), Q(values[name][kept], unit)), x_label="time (ms)", y_label=label)]  # noqa: E731
    return {"ball-slip": over("cage_slip", "1", "slip (%)"), "ball-impacts": over("pocket_load", "N", "largest load (N)"),
            "ball-load": over("first_ball_inner_load", "N", "load on the inner race (N)", late), "ball-heat": [bars],
            "ball-cage": [Expected(line(Q(values["cage_x"][late], "m"), Q(values["cage_y"][late], "m")), x_label="along the radial load (µm)", y_label="across it (µm)")]}


def pressure_map():
    """Both halves of a contact that is the same on both sides."""
    contact = {"profile": "arc", "tilt_mrad": 0.25, "x_mm": [0.0, 1.0, 2.5, 3.0, 4.0], "y_um": [0.0, 10.0, 25.0], "pressure_MPa": [made.some(3, 100.0, 900.0) for _ in range(5)]}
    half = np.array(contact["pressure_MPa"]).T
    top = 200.0 * np.ceil(half[:, 2:-2].max() / 200.0)  # what the outermost elements reach lies beyond the colours
    whole = ("map", "", (named(contact, "x_mm"), Q([-25.0, -10.0, 0.0, 10.0, 25.0], "µm"), Q(half[[2, 1, 0, 1, 2]], "MPa"),
                        Q([0.02 * top / 12, *(top / 12 * n for n in range(1, 13))], "MPa")))
    return contact, [Expected(whole, z="MPa", title="arc, tilt 0.25 mrad", x_label="place along the roller (mm)", y_label="across (µm)"), Expected(y_label="pressure (MPa)")]


def uncertain(result):
    data, rows_of = result.data, result.data["speeds"]
    speed = named(rows_of, "speed_rpm")
    of = lambda band, percent: Q([row[band]["percentiles"][percent] for row in rows_of], "h")  # noqa: E731
    inputs, single, both = "of_uncertain_inputs", "of_single_bearings_at_the_case", "of_both"
    samples = [row["dynamic_h"] for row in data["motion"]]
    series = [("band", f"inputs: {low} to {high} %", (speed, of(inputs, low), of(inputs, high))) for low, high in (("5", "95"), ("25", "75"))]
    series += [line(speed, of(inputs, "50"), "inputs: median"), line(speed, named(rows_of, "life_at_the_case_h"), "the case as it stands"),
               line(speed, of(single, "5"), "single bearings at the case: 5 and 95 %"), line(speed, of(single, "95")),
               line(speed, of(both, "5"), "inputs and bearings: 5 and 95 %"), line(speed, of(both, "95")),
               line(Q([data["operating_point"]["speed_rpm"]] * 2, "rpm"), Q(samples, "h"), "samples in motion")]
    found = {"life_band": [speed_axes(*series, y_label="system life (h)")], "peak": [], "indices": []}
    for values, label, key, unit in ((result.peak_speeds, "input speed of the peak (rpm)", "speed_at_the_case_rpm", "rpm"),
                                     (result.peak_lives, "system life at the peak (h)", "life_at_the_case_h", "h")):
        counts, edges = np.histogram(values, bins=8)  # the root of 80 samples
        low, high = np.percentile(values, [5, 95])
        found["peak"].append(Expected(("bars", "", ((edges[1:] + edges[:-1]) / 2, counts)), ("place", "5 and 95 %", (Q([low, low], unit),)), ("place", "", (Q([high, high], unit),)),
                                      ("place", "the case as it stands", (Q([data["peak"][key]] * 2, unit),)), x_label=label, y_label="curves"))
    of_results = ((f"life at {data['operating_point']['speed_rpm']:g} rpm", data["operating_point"]), ("speed of the peak", data["peak"]["speed_rpm"]),
                  ("life at the peak", data["peak"]["life_h"]))
    order = [row["inputs"] for row in sorted(of_results[0][1]["indices"], key=lambda row: row["total"])]
    for n, (title, one) in enumerate(of_results):
        by = {row["inputs"]: row for row in one["indices"]}
        series = []
        for shift, key in ((0.2, "first"), (-0.2, "total")):
            series += [("bars", key, (np.arange(2) + shift, [by[name][key] for name in order])),
                       ("segments", "", ([by[name][f"{key}_95"][0] for name in order], np.arange(2) + shift,
                                         [by[name][f"{key}_95"][1] for name in order], np.arange(2) + shift))]
        panel = Expected(*series, title=title, x_label="share of the variance")
        if n == 0:
            panel.row_names = tuple("\n".join(".".join(part.split(".")[-2:]) for part in name.split(" + ")) for name in order)
        found["indices"].append(panel)
    return found


# Columns of the data under a figure that are neither drawn nor in the result, by figure and head: tested in report_dynamic_test, counts, or times.
OF_THEIR_OWN = {"dynamic-polar": ("inner, quasi-static (N)", "outer, quasi-static (N)"), "roller-history": ("place (deg)",), "cage-orbit": ("time (ms)",),
                "power-loss": ("sum (W)",), "load-spectrum": ("bin",)}


def is_number(value):
    return isinstance(value, (int, float, np.number)) and not isinstance(value, bool)


def numbers_in(value, key=""):
    """All numbers of a result, however deep, each with its key."""
    if isinstance(value, np.ndarray):
        return [(key, one) for one in value.ravel().tolist()] if value.dtype.kind in "fi" else []
    if isinstance(value, dict):
        return [one for name, part in value.items() for one in numbers_in(part, str(name))]
    if isinstance(value, (list, tuple)):
        return [one for part in value for one in numbers_in(part, key)]
    return [(key, float(value))] if is_number(value) else []


# Words of a head whose numbers are those of a key with this word.
SAID = {word: rf"(?<![a-z]){word}(?![a-z])" for word in ("rms", "inner", "outer", "sun", "ring", "tangential", "radial")}


def faults_of_table(slug, table, of_result):
    """No two columns are the same, and heads name the keys that have their numbers."""
    keys, found, columns = {}, [], {}
    for key, number in of_result:
        for value in (number, 100 * number):  # shares in per cent
            keys.setdefault(f"{value:.5g}", set()).add(key)
    for head, cells in zip(table.head, zip(*table.rows)):
        values = tuple(f"{cell:.5g}" for cell in cells if is_number(cell) and np.isfinite(cell))
        if len(set(values)) < 2:
            continue
        if columns.setdefault(values, head) != head and slug != "slip-traces" and "orbit slip" not in head:  # those are made alike
            found.append(f"{slug}: {head} has the numbers of {columns[values]}")
        of_all = set.intersection(*(keys.get(value, set()) for value in values))
        named = [key for key in of_all if all((word in key.split("_")) == bool(re.search(said, head)) for word, said in SAID.items())]
        if of_all and not named:
            found.append(f"{slug}: {head} has the numbers of {of_all}")
    return found


def faults_of_data(block, of_result):
    """The data under a figure are those that it draws or that the result has."""
    drawn = [number for picture in block.pictures for panel in picture.panels for series in panel.series for column in series.columns
             for _, number in numbers_in(np.asarray(column))]
    known = {f"{number:.5g}" for number in [*drawn, *(number for _, number in of_result)] if np.isfinite(number)}
    found = []
    for head, cells in zip(block.data.head, zip(*block.data.rows)):
        values = {f"{cell:.5g}" for cell in cells if is_number(cell) and np.isfinite(cell)}
        if head not in OF_THEIR_OWN.get(block.slug, ()) and not known.issuperset(values):
            found.append(f"{block.slug}, {head}: {sorted(values - known)[:3]} is neither drawn nor in the result")
    return found


TEXTS = Path(__file__).with_name("figures_texts.txt")
seen = set()  # texts of this run, for --record


def texts_of(block):
    """A line for the caption of a figure and for each row of its table, heads included: what a reader finds in words and numbers beside the picture."""
    def cell(value):
        return f"{value:.4g}" if is_number(value) else str(value)
    rows = [block.summary.head, *block.summary.rows] if block.summary else []
    rows += [block.data.head] if block.data else []
    return [f"{block.slug}: {line}" for line in (block.caption or "", *(" | ".join(map(cell, row)) for row in rows)) if line]


def pictures_of(content, write=None, values=None):
    """Pictures by name, as the report draws them; `values` are the variables of the only point's file."""
    with tempfile.TemporaryDirectory() as folder:
        if write:
            with unittest.mock.patch.object(fixture, "GRID", [*fixture.GRID, 5500, 6500]):  # those that the sweep added have files, too
                write(folder, content, made.change)
            found = report.blocks_of(read_report(Path(folder)))
        else:
            with unittest.mock.patch("orbearing.point_file.read_only_point", lambda folder: PointFile(values or {})):
                found = report.blocks_of(Report(content, None))
    of_result = numbers_in(content) + numbers_in(values or {})
    wrong = [fault for block in found if block.data for fault in faults_of_data(block, of_result)]
    wrong += [fault for block in found for table in (block.data, block.summary) if table for fault in faults_of_table(block.slug, table, of_result)]
    texts = {text.replace("\n", " ") for block in found for text in texts_of(block)}
    seen.update(texts)
    wrong += sorted(texts.difference(TEXTS.read_text(encoding="utf-8").splitlines())) if "--record" not in sys.argv else []
    assert not wrong, wrong
    return {picture.name: picture.panels for block in found for picture in block.pictures}


def without_svg(figure, target, **more):
    """In place of the drawing itself, which takes longest and is not asked for here."""
    target.write("<svg></svg>")


@unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", without_svg)
class Figures(unittest.TestCase):
    def check(self, pictures, expected, others=False):
        """`others`: more pictures are drawn, which another test asks for."""
        if not others:
            self.assertEqual(sorted(set(pictures) - set(expected)), [], "drawn and not expected: every figure is to be covered")
        self.assertEqual(sorted(set(expected) - set(pictures)), [], "expected and not drawn")
        found = [fault for name in expected for fault in faults(name, pictures[name], expected[name])]
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_of_a_sweep_in_motion(self):
        content = made.moving()
        self.check(pictures_of(content, dynamic.write_results), moving(content))

    def test_of_gears_and_bearings_that_act_on_each_other(self):
        content = made.coupled()
        self.check(pictures_of(content), coupled(content), others=True)

    def test_of_slip_over_speed_and_power(self):
        for content in (made.powers(), made.fine_powers()):
            self.check(pictures_of(content), slip_maps(content), others=True)

    def test_of_a_load_spectrum(self):
        content = made.spectrum()
        self.check(pictures_of(content), spectrum(content), others=True)

    def test_of_a_crowning_study(self):
        for content in (made.crown(), made.computed_crown()):
            self.check(pictures_of(content), crown(content))

    def test_of_a_bearing_with_a_scratch(self):
        for content, values in (made.scratch(), made.run_up()):
            self.check(pictures_of(content, values=values), scratch(content, values))

    def test_of_a_ball_bearing_in_time(self):
        content, values = made.balls()
        self.check(pictures_of(content, values=values), balls(content, values))

    def test_of_pressure_over_a_contact(self):
        contact, expected = pressure_map()
        with style.context():
            block = roller_pressure.map_block([contact])
        self.check({picture.name: picture.panels for picture in block.pictures}, {"pressure-map": expected})

    def test_a_small_orbit_of_the_cage_is_ringed_and_enlarged(self):
        """The inset shows it again around the middle of its extent, a quarter wider than it is."""
        turn = np.linspace(0, 2 * np.pi, 50)
        x, y = 60.0 + 5.0 * np.cos(turn) + np.where(turn < 1, 3.0, 0.0), 50.0 + 8.0 * np.sin(turn)
        with style.context():
            panels = orbit_figure._draw((3000, None, np.array([x, y])), 100.0, "orbit").panels
        um = lambda *values: tuple(Q(np.atleast_1d(value), "µm") for value in values)  # noqa: E731
        mean, half = line(*um(y.mean(), x.mean())), max(x.max() - x.min(), y.max() - y.min()) / 2
        middle = (x.max() + x.min()) / 2, (y.max() + y.min()) / 2
        whole = Expected(("circle", "", um(0, 0, 100, 0)), line(*um(0, 0)), line(*um(y, x)), mean, title="3,000 rpm", x_limits=(115.0, -115.0), y_limits=(-115.0, 115.0))
        inset = Expected(line(*um(y, x)), line(*um(y[0], x[0])), line(*um(y.mean(), x.mean())), x="µm", y="µm",
                         x_limits=(middle[1] + 1.25 * half, middle[1] - 1.25 * half), y_limits=(middle[0] - 1.25 * half, middle[0] + 1.25 * half))
        self.assertEqual(faults("orbit", panels, [whole, inset]), [])

    def test_rollers_without_a_cage_have_the_slip_of_their_orbit(self):
        content = made.moving()
        for p in content["points"]:
            p["orbit_slip"], p["cage_slip"] = 0.001 + 1e-7 * p["input_speed_rpm"], None
        points, runs = content["points"], content["branches"]["runs"]
        for run in runs:
            for p in run["points"]:
                p["orbit_slip"], p["cage_slip"] = 0.002 + 1e-7 * p["input_speed_rpm"], None
        for run in content["dynamic"]["ablation"]:
            for p in run["points"]:
                p["orbit_slip"] = 3 * p["cage_slip"]
        drawn = pictures_of(content)
        self.assertEqual(faults("slip", drawn["slip"], [Expected(rows(points, "input_speed_rpm", "roller_slip"), x="rpm", y_label="slip of the rollers' spin (%)"),
                                                        speed_axes(rows(points, "input_speed_rpm", "orbit_slip"), y_label="slip of the rollers' orbit (%)")]), [])
        last = drawn["branches"][2]
        self.assertEqual((last.y_label, [np.round(one.columns[1][0], 6) for one in last.series if one.label in ("up", "down")]), ("orbit slip (%)", [0.21, 0.21]))
        effects_of = drawn["dynamic-ablation"][2]
        first = [run["points"][0]["orbit_slip"] for run in content["dynamic"]["ablation"]]
        self.assertEqual(effects_of.x_label, "orbit slip (%)")
        np.testing.assert_allclose(next(one for one in effects_of.series if one.label == "1,000 rpm").columns[1], 100 * np.array(first))

    def test_points_have_markers_while_they_can_be_told_apart(self):
        content = made.moving()
        many = {**content, "points": [{**content["points"][0], "input_speed_rpm": 1000.0 + 100.0 * i} for i in range(61)]}
        many["branches"] = {"load_drift": 0.002, "runs": [{"name": "up", "points": many["points"]}]}
        many["polar"] = [{**content["polar"][0], "angle_deg": np.linspace(0, 354, 61).tolist(), "inner_load_N": [1.0] * 61, "outer_load_N": [2.0] * 61}]
        for case, wanted in ((content, True), (many, False)):
            drawn = pictures_of(case)
            for name in ("roller-loads", "slip", "branches", "polar-1"):
                self.assertEqual({one.marked for panel in drawn[name] for one in panel.series if one.kind == "line"}, {wanted}, name)

    def test_the_height_of_a_picture_of_pressures_without_peaks(self):
        """The line contact's pressure has room above; without it, and without means of peaks, the greatest pressure stands in the picture."""
        curve = {"profile": "arc", "tilt_mrad": 0.0, "x_mm": [0.0, 1.0], "pressure_MPa": [100.0, 900.0]}
        for hertz, top in ((None, 1.08 * 900.0), (700.0, 1.6 * 700.0)):
            with style.context():
                panel = roller_pressure.block([curve], hertz).pictures[0].panels[0]
            self.assertAlmostEqual(panel.y_limits[1], top)
            self.assertEqual([one.columns[0][0] for one in panel.series if one.kind == "level"], [hertz] if hertz else [])

    def test_of_an_uncertain_life(self):
        from orbearing.uncertainties.figures import figures
        result = made.uncertainty()
        self.check({name: panels_of(figure) for name, figure in figures(result).items()}, uncertain(result))

    def test_of_the_elements_of_a_bearing_at_rest(self):
        """Bars by their angle from the line of the load, from -180 to 180 degrees; of a pair those of the first row, half of the numbers."""
        angles, loads = [200.0, 10.0, 100.0, 300.0], [0.0, 700.0, 40.0, 250.0]
        for kind, more, said in (("static", [], "by its angle from the line of the radial load"), ("pair", [11.0, 12.0, 13.0, 14.0], "of the first row under the preload")):
            block = static_loads.block(Report({kind: {"contact_loads_N": loads + more, "steps": {"element_angles_deg": angles}}}, None), kind)
            (bars,) = [one for one in block.pictures[0].panels[0].series if one.kind == "bars"]
            self.assertEqual([list(column) for column in bars.columns[:2]], [[-160.0, -60.0, 10.0, 100.0], [0.0, 250.0, 700.0, 40.0]])
            self.assertEqual([tuple(row) for row in block.data.rows], [(-160.0, 0.0), (-60.0, 250.0), (10.0, 700.0), (100.0, 40.0)])
            self.assertEqual(block.data.head, ("angle (deg)", "load (N)"))
            self.assertEqual(block.caption, f"Load of each rolling element on the inner race {said}. Largest load: 700 N. 3 of 4 elements carry load.")
        even = static_loads.block(Report({"static": {"contact_loads_N": loads}}, None))
        self.assertEqual([row[0] for row in even.data.rows], [-180.0, -90.0, 0.0, 90.0])

    def test_of_a_revolution_of_the_carrier(self):
        """A line for each bearing; over the face, of each kind of mesh the one with the largest load per width."""
        same = {"load_min_N": 1.0, "load_max_N": 2.0, "equivalent_load_N": 3.0, "tilt_max_mrad": 4.0}
        bearings = [{"planet": planet, "position_mm": place, **same, "L10h_h": life} for planet, place, life in
                    ((1, -50.0, 900.0), (1, 50.0, 700.0), (2, -50.0, 800.0))]
        meshes = [{"planet": planet, "with": wheel, "K_Hbeta": factor, "face_load_N_per_mm": load} for planet, wheel, factor, load in
                  ((1, "sun", 1.11, [30.0, 80.0, 10.0]), (2, "sun", 1.22, [40.0, 50.0, 60.0]),
                   (1, "ring", 1.33, [25.0, 35.0, 45.0]), (2, "ring", 1.44, [5.0, 20.0, 65.0]))]
        carrier = {"bearings": bearings, "meshes": meshes, "carrier_angle_deg": [0.0, 120.0, 240.0], "face_position_mm": [-20.0, 0.0, 20.0],
                   "bearing_loads_N": [[10.0, 20.0, 30.0], [11.0, 22.0, 33.0], [12.0, 24.0, 36.0]], "expected_load_N": 15.0, "largest_load_share": 2.4}
        with style.context():
            block = carrier_revolution.block(Report({"carrier": carrier, "peak": {"life_key": "L10h"}}, None))
        over = [line(Q([0.0, 120.0, 240.0, 360.0], "deg"), Q([*loads, loads[0]], "N"), f"planet {planet}, at {place} mm")
                for planet, place, loads in ((1, "−50", [10.0, 11.0, 12.0]), (1, "50", [20.0, 22.0, 24.0]), (2, "−50", [30.0, 33.0, 36.0]))]
        face = [line(Q(carrier["face_position_mm"], "mm"), most, name) for most, name in
                (([30.0, 80.0, 10.0], "sun, K_Hβ 1.11"), ([5.0, 20.0, 65.0], "ring, K_Hβ 1.44"))]
        expected = [Expected(*over, ("level", "torque shared evenly", (Q([15.0], "N"),)), x_label="angle of the carrier (deg)",
                             y_label="load of the bearing (N)", x_limits=(0.0, 360.0)),
                    Expected(*face, y="", x_label="position on the face (mm)", y_label="load per width (N/mm)")]
        found = faults("carrier", [panel for picture in block.pictures for panel in picture.panels], expected)
        self.assertEqual(found, [], "\n" + "\n".join(found))
        self.assertIn("Largest load of one bearing: 36 N, 2.4 times the expected load of 15 N (torque shared evenly). "
                      "Shortest L10h: 700 h, planet 1, at 50 mm.", block.caption)

    def test_names_of_modes_stand_at_the_ends_of_their_lines(self):
        """Of two lines with one name between both; a name is 3.2 % of the height above the one below it at least."""
        from matplotlib.figure import Figure
        ends = (("P1", [900.0, 1000.0]), ("R1", [1500.0, 1530.0]), ("P1", [1900.0, 2000.0]), ("T1", [100.0, 2500.0]), ("P2", [300.0, None]))
        axes = Figure().add_subplot()
        gear_modes._name_modes(axes, np.array([1.0, 2.0]), [{"name": name, "frequency_Hz": values} for name, values in ends], 3.0)
        self.assertEqual([(text.get_text(), text.xy[1]) for text in axes.texts], [("P1", 1.5), ("R1", 1.53), ("T1", 2.5)])
        for text, height in zip(axes.texts, (1.5, 1.5 + 0.032 * 3.0, 2.5)):
            self.assertAlmostEqual(text.xyann[1], height, 12)

    def test_time_of_an_orbit_begins_with_it(self):
        time, path = 0.75 + 1e-3 * np.arange(21), 1e-6 * np.array([np.arange(21.0), 2.0 + np.arange(21.0) ** 2])
        point = types.SimpleNamespace(problem="", get=lambda *names: (time, path) if names == ("time", "cage_position") else None)
        report_of_one = Report({"points": [{"input_speed_rpm": 500.0, "life_h": 10.0, "status": "ok"}]}, None)
        with unittest.mock.patch("orbearing.figures.cage_orbit.read_point", lambda *_: point):
            rows = orbit_figure.block(report_of_one).data.rows
        np.testing.assert_allclose(rows, [(500.0, 0.0, 0.0, 2.0), (500.0, 10.0, 10.0, 102.0), (500.0, 20.0, 20.0, 402.0)], atol=1e-9)


class Words(unittest.TestCase):
    """What results say of themselves in a line."""

    def test_speeds_that_are_shown_have_a_life(self):
        """Both ends of the sweep failed: the lowest and the highest speed are those with a life, and one without a speed has no place."""
        points = [{"input_speed_rpm": speed, "life_h": life, "status": "ok" if life else "failed"}
                  for speed, life in ((1000.0, None), (2000.0, 50.0), (3000.0, 90.0), (4000.0, 70.0), (5000.0, None), (None, 99.0))]
        shown = Report({"points": points, "peak": {"speed_rpm": 3000.0, "life_h": 90.0}}, None)
        self.assertEqual(shown.shown_speeds, [2000.0, 3000.0, 4000.0])
        self.assertEqual([point["input_speed_rpm"] for point in shown.failed_points], [1000.0, 5000.0])

    def test_an_uncertain_life_prints_its_band(self):
        from orbearing.uncertainties.result import UncertaintyResult
        result = made.uncertainty()
        point = result.data["operating_point"]
        low, high = (f"{point['of_uncertain_inputs']['percentiles'][percent]:,.0f}" for percent in ("5", "95"))
        self.assertNotEqual(low, high)
        self.assertEqual(UncertaintyResult.__repr__(types.SimpleNamespace(_data=result.data)), f"UncertaintyResult({result.data['case']}: {result.data['life']} at {point['speed_rpm']:g} rpm, 5 to 95 %: {low} to {high} h)")

    def test_a_study_names_its_best_variant(self):
        from orbearing.studies.pictures import headline
        from orbearing.studies.result import StudyResult

        def of(lives, over_speed=True):
            key = "peak_life_h" if over_speed else "life_h"
            variants = [{"bearing.width": 10.0 + i, "bearing.kind": f"kind {i}", key: life} for i, life in enumerate(lives)]
            parameters = [types.SimpleNamespace(path="bearing.width", unit="mm"), types.SimpleNamespace(path="bearing.kind", unit=""),
                          types.SimpleNamespace(path="input.speed", unit="rpm")]
            design = types.SimpleNamespace(parameters=parameters, variants=len(lives), dimensions=(("bearing.width", 2), ("input.speed", 3)))
            return types.SimpleNamespace(life_key="life_h", points=6, failed=2, missing=1, design=design, variants=lambda: variants,
                                         header={"case": "reducer", "fidelity": "quasi-static"})
        for over_speed in (True, False):
            self.assertEqual(headline(of([300.0, None, 900.0, 120.0], over_speed)), "Of 4 variants the longest life is 900 h (bearing.width 12 mm, bearing.kind kind 2), "
                             "the shortest 120 h.")
        self.assertEqual(headline(of([None, None])), "None of 6 points has a life.")
        self.assertEqual(StudyResult.__repr__(of([1.0])), "StudyResult(reducer, quasi-static: bearing.width 2 x input.speed 3 = 6 points, 2 failed, 1 not computed)")


if __name__ == "__main__":
    record = "--record" in sys.argv
    done = unittest.main(argv=[one for one in sys.argv if one != "--record"], exit=not record)
    if record and done.result.wasSuccessful():
        TEXTS.write_text("\n".join(sorted(seen)) + "\n", encoding="utf-8")
