"""`orbearing run` of a gear set with a scratched planet bearing, from outside."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

CASE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases" / "planet_scratch" / "case.yaml"
SHORT = ("--set", "signal.carrier_revolutions=1", "--set", "signal.carrier_settling=0.2", "--set", "signal.sampling_rate=25.6 kHz")


def call(*arguments):
    return subprocess.run([os.environ["ORBEARING"], *map(str, arguments)], capture_output=True, text=True, timeout=600, check=False)


class PlanetScratch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name) / "out"
        cls.result = call("run", CASE, "--json", "-o", cls.folder, "--set", "defect.race=inner", *SHORT)
        assert cls.result.returncode == 0, cls.result.stderr
        cls.found = json.loads(cls.result.stdout)

    def test_keys_of_the_contract(self):
        for key in ("shaft_Hz", "cage_Hz", "defect_Hz"):
            self.assertIsInstance(self.found[key], float, key)
        for one in self.found["envelope_peaks"]:
            self.assertEqual(set(one), {"frequency_Hz", "amplitude", "is"})
        self.assertIsNone(self.found["orders"])
        for view, unit in (("carrier_frame", "m/s2"), ("housing", "N")):
            self.assertEqual(self.found[view]["amplitude_unit"], unit)
            self.assertTrue(self.found[view]["spectrum_peaks"])

    def test_frequencies_are_those_on_paper(self):
        carrier = 100 * 37 / (37 + 79)
        planet, g = carrier * 79 / 22, 5.24 / 35.64
        rolling = self.found["at_pure_rolling"]
        for key, value in (("carrier_Hz", carrier), ("planet_Hz", planet), ("mesh_Hz", 79 * carrier),
                           ("outer_pass_Hz", 7.5 * planet * (1 - g)), ("inner_pass_Hz", 7.5 * planet * (1 + g)),
                           ("roller_pass_Hz", planet * (1 / g - g))):
            self.assertAlmostEqual(rolling[key] / value, 1.0, places=9, msg=key)
        self.assertAlmostEqual(self.found["defect_Hz"], rolling["inner_pass_Hz"], places=9)
        self.assertLess(abs(self.found["cage_slip"]), 0.02)

    def test_text_has_the_numbers_with_their_units(self):
        text = call("run", CASE, "--set", "defect.race=inner", *SHORT, "-o", self.folder.parent / "text").stdout
        for key in ("carrier_Hz", "planet_Hz", "mesh_Hz", "inner_pass_Hz"):
            value = self.found["at_pure_rolling"][key]
            self.assertTrue(any(abs(float(number) / value - 1) < 1e-4 for number in re.findall(r"([\d.e+]+) Hz", text)), (key, text))
        self.assertNotIn("kHz", text)

    def test_folder_and_page(self):
        self.assertTrue(list((self.folder / "points").glob("*.nc")))
        self.assertTrue((self.folder / "case.resolved.yaml").exists())

    def test_refusals(self):
        for setting, words in (("defect.race=ball", "'ball' in a bearing of rollers"), ("defect.planet=5", "gearset.planets"),
                               ("defect.form=as-printed", "as-printed"), ("defect.width=5 mm", "half a roller diameter")):
            result = call("run", CASE, "--json", "--set", setting, *SHORT)
            self.assertEqual((result.returncode, result.stdout), (2, ""), setting)
            self.assertIn(words, result.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
