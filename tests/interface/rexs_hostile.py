#!/usr/bin/env python3
"""`orbearing convert`: files that are damaged, or made to do damage, end with exit code 2 and one line, and leave nothing behind.

RANDOM_FILES (150 if unset): how many files are damaged at random. The seed is that of the time, printed with each failure; FUZZ_SEED repeats it.
"""

import copy
import json
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import time
import unittest
import warnings
import zipfile

import program
import rexs_files

orbearing = program.package()
with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    import netCDF4  # noqa: F401  so that what it says of its libraries is no line of a command

from orbearing import terminal  # noqa: E402
from orbearing.errors import CaseError  # noqa: E402
from orbearing.rexs import convert, reading, sources  # noqa: E402
from orbearing.rexs.__main__ import main  # noqa: E402


class Hostile(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)
        self.out = self.place / "out"

    def write(self, name, content):
        file = self.place / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def refused(self, file, text, *options):
        """One line on standard error, and no folder."""
        result = program.within(main, file, "-o", self.out, *options)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertTrue(result.stderr.startswith(f"{file}:"), result.stderr)
        self.assertIn(text, result.stderr)
        self.assertFalse(self.out.exists())
        return result.stderr

    def data(self):
        return json.loads(rexs_files.planetary().json())


class Damaged(Hostile):
    def test_identities(self):
        for stated, shown in ((float("inf"), "inf"), (1.5, "1.5"), (True, "True"), ("1_0", "1_0"), (None, "None"), (-3, "-3"), ("\x1b[2J", "\\x1b[2J")):
            data = self.data()
            data["model"]["components"][1]["id"] = stated
            text = json.dumps(data, indent=1)
            line = text[:text.index('"id": ' + json.dumps(stated))].count("\n") + 1
            said = self.refused(self.write("a.rexsj", text), f"found the id '{shown}' of a component; a whole number is required")
            if stated is not True:  # the first "true" is an attribute's
                self.assertIn(f"a.rexsj:{line}:", said)
        self.refused(self.write("a.rexs", '<model version="1.4"><components>\n <component id="x" type="shaft"/></components></model>'), "a.rexs:2:2: found the id 'x'")

    def test_depth(self):
        self.refused(self.write("d.rexsj", '{"a":' * 3000 + "1" + "}" * 3000), "d.rexsj:1:501: found more than 100 brackets within each other")
        self.refused(self.write("d.rexs", '<model version="1.4"><components><component id="1" type="x"><attribute id="a">' + "<array>" * 5000 + "</array>" * 5000
                                + "</attribute></component></components></model>"), "found more than 100 elements within each other")

    def test_characters_and_numbers(self):
        text = rexs_files.planetary().json()
        self.refused(self.write("s.rexsj", text.replace("Planetenstufe", "Pl\\udc00")), "found half of a pair of UTF-16 in a text")
        self.refused(self.write("n.rexsj", text.replace('"floating_point": 10.0', f'"floating_point": {"9" * 5000}')), "found a number with more digits than can be read")
        self.refused(self.write("v.rexsj", text.replace('"1.4"', '"1.4\\u001b[2J"')), "(it states '1.4\\x1b[2J')")
        pair = program.within(main, self.write("p.rexsj", text.replace("Planetenstufe", "Pl\\ud83d\\ude00")), "-o", self.out)
        self.assertEqual(pair.returncode, 0, pair.stderr)

    def test_entities(self):
        self.refused(self.write("e.rexs", '<?xml version="1.0"?>\n<!DOCTYPE m [<!ENTITY a "b">]><model version="1.4"/>'), "e.rexs:2:13: found a document type declaration")

    def test_archives(self):
        with zipfile.ZipFile(self.place / "c.rexsz", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("a.rexs", rexs_files.planetary().xml())
        content = bytearray((self.place / "c.rexsz").read_bytes())
        content[200:260] = b"\xff" * 60  # of the packed data
        self.refused(self.write("c.rexsz", bytes(content)), "a ZIP file that cannot be read")

    def test_what_no_one_thought_of_is_bad_input(self):
        """The last net: no traceback, whatever fails."""
        file = self.write("a.rexs", rexs_files.planetary().xml())
        kept = convert.convert
        convert.convert = lambda *_: {}["key"]
        try:
            self.refused(file, "found a model that cannot be converted (KeyError: 'key')")
        finally:
            convert.convert = kept


class Packed(Hostile):
    """What stands beside the model in an archive is not unpacked into memory."""

    def archive(self, megabytes):
        file = self.place / "b.rexsz"
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("a.rexs", rexs_files.planetary().xml())
            archive.writestr("notes/größe.txt", "beside the model")
            with archive.open("pad.bin", "w", force_zip64=True) as member:
                for _ in range(megabytes):
                    member.write(b"\0" * (1 << 20))
        return file

    def run_of(self, file):
        result = program.within(main, file, "-o", self.place / "first", "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(program.run("run", self.place / "first" / "cases" / "planetenstufe_9" / "case.yaml", "-o", self.place / "run", "--quiet").returncode, 0)
        return self.place / "run"

    def test_a_member_of_600_MB(self):
        file = self.archive(600)
        said = self.refused(file, "found 600 MB beside the model in a ZIP file; at most 512 MB are packed again", "--results", self.run_of(file))
        self.assertIn("take the model 'a.rexs' out of the archive", said)

    def test_a_member_of_300_MB_is_copied_in_pieces(self):
        file = self.archive(300)
        run = self.run_of(file)
        code = ("import sys, resource; from orbearing.rexs.__main__ import main; code = main(sys.argv[1:]); "
                "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024); sys.exit(code)")
        done = subprocess.run([sys.executable, "-c", code, file, "-o", self.out, "--quiet", "--results", run], capture_output=True, text=True, check=False,
                              env={**os.environ, "PYTHONPATH": sys.path[0]})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLess(int(done.stdout.split()[-1]), 250)  # [MB]
        with zipfile.ZipFile(self.out / "b.rexsz") as archive:
            self.assertEqual(archive.namelist(), ["a.rexs", "notes/größe.txt", "pad.bin"])
            self.assertEqual(archive.read("notes/größe.txt"), b"beside the model")
            self.assertEqual(archive.getinfo("pad.bin").file_size, 300 << 20)


class Printed(Hostile):
    def test_texts_of_a_file_do_not_move_the_cursor(self):
        """As the C++ commands print them; JSON has them escaped too."""
        data = self.data()
        data["model"]["applicationId"] = "x\nall 40 cases passed\x9b2J"
        for component in data["model"]["components"]:
            component["name"] = "\x1b]0;title\x07\x1b[2J\u202e"
        file = self.write("e.rexsj", json.dumps(data))
        for options, escape in (((), "\\x1b]0;title\\x07\\x1b[2J\\u202e"), (("--json",), "\\u001b]0;title\\u0007\\u001b[2J\\u202e")):
            result = program.within(main, file, "-o", self.place / f"o{len(options)}", *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn(escape, result.stdout)
            for line in result.stdout.splitlines() + result.stderr.splitlines():
                self.assertEqual(line, terminal.printable(line))
        self.assertIn("x\\nall 40 cases passed\\x9b2J", (self.place / "o0" / "cases" / "0_title_2j" / "case.yaml").read_text(encoding="utf-8").replace("\\\\", "\\"))

    def test_printable(self):
        """The same texts as of printable() in C++ (tests/unit/app_case)."""
        for text, shown in (("a\x1b[2J", "a\\x1b[2J"), ("a\nb\tc\rd", "a\\nb\\tc\\rd"), ("\x7f\x9b", "\\x7f\\x9b"), ("\u202e\u2066\ufeff", "\\u202e\\u2066\\ufeff"),
                            ("größe 45°", "größe 45°"), ("\udc00", "\\udc00"), ("a\\x1b", "a\\x1b")):
            self.assertEqual(terminal.printable(text), shown)
            self.assertEqual(terminal.printable(shown), shown)


class Beside(Hostile):
    """Parts in other files: those of the model's own folder alone."""

    def model(self, **attributes):
        model = rexs_files.gearbox()
        model.components = [(number, kind, name, [("data_source", attributes["source"], "none"), ("referenced_component_id", attributes["number"], "none")]
                             if number == 30 else rows) for number, kind, name, rows in model.components]
        return model

    def library(self, file):
        library = rexs_files.Rexs("1.5")
        library.add(60, "rolling_bearing_with_catalog_geometry", "of the library", catalogue_designation="6205", bearing_type="radial_grooved_ball_bearing",
                    u_coordinate_on_shaft_inner_side=(20.0, "mm"), operating_radial_bearing_clearance=(11.0, "mum"), axial_force_absorption="both_directions")
        library.add(61, "rolling_bearing_row", "", number_of_rolling_elements=9, reference_diameter_rolling_bearing=(39.0, "mm"), pressure_angle=(0.0, "deg"))
        library.add(62, "rolling_element", "", diameter_of_rolling_element=(7.94, "mm"))
        library.add(63, "shaft", "that no bearing belongs to")
        library.relate("ordered_assembly", assembly=60, part=61)
        library.relate("ordered_assembly", assembly=61, part=62)
        library.relate("side", assembly=60, inner_part=63, outer_part=63)
        file.parent.mkdir(parents=True, exist_ok=True)
        return library.write(file)

    def converted(self, source, number, name="model.rexs"):
        (self.place / "own").mkdir(exist_ok=True)
        file = self.model(source=source, number=number).write(self.place / "own" / name)
        result = program.within(main, file, "-o", self.place / f"o{len(list(self.place.iterdir()))}", "--json")
        self.assertEqual(result.returncode, 2, result.stderr)
        return json.loads(result.stdout)

    def entry(self, report):
        return next(one for one in report["bearings"] if one["component"] == 30)

    def test_a_bearing_of_a_library(self):
        for name in ("library.rexs", "parts/library.rexsj"):
            self.library(self.place / "own" / name)
            report = self.converted(f"./{name}", 60)
            self.assertEqual(report["notes"], [])
            self.assertEqual(self.entry(report)["case"], "cases/6205_lager_30/case.yaml")
            taken = {entry["attribute"]: entry for entry in report["taken"] if entry["case"] == "6205_lager_30"}
            for attribute, value in (("operating_radial_bearing_clearance", 11.0), ("diameter_of_rolling_element", 7.94), ("number_of_rolling_elements", 9)):
                self.assertEqual((taken[attribute]["value"], taken[attribute]["file"]), (value, f"./{name}"))
            self.assertNotIn("that no bearing belongs to", json.dumps(report))

    def test_what_is_not_there(self):
        self.library(self.place / "own" / "library.rexs")
        self.library(self.place / "outside.rexs")
        (self.place / "own" / "link.rexs").symlink_to(self.place / "outside.rexs")
        (self.place / "own" / "broken.rexs").write_text("<html/>")
        for source, number, said in (("./other.rexs", 60, "the file './other.rexs' is not in the folder of the model"),
                                     ("library.rexsz", 60, "the file 'library.rexsz' is not in the folder of the model, which has 'library.rexs'"),
                                     ("library.rexs", 64, "the file 'library.rexs' has no component 64"),
                                     ("library.rexs", 62, "component 62 of the file 'library.rexs' is a rolling_element, this one a rolling_bearing_with_catalog_geometry"),
                                     ("library.rexs", "x", "the file 'library.rexs' is named without the id of a component in it"),
                                     ("../outside.rexs", 60, "the file '../outside.rexs' is outside the folder of the model"),
                                     (str(self.place / "outside.rexs"), 60, "is outside the folder of the model"),
                                     ("link.rexs", 60, "the file 'link.rexs' is outside the folder of the model"),
                                     ("broken.rexs", 60, "the file 'broken.rexs' cannot be read (found an XML file whose root is 'html'"),
                                     ("model.rexs", 30, "the file 'model.rexs' is the model itself"), ("a\0b", 60, "is no name of a file")):
            report = self.converted(source, number, "model.rexsj" if "\0" in source else "model.rexs")
            self.assertTrue(any(note.startswith("component 30 (") and said in note for note in report["notes"]), (said, report["notes"]))
            self.assertIsNone(self.entry(report)["case"])
            self.assertIn(said, self.entry(report)["problems"][0])


ODD = (None, True, False, 0, -1, 1e300, -1e300, 1e-300, float("inf"), float("nan"), "", "x", "1,5", "\x1b[2J", [], [1], [1.0, 2.0, 3.0], [0.0, 0.0, 0.0], ["a"], {},
       {"a": float("inf")}, 10**30, 0.5, -3.7, "radial_roller_bearing", 90.0, 1e20)
WORDS = ("none", "mm", "rad", "N", "planet_pin", "side", "", "assembly", "shaft", "cylindrical_gear", "ring_gear", "external_load", "concept_bearing", "worm_stage")


class Random(Hostile):
    """Whatever is changed in a file, it is converted or refused; no other error, and no text that is no JSON."""

    COUNT = int(os.environ.get("RANDOM_FILES", "150"))
    SEED = int(os.environ.get("FUZZ_SEED", str(int(time.time()))))

    def places(self, node, at=()):
        yield at
        for key, one in node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ():
            yield from self.places(one, at + (key,))

    def change(self, draw, data):
        places = [one for one in self.places(data) if one]
        for _ in range(draw.choice((1, 1, 2, 4, 8))):
            *way, last = draw.choice(places)
            node, what = data, draw.random()
            try:
                for key in way:
                    node = node[key]
                if what < 0.35:
                    node[last] = draw.choice(ODD)
                elif what < 0.5:
                    del node[last]
                elif what < 0.6 and isinstance(node, list):
                    node.append(copy.deepcopy(node[last]))
                elif isinstance(node[last], (int, float)) and not isinstance(node[last], bool):
                    node[last] *= draw.choice((0, -1, 2, 1000, 1e-3, 0.5, 1.0000001))
                elif isinstance(node[last], str):
                    node[last] = draw.choice(WORDS)
            except (KeyError, IndexError, TypeError):
                pass  # an earlier change took it away

    def test_changed_models(self):
        draw = random.Random(self.SEED)
        models = [json.loads(one.json()) for one in (rexs_files.planetary(), rexs_files.planetary(bearing="concept"), rexs_files.planetary(load_cases=True),
                                                     rexs_files.gearbox(), rexs_files.planetary(version="1.0"), rexs_files.two_stages())]
        for number in range(self.COUNT):
            data = copy.deepcopy(draw.choice(models))
            self.change(draw, data)
            file, content = self.place / "f.rexsj", json.dumps(data).encode()
            try:
                convert.json_of(convert.convert(sources.completed(reading.read(file, content), file), "f.rexsj", "json"))
            except CaseError as error:
                self.assertTrue(str(error).startswith(f"{file}:"), error)
            except Exception as error:
                raise AssertionError(f"FUZZ_SEED={self.SEED}, file {number}") from error

    def test_changed_bytes(self):
        draw = random.Random(self.SEED + 1)
        model = rexs_files.planetary(load_cases=True)
        texts = [model.xml(coded="float64").encode(), model.json(coded="float32").encode(), model.write(self.place / "z.rexsz").read_bytes(), model.xml(mark=False).encode("utf-16")]
        pieces = (b"<a>", b"[[", b'{"a":', b'"', b"\x00", b"&x;", b"<!DOCTYPE a>", b"9" * 30, b"\\udc00", b"1e999", b"</component>")
        for number in range(10 * self.COUNT):
            content = bytearray(draw.choice(texts))
            for _ in range(draw.choice((1, 1, 3))):
                at, what = draw.randrange(len(content)), draw.random()
                if what < 0.5:
                    content[at] = draw.randrange(256)
                elif what < 0.7:
                    del content[at:at + draw.randrange(1, 50)]
                else:
                    content[at:at] = draw.choice(pieces)
            try:
                reading.read(self.place / "f.rexs", bytes(content))
            except CaseError as error:
                self.assertRegex(str(error), r"^.*f\.rexs:\d+:\d+: ")
            except Exception as error:
                raise AssertionError(f"FUZZ_SEED={self.SEED}, text {number}") from error


if __name__ == "__main__":
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, resource.RLIM_INFINITY))  # [byte] what takes the memory fails here
    print(f"FUZZ_SEED={Random.SEED}")
    unittest.main()
