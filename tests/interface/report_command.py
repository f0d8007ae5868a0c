#!/usr/bin/env python3
"""`orbearing report` from outside: which Python draws, and what is left where the page cannot be written.

Exit code 77 (skipped) where matplotlib is missing.
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import matplotlib  # noqa: F401
except ImportError:
    print("skipped: matplotlib is missing")
    sys.exit(77)

from program import BRIEF_GEARS, settings
from sweep_runs import CASE, PROGRAM, run, snapshot, sweep

SHORT = "sweep.input.speed=[6000 rpm, 8000 rpm]"


def report(folder, *before, **variables):
    return subprocess.run([*before, PROGRAM, "report", str(folder)], capture_output=True, text=True, timeout=600, check=False,
                          env={**os.environ, **variables})


class ReportCommand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        cls.root = Path(cls.place.name)

    def swept(self, name):
        folder = self.root / name
        result = sweep(folder, *settings(BRIEF_GEARS), grid=SHORT)
        self.assertEqual(result.returncode, 0, result.stderr)
        return folder

    def test_another_python_first_on_the_path(self):
        """A virtual environment has none of the packages of the system's own interpreter."""
        environment = self.root / "venv"
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(environment)], check=True)
        whole = self.swept("whole")
        result = report(whole, PATH=f"{environment}/bin:{os.environ['PATH']}", VIRTUAL_ENV=str(environment))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertNotIn('class="missing"', (whole / "report.html").read_text(encoding="utf-8"))
        self.check_full_disks(whole)

    def check_full_disks(self, whole):
        """A full disk leaves nothing half; `whole` tells how large the files become."""
        data, page = ((whole / name).stat().st_size // 1024 for name in ("report.json", "report.html"))
        self.assertGreater(page, data + 16, "no limit lets one through and stops the other")
        for name, kilobytes in (("data", data // 2), ("page", (data + page) // 2)):
            with self.subTest(name):
                folder = self.swept(name)
                before = snapshot(folder)
                result = report(folder, "bash", "-c", f'ulimit -f {kilobytes}; exec "$@"', "report")
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn("cannot be written", result.stderr)
                self.assertEqual(snapshot(folder), before)

    def test_a_folder_that_cannot_be_written_to_is_found_first(self):
        """Read-only for everybody, root too: a file system that is mounted so."""
        folder = self.swept("closed")
        mounted = ("unshare", "--mount", "--map-root-user", "bash", "-c",
                   f'mount --bind "{folder}" "{folder}" && mount -o remount,bind,ro "{folder}" && exec "$@"', "report")
        if subprocess.run([*mounted, "true"], capture_output=True, check=False).returncode:
            self.skipTest("nothing can be mounted here")
        result = report(folder, *mounted)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(f"{folder}: cannot be written to", result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1)

    def test_a_folder_without_results(self):
        for folder in (self.root / "none", self.root):
            result = report(folder)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("manifest.jsonl", result.stderr)
        self.assertEqual(run([PROGRAM, "report", str(CASE)]).returncode, 2)

    def test_the_motion_of_gears_alone_has_no_page(self):
        folder = self.root / "gears"
        done = run([PROGRAM, "run", str(CASE), "--gears", "-o", str(folder), "--quiet"])
        self.assertEqual(done.returncode, 0, done.stderr)
        result = report(folder)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("the motion of gears alone", result.stderr)


if __name__ == "__main__":
    unittest.main()
