"""What single effects do to the dynamic run as a Markdown table: python3 -m orbearing.effects_table DIR."""

from __future__ import annotations

import sys
from pathlib import Path

from orbearing.blocks import is_number
from orbearing.errors import CaseError
from orbearing.figures.ablation import REFERENCE, life_key_of
from orbearing.lives import LUNDBERG_PALMGREN
from orbearing.result_folder import read_report, record, records, slip_of_set
from orbearing.style import life_name

HEAD = ("rpm", "effect", "life [h]", "change", "rms load, pin [N]", "rms load, bore [N]", "cage slip", "roller slip", "power loss [W]")


def life_key_in(effects: list[dict]) -> str:
    """The life that they are compared by."""
    return next(map(life_key_of, effects), LUNDBERG_PALMGREN)


def rows(effects: list[dict]) -> list[tuple[str, ...]]:
    """One row for each speed and effect, speed by speed."""
    found, life_key = [], life_key_in(effects)
    for effect in effects:
        for point in records(effect.get("points")):
            if is_number(point.get("speed_rpm")):
                found.append((round(point["speed_rpm"], 3), str(effect.get("name")), point))
    base = {speed: point.get(life_key) for speed, name, point in found if name == REFERENCE}
    return [_row(speed, name, point, life_key, base.get(speed)) for speed, name, point in sorted(found, key=lambda one: one[0])]


def _row(speed: float, name: str, point: dict, life_key: str, base) -> tuple[str, ...]:
    def number(key: str, form: str, factor: float = 1.0) -> str:
        return form.format(factor * point[key]) if is_number(point.get(key)) else str(point.get("status", "missing"))

    life = point.get(life_key)
    change = f"{100 * (life / base - 1):+.1f} %" if is_number(life) and is_number(base) and name != REFERENCE else ""
    drifts = "" if point.get("steady", True) else " (drifts)"
    return (f"{speed:g}", name + drifts, number(life_key, "{:.0f}"), change, number("inner_load_rms_N", "{:.1f}"),
            number("outer_load_rms_N", "{:.1f}"), number("orbit_slip" if is_number(point.get("orbit_slip")) else "cage_slip", "{:.2f} %", 100), number("roller_slip", "{:.2f} %", 100),
            number("power_loss_W", "{:.1f}"))


def main(folder: str) -> int:
    try:
        report = read_report(Path(folder))
    except CaseError as error:
        print(error, file=sys.stderr)
        return 2
    effects = records(record(report.record("dynamic")).get("ablation"))
    lines = rows(effects)
    points = [point for effect in effects for point in records(effect.get("points"))]
    own = {"cage slip": f"{slip_of_set(points)[1]} slip", "life [h]": f"{life_name(life_key_in(effects))} [h]"}
    head = [own.get(name, name) for name in HEAD]
    print("| " + " | ".join(head) + " |")
    print("|---:|---|" + "---:|" * (len(head) - 2))
    for line in lines:
        print("| " + " | ".join(line) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else "usage: python3 -m orbearing.effects_table DIR")
