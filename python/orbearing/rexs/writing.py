"""The text of a case, and its way through the check: what is refused is taken out, told, and tried again."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Callable, Optional

from orbearing.errors import CaseError
from orbearing.rexs.ledger import Draft, Ledger
from orbearing.rexs.names import OURS, in_unit

# Optional inputs of a case: taken out, first match first, where the check refuses it.
OPTIONAL = ("gearset.profile_shift.planet", "gearset.centre_distance", "gearset.planet_angles", "gearset.addendum_of", "gearset.clearance_of",
            "gearset.addendum", "gearset.clearance", "gearset.root_fillet_radius", "gearset.sun_bore_ratio", "gearset.ring_outside_ratio",
            "gearset.planet_bore_ratio", "gearset.dynamics", "material", "spectrum", "life", "support", "bearing.tilt_state", "bearing.profile",
            "bearing.laminae", "bearing.axial_places", "bearing.dynamic_capacity", "bearing.static_capacity", "bearing.fatigue_load_limit",
            "bearing.clearance_class", "bearing.cage", "bearing.outer_osculation", "bearing.inner_osculation", "lubricant", "pair.addendum",
            "pair.clearance", "pair.root_fillet_radius")
BLOCKS = ("bearing", "support", "lubricant", "life")  # of a planetary set without a complete bearing
ORDER = ("input", "spectrum", "load", "operation", "gearset", "pair", "bearing", "support", "lubricant", "life", "material")
MOST_LETTERS = 240  # of a message in the report
MOST_TRIALS = 40


def shortened(message: str) -> str:
    """A message without a long list of choices at its end."""
    return message if len(message) <= MOST_LETTERS else message[:MOST_LETTERS - 3].rstrip() + "..."


def number_text(value: float) -> str:
    """A number without noise of its last digits."""
    text = f"{value:.12g}"
    return "0" if text == "-0" else text


def quantity(value: float, unit: str) -> str:
    """A number in SI as text in a unit of a case."""
    return f"{number_text(in_unit(value, unit))} {unit}".strip()


def number_in(text: Any) -> float:
    """A text with a unit of a case as a number in SI."""
    number, _, unit = str(text).partition(" ")
    return float(number) * OURS[unit]


def scalar_text(value: Any) -> str:
    """A value in flow style."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return number_text(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, list):
        return "[" + ", ".join(scalar_text(one) for one in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {scalar_text(one)}" for key, one in value.items()) + "}"
    text = str(value)
    plain = all(letter.isalnum() and letter.isascii() or letter in " ._/-" for letter in text) and text[:1].isalnum()
    return text if plain else json.dumps(text, ensure_ascii=False)


def _lines(block: dict, indent: str) -> list[str]:
    lines = []
    for key, value in block.items():
        if isinstance(value, dict):
            lines += [f"{indent}{key}:", *_lines(value, indent + "  ")]
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            lines += [f"{indent}{key}:", *(f"{indent}  - {scalar_text(row)}" for row in value)]
        else:
            lines.append(f"{indent}{key}: {scalar_text(value)}")
    return lines


def _place(path: str) -> int:
    """Where a block stands in a case."""
    block = path.split(".")[0]
    return ORDER.index(block) if block in ORDER else len(ORDER)


def case_text(draft: Draft) -> str:
    """The case as YAML."""
    root: dict[str, Any] = {"name": draft.name, "source": draft.source, "model": draft.model}
    for path, value in sorted(draft.values.items(), key=lambda one: _place(one[0])):
        *blocks, last = path.split(".")
        block = root
        for name in blocks:
            block = block.setdefault(name, {})
        block[last] = value
    if draft.assumed:
        root["assumed"] = dict(draft.assumed)
    return "\n".join(_lines(root, "")) + "\n"


@dataclass
class Checked:
    """A case that passed the check, or the messages that it did not."""

    text: str
    core: Optional[object] = None
    messages: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)


def warnings_of(core: object) -> list[str]:
    """What the check says of a case that it lets pass."""
    from orbearing import _core

    try:
        return json.loads(_core.compute(core, "check", {})[0]).get("warnings", [])
    except RuntimeError as error:  # a derived value that cannot be computed
        return [f"check: {error}"]


def _refused(text: str, name: str) -> tuple[Optional[object], list]:
    from orbearing import _core

    try:
        return _core.parse(text, name), []
    except CaseError as error:
        return None, error.mistakes


def _to_remove(draft: Draft, keys: list[str]) -> Optional[str]:
    """The path to take out: of the values that the check names, the least needed."""
    for optional in (*OPTIONAL, *(("bearing.designation",) if draft.model == "planetary-drivetrain" else ())):
        for key in keys:
            inside = key == optional or key.startswith(optional + ".")
            if inside and any(path == optional or path.startswith(optional + ".") for path in draft.values):
                own = key if key in draft.values else optional
                return own
    return None


def _drop(draft: Draft, ledger: Ledger, path: str, reason: str) -> None:
    for gone in draft.remove(path):
        if any(attribute.value is not None for _, attribute in draft.origins.get(gone, [])):
            ledger.refused.setdefault(f"{gone}: {shortened(reason)}", []).append(draft.name)
        for component, attribute in draft.origins.get(gone, []):
            ledger.leave(component, attribute, f"{gone}: {shortened(reason)}")


def _drop_bearing(draft: Draft, ledger: Ledger, lacking: list[str]) -> None:
    """Takes out an incomplete bearing with all that stands for it alone."""
    ledger.forget(draft.name, BLOCKS)
    for key in lacking:
        ledger.miss(draft.name, key, "", None, "required by a bearing; the case is written without one")
    for block in BLOCKS:
        _drop(draft, ledger, block, f"the bearing of the planets is incomplete: {', '.join(lacking)} missing")


def checked(draft: Draft, ledger: Ledger, fill: Callable[[Draft, list[str], set[str]], bool]) -> Checked:
    """The draft as a case that passes the check. `fill` may put what is missing, but for what was refused, and says whether it did."""
    dropped: set[str] = set()
    for _ in range(MOST_TRIALS):
        text = case_text(draft)
        core, mistakes = _refused(text, draft.name)
        if core is not None:
            return Checked(text, core)
        missing = [mistake.key for mistake in mistakes if mistake.key and mistake.text.startswith("missing")]
        if missing and fill(draft, missing, dropped):
            continue
        lacking = [key for key in missing if key.startswith("bearing.")]
        if lacking and draft.model == "planetary-drivetrain":
            _drop_bearing(draft, ledger, list(dict.fromkeys(lacking)))
            continue
        refused = [(mistake.key, mistake.text) for mistake in mistakes if mistake.key and mistake.key not in missing]
        path = _to_remove(draft, [key for key, _ in refused])
        if path is None:
            for key in missing:
                ledger.miss(draft.name, key, "", None, "required by the case")
            return Checked(text, None, [_message(mistake) for mistake in mistakes])
        dropped.add(path)
        reason = next((text for key, text in refused if key == path or key.startswith(path + ".") or path.startswith(key)), "refused by the check")
        _drop(draft, ledger, path, reason)
    return Checked(case_text(draft), None, ["no version of the case passes the check"])


def _message(mistake: Any) -> str:
    return f"{mistake.key}: {mistake.text}" if mistake.key else mistake.text
