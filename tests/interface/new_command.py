#!/usr/bin/env python3
"""`orbearing new TEMPLATE FILE`: commented cases to begin from, each sound, none written over another file."""

import json
import os
import pathlib
import stat
import tempfile
import unittest

from program import CASES, answer, run

TEMPLATES = ("wind-stage", "e-drive", "industrial", "roller-bearing", "ball-bearing", "duplex", "defect")
RATED = TEMPLATES[:5]  # what has lives


class NewCommand(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def test_every_template_is_listed_written_checked_and_run(self):
        self.assertEqual({file.stem for file in (CASES / "templates").iterdir()}, set(TEMPLATES))
        listed = run("new", "--help").stdout
        for name in TEMPLATES:
            with self.subTest(template=name):
                self.assertIn(name, listed)
                file = self.folder / f"{name}.yaml"
                written = run("new", name, file)
                self.assertEqual(written.returncode, 0, written.stderr)
                text = file.read_text(encoding="utf-8")
                self.assertEqual(text, (CASES / "templates" / f"{name}.yaml").read_text(encoding="utf-8"))
                self.assertTrue(20 <= text.count("\n") <= 40, text.count("\n"))
                self.assertGreaterEqual(text.count("#"), 5)
                answer("check", file)
                found = answer("run", file)
                if name in RATED:
                    point = found.get("points", [found])[0]
                    for key in ("L10h", "L10rh", "L10mh", "L10mrh", "life_h"):
                        self.assertGreater(point[key], 1000.0, key)

    def test_json_names_what_was_written(self):
        file = self.folder / "mine.yaml"
        told = json.loads(run("new", "duplex", file, "--json").stdout)
        self.assertEqual((told["template"], told["file"], told["title"]), ("duplex", str(file), "Duplex pair"))
        self.assertIn("spindle shaft", told["purpose"])

    def test_a_file_is_never_written_over(self):
        file = self.folder / "mine.yaml"
        file.write_text("mine\n", encoding="utf-8")
        link = self.folder / "link.yaml"
        link.symlink_to(self.folder / "nowhere.yaml")
        for name in (file, link, self.folder):
            refused = run("new", "duplex", name)
            self.assertEqual((refused.returncode, refused.stdout), (2, ""))
            self.assertIn("exists already", refused.stderr)
        self.assertEqual(file.read_text(encoding="utf-8"), "mine\n")
        self.assertFalse((self.folder / "nowhere.yaml").exists())

    def test_an_unknown_template_is_refused_with_the_list(self):
        refused = run("new", "wind", self.folder / "mine.yaml")
        self.assertEqual(refused.returncode, 2)
        self.assertEqual(refused.stderr, f"TEMPLATE: found 'wind'; required: one of {', '.join(TEMPLATES)}\n")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_folder_that_is_missing_is_refused(self):
        refused = run("new", "duplex", self.folder / "none" / "mine.yaml")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("cannot be made: No such file or directory", refused.stderr)

    def test_the_file_has_the_modes_of_other_new_files(self):
        old = os.umask(0o027)
        try:
            run("new", "duplex", self.folder / "mine.yaml")
        finally:
            os.umask(old)
        self.assertEqual(stat.S_IMODE((self.folder / "mine.yaml").stat().st_mode), 0o640)


if __name__ == "__main__":
    unittest.main()
