#!/usr/bin/env python3
"""Gear set and planet bearings, coupled both ways by a master that is not ours (ECOS), with FMI 2.0 and 3.0.

All exchange in parallel. The same exchange by hand, through FMPy, gives the same motion. Skipped where ecospy and
FMPy are missing and cannot be had. Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from virtual_environment import interpreter_with, left_to_full

CASE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"], "cases", "reducer_150kW", "case.yaml")
PACKAGES = ("ecospy==0.7.2", "fmpy==0.3.32")
STEPS = 100
# [-] The masters add up times and multiply forces in their own ways; loose rollers multiply round-off.
ROUND_OFF = 1e-9
COMMON = """
import json, sys
gears, bearing, steps, size = sys.argv[1], sys.argv[2], int(sys.argv[3]), 1e-6
planets = range(1, 5)
to_bearing = [(f"planet[%d].{q}", f"planet.{q}") for q in
              ("displacement.x", "displacement.y", "velocity.x", "velocity.y", "speed")]
to_bearing += [("carrier.speed", "carrier.speed"), ("carrier.acceleration", "carrier.acceleration")]
to_gears = [(q, f"planet[%d].{q}") for q in ("force.x", "force.y", "moment")]
seen = ("displacement.x", "displacement.y", "speed")
name = lambda pattern, i: pattern % i if "%" in pattern else pattern
double = lambda force: 2.0 * force  # a planet sits on two bearings, which are one here
"""
BY_ECOS = COMMON + """
from ecospy.EcosSimulation import EcosSimulation
from ecospy.EcosSimulationStructure import EcosSimulationStructure
with EcosSimulationStructure() as structure:
    structure.add_model("gears", gears)
    for i in planets:
        structure.add_model(f"bearing{i}", bearing)
        for source, sink in to_bearing:
            structure.make_real_connection(f"gears::{name(source, i)}", f"bearing{i}::{sink}")
        for source, sink in to_gears:
            structure.make_real_connection(f"bearing{i}::{source}", f"gears::{name(sink, i)}", double)
    with EcosSimulation(size, structure=structure) as simulation:
        simulation.init()
        rows = []
        for k in range(steps + 1):
            if k > 0:
                simulation.step(1)
            rows.append([simulation.get_real(f"gears::planet[{i}].{q}") for i in planets for q in seen])
print("\\n" + json.dumps(rows))
"""
BY_HAND = COMMON + """
import shutil, fmpy, fmpy.fmi2
class One:
    def __init__(self, file):
        self.folder = fmpy.extract(file)
        about = fmpy.read_model_description(self.folder)
        self.of = {v.name: v.valueReference for v in about.modelVariables}
        self.fmu = fmpy.fmi2.FMU2Slave(guid=about.guid, unzipDirectory=self.folder,
                                       modelIdentifier=about.coSimulation.modelIdentifier)
        self.fmu.instantiate()
        self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()
    def get(self, names):
        return self.fmu.getReal([self.of[n] for n in names])
    def set(self, names, values):
        self.fmu.setReal([self.of[n] for n in names], values)
one, many = One(gears), {i: One(bearing) for i in planets}
def exchange():
    motion = {i: one.get([name(source, i) for source, _ in to_bearing]) for i in planets}
    force = {i: [double(f) for f in many[i].get([source for source, _ in to_gears])] for i in planets}
    for i in planets:
        many[i].set([sink for _, sink in to_bearing], motion[i])
        one.set([name(sink, i) for _, sink in to_gears], force[i])
exchange()
exchange()
for model in (one, *many.values()):
    model.fmu.exitInitializationMode()
rows = []
for k in range(steps + 1):
    if k > 0:
        exchange()
        for model in (one, *many.values()):
            model.fmu.doStep(currentCommunicationPoint=(k - 1) * size, communicationStepSize=size)
    rows.append([one.get([f"planet[{i}].{q}"])[0] for i in planets for q in seen])
print("\\n" + json.dumps(rows))
for model in (one, *many.values()):
    model.fmu.freeInstance()
    shutil.rmtree(model.folder)
"""


def rows_of(program, fmus):
    done = subprocess.run([PYTHON, "-c", program, *fmus, str(STEPS)], capture_output=True, text=True)
    if done.returncode:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout.splitlines()[-1])


class Master(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def fmus(self, version):
        files = []
        for model in ("gearset", "bearing"):
            files.append(pathlib.Path(self.folder.name, f"{model}{version}.fmu"))
            subprocess.run([os.environ["ORBEARING"], "fmu", CASE, "-o", files[-1], "--fmi", str(version), "--model",
                            model, "--quiet"], check=True, capture_output=True)
        return files

    def check(self, rows, expected):
        self.assertEqual(len(rows), STEPS + 1)
        largest = 0.0
        for column in range(len(expected[0])):
            size = max(abs(row[column]) for row in expected)
            worst = max(abs(row[column] - other[column]) for row, other in zip(rows, expected))
            largest = max(largest, worst / size)
            self.assertLess(worst, ROUND_OFF * size, f"column {column}")
        print(f"from the exchange by hand at most {largest:.1e}")
        # The bearings had an effect: the planet is where its gears alone do not take it.
        self.assertGreater(abs(expected[-1][0] - expected[0][0]), 1e-3 * abs(expected[0][0]))

    def test_pair_moves_as_by_hand(self):
        by_hand = rows_of(BY_HAND, self.fmus(2))
        for version in (2, 3):
            self.check(rows_of(BY_ECOS, self.fmus(version)), by_hand)


if __name__ == "__main__":
    left_to_full("a second tool of others; fmu_fmpy.py tries the same FMUs in FMPy")
    PYTHON = interpreter_with(*PACKAGES)
    unittest.main()
