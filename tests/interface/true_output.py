#!/usr/bin/env python3
"""What a command prints and writes is whole and true, or the command says so: full disks, two at once, parts of sweeps, changed cases, foreign code.

Needs ORBEARING and ORBEARING_SOURCE_DIR. Parts that need Python packages are skipped where they are missing.
"""

import importlib.util
import json
import os
import re
import resource
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import program

CASES, REDUCER = program.CASES, program.REDUCER
PROGRAM = os.environ["ORBEARING"]
THREE = "sweep={input.speed: [3000 rpm, 6000 rpm, 9000 rpm]}"
ONE = "sweep={input.speed: [6000 rpm]}"
UNCERTAIN = CASES / "reducer_150kW_uncertain" / "case.yaml"
FEW = ("--samples", "4", "--curves", "2", "--index-samples", "2", "--speeds", "5000 rpm, 6000 rpm")


def there(*names):
    return all(importlib.util.find_spec(name) for name in names)


PLOTS = there("numpy", "matplotlib")
STORES = there("numpy", "netCDF4")
SAMPLES = PLOTS and there("openturns", "xarray", "netCDF4")


class InAFolder(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def call(self, *arguments, **more):
        return subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=program.SECONDS, check=False, cwd=self.place,
                              **{"capture_output": True, **more})

    def done(self, *arguments, code=0):
        result = self.call(*arguments)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def sweep(self, name, *options):
        self.done("sweep", REDUCER, "-o", self.place / name, "--quiet", *options)
        return self.place / name


class FullDisk(InAFolder):
    """Output that cannot be written ends with exit 1 and a message."""

    def onto_a_full_disk(self, *arguments):
        with open("/dev/full", "w", encoding="ascii") as full:
            result = self.call(*arguments, stdout=full, stderr=subprocess.PIPE, capture_output=False)
        with self.subTest(arguments):
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn("standard output: ", result.stderr)
            self.assertIn("No space left on device", result.stderr)
            self.assertNotIn("None:", result.stderr)
            self.assertNotIn("Traceback", result.stderr)
            self.assertNotIn("Exception ignored", result.stderr)

    def test_every_command(self):
        record = self.place / "record.csv"
        record.write_text("time [s],speed [rpm],torque [N.m]\n0,1500,10\n1,1500,20\n2,1500,20\n")
        for arguments in (("--version",), ("--help",), ("sweep", "--help"), ("check", REDUCER), ("check", REDUCER, "--json"),
                          ("check", CASES / "spin_film_guo2013" / "case.yaml"), ("modes", REDUCER), ("modes", REDUCER, "--json"),
                          ("mesh", CASES / "mesh_62_62" / "case.yaml"), ("mesh", CASES / "mesh_62_62" / "case.yaml", "--json"),
                          ("run", REDUCER, "--json"), ("run", REDUCER, "-o", "r"), ("run", CASES / "harris_209" / "case.yaml", "--json"),
                          ("sweep", REDUCER, "--set", THREE, "--json"), ("stiffness", REDUCER, "--set", THREE, "--json"),
                          ("sensitivities", CASES / "harris_209" / "case.yaml"), ("validate", CASES / "mesh_62_62"),
                          ("spectrum", record, "-o", "loads.csv"), ("spectrum", record, "--json"),
                          ("crown", REDUCER, "--json", "--tilts", "0 mrad", "--drops", "0 um, 2 um", "--starts", "1"),
                          ("fmu", REDUCER, "-o", "b.fmu")):
            self.onto_a_full_disk(*arguments)
        self.assertTrue((self.place / "loads.csv").is_file())

    @unittest.skipUnless(STORES, "numpy and netCDF4 are required")
    def test_python_parts(self):
        vary = ("--vary", "bearing.radial_clearance=[0 um, 10 um]", "--set", THREE)
        for arguments in (("study", "--help"), ("study", REDUCER, "--json", *vary), ("study", REDUCER, "-o", "study", *vary), ("uncertainty", "--help")):
            self.onto_a_full_disk(*arguments)
        if SAMPLES:
            self.onto_a_full_disk("uncertainty", UNCERTAIN, "--json", *FEW)

    def test_files_that_options_name(self):
        """A device is written into, and stays what it is; through a link, which alone a program that renames would take."""
        full = self.place / "full"
        full.symlink_to("/dev/full")
        record = self.place / "record.csv"
        record.write_text("time [s],speed [rpm],torque [N.m]\n0,1500,10\n1,1500,20\n2,1500,20\n")
        result = self.call("spectrum", record, "-o", full)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("No space left on device", result.stderr)
        self.assertTrue(full.is_char_device())
        self.assertTrue(full.is_symlink())


class MessagesLost(InAFolder):
    """Where standard error is closed or on a full disk, the exit code is what it would be, and nothing is written elsewhere."""

    def code(self, *arguments, out=subprocess.DEVNULL, close=()):
        """With /dev/full as standard error, or with streams that are closed."""
        def shut():
            for stream in close:
                os.close(stream)
        with open("/dev/full", "w", encoding="ascii") as full:
            return self.call(*arguments, stdout=out, stderr=full, capture_output=False, preexec_fn=shut).returncode

    def test_bad_input_stays_bad_input(self):
        for arguments in (("run", "nosuch"), ("check", "nosuch"), ("validate", "nosuch"), ("run", REDUCER, "--json", "--set", "input.power=3"), ("nonsense",), ("run", "--nosuch"),
                          ("fmu", REDUCER, "-o", "x.txt"), ("report", "nosuch")):
            with self.subTest(arguments):
                self.assertEqual(self.code(*arguments), 2)
                self.assertEqual(self.code(*arguments, close=(2,)), 2)

    @unittest.skipUnless(STORES, "numpy and netCDF4 are required")
    def test_bad_input_of_python_parts(self):
        for arguments in (("study", REDUCER, "-o", "s", "--vary", "x"), ("study", REDUCER, "--nosuch"), ("uncertainty", REDUCER, "-o", "u"), ("convert", "nosuch.rexs", "-o", "c")):
            with self.subTest(arguments):
                self.assertEqual(self.code(*arguments), 2)
                self.assertEqual(self.code(*arguments, close=(2,)), 2)

    def test_a_computation_that_fails_or_cannot_be_printed(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            self.assertEqual(self.code("run", REDUCER, "--json", out=full), 1)
        self.assertEqual(self.code("check", REDUCER, close=(1, 2)), 1)
        self.assertEqual(self.code("check", REDUCER), 0)

    def test_messages_do_not_go_into_files_of_results(self):
        """A file that is opened first would have the number of the closed stream."""
        self.assertEqual(self.code("sweep", REDUCER, "-o", "out", "--set", THREE, "--set", "bearing.radial_clearance=-1 mm", "--grid-only", close=(2,)),
                         self.code("sweep", REDUCER, "-o", "other", "--set", THREE, "--set", "bearing.radial_clearance=-1 mm", "--grid-only"))
        self.assertEqual(self.code("sweep", REDUCER, "-o", "kept", "--set", THREE, "--grid-only", close=(2,)), 0)
        for line in (self.place / "kept" / "manifest.jsonl").read_text(encoding="utf-8").splitlines():
            json.loads(line)


class FilesThatEnd(InAFolder):
    """A disk that is full, here a limit on the size of files: exit 1 with the file and the reason, and --resume goes on."""

    def limited(self, kilobytes, *arguments):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1024 * kilobytes, 1024 * kilobytes))
        return self.call(*arguments, preexec_fn=limit)

    @unittest.skipUnless(STORES, "numpy and netCDF4 are required")
    def test_a_study_goes_on(self):
        words = ("study", REDUCER, "-o", "st", "--quiet", "--vary", "bearing.radial_clearance={from: 0 um, to: 40 um, count: 6}", "--set", THREE)
        stopped = self.limited(60, *words)
        self.assertEqual(stopped.returncode, 1, stopped.stderr)
        self.assertEqual(stopped.stderr, "study: st/study.nc: cannot be written: File too large; what is done stays in st, --resume continues\n")
        self.done(*words, "--resume")
        self.done(*(word.replace("st", "whole") if word == "st" else word for word in words))
        self.assertEqual((self.place / "st" / "study.nc").read_bytes(), (self.place / "whole" / "study.nc").read_bytes())

    @unittest.skipUnless(SAMPLES, "openturns, xarray, netCDF4 and matplotlib are required")
    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_a_study_of_uncertainty_goes_on(self):
        words = ("uncertainty", UNCERTAIN, "-o", "u", "--quiet", *FEW)
        stopped = self.limited(20, *words)
        self.assertEqual(stopped.returncode, 1, stopped.stderr)
        self.assertRegex(stopped.stderr, r"^uncertainty: u/\w+\.(svg|png|html|nc): cannot be written: File too large; what is done stays in u, --resume continues\n$")
        self.done(*words, "--resume")
        self.assertTrue((self.place / "u" / "uncertainty.json").is_file())


class ForeignCode(InAFolder):
    """Files of the working folder are data and no code."""

    NAMES = ("json", "numpy", "orbearing", "matplotlib", "argparse", "runpy", "site", "sitecustomize", "usercustomize")

    def lay_traps(self, folder):
        for name in self.NAMES:
            (folder / f"{name}.py").write_text(f"open({str(self.place / 'ran')!r}, 'a').write({name!r})\nraise SystemExit(3)\n")

    @unittest.skipUnless(PLOTS, "numpy and matplotlib are required")
    def test_report(self):
        folder = self.sweep("swept", "--set", ONE)
        self.lay_traps(folder)
        result = subprocess.run([PROGRAM, "report", "."], capture_output=True, text=True, timeout=program.SECONDS, check=False, cwd=folder)
        self.assertEqual((result.returncode, (self.place / "ran").exists()), (0, False), result.stderr)
        self.assertTrue((folder / "report.html").is_file())

    @unittest.skipUnless(STORES, "numpy and netCDF4 are required")
    def test_study_and_uncertainty(self):
        self.lay_traps(self.place)
        self.done("study", REDUCER, "--json", "--set", THREE, "--vary", "bearing.radial_clearance=[0 um]")
        self.done("uncertainty", "--help")
        if SAMPLES:
            self.done("uncertainty", UNCERTAIN, "--json", *FEW)
        self.assertFalse((self.place / "ran").exists())


class Reports(InAFolder):
    @unittest.skipUnless(PLOTS, "numpy and matplotlib are required")
    def page_of(self, folder):
        result = self.done("report", folder)
        return re.sub("<[^>]*>", " ", (folder / "report.html").read_text(encoding="utf-8")), json.loads((folder / "report.json").read_text()), result

    def data_of(self, folder):
        """What a page would be made of, without drawing it."""
        return json.loads(self.done("report", folder, "--data-only", "--json").stdout)

    @unittest.skipUnless(PLOTS, "numpy and matplotlib are required")
    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_nothing_is_interpolated(self):
        """10,504 h were printed for the 49,356 h that are computed at 6000 rpm."""
        folder = self.sweep("two", "--grid-only", "--set", "sweep={input.speed: [3000 rpm, 9000 rpm]}")
        text, data, _ = self.page_of(folder)
        life = program.answer("run", REDUCER, "input.speed=6000 rpm")["points"][0]["life_h"]
        self.assertAlmostEqual(data["published"][0]["ours_h"] / life, 1, delta=1e-12)
        self.assertIn(f"ours there {life:,.0f} h", text)

    @unittest.skipUnless(PLOTS, "numpy and matplotlib are required")
    def test_a_changed_case_is_not_the_published_one(self):
        text, data, _ = self.page_of(self.sweep("changed", "--set", ONE, "--set", "input.power=75 kW", "--set", "bearing.rollers=12"))
        self.assertEqual(data["changed_inputs"], ["input.power: 75 kW (published: 150 kW)", "bearing.rollers: 12 (published: 15)"])
        self.assertEqual((data["published"], data["validation"]), ([], []))
        self.assertIn("bearing.rollers: 12 (published: 15)", text)
        self.assertNotIn("ours there", text)

    @unittest.skipUnless(PLOTS, "numpy and matplotlib are required")
    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_a_part_of_a_sweep_is_told_as_one(self):
        brief = program.settings((THREE, *program.BRIEF_GEARS))  # gears at forty speeds, which nothing here asks for
        shard = self.sweep("shard", "--shard", "1/2", *brief)
        text, data, result = self.page_of(shard)
        self.assertEqual(data["missing"]["points"], ["input.speed = 6000 rpm"])
        for place in (text, result.stdout):
            self.assertIn("1 of 3 points of the sweep are missing (this is shard 1/2): input.speed = 6000 rpm", place)
        self.assertIn("Incomplete sweep, 2 of 3 points, shard 1/2", text)
        whole = self.sweep("whole", *brief)
        self.assertIsNone(self.data_of(whole)["missing"])
        lines = (whole / "manifest.jsonl").read_bytes().splitlines(keepends=True)
        (whole / "manifest.jsonl").write_bytes(b"".join(lines[:3]))
        self.assertIn("continue with --resume", self.data_of(whole)["missing"]["text"])
        (whole / "manifest.jsonl").write_bytes(b"".join(lines[:4]))
        self.assertTrue(self.data_of(whole)["missing"]["peak_unfinished"])
        (whole / "manifest.jsonl").write_bytes(lines[0])
        self.assertIn("found no finished point", self.done("report", whole, code=2).stderr)

    def test_damaged_results_have_no_report(self):
        """What a report reads is what was written."""
        folder = self.sweep("damaged", "--set", THREE)
        file = folder / "case.resolved.yaml"
        file.write_text(file.read_text().replace("150 kW", "151 kW"))
        self.assertIn("case.resolved.yaml: differs from what its run wrote", self.done("report", folder, code=2).stderr)

    def test_results_without_a_page(self):
        """A crowning study that was interrupted, and results of other commands."""
        crown = self.place / "crown"
        few = ("--tilts", "0 mrad", "--drops", "0 um, 2 um", "--starts", "1")
        self.done("crown", REDUCER, "-o", crown, "--quiet", *few)
        whole = (crown / "crown.json").read_text()
        (crown / "crown.json").write_text(whole.replace("1", "2", 1))
        self.assertIn("crown.json: differs", self.done("report", crown, code=2).stderr)
        (crown / "crown.json").unlink()
        self.assertIn("crown.json", self.done("report", crown, code=2).stderr)
        manifest = crown / "manifest.jsonl"
        manifest.write_bytes(manifest.read_bytes().splitlines(keepends=True)[0])
        self.assertIn("--resume", self.done("report", crown, code=2).stderr)
        stiffness = self.place / "stiffness"
        self.done("stiffness", REDUCER, "-o", stiffness, "--quiet")
        found = self.done("report", stiffness, code=2).stderr
        self.assertIn("found results of 'stiffness'", found)
        for text in (found,):
            self.assertNotIn("map::at", text)

    @unittest.skipUnless(PLOTS, "numpy and matplotlib are required")
    def test_two_at_once(self):
        """One of them writes, the other says so at once."""
        folder = self.sweep("two_reports", "--set", ONE)
        both = [subprocess.Popen([PROGRAM, "report", str(folder)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for _ in range(2)]
        ends = [(process.communicate(timeout=program.SECONDS)[1], process.returncode) for process in both]
        self.assertIn(0, [code for _, code in ends])
        for words, code in ends:
            self.assertIn(code, (0, 2), words)
            if code == 2:
                self.assertIn("another command is writing here", words)

    def test_links_are_not_written_through(self):
        self.assertTrue(PLOTS or True)
        folder = self.sweep("linked", "--set", THREE)
        (self.place / "elsewhere").mkdir()
        (folder / "points" / "00000.nc").rename(self.place / "elsewhere" / "00000.nc")
        for file in (folder / "points").iterdir():
            file.unlink()
        (folder / "points").rmdir()
        (folder / "points").symlink_to(self.place / "elsewhere")
        result = self.done("sweep", REDUCER, "-o", folder, "--quiet", "--set", THREE, "--resume", code=2)
        self.assertIn("found a link to", result.stderr)
        self.assertEqual([file.name for file in (self.place / "elsewhere").iterdir()], ["00000.nc"])


@unittest.skipUnless(SAMPLES, "numpy, matplotlib, OpenTURNS, xarray and netCDF4 are required")
class Uncertainty(InAFolder):
    def start(self, folder, *options):
        return subprocess.Popen([PROGRAM, "uncertainty", str(UNCERTAIN), "-o", str(folder), "--quiet", *FEW, *options], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def test_two_at_once(self):
        both = [self.start(self.place / "both", "--seed", str(seed)) for seed in (1, 2)]
        ends = [(process.communicate(timeout=program.SECONDS)[1], process.returncode) for process in both]
        self.assertEqual(sorted(code for _, code in ends), [0, 2], ends)
        seed = next(number for number, (_, code) in enumerate(ends, 1) if code == 0)
        self.assertEqual(json.loads((self.place / "both" / "uncertainty.json").read_text())["settings"]["seed"], seed)
        words = next(words for words, code in ends if code == 2)
        self.assertTrue("another run is writing here" in words or "found a folder that holds" in words, words)

    @unittest.skipIf(program.LEFT_TO_FULL, "three studies: tools/test --full, or by hand")
    def test_a_killed_one_goes_on(self):
        folder, journal = self.place / "killed", self.place / "killed" / "uncertainty.journal"
        whole = self.place / "whole"
        first = self.start(whole)
        self.assertEqual((first.communicate(timeout=program.SECONDS)[1], first.returncode), ("", 0))
        process = self.start(folder)
        while process.poll() is None and not (journal.exists() and journal.stat().st_size > 2000):
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.communicate()
        if (folder / "uncertainty.json").exists():
            (folder / "uncertainty.json").unlink()
        kept = journal.stat().st_size
        self.assertGreater(kept, 0)
        self.done("uncertainty", UNCERTAIN, "-o", folder, "--quiet", *FEW, code=2)
        other = self.done("uncertainty", UNCERTAIN, "-o", folder, "--quiet", *FEW, "--seed", "9", "--resume", code=2)
        self.assertIn("--resume: seed '1' was found; '9' is required", other.stderr)
        self.done("uncertainty", UNCERTAIN, "-o", folder, "--quiet", *FEW, "--resume")
        self.assertGreaterEqual(journal.stat().st_size, kept)
        self.assertEqual((folder / "uncertainty.json").read_bytes(), (whole / "uncertainty.json").read_bytes())
        self.assertEqual(sorted(file.name for file in folder.iterdir()), sorted(file.name for file in whole.iterdir()))


class Sizes(InAFolder):
    """What would take years is refused at once, with the reason."""

    @unittest.skipUnless(STORES, "numpy and netCDF4 are required")
    def test_variants_are_counted_before_they_are_made(self):
        wide = "{from: 0 um, to: 10 um, step: 0.00001 um}"
        result = self.done("study", REDUCER, "--json", "--vary", f"bearing.radial_clearance={wide}", "--vary",
                           "input.power={from: 100 kW, to: 200 kW, step: 0.0001 kW}", code=2)
        self.assertRegex(result.stderr, r"study: found \d{14} points; at most 10000000 are required")
        listed = self.done("study", REDUCER, "--json", "--vary", "bearing.radial_clearance=[5 um, 0.005 mm]", code=2)
        self.assertIn("'5 um' and '0.005 mm' are one value", listed.stderr)

    def test_a_ring_without_mass_and_a_scratch_without_width(self):
        for setting, words in (("defect.width=1e-6 mm", "defect.width"), ("bearing.outer_ring_mass=1e-9 kg", "bearing.outer_ring_mass: 1e-9 kg")):
            result = self.done("run", CASES / "scratch_defect" / "case.yaml", "--json", "--set", setting, "--set", "signal.revolutions=4", code=2)
            self.assertIn(words, result.stderr)


class Messages(InAFolder):
    """Values as they were written."""

    def test_lists_of_a_crowning_study(self):
        for option, value, words in (("--tilts", "0 mrad, 1000 mrad", "--tilts: found '1000 mrad'; required: tilts from 0 to 100 mrad"),
                                     ("--drops", "-1 um, 2 um", "--drops: found '-1 um'; required: drops from 0 to 1000 um"),
                                     ("--tilt-tolerance", "1 rad", "--tilt-tolerance: found '1 rad'; required: at least 0 and less than 100 mrad")):
            self.assertIn(words, self.done("crown", REDUCER, "--json", f"{option}={value}", code=2).stderr)

    def test_a_band_that_is_open_is_told(self):
        """The band ended at 2.00 for 2.28 um where 2 um was the greatest drop studied."""
        few = ("--tilts", "0 mrad, 1 mrad", "--starts", "1", "--json")
        narrow = json.loads(self.done("crown", REDUCER, *few, "--drops", "0 um, 2 um").stdout)
        self.assertTrue(narrow["recommended"]["most_is_greatest_studied"])
        self.assertTrue(any("ends at 2 um because greater ones were not studied" in text for text in narrow["warnings"]), narrow["warnings"])


class Stiffness(InAFolder):
    def test_the_resolved_case_gives_the_points_of_the_run(self):
        for name, settings in (("reducer_150kW", ("--set", THREE)), ("spin_bearing_7210", ())):
            folder = self.place / name
            first = json.loads(self.done("stiffness", CASES / name / "case.yaml", "-o", folder, "--json", *settings).stdout)
            again = json.loads(self.done("stiffness", folder / "case.resolved.yaml", "--json").stdout)
            self.assertGreater(len(first["points"]), 1)
            self.assertEqual(first["points"], again["points"])


if __name__ == "__main__":
    unittest.main()
