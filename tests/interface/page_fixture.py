"""The page in node for the tests of what it draws: its scripts on a document without a browser (page_dom.mjs) and a server whose results are made up,
of which no two keys have the same number at any speed.

Tests that use it are skipped, with the reason, where node is missing or older than 20.
"""

import decimal
import functools
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from program import CASES, run

NODE = shutil.which("node") or shutil.which("nodejs")
if NODE is None:
    print("skipped: node is missing (Debian: nodejs)")
    sys.exit(77)
# Node 18 has no global CustomEvent, without which the page's scripts waited for ever; page_dom.mjs gives it, and is not tried there yet.
if int(subprocess.run([NODE, "--version"], capture_output=True, text=True, check=True).stdout.lstrip("v").split(".")[0]) < 20:
    print("skipped: node 20 or later is required")
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
WEB = CASES.parent / "page" / "web"
RPM = 30 / math.pi
SCHEMA = json.loads((CASES / "result.schema.json").read_text(encoding="utf-8"))
POINT = {**SCHEMA["$defs"]["sweep"]["properties"]["points"]["items"]["properties"], **SCHEMA["$defs"]["run sweep"]["properties"]["points"]["items"]["properties"]}
KEYS = [key for key, part in POINT.items() if "number" in part["type"] and key not in ("input_speed_rpm", "rim_over_module")] + ["rim_over_module"]
SPEED, LOW, HIGH, SPEEDS = 9000.0, 8000.0, 10000.0, 60
CASE = """name: reducer of the page
source: tests
model: planetary-drivetrain
input: {power: 150 kW, speed: 9000 rpm}   # the operating point
sweep:
  input.speed: [8000 rpm, 9000 rpm, 10000 rpm]
gearset:
  planets: 4
  teeth: {sun: 37, planet: 22, ring: 79}
  module: 3 mm
  profile_shift: {sun: 0.2618, ring: 0.4146}
  face_width: 28 mm
bearing:
  type: cylindrical-roller
  per_planet: 2
  rollers: 15
  roller_diameter: 5.24 mm
  roller_length: 5.7 mm
  pitch_diameter: 35.64 mm
  radial_clearance: 10 um
  bore: 25 mm
  outside_diameter: 47 mm
  width: 11.9 mm
  cage: {inner_diameter: 33.44 mm, outer_diameter: 38.54 mm, width: 9 mm, density: 1310 kg/m3, guide_land_diameter: 38.88 mm}
lubricant: {viscosity: 0.01 Pa.s, pressure_viscosity: 1.5e-8 Pa-1}
life: {method: lundberg-palmgren}
requirements: {S0: 1.5, kappa: 1000}
"""
OTHER = CASE.replace("power: 150 kW", "power: 0.123456789012345 MW")
ROLLER = 15


def value_of(key, speed, which=0):
    """As page_dom.mjs makes them."""
    k = KEYS.index(key)
    return (k + 2) ** 2 * (1 + speed / 20000) * (1 + 0.1 * which * (1 + k / 500))


def speeds_of(low, high, count=SPEEDS):
    return [float(f"{low + (high - low) * i / (count - 1):.5g}") for i in range(count)]


@functools.cache
def check_of(text):
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place) / "case.yaml"
        file.write_text(text, encoding="utf-8")
        done = run("check", file, "--json")
        if done.returncode:
            return {"errors": [line.replace(str(file), "case.yaml") for line in done.stderr.splitlines()]}
        return {"check": json.loads(done.stdout)}


def rounded(number, places):
    return format(number.quantize(decimal.Decimal(1).scaleb(-places), decimal.ROUND_HALF_UP), "f")


def readable(value, digits=4):
    """A number as the page shows it: significant digits, thousands apart, the sign of a minus."""
    if value is None:
        return "–"
    if value == 0:
        return "0"
    size = abs(value)
    exact = decimal.Decimal(value)  # a half is rounded up
    if size >= 1e7 or size < 1e-3:
        power = exact.adjusted()
        mantissa = rounded(exact.scaleb(-power), digits - 1)
        if mantissa.lstrip("-").startswith("10"):
            mantissa, power = rounded(exact.scaleb(-power - 1), digits - 1), power + 1
        return mantissa.replace("-", "−") + "·10" + "".join("⁻" if c == "-" else "⁰¹²³⁴⁵⁶⁷⁸⁹"[int(c)] for c in str(power))
    places = max(0, digits - 1 - math.floor(math.log10(size)))
    text = rounded(exact, min(places, 12))
    whole, _, part = text.partition(".")
    whole = re.sub(r"\B(?=(\d{3})+$)", "\u202f", whole)
    part = part.rstrip("0")
    return (whole + (f".{part}" if part else "")).replace("-", "−")


def name_of(key, unit):
    """"inner_load_max_N" -> "inner load max"."""
    end = "_" + unit.replace(".", "_").replace("/", "_per_")
    stem = key.removesuffix(end) if unit != "1" else re.sub(r"_(rpm|N|h|um|mm|MPa|Mrev|W|Hz|mrad|deg|us|N_m|N_per_m|N_s_per_m|kg|kW|s|m_s2)$", "", key)
    return stem.replace("_", " ")


def label_of(key):
    part = POINT.get(key, {})
    if "symbol" in part:
        return part["symbol"]
    if re.fullmatch(r"(system_)?(L10\w*h|life_h)", key):
        return key.replace("system_", "system ").replace("life_h", "life (Lundberg-Palmgren)")
    return name_of(key, part.get("unit", ""))


SIGNS = {"1": "", "um": "µm", "N.m": "N m", "degree": "°", "deg": "°"}


def figure_of(value, unit="", digits=4):
    sign = SIGNS.get(unit, unit)
    return readable(value, digits) + (f" {sign}" if sign and value is not None else "")


VERDICTS = [
    {"requirement": "life", "value": 6.55, "limit": 100.0, "passed": False, "key": "L10mrh", "unit": "h", "bound": "at least", "at": "input_speed_rpm = 9000",
     "reason": "", "points": 1, "points_failed": 1},
    {"requirement": "S0", "value": 7.25, "limit": 1.5, "passed": True, "key": "S0", "unit": "", "bound": "at least", "at": "input_speed_rpm = 9000", "reason": "",
     "points": 1, "points_failed": 0},
    {"requirement": "load_share", "value": None, "limit": 1.3, "passed": None, "key": "largest_load_share", "unit": "", "bound": "at most", "at": "",
     "reason": "all planets carry the same load", "points": 1, "points_failed": 0}]
OVER_SPEEDS = [{**VERDICTS[0], "passed": False, "value": 5.5, "points": 60, "points_failed": 60},
               {**VERDICTS[1], "passed": False, "value": 1.125, "points": 60, "points_failed": 17, "at": "input_speed_rpm = 10000"}]
ROLLERS = [{"set": "", "angle_deg": [360 * j / ROLLER for j in range(ROLLER)], "inner_load_N": [1000.5 + 31 * j for j in range(ROLLER)],
            "outer_load_N": [700.25 + 29 * j for j in range(ROLLER)], "along_mm": [-2.0, -1.0, 0.0, 1.0, 2.0], "inner_pressure_MPa": [1011.0, 1022.0, 1044.0, 1033.0, 1001.0],
            "outer_pressure_MPa": [811.0, 822.0, 844.0, 833.0, 801.0]}]
UNITS = {"rest_a": "N", "rest_b/inner": "mm"}
RUN = {"peak": {"life_key": "L10mrh", "speed_rpm": SPEED, "life_h": 6.55}, "verdicts": VERDICTS, "roller_loads": ROLLERS, "warnings": ["a warning of the run"], "units": UNITS,
       "assumptions": []}
SWEEP = {"peak": {"life_key": "L10rh", "speed_rpm": 8400.0, "life_h": 77.0}, "verdicts": OVER_SPEEDS,
         "spectrum": None, "units": {}}
MODES = [{"kind": "rotational", "multiplicity": 1, "frequency_Hz": 1100.0, "shape": [[0.11, 0.12, 0.13]] * 3 + [[0.21, 0.22, 0.23]] * 4, "shape_quarter": [[0.0, 0.0, 0.0]] * 7},
         {"kind": "translational", "multiplicity": 2, "frequency_Hz": 2300.0, "shape": [[0.31, 0.32, 0.33], [0.41, 0.42, 0.43], [0.51, 0.52, 0.53]] + [[0.61, 0.62, 0.63]] * 4,
          "shape_quarter": [[0.07, 0.08, 0.09]] * 7},
         {"kind": "rigid", "multiplicity": 1, "frequency_Hz": 0.0, "shape": [[0.0] * 3] * 7, "shape_quarter": [[0.0] * 3] * 7},
         {"kind": "planet", "multiplicity": 1, "frequency_Hz": 3700.0, "shape": [[0.0, 0.0, 0.0]] * 3 + [[0.71, 0.72, 0.73]] * 4, "shape_quarter": [[0.0, 0.0, 0.0]] * 7}]
MESH = {"meshes": [{"name": f"{kind} {i}", "contact_ratio": 1.5 + 0.1 * n + 0.01 * i, "mean_N_per_m": (3.1 + n) * 1e8 + i, "min_N_per_m": (2.2 + n) * 1e8 + i, "max_N_per_m": (4.3 + n) * 1e8 + i,
                    "curve": [[0.0, (3.0 + n) * 1e8], [0.5, (4.0 + n) * 1e8], [1.0, (2.5 + n) * 1e8]]} for n, kind in enumerate(("sun-planet", "ring-planet")) for i in (1, 2)]}
CROWN = {"laminae": 41, "life_key": "L10mrh", "in_run": {"life_key": "L10mrh", "case_h": 21234.0, "recommended_h": 22345.0},
         "recommended": {"drop_um": 6.5, "least_drop_um": 3.25, "most_drop_um": 9.75, "half_space_life_h": 41234.0, "life_h": 50321.0, "governing_life_h": 40123.0, "peak_pressure_MPa": 1717.0,
                         "rollers": "crowned", "profile": "iso16281", "curve": [{"drop_um": 0.0, "life_share": 0.7}, {"drop_um": 6.5, "life_share": 1.0}, {"drop_um": 12.0, "life_share": 0.8}]},
         "optimum": {"drop_um": 1.0}, "straight": {"half_space_life_h": 31234.0, "life_h": 50123.0, "governing_life_h": 30123.0, "peak_pressure_MPa": 1919.0},
         "points": [{"drop_um": drop, "life_h": 51000.0, "governing_life_h": life, "peak_pressure_MPa": pressure}
                    for drop, life, pressure in ((12.0, 33000.0, 1750.0), (0.0, 30000.0, 1900.0), (6.0, 40000.0, 1700.0), (3.0, None, None))]}
SENSITIVITIES = {"inputs": [{"path": "life.reduction_factor", "elasticity": 4.25}, {"path": "material.density", "elasticity": -8.5}, {"path": "bearing.rings", "elasticity": None}]}
RESULTS = {"run": RUN, "sweep": SWEEP, "mode_list": MODES, "mesh": MESH, "crown": CROWN, "sensitivities": SENSITIVITIES, "nulls": {}}


def page(steps, texts=(CASE,), opened=None, results=None, narrow=False, **more):
    """What the page shows and asks for in these steps. Of `texts`, those that are checks already are {"text", "check" or "errors"}."""
    checks = [{"speed": SPEED, **({"text": one, **check_of(one)} if isinstance(one, str) else one)} for one in texts]
    fixture = {"web": str(WEB), "schemas": str(CASES), "keys": KEYS, "steps": steps, "narrow": narrow, "units": {}, "results": {**RESULTS, **(results or {})},
               "opened": opened or {"kind": "case", "name": "case.yaml", "file": "case.yaml", "text": checks[0]["text"], "checksum": "as opened", "writable": True, "folder": "/x"},
               "checks": checks, **more}
    done = subprocess.run([NODE, str(HERE / "page_dom.mjs")], input=json.dumps(fixture), capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert not found["failures"], found["failures"]
    return found


def dump(name="end", **more):
    return {"what": "dump", "name": name, **more}


def click(selector):
    return {"what": "click", "selector": selector}


def put(selector, value, event="change"):
    return {"what": "set", "selector": selector, "value": value, "event": event}


def text_put(text):
    return put("#yaml", text, "input")


def cursor_put(rpm):
    return put("#cursor", str(round(1000 * (rpm - LOW) / (HIGH - LOW))), "input")
