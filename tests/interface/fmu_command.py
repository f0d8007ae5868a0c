#!/usr/bin/env python3
"""`orbearing fmu` from outside: what it writes, what it refuses."""

import json
import os
import pathlib
import pty
import select
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml
import zipfile

from fmu_library import OLDEST_GLIBC

CASES = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases"
REDUCER = CASES / "reducer_150kW" / "case.yaml"
LIBRARIES = pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1] / "lib" / "orbearing" / "fmu"
SECONDS = 600


def fmu(case, output, *arguments):
    command = [os.environ["ORBEARING"], "fmu", str(case), "-o", str(output), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


class FmuCommand(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def written(self, *arguments):
        file = self.folder / "a.fmu"
        result = fmu(REDUCER, file, "--json", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout), zipfile.ZipFile(file)

    def test_contents_of_both_versions(self):
        for version, linux in (("2", "linux64"), ("3", "x86_64-linux")):
            for model in ("bearing", "gearset"):
                with self.subTest(version=version, model=model):
                    answer, archive = self.written("--fmi", version, "--model", model)
                    root = xml.fromstring(archive.read("modelDescription.xml"))
                    self.assertEqual(root.get("fmiVersion"), version + ".0")
                    self.assertEqual(root.get("guid") or root.get("instantiationToken"), answer["token"])
                    self.assertRegex(answer["token"], r"^\{[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\}$")
                    identifier = root.find("CoSimulation").get("modelIdentifier")
                    self.assertIn(f"binaries/{linux}/{identifier}.so", archive.namelist())
                    for name in ("resources/model.txt", "documentation/index.html",
                                 "documentation/licenses/license.txt"):
                        self.assertIn(name, archive.namelist())
                    # The FMU states the oldest C library.
                    page = archive.read("documentation/index.html").decode()
                    self.assertIn("glibc {}.{} or newer".format(*OLDEST_GLIBC), page)
                    self.assertEqual(answer["inputs"], len(root.findall(".//*[@causality='input']")))

    def test_the_platform_at_hand_alone_is_the_default(self):
        answer, archive = self.written()
        self.assertEqual(answer["platforms"], ["linux64"])
        self.assertEqual([name for name in archive.namelist() if name.startswith("binaries/")], ["binaries/linux64/orbearing_bearing.so"])

    @unittest.skipUnless((LIBRARIES / "win64" / "orbearing.dll").exists(), "no Windows library was built")
    def test_windows_library_is_added_on_request(self):
        answer, archive = self.written("--windows")
        self.assertEqual(answer["platforms"], ["linux64", "win64"])
        self.assertIn("binaries/win64/orbearing_bearing.dll", archive.namelist())

    def test_default_is_the_bearing_for_fmi_2(self):
        answer, _ = self.written()
        self.assertEqual((answer["fmi"], answer["model"]), ("2", "bearing"))

    def test_equal_cases_give_equal_files(self):
        for name in ("a.fmu", "b.fmu"):
            self.assertEqual(fmu(REDUCER, self.folder / name).returncode, 0)
        self.assertEqual((self.folder / "a.fmu").read_bytes(), (self.folder / "b.fmu").read_bytes())

    def test_another_clearance_is_another_model(self):
        first, _ = self.written()
        second, archive = self.written("--set", "bearing.radial_clearance=20 um")
        self.assertNotEqual(first["token"], second["token"])
        root = xml.fromstring(archive.read("modelDescription.xml"))
        clearance = root.find(".//ScalarVariable[@name='bearing.radial_clearance']/Real")
        self.assertAlmostEqual(float(clearance.get("start")), 20e-6, delta=1e-18)
        self.assertEqual(clearance.get("unit"), "m")

    def test_quiet_says_nothing_and_folders_are_made(self):
        file = self.folder / "new" / "deep" / "a.fmu"
        result = fmu(REDUCER, file, "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertTrue(file.exists())

    def test_bad_input(self):
        rows = (
            (REDUCER, "a.zip", (), ".fmu"),
            (REDUCER, "a.fmu", ("--fmi", "1"), "1"),
            (REDUCER, "a.fmu", ("--model", "engine"), "engine"),
            (REDUCER, "a.fmu", ("--set", "bearing.rollers=0"), "bearing.rollers"),
            (CASES / "three_sets_150kW" / "case.yaml", "a.fmu", (), "one set"),
            (CASES / "lin_parker_1999" / "case.yaml", "a.fmu", (), "bearing"),
            (CASES / "lin_parker_1999" / "case.yaml", "a.fmu", ("--model", "gearset"), "teeth"),
            (CASES / "harris_209" / "case.yaml", "a.fmu", (), "planetary-drivetrain"),
            (CASES / "mesh_62_62" / "case.yaml", "a.fmu", ("--model", "gearset"), "planetary-drivetrain"),
            (self.folder / "none.yaml", "a.fmu", (), "none.yaml"),
        )
        for case, name, arguments, word in rows:
            with self.subTest(word=word, name=name, case=case.parent.name):
                result = fmu(case, self.folder / name, *arguments)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn(word, result.stderr)
                self.assertFalse((self.folder / name).exists())

    def test_a_file_size_limit_leaves_nothing(self):
        command = [os.environ["ORBEARING"], "fmu", str(REDUCER), "-o", str(self.folder / "new" / "a.fmu")]
        result = subprocess.run(["bash", "-c", 'ulimit -f 100; exec "$@"', "fmu", *command], capture_output=True, text=True,
                                timeout=SECONDS, check=False)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("raise the limit of the size of files (ulimit -f)", result.stderr)
        self.assertNotIn("--resume", result.stderr)
        self.assertEqual(list((self.folder / "new").iterdir()), [])

    def test_a_place_that_cannot_be_written_to(self):
        (self.folder / "file").write_text("text")
        for output in (self.folder / "file" / "a.fmu", "/proc/a.fmu", "/proc/none/a.fmu"):
            result = fmu(REDUCER, output)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("required", result.stderr)

    def test_a_folder_is_no_file(self):
        (self.folder / "a.fmu").mkdir()
        self.assertEqual(fmu(REDUCER, self.folder / "a.fmu").returncode, 2)


class WindowsLibraryWhenItIsNeeded(unittest.TestCase):
    """A copy of the program and its library for Linux, with a recipe of our own for that for Windows."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name, "it's here")
        self.libraries = self.folder / "lib" / "orbearing" / "fmu"
        (self.libraries / "linux64").mkdir(parents=True)
        (self.folder / "bin").mkdir()
        program = pathlib.Path(os.environ["ORBEARING"]).resolve()
        shutil.copy(program, self.folder / "bin")
        shutil.copy(program.parents[1] / "lib" / "orbearing" / "fmu" / "linux64" / "orbearing.so",
                    self.libraries / "linux64")

    def recipe(self, text):
        file = self.libraries / "build_win64"
        file.write_text("#!/bin/sh\n" + text)
        file.chmod(0o755)

    def run_with(self, *arguments):
        command = [self.folder / "bin" / "orbearing", "fmu", REDUCER, "-o", self.folder / "a.fmu", "--json", *arguments]
        return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)

    def made(self, *arguments):
        result = self.run_with(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout), zipfile.ZipFile(self.folder / "a.fmu"), result.stderr

    def test_is_built_on_request_once(self):
        self.recipe('cd "$(dirname "$0")" && mkdir win64 && printf MZ > win64/orbearing.dll && rm build_win64')
        answer, archive, message = self.made()
        self.assertEqual((answer["platforms"], message), (["linux64"], ""))
        answer, archive, message = self.made("--windows")
        self.assertEqual(answer["platforms"], ["linux64", "win64"])
        self.assertEqual(archive.read("binaries/win64/orbearing_bearing.dll"), b"MZ")
        self.assertEqual(message, "fmu: building the library for win64, this once (5 to 20 minutes) ...\n")
        self.assertEqual(self.made("--windows")[2], "")
        self.assertEqual(self.made()[0]["platforms"], ["linux64"])

    def test_quiet_builds_without_a_word(self):
        self.recipe('cd "$(dirname "$0")" && mkdir win64 && printf MZ > win64/orbearing.dll')
        answer, _, message = self.made("--windows", "--quiet")
        self.assertEqual((answer["platforms"], message), (["linux64", "win64"], ""))

    def test_its_progress_is_shown_on_a_terminal(self):
        self.recipe('cd "$(dirname "$0")" && echo "-- configured"; echo "[1/4] a"; sleep 0.3; echo "[3/4] b"; mkdir win64 && printf MZ > win64/orbearing.dll')
        master, slave = pty.openpty()
        command = [self.folder / "bin" / "orbearing", "fmu", REDUCER, "-o", self.folder / "a.fmu", "--windows"]
        code = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=slave, timeout=SECONDS, check=False).returncode
        os.close(slave)
        shown = b""
        while select.select([master], [], [], 0.0)[0]:
            try:
                shown += os.read(master, 4096)
            except OSError:  # the end, as Linux says it
                break
        os.close(master)
        self.assertEqual(code, 0, shown)
        self.assertIn(b"library for win64: 3 of 4", shown)

    def expect_none(self, reason):
        result = self.run_with("--windows")
        self.assertEqual((result.returncode, result.stdout), (1, ""), result.stderr)
        self.assertIn("fmu: no library for win64: ", result.stderr)
        self.assertIn(reason, result.stderr)
        self.assertIn("Without --windows the FMU is for Linux", result.stderr)
        self.assertFalse((self.folder / "a.fmu").exists())
        self.assertEqual(self.made()[0]["platforms"], ["linux64"])

    def test_failure_is_reported_with_its_reason(self):
        self.recipe("echo many words; echo the compiler is gone; exit 1")
        self.expect_none("the compiler is gone")

    def test_recipe_without_result(self):
        self.recipe("exit 0")
        self.expect_none("orbearing.dll")

    def test_nothing_to_build_with(self):
        self.expect_none("ORBEARING_BUILD_WIN64")

    def test_recipe_names_the_missing_compiler(self):
        ours = LIBRARIES / "build_win64"
        if not ours.exists():
            self.skipTest("this build has no recipe for the Windows library")
        tools = self.folder / "tools"
        tools.mkdir()
        for name in ("sh", "flock"):
            (tools / name).symlink_to(shutil.which(name))
        text = ours.read_text().replace(str(LIBRARIES), str(self.libraries))
        self.recipe(f"unset ORBEARING_FULL; PATH='{self.folder}'; PATH=$PATH/tools\n".replace("it's", "it'\\''s") + text)
        self.expect_none("g++-mingw-w64-x86-64-posix")


if __name__ == "__main__":
    unittest.main()
