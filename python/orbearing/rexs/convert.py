"""A REXS file into cases and a report of what was taken, what is missing and what was left out."""

from __future__ import annotations

import json
import math
import re
import unicodedata
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Optional

from orbearing.errors import CaseError, ComputationError
from orbearing.rexs.drive import Drive, planetary
from orbearing.rexs.ledger import Ledger
from orbearing.rexs.model import Component, Model
from orbearing.rexs.names import BEARINGS, attribute_of, in_unit, number_of
from orbearing.rexs.pairs import BearingCase, LoadPoint, PairCase
from orbearing.rexs.parts import Source, filler, is_bearing
from orbearing.rexs.reactions import bearing_forces
from orbearing.rexs.stages import SAME_SHARE, StageCase, rounded
from orbearing.rexs.writing import checked, shortened, warnings_of
from orbearing.terminal import CONTROL, printable
from orbearing.whole_files import write_whole

FIGURES = {"rpm": "rpm", "N_m": "N.m", "N": "N", "kN": "kN", "Hz": "Hz", "mm": "mm", "deg": "deg", "h": "h"}
REPORT = "conversion.json"
MOST_CASES = 20  # of one bearing; of more load cases that with most damage is written alone
LIVES = ("L10h", "L10mh", "L10rh", "L10mrh")


@dataclass
class Conversion:
    """The report and the texts of the cases by name; those that the check refuses stand apart."""

    report: dict[str, Any]
    cases: dict[str, str] = field(default_factory=dict)
    incomplete: dict[str, str] = field(default_factory=dict)
    bearings: dict[str, list[list[Component]]] = field(default_factory=dict)  # by case: those of each planet
    load_cases: dict[str, str] = field(default_factory=dict)  # by case of one of several loads: which

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
        """The name of a part's case."""
        name = _plain(component.name.split("@")[0])
        name = name if re.search("[a-z]", name) else f"{kind}_{component.id}"
        if name in self._used:
            name = f"{name}_{component.id}"
        self._used.add(name)
        return name


def _plain(text: str) -> str:
    """Letters and digits of a text, fit for a name."""
    text = text.replace("\u00df", "ss")
    for umlaut, letters in (("\u00e4", "ae"), ("\u00f6", "oe"), ("\u00fc", "ue")):
        text = text.replace(umlaut, letters).replace(umlaut.upper(), letters.capitalize())
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_")


def convert(model: Model, source: str, form: str) -> Conversion:
    """Cases of the planetary stages; without any, of the gear pairs and bearings."""
    ledger = Ledger(model)
    text = printable(f"REXS {model.version} file {source}" + (f" of {model.application}" if model.application else ""))
    parts = Source(model, ledger, text)
    conversion = Conversion({"source": source, "form": form, "version": model.version, "application": model.application,
                             "stages": [], "pairs": [], "bearings": [], "shafts": [], "notes": list(model.notes)})
    found = [(stage, planetary(model, stage)) for stage in model.of_type("planetary_stage")]
    drive = Drive(model, [one for _, one in found if not isinstance(one, str)])
    names = Names()
    for stage, one in found:
        builder = None if isinstance(one, str) else StageCase(parts, drive, one, names.of(stage, "stage"))
        _add(conversion, ledger, "stages", stage, builder, "" if builder else one)
    if not found:
        points, notes = _load_points(parts, drive)
        conversion.report["notes"] += notes
        _add_pairs(conversion, ledger, parts, drive, names, points)
        _add_bearings(conversion, ledger, parts, drive, names, points)
        _add_shafts(conversion, drive, points)
    ledger.close()
    conversion.report["notes"] = list(dict.fromkeys([*conversion.report["notes"], *ledger.notes, *parts.places.notes]))
    conversion.report |= {"taken": ledger.taken, "missing": ledger.missing, "left_out": ledger.left_out, "units": _units(conversion.report)}
    return conversion


def _load_points(parts: Source, drive: Drive) -> tuple[list[LoadPoint], list[str]]:
    """The loads of the file and their contradictions: its load cases, else its own."""
    model, notes = parts.model, []
    shares = _shares(parts, notes)
    own = any(attribute_of(load, name) for load in model.of_type("external_load") for name in ("torque", "load_power"))
    at = [(one.id, loaded, share) for (one, loaded), share in zip(parts.load_cases, shares or [None] * len(parts.load_cases))]
    if not at or (own and shares is None):
        at = [("", model, None)]
    points = []
    for load_case, loaded, share in at:
        _, speeds, found = drive.members(loaded)
        notes += [f"{f'load case {load_case}: ' if load_case else ''}{note}" for note in found]
        points.append(LoadPoint(load_case, loaded, share, speeds, bearing_forces(drive, parts.places, loaded)))
    return points, notes


def _longest(points: list[LoadPoint]) -> LoadPoint:
    return max(points, key=lambda point: point.share or 0.0)


def _shares(parts: Source, notes: list[str]) -> Optional[list[float]]:
    """Share of time of each load case, 0 for one that never acts; None where one states none."""
    for name in ("share", "duration"):
        found = [[number_of(unit, name).number for unit in model.of_type("gear_unit")] for _, model in parts.load_cases]
        stated = [max((one for one in numbers if one is not None), default=None) for numbers in found]
        missing = [str(one.id) for (one, _), number in zip(parts.load_cases, stated) if number is None]
        if 0 < len(missing) < len(stated):
            notes.append(f"no {'share of time' if name == 'share' else 'duration'} is stated of load case {', '.join(missing)}: lives under all load cases together are left out")
        if stated and not missing and min(stated) >= 0.0 and sum(stated) > 0.0:
            total = sum(stated)
            if name == "share" and abs(total - 1.0) > SAME_SHARE:
                notes.append(f"the shares of the load cases add up to {total:.6g}; scaled to 1")
            return [one / total for one in stated]
    return None


def _add_pairs(conversion: Conversion, ledger: Ledger, parts: Source, drive: Drive, names: Names, points: list[LoadPoint]) -> None:
    longest = _longest(points)
    drive.members(longest.model)
    for mesh in parts.model.of_type("cylindrical_stage"):
        _add(conversion, ledger, "pairs", mesh, PairCase(parts, drive, mesh, names.of(mesh, "pair"), longest.speeds))
    for mesh in parts.model.components.values():
        if mesh.type.endswith("_stage") and mesh.type != "cylindrical_stage":
            _add(conversion, ledger, "pairs", mesh, None, f"a {mesh.type.replace('_', ' ')}: cylindrical gears are known")


def _add_bearings(conversion: Conversion, ledger: Ledger, parts: Source, drive: Drive, names: Names, points: list[LoadPoint]) -> None:
    """Bearings between two parts, then those of which the file does not say where they are."""
    model, placed = parts.model, set()
    for relation in model.related("side"):
        bearing, inner, outer = (model.components.get(relation.part(role) or -1) for role in ("assembly", "inner_part", "outer_part"))
        if is_bearing(bearing) and bearing.id not in placed and inner is not None and outer is not None:
            placed.add(bearing.id)
            _add_bearing(conversion, ledger, [BearingCase(parts, drive, bearing, inner, outer, "", point) for point in points], names)
    for bearing in model.of_type(*BEARINGS):
        if bearing.id not in placed:
            _add_bearing(conversion, ledger, [BearingCase(parts, drive, bearing, None, None, "", point) for point in points], names)
            conversion.report["bearings"][-1].setdefault("problems", []).append("no relation side states between which parts it is: load and speeds do not "
                                                                                "follow from the file")


def _add_bearing(conversion: Conversion, ledger: Ledger, builders: list[BearingCase], names: Names) -> None:
    """A case for each load of the file; with several, their lives together by the rule of Palmgren and Miner."""
    bearing, name = builders[0].bearing, names.of(builders[0].bearing, "bearing")
    rows = []
    for number, builder in enumerate(builders):
        builder.draft.name = name if len(builders) == 1 else f"{name}_load_case_{_plain(builder.at.load_case) or number + 1}"
        _add(conversion, ledger, "bearings", bearing, builder)
        if len(builders) > 1:
            conversion.load_cases[builder.draft.name] = builder.at.load_case
        entry = conversion.report["bearings"].pop()
        entry["figures"] = builder.figures()
        rows.append((builder, entry, _lives(conversion.cases.get(builder.draft.name), builder.draft.name) if len(builders) > 1 else {}))
    if len(rows) == 1:
        conversion.report["bearings"].append(rows[0][1])
        return
    lives = _lives_together([(builder.at.share, lives) for builder, _, lives in rows if not builder.stands])
    worst = max(rows, key=lambda row: (row[0].at.share or 0.0) / row[2].get("L10h", math.inf)) if lives else max(rows, key=lambda row: row[0].at.share or 0.0)
    entry = worst[1]
    if len(rows) > MOST_CASES:
        for builder, one, _ in rows:
            if one is not entry:
                one["case"] = None
                for held in (conversion.cases, conversion.incomplete, conversion.bearings, conversion.load_cases):
                    held.pop(builder.draft.name, None)
    entry["load_cases"] = [{"load_case": builder.at.load_case, "share": builder.at.share, "case": one["case"], "figures": builder.load_figures() | lives_of_one}
                           for builder, one, lives_of_one in rows]
    entry["lives"] = lives
    if lives:
        ledger.miss(name, "spectrum", "share", bearing, "a case of one bearing has one load: a case for each load case, and their lives together in the report",
                    f"L10h {lives['L10h']:.6g} h")
    conversion.report["bearings"].append(entry)


def _lives(text: Optional[str], name: str) -> dict[str, float]:
    """Lives [h] of a case of one bearing; none where there is no case, or no life."""
    from orbearing import _core

    if text is None:
        return {}
    try:
        result = json.loads(_core.compute(_core.parse(text, name), "run", {})[0])
    except (CaseError, ComputationError):
        return {}
    return {life: result[life] for life in LIVES if isinstance(result.get(life), (int, float))}


def _lives_together(rows: list[tuple[Optional[float], dict[str, float]]]) -> dict[str, float]:
    """Palmgren and Miner: 1/L is the sum of share/L, of the lives that all loads have; none without shares. A load that never acts does no damage."""
    if any(share is None for share, _ in rows):
        return {}
    rows = [row for row in rows if row[0]]
    if not rows:
        return {}
    common = [life for life in LIVES if all(life in lives for _, lives in rows)]
    return {life: rounded(1.0 / sum(share / lives[life] for share, lives in rows)) for life in common}


def _add_shafts(conversion: Conversion, drive: Drive, points: list[LoadPoint]) -> None:
    """Speed of each shaft at the longest load, and the diameters of its sections."""
    model, speeds = drive.model, _longest(points).speeds
    for shaft in model.of_type("shaft"):
        sections = [one for one in model.parts("assembly", "assembly", shaft.id, "part") if one.type == "shaft_section"]
        diameters = [value for value in (number_of(one, "section_outside").number for one in sections) if value is not None]
        figures: dict[str, Any] = {"outside_diameters_mm": [rounded(in_unit(one, "mm")) for one in diameters]} if diameters else {}
        speed = speeds.get(drive.bodies.of(shaft.id))
        if speed is not None:
            figures["speed_rpm"] = rounded(in_unit(speed, "rpm"))
        conversion.report["shafts"].append({"component": shaft.id, "type": shaft.type, "name": shaft.name, "figures": figures})


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
    for entry in (one for kind in ("stages", "pairs", "bearings", "shafts") for one in report[kind]):
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
    """The report as JSON; what would move the cursor of a terminal is escaped."""
    text = json.dumps(conversion.report, ensure_ascii=False, indent=1, allow_nan=False)
    return "\n".join(CONTROL.sub(lambda found: f"\\u{ord(found[0]):04x}", line) for line in text.split("\n"))
