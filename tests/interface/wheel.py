"""The wheel that tools/wheel made: its tags, versions of symbols, and the demo in an empty environment of each Python that is there.

Skipped where there is no wheel of this version in dist.
"""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import unittest
import zipfile

from program import LEFT_TO_FULL
from virtual_environment import skip

SOURCE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
OLDEST_GLIBC = (2, 28)
VERSION = re.search(r"project\(Orbearing VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
WHEELS = sorted((SOURCE / "dist").glob(f"orbearing-{VERSION}-*.whl"))
# Names of the C library and of what belongs to it: no other library may be needed.
PARTS_OF_GLIBC = re.compile(r"(?:libc|libm|libdl|librt|libpthread|libutil|ld-linux-x86-64)\.so\.\d")


def called(*words, **more):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **more)


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        cls.wheel, = WHEELS
        with zipfile.ZipFile(cls.wheel) as archive:
            cls.names = archive.namelist()
            cls.libraries = [pathlib.Path(archive.extract(name, cls.folder / "content")) for name in cls.names if name.endswith(".so")]

    def test_it_is_for_every_python(self):
        self.assertEqual(self.wheel.name, f"orbearing-{VERSION}-py3-none-manylinux_2_28_x86_64.whl")
        self.assertFalse([name for name in self.names if "cpython" in name])
        self.assertEqual(len(set(self.names)), len(self.names))

    def test_libraries_ask_for_an_old_c_library_and_no_other(self):
        self.assertEqual({file.name for file in self.libraries}, {"liborbearing.so", "orbearing.so"})
        for file in self.libraries:
            with self.subTest(file.name):
                read = called("readelf", "--wide", "-V", "-d", file).stdout
                versions = {tuple(map(int, number.split("."))) for number in re.findall(r"GLIBC_([0-9.]+)", read)}
                self.assertGreater(len(versions), 1)
                self.assertLessEqual(max(versions), OLDEST_GLIBC)
                self.assertNotRegex(read, "GLIBCXX|CXXABI")
                needed = re.findall(r"\(NEEDED\).*\[(.*)\]", read)
                self.assertEqual([name for name in needed if not PARTS_OF_GLIBC.fullmatch(name)], [])

    def test_it_runs_the_demo_in_an_empty_environment(self):
        """With Debian's own NumPy, matplotlib and netCDF4: nothing is fetched."""
        environment = self.folder / "debian"
        self.assertEqual(called("/usr/bin/python3", "-m", "venv", "--system-site-packages", environment).returncode, 0)
        self.demo(environment, "--no-deps", "--no-index")

    @unittest.skipIf(LEFT_TO_FULL, "packages of PyPI for each Python: tools/test --full, or by hand")
    def test_other_pythons_take_it(self):
        found = {f"python3.{number}": shutil.which(f"python3.{number}") for number in range(9, 15)}
        interpreters = {name: path for name, path in found.items() if path and called(path, "-m", "venv", "--help").returncode == 0}
        if not interpreters:
            self.skipTest("no other Python is there")
        for name, path in interpreters.items():
            with self.subTest(name):
                environment = self.folder / name
                if called(path, "-m", "venv", environment).returncode:
                    self.skipTest(f"{name} makes no environment")
                self.demo(environment)

    def demo(self, environment, *options):
        clean = {"PATH": f"{environment}/bin:/usr/bin:/bin", "HOME": str(self.folder)}
        installed = called(environment / "bin" / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *options, self.wheel, env=clean)
        if installed.returncode and not options:
            self.skipTest(f"packages were not installed: {installed.stderr[-200:]}")
        self.assertEqual(installed.returncode, 0, installed.stderr)
        with tempfile.TemporaryDirectory(dir=self.folder) as place:
            begin = time.monotonic()
            done = called(environment / "bin" / "orbearing", "demo", cwd=place, env=clean)
            seconds = time.monotonic() - begin
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertGreater((pathlib.Path(place) / "orbearing-demo" / "report.html").stat().st_size, 100_000)
        print(f"{environment.name}: demo in {seconds:.1f} s")


if __name__ == "__main__":
    if not WHEELS:
        skip(f"dist has no wheel of version {VERSION}; tools/wheel makes it")
    unittest.main()
