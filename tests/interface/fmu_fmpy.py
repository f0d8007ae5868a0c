#!/usr/bin/env python3
"""Our FMUs in FMPy, a tool that is not ours: valid, and with the results of what is inside.

Needs ORBEARING and ORBEARING_MACHINE_RUN. Skipped where FMPy (PyPI) cannot be installed.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from virtual_environment import interpreter_with

FMPY = "fmpy==0.3.32"
CASE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"], "cases", "reducer_150kW", "case.yaml")
STEP = 1e-5  # [s]
STEPS = 30
# [-] The same operations on the same numbers; the text of the comparison has all digits.
ROUND_OFF = 1e-9
BEARING_INPUTS = ("planet.displacement.x", "planet.displacement.y", "planet.velocity.x", "planet.velocity.y",
                  "planet.speed", "carrier.speed", "carrier.acceleration")
BEARING_OUTPUTS = ("force.x", "force.y", "moment", "life_used", "cage.speed", "roller[1].inner_load",
                   "roller[1].outer_load")
GEAR_INPUTS = tuple(f"planet[{i}].{name}" for i in range(1, 5) for name in ("force.x", "force.y", "moment"))
GEAR_OUTPUTS = tuple("planet[1]." + name for name in ("displacement.x", "displacement.y", "velocity.x", "velocity.y",
                                                      "speed", "sun_mesh_force", "ring_mesh_force"))


def inputs_at(model, step):
    """A motion that the bearing feels, or forces about those of the mean load."""
    phase = 2 * math.pi * step / 17
    if model == "bearing":
        swing = 2 * math.pi / (17 * STEP)
        return [2e-6 + 1e-6 * math.sin(phase), 25e-6 + 2e-6 * math.cos(phase),
                1e-6 * swing * math.cos(phase), -2e-6 * swing * math.sin(phase), -720.0, 200.0, 10.0]
    return [value for i in range(4) for value in (50.0 * math.sin(phase + i), -1900.0 + 100.0 * math.cos(phase), 0.5)]


def slopes_at(step):
    """Slopes of both velocities of the bearing's motion above, which swing."""
    phase, swing = 2 * math.pi * step / 17, 2 * math.pi / (17 * STEP)
    return [-1e-6 * swing**2 * math.sin(phase), -2e-6 * swing**2 * math.cos(phase)]


class Fmu:
    """One unpacked FMU; instances are made of it."""

    def __init__(self, file, folder, model, version):
        self.file, self.model, self.version = str(file), model, version
        self.description = fmpy.read_model_description(self.file)
        self.folder = str(fmpy.extract(self.file, unzipdir=str(folder)))
        self.references = {v.name: v.valueReference for v in self.description.modelVariables}
        self.inputs = BEARING_INPUTS if model == "bearing" else GEAR_INPUTS
        self.outputs = BEARING_OUTPUTS if model == "bearing" else GEAR_OUTPUTS

    def instance(self, begin=True):
        kind = fmpy.fmi3.FMU3Slave if self.version == 3 else fmpy.fmi2.FMU2Slave
        token = self.description.instantiationToken if self.version == 3 else self.description.guid
        slave = kind(guid=token, unzipDirectory=self.folder, instanceName="one",
                     modelIdentifier=self.description.coSimulation.modelIdentifier)
        slave.instantiate()
        if begin:
            if self.version == 2:
                slave.setupExperiment(startTime=0.0)
            self.set(slave, 0)
            slave.enterInitializationMode()
            slave.exitInitializationMode()
        return slave

    def of(self, names):
        return [self.references[name] for name in names]

    def set(self, slave, step):
        (slave.setFloat64 if self.version == 3 else slave.setReal)(self.of(self.inputs), inputs_at(self.model, step))

    def get(self, slave):
        return list((slave.getFloat64 if self.version == 3 else slave.getReal)(self.of(self.outputs)))

    def run(self, slave, first, last, sloping=False):
        for step in range(first, last):
            self.set(slave, step)
            if sloping:
                slave.setRealInputDerivatives(self.of(BEARING_INPUTS[2:4]), [1, 1], slopes_at(step))
            slave.doStep(step * STEP, STEP)
        return self.get(slave)


def machine_outputs(fmu, sloping=False):
    lines = "".join(" ".join(repr(x) for x in [STEP, *inputs_at(fmu.model, step), *(slopes_at(step) if sloping else ())])
                    + "\n" for step in range(STEPS))
    done = subprocess.run([os.environ["ORBEARING_MACHINE_RUN"], str(pathlib.Path(fmu.folder, "resources"))],
                          input=lines, capture_output=True, text=True, check=True)
    return [float(word) for word in done.stdout.splitlines()[-1].split()]


class InFmpy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory(prefix="fmus of 100 % ä ")
        cls.addClassCleanup(cls.place.cleanup)
        cls.fmus = []
        for model in ("bearing", "gearset"):
            for version in (2, 3):
                file = pathlib.Path(cls.place.name, f"{model}{version}.fmu")
                subprocess.run([os.environ["ORBEARING"], "fmu", CASE, "-o", file, "--fmi", str(version), "--model",
                                model, "--quiet"], check=True)
                cls.fmus.append(Fmu(file, file.with_suffix(""), model, version))

    def each(self):
        for fmu in self.fmus:
            with self.subTest(model=fmu.model, fmi=fmu.version):
                yield fmu

    def test_no_problem_is_found(self):
        for fmu in self.each():
            self.assertEqual(fmpy.validation.validate_fmu(fmu.file), [])

    def test_results_are_those_of_the_machine(self):
        for fmu in self.each():
            found, expected = fmu.run(fmu.instance(), 0, STEPS), machine_outputs(fmu)
            self.assertEqual(len(found), len(expected))
            worst = max(abs(a - b) / abs(b) for a, b in zip(found, expected))
            print(f"{fmu.model}, FMI {fmu.version}.0: largest relative difference {worst:.1e}")
            self.assertLess(worst, ROUND_OFF)

    def test_a_package_is_read_and_simulated(self):
        """FMPy knows no LinearTransformation, so that a planet has one bearing here."""
        file = pathlib.Path(self.place.name, "one.ssp")
        subprocess.run([os.environ["ORBEARING"], "fmu", CASE, "-o", file, "--quiet", "--set", "bearing.per_planet=1"], check=True)
        system = fmpy.ssp.ssd.read_ssd(str(file)).system
        self.assertEqual((len(system.elements), len(system.connections)), (5, 40))
        rows = fmpy.ssp.simulation.simulate_ssp(str(file), stop_time=10e-6, step_size=1e-6)
        for i in range(1, 5):
            self.assertGreater(abs(rows[f"bearing_{i}.force.y"][-1]), 1e3)  # both meshes press with 2129 N
            self.assertEqual(rows[f"bearing_{i}.force.y"][-1], rows[f"gears.planet[{i}].force.y"][-1])

    def test_slopes_of_inputs_are_felt_as_by_the_machine(self):
        for fmu in self.each():
            if fmu.model != "bearing" or fmu.version != 2:  # FMI 3.0 has none
                continue
            found, expected = fmu.run(fmu.instance(), 0, STEPS, True), machine_outputs(fmu, True)
            self.assertLess(max(abs(a - b) / abs(b) for a, b in zip(found, expected)), ROUND_OFF)
            held = machine_outputs(fmu)
            self.assertGreater(math.dist(held[:2], expected[:2]), 1e-3 * math.hypot(*expected[:2]))  # of the force

    def test_directional_derivatives_are_slopes_of_the_force(self):
        step = 1e-10  # [m]
        for fmu in self.each():
            if fmu.model != "bearing":
                continue
            slave = fmu.instance()
            fmu.run(slave, 0, 5)
            unknown, known = fmu.of(["force.y"]), fmu.of(["planet.displacement.y"])
            (found,) = slave.getDirectionalDerivative(unknown, known, [1.0])
            get = slave.getFloat64 if fmu.version == 3 else slave.getReal
            put = slave.setFloat64 if fmu.version == 3 else slave.setReal
            (middle,) = get(known)
            force = []
            for sign in (1, -1):
                put(known, [middle + sign * step])
                force += get(unknown)
            slope = (force[0] - force[1]) / (2 * step)
            self.assertLess(slope, 0.0)
            # Curvature of the contacts; round-off of 1e4 N over the step.
            self.assertLess(abs(found - slope), 1e-4 * abs(slope) + 1e-11 * 1e4 / step)

    def test_simulation_by_fmpy_itself(self):
        results = {}
        for fmu in self.each():
            start = dict(zip(BEARING_INPUTS[:2], (2e-6, 25e-6))) if fmu.model == "bearing" else {}
            rows = fmpy.simulate_fmu(fmu.file, stop_time=STEPS * STEP, output_interval=STEP, start_values=start,
                                     output=list(fmu.outputs))
            self.assertEqual(len(rows), STEPS + 1)
            results.setdefault(fmu.model, []).append(rows[-1].tolist())
        for two, three in results.values():
            self.assertEqual(two, three)

    def test_starts_are_the_built_in_ones(self):
        for fmu in self.each():
            slave = fmu.instance(begin=False)
            get = slave.getFloat64 if fmu.version == 3 else slave.getReal
            shown = [v for v in fmu.description.modelVariables if v.start is not None and v.variability != "constant"]
            self.assertGreater(len(shown), 20)
            self.assertEqual(list(get([v.valueReference for v in shown])), [float(v.start) for v in shown])

    def test_two_instances_side_by_side_and_a_new_one(self):
        for fmu in self.each():
            alone = fmu.run(fmu.instance(), 0, 8)
            first, second = fmu.instance(), fmu.instance()
            for step in range(8):
                fmu.run(first, step, step + 1)
                if step % 2:
                    fmu.run(second, step // 2, step // 2 + 1)
            self.assertEqual(fmu.get(first), alone)
            self.assertNotEqual(fmu.get(second), alone)
            first.terminate()
            first.freeInstance()
            self.assertEqual(fmu.run(fmu.instance(), 0, 8), alone)

    def test_a_state_gives_the_same_bits_here_and_in_another_process(self):
        for fmu in self.each():
            slave = fmu.instance()
            fmu.run(slave, 0, 5)
            state = slave.getFMUState()
            first = fmu.run(slave, 5, 12)
            slave.setFMUState(state)
            self.assertEqual(fmu.run(slave, 5, 12), first)
            content = slave.serializeFMUState(state)
            slave.freeFMUState(state)
            request = {"file": fmu.file, "folder": fmu.folder + " again", "model": fmu.model,
                       "version": fmu.version, "state": bytes(content).hex()}
            done = subprocess.run([sys.executable, __file__, "--go-on"], input=json.dumps(request), text=True,
                                  capture_output=True, check=True)
            self.assertEqual(json.loads(done.stdout), first)


def go_on():
    """The other process: from a state as bytes to the end."""
    request = json.load(sys.stdin)
    fmu = Fmu(request["file"], request["folder"], request["model"], request["version"])
    slave = fmu.instance(begin=False)
    slave.setFMUState(slave.deserializeFMUState(bytes.fromhex(request["state"])))
    print(json.dumps(fmu.run(slave, 5, 12)))


if __name__ == "__main__":
    try:
        import fmpy
        import fmpy.fmi2
        import fmpy.fmi3
        import fmpy.ssp.simulation
        import fmpy.validation
    except ImportError:
        python = interpreter_with(FMPY)
        os.execv(python, [str(python), __file__, *sys.argv[1:]])
    if sys.argv[1:] == ["--go-on"]:
        go_on()
    else:
        unittest.main()
