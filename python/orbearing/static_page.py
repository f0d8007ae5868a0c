"""The page of a single bearing under a static load."""

from __future__ import annotations

from typing import Sequence

from orbearing import run_page
from orbearing.blocks import FigureBlock, Table, format_quantity
from orbearing.lives import governing_number
from orbearing.result_folder import Report


def page(report: Report, blocks: Sequence[FigureBlock]) -> str:
    """The whole document."""
    study = report.of("static")
    return run_page.page(study, "bearing under a static load", headline(study), _summary(study), blocks)


def headline(study: Report) -> str:
    """The governing life, in one sentence."""
    name, number, unit = governing_number(study.content) or ("L10r", None, "million revolutions")
    return f"Life of the bearing: {name} {format_quantity(number, unit, 4)}."


def _summary(study: Report) -> Table:
    get, moved = study.content.get, study.record("displacement")
    rows = [("Largest load of a rolling element", format_quantity(get("contact_load_max_N"), "N", 4)),
            ("Largest contact pressure", format_quantity(get("contact_pressure_max_MPa"), "MPa", 4)),
            ("Displacement of the inner ring, radial", format_quantity(moved.get("radial_um"), "µm", 4)),
            ("Displacement of the inner ring, axial", format_quantity(moved.get("axial_um"), "µm", 4)),
            ("Tilt of the inner ring", format_quantity(get("tilt_mrad"), "mrad", 4)), *_friction(study)]
    return Table(("Quantity", "Value"), rows)


def _friction(study: Report) -> list[tuple[str, str]]:
    """Ours beside that of others; none without speed and oil."""
    if not study.content.get("friction"):
        return []
    rows = [("Friction torque at pure rolling", format_quantity(study.record("friction").get("torque_N_mm"), "N mm", 4))]
    others = study.content.get("friction_by_standards") or {}
    names = (("by SKF, without an oil bath", "skf"), ("by Palmgren", "palmgren"), ("by ISO/TR 14179-2", "iso_tr_14179_2"))
    return rows + [(f"The same {name}", format_quantity(others[key].get("torque_N_mm"), "N mm", 4)) for name, key in names if key in others]
