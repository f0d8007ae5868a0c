"""Arguments for functions of the page's scripts that need no document (page_functions.mjs): case files in all ways of writing, numbers, units, a schema."""

TEXTS = ["", "\n\n", "# a comment alone\n", "---\na: 1\n", "a: 1", "a: 1\n", "a: 1\r\nb: 2\r\n", "\n# before\n\na: 1  # behind\n# between\nb: 2\n\n\n", "a:\nb:\n  c:\n", "a: {}\n", "a: []\nb: 1\n", "a: {b: 1}\n", "a: {b: 1, c: {d: 2, e: [3, 4]}}\n",
         "a: {b: , c:}\n", "a: {b: 1,}\n", "a: { b : 1 , 'c d': 2, \"e\": x y }  # c\n", "a: {  # c\n  b: 1,  # d, e: 2\n  c: 2\n}\nk: 3\n", "a: [1, [2, 3], {b: 4}, x y, 'z, z']\n", "a: [1, 2, ]\n", "list:\n- 1\n- 2\nb: 3\n", "list:\n  - a: 1\n    b: 2\n  - c\n  - \n  -\n    d: 4\n    e: 5\n  - - f\n    - g\n  - {h: 1}\n",
         "a:\n  b:\n    c: 1\n    # of c\n    d: 2\n  e: 3\nf: 4\n", "a:\n    b: 1\n    c: 2\n", "a: first\n  second\n   third # c\nb: 1\n", "a: |\n  one\n    two\n\n  three\nb: 1\n", "a: >\n  one\n  two\nb: 1\n", "a: |\n\n  one\n", "a: \"x\\\"y\\\\z\\n\\t\\x41\\u00e9\\e\\0\\q\"\nb: 'it''s'\nc: ''\nk: \"\"\n",
         "\"a b\": 1\n'c''d' : 2\n? x\n", "-a: 1\n- b\n", "a b c: 1\n$x: 2\n", "a: -5 mm\nb: -x\nc: .5\n", "a: 1 #b\nc: 2#d\n", "a: x:y\nb: http://c\n", "a: 'x' # c\nb: \"y\"\n", "a:\n  - 1\n  -  2\nb:\n  c: [1]\n",
         "  a: 1\n  b: 2\n", "a: 1\n   b: 2\n", "a: 1\nwords\n", "a: b: c\n", "a: [1 2: 3]\n", "a: [1 {b: 2}]\n", "\ta: 1\n", "a:\n \tb: 1\n", "a:\n  b: 1\n c: 2\n", "a: &x 1\n", "a: *x\n", "a: !x 1\n", "a: {b: &x 1}\n", "a: [*x]\n", "a: 'x\n", "a: \"x\\\"\n", "a: {b: 'x}\n", "a: [1, 2\n", "a: {b: 1\n", "a: {b 1}\n",
         "a: {b: 1} c\n", "a: 'x' y\n", "a: [,]\n", "a: {: 1}\n", "words\n", "'words'\n", "- 1\n- 2\n", "{a: 1}\n", "[1, 2]\n", "a: 1\n---\nb: 2\n", "a: 1\n- b\n", "a:\n- b: 1\n  c: 2\n- d: 3\ne: 4\n", "a: x\n\n  y\nb: 2\n", "a:\n  b: x\n    y\n  c: 1\n", "new:\n  deep: 1\nz: 1\n", "new: {deep: 1}\n", "new: 5\n", "new: [1, 2]\n",
         "b: 1\nk: 2\nf:\n  b: 1\n  k: 2\n", "b: 1\nf:\n  b: 1\n\n  # of d\n  k: 2\n\n# at the end\n", "f: {b: 1, d: 2}\nb: 1\n", "a: {b: {c: 1}}\n", "a:\n  b: {c: 1}\n", "a:\n  b:\n    c:\n      d: 1\ne: 1\n", "x: {y: [\n  1,\n  2\n]}\nz: 1\n", "a:\n  - {b: 1,\n     c: 2}\n  - d\n", "a: x, y\nb: {c: x y z}\n",
         "a: \"x\ny\"\nb: 1\n", "a:   1\nb  : 2\n", "a: 1\n\n\n", "a:\n  b: 1\n\n\nc: 2", "a: |\n  x\n\n\n# c\nb: 1\n", "a:\n    - 1\n    - 2\n  \nb: 1\n",
         "a:\n  b: 1\n  words\nc: 1\n", "a: [1,\n 2] c\n", "  words\n", "  words\n  more\n", "\"a b\": 1\n'c''d' : 2\n", "list:\n  - c\n   d\n  - e\n", "a: |\nb: 1\n", "a:   [1,\n  2]\nb:   {c: 1,\n  k: 2}\n", "a:\n  b: 1\n# of c\n  c: 2\nk: 3\n", "a:\n  - b\n# of c\n  - c\n"]
SOURCES = ["12 mm", "b: 1\nc: 2", "- 1\n- 2", "[3, 4]", ""]
ORDERS = [["a", "added", "b", "new", "c", "d", "f", "list", "z"], ["b", "added", "c", "d"], ["added", "c"], []]
WORDS = ["a", "", " a", "a ", "a: b", "a:", "a #b", "a#b", "- a", "-", "-5 mm", "-x", "-a: b", ".5 mm", "?x", ":x", ",x", "[a", "{", "}", "#", "&a", "*a", "!a", "|", ">", "'x", "\"x", "%x", "@x", "`x", "yes", "No", "on", "off", "null", "~", "a\nb\tc\x01\r\x1f", "a \"b\" \\c", "1", "-1", "+1.5e3", "1.5e-3",
         "1.", ".5", "true", "False", "0x1F", "0xg", ".inf", ".NaN", "-.inf", "a, b", "a]b", "a{b", "NU 204", "5 % of it", "1 mm", "a.b_c.d", "trailing_", "..x", "1e", "--1", "\x00", "\n"]
NUMBERS = [0, 1, -1, 9.9994, 9.9995, 9.99949, 99.995, 999.95, 1234.5, 12345.6, 99999.5, 123456, 1234567, 9999999, 9999999.5, 1e7, 12345678, -1e7, 1.5e10, 1e21, 1e100, 0.1, 0.12345, 0.012345, 0.0012345, 0.001, 0.00099999, 0.000999999, 1e-3 - 1e-9, 1.234e-5, -1.234e-5, 1e-100, 2.5, 0.5, 100, 1000,
           -1234.5, 1.0005, 1.00049, 0.30000000000000004, 5.2399999999999998, 1e6, 123.456789, 8.8888888, 65536.125, 3]
QUANTITIES = ["5.2399999999999998 mm", "5.24 mm", "150 kW", "-20 degC", "+1.5e3 N", "1e-9 mm", "1.23456789e-12 m", "[1.23456789 mm, 2]", "{a: 1.23456789}", "words 1.23456789", "3,5 mm", "3.5.6", "12mm", " 7  rpm ", "7", ".5 mm", "-.5", "5.", "5. mm", "1e5", "1E+5 Pa", "e5", "", "NU 204", "0.000123456789 m", "0.00012345678 m",
              "1234567.8 N", "123456.7 N", "5 % of it", "-", "+", "1 2", "1 .5", "1 a5"]
SPANS = [(0, 1, 5), (0, 10, 5), (0, 0.37, 5), (-3, 7, 5), (-1e-9, 1e-9, 4), (8000, 10000, 8), (8000, 10000, 2), (999.99, 1000.01, 3), (5, 5, 3), (6, 5, 3), (1e6, 5e6, 5), (0.1, 0.7, 3), (-50, -10, 4), (0, 1.05, 5), (1, 2, 100), (0, 2.4999, 5), (0, 2.5, 5), (0, 2.5001, 5), (0.3, 0.9, 6), (-0.0, 3, 3)]
KEYS = [["inner_load_max_N", "N"], ["moment_N_m", "N.m"], ["k_N_per_m", "N/m"], ["speed_rpm", "rpm"], ["L10h", "h"], ["system_L10mrh", "h"], ["life_h", "h"], ["system_life_h", "h"], ["L10r_Mrev", "Mrev"], ["cage_slip", "1"], ["share", ""], ["x_mm", "um"], ["t_us", "us"], ["a_m_s2", "m/s2"], ["rate_per_s", "1/s"], ["of_s", "s"],
        ["contact_pressure_max_MPa", "MPa"], ["kappa", "1"], ["a_W_b", "W"], ["mass_kg", "kg"], ["angle_deg", "deg"], ["angle_mrad", "mrad"], ["power_kW", "kW"], ["f_Hz", "Hz"], ["d_N_s_per_m", "N.s/m"], ["film_inner_um", "um"], ["odd_", ""], ["odd_1", "1"]]
PARTS = [["run", {"L10h": 1, "S0": 2}], ["run", {"points": []}], ["run", {"modes": [], "pair": {}}], ["run", {"film": []}], ["run", {}], ["mesh", {"meshes": []}], ["modes", {"modes": []}], ["modes", {"tilt": 1, "axial": 1}], ["none", {"a": 1}], ["run", {"defect": 1, "shaft_Hz": 2, "defect_Hz": 3}]]
ROWS = [{"a": 1, "b": "x, y", "c": None}, {"a": 0.1, "d": "q\"q", "b": "line\nline"}, {"c": 5, "a": 1e-9}]
SESSIONS = [{"overSpeed": over, "model": model, "file": file, "fidelity": fidelity, "setting": setting} for over, model, file, fidelity, setting in (
    (True, "planetary-drivetrain", "case.yaml", "quasi-static", ["input.speed=9000 rpm"]), (True, "planetary-drivetrain", "my case.yaml", "dynamic", []), (False, "gear-pair", "it's.yaml", "dynamic", ["a=b", "c=d e"]),
    (False, "roller-bearing", "a/b-c_1.yml", "quasi-static", []), (False, "planetary-drivetrain", "x=y.yaml", "quasi-static", []))]
LINES = ["case.yaml:12:4: gearset.module: found 3; required: 4", "a/b c.yml:1:2: key: text: more\nand more", "--set: input.speed: found x", "--set: input.speed found x", "words", "case.yaml:12: x: y", "case.txt:1:2: x: y", "", "x: y: z"]
CHECKS = [None, {}, {"warnings": ["a.b: 3 has no effect: c", "a.b: 3 has no effect here", "a.b has no effects", "words"]}]
ROLLING = [[{"element": 5.24, "pitch": 35.64}, 100, 0], [{"element": 5.24, "pitch": 35.64}, 0, 100], [{"element": 5.24, "pitch": 35.64}, 30, -70, 0.125], [{"element": 10, "pitch": 20}, 7, 11, 1]]
GEARS = [{"teeth": 3, "shift": 0.25, "module": 3, "normal": 2.9, "pressure": 0.35, "internal": False, "tip": 7.5, "root": 2.5}, {"teeth": 5, "shift": -0.25, "module": 3, "normal": 3, "pressure": 0.4, "internal": True, "tip": 5.5, "root": 10.5},
         {"teeth": 40, "shift": 0, "module": 1, "normal": 1, "pressure": 0.35, "internal": False, "tip": 21, "root": 18.75}]
TEXT, LENGTH = "of the page (a text)", "how long; left out: a rule (a length like '5 mm', greater than 0)"
CASE_SCHEMA = {"$defs": {
    "model": {"required": ["name", "a"], "properties": {
        "name": {"type": "string", "description": TEXT}, "model": {"const": "model", "description": "of all"}, "any": True,
        "a": {"required": ["x", "b"], "properties": {"x": {"type": "string", "description": LENGTH, "minimum": 1, "exclusiveMinimum": 2, "maximum": 3, "exclusiveMaximum": 4, "default": "7 mm"}, "y": {"type": "string", "description": "a y, instead of x (an angular speed like '5 rpm')", "exclusiveMinimum": 2,
                              "exclusiveMaximum": 4}, "b": {"required": ["c"], "properties": {"c": {"type": "integer", "examples": list(range(11))}, "d": {"type": "number", "examples": list(range(10))}, "e": {"type": "boolean", "description": "whether (true or false)"}}},
                              "f": {"enum": ["u", "v"], "description": "which (one of u, v)"}, "g": {"type": "array", "description": "many (a list, each element a length like '3 um')"}, "h": {"description": "a table (a text of several lines)", "type": "string"}},
              "anyOf": [{"required": ["x"]}, {"required": ["y"]}], "allOf": [{"oneOf": [{"required": ["f"]}, {"required": ["g"]}, {"required": ["h"]}]}, {"anyOf": [{"required": ["x"]}, {"required": ["f"]}]}]},
        "open": {"patternProperties": {"^s[0-9]$": {"required": ["x"], "properties": {"x": {"type": "number"}}}, "^t": {"type": "string", "description": "t (a mass like '4 kg')"}}, "properties": {"s1": {"type": "string"}}},
        "sweep": {"properties": {"input.speed": {"type": "array"}, "a.x": {"type": "array"}}, "patternProperties": {"^a": {"type": "array"}}}, "assumed": {"properties": {"a.x": {"type": "string"}}}, "uncertain": {"properties": {"q": {"properties": {"low": {"type": "number"}}}}},
        "gearset": {"properties": {"teeth": {"type": "integer"}}}, "bearing": {"properties": {"type": {"enum": ["p"]}}}, "sets": {"patternProperties": {"^.*$": {"properties": {"gearset": {"properties": {"teeth": {"type": "integer"}}}}}}}},
        "oneOf": [{"required": ["a"]}, {"required": ["open"]}, {"required": ["q"], "properties": {}}]},
    "other": {"properties": {"k": {"type": "string", "description": "a (an inertia like '5 kg.m2')"}}, "oneOf": [{"required": ["k"]}, {"required": ["l"]}], "anyOf": [{"required": ["k"]}, {"required": ["m"]}]}, "bare": {}}}
MODELS = [["model", "a: {x: 1}\n"], ["model", "open: {s1: 1, s2: {x: 2}, t5: 1, z: 1}\nsweep: {a.x: [1], ab: 2, q: 1}\nuncertain: {q: {low: 1}}\nassumed: {a.x: 1}\n"], ["model", "sets: {one: {gearset: {teeth: 3}}, two: {}}\nbearing: {type: p}\n"], ["model", "x: 1\n"], ["other", "k: 1\n"], ["bare", "k: 1\n"], ["none", "k: 1\n"]]
PATHS = [[], ["a"], ["a", "x"], ["a", "y"], ["a", "b"], ["a", "b", "c"], ["a", "f"], ["a", "g"], ["a", "h"], ["open"], ["open", "s1"], ["open", "s2"], ["open", "s2", "x"], ["open", "t5"], ["k"], ["l"], ["m"], ["none", "x"], ["sets", "one", "gearset"], ["sweep"]]


def arguments(web, result_schema):
    return {"web": str(web), "texts": TEXTS, "sources": SOURCES, "orders": ORDERS, "most_paths": 40, "words": WORDS, "numbers": NUMBERS, "quantities": QUANTITIES, "spans": SPANS, "keys": KEYS, "parts": PARTS, "rows": ROWS, "sessions": SESSIONS, "lines": LINES,
            "checks": CHECKS, "rolling": ROLLING, "gears": GEARS, "schema": result_schema, "case_schema": CASE_SCHEMA, "models": MODELS, "paths": PATHS}
