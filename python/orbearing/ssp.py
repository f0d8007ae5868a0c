"""`orbearing fmu CASE -o FILE.ssp`: gear set, planet bearings and their parameters as one system of FMUs; `python3 -m orbearing.ssp` is the same.

System Structure and Parameterization 1.0 [SSP1] with FMUs of FMI 2.0. A planet sits on one bearing FMU: all bearings of a planet are alike and carry the same, so
that the connection multiplies the forces of one by their number.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import xml.etree.ElementTree as tree
import zipfile
from dataclasses import dataclass
from pathlib import Path

from orbearing import _core
from orbearing.case import Case, PathLike, load
from orbearing.errors import CaseError, ComputationError
from orbearing.terminal import Parser, exit_code, finished, settings_of

NAMESPACES = {name: f"http://ssp-standard.org/SSP1/SystemStructure{end}" for name, end in
              (("ssd", "Description"), ("ssc", "Common"), ("ssv", "ParameterValues"))}
KINDS = ("input", "output", "parameter")
TYPES = ("Real", "Integer", "Boolean", "String")
GEARS, BEARING = "gears", "bearing"
# Quantities of one planet: of the gear set with planet[i] before them, of the bearing as here.
MOTION = tuple(f"planet.{name}" for name in ("displacement.x", "displacement.y", "velocity.x", "velocity.y", "speed"))
CARRIER = ("carrier.speed", "carrier.acceleration")
FORCES = ("force.x", "force.y", "moment")
LONG_AGO = (1980, 1, 1, 0, 0, 0)  # the date of each file, so that equal cases give equal packages


@dataclass(frozen=True)
class Variable:
    """A variable of an FMU as its modelDescription.xml has it."""

    name: str
    kind: str
    type: str
    unit: str | None
    start: str | None


@dataclass(frozen=True)
class Fmu:
    """One FMU: its file and what its modelDescription.xml states."""

    content: bytes
    variables: dict[str, Variable]
    units: dict[str, dict[str, str]]  # exponents of the base units
    stop_time: str

    def of_kind(self, kind: str) -> list[Variable]:
        return [one for one in self.variables.values() if one.kind == kind]


def read_fmu(file: Path) -> Fmu:
    """An FMU of FMI 2.0."""
    with zipfile.ZipFile(file) as archive:
        root = tree.fromstring(archive.read("modelDescription.xml"))
    variables = {}
    for one in root.iter("ScalarVariable"):
        typed = next(child for child in one if child.tag in TYPES)
        variables[one.get("name")] = Variable(one.get("name"), one.get("causality"), typed.tag, typed.get("unit"), typed.get("start"))
    units = {one.get("name"): dict(one.find("BaseUnit").attrib) for one in root.iter("Unit")}
    return Fmu(file.read_bytes(), variables, units, root.find("DefaultExperiment").get("stopTime"))


def planets_of(gears: Fmu) -> int:
    return sum(name.startswith("planet[") and name.endswith("].force.x") for name in gears.variables)


def connections(planets: int) -> list[tuple[str, str, str, str]]:
    """Element and connector of each start and end, for every planet: motion of planet and carrier to the bearing, forces back."""
    rows = []
    for i in range(1, planets + 1):
        bearing = f"{BEARING}_{i}"
        rows += [(GEARS, name.replace("planet", f"planet[{i}]"), bearing, name) for name in MOTION]
        rows += [(GEARS, name, bearing, name) for name in CARRIER]
        rows += [(bearing, name, GEARS, f"planet[{i}].{name}") for name in FORCES]
    return rows


def _named(tag: str) -> str:
    prefix, name = tag.split(":")
    return f"{{{NAMESPACES[prefix]}}}{name}"


def _child(parent: tree.Element, tag: str, /, **attributes: str | None) -> tree.Element:
    return tree.SubElement(parent, _named(tag), {key: value for key, value in attributes.items() if value is not None})


def _text(root: tree.Element) -> bytes:
    for prefix, address in NAMESPACES.items():
        tree.register_namespace(prefix, address)
    tree.indent(root)
    return tree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"


def _add_units(parent: tree.Element, prefix: str, units: dict[str, dict[str, str]]) -> None:
    block = _child(parent, f"{prefix}:Units")
    for name, exponents in sorted(units.items()):
        tree.SubElement(_child(block, "ssc:Unit", name=name), _named("ssc:BaseUnit"), exponents)


def _add_component(elements: tree.Element, name: str, file: str, fmu: Fmu) -> None:
    component = _child(elements, "ssd:Component", name=name, type="application/x-fmu-sharedlibrary", source=f"resources/{file}.fmu", implementation="CoSimulation")
    connectors = _child(component, "ssd:Connectors")
    for kind in KINDS:
        for variable in fmu.of_kind(kind):
            connector = _child(connectors, "ssd:Connector", name=variable.name, kind=kind)
            _child(connector, f"ssc:{variable.type}", unit=variable.unit)
    _child(_child(component, "ssd:ParameterBindings"), "ssd:ParameterBinding", type="application/x-ssp-parameter-set", source=f"resources/{file}.ssv")


def structure(name: str, gears: Fmu, bearing: Fmu, per_planet: int, version: str) -> bytes:
    """SystemStructure.ssd."""
    root = tree.Element(_named("ssd:SystemStructureDescription"), version="1.0", name=name, generationTool=f"Orbearing {version}")
    system = _child(root, "ssd:System", name="planetary_set", description=f"gear set and planet bearings of {name}")
    elements = _child(system, "ssd:Elements")
    planets = planets_of(gears)
    _add_component(elements, GEARS, GEARS, gears)
    for i in range(1, planets + 1):
        _add_component(elements, f"{BEARING}_{i}", BEARING, bearing)
    joined = _child(system, "ssd:Connections")
    for start, output, end, input_ in connections(planets):
        one = _child(joined, "ssd:Connection", startElement=start, startConnector=output, endElement=end, endConnector=input_)
        if end == GEARS and per_planet > 1:
            _child(one, "ssc:LinearTransformation", factor=f"{per_planet}.0")
    _add_units(root, "ssd", {**gears.units, **bearing.units})
    _child(root, "ssd:DefaultExperiment", startTime="0", stopTime=gears.stop_time)
    return _text(root)


def parameters(name: str, fmu: Fmu, version: str) -> bytes:
    """Parameters of an FMU with the values of the case, an .ssv file."""
    root = tree.Element(_named("ssv:ParameterSet"), version="1.0", name=name, generationTool=f"Orbearing {version}")
    block = _child(root, "ssv:Parameters")
    for variable in fmu.of_kind("parameter"):
        if variable.start is not None:
            _child(_child(block, "ssv:Parameter", name=variable.name), f"ssv:{variable.type}", value=variable.start, unit=variable.unit)
    _add_units(root, "ssv", fmu.units)
    return _text(root)


@dataclass(frozen=True)
class Package:
    """What was written."""

    file: str
    planets: int
    bearings_per_planet: int
    connections: int
    parameters: int
    warnings: list[str]


def write(case: Case, path: PathLike, windows: bool = False, progress=None) -> Package:
    """The package of a case with one planetary set and planet bearings. windows, progress: as of Case.fmu()."""
    file = Path(path)
    if file.suffix != ".ssp" or file.is_dir():
        raise CaseError(f"--output: found '{file}'; required: a file that ends with .ssp")
    made, warnings = {}, []
    with tempfile.TemporaryDirectory() as folder:
        for name, model in ((BEARING, "bearing"), (GEARS, "gearset")):
            fmu = Path(folder) / f"{name}.fmu"
            result = case.fmu(fmu, fmi=2, model=model, windows=windows, progress=progress)
            warnings += [text for text in result["warnings"] if text not in warnings]
            made[name] = read_fmu(fmu)
    version, per_planet = result["versions"]["orbearing"], int(case["bearing.per_planet"])
    gears, bearing = made[GEARS], made[BEARING]
    content = {"SystemStructure.ssd": structure(case.name, gears, bearing, per_planet, version)}
    for name, fmu in made.items():
        content[f"resources/{name}.fmu"] = fmu.content
        content[f"resources/{name}.ssv"] = parameters(name, fmu, version)
    _store(file, content)
    planets = planets_of(gears)
    return Package(str(file), planets, per_planet, len(connections(planets)), sum(len(fmu.of_kind("parameter")) for fmu in made.values()), warnings)


def _store(file: Path, content: dict[str, bytes]) -> None:
    """Written beside the file and renamed, so that a failure leaves nothing."""
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=file.parent, prefix=".ssp-") as aside:
            whole = Path(aside) / file.name
            with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
                for name, data in content.items():
                    archive.writestr(zipfile.ZipInfo(name, LONG_AGO), data, zipfile.ZIP_DEFLATED)
            whole.replace(file)
    except OSError as error:
        raise ComputationError(f"--output: {error.filename or file}: cannot be written: {error.strerror}; no package was written") from None


def main(arguments: list[str] | None = None) -> int:
    """The command; the exit code."""
    parser = Parser(prog="orbearing fmu", allow_abbrev=False, description="A system structure package (SSP 1.0): gear set, planet bearings, parameters.")
    parser.add_argument("case", metavar="CASE", help="case file, or a folder with case.yaml")
    parser.add_argument("-o", "--output", metavar="FILE.ssp", required=True, help="the package; its folder is made where it is missing")
    parser.add_argument("--set", metavar="PATH=VALUE", action="append", default=[], help="replaces an input; repeatable")
    parser.add_argument("--windows", action="store_true", help="add the libraries for Windows; the first use builds them")
    parser.add_argument("--json", action="store_true", help="print the result as one JSON object")
    parser.add_argument("--quiet", action="store_true", help="print nothing but errors")
    options = parser.parse_args(arguments)
    return exit_code("orbearing fmu", lambda: _run(options), "numpy (Debian: python3-numpy)")


def _run(options: argparse.Namespace) -> int:
    settings = settings_of(options.set)
    _core.load(options.case, settings)  # its messages name --set
    package = write(load(options.case, dict(settings)), options.output, options.windows, None if options.quiet or not sys.stderr.isatty() else True)
    if options.json:
        import json

        print(json.dumps({**vars(package), "units": {}}, indent=2))
    elif not options.quiet:
        print(f"{package.file}: SSP 1.0, gear set and {package.planets} bearings by FMI 2.0, {package.connections} connections, {package.parameters} parameters")
        for text in package.warnings:
            print(f"warning: {text}")
    return 0


if __name__ == "__main__":
    sys.exit(finished(main))
