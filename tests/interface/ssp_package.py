#!/usr/bin/env python3
"""Gear set, planet bearings and parameters as a package of SSP 1.0 [SSP1], by what the format requires, and simulated.

The master here is made for this test: it takes elements, connections and parameters from the package alone and calls the C functions of FMI 2.0.
"""

import ctypes
import json
import os
import pathlib
import re
import tempfile
import unittest
import xml.etree.ElementTree as tree
import zipfile

from program import CASES, REDUCER, package, run

orbearing = package()

STEPS, SIZE = 60, 1e-6  # [s]
ROUND_OFF = 1e-9  # the same operations; the master multiplies forces in its own way
SSD, SSC, SSV = ("{http://ssp-standard.org/SSP1/SystemStructure%s}" % end for end in ("Description", "Common", "ParameterValues"))
# Elements of the format that are written: required attributes, optional ones, and their parts in their order.
FORMAT = {
    SSD + "SystemStructureDescription": ("version name", "generationTool", [SSD + "System", SSD + "Units", SSD + "DefaultExperiment"]),
    SSD + "System": ("name", "description", [SSD + "Elements", SSD + "Connections"]),
    SSD + "Elements": ("", "", [SSD + "Component"]),
    SSD + "Component": ("name source", "type implementation", [SSD + "Connectors", SSD + "ParameterBindings"]),
    SSD + "Connectors": ("", "", [SSD + "Connector"]),
    SSD + "Connector": ("name kind", "", [SSC + "Real", SSC + "Integer", SSC + "Boolean"]),
    SSD + "ParameterBindings": ("", "", [SSD + "ParameterBinding"]),
    SSD + "ParameterBinding": ("", "type source", []),
    SSD + "Connections": ("", "", [SSD + "Connection"]),
    SSD + "Connection": ("startConnector endConnector", "startElement endElement", [SSC + "LinearTransformation"]),
    SSD + "Units": ("", "", [SSC + "Unit"]),
    SSD + "DefaultExperiment": ("", "startTime stopTime", []),
    SSC + "LinearTransformation": ("", "factor offset", []),
    SSC + "Real": ("", "unit", []),
    SSC + "Integer": ("", "", []),
    SSC + "Boolean": ("", "", []),
    SSC + "Unit": ("name", "", [SSC + "BaseUnit"]),
    SSC + "BaseUnit": ("", "kg m s A K mol cd rad factor offset", []),
    SSV + "ParameterSet": ("version name", "generationTool", [SSV + "Parameters", SSV + "Units"]),
    SSV + "Parameters": ("", "", [SSV + "Parameter"]),
    SSV + "Parameter": ("name", "", [SSV + "Real", SSV + "Integer", SSV + "Boolean"]),
    SSV + "Real": ("value", "unit", []),
    SSV + "Integer": ("value", "", []),
    SSV + "Boolean": ("value", "", []),
    SSV + "Units": ("", "", [SSC + "Unit"]),
}


def wrong(element):
    """What the format does not have, in this element and its parts."""
    required, optional, parts = FORMAT.get(element.tag, ("", "", None))
    if parts is None:
        return [element.tag]
    found = [f"{element.tag}: no {name}" for name in required.split() if element.get(name) is None]
    found += [f"{element.tag}: {name}" for name in element.keys() if name not in (required + " " + optional).split()]
    tags = [part.tag for part in element]
    found += [f"{element.tag}: {tag}" for tag in tags if tag not in parts]
    if not found and [parts.index(tag) for tag in tags] != sorted(parts.index(tag) for tag in tags):
        found.append(f"{element.tag}: order of {tags}")
    return found + [text for part in element for text in wrong(part)]


class Callbacks(ctypes.Structure):
    """fmi2CallbackFunctions."""

    LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)
    _fields_ = [("logger", LOGGER), ("allocate", ctypes.c_void_p), ("free", ctypes.c_void_p), ("step_finished", ctypes.c_void_p),
                ("environment", ctypes.c_void_p)]


CALLBACKS = Callbacks(Callbacks.LOGGER(lambda *_: None), None, None, None, None)


class Slave:
    """One instance of an unpacked FMU of FMI 2.0 for Linux."""

    def __init__(self, folder, name):
        root = tree.parse(folder / "modelDescription.xml").getroot()
        self.of = {one.get("name"): int(one.get("valueReference")) for one in root.iter("ScalarVariable")}
        self.library = ctypes.CDLL(str(folder / "binaries" / "linux64" / (root.find("CoSimulation").get("modelIdentifier") + ".so")))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.one = ctypes.c_void_p(self.library.fmi2Instantiate(name.encode(), 1, root.get("guid").encode(), (folder / "resources").as_uri().encode(),
                                                                ctypes.byref(CALLBACKS), 0, 0))
        assert self.one
        self.call("SetupExperiment", 0, ctypes.c_double(0), ctypes.c_double(0), 0, ctypes.c_double(0))

    def call(self, name, *arguments):
        status = getattr(self.library, "fmi2" + name)(self.one, *arguments)
        assert status == 0, (name, status)

    def get(self, name):
        value = ctypes.c_double()
        self.call("GetReal", (ctypes.c_uint * 1)(self.of[name]), ctypes.c_size_t(1), ctypes.byref(value))
        return value.value

    def set(self, name, value):
        self.call("SetReal", (ctypes.c_uint * 1)(self.of[name]), ctypes.c_size_t(1), (ctypes.c_double * 1)(value))

    def begin(self):
        self.call("EnterInitializationMode")

    def start(self):
        self.call("ExitInitializationMode")

    def step(self, time):
        self.call("DoStep", ctypes.c_double(time), ctypes.c_double(SIZE), 1)


def run_system(elements, connections, seen):
    """All exchange in parallel, twice before the first step; (steps, seen)."""

    def exchange():
        values = [factor * elements[start].get(output) for start, output, _, _, factor in connections]
        for (_, _, end, name, _), value in zip(connections, values):
            elements[end].set(name, value)

    exchange()
    exchange()
    for one in elements.values():
        one.start()
    rows = []
    for step in range(STEPS):
        exchange()
        for one in elements.values():
            one.step(step * SIZE)
        rows.append([elements[element].get(name) for element, name in seen])
    return rows


class Live:
    """A participant of this process behind the same calls; before its start each value is that of a new one under the inputs."""

    def __init__(self, make):
        self.make, self.inputs, self.machine, self.started = make, {}, None, False

    def ready(self):
        if self.machine is None:
            self.machine = self.make()
            for name, value in self.inputs.items():
                self.machine.set_input(name, value)
            self.machine.initialize(0.0)
        return self.machine

    def get(self, name):
        return self.ready().output(name)

    def set(self, name, value):
        self.inputs[name] = value
        if self.started:
            self.machine.set_input(name, value)
        else:
            self.machine = None

    def start(self):
        self.ready()
        self.started = True

    def step(self, _time):
        self.machine.advance(SIZE)


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory(prefix="package of 100 % ä ")
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name)
        cls.file = cls.folder / "new" / "reducer.ssp"
        made = run("fmu", REDUCER, "-o", cls.file, "--json", "--set", "bearing.radial_clearance=10 um")
        assert made.returncode == 0, made.stderr
        cls.answer = json.loads(made.stdout)
        cls.names = zipfile.ZipFile(cls.file).namelist()
        with zipfile.ZipFile(cls.file) as archive:
            archive.extractall(cls.folder)
        for name in ("gears", "bearing"):
            with zipfile.ZipFile(cls.folder / "resources" / f"{name}.fmu") as archive:
                archive.extractall(cls.folder / name)
        cls.root = tree.parse(cls.folder / "SystemStructure.ssd").getroot()
        cls.components = {one.get("name"): one for one in cls.root.iter(SSD + "Component")}
        cls.connections = [(one.get("startElement"), one.get("startConnector"), one.get("endElement"), one.get("endConnector"),
                            float(one.find(SSC + "LinearTransformation").get("factor")) if len(one) else 1.0) for one in cls.root.iter(SSD + "Connection")]

    def model_of(self, component):
        return tree.parse(self.folder / pathlib.Path(component.get("source")).stem / "modelDescription.xml").getroot()

    def variables(self, model):
        return {one.get("name"): (one.get("causality"), one[0].tag, one[0].get("unit"), one[0].get("start")) for one in model.iter("ScalarVariable")}

    def test_the_archive_and_the_structure_are_those_of_the_format(self):
        self.assertEqual(set(self.names), {"SystemStructure.ssd", *(f"resources/{name}.{end}" for name in ("gears", "bearing") for end in ("fmu", "ssv"))})
        self.assertEqual(self.root.tag, SSD + "SystemStructureDescription")
        self.assertEqual(self.root.get("version"), "1.0")
        self.assertEqual(wrong(self.root), [])
        self.assertEqual(list(self.components), ["gears", "bearing_1", "bearing_2", "bearing_3", "bearing_4"])
        self.assertEqual((self.answer["planets"], self.answer["bearings_per_planet"], self.answer["connections"]), (4, 2, 40))
        for component in self.components.values():
            self.assertIn(component.get("source"), self.names)
            self.assertEqual(component.get("type"), "application/x-fmu-sharedlibrary")

    def test_each_connector_is_a_variable_of_its_fmu_with_kind_type_and_unit(self):
        units = {one.get("name"): one.find(SSC + "BaseUnit").attrib for one in self.root.iter(SSC + "Unit")}
        for component in self.components.values():
            model = self.model_of(component)
            variables = self.variables(model)
            connectors = {one.get("name"): (one.get("kind"), one[0].tag.removeprefix(SSC), one[0].get("unit")) for one in component.iter(SSD + "Connector")}
            self.assertEqual(connectors, {name: row[:3] for name, row in variables.items() if row[0] in ("input", "output", "parameter")})
            for unit in model.iter("Unit"):
                self.assertEqual(units[unit.get("name")], unit.find("BaseUnit").attrib)
            self.assertLessEqual({unit for _, _, unit in connectors.values() if unit}, set(units))

    def test_connections_join_an_output_to_an_input_once(self):
        kinds = {(name, one.get("name")): (one.get("kind"), one[0].get("unit")) for name, component in self.components.items()
                 for one in component.iter(SSD + "Connector")}
        ends = [(end, name) for _, _, end, name, _ in self.connections]
        self.assertEqual(len(ends), len(set(ends)))
        self.assertEqual(set(ends), {key for key, (kind, _) in kinds.items() if kind == "input"})
        for start, output, end, name, factor in self.connections:
            self.assertEqual(kinds[start, output], ("output", kinds[end, name][1]))
            self.assertEqual(factor, 2.0 if end == "gears" else 1.0)  # a planet sits on two bearings, which are one here

    def test_parameters_are_those_of_the_case(self):
        for component in self.components.values():
            (binding,) = component.iter(SSD + "ParameterBinding")
            values = tree.parse(self.folder / binding.get("source")).getroot()
            self.assertEqual((values.tag, values.get("version"), wrong(values)), (SSV + "ParameterSet", "1.0", []))
            stated = {one.get("name"): ("parameter", one[0].tag.removeprefix(SSV), one[0].get("unit"), one[0].get("value")) for one in values.iter(SSV + "Parameter")}
            self.assertEqual(stated, {name: row for name, row in self.variables(self.model_of(component)).items() if row[0] == "parameter"})
            units = {one.get("name") for one in values.iter(SSC + "Unit")}
            self.assertLessEqual({row[2] for row in stated.values() if row[2]}, units)
            if component.get("name") != "gears":
                self.assertAlmostEqual(float(stated["bearing.radial_clearance"][3]), 10e-6, delta=1e-18)

    def test_simulated_it_moves_as_the_parts_in_this_process(self):
        elements = {name: Slave(self.folder / pathlib.Path(one.get("source")).stem, name) for name, one in self.components.items()}
        for name, component in self.components.items():
            file = next(component.iter(SSD + "ParameterBinding")).get("source")
            for one in tree.parse(self.folder / file).getroot().iter(SSV + "Parameter"):
                if one[0].tag == SSV + "Real":
                    elements[name].set(one.get("name"), float(one[0].get("value")))
            elements[name].begin()
        seen = [("gears", f"planet[{i}].{name}") for i in range(1, 5) for name in ("displacement.x", "displacement.y", "speed")]
        seen += [(f"bearing_{i}", "force.y") for i in range(1, 5)]
        found = run_system(elements, self.connections, seen)
        case = orbearing.load(REDUCER, {"bearing.radial_clearance": "10 um"})
        live = {"gears": Live(case.gears), **{f"bearing_{i}": Live(case.bearing) for i in range(1, 5)}}
        by_hand = []
        for i in range(1, 5):
            motion = [f"planet.{name}" for name in ("displacement.x", "displacement.y", "velocity.x", "velocity.y", "speed")]
            by_hand += [("gears", name.replace("planet.", f"planet[{i}]."), f"bearing_{i}", name, 1.0) for name in motion]
            by_hand += [("gears", name, f"bearing_{i}", name, 1.0) for name in ("carrier.speed", "carrier.acceleration")]
            by_hand += [(f"bearing_{i}", name, "gears", f"planet[{i}].{name}", 2.0) for name in ("force.x", "force.y", "moment")]
        direct = run_system(live, by_hand, seen)
        for k, (element, name) in enumerate(seen):
            size = max(abs(row[k]) for row in direct)
            worst = max(abs(one[k] - other[k]) for one, other in zip(found, direct))
            self.assertLessEqual(worst, ROUND_OFF * size, (element, name))
        self.assertGreater(abs(direct[-1][0] - direct[0][0]), 1e-4 * abs(direct[0][0]))

    def test_equal_cases_give_equal_packages(self):
        from orbearing import ssp

        other = self.folder / "other.ssp"
        ssp.write(orbearing.load(REDUCER, {"bearing.radial_clearance": "10 um"}), other)
        self.assertEqual(other.read_bytes(), self.file.read_bytes())

    def test_refusals(self):
        for case, options, text in (
                (REDUCER, ("--fmi", "3"), "--output: found '--fmi 3' together with"),
                (REDUCER, ("--model", "gearset"), "--output: found '--model gearset' together with"),
                (CASES / "lin_parker_1999" / "case.yaml", (), "bearing: found no bearing; required: a planet bearing"),
                (CASES / "harris_209" / "case.yaml", (), "planetary-drivetrain"),
                (REDUCER, ("--set", "bearing.rollers=0"), "--set: bearing.rollers: '0' is out of range"),
                (self.folder / "none.yaml", (), "none.yaml")):
            with self.subTest(text):
                made = run("fmu", case, "-o", self.folder / "no.ssp", *options)
                self.assertEqual(made.returncode, 2, made.stderr)
                self.assertIn(text, made.stderr)
                self.assertFalse((self.folder / "no.ssp").exists())
        closed = run("fmu", REDUCER, "-o", "/proc/none/a.ssp", "--quiet")
        self.assertEqual((closed.returncode, closed.stdout), (1, ""))
        self.assertRegex(closed.stderr, re.escape("--output: /proc/none") + ".*no package was written")


if __name__ == "__main__":
    unittest.main()
