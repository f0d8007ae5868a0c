#!/usr/bin/env python3
"""What tools/mutation draws and how it writes an error beside the right statement; nothing is built.

Needs the source folder in ORBEARING_SOURCE_DIR.
"""

import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2])).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(SOURCE / "tools"))
from mutants import beside, draw, glue, page_trial  # noqa: E402
from mutants.results import Results  # noqa: E402
from mutants.trial import Running, with_error  # noqa: E402
from mutants.trial import run as run_within  # noqa: E402

TEXTS = {name: (SOURCE / name).read_text(encoding="utf-8") for name in draw.PHYSICS.sources(SOURCE)
         if name.startswith(("gearset/dynamics/e", "gearset/dynamics/f", "bearing/contact/f", "bearing/geometry"))}


def drawn(texts: dict[str, str], seed: int) -> list[draw.Mutant]:
    return list(itertools.islice(draw.PHYSICS.draw(texts, seed), 60))


DRAWN = drawn(TEXTS, 1)

# One line for each kind, and what each of its errors makes of it.
LINES = {
    "sign of a term": ("return -stiffness * x;", {"return stiffness * x;"}),
    "plus for minus": ("return a + b;", {"return a - b;"}),
    "times for divided by": ("f = force / length;", {"f = force * length;"}),
    "factor of two left out": ("w = 0.5 * k * x;", {"w = k * x;"}),
    "factor of two too many": ("w = k * x;", {"w = k * 2.0 * x;"}),
    "sine and cosine": ("return std::sin(angle);", {"return std::cos(angle);"}),
    "exponent": ("c = std::pow(load, 1.5);", {"c = std::pow(load, 1.5 + 1.0);"}),
    "less and greater": ("if (x <= least) x = least;", {"if (x >= least) x = least;"}),
    "smallest and largest": ("x = std::max(x, least);", {"x = std::min(x, least);"}),
    "index off by one": ("for (int i = 0; i < n; ++i) s += x[i - 1];",
                         {"for (int i = 1; i < n; ++i) s += x[i - 1];", "for (int i = 0; i < n; ++i) s += x[i];"}),
    "term left out": ("return load - mass * pull(x);", {"return load;"}),
    "constant wrong by 10 %": ("return std::pow(u, 0.7);", {"return std::pow(u, 0.77);"}),
    "inner and outer": ("r = at(Race::inner);", {"r = at(Race::outer);"}),
    "and, or, not": ("if (a && !b) c = d;", {"if (a || !b) c = d;", "if (a && b) c = d;"}),
    "radius and diameter": ("d = pitch_diameter;", {"d = pitch_radius;"}),
    "other direction": ("f = force.x();", {"f = force.y();"}),
    "sun and ring": ("k = sun_mesh.stiffness;", {"k = ring_mesh.stiffness;"}),
    "sum and mean": ("return loads.mean();", {"return loads.sum();"}),
}


class Draw(unittest.TestCase):
    def test_each_kind_makes_its_errors(self):
        self.assertEqual(set(LINES), {kind for kind, _, _ in draw.KINDS})
        for kind, (line, changed) in LINES.items():
            made = {mutant.after for mutant in draw.PHYSICS.mutants_of("x.cpp", line) if mutant.kind == kind}
            self.assertEqual(made, changed, kind)

    def test_lines_that_compute_nothing_have_no_errors(self):
        for line in ("// a + b", "#include <a + b>", 'require(a > b, "a", a, "more than b");', "  throw Refused(a + b);",
                     "namespace a::b { x + y; }", "double radius(double inner_radius, double outer_radius);"):
            self.assertEqual(draw.PHYSICS.mutants_of("x.cpp", line), [], line)

    def test_the_draw_follows_from_seed_and_sources(self):
        self.assertEqual(drawn(TEXTS, 1), DRAWN)
        other = drawn(TEXTS, 2)
        self.assertLess(len({mutant.key for mutant in DRAWN} & {mutant.key for mutant in other}), 30)

    def test_each_kind_is_drawn_as_often_as_its_places_allow(self):
        there_are = {mutant.kind for name, text in TEXTS.items() for mutant in draw.PHYSICS.mutants_of(name, text)}
        self.assertGreater(len(there_are), 12)
        round_of_kinds = [mutant.kind for mutant in DRAWN[:len(there_are) - 2]]  # two may have no place left beside the others
        self.assertEqual(len(set(round_of_kinds)), len(round_of_kinds))

    def test_an_error_changes_one_line_and_no_other(self):
        for mutant in DRAWN:
            whole = TEXTS[mutant.file]
            before, after = whole.splitlines(), with_error(whole, mutant).splitlines()
            differ = [number for number, pair in enumerate(zip(before, after, strict=True), 1) if pair[0] != pair[1]]
            self.assertEqual(differ, [mutant.line], mutant)
            self.assertNotEqual(mutant.before, mutant.after)
            self.assertEqual(draw.code_of(after[mutant.line - 1]).strip() or mutant.after, mutant.after)

    def test_a_line_more_leaves_the_draw_as_it_is(self):
        moved = TEXTS | {"bearing/geometry.cpp": "\n\n" + TEXTS["bearing/geometry.cpp"]}
        self.assertEqual([mutant.key for mutant in drawn(moved, 1)], [mutant.key for mutant in DRAWN])


# One line of glue for each kind, in C++ or Python, and what each of its errors makes of it.
GLUE_LINES = {
    ".cpp": {
        "unit factor": ('{"tilt_mrad", 1e3 * tilt},', {'{"tilt_mrad", 1.0 * tilt},'}),
        "other key": ('{"life_h", life, "system_life_h"}', {'{"system_life_h", life, "system_life_h"}', '{"life_h", life, "life_h"}'}),
        "label or unit": ('text += "life (h)";', {'text += "life (s)";'}),
        "negated condition": ("if (converged) return result;", {"if (!(converged)) return result;"}),
        "member swapped": ("v = sums.rms + sums.max;", {"v = sums.max + sums.max;", "v = sums.rms + sums.rms;"}),
        "smallest and largest": ("return *std::min_element(a, b);", {"return *std::max_element(a, b);"}),
        "and, or, not": ("if (a && !b) c = d;", {"if (a || !b) c = d;", "if (a && b) c = d;"}),
        "inner and outer": ('{"inner_life", life(outer)},', {'{"outer_life", life(outer)},', '{"inner_life", life(inner)},'}),
    },
    ".py": {
        "unit factor": ("axes.plot(1e3 * time, np.degrees(angle))", {"axes.plot(1.0 * time, np.degrees(angle))",
                                                                     "axes.plot(1e3 * time, (angle))"}),
        "other key": ('table(row["life_h"], row["share"])', {'table(row["share"], row["share"])', 'table(row["life_h"], row["life_h"])'}),
        "label or unit": ('label = f"{speed} rpm, 5 and 95 %"', {'label = f"{speed} rad/s, 5 and 95 %"', 'label = f"{speed} rpm, 25 and 75 %"',
                                                                'label = f"{speed} rpm, 5 and 95 ‰"'}),
        "negated condition": ("x = a if b is None else c", {"x = a if not (b is None) else c", "x = a if b is not None else c"}),
        "member swapped": ("v = one.first + one.second", {"v = one.second + one.second", "v = one.first + one.first"}),
        "sorted the other way": ("order = np.argsort(-share)", {"order = np.argsort(share)"}),
        "sum and mean": ("total = np.nansum(load)", {"total = np.nanmean(load)"}),
        "less and greater": ("if a <= b: pass", {"if a >= b: pass"}),
        "index off by one": ("x = rows[0] + path[-1]", {"x = rows[1] + path[-1]", "x = rows[0] + path[-2]"}),
        "smallest and largest": ("x = np.nanmax(load)", {"x = np.nanmin(load)"}),
    },
}


class Glue(unittest.TestCase):
    def test_each_kind_makes_its_errors(self):
        for end, lines in GLUE_LINES.items():
            for kind, (line, changed) in lines.items():
                text = f"{line}\n# inner outer outer_life"  # other members that the file knows
                made = {mutant.after for mutant in glue.GLUE.mutants_of("x" + end, text) if mutant.kind == kind}
                self.assertEqual(made, changed, f"{end} {kind}")

    def test_comments_texts_and_figures_looks_have_no_errors(self):
        for name, line in (("x.cpp", "// a + b"), ("x.cpp", '#include "inner/x.hpp"'), ("x.py", '"""inner and outer race."""'), ("x.py", "# a and b"),
                           ("x.py", 'text = "the inner race and the outer"'), ("x.py", "figure = Figure(figsize=(3 * wide, 2))")):
            self.assertEqual([mutant.after for mutant in glue.GLUE.mutants_of(name, line)], [], line)

    def test_what_is_put_in_anothers_place_stands_in_the_file(self):
        self.assertEqual([mutant.after for mutant in glue.GLUE.mutants_of("x.cpp", "v = one.radial_clearance;") if mutant.kind == "member swapped"], [])

    def test_all_four_folders_and_both_languages_are_drawn_from(self):
        """Seed 44 was fixed before the tests that were to find its errors."""
        texts = {name: (SOURCE / name).read_text(encoding="utf-8") for name in glue.GLUE.sources(SOURCE)}
        errors = list(itertools.islice(glue.GLUE.draw(texts, 44), 60))
        for folder in glue.GLUE.folders:
            self.assertTrue(any(mutant.file.startswith(folder) for mutant in errors), folder)
        self.assertGreater(sum(mutant.file.endswith(".py") for mutant in errors), 15)


PAGE_TEST = """import os, pathlib, subprocess, sys
page = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"]) / "page" / "web"
said = subprocess.run(["node", str(page / "shown.mjs")], capture_output=True, text=True).stdout
if said.strip() != "7":
    print("FAIL: test_what_is_drawn", file=sys.stderr)
    sys.exit(1)
"""


class PageScripts(unittest.TestCase):
    """Errors in the page's scripts stay in them, and the page's own test judges them."""

    @unittest.skipUnless(shutil.which("node"), "node is missing (Debian: nodejs)")
    def test_an_error_is_found_in_a_copy(self):
        with tempfile.TemporaryDirectory() as folder:
            root, home = pathlib.Path(folder) / "root", pathlib.Path(folder) / "home"
            web, tests = root / "page" / "web", root / "tests" / "interface"
            for place in (web, tests, home):
                place.mkdir(parents=True)
            right = "const a = 3; const b = 4; const unused = a <= b;\nconsole.log(a + b);\n"
            (web / "shown.mjs").write_text("import './code.js';\n", encoding="utf-8")
            (web / "code.js").write_text(right, encoding="utf-8")
            (tests / "page_drawn.py").write_text(PAGE_TEST, encoding="utf-8")
            copies = page_trial.PageCopies(root, home, root / "build", 1)
            copies.measure(self.fail)
            def judged(line, before, after):
                at = right.splitlines()[line - 1].index(before)
                return copies.finder(draw.Mutant("kind", "page/web/code.js", line, at, at + len(before), "", "", after, 0))
            self.assertEqual(judged(2, "a + b", "a - b"), ("interface", "page_drawn.py: test_what_is_drawn"))
            self.assertEqual(judged(1, "a <= b", "a >= b"), ("none", ""))
            self.assertEqual(judged(2, "a + b", "a + +* b"), ("no program", ""))
            self.assertEqual((web / "code.js").read_text(encoding="utf-8"), right)
            self.assertNotEqual(judged(2, "a + b", "a * b"), ("none", ""))  # the copy is whole again, and takes the next one

    def test_a_draw_has_a_new_seed_and_can_be_repeated(self):
        def listed(*words, files=("*/rexs/s*.py", "page/web/s*")):  # of few files, since the draw reads all of them
            return subprocess.run([sys.executable, str(SOURCE / "tools" / "mutation"), "--glue", "--list", "--count", "20", "--files", *files, *words],
                                  capture_output=True, text=True, check=True).stdout
        before = int(time.time())
        first = listed()
        seed = re.match(r"errors in glue and figures, seed (\d+): --seed \1 goes on with this draw\n", first)[1]
        self.assertTrue(before <= int(seed) <= int(time.time()))  # the time of day
        self.assertEqual(listed("--seed", seed), first)
        self.assertNotEqual(listed("--seed", str(int(seed) + 1)).splitlines()[1:], first.splitlines()[1:])
        files = set(re.findall(r"^ *\d+  ([^:\s]+):\d+ ", first, re.MULTILINE))
        self.assertGreater(len(files), 1)
        self.assertTrue(all(file.startswith(("python/orbearing/rexs/s", "page/web/s")) for file in files), files)
        with self.assertRaises(subprocess.CalledProcessError) as raised:
            listed(files=["nowhere/*"])
        self.assertEqual(raised.exception.returncode, 2)


class Table(unittest.TestCase):
    def results(self, folder: str, sources: str = "sources", tests: str = "tests", listed=()) -> Results:
        return Results(pathlib.Path(folder) / "known.json", DRAWN[:8], 5, set(listed), lambda mutant: sources, tests)

    def test_what_is_no_error_gives_way_to_the_next(self):
        with tempfile.TemporaryDirectory() as folder:
            results = self.results(folder, listed=[DRAWN[3].key])
            self.assertEqual(results.pending(), [0, 1, 2, 4, 5])
            results.add(0, "unit", "a test", 1.0)
            results.add(1, "no program", "", 1.0)
            results.add(2, "none", "", 1.0)
            results.add(4, "regression", "another", 1.0)
            self.assertEqual(results.pending(), [5, 6])
            results.add(6, "same program", "", 1.0)
            results.add(7, "interface", "a third", 1.0)
            tally = results.table()["tally"]
            self.assertEqual([row["number"] for row in results.table()["errors"]], [0, 2, 4, 5, 7])
            self.assertEqual(list(tally.values()), [5, 4, 3, 1, 1, 1, 1, 1, 1, 1])

    def test_it_goes_on_where_it_was(self):
        with tempfile.TemporaryDirectory() as folder:
            first = self.results(folder)
            first.add(0, "unit", "a test", 1.0)
            first.add(1, "none", "", 1.0)
            self.assertEqual(self.results(folder).pending(), [2, 3, 4])
            self.assertEqual(self.results(folder, tests="more tests").pending(), [1, 2, 3, 4])
            self.assertEqual(self.results(folder, sources="other sources").pending(), [0, 1, 2, 3, 4])


class Ended(unittest.TestCase):
    """Commands end with all that they began."""

    # Begins a child that outlives it, says which, and waits.
    BEGINS = [sys.executable, "-c", "import subprocess, time; print(subprocess.Popen(['sleep', '600']).pid, flush=True); time.sleep(600)"]

    def assert_gone(self, process: int):
        for _ in range(200):
            state = pathlib.Path(f"/proc/{process}/stat")
            if not state.exists() or state.read_text().rpartition(")")[2].split()[0] == "Z":
                return
            time.sleep(0.05)
        self.fail(f"{process} still runs")

    def test_a_command_that_takes_too_long(self):
        code, said = run_within(self.BEGINS, 2.0)
        self.assertEqual(code, 124)
        self.assertTrue(said.endswith("did not end"), said)
        self.assert_gone(int(said.split()[0]))

    def test_all_when_told_to_end(self):
        running = Running()
        with self.assertRaises(KeyboardInterrupt), running.of(self.BEGINS) as process:
            child = int(process.stdout.readline())
            running.end_all()
            process.communicate()
        self.assert_gone(child)
        with self.assertRaises(KeyboardInterrupt), running.of(["true"]):
            self.fail("began after the end")


class Beside(unittest.TestCase):
    def ways(self, text: str, wrong: str, fresh: str) -> list[str]:
        begin = text.index(wrong)
        return [text[:first] + written + text[last:]
                for first, last, written in beside.forms(text, begin, begin + len(wrong), fresh, 7)]

    def test_a_statement_is_written_twice(self):
        statement, expression = self.ways("void f() {\n  x = a +\n      b;\n}\n", " +", " -")
        self.assertEqual(statement,
                         "void f() {\n  { if (orbearing_mutants::acts(7)) { x = a - b; } else { x = a + b; } }\n\n}\n")
        self.assertEqual(expression, "void f() {\n  x = (orbearing_mutants::acts(7) ? (a - b) : (a + b))\n;\n}\n")

    def test_a_condition_an_initialiser_and_a_constant_choose(self):
        self.assertIn("if (orbearing_mutants::acts(7) ? bool(a > b) : bool(a < b)) {",
                      self.ways("{ if (a < b) { x = 1; } }", " < ", " > ")[0])
        self.assertEqual(self.ways("A(double b) : x_(b + c) {}", " + ", " - "),
                         ["A(double b) : x_((orbearing_mutants::acts(7) ? (b - c) : (b + c))) {}"])
        self.assertEqual(self.ways("constexpr double kA = 0.5;", "0.5", "0.55")[0],
                         "const double kA = orbearing_mutants::acts(7) ? (0.55) : (0.5);")

    def test_a_format_is_written_twice_with_the_call_around_it(self):
        """A text with brackets and slashes is no code; fmt::format takes constants alone."""
        ways = self.ways('return {fmt::format("({}) // N", load), 1};', "N", "kN")
        self.assertEqual(ways[-1], 'return {(orbearing_mutants::acts(7) ? (fmt::format("({}) // kN", load)) : (fmt::format("({}) // N", load))), 1};')
        self.assertIn('fmt::format((orbearing_mutants::acts(7) ? ("({}) // kN") : ("({}) // N")), load)', ways[-2])

    def test_lines_keep_their_numbers(self):
        for number, mutant in enumerate(DRAWN):
            whole = TEXTS[mutant.file]
            begin = sum(len(line) for line in whole.splitlines(keepends=True)[:mutant.line - 1]) + mutant.begin
            end = begin + mutant.end - mutant.begin
            for first, last, text in beside.forms(beside.without_comments(whole), begin, end, mutant.fresh, number):
                self.assertEqual(text.count("\n"), whole.count("\n", first, last))
                self.assertIn(beside.acts(number), text)


class Equivalent(unittest.TestCase):
    def test_what_is_listed_stands_in_the_sources_and_has_a_reason(self):
        for entry in json.loads((SOURCE / "tools/mutants/equivalent.json").read_text()):
            text = (SOURCE / entry["file"]).read_text()
            self.assertIn((entry["kind"], entry["before"], entry["after"]),
                          [(mutant.kind, mutant.before, mutant.after) for subject in (draw.PHYSICS, glue.GLUE)
                           if pathlib.PurePath(entry["file"]).suffix in subject.kinds for mutant in subject.mutants_of(entry["file"], text)])
            self.assertGreater(len(entry["reason"]), 20)


if __name__ == "__main__":
    unittest.main()
