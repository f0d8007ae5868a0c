#!/usr/bin/env python3
"""Each column of the reports' tables holds what its head says, in the unit that stands there.

Every table below a figure has to be expected here. Exit code 77 (skipped) where matplotlib or netCDF4 is missing.
"""

import contextlib
import html
import io
import re
import tempfile
import unittest
import unittest.mock
from pathlib import Path

import figures_fixture as made
import report_dynamic_fixture as dynamic
import report_fixture as fixture
from figures_test import Q, named, np, number, of_first_roller, rolling, unit_of, without_svg
from orbearing import ball_page, crown_page, defect_page, effects_table, page, report, style, summary
from orbearing.blocks import Table
from orbearing.figures import roller_pressure
from orbearing.point_file import PointFile
from orbearing.result_folder import Report, read_report
from orbearing.uncertainties import page as uncertain_page
from orbearing.uncertainties.__main__ import print_result

EVERY = 5  # one in so many instants stands in tables over time; of the cage's path one in ten


def column(records, key):
    return named([r for r in records], key) if not key.startswith(("=",)) else [r.get(key[1:]) for r in records]


def percent_change(value, reference):
    """As a text."""
    if value is None or reference is None:
        return "–"
    return f"× {number(value / reference, 3)}" if value / reference > 3 else f"{100 * (value / reference - 1):+.1f} %".replace("-", "−")


def faults(name, table, expected):
    """`expected`: head -> numbers with a unit, or cells."""
    if table is None:
        return [f"{name}: there is no table"]
    found = [] if list(table.head) == list(expected) else [f"{name}: heads {table.head} for {tuple(expected)}"]
    for place, (head, wanted) in enumerate(expected.items()):
        cells = [row[place] for row in table.rows]
        if isinstance(wanted, Q):
            unit = unit_of(head)
            numbers = np.ravel(wanted.given_in(unit) if unit else wanted.values)
            got = np.array([np.nan if cell is None or isinstance(cell, str) else cell for cell in cells], float)
            if len(got) != len(numbers) or not np.allclose(got, numbers, rtol=1e-6, atol=0.0051 if unit in ("%", "µm", "deg") else 1e-9, equal_nan=True):
                found.append(f"{name}: column {head!r} is {cells[:4]} for {numbers[:4].tolist()}")
        elif cells != list(wanted):
            found.append(f"{name}: column {head!r} is {cells[:4]} for {list(wanted)[:4]}")
    return found


def by_speed(points, *columns):
    return {"input speed (rpm)": column(points, "input_speed_rpm"), **{head: column(points, key) for head, key in columns}}


def moving(content):
    points, fine, gears = content["points"], content["fine"], content["gears"]
    peak = content["peak"]["refined_speed_rpm"]
    status = [f"{p['status']}, added" if p["refined"] else p["status"] for p in points]
    nearest = [f"2 × P1 at {p['resonance_speed_rpm']:,.0f} rpm" if "resonance_speed_rpm" in p else "" for p in points]
    causes = (("rolling", "rolling resistance"), ("pockets", "cage pockets"), ("drag", "oil drag"), ("guidance", "cage guidance"), ("neighbours", "between rollers"),
              ("outer_traction", "sliding, outer race"), ("inner_traction", "sliding, inner race"), ("race_damping", "contact damping"), ("support", "pin support"))
    watts = {label: [p.get(f"power_loss_{key}_W") or 0.0 for p in points] for key, label in causes}
    order = np.argsort([p["input_speed_rpm"] for p in points], kind="stable")
    in_order = [points[i] for i in order]
    parts = (("total (magnitude) (N)", "planet_load_N"), ("tangential, both meshes (y) (N)", "tangential_load_N"),
             ("radial, both meshes (x) (N)", "radial_mesh_load_N"), ("centrifugal (x) (N)", "centrifugal_load_N"))
    loads = (("outer race, largest (N)", "outer_load_max_N"), ("inner race, largest (N)", "inner_load_max_N"), ("outer race, rms (N)", "outer_load_rms_N"),
             ("inner race, rms (N)", "inner_load_rms_N"))
    drawn = content["drawing"]
    sizes = {"bore (mm)": "bore_mm", "inner raceway diameter (mm)": "inner_raceway_diameter_mm", "pitch diameter (mm)": "pitch_diameter_mm",
             "outer raceway diameter (mm)": "outer_raceway_diameter_mm", "outside diameter (mm)": "outside_mm", "number of rollers": "rollers",
             "roller diameter (mm)": "roller_diameter_mm", "cage inside diameter (mm)": "cage_inner_mm", "cage outside diameter (mm)": "cage_outer_mm",
             "diameter of the cage's guide land (mm)": "guide_land_mm", "radial clearance, diametral measure (µm)": "clearance_um"}
    ablation = content["ablation"]
    one = of_first_roller(peak)
    films, slides = ({race: one.of(f"roller_{race}_{what}", unit) for race in ("inner", "outer")} for what, unit in (("film", "m"), ("sliding", "m/s")))
    turned = np.argsort(one.angle.values, kind="stable")
    slip = lambda name, rolls: Q(1 - made.variable(peak, name) / rolling(peak, rolls), "1")  # noqa: E731
    up, down = (run["points"] for run in content["branches"]["runs"])
    gaps = [max(abs(p[k] - q[k]) / max(p[k], q[k]) for k in ("inner_load_rms_N", "outer_load_rms_N")) for p, q in zip(up, down)]
    orbits = [(speed, made.variable(speed, "time"), made.variable(speed, "cage_position")) for speed in (1000, 6500, 12000)]
    radius = 1e-3 * (drawn["guide_land_mm"] - drawn["cage_outer_mm"]) / 2
    effects = content["dynamic"]["ablation"]
    ran = [(run["name"], p, effects[0]["points"][i]) for i in range(3) for run in effects for p in [run["points"][i]]]
    half = Q([p for speed in (1000, 6500, 12000) for p in [speed] * len(orbits[0][1][::10])], "rpm")
    found = {
        "life.data": {**by_speed(points, ("life of one bearing (h)", "life_h"), ("life of all bearings (h)", "system_life_h")), "nearest resonance": nearest, "status": status},
        "planet-load.data": {"input speed (rpm)": named(fine, "speed_rpm"), **{head: named(fine, key) for head, key in parts}},
        "polar.data": {"input speed (rpm)": Q([e["speed_rpm"] for e in content["polar"] for _ in e["angle_deg"]], "rpm"),
                       **{head: Q(np.concatenate([e[key] for e in content["polar"]]), unit)
                          for head, key, unit in (("place (deg)", "angle_deg", "deg"), ("inner race (N)", "inner_load_N", "N"), ("outer race (N)", "outer_load_N", "N"))}},
        "drawing.data": {"place (deg)": named(drawn, "roller_angle_deg"), "inner race (N)": named(drawn, "inner_load_N"), "outer race (N)": named(drawn, "outer_load_N")},
        "drawing.summary": {"dimension": list(sizes), "value": [drawn.get(key) for key in sizes.values()]},
        "roller-loads.data": by_speed(points, *loads),
        "slip.data": by_speed(points, ("slip of the rollers (%)", "roller_slip"), ("slip of the cage (%)", "cage_slip")),
        "power-loss.data": {"input speed (rpm)": column(in_order, "input_speed_rpm"), **{f"{label} (W)": Q(np.array(values)[order], "W") for label, values in watts.items()},
                            "sum (W)": Q(np.sum(list(watts.values()), axis=0)[order], "W")},
        "roller-history.data": {"time (ms)": Q(one.time.values[::EVERY], "s"), "place (deg)": Q(one.angle.values[::EVERY], "rad"),
                                **{f"{race} race (N)": Q(one.of(f"roller_{race}_load", "N").values[::EVERY], "N") for race in ("inner", "outer")}},
        "roller-orbit.data": {"place (deg)": Q(one.angle.values[turned][::EVERY], "rad"),
                              **{f"{what}, {race} ({unit})": Q(values[race].values[turned][::EVERY], values[race].unit)
                                 for what, values, unit in (("sliding", slides, "m/s"), ("film", films, "µm")) for race in ("inner", "outer")}},
        "slip-traces.data": {"time (ms)": Q(one.time.values[::EVERY], "s"), "one roller (%)": Q(slip("roller_spin", "roller_spin").values[0, ::EVERY], "1"),
                             "mean of the rollers (%)": Q(slip("roller_spin", "roller_spin").values.mean(axis=0)[::EVERY], "1"),
                             "cage (%)": Q(slip("cage_speed", "cage").values[::EVERY], "1")},
        "cage-orbit.data": {"input speed (rpm)": half, "time (ms)": Q(np.concatenate([(t - t[0])[::10] for _, t, _ in orbits]), "s"),
                            "cage centre x (µm)": Q(np.concatenate([p[0, ::10] for *_, p in orbits]), "m"),
                            "cage centre y (µm)": Q(np.concatenate([p[1, ::10] for *_, p in orbits]), "m")},
        "cage-orbit.summary": {"input speed (rpm)": Q([1000, 6500, 12000], "rpm"),
                               "distance of the mean (µm)": Q(np.round([np.hypot(*(1e6 * p.mean(axis=1))) for *_, p in orbits], 1), "µm"),
                               "its direction (deg)": Q(np.round([np.degrees(np.arctan2(*p.mean(axis=1)[::-1])) % 360 for *_, p in orbits], 1), "deg"),
                               "farthest from the mean (µm)": Q(np.round([1e6 * np.hypot(*(p - p.mean(axis=1)[:, None])).max() for *_, p in orbits], 1), "µm"),
                               "farthest from the middle (µm)": Q(np.round([1e6 * np.hypot(*p).max() for *_, p in orbits], 1), "µm"),
                               "of the clearance (%)": Q(np.round([100 * np.hypot(*p).max() / radius for *_, p in orbits], 1), "%")},
        "branches.data": {"branch": ["up"] * 12 + ["down"] * 12,
                          **{key: ([p.get(key) for p in up + down]) for key in ("input_speed_rpm", "inner_load_rms_N", "outer_load_rms_N", "inner_load_max_N",
                                                                               "outer_load_max_N", "cage_slip", "orbit_slip", "roller_slip", "steady")}},
        "branches.summary": {"input speed (rpm)": column(up, "input_speed_rpm"), "rms load, outer race, up (N)": column(up, "outer_load_rms_N"),
                             "rms load, outer race, down (N)": column(down, "outer_load_rms_N"), "largest difference (%)": Q(gaps, "1"),
                             "cage slip, up (%)": column(up, "cage_slip"), "cage slip, down (%)": column(down, "cage_slip"),
                             "reading": ["two states" if gap > 0.002 else "one state" for gap in gaps]},
        "dynamic-ablation.summary": {"input speed (rpm)": [round(p["speed_rpm"], 3) for _, p, _ in ran], "what is computed": [name for name, *_ in ran],
                                     "life (h)": Q([p["life_h"] for _, p, _ in ran], "h"),
                                     "against all effects": ["reference" if p is base else percent_change(p["life_h"], base["life_h"]) for _, p, base in ran],
                                     "roller slip (%)": Q([p["roller_slip"] for _, p, _ in ran], "1"), "cage slip (%)": Q([p["cage_slip"] for _, p, _ in ran], "1"),
                                     "power loss (W)": Q([p["power_loss_W"] for _, p, _ in ran], "W"),
                                     "rms load, inner race (N)": [p.get("inner_load_rms_N") for _, p, _ in ran],
                                     "rms load, outer race (N)": Q([p["outer_load_rms_N"] for _, p, _ in ran], "N")},
        **dynamic_polar(content), **of_gears(gears)}
    for slug, kept in (("inertia", [e for e in ablation if e["name"].startswith("no ")]), ("clearance", [e for e in ablation[1:] if not e["name"].startswith("no ")])):
        all_of_them = [ablation[0], *kept]
        found[f"ablation-{slug}.summary"] = {
            "what is computed": [e["name"] for e in all_of_them], "peak at (rpm)": column(all_of_them, "peak_speed_rpm"),
            "life at its peak (h)": column(all_of_them, "peak_life_h"),
            "against all effects": ["reference", *(percent_change(e["peak_life_h"], ablation[0]["peak_life_h"]) for e in kept)]}
        found[f"ablation-{slug}.data"] = {"what is computed": [e["name"] for e in all_of_them for _ in e["speed_rpm"]],
                                          "input speed (rpm)": Q(np.concatenate([e["speed_rpm"] for e in all_of_them]), "rpm"),
                                          "life of one bearing (h)": Q(np.concatenate([e["life_h"] for e in all_of_them]), "h")}
    return found


def dynamic_polar(content):
    places, table = 2 * np.pi * np.arange(dynamic.PLACES) / dynamic.PLACES, []
    rows = []
    for speed in (1000, 6500, 12000):
        still = next((e for e in content["dynamic"]["quasi_static"]["polar"] if e["speed_rpm"] == speed), None)
        before = {race: np.interp(np.degrees(places), still["angle_deg"], still[f"{race}_load_N"], period=360.0) if still else np.full(len(places), np.nan)
                  for race in ("inner", "outer")}
        after = {race: made.variable(speed, f"{race}_load") for race in ("inner", "outer")}
        table.append([np.full(len(places), speed), np.degrees(places), before["inner"], before["outer"], after["inner"], after["outer"]])
        for race in ("outer", "inner"):
            most = max(still[f"{race}_load_N"]) if still else None
            gap = np.abs(after[race] - before[race])
            rows.append((speed, race, most, after[race].max(), percent_change(after[race].max(), most), gap.max() if still else None))
    heads = ("input speed (rpm)", "place (deg)", "inner, quasi-static (N)", "outer, quasi-static (N)", "inner, dynamic (N)", "outer, dynamic (N)")
    columns = np.concatenate(table, axis=1)
    short = ("input speed (rpm)", "race", "largest, quasi-static (N)", "largest mean, dynamic (N)", "change", "largest difference at a place (N)")
    of_rows = list(zip(*rows))
    numbers = {2: "N", 3: "N"}
    return {"dynamic-polar.data": {head: Q(values, unit) for head, values, unit in zip(heads, columns, ("rpm", "deg", "N", "N", "N", "N"))},
            "dynamic-polar.summary": {head: Q(of_rows[i], numbers[i]) if i in numbers else [round(v, 2) if i == 5 and v is not None else v for v in of_rows[i]]
                                      for i, head in enumerate(short)}}


def of_gears(gears):
    pair, content, runs, spectrum = gears["tooth_pairs"][0], gears["campbell"], gears["runs"], gears["spectrum"]
    parts = []
    for mesh in gears["meshes"]:
        point, name = mesh["at_pitch_point"], mesh["name"].removesuffix(" 1")
        whole = point["pair_N_per_m"]
        rows = [("contact", point["hertz_N_per_m"])]
        rows += [(f"{g['gear']}, {part}", g[f"{part}_N_per_m"]) for g in point["gears"] for part in ("bending", "shear", "axial", "foundation")]
        parts += [(name, what, k, whole / k) for what, k in rows] + [(name, "one pair of teeth", whole, 1.0)]
    mesh, what, stiffness, share = zip(*parts)
    lines = [(order, amplitude) for order, amplitude in zip(spectrum["order"], spectrum["amplitude_N"]) if order == round(order)]
    meetings = [("P1", 1, 6730.0, 1283.0), ("T1", 2, 5350.0, 940.0)]
    found = {
        "gear-teeth.summary": {"gear": ["sun", "planet"], "mesh": ["sun and planet"] * 2, "teeth": [31, 39], "module (mm)": column(pair["gears"], "module_mm"),
                               "base radius (mm)": column(pair["gears"], "base_radius_mm"), "root radius (mm)": Q([g["radius_mm"][0] for g in pair["gears"]], "mm"),
                               "tip radius (mm)": Q([g["radius_mm"][-1] for g in pair["gears"]], "mm"),
                               "working pressure angle (deg)": Q([pair["working_pressure_angle_deg"]] * 2, "deg")},
        "gear-stiffness.summary": {"mesh": mesh, "part at the pitch point": what, "stiffness (N/µm)": Q(stiffness, "N/m"), "share of the compliance (%)": Q(share, "1")},
        "gear-stiffness.data": {"mesh period": [p[0] for p in gears["meshes"][0]["curve"]],
                                **{f"{m['name'].removesuffix(' 1')} (N/µm)": Q([p[1] for p in m["curve"]], "N/m") for m in gears["meshes"]}},
        "gear-modes.summary": {"mode": ["R1", "T1", "P1"], "kind": ["rotational", "translational", "planet"],
                               "frequency (Hz)": column(gears["mode_shapes"]["modes"], "frequency_Hz"), "multiplicity": [1, 2, 1]},
        "gear-campbell.data": {"input speed (rpm)": named(content, "speed_rpm"), "mesh frequency (Hz)": named(content, "mesh_frequency_Hz"),
                               **{f"{m['name']} (Hz)": named(m, "frequency_Hz") for m in content["modes"]}},
        "gear-acceleration.summary": {"mesh harmonic": [m[1] for m in meetings], "mode": [m[0] for m in meetings], "input speed (rpm)": Q([m[2] for m in meetings], "rpm"),
                                      "frequency (Hz)": Q([m[3] for m in meetings], "Hz")},
        "gear-acceleration.data": {"input speed (rpm)": column(runs, "speed_rpm"),
                                   **{f"{way}, {key} (m/s²)": Q([run["acceleration_m_per_s2"][way][key] for run in runs], "m/s²")
                                      for way in "xy" for key in ("rms", "max")}},
        "gear-spectrum.summary": {"mesh order": [order for order, _ in lines], "frequency (Hz)": Q([order * spectrum["mesh_frequency_Hz"] for order, _ in lines], "Hz"),
                                  "amplitude (N)": Q([amplitude for _, amplitude in lines], "N")},
        "gear-sharing.data": {"input speed (rpm)": column(runs, "speed_rpm"),
                              **{f"planet {n + 1}, {key}": [run["load_sharing"][key][n] for run in runs] for key in ("mean", "largest") for n in range(3)}}}
    return found


def coupled(content):
    one, points = content["coupled"]["one_way"], content["points"]
    known = dict(zip(one["speed_rpm"], one["life_h"]))
    before = [known.get(p["input_speed_rpm"]) for p in points]
    return {"two-way.summary": {**by_speed(points), "life, one way (h)": Q(before, "h"), "life, two ways (h)": column(points, "life_h"),
                                "change": [percent_change(p["life_h"], b) for p, b in zip(points, before)]},
            "interface-energy.data": {**by_speed(points), "energy residual / energy passed": column(points, "interface_energy_residual")}}


def slip_map(content):
    points = content["points"]
    rows = []
    speeds, powers = (sorted({p[key] for p in points}) for key in ("input_speed_rpm", "input.power_kW"))
    at = {(p["input_speed_rpm"], p["input.power_kW"]): p for p in points}
    for key, name in (("cage_slip", "cage"), ("roller_slip", "rollers")):
        grid = np.array([[at[s, p][key] for s in speeds] for p in powers])
        for axis, what in ((1, "input speed"), (0, "input.power (kW)")):
            steps = np.diff(grid, axis=axis)
            rows.append((f"slip of the {name}", what, f"{(steps > 0).sum()} of {steps.size} steps"))
    keys = ("input_speed_rpm", "input.power_kW", "planet_load_N", "cage_slip", "orbit_slip", "roller_slip", "status")
    return {"slip-map.summary": dict(zip(("quantity", "as this grows", "it rises in"), zip(*rows))),
            "slip-map.data": {key: [p.get(key) for p in points] for key in keys}}


def spectrum(content):
    bins = content["spectrum"]["bins"][:4]
    return {"load-spectrum.data": {"bin": [1.0, 2.0, 3.0, 4.0], "speed (rpm)": column(bins, "speed_rpm"), "torque (N m)": column(bins, "torque_N_m"),
                                   "share of time": column(bins, "share"), "share of damage": column(bins, "damage_share"),
                                   "life_h at this bin alone (h)": column(bins, "life_h")}}


def crown(content):
    study, figures = content["crown"], content["figures"]
    advice = study["recommended"]
    marks = [("recommended", advice["drop_um"], 1.0), ("straight rollers", 0.0, advice["straight_life_share"]),
             *(("missed by one tolerance", p["drop_um"], p["life_share"]) for p in advice["missed"]), ("by laminae", *advice["by_laminae"].values())]
    ends = [(name, study[key]) for name, key in (("straight", "straight"), ("ISO/TS 16281, as in the standard", "reference"), ("optimum by laminae", "optimum"),
                                                ("best within the tolerances, by laminae", "robust"), ("recommended, by half-space pressures", "recommended"))]
    own = [one for _, one in ends]
    curves, fronts, lines = figures["pressure"], figures["fronts"], figures["speeds"]
    worst = [(z["profile"], f"tilt {z['tilt_mrad']:g} mrad", max(max(p["pressure_MPa"][2:-2]) for p in z["places"])) for z in figures["zone"]]
    flat = lambda group, key, inner: np.concatenate([one[inner] if inner == key else [one[key]] * len(one[inner]) for one in group])  # noqa: E731
    return {
        "crown-drop.summary": {"rollers": [m[0] for m in marks], "drop (µm)": Q([m[1] for m in marks], "µm"), "life left (%)": Q([m[2] for m in marks], "1")},
        "crown-drop.data": {"drop (µm)": column(advice["curve"], "drop_um"), "life left (%)": column(advice["curve"], "life_share")},
        "crown-map.summary": {"rollers": [name for name, _ in ends], "profile": [one["profile"] for one in own], "drop (µm)": column(own, "drop_um"),
                              "shortest L10mrh over the tilts (h)": column(own, "governing_life_h"),
                              "times straight": Q([one["governing_life_h"] / own[0]["governing_life_h"] for one in own], "1"),
                              "L10mrh without tilt (h)": column(own, "untilted_governing_life_h"), "greatest peak pressure (MPa)": column(own, "peak_pressure_MPa"),
                              "edge ratio there": [one["edge_ratio"] for one in own], "shortest life from half-space pressures (h)": column(own, "half_space_life_h"),
                              "shortest L10mrh within the tolerances (h)": Q([one["governing_life_in_band_h"] for one in own], "h")},
        "crown-front.data": {"profile": [f["profile"] for f in fronts for _ in f["points"]],
                             **{head: Q([p[key] for f in fronts for p in f["points"]], unit)
                                for head, key, unit in (("drop (µm)", "drop_um", "µm"), ("shortest L10mrh (h)", "governing_life_h", "h"), ("greatest peak pressure (MPa)", "peak_pressure_MPa", "MPa"))},
                             "on the front": ["yes" if p["efficient"] else "" for f in fronts for p in f["points"]]},
        "roller-pressure.summary": {"profile": [c["profile"] for c in curves], "tilt (mrad)": column(curves, "tilt_mrad"), "peak pressure (MPa)": column(curves, "peak_pressure_MPa"),
                                    "edge ratio": [c["edge_ratio"] for c in curves]},
        "roller-pressure.data": {"profile": [c["profile"] for c in curves for _ in c["x_mm"]], "tilt (mrad)": Q([c["tilt_mrad"] for c in curves for _ in c["x_mm"]], "mrad"),
                                 "place (mm)": Q(flat(curves, "x_mm", "x_mm"), "mm"), "pressure (MPa)": Q(flat(curves, "pressure_MPa", "pressure_MPa"), "MPa")},
        "crown-zone.summary": dict(zip(("profile", "at", "greatest pressure but at the outermost elements (MPa)"), zip(*worst))),
        "crown-speeds.data": {"profile": [one["profile"] for one in lines for _ in one["governing_life_h"]], "tilt (mrad)": Q([0.0] * 6, "mrad"),
                              "input speed (rpm)": Q(flat(lines, "speed_rpm", "speed_rpm"), "rpm"), "L10mrh (h)": Q(flat(lines, "governing_life_h", "governing_life_h"), "h")}}


def scratch(content):
    found = {}
    for slug, key in (("envelope", "envelope_peaks"), ("spectrum", "spectrum_peaks")):
        peaks = content["defect"][key]
        found[f"defect-{slug}.data"] = {"frequency (Hz)": column(peaks, "frequency_Hz"), "amplitude (m/s²)": [p["amplitude"] for p in peaks], "is": [p["is"] for p in peaks]}
    return found


def balls(content):
    causes = (("sliding", "sliding in the contacts"), ("differential_slip", "curved ellipses"), ("spin", "spin"), ("rolling", "rolling resistance"),
              ("contact_damping", "contact damping"), ("cage", "pockets and lands"), ("churning", "drag and churning"))
    return {"ball-heat.data": {"cause": [label for _, label in causes], "power (W)": Q([content["balls"]["heat_W"][key] for key, _ in causes], "W")}}


def governed_by(content, key):
    """The same results of a case whose governing life is `key`, which has the values of life_h; life_h is 1 h throughout."""
    def renamed(value):
        if isinstance(value, list):
            return [renamed(one) for one in value]
        if not isinstance(value, dict):
            return value
        found = {name.replace("life_h", key) if name in ("life_h", "system_life_h") else name: renamed(one) for name, one in value.items()}
        return {**found, "life_h": [1.0] * len(found[key]) if isinstance(found[key], list) else 1.0} if key in found else found

    kept = {name: content[name] for name in ("published",)}
    made_so = {**renamed(content), **kept, "peak": {**content["peak"], "life_key": key}}
    for entry in [*made_so["ablation"], *made_so["dynamic"]["ablation"]]:
        entry["life_key"] = key
    return made_so


def tables_of(content, write=None, values=None):
    """Tables by the figure's name and where they stand."""
    with tempfile.TemporaryDirectory() as folder:
        if write:
            with unittest.mock.patch.object(fixture, "GRID", [*fixture.GRID, 5500, 6500]):
                write(folder, content, made.change)
            blocks = report.blocks_of(read_report(Path(folder)))
        else:
            with unittest.mock.patch("orbearing.point_file.read_only_point", lambda folder: PointFile(values or {})):
                blocks = report.blocks_of(Report(content, None))
    return {f"{block.slug}.{place}": getattr(block, place) for block in blocks for place in ("summary", "data") if getattr(block, place)}


@unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", without_svg)
class BelowFigures(unittest.TestCase):
    def check(self, tables, expected, others=False):
        if not others:
            self.assertEqual(sorted(set(tables) - set(expected)), [], "tables that no test expects")
        found = [fault for name in expected for fault in faults(name, tables.get(name), expected[name])]
        self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_of_a_sweep_in_motion(self):
        content = made.moving()
        self.check(tables_of(content, dynamic.write_results), moving(content))

    def test_of_gears_and_bearings_that_act_on_each_other(self):
        content = made.coupled()
        self.check(tables_of(content), coupled(content), others=True)

    def test_of_another_governing_life(self):
        """The same numbers under the key of that life give the same tables under its name, whatever life_h is."""
        for content in (made.moving(), made.coupled()):
            before, after = tables_of(content), tables_of(governed_by(content, "L10mrh"))
            self.assertEqual(list(after), list(before))
            for name, table in before.items():
                self.assertEqual(after[name].head, tuple(re.sub(r"\blife\b", "L10mrh", head) for head in table.head))
                self.assertEqual(repr(after[name].rows), repr(table.rows), name)
        self.assertIn("ablation-inertia.summary", before)
        self.assertIn("two-way.summary", before)

    def test_of_slip_over_speed_and_power_and_of_a_spectrum(self):
        content = made.powers()
        self.check(tables_of(content), slip_map(content), others=True)
        content = made.spectrum()
        self.check(tables_of(content), spectrum(content), others=True)

    def test_of_single_bearings_and_crowns(self):
        content = made.crown()
        self.check(tables_of(content), crown(content))
        content, values = made.scratch()
        self.check(tables_of(content, values=values), scratch(content))
        content, values = made.balls()
        self.check(tables_of(content, values=values), balls(content))


@unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", without_svg)
class Captions(unittest.TestCase):
    """Numbers in the sentences below the figures."""

    def captions(self, content, values=None):
        with unittest.mock.patch("orbearing.point_file.read_only_point", lambda folder: PointFile(values or {})):
            return {block.slug: block.caption for block in report.blocks_of(Report(content, None))}

    def test_of_a_sweep_in_motion(self):
        content = made.moving()
        found = self.captions(content)
        fine, spectrum_of = content["fine"], content["gears"]["spectrum"]
        least = int(np.argmin(fine["planet_load_N"]))
        self.assertIn(f": here {number(fine['planet_load_N'][least], 4)} N at {number(fine['speed_rpm'][least], 4)} rpm.", found["planet-load"])
        self.assertEqual("Life peaks at a lower speed, 6,500 rpm" in found["planet-load"], fine["speed_rpm"][least] > 6500)
        self.assertIn(f"{sum(p['life_h'] is None for p in content['points'])} point(s) gave no life", found["life"])
        self.assertIn("quasi-static at 6,000 rpm", found["drawing"])
        self.assertIn("The clearance is zero", found["drawing"])
        content["drawing"]["clearance_um"] = 12.5
        self.assertIn("The clearance of 12.5 µm", self.captions(content)["drawing"])
        self.assertIn(f"at 4,000 rpm, the middle speed of the sweep; its mean is {number(spectrum_of['mean_N'], 4)} N", found["gear-spectrum"])
        self.assertIn("orders of the mesh frequency, 1,240 Hz", found["gear-spectrum"])

    def test_of_gears_and_bearings_that_act_on_each_other(self):
        content = made.coupled()
        one = content["coupled"]["one_way"]
        known = dict(zip(one["speed_rpm"], one["life_h"]))
        changes = {p["input_speed_rpm"]: p["life_h"] / known[p["input_speed_rpm"]] - 1 for p in content["points"] if p["life_h"] and p["input_speed_rpm"] in known}
        speed = max(changes, key=lambda key: abs(changes[key]))
        found = self.captions(content)
        self.assertIn(f"at {number(speed)} rpm: {number(100 * abs(changes[speed]), 3)} % {'longer' if changes[speed] > 0 else 'shorter'} than one way. "
                      "Points of this sweep: degree 1.", found["two-way"])

    def test_of_a_load_spectrum(self):
        content = made.spectrum()
        bins = content["spectrum"]["bins"][:4]
        worst = max(range(4), key=lambda i: bins[i]["damage_share"])
        self.assertIn(f"By life_h one bearing reaches 23,456 h under the spectrum, all together 3,456 h; bin {worst + 1} takes "
                      f"{number(100 * bins[worst]['share'], 3)} % of the time and {number(100 * bins[worst]['damage_share'], 3)} % of the life.",
                      self.captions(content)["load-spectrum"])

    def test_of_single_bearings(self):
        content, values = made.scratch()
        self.assertIn("between 900 and 1,300 Hz", self.captions(content, values)["defect-envelope"])


class OfPages(unittest.TestCase):
    """Tables and sentences beside the figures."""

    def table(self, found, expected):
        self.assertEqual(faults("table", found, expected), [])

    def text_table(self, text):
        """Rows of cells of the tables in a piece of a page, heads first."""
        cells = [[html.unescape(re.sub("<[^>]*>", "", cell)) for cell in re.findall(r"<t[hd][^>]*>.*?</t[hd]>", row)] for row in re.findall(r"<tr>.*?</tr>", text)]
        return [row for row in cells if row]

    def test_summary_of_a_sweep(self):
        content = made.moving()
        life = content["points"][5]["life_h"]
        content["published"][0] |= {"ours_h": life, "ours_by": "point of the sweep"}
        found = dict(summary.summary_table(Report(content)).rows)
        self.assertEqual(found["Points of the sweep"], "14, of which 1 without a life; 2 of them added around the peak")
        self.assertEqual(found["Peak of the grid"], f"6,000 rpm, {number(content['peak']['life_h'])} h")
        self.assertEqual(found["Peak of all points"], "6,500 rpm, 61,234 h")
        self.assertEqual(found["Published, [Gai2025]"],
                         f"6,000 rpm, 43,869 h; ours there {number(life)} h, {percent_change(life, 43869)} (point of the sweep)")
        fine = content["fine"]
        least = int(np.argmin(fine["planet_load_N"]))
        self.assertEqual(found["Least planet load"], f"{number(fine['planet_load_N'][least], 4)} N at {number(fine['speed_rpm'][least], 4)} rpm (one bearing, quasi-static)")
        self.assertIn("at 6,500 rpm input speed: 61,234 hours", summary.headline(Report(content)))

    def test_summary_of_what_is_missing_or_changed(self):
        """Nothing is interpolated, a part is told as one, a changed case is not compared."""
        content = made.moving()
        content["published"][0]["speed_rpm"] = 1500.0
        found = dict(summary.summary_table(Report(content)).rows)
        self.assertEqual(found["Published, [Gai2025]"], "1,500 rpm, 43,869 h; ours there is not computed: the sweep has no point at that speed")
        self.assertNotIn("Missing", found)
        content["missing"] = {"of": 20, "found": 14, "shard": "1/2", "points": ["input.speed = 1 rpm"], "peak_unfinished": False, "text": "six are missing"}
        self.assertEqual(dict(summary.summary_table(Report(content)).rows)["Missing"], "Six are missing")
        self.assertIn("Incomplete sweep, 14 of 20 points, shard 1/2: the longest life of these points is 61,234 hours", summary.headline(Report(content)))
        content["missing"] |= {"points": [], "peak_unfinished": True}
        self.assertIn("Peak not yet refined: the longest life of the points so far is 61,234 hours", summary.headline(Report(content)))
        content |= {"missing": None, "published": [], "changed_inputs": ["input.power: 75 kW (published: 150 kW)"]}
        found = dict(summary.summary_table(Report(content)).rows)
        self.assertIn("input.power: 75 kW (published: 150 kW)", found["Published numbers"])
        self.assertIn("<li>input.power: 75 kW (published: 150 kW)</li>", page._validation(Report(content)))

    def test_assumptions_validation_and_what_assumptions_are_worth(self):
        content = fixture.make_report()
        content["validation"] = [{"source": "[A]", "quantity": "load (N)", "published": 100.0, "ours": 103.0, "deviation": 0.03, "tolerance": 0.05, "verdict": "reproduced", "of_sweep": 99.0}]
        content["sensitivities"] = [{"assumption": "film", "reading": "thin", "peak_speed_rpm": 5555.0, "peak_life_h": 40000.0, "worth_h": -2000.0}]
        content["assumptions"] = [{"key": "a.b", "value": "1 mm", "reason": "why", "worth_h": 1234.0, "worth_text": "thicker"}]
        still, moving_one = Report(content), Report({**content, "fidelity": "dynamic"})
        self.assertEqual(self.text_table(page._validation(still)), [["source", "quantity", "published", "quasi-static", "deviation", "tolerance", "verdict"],
                                                                   ["[A]", "load (N)", "100", "103", "+3.0 %", "5.0 %", "reproduced"]])
        self.assertEqual(self.text_table(page._validation(moving_one))[1][-1], "99")
        text = page._sensitivities(still)
        self.assertEqual(self.text_table(text), [["assumption", "other reading", "peak (rpm)", "life at the peak (h)", "effect"], ["film", "thin", "5,555", "40,000", "−2,000 h"]])
        self.assertIn("speed, 42,000 h as the case stands", text)
        partial = [{"assumption": "oil", "reading": "none", "worth_h": 77.0}, {"assumption": "cage", "peak_life_h": 88.0}]
        content["sensitivities"] = [*partial, *content["sensitivities"]]
        self.assertIn("speed, 42,000 h as the case stands", page._sensitivities(Report(content)), "what the first row that has both numbers says")
        self.assertEqual(self.text_table(page._assumptions(still)), [["assumed", "value", "reason", "effect"], ["a.b", "1 mm", "why", "+1,234 h: thicker"]])
        content["points"][2].update(life_h=None, status="jams")
        self.assertEqual(self.text_table(page._failed(still)), [["input speed (rpm)", "reason"], ["3,000", "jams"]])

    def test_ball_bearing(self):
        content, _ = made.balls()
        study = content["balls"]
        heat = study["heat_W"]["total"]
        self.assertEqual(ball_page.headline(Report(study)), f"The bearing lives 12,345 h and gives off {number(heat, 3)} W; its cage slips 2.3 %.")
        rows = dict(ball_page._summary(Report(study)).rows)
        for name in ("inner", "outer"):
            race = study[name]
            self.assertEqual(rows[f"{name.capitalize()} race"],
                             f"{number(race['load_rms_N'], 4)} N rms, at most {number(race['load_max_N'], 4)} N; contact angle {number(race['contact_angle_deg'], 3)} °; "
                             f"film {number(race['central_film_um'], 3)} µm; life {number(race['life_Mrev'], 4)} Mrev")
        self.assertEqual(rows["Cage"], "1,234 rpm; slip settled after 0.0456 s")
        self.assertEqual((rows["Largest load of a ball on the cage"], rows["Friction torque"]), ("67.8 N", "91.2 N mm"))

    def test_scratch(self):
        study = made.scratch()[0]["defect"]
        rows = dict(defect_page._summary(Report(study)).rows)
        self.assertEqual(rows["Shaft, cage"], "25 Hz, 9.9 Hz")
        self.assertEqual([rows[f"Balls over a place of the {race} race"] for race in ("outer", "inner")], ["89 Hz", "136 Hz"])
        self.assertEqual(rows["A place of a ball over either race"], "116 Hz")
        self.assertEqual(rows["Outer ring at rest"], "4.56 µm along the load; it would vibrate at 1,100 Hz")
        self.assertEqual(rows["Acceleration of the outer ring"], "12.3 m/s² rms, at most 45.6 m/s²")
        self.assertEqual(rows["Largest contact load"], "1,234 N; at rest 812 N")
        self.assertEqual(rows["Band of the envelope"], "900 to 1,300 Hz, spectral kurtosis 3.21")
        first = study["envelope_peaks"][0]
        self.assertEqual(defect_page.headline(Report(study)), f"The strongest line of the envelope stands at {number(first['frequency_Hz'], 4)} Hz: line 0.")
        turning = made.run_up()[0]["defect"]
        self.assertIn(f"stands at {number(turning['orders'][0]['order'], 4)} turns of the shaft", defect_page.headline(Report(turning)))

    def test_crown(self):
        study = made.crown()["crown"]
        advice, best, straight = study["recommended"], study["optimum"], study["straight"]
        study["spectrum"] = [{"input_speed_rpm": 1500.0}, {"input_speed_rpm": 4500.0}]
        rows = dict(crown_page._summary(Report(study)).rows)
        self.assertEqual(rows["Operating points"], "2 points, 1,500 to 4,500 rpm, by Miner's sum")
        self.assertEqual(rows["Recommended drop"], f"{number(advice['drop_um'], 3)} µm; 4.25 to 10.5 µm leaves at least 95 % of the life")
        self.assertEqual(rows["Recommended by"], "L10mrh from half-space pressures of both races, the shortest over the tilts")
        self.assertRegex(rows["Without tilt"], "^L10mrh [0-9.,]+ h, ")
        self.assertEqual(rows["Greatest peak pressure"], f"{number(best['peak_pressure_MPa'], 4)} MPa, straight rollers {number(straight['peak_pressure_MPa'], 4)} MPa")
        self.assertEqual(crown_page.headline(Report(study)), f"A drop of {number(advice['drop_um'], 3)} µm (recommended) gives {number(advice['half_space_life_h'], 3)} h, "
                                                             "of which straight rollers leave 43 %.")
        keys = {"input_speed_rpm": "input speed (rpm)", "power_kW": "power (kW)", "share": "share of time", "tilt_mrad": "tilt (mrad)", "load_share": "largest share of the load",
                "half_space_life_h": "life from half-space pressures (h)", "governing_life_h": "L10mrh by laminae (h)", "damage_share": "share of damage",
                "peak_pressure_MPa": "peak pressure (MPa)", "edge_ratio": "edge ratio"}
        advice["points"] = [dict(zip(keys, range(1, 11)))]
        self.assertEqual(self.text_table(crown_page._points(Report(study))), [list(keys.values()), [str(n) for n in range(1, 11)]])
        ends = dict(zip(("start_um", "drop_um", "crowned_share", "governing_life_h", "evaluations"), range(1, 6)))
        study["optima"] = [{"profile": "arc", "starts": {"ends": [ends]}}]
        self.assertEqual(self.text_table(crown_page._starts(Report(study))),
                         [["profile", "started at drop (µm)", "ended at drop (µm)", "crowned share", "shortest L10mrh (h)", "evaluations"], ["arc", "1", "2", "3", "4", "5"]])

    def test_effects_in_motion(self):
        runs = made.moving()["dynamic"]["ablation"]
        first, second = (run["points"][0] for run in runs[:2])
        second |= {"inner_load_rms_N": 123.4, "steady": 0}
        row = next(row for row in effects_table.rows(runs) if row[1].startswith("no Coriolis"))
        self.assertEqual(row, ("1000", "no Coriolis (drifts)", f"{second['life_h']:.0f}", f"{100 * (second['life_h'] / first['life_h'] - 1):+.1f} %", "123.4",
                               f"{second['outer_load_rms_N']:.1f}", f"{100 * second['cage_slip']:.2f} %", f"{100 * second['roller_slip']:.2f} %", f"{second['power_loss_W']:.1f}"))
        self.assertEqual(effects_table.HEAD, ("rpm", "effect", "life [h]", "change", "rms load, pin [N]", "rms load, bore [N]", "cage slip", "roller slip", "power loss [W]"))

    def test_uncertain_life(self):
        data = made.uncertainty().data
        point, peak, percents = data["operating_point"], data["peak"], ("5", "25", "50", "75", "95")
        bands = (("of uncertain inputs", point["of_uncertain_inputs"]), ("of single bearings at the case's inputs", point["of_single_bearings_at_the_case"]),
                 ("of both", point["of_both"]), ("speed of the peak (rpm), of uncertain inputs", peak["speed_rpm"]), ("system life at the peak, of uncertain inputs", peak["life_h"]))
        self.table(uncertain_page.summary_table(data), {"system_life_h (h) at 3000 rpm": [name for name, _ in bands],
                                                        **{f"{p} %": [band["percentiles"][p] for _, band in bands] for p in percents}})
        low, high = (number(point["of_uncertain_inputs"]["percentiles"][p], 4) for p in ("5", "95"))
        self.assertEqual(uncertain_page.headline(data), f"At 3,000 rpm system life lies between {low} and {high} h (5 to 95 %); measure bearing.radial_clearance first.")
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            print_result({**data, "measure_first": [{"result": "life", "measure": "x", "standard_deviation": 9.0, "expected_standard_deviation_after": 7.0}]})
        band = lambda row, key: f"{key} {row[key]:6.3f} ({row[f'{key}_95'][0]:6.3f} to {row[f'{key}_95'][1]:6.3f})"  # noqa: E731
        lines = [f"  {row['inputs']:29}  {band(row, 'first')}  {band(row, 'total')}" for row in sorted(point["indices"], key=lambda row: -row["first"])]
        self.assertIn("indices (95 %), the input to measure first on top:\n" + "\n".join(lines) + "\n", said.getvalue())
        rows = data["speeds"]
        self.table(uncertain_page._band_table(data), {"input speed (rpm)": column(rows, "speed_rpm"), "the case (h)": column(rows, "life_at_the_case_h"),
                                                      **{f"inputs {p} % (h)": Q([r["of_uncertain_inputs"]["percentiles"][p] for r in rows], "h") for p in percents},
                                                      "life that 90 % reach, all uncertain (h)": Q([r["of_both"]["L10"] for r in rows], "h")})
        two = (peak["speed_rpm"], peak["life_h"])
        self.table(uncertain_page._peak_table(data), {"of the peak": ["speed (rpm)", "system life (h)"], "the case": [3111.0, 22222.0], "mean": [one["mean"] for one in two],
                                                      "standard deviation": [one["standard_deviation"] for one in two],
                                                      **{f"{p} %": [one["percentiles"][p] for one in two] for p in percents}})
        expected = [(title, row) for title, one in (("life at 3000 rpm", point), ("speed of the peak", peak["speed_rpm"]), ("life at the peak", peak["life_h"]))
                    for row in sorted(one["indices"], key=lambda row: -row["first"])]
        ends = lambda key: [f"{number(row[key][0], 3)} to {number(row[key][1], 3)}" for _, row in expected]  # noqa: E731
        found = uncertain_page._index_table(data)
        self.assertEqual(found.head, ("result", "input", "first", "95 %", "total", "95 %", "expected standard deviation once it is known (h or rpm)"))
        self.assertEqual([row[:3] for row in found.rows], [(title, row["inputs"], row["first"]) for title, row in expected])
        self.assertEqual([row[3] for row in found.rows], ends("first_95"))
        self.assertEqual([row[4:] for row in found.rows], [(row["total"], end, row["expected_standard_deviation_after"]) for (_, row), end in zip(expected, ends("total_95"))])
        self.assertEqual(self.text_table(uncertain_page._motion(data))[1:], [["5", "11,000", "12,000", "1.09", "ok"], ["95", "31,000", "30,500", "0.98", "ok"]])

    def test_cells(self):
        """Numbers for reading; what is missing is a dash."""
        text = page.table(Table(("a (N)", "b"), [(1234.5678, "x < y"), (None, float("nan"))]))
        self.assertEqual(self.text_table(text), [["a (N)", "b"], ["1,235", "x < y"], ["–", "–"]])

    def test_pressure_over_a_contact(self):
        contact = {"profile": "arc", "tilt_mrad": 0.25, "x_mm": [0.0, 1.0], "y_um": [0.0, 10.0, 20.0, 30.0], "pressure_MPa": [[900.0, 400.0, 0.0, 0.0], [1000.0, 500.0, 0.0, 0.0]]}
        contact["x_mm"], contact["pressure_MPa"] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0], contact["pressure_MPa"] * 3
        with unittest.mock.patch("matplotlib.backends.backend_svg.FigureCanvasSVG.print_svg", without_svg), style.context():
            found = roller_pressure.map_block([contact]).summary
        self.table(found, {"profile": ["arc"], "tilt (mrad)": [0.25], "greatest in one element (MPa)": [1000.0], "greatest width (µm)": [30.0]})


if __name__ == "__main__":
    unittest.main()
