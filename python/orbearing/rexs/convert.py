"""A REXS file into cases and a report of what was taken, what is missing and what was left out."""

from __future__ import annotations

import json
import re
import unicodedata
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional

from orbearing.errors import CaseError
from orbearing.rexs.drive import GEARED, Drive, planetary
from orbearing.rexs.ledger import Ledger
from orbearing.rexs.model import Component, Model
from orbearing.rexs.names import attribute_of, number_of
from orbearing.rexs.pairs import BearingCase, PairCase
from orbearing.rexs.parts import Source, filler, is_bearing
from orbearing.rexs.reactions import bearing_forces
from orbearing.rexs.stages import StageCase
from orbearing.rexs.writing import checked, shortened, warnings_of
from orbearing.whole_files import write_whole

FIGURES = {"rpm": "rpm", "N_m": "N.m", "N": "N", "Hz": "Hz", "mm": "mm"}
REPORT = "conversion.json"


@dataclass
class Conversion:
    """The report and the texts of the cases by name; those that the check refuses stand apart."""

    report: dict[str, Any]
    cases: dict[str, str] = field(default_factory=dict)
    incomplete: dict[str, str] = field(default_factory=dict)
    bearings: dict[str, list[list[Component]]] = field(default_factory=dict)  # by case: those of each planet

    @property
    def is_complete(self) -> bool:
        """Whether there is a planetary stage, and a case for each."""
        stages = self.report["stages"]
        return bool(stages) and all(stage["case"] for stage in stages)


class Names:
    """Names of cases: letters and digits of the part's own name, each once."""

    def __init__(self) -> None:
        self._used: set[str] = set()

    def of(self, component: Component, kind: str) -> str:
        own = component.name.split("@")[0].replace("\u00df", "ss")
        for umlaut, letters in (("\u00e4", "ae"), ("\u00f6", "oe"), ("\u00fc", "ue")):
            own = own.replace(umlaut, letters).replace(umlaut.upper(), letters.capitalize())
        plain = unicodedata.normalize("NFKD", own).encode("ascii", "ignore").decode().lower()
        name = re.sub(r"[^a-z0-9]+", "_", plain).strip("_")
        name = name if re.search("[a-z]", name) else f"{kind}_{component.id}"
        if name in self._used:
            name = f"{name}_{component.id}"
        self._used.add(name)
        return name


def convert(model: Model, source: str, form: str) -> Conversion:
    """Cases of the planetary stages; without any, of the gear pairs and bearings."""
    ledger = Ledger(model)
    text = f"REXS {model.version} file {source}" + (f" of {model.application}" if model.application else "")
    parts = Source(model, ledger, text)
    conversion = Conversion({"source": source, "form": form, "version": model.version, "application": model.application,
                             "stages": [], "pairs": [], "bearings": [], "notes": list(model.notes)})
    found = [(stage, planetary(model, stage)) for stage in model.of_type("planetary_stage")]
    drive = Drive(model, [one for _, one in found if not isinstance(one, str)])
    names = Names()
    for stage, one in found:
        builder = None if isinstance(one, str) else StageCase(parts, drive, one, names.of(stage, "stage"))
        _add(conversion, ledger, "stages", stage, builder, "" if builder else one)
    if not found:
        loaded, load = _loaded(model)
        _, speeds, notes = drive.members(loaded)
        conversion.report["notes"] += notes
        _add_pairs(conversion, ledger, parts, drive, names, speeds)
        _add_bearings(conversion, ledger, parts, drive, names, speeds, bearing_forces(drive, loaded), load)
    ledger.close()
    conversion.report |= {"taken": ledger.taken, "missing": ledger.missing, "left_out": ledger.left_out, "units": _units(conversion.report)}
    return conversion


def _loaded(model: Model) -> tuple[Model, str]:
    """The model at its own loads, else at the load case that acts longest, and what to call that."""
    if not model.load_cases or any(attribute_of(load, name) for load in model.of_type("external_load") for name in ("torque", "load_power")):
        return model, "the loads of the file"
    cases = [model.with_load_case(one) for one in model.load_cases]
    shares = [max((number_of(unit, name).number or 0.0 for unit in one.of_type("gear_unit") for name in ("share", "duration")), default=0.0)
              for one in cases]
    longest = shares.index(max(shares))
    return cases[longest], f"load case {model.load_cases[longest].id}" + (" (the longest)" if len(cases) > 1 else "")


def _add_pairs(conversion: Conversion, ledger: Ledger, parts: Source, drive: Drive, names: Names,
               speeds: dict) -> None:
    for mesh in parts.model.of_type(*GEARED):
        if mesh.type == "cylindrical_stage":
            _add(conversion, ledger, "pairs", mesh, PairCase(parts, drive, mesh, names.of(mesh, "pair"), speeds))
        else:
            _add(conversion, ledger, "pairs", mesh, None, "a bevel stage: cylindrical gears are known")
    for mesh in parts.model.of_type("worm_stage"):
        _add(conversion, ledger, "pairs", mesh, None, "a worm stage: cylindrical gears are known")


def _add_bearings(conversion: Conversion, ledger: Ledger, parts: Source, drive: Drive, names: Names,
                  speeds: dict, forces: dict, load: str) -> None:
    model = parts.model
    for relation in model.related("side"):
        bearing, inner, outer = (model.components.get(relation.part(role) or -1) for role in ("assembly", "inner_part", "outer_part"))
        if is_bearing(bearing) and inner is not None and outer is not None:
            _add(conversion, ledger, "bearings", bearing, BearingCase(parts, drive, bearing, inner, outer, names.of(bearing, "bearing"),
                                                                         forces, speeds, load))


def _add(conversion: Conversion, ledger: Ledger, kind: str, component: Component, builder: Optional[Any], problem: str = "") -> None:
    """Builds, checks and files one case."""
    entry: dict[str, Any] = {"component": component.id, "type": component.type, "name": component.name, "case": None}
    conversion.report[kind].append(entry)
    if builder is None:
        entry["problems"] = [problem]
        return
    draft = builder.build()
    conversion.report["notes"] += builder.notes
    if builder.problem:
        entry["problems"] = [builder.problem]
        return
    bearing = getattr(builder, "bearing", None) or next(iter(getattr(builder, "bearings", [])), None)
    result = checked(draft, ledger, filler(builder.source, bearing))
    entry["model"] = draft.model
    entry["figures"] = builder.figures()
    if result.core is None:
        entry["problems"] = [shortened(message) for message in result.messages]
        entry["incomplete"] = f"incomplete/{draft.name}.yaml"
        conversion.incomplete[draft.name] = result.text
        return
    builder.take()
    entry["warnings"] = warnings_of(result.core)
    entry["case"] = f"cases/{draft.name}/case.yaml"
    conversion.cases[draft.name] = result.text
    if any(path.startswith("bearing.") for path in draft.values):
        conversion.bearings[draft.name] = builder.bearing_sets()


def _units(report: dict) -> dict[str, str]:
    """Units of the figures, by their names."""
    units = {}
    for entry in (*report["stages"], *report["pairs"]):
        for name in entry.get("figures", {}):
            ending = next((one for one in FIGURES if name.endswith(f"_{one}")), None)
            units[name] = FIGURES[ending] if ending else "1"
    return units


def write(conversion: Conversion, folder: Path) -> None:
    """The cases and the report."""
    for block, texts in (("cases/{}/case.yaml", conversion.cases), ("incomplete/{}.yaml", conversion.incomplete)):
        for name, text in texts.items():
            file = folder / block.format(name)
            file.parent.mkdir(parents=True, exist_ok=True)
            write_whole(file, text)
    folder.mkdir(parents=True, exist_ok=True)
    write_whole(folder / REPORT, json_of(conversion) + "\n")


def require_empty(folder: Path) -> None:
    """Raises CaseError for a folder that holds other results, or a file of its name."""
    if folder.is_dir() and any(folder.iterdir()):
        raise CaseError(f"--output: {folder} holds files; an empty folder, or a new one, is required")
    if folder.exists() and not folder.is_dir():
        raise CaseError(f"--output: {folder} is a file; a folder is required")


def json_of(conversion: Conversion) -> str:
    """The report as JSON."""
    return json.dumps(conversion.report, ensure_ascii=False, indent=1, allow_nan=False)
