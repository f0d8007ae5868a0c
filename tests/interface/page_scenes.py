"""What is done on the page for the record of all that it draws and sends (page_drawn_record.py): cases, results that are made up, and steps.

The program checks the cases once, when page_cases.json.xz is written; from then on they stay as they are.
"""

from page_fixture import CASE, CROWN, HIGH, MESH, MODES, OTHER, OVER_SPEEDS, ROLLER, ROLLERS, RUN, SWEEP, VERDICTS, click, cursor_put, put, text_put
from program import CASES


def of_template(name):
    return (CASES / "templates" / f"{name}.yaml").read_text(encoding="utf-8")


def of_case(name):
    return (CASES / name / "case.yaml").read_text(encoding="utf-8")


PROFILE = CASE.replace("lubricant: {", "  profile:\n    kind: iso16281\n    drop: 6.5 um\nlubricant: {")
PLAIN = CASE.replace("sweep:\n  input.speed: [8000 rpm, 9000 rpm, 10000 rpm]\n", "")
THIRD = CASE.replace("radial_clearance: 10 um", "radial_clearance: 30 um")
RINGS = CASE.replace("  type: cylindrical-roller\n", "  type: cylindrical-roller\n  rings: outer\n")
NAMED = of_case("reducer_nu204")
TEXTS = {
    "planets": CASE, "other": OTHER, "profile": PROFILE, "plain": PLAIN, "third": THIRD, "rings": RINGS, "named": NAMED, "sets": of_case("three_sets_150kW"), "wind": of_template("wind-stage"),
    "roller": of_template("roller-bearing"), "ball": of_template("ball-bearing"), "duplex": of_template("duplex"), "defect": of_template("defect"), "pair": of_case("mesh_62_62"),
    "modes": of_case("lin_parker_1999"), "film": of_case("spin_film_guo2013")}


# --- Steps.
def record(name):
    return {"what": "record", "name": name}


def opened(name):
    return {"what": "open", "selector": f"#card-{name}"}


def press(selector, event="pointerdown", **data):
    return {"what": "press", "selector": selector, "event": event, "data": data}


def frames(*times):
    return {"what": "frames", "times": list(times)}


def resize(width):
    return {"what": "resize", "width": width}


def told(event, **data):
    return {"what": "tell", "event": event, "data": data}


def points(*speeds):
    return {"what": "points", "speeds": list(speeds), "which": 0}


def button(text, selector="button"):
    return {"what": "click", "selector": selector, "text": text}


def time(by):
    return {"what": "time", "by": by}


def file_put(name, text, selector="#open-file"):
    return {"what": "files", "selector": selector, "files": [{"name": name, "text": text}]}


def together(*steps):
    return {"what": "together", "all": list(steps)}


def check_put(selector, value):
    return {"what": "check", "selector": selector, "value": value}


# --- Checks that are changed, as other cases have them.
def with_inputs(check, **values):
    """Inputs of a check with other values; None: without it. A path has double underscores for its dots."""
    values = {path.replace("__", "."): value for path, value in values.items()}
    known = {one["path"] for one in check["inputs"]}
    kept = [{**one, "value": values.get(one["path"], one["value"]), "given": str(values.get(one["path"], one["given"]))} for one in check["inputs"]
            if values.get(one["path"], 0) is not None]
    return {**check, "inputs": kept + [{**check["inputs"][0], "path": path, "value": value, "given": str(value)} for path, value in values.items() if path not in known and value is not None]}


def made(base, name, edit=lambda check: check, **more):
    """Another case: `base` with a comment, by which the page tells it from others, and a check that is changed."""
    return {"base": base, "text": f"{TEXTS[base]}# {name}\n", "edit": edit, **more}


def steps_through(cases):
    """One case after another is put into the text."""
    return [step for case in cases.values() for step in [text_put(case["text"]), *case.get("steps", [])]]


# --- Curves.
CURVES = [
    record("as it is at first"), opened("more"), put("#card-more select", "film_inner_um"), cursor_put(8400), cursor_put(8000), cursor_put(10000), check_put("#card-life-log", False),
    press("#card-life .chart", buttons=1, clientX=300, clientY=50, pointerId=7), press("#card-loads .chart", "pointermove", buttons=1, clientX=470, clientY=60),
    press("#card-loads .chart", "pointermove", buttons=2, clientX=100, clientY=60), press("#card-roller-loads .chart", "pointermove", buttons=3, clientX=-50, clientY=60),
    press("#card-roller-loads .chart", "pointermove", buttons=1, clientX=5000, clientY=60), click("[data-pin=B]"), text_put(OTHER), click("[data-pin=A]"), cursor_put(8700),
    text_put(THIRD), click("[data-pin=C]"), check_put("#card-life-log", True), click("[data-take=B]"), click("[data-pin=B]"), click("[data-drop=A]"),
    resize(360), resize(1600), resize(40), resize(561)]

# --- Axes: pressures along a roller, of any sign and size; each is its own result.
def along(inner, outer, at=None):
    return {"roller_loads": [{**ROLLERS[0], "along_mm": at or [-1.0, 1.0][:len(inner)], "inner_pressure_MPa": inner, "outer_pressure_MPa": outer}]}


AXES = {name: made("plain", name, results={"run": {**RUN, **along(*values)}}) for name, values in {
    "near": ([1011.0, 1022.0], [1001.0, 1044.0]), "from nought": ([100.0, 300.0], [900.0, 1000.0]), "below nought": ([-1011.0, -1022.0], [-1001.0, -1044.0]),
    "up to nought": ([-100.0, -300.0], [-900.0, -1000.0]), "of both signs": ([-50.0, 10.0], [20.0, 30.0]), "one below": ([-7.0, -7.0], [-7.0, -7.0]), "one above": ([7.0, 7.0], [7.0, 7.0]),
    "all nought": ([0.0, 0.0], [0.0, 0.0]), "60 percent": ([601.0, 700.0], [800.0, 1000.0]), "59 percent": ([599.0, 700.0], [800.0, 1000.0]), "minus 60 percent": ([-601.0, -700.0], [-800.0, -1000.0]),
    "huge": ([1.5e7, 3e7], [2e7, 4.5e7]), "tiny": ([1.5e-5, 3e-5], [2e-5, 4.5e-5]), "one point": ([5.0], [6.0], [2.0]), "one point at nought": ([5.0], [6.0], [0.0]), "left of nought": ([5.0], [6.0], [-3.0]),
    "gaps": ([None, 10.0, 20.0, None, None, 30.0, 40.0, None], [1.0, None, 3.0, 4.0, 5.0, None, 7.0, 8.0], [-4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0]),
    "alike": ([1.0, 2.0, 3.0], [1.001, 2.002, 3.003], [0.0, 1.0, 2.0]), "the same": ([1.0, 2.0, 3.0], [1.0, 2.0, 3.0], [0.0, 1.0, 2.0]), "at this scale": ([0.001, 200.0, 300.0], [0.5, 200.0, 300.0], [0.0, 1.0, 2.0]),
    "half alike": ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [1.0, 2.0, 3.0, 4.0, 9.0, 9.0], [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]), "less than half": ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [1.0, 2.0, 9.0, 9.0, 9.0, 9.0], [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]),
    "few digits": ([100.0, 200.0], [150.0, 250.0], [1000.0, 1010.0]), "many digits": ([100.0, 200.0], [150.0, 250.0], [1234567.0, 1234568.0]),
    "percent apart": ([100.0, 200.0], [100.9, 201.8], [0.0, 1.0]), "more than a percent apart": ([100.0, 200.0, 50000.0], [101.2, 202.4, 50000.0], [0.0, 1.0, 2.0]), "nothing": ([], [])}.items()}
AXES["three curves"] = made("plain", "three curves", results={"run": {**RUN, "roller_loads": [
    {**ROLLERS[0], "set": name, "along_mm": [-1.0, 0.0, 1.0], "inner_pressure_MPa": [10.0, 20.0, 15.0 + i], "outer_pressure_MPa": [10.0, 20.0, 15.0]} for i, name in enumerate(("first", "second", ""))]}})
AXES["none"] = made("plain", "none", results={"run": {**RUN, "roller_loads": []}})
AXES["no loads"] = made("plain", "no loads", results={"run": {**RUN, "roller_loads": None}})


def lives(name, **nulls):
    """Lives over speed of an axis with logarithms."""
    return made("planets", name, nulls={key: None for key in ("L10h", "L10rh", "L10mh", "L10mrh")} | nulls, results={"run": {**RUN, "verdicts": []}, "sweep": {**SWEEP, "verdicts": []}})


AXES["more labels"] = made("plain", "more labels", results={"run": {**RUN, **along([1.0, 2.0], [3.0, 4.0], [8100.0, 9990.0])}}, steps=[resize(300), resize(240), resize(180), resize(800)])


def of_points(*rows):
    return [{"input_speed_rpm": 8000.0 + 1000.0 * i, "status": "ok", **row} for i, row in enumerate(rows)]


LOGS = {"first without": made("planets", "first without", results={"sweep": {**SWEEP, "points": of_points({"life_h": 1.0, "planet_load_N": 5.0}, {"life_h": 2.0, "L10h": 3.0, "planet_load_N": 6.0}, {"life_h": 4.0, "L10h": 5.0, "planet_load_N": 7.0})}}),
        "alike below nought": made("planets", "alike below nought", results={"sweep": {**SWEEP, "points": of_points(*({"life_h": one, "L10h": one, "L10rh": other} for one, other in ((1.0, 2.0), (-1.0, 0.0), (3.0, 9.0))))}}),
        "other choice": made("planets", "other choice", nulls={"contact_pressure_max_MPa": None}, results={"run": {**RUN, "verdicts": []}}), "one life": lives("one life", life_h=5.0), "three decades": lives("three decades", life_h=2.0, L10h=1990.0), "more than three decades": lives("more than three decades", life_h=2.0, L10h=2100.0),
        "no life": lives("no life", life_h=None), "below nought": lives("below nought", life_h=-1.0, L10h=0.0), "below and above": lives("below and above", life_h=-1.0, L10h=30.0),
        "19 percent": lives("19 percent", life_h=100.0, L10h=119.0), "21 percent": lives("21 percent", life_h=100.0, L10h=121.0),
        "peak at the end": made("planets", "peak at the end", results={"sweep": {**SWEEP, "peak": {"life_key": "L10h", "speed_rpm": HIGH, "life_h": 7.0}}}),
        "peak at the beginning": made("planets", "peak at the beginning", results={"sweep": {**SWEEP, "peak": {"life_key": "system_L10h", "speed_rpm": 8000.0, "life_h": 7.0}}}),
        "peak elsewhere": made("planets", "peak elsewhere", results={"sweep": {**SWEEP, "peak": {"life_key": "L10h", "speed_rpm": 12000.0, "life_h": 7.0}}}),
        "no peak": made("planets", "no peak", results={"sweep": {**SWEEP, "peak": None}}),
        "peak without speed": made("planets", "peak without speed", results={"sweep": {**SWEEP, "peak": {"life_key": "L10h", "speed_rpm": None, "life_h": None}}}),
        "loads alike": made("planets", "loads alike", nulls={"planet_load_N": 1e6, "tangential_load_N": 5e5, "centrifugal_load_N": 10.0, "radial_mesh_load_N": 5.0}),
        "failed points": made("planets", "failed points", nulls={"status": "failed"})}

# --- Charts as no card has them.
def chart(series, x=None, y=None, options=None, moved=False, **more):
    return {"what": "chart", "options": options or {}, "moved": moved, "state": {"series": [{"key": f"s{i}", "label": f"series {i}", "points": points} if isinstance(points, list) else points for i, points in enumerate(series)],
                                                                                  "x": {"label": "across", **(x or {})}, "y": {"label": "up", **(y or {})}, **more}}


UP, DOWN = [[0.0, 1.0], [1.0, 5.0], [2.0, 2.0]], [[0.0, 5.0], [1.0, 1.0], [2.0, 4.0]]
CHARTS = [
    {"what": "chart", "options": {}, "moved": True, "state": None}, {"what": "chart cursor", "value": 1.0}, press("article .chart", buttons=1, clientX=300, clientY=50, pointerId=1), resize(700),
    chart([UP, DOWN], {"low": 0.5, "high": 1.5, "unit": "mm"}, {"unit": "1"}, marks=[{"x": 1.0, "label": "a mark"}, {"x": 0.25, "label": "left of it"}, {"x": 1.75, "label": "right of it"}, {"x": None, "label": "nowhere"}], cursor=1.25, moved=True),
    *({"what": "chart cursor", "value": value} for value in (0.25, 1.75, 0.5, 1.5, None, 0.75)),
    press("article .chart", buttons=1, clientX=300, clientY=50, pointerId=9), press("article .chart", "pointermove", buttons=1, clientX=411, clientY=170), press("article .chart", buttons=2, clientX=411, clientY=170, pointerId=9), press("article .chart", buttons=1, clientX=9, clientY=9, pointerId=9),
    chart([UP], {"low": 3.0, "high": 3.0}), chart([UP], {"low": 4.0, "high": 3.0}), chart([UP], {"low": -2.0, "high": -2.0}), chart([UP], marks=[{"x": 7.0, "label": "far, and a long label of many letters"}, {"x": -5.0, "label": "far on the other side of it"}]),
    chart([{"label": "without a key", "points": UP}, {"label": "the same", "points": UP, "dots": True, "title": "titled"}, {"key": "k", "points": DOWN, "only": True, "colour": "c5"}, {"label": "third", "points": UP, "dash": "1 1"}, {"label": "fourth", "points": UP}]),
    chart([{"label": f"of {name}", "points": UP if name == "A" else DOWN, "group": name} for name in "ABAB"]), chart([[[0.0, None], [None, 2.0], [1.0, 3.0], [2.0, 4.0]]]), chart([[[0.0, 1e8], [1.0, 2.5e8]]], options={"height": 120}), chart([[[1e7, 1.0], [2e7, 3.0]]]),
    chart([[[0.0, 1.0], [1.0, 2e3]], [[0.0, 0.0], [1.0, 3.0]]], y={"log": True, "unit": "um"}, empty="nothing"), chart([[[0.0, 0.0]]], y={"log": True}, empty="nothing at all"), chart([[]]), chart([[[-3.0, -2.0], [-1.0, -1.9]]], {"unit": "N.m"}), resize(1000)]

# --- Drawings.
DRAWN = [
    opened("modes"), click("#card-bearing .play"), frames(500, 1500), frames(2750), put("#card-bearing .player select", "16"), frames(7000), put("#card-bearing .player input", "800", "input"), frames(7500),
    click("#card-bearing .play"), frames(9000), cursor_put(8400), frames(9100), put("#mode-choice", "translational 2"), click("#card-modes .play"), frames(10000), frames(10500, 10700),
    put("#card-modes .player input", "50", "input"), click("#card-modes .play"), frames(12000), press("#card-modes .chart", buttons=1, clientX=400, clientY=120, pointerId=3),
    press("#card-modes .chart", buttons=1, clientX=250, clientY=300, pointerId=3), put("#mode-choice", "planet 1"), resize(1600), text_put(OTHER), put("#mode-choice", "translational 1"), {"what": "open", "selector": "#card-gears", "value": False}, put("#card-bearing .player input", "300", "input"), frames(12500), {"what": "open", "selector": "#card-gears"},
    together(text_put(CASE), press("#card-modes .chart", buttons=1, clientX=400, clientY=200, pointerId=3)), together(cursor_put(8600), press("#card-modes .chart", buttons=1, clientX=400, clientY=380, pointerId=3), cursor_put(8700)),
    click("#card-modes .play"), frames(13000), put("#mode-choice", "rotational 1"), frames(13400), text_put(f"{CASE}# bad\n"), cursor_put(8800)]
UNEVEN = [{**ROLLERS[0], "angle_deg": [(7.0 + 360 * j / ROLLER) % 360 for j in range(ROLLER)]}]
BEARINGS = {
    "without rings": made("planets", "without rings", lambda check: with_inputs(check, bearing__rings="none")), "on the pin": made("rings", "on the pin"),
    "without a bore": made("planets", "without a bore", lambda check: with_inputs(check, bearing__bore=None)), "bore too large": made("planets", "bore too large", lambda check: with_inputs(check, bearing__bore=0.032)),
    "without an outside": made("planets", "without an outside", lambda check: with_inputs(check, bearing__outside_diameter=0.035)),
    "without a cage": made("planets", "without a cage", lambda check: with_inputs(check, bearing__cage__inner_diameter=None, bearing__cage__outer_diameter=None)),
    "few rollers": made("planets", "few rollers", lambda check: {**with_inputs(check, bearing__pitch_diameter=0.02, bearing__roller_diameter=0.011, bearing__rollers=3, bearing__bore=None),
                                                                "derived": [one for one in check["derived"] if "raceway" not in one["path"]]}),
    "one angle": made("planets", "one angle", results={"run": {**RUN, "roller_loads": [{**ROLLERS[0], "angle_deg": [30.0], "inner_load_N": [100.0], "outer_load_N": [200.0]}]}}),
    "no angle": made("planets", "no angle", results={"run": {**RUN, "roller_loads": [{**ROLLERS[0], "angle_deg": [], "inner_load_N": [], "outer_load_N": []}]}}),
    "no load": made("planets", "no load", results={"run": {**RUN, "roller_loads": [{**ROLLERS[0], "inner_load_N": [0.0] * ROLLER, "outer_load_N": [0.0] * ROLLER}]}}),
    "turned": made("planets", "turned", results={"run": {**RUN, "roller_loads": UNEVEN}}, steps=[put("#card-bearing .player input", "130", "input")]),
    "other set": made("planets", "other set", results={"run": {**RUN, "roller_loads": [{**ROLLERS[0], "set": "none of it"}]}}),
    "backwards": made("planets", "backwards", lambda check: {**check, "derived": [{**one, "value": -one["value"]} if one["path"] == "operation.planet_speed" else one for one in check["derived"]]},
                      steps=[put("#card-bearing .player input", "250", "input"), frames(100)]),
    "no speed": made("planets", "no speed", lambda check: {**check, "derived": [one for one in check["derived"] if one["path"] != "operation.planet_speed"]}, steps=[put("#card-bearing .player input", "400", "input")]),
    "no size": made("planets", "no size", lambda check: with_inputs(check, bearing__pitch_diameter=None)), "no rollers": made("planets", "no rollers", lambda check: with_inputs(check, bearing__rollers=0)),
    "no diameter": made("planets", "no diameter", lambda check: with_inputs(check, bearing__roller_diameter=0.0)),
    "angles": made("planets", "angles", lambda check: with_inputs(check, gearset__planet_angles=[0.1, 1.5, 3.3, 4.6]), steps=[put("#card-bearing .player input", "700", "input"), frames(100)]),
    "too few angles": made("planets", "too few angles", lambda check: with_inputs(check, gearset__planet_angles=[0.1, 1.5, 3.3])),
    "helix": made("planets", "helix", lambda check: {**with_inputs(check, gearset__helix_angle=0.35, gearset__addendum=1.1, gearset__clearance=0.3, gearset__pressure_angle=None),
                                                     "derived": [one for one in check["derived"] if one["path"] not in ("gearset.centre_distance", "gearset.profile_shift.planet")]}),
    "no helix": made("planets", "no helix", lambda check: {**with_inputs(check, gearset__helix_angle=None, gearset__addendum=None, gearset__clearance=None, gearset__profile_shift__sun=None,
                                                                         gearset__profile_shift__ring=None), "power_flow": []}),
    "moving ring": made("planets", "moving ring", lambda check: {**check, "power_flow": [{**one, "speed_rpm": {"sun": 3000.0, "ring": -9000.0, "carrier": 500.0}.get(one["member"], 1.0)} for one in check["power_flow"]]},
                        steps=[put("#card-bearing .player input", "300", "input"), frames(100)]),
    "no tooth at all": made("planets", "no tooth at all", lambda check: with_inputs(check, gearset__teeth__sun=None), steps=[put("#card-bearing .player input", "600", "input"), frames(200)]), "no tooth": made("planets", "no tooth", lambda check: with_inputs(check, gearset__teeth__sun=None)), "no module": made("planets", "no module", lambda check: with_inputs(check, gearset__module=0.0)),
    "without a quarter": made("planets", "without a quarter", results={"modes": {"refused": {"body": {"modes": [{key: value for key, value in mode.items() if key != "shape_quarter"} for mode in MODES]}}}},
                              steps=[opened("modes")]),
    "other kinds": made("planets", "other kinds", results={"modes": {"refused": {"body": {"modes": [{**MODES[0], "kind": "planar"}, *MODES[1:]]}}}}, steps=[put("#mode-choice", "planar 1")]),
    "no mesh": made("planets", "no mesh", lambda check: {**check, "derived": [one for one in check["derived"] if one["path"] != "gearset.dynamics.mesh_frequency"]}),
}

# --- Tiles and verdicts.
OF_SETS = {"first": {"L10mrh": 15000.0, "shortest_L10mrh": 7448.0, "S0": 4.5, "kappa": 1.25}, "second": {"L10mrh": 90000.0, "S0": 3.5, "kappa": 2.25, "contact_pressure_max_MPa": 1234.0, "planet_load_N": 4321.0}}
NULLS_OF_SETS = {"limiting_set": "first", "carrier_L10mrh": None, "shortest_L10mrh": 7448.0, **{f"sets.{name}.{key}": value for name, of in OF_SETS.items() for key, value in of.items()}}
NONE_JUDGED = {**RUN, "verdicts": []}
BINS = [{"bin": i + 1, "power_kW": 150.5 - i, "torque_N_m": 160.25 - 3 * i, "speed_rpm": 9000.0 - 7 * i, "share": [0.25, 0.75, None, 1.5][i], "damage_share": [0.875, 0.125, 1.25, None][i], "life_h": 1.0, "L10mrh": 2.0,
         "worst_bearing_h": 4321.0 + 11 * i} for i in range(4)]
SPECTRUM = {"bins": BINS, "life_h": 1.0, "life_key": "L10mrh", "L10mrh": 2.0, "shortest_L10mrh": 5432.0, "worst_bearing_key": "shortest_L10mrh", "worst_bearing_h": 5432.0, "limiting_set": "second"}


def judged(name, run=None, sweep=None, check=lambda check: check, base="planets", **nulls):
    return made(base, name, check, nulls=nulls, results={"run": {**RUN, **(run or {})}, "sweep": {**SWEEP, **(sweep or {})}})


TILES = {
    "passed": judged("passed", {"verdicts": [{**VERDICTS[0], "value": 200.5, "passed": True, "points_failed": 0}]}, {"verdicts": []}),
    "not limited": judged("not limited", {"verdicts": [{**VERDICTS[0], "key": "L10h"}]}, {"verdicts": []}), "none judged": judged("none judged", {"verdicts": []}, {"verdicts": []}),
    "no worst": judged("no worst", {"verdicts": []}, carrier_L10mrh=None, shortest_L10mrh=None), "shortest": judged("shortest", {"verdicts": []}, carrier_L10mrh=None),
    "life without value": judged("life without value", {"verdicts": [{**VERDICTS[0], "value": None, "passed": None}]}), "no limits over speed": judged("no limits over speed", sweep={"verdicts": None}),
    "passed over speed": judged("passed over speed", sweep={"verdicts": [{**OVER_SPEEDS[1], "passed": True}]}), "one speed": judged("one speed", base="plain"),
    "by one key": judged("by one key", {"verdicts": [], "life_key": "L10h"}), "by another": judged("by another", {"verdicts": [], "peak": {**RUN["peak"], "life_key": "life_h"}}),
    "by the check": judged("by the check", {"verdicts": [], "peak": None}, check=lambda check: {**check, "governing_life": {**check["governing_life"], "key": "L10rh"}}),
    "by none": judged("by none", {"verdicts": [], "peak": None}, check=lambda check: {**check, "governing_life": None}),
    "spectrum": judged("spectrum", {"spectrum": SPECTRUM, "verdicts": []}, {"spectrum": SPECTRUM}), "spectra": judged("spectra", {"spectrum": [{**SPECTRUM, "limiting_set": None}]}, {"spectrum": [{**SPECTRUM, "limiting_set": None, "bins": BINS[:2]}]}),
    "no bins": judged("no bins", {"spectrum": {"life_key": "L10rh", "L10rh": 4321.0, "bins": []}}, {"spectrum": {"bins": []}}),
    "sets": judged("sets", {"verdicts": [{**VERDICTS[0], "value": 7448.0, "result": "shortest_L10mrh", "of_set": "first"}, {**VERDICTS[1], "value": 3.5, "of_set": "second"}]}, **NULLS_OF_SETS),
    "second set": judged("second set", {"verdicts": []}, **{**NULLS_OF_SETS, "limiting_set": "second", "sets.second.carrier_L10mrh": 1e8, "sets.first.kappa": None}),
    "sets without a limit": judged("sets without a limit", {"verdicts": []}, **{**NULLS_OF_SETS, "limiting_set": None}),
    "missing": judged("missing", {"verdicts": []}, L10h=1234567.8, kappa=None, L10mh=None, L10mrh=None, carrier_L10mrh=None, shortest_L10mrh=None, S0=None, planet_load_N=-0.000123, cage_slip=0.0),
    "no oil": judged("no oil", {"verdicts": []}, check=lambda check: {**check, "inputs": [one for one in check["inputs"] if not one["path"].startswith("lubricant.")]}, kappa=None, L10mh=None, L10mrh=None),
    "hours": judged("hours", {"verdicts": []}, L10h=0.5, L10rh=9999.4, L10mh=99999.6, life_h=1.0, system_life_h=1e7, system_L10h=12.3456),
    "infinite": judged("infinite", {"verdicts": [{**VERDICTS[1], "value": 9.75, "unit": "kN", "limit": 1e-5, "bound": "at most"}]}, S0=None)}

# --- What is asked for on a button.
WORSE = {**CROWN, "in_run": {**CROWN["in_run"], "recommended_h": 20123.0}, "life_key": "life_h",
         "recommended": {**CROWN["recommended"], "curve": None, "shortens_governing_life": True, "status": "shortens the governing life"}}
ASKED_FOR = {"worse crown": made("planets", "worse crown", results={"crown": WORSE}, steps=[click("#card-crown button")]),
             "no recommendation": made("planets", "no recommendation", results={"crown": {**CROWN, "recommended": None, "in_run": None, "optimum": {"profile": "logarithmic", "drop_um": 1.25, "governing_life_h": 345.0, "peak_pressure_MPa": 678.0}}},
                                       steps=[click("#card-crown button"), button("Put this drop into the case")]),
             "no run": made("planets", "no run", results={"crown": {**CROWN, "in_run": None}}, steps=[click("#card-crown button")]),
             "refused": made("planets", "refused", results={"crown": {"refused": {"status": 422, "body": {"code": 2, "errors": ["case.yaml:3:4: bearing.profile: found none; required: one", "--set: input.speed: found x", "words"]}}},
                                                            "mesh": {"refused": {"status": 422, "body": {"code": 1, "errors": ["no mesh"]}}}, "sensitivities": {"refused": {"status": 500, "body": {"error": "an error"}}},
                                                            "modes": {"refused": {"status": 500, "body": {}}}},
                            steps=[click("#card-crown button"), click("#card-assumptions button"), cursor_put(8500), click("#card-assumptions button")]),
             "bad": made("planets", "bad", lambda check: None, errors=["case.yaml:10:11: gearset.module: found 3,5 mm; required: more"]),
             "idle": made("planets", "idle", lambda check: {**check, "warnings": ["bearing.x: 3 has no effect: y replaces it", "another warning", "input.z: 4 has no effect here"]},
                          steps=[click("[data-pin=A]"), text_put(CASE), click("[data-pin=A]"), text_put(f"{CASE}# idle\n"), click("[data-pin=B]"), click("[data-pin=A]")])}
ASKED = [
    opened("crown"), opened("assumptions"), opened("mesh"), opened("point"), click("#card-crown button"), click("#card-assumptions button"), cursor_put(8400), click("#card-assumptions button"),
    {"what": "press", "selector": "#card-assumptions a", "event": "click", "data": {}}, cursor_put(9000), text_put(OTHER), click("#card-crown button"), button("Put this drop into the case"), *steps_through(ASKED_FOR), text_put(CASE),
    {"what": "open", "selector": "#card-mesh", "value": False}, text_put(OTHER), {"what": "open", "selector": "#card-mesh"},
    together(click("#card-crown button"), click("#card-crown button"), cursor_put(8100)), *(step | {"unseen": True} for i in range(21) for step in (cursor_put(8200 + 10 * i), click("#card-crown button"))), cursor_put(8200),
    cursor_put(9000), click("#card-crown button"), cursor_put(8400), together(click("#card-crown button"), cursor_put(9000)), {"what": "open", "selector": "#card-mesh", "value": False}, text_put(PROFILE),
    together(cursor_put(9100), click("[data-pin=A]")), text_put(f"{CASE}# bad\n"), {"what": "open", "selector": "#card-mesh"}, click("[data-pin=B]"), text_put(PROFILE), click("[data-pin=C]"), text_put(OTHER), click("[data-pin=A]"), click("[data-drop=C]"),
    text_put(f"{CASE}# idle\n"), click("[data-pin=B]"), together(text_put(CASE), text_put(OTHER), cursor_put(9200), text_put(CASE))]

# --- A result as tables.
REST = {"rest_a": 12345.678, "rest_b": {"inner": 0.00012346, "rows": [{"a": 1.5}], "deep": {"most_mm": 5.5, "words": "of it"}}, "single": [{"set": "first", "b_um": [1.5]}], "bare": [{"a_um": [1, 2]}, {"a_um": [3, 4]}], "blank": [{"q": 1}, {"q": ""}], "rest_list": [1.5, None, 2.5], "rest_um": [4.25], "rest_rows": [{"name": "one", "force_N": 3.25}, {"name": "two", "force_N": 4.75}],
        "rest_lists": [{"set": "", "loads_N": [1.5, 2.5]}], "rest_words": ["x", "y"], "rest_matrix": [[1.25, 2.25, "z"], [3.25, None, "u"]], "rest_text": "words_of.it", "rest_flag": True, "rest_none": None,
        "power_flow": [{"member": "sun", "speed_rpm": 1.5, "torque_N_m": 2.5}, {"member": "ring", "speed_rpm": 3.5, "torque_N_m": -4.5}]}
LONG = {"many": [{"name": f"row_{i}", "force_N": 1.5 + i, "left": "", "loads_N": [i + 0.5], "odd": None if i % 2 else i} for i in range(70)], "twelve": [{"set": f"of {i}", "a_um": [i, 2 * i]} for i in range(12)], "thirteen": [{"x": i} for i in range(13)],
        "wide": [[float(i) for i in range(14)]], "twelve_wide": [[float(i) for i in range(12)]], "none": [], "long": [float(i) + 0.5 for i in range(30)], "mixed": [{"a": 1, "b": {"c": 2}}, {"a": "word", "b": None}], "numbers": [1, 2, None]}
TABLES = {"rest": made("planets", "rest", nulls={"refined": True, "within": {"a": 1}, "none_of": None}, results={"run": {**RUN, **REST}}), "long": made("planets", "long", results={"run": {**RUN, **LONG, "units": {**RUN["units"], "many": "N", "long": "um", "wide": "1"}}},
                                                                                      steps=[{"what": "open", "selector": "#card-point details"}])}

# --- A run in time.
NOW = {"angle_deg": [360 * j / ROLLER for j in range(ROLLER)], "spin_rpm": [1200.0 + j for j in range(ROLLER)], "inner_load_N": [10.0 + j for j in range(ROLLER)], "outer_load_N": [20.0 + 2 * j for j in range(ROLLER)],
       "cage_um": [3.0, 4.0], "cage_turned_deg": 30.0, "cage_rpm": 950.0, "rolling_cage_rpm": 1000.0, "time_s": 0.1, "expected_s": 0.4, "most_s": 0.8, "run": 2, "most_runs": 5}


def moving(after=0, **more):
    return [*([time(after)] if after else []), told("motion", **{**NOW, **more})]


MOTION = [
    put("#fidelity", "dynamic"), click("#card-motion .chief"), told("progress", done=1, all=16, seconds_left=12.34, doing=""), points(9000.0, 8000.0), *moving(), *moving(250, time_s=0.2, cage_turned_deg=600.0, cage_um=[5.0, -6.0]),
    *moving(300, time_s=0.25, cage_turned_deg=910.0, cage_rpm=900.0, inner_load_N=[77.0] * ROLLER), *moving(700, time_s=0.5, cage_turned_deg=1990.0, run=None), *moving(100, time_s=0.1, cage_turned_deg=3.0),
    *moving(200, time_s=0.2, cage_turned_deg=600.0, rolling_cage_rpm=1100.0), *moving(0, time_s=0.3, cage_turned_deg=700.0, rolling_cage_rpm=1100.0), cursor_put(8500),
    told("progress", done=2, all=16, seconds_left=None, doing="Set up"), told("progress", done=2, all=0, seconds_left=3.0, doing=""), {"what": "click", "selector": "#card-motion .stop"},
    text_put(OTHER), click("#card-motion .back"), {"what": "click", "selector": "#card-motion .proceed"}, points(10000.0, 9000.0), text_put(OTHER), *moving(50, time_s=0.4), text_put(CASE), *moving(50, time_s=0.5),
    told("result", points=[]), put("#fidelity", "monolithic"), click("#card-motion .chief"), told("failed", code=1, errors=["case.yaml:3:4: motion.step: too small", "second line"]), click("#card-motion .chief"), points(8800.0),
    told("failed", code=1, errors=["--set: input.speed: bad"]), put("#fidelity", "quasi-static"), click("#card-motion .chief"), *moving(10, angle_deg=[0.0, 1.0]), {"what": "broken", "state": 1}, {"what": "broken", "state": 2},
    click("#card-motion .chief"), *moving(10, rolling_cage_rpm=-1000.0, cage_rpm=-990.0), points(8300.0, 8200.0), told("result", points=None), text_put(OTHER), click("#card-motion .chief"), *moving(10), told("result", points=of_points({"cage_slip": 0.5}, {"cage_slip": 0.25, "roller_slip": 0.125})), text_put(CASE), click("#to-take"), click("#take-motion")]
LONG_MOTION = [click("#card-motion .chief"), *(
    {"what": "tells", "event": "motion", "each": 5, "all": [{**NOW, "time_s": 0.1 + 0.001 * i, "cage_turned_deg": 6.0 * i, "cage_rpm": 950.0 + i % 7} for i in range(first, last)]}
    for first, last in ((0, 1), (1, 101), (101, 400), (400, 401), (401, 402), (402, 700), (700, 803)))]

# --- Folders of results, the first page, what is taken away.
POINTS = [{"L10mrh": 1000.5 - 2000 * i, "cage_slip": 0.125 - 0.375 * i, "roller_slip": [0.5, None][i], "power_loss_W": 10.5 + i, "power_loss_cage_W": 3.25 + i, "film_inner_um": None, "input_speed_rpm": speed, "status": "ok"} for i, speed in enumerate((9000.0, 8000.0))]
HALF = {"kind": "results", "name": "half", "file": "case.resolved.yaml", "text": CASE, "checksum": "1", "writable": True, "folder": "/x/half", "fidelity": "dynamic", "finished": False, "points": POINTS,
        "missing": {"found": 2, "of": 3}, "options": {"fidelity": "dynamic", "grid_only": True, "continue": "speed"}}
MORE = {**HALF, "points": [*POINTS, {**POINTS[0], "input_speed_rpm": 10000.0, "L10mrh": 999.5, "status": "failed"}]}
START = {"kind": "start", "name": "", "file": "", "text": "", "writable": False, "folder": ""}
FOUND_FOLDERS = [{"name": "half", "case": "reducer", "fidelity": "dynamic", "points": 5, "of": 16}, {"name": "whole", "case": "other", "fidelity": "quasi-static", "points": 7, "of": 7}]
TEMPLATES = [{"name": "one", "title": "One title", "purpose": "its purpose", "text": CASE}, {"name": "two", "title": "Two titles", "purpose": "other", "text": OTHER}]
TAKEN = [
    click("#to-take"), click("#take-case"), click("#take-csv"), click("#take-json"), time(10000), button("Copy", "#take .copy button"), click("#take-report"), put("#take-scope", "speeds"), click("#take-pdf"), click("#take-report"), click("#take-print"), click("#to-take"),
    click("#save"), click("#save"), click("#replace"), put("#save-name", "other.yaml"), click("#save"), click("#take .close"), put("#fidelity", "dynamic"), cursor_put(8400), click("#to-take"), click("#take .close"), text_put(f"{CASE}# bad\n"), click("#to-take"), click("#take-case"), click("#take .close"),
    click("#to-text"), press("#yaml", "keydown", key="a"), press("#yaml", "keydown", key="Escape"), click("#to-text"), press("#form", "submit"), click("#mend button"), {"what": "window", "event": "pagehide"}, time(15000)]

# --- The form, with more inputs.
IDS = {name: f"[id='in-{name}']" for name in ("input.power", "input.speed", "gearset.module", "gearset.planets", "gearset.face_width", "bearing.radial_clearance", "bearing.laminae", "bearing.type", "bearing.designation",
                                              "bearing.catalogue", "lubricant.temperature", "lubricant.viscosity", "life.method", "gearset.planet_angles", "sweep.input.speed", "name", "gearset.profile_shift.sun",
                                              "bearing.cage.material", "gearset.helix_angle", "material.density", "input.torque", "gearset.teeth.sun")}


def row(key, inner):
    return f"[data-key='{key}'] {inner}"


RESOLVED = f"{CASE}assumed: {{gearset.module: 'default: of the page', bearing.radial_clearance: measured}}\n"
AS_FORM = {
    "wrong": {**made("named", "wrong"), "text": NAMED.replace("power: 150 kW", "power: 0.15 MW"), "errors": ["case.yaml:20:16: bearing.designation: found NU 2999; required: a designation. nearest: NU 2206, NU 204, NU 9999. See it", "case.yaml:9:3: gearset.module: found -3 mm; required: more",
                                            "case.yaml:4:3: nowhere.key: found a key", "--set: input.speed: found x", "not about a line", "--set: gearset.teeth.sun[2].x: found 3", "case.yaml:1:1: bearing.laminae: found 3"]},
    "no unit": {"base": "planets", "text": CASE.replace("radial_clearance: 10 um", "radial_clearance: 0"), "edit": lambda check: check},
    "unchecked": {"base": "planets", "text": CASE.replace("  face_width: 28 mm\n", ""), "edit": lambda check: check, "results": {"check": {"refused": {"status": 500, "body": {"code": 1, "errors": ["no answer"]}}}}},
    "resolved": {"base": "planets", "text": RESOLVED, "edit": lambda check: check},
    "anchored": {"base": "planets", "text": CASE.replace("module: 3 mm", "module: &m 3 mm"), "edit": lambda check: None, "errors": ["case.yaml:12:11: gearset.module: found an anchor", "case.yaml:4:3: nowhere.key: found a key"]},
    "flow": {"base": "planets", "text": CASE.replace("bearing:\n", "bearing:\n  catalogue: own.csv\n").replace("viscosity: 0.01 Pa.s,", "viscosity: 0.01 Pa.s, temperature: -20 degC,"), "edit": lambda check: check},
    "empty": {"base": "planets", "text": CASE.replace("  module: 3 mm\n", "  module:\n").replace("name: reducer of the page\n", ""), "edit": lambda check: None, "errors": ["case.yaml:12:9: gearset.module: found nothing; required: a length"]}}
FORM = [
    record("as it is at first"), click("[data-group=Gears] [data-state=default]"), click("[data-group=Bearing] [data-state=absent]"), click("[data-group=Oil] [data-state=default]"), click("[data-group=Bearing] [data-state=absent]"),
    put("#search", "grease", "input"), put("#search", " Clearance  radial ", "input"), put("#search", "tapered", "input"), put("#search", "nothing is like this", "input"), put("#search", "", "input"),
    put(IDS["input.power"], "160"), put(IDS["input.power"], "160 Nm"), put(IDS["input.power"], " 0.16 MW "), put(IDS["input.power"], "150 kW"), put(IDS["gearset.module"], "4", "input"), put(IDS["gearset.module"], "3.5"), put(IDS["gearset.module"], "3,5"),
    text_put(CASE), put(row("gearset.module", ".slider"), "150", "input"), put(row("gearset.module", ".slider"), "50"), put(row("gearset.planets", ".slider"), "140", "input"), put(row("gearset.planets", ".slider"), "30"),
    put(row("gearset.profile_shift.sun", ".slider"), "77"), put(row("gearset.helix_angle", ".slider"), "120"), text_put(CASE), put(row("gearset.module", ".unit"), "um"), put(row("gearset.face_width", ".unit"), "inch"),
    put(row("gearset.helix_angle", ".unit"), "rad"), put(row("gearset.module", ".unit"), "other"), put(row("gearset.module", "input.unit"), "furlong", "input"), press(row("gearset.module", "input.unit"), "keydown", key="x"),
    press(row("gearset.module", "input.unit"), "keydown", key="Enter"), put(row("gearset.face_width", ".unit"), "other"), put(row("gearset.face_width", "input.unit"), "cm", "input"),
    press(row("gearset.face_width", "input.unit"), "keydown", key="Escape"), put(row("bearing.radial_clearance", ".unit"), "other"), press(row("bearing.radial_clearance", "input.unit"), "blur"),
    text_put(CASE), click(row("gearset.face_width", ".reset")), click(row("bearing.laminae", ".reset")), put(IDS["bearing.laminae"], "30"), put(IDS["bearing.laminae"], ""), put(IDS["name"], "12"), put(IDS["name"], ""), put(IDS["life.method"], "iso-16281"),
    put(IDS["bearing.type"], ""), put(IDS["gearset.planet_angles"], "[0 deg, 95 deg]"), put(IDS["sweep.input.speed"], "{from: 1000 rpm, to: 2000 rpm, step: 500 rpm}"), put(IDS["bearing.catalogue"], "other.csv"),
    file_put("own.csv", "a,b\n1,2\n", row("bearing.catalogue", "[type=file]")), file_put("own.csv", "x", row("bearing.catalogue", "[type=file]")), {"what": "files", "selector": row("bearing.catalogue", "[type=file]"), "files": []},
    text_put(CASE), click("[data-instead='input.torque']"), click("[data-instead='input.torque_curve']"), text_put(CASE), click("[data-instead='input.torque_curve']"), text_put(AS_FORM["resolved"]["text"]), put(IDS["gearset.module"], "3"), put(IDS["gearset.module"], "2"),
    text_put(AS_FORM["resolved"]["text"]), click(row("gearset.module", ".reset")), text_put(AS_FORM["flow"]["text"]), put(row("lubricant.temperature", ".slider"), "51"), put(IDS["lubricant.viscosity"], "0.02 Pa.s # x"), put("[id='in-lubricant.grade']", "ISO, VG"), put("[id='in-lubricant.grade']", "VG, {ISO}"),
    put(IDS["bearing.catalogue"], ""), text_put(AS_FORM["empty"]["text"]), put(IDS["gearset.module"], "3"), text_put(AS_FORM["anchored"]["text"]), button("Show the line", "#errors button"), click("#mend button"), text_put(CASE), put("#fidelity", "dynamic"), put("#fidelity", "monolithic"), text_put(AS_FORM["no unit"]["text"]), put(IDS["bearing.radial_clearance"], "3,5"), put(row("bearing.radial_clearance", ".slider"), "60"), put(IDS["gearset.planets"], "-5"),
    text_put(CASE), put(IDS["gearset.planets"], "500"), text_put(CASE), click(row("gearset.face_width", ".reset")),
    text_put(AS_FORM["wrong"]["text"]), click("#mend button"), button("NU 204", ".offers button"), button("Show the line", "#errors button"), {"what": "window", "event": "pointerdown"}, press(IDS["gearset.planets"], "focusin"),
    {"what": "window", "event": "pointerup"}, time(0), {"what": "window", "event": "pointerdown"}, {"what": "window", "event": "pointercancel"}, press("#search", "focusin"), resize(860), resize(861), text_put(TEXTS["roller"])]
CHOSEN = {**made("named", "chosen"), "text": NAMED.replace("designation: NU 204", "designation: NU 2206"), "errors": ["case.yaml:5:6: bearing.per_planet: found 2 bearings of 31 mm; required: less"]}
FILM_LIKE_NAMED = made("film", "film", errors=["case.yaml:5:6: bearing.per_planet: found 2 bearings of 31 mm; required: less"])
LIKE_NAMED = made("named", "in its place", errors=["case.yaml:5:6: bearing.per_planet: found 2 bearings of 31 mm; required: less"])

# --- Other models, each opened as a file.
OF_ROLLERS = {"L10h": 1000.5, "L10rh": 1137.5, "L10mh": 1274.5, "L10mrh": 1411.5, "life_h": 1548.5, "S0": 2.5, "kappa": 3.5, "contact_pressure_max_MPa": 1234.5, "contact_loads_N": [500.0 + 7 * j for j in range(14)],
              "outer_contact_loads_N": [400.0 + 9 * j for j in range(14)], "lamina_loads_N": [[10.0 * ((5 * j) % 14) + i for i in range(4)] for j in range(14)], "roller_loads": [], "steps": {"gamma": 0.125, "lamina_places_mm": [-3.0, -1.0, 1.0, 3.0]},
              "displacement": {"radial_um": 4.25, "axial_um": 0.5}, "verdicts": [{**VERDICTS[0], "value": 1274.0, "limit": 1274.5}, {**VERDICTS[1], "value": 2.5, "limit": 2.0}], "units": {"steps/gamma": "1"}, "warnings": ["of the run"]}
OF_BALLS = {"L10h": 900.5, "contact_loads_N": [300.0 + 11 * j for j in range(18)], "steps": {"element_angles_deg": [3.0 + 40 * j for j in range(9)]}, "units": {}, "verdicts": []}
MODELS = {
    "rollers": made("roller", "rollers", results={"run": OF_ROLLERS}), "outer turns": made("roller", "outer turns", lambda check: with_inputs(check, operation__turning_race="outer", bearing__first_element_angle=0.3), results={"run": {**OF_ROLLERS, "lamina_loads_N": []}}),
    "stands": made("roller", "stands", lambda check: with_inputs(check, operation__shaft_speed=0.0, load__radial=0.0), results={"run": {**OF_ROLLERS, "contact_loads_N": [1.0] * 13}}),
    "one row": made("roller", "one row", results={"run": {**OF_ROLLERS, "lamina_loads_N": [[4.0, 3.0, 2.0, 1.0]]}}), "rows unlike": made("roller", "rows unlike", results={"run": {**OF_ROLLERS, "lamina_loads_N": [[4.0, 3.0, 2.0, 1.0], [9.0], [5.0] * 4]}}),
    "no rollers": made("roller", "no rollers", lambda check: with_inputs(check, bearing__rollers=None), results={"run": {**OF_ROLLERS, "steps": {"lamina_places_mm": [1.0]}}}),
    "balls": made("ball", "balls", results={"run": OF_BALLS}, steps=[opened("assumptions"), click("#card-assumptions button"), click("#to-take"), click("#take .close"), click("[data-pin=A]")]),
    "balls in time": made("ball", "balls in time", lambda check: {**check, "inputs": [{**one, "used_by": [*one["used_by"], "run of a ball bearing in time"]} for one in check["inputs"]]}),
    "duplex": made("duplex", "duplex", results={"run": {"L10h": 1.5, "units": {}}}), "pair": made("pair", "pair", steps=[click("#to-take"), click("#take-report"), click("#take .close"), opened("mesh")]),
    "modes": made("modes", "modes", results={"modes": {"refused": {"body": {"modes": MODES, "units": {"frequency_Hz": "Hz"}, "warnings": []}}}}), "film": made("film", "film", results={"run": {"film": [{"load_N": 500.0, "h_c_um": 0.4048}], "units": {}}}),
    "sets": made("sets", "sets", lambda check: check, nulls=NULLS_OF_SETS | {"limiting_set": "coupling"}, results={"run": {**RUN, "roller_loads": [{**ROLLERS[0], "set": "coupling"}]}}, steps=[
        put("#card-bearing select", "reduction"), put("#card-gears select", "reduction"), cursor_put(7000)]),
    "wind": made("wind", "wind"),
    "planets again": made("planets", "planets again")}
DEFECT_2 = made("defect", "heavier", lambda check: with_inputs(check, load__radial=2000.0))
DEFECT = [file_put("defect.yaml", TEXTS["defect"]), click("#card-result .chief"), told("progress", done=3, all=8, doing="Motion", seconds_left=4.56), told("progress", done=3, all=0, doing="", seconds_left=None), text_put(DEFECT_2["text"]),
          told("progress", done=4, all=8, doing="Motion", seconds_left=None), told("result", shaft_Hz=25.25, defect_Hz=89.5, units={}), text_put(TEXTS["defect"]), click("#card-result .chief"),
          {"what": "click", "selector": "#card-result .player button", "text": "Stop"}, click("#card-result .chief"), told("failed", code=2, errors=["case.yaml:1:2: defect.depth: too deep", "--set: a.b: c", "other"]), click("#card-result .chief"),
          told("result", shaft_Hz=26.5, units={"shaft_Hz": "Hz"}), click("#to-take"), click("#take-json")]
FILES_OF_MODELS = [step for name, case in MODELS.items() for step in [file_put(f"{name}.yaml", case["text"]), *case.get("steps", [])]]

SPANS = {name: {"base": "planets", "text": CASE.replace("[8000 rpm, 9000 rpm, 10000 rpm]", value), "edit": lambda check: check} for name, value in {
    "radians": "[800 rad/s, 1000 rad/s]", "degrees": "[48000 deg/s, 60000 deg/s]", "from to": "{from: 8 krpm, to: 10 krpm, step: 1 krpm}", "one": "[9500 rpm]", "odd": "[9500 furlong, x, 3 rpm, 8000 rpm]", "word": "words", "from alone": "{from: 7000 rpm}",
    "backwards": "[10000 rpm, 9000 rpm]"}.items()}
SPANS |= {"slower": made("planets", "slower", lambda check: with_inputs(check, input__speed=700.0)), "by torque": made("planets", "by torque", lambda check: with_inputs(check, input__power=None, input__torque=150.0)),
          "no speed": made("planets", "no speed", lambda check: with_inputs(check, input__speed=None)), "no bearing": made("planets", "no bearing", lambda check: with_inputs(check, bearing__per_planet=None)),
          "no power": made("planets", "no power", lambda check: with_inputs(check, input__power=0.0)), "member": made("planets", "member", lambda check: with_inputs(check, input__member="carrier")), "no member": made("planets", "no member", lambda check: with_inputs(check, input__member=None)),
          "unused": made("planets", "unused", lambda check: {**check, "inputs": [{**one, "used_by": []} for one in check["inputs"]]}), "bad": ASKED_FOR["bad"],
          "anchored": {"base": "planets", "text": CASE.replace("[8000 rpm, 9000 rpm", "&s [8000 rpm, 9000 rpm"), "edit": lambda check: check}, "no curve": made("planets", "no curve", results={"sweep": {"refused": {"status": 500, "body": {"code": 1, "errors": ["no curve"]}}}}),
          "broken curve": made("planets", "broken curve", results={"sweep": {"refused": {"body": "no JSON"}}}), "planets once more": made("planets", "planets once more"),
          "no inputs": made("planets", "no inputs", lambda check: {**check, "derived": None}), "planets": made("planets", "as before"), "one fidelity": made("planets", "one fidelity", lambda check: {
              **check, "inputs": [{**one, "used_by": [name for name in one["used_by"] if name != "--fidelity quasi-static"]} for one in check["inputs"]]})}

# --- Engines: what they send and take, asked for what the page does not ask for.
RUN_OF_CASE = {"command": "run", "case_text": CASE, "settings": ["input.speed=8100 rpm"]}


def ask(engine, how, *given, **more):
    return {"what": "ask", "engine": engine, "how": how, "given": list(given), **more}


ENGINE_A = [
    ask("a", "answer", RUN_OF_CASE), ask("a", "answer", {"command": "check", "case_text": CASE}, abort="before"), ask("a", "units", "3 mm", "um"), ask("a", "units", "3 mm", "x"), ask("a", "folders"), ask("a", "results", "a folder/of it"), ask("a", "templates"),
    ask("a", "save", "x.yaml", "text: 1"), ask("a", "save", "x.yaml", "text: 2", "version"), ask("a", "report", RUN_OF_CASE), ask("a", "report", RUN_OF_CASE, "pdf", "point"), ask("a", "schema", "result"), time(15000), time(30000), {"what": "window", "event": "pagehide"},
    cursor_put(8200), cursor_put(8300), cursor_put(8400), cursor_put(8500), cursor_put(8600), click("#card-motion .chief"), click("#card-motion .chief"), click("#card-motion .stop"), {"what": "broken", "state": 0}, {"what": "broken", "state": 2}]
MANIFEST = [{"file": "manifest.jsonl", "text": '{"sweep": "of the page", "file": ""}\n'}, {"told": ["progress", {"done": 0, "all": 3, "doing": "Set up"}]}, {"told": ["progress", {"done": 0, "all": 3, "doing": "Mesh"}]},
            {"file": "manifest.jsonl", "text": '{"row": {"input_speed_rpm": 8000.0, "cage_slip": 0.5, "status": "ok"}, "file": "points/1.nc"}\n{"row": {"input_sp'}, {"told": ["motion", NOW]},
            {"file": "manifest.jsonl", "text": 'eed_rpm": 9000.0, "cage_slip": 0.25, "status": "ok"}, "file": "points/2.nc"}\n'}, {"file": "points/1.nc", "text": "arrays"}, {"told": ["progress", {"done": 2, "all": 3, "doing": ""}]},
            {"file": "manifest.jsonl", "text": '{"row": {"input_speed_rpm": 10000.0, "cage_slip": 0.125, "status": "ok"}, "file": "points/3.nc"}\n{"cut'}]
ENGINE_B = [
    record("as it is at first"), click("[data-template=one]"), cursor_put(8400), click("#to-take"), click("#take .close"), put("#fidelity", "dynamic"), click("#card-motion .chief"), *({"what": "deliver", "count": 1} for _ in range(3)), time(4000), {"what": "deliver", "count": 2},
    click("#card-motion .stop"), {"what": "click", "selector": "#card-motion .proceed"}, {"what": "deliver", "count": 3}, time(500), {"what": "deliver", "count": 20}, click("#card-motion .chief"), {"what": "deliver", "count": 30}, text_put(OTHER), text_put("name: x\n"),
    file_put("defect.yaml", TEXTS["defect"]), click("#card-result .chief"), {"what": "deliver", "count": 9}, click("#card-result .chief"), {"what": "click", "selector": "#card-result .player button", "text": "Stop"}, ask("b", "answer", RUN_OF_CASE, abort="before"),
    ask("b", "answer", RUN_OF_CASE, abort="after"), ask("b", "answer", {**RUN_OF_CASE, "settings": []}), ask("b", "units", "3 mm", "um"), ask("b", "answer", {"command": "sweep", "case_text": CASE, "settings": ["sweep={input.speed: [8000 rpm, 9000 rpm]}"]}),
    *({"what": "post", "data": {"id": 90 + i, "request": {"command": "sweep", "case_text": CASE, "settings": ["sweep={input.speed: [8000 rpm]}"], "options": {"x": i}}, "kept": kept}} for i, kept in enumerate((
        [], ['{"sweep": "x", "file": ""}', '{"row": {"input_speed_rpm": 8000.0}, "file": "points/7.nc"}'], [])))]
WHOLE = [{"body": "no memory"}, {"body": "words alone"}]

SCENES = {
    "form": {"texts": ["planets", "other", "named", "roller"], "inputs": "case", "made": {**AS_FORM, "in its place": LIKE_NAMED}, "steps": FORM, "box": [0, 0], "width": 900,
             "units": {"3 mm > um": {"body": {"number": 3000, "text": "3000 um"}}, "3 mm > furlong": {"body": {"number": 0.125, "text": "0.125 furlong"}}}, "saves": [
                 {"body": {"file": "kept/own.csv", "checksum": "c"}}, {"status": 409, "body": {"errors": ["own.csv: is there", "already"]}}]},
    "narrow form": {"texts": ["named", "planets"], "inputs": "case", "made": {"in its place": LIKE_NAMED, "chosen": CHOSEN, "film": FILM_LIKE_NAMED}, "width": 500, "opened": {**START, "kind": "case", "text": NAMED, "file": "x.yml", "name": "x"}, "steps": [
        record("as it is at first"), put(IDS["bearing.designation"], "NU 2307"), put(IDS["bearing.catalogue"], "x"), file_put("own.csv", "a,b\n1,2\n", row("bearing.catalogue", "[type=file]")), text_put(LIKE_NAMED["text"]), click("#mend button"), resize(700), text_put(NAMED), put(IDS["bearing.designation"], "NU 2206"), text_put(FILM_LIKE_NAMED["text"])]},
    "models": {"texts": ["planets"], "made": MODELS, "results": {"run": {"units": {}}}, "steps": FILES_OF_MODELS},
    "forms": {"texts": ["pair", "roller", "defect", "duplex", "film", "sets", "planets"], "inputs": "case", "steps": [record("as it is at first"), *(text_put(TEXTS[name]) for name in ("roller", "defect", "duplex", "film", "sets", "planets"))]},
    "defect": {"texts": ["planets", "defect"], "made": {"heavier": DEFECT_2}, "steps": DEFECT},
    "spans": {"texts": ["planets"], "made": SPANS, "steps": [step for case in SPANS.values() for step in (text_put(case["text"]), put("#cursor", "250", "input"), click("#to-start"), click("#back"))]
              + [text_put(SPANS["by torque"]["text"]), click("[data-instead='input.torque']"), text_put(SPANS["radians"]["text"]), click("[data-instead='input.torque']"), text_put(SPANS["no power"]["text"]), click("[data-instead='input.torque']")]},
    "slow": {"texts": ["planets", "other", "third"], "takes": {"sweep": 400, "run": 7, "check": 3}, "steps": [record("as it is at first"), text_put(OTHER), text_put(THIRD)]},
    "fast": {"texts": ["planets", "other"], "takes": {"sweep": 225, "run": 7, "check": 3}, "steps": [record("as it is at first"), text_put(OTHER), cursor_put(8100)]},
    "engine a": {"texts": ["planets"], "steps": ENGINE_A, "hash": "#results", "refusals": [None] * 4 + ["gone", {"status": 429, "body": {"error": "more than 8"}}, {"status": 429, "body": {}}, None, {"status": 503, "body": {}},
                                                                                          {"status": 500, "body": {"error": "an error"}}, {"status": 500, "body": {"code": 3, "errors": ["first", "second"]}}] + [{"status": 429, "body": {}}] * 22,
                 "job_refusals": [{"status": 503, "body": {"errors": ["no job"]}}]},
    "engine b": {"texts": ["planets", "other", "defect"], "opened": None, "search": "", "templates": TEMPLATES, "core": {"held": True, "lines": MANIFEST}, "steps": ENGINE_B, "box": [0, 0]},
    "engine b without streams": {"texts": ["planets"], "made": {"no memory": made("planets", "no memory", results={"run": {"refused": WHOLE[0]}}), "words": made("planets", "words", results={"run": {"refused": WHOLE[1]}})}, "opened": None, "search": "",
                                 "templates": TEMPLATES, "core": {"streams": False}, "steps": [record("as it is at first"), click("[data-template=one]"), text_put(f"{CASE}# no memory\n"), text_put(f"{CASE}# words\n")]},
    "engine b without a worker": {"texts": ["planets"], "opened": None, "search": "", "templates": TEMPLATES, "core": {"failing": 1}, "steps": [record("as it is at first"), click("[data-template=one]")]},
    "curves": {"texts": ["planets", "other", "third"], "steps": CURVES},
    "axes": {"texts": ["plain"], "made": AXES, "steps": steps_through(AXES)},
    "logarithms": {"texts": ["planets"], "made": LOGS, "steps": [opened("more"), put("#card-more select", "L10h"), *steps_through(LOGS), check_put("#card-life-log", False), *steps_through({"no life": LOGS["no life"], "one life": LOGS["one life"]})]},
    "charts": {"texts": [], "made": {"bad": ASKED_FOR["bad"]}, "steps": CHARTS},
    "drawings": {"texts": ["planets", "other"], "made": {"bad": ASKED_FOR["bad"]}, "steps": DRAWN},
    "bearings and gears": {"texts": ["planets"], "made": BEARINGS, "steps": steps_through(BEARINGS)},
    "tiles": {"texts": ["planets"], "made": TILES, "steps": [*steps_through(TILES), click("[data-pin=A]"), text_put(TILES["missing"]["text"]), click("[data-pin=B]"), text_put(TILES["hours"]["text"]), click("[data-drop=A]")]},
    "asked": {"texts": ["planets", "other", "profile"], "made": ASKED_FOR, "steps": ASKED, "width": 500},
    "tables": {"texts": ["planets"], "made": TABLES, "steps": [opened("point"), *steps_through(TABLES), text_put("name: bad\n"), {"what": "open", "selector": "#card-point details"}, cursor_put(8400)]},
    "motion": {"texts": ["planets", "other"], "steps": MOTION},
    "long motion": {"texts": ["plain"], "steps": LONG_MOTION},
    "take away": {"texts": ["planets"], "made": {"bad": ASKED_FOR["bad"]}, "steps": TAKEN, "saves": [
        {"body": {"file": "case.yaml", "checksum": "second"}}, {"status": 409, "body": {"errors": ["case.yaml: found another content"], "checksum": "by a colleague"}}]},
    "folder": {"texts": ["planets", "other"], "opened": HALF, "results": {"nulls": {"L10mrh": None}}, "folder_results": [{"body": HALF}, {"body": MORE}, {"body": {**MORE, "finished": True}}], "steps": [
        record("opened"), time(5000), time(5000), click("#card-motion .proceed"), points(8500.0), told("stopped", points=[]), time(5000), time(5000), text_put(OTHER), time(5000)]},
    "crown in a folder": {"texts": ["planets"], "opened": {**HALF, "points": None, "finished": True, "result": CROWN}, "steps": [record("opened"), cursor_put(8400)]},
    "optimum in a folder": {"texts": ["planets"], "opened": {**HALF, "points": None, "finished": True, "result": {**CROWN, "recommended": None, "in_run": None, "optimum": {"profile": "x", "drop_um": 1.25, "governing_life_h": 345.0, "peak_pressure_MPa": 678.0}}},
                            "steps": [record("opened"), button("Put this drop into the case")]},
    "result in a folder": {"texts": ["defect"], "opened": {**HALF, "text": TEXTS["defect"], "points": None, "finished": True, "result": {"shaft_Hz": 25.25, "units": {}}, "error": "case.resolved.yaml: differs"}, "steps": [record("opened")]},
    "empty folder": {"texts": ["planets"], "opened": {**HALF, "points": None, "finished": True, "result": None}, "steps": [record("opened")]},
    "whole folder": {"texts": ["planets"], "opened": {**HALF, "finished": True, "result": {"shaft_Hz": 25.25, "units": {}}}, "steps": [record("opened")]},
    "begun folder": {"texts": ["planets", "other"], "opened": {**HALF, "points": [], "missing": {"text": "no manifest"}, "options": None, "fidelity": "quasi-static"}, "folder_results": [{"body": {**HALF, "missing": None}}, {"body": HALF}, {"body": HALF}], "steps": [
        record("opened"), time(5000), together(click("#card-motion .chief"), time(5000)), told("result", points=[]), time(5000), together(time(5000), text_put(OTHER))]},
    "bad from the start": {"texts": [], "made": {"bad": made("planets", "bad", lambda check: None, errors=["case.yaml:1:1: name: found x", "case.yaml:70:3: nowhere.key: found y"])}, "steps": [
        record("as it is at first"), click("#mend button"), button("Show the line", "#errors button"), click("#to-take"), click("#take .close"), click("[data-pin=A]")]},
    "bad after another": {"texts": ["planets"], "made": {"bad": ASKED_FOR["bad"]}, "steps": [opened("point"), file_put("bad.yaml", ASKED_FOR["bad"]["text"]), text_put(CASE)]},
    "motion of no speed": {"texts": [], "made": {"no speed": BEARINGS["no speed"], "small": BEARINGS["few rollers"], "planets": made("planets", "planets")}, "steps": [
        click("#card-motion .chief"), *moving(10), *moving(200, time_s=0.2), *moving(600, time_s=0.3), *moving(600, rolling_cage_rpm=0.0, cage_rpm=0.0), *moving(600, rolling_cage_rpm=0.0, cage_rpm=0.0, time_s=0.2), told("result", points=[]), text_put(BEARINGS["few rollers"]["text"]), click("#card-motion .chief"), *moving(10), told("stopped", points=[])]},
    "start": {"texts": ["planets", "other"], "opened": START, "templates": TEMPLATES, "folders": FOUND_FOLDERS, "steps": [
        record("as it is at first"), click("[data-folder=half]"), click("[data-template=two]"), click("#to-start"), click("#back"), click("#to-start"), file_put("given.yml", CASE), click("#to-start"),
        click("[data-folder=whole]"), time(5000), click("#to-take")], "folder_results": [
            {"status": 422, "body": {"code": 2, "errors": ["a folder that differs", "and more"]}}, {"body": {**HALF, "name": "whole", "finished": True, "fidelity": "quasi-static", "options": None, "missing": None}}]},
}
