"""The page of a duplex pair under its preload."""

from __future__ import annotations

from typing import Sequence

from orbearing import run_page
from orbearing.blocks import FigureBlock, Table, format_quantity, is_number
from orbearing.result_folder import Report


def page(report: Report, blocks: Sequence[FigureBlock]) -> str:
    """The whole document."""
    study = report.of("pair")
    return run_page.page(study, "duplex pair under its preload", headline(study), _summary(study), blocks)


def life_key(content: dict) -> str:
    """The life of both rows: in hours where the shaft turns."""
    return "system_L10rh" if is_number(content.get("system_L10rh")) else "system_L10r_Mrev"


def headline(study: Report) -> str:
    """The life of both rows, in one sentence."""
    key = life_key(study.content)
    unit = "h" if key.endswith("h") else "million revolutions"
    return f"Life of the pair under its preload: {key.removeprefix('system_').removesuffix('_Mrev')} {format_quantity(study.content.get(key), unit, 4)}."


def _summary(study: Report) -> Table:
    get = study.content.get
    rows = [("Approach of each row under preload", format_quantity(get("approach_um"), "µm", 4)),
            ("Contact angle under preload", format_quantity(get("contact_angle_deg"), "deg", 4)),
            ("Largest load of a ball, inner race", format_quantity(get("inner_load_max_N"), "N", 4)),
            ("Largest load of a ball, outer race", format_quantity(get("outer_load_max_N"), "N", 4)),
            ("Largest contact pressure", format_quantity(get("pressure_max_MPa"), "MPa", 4))]
    return Table(("Quantity", "Value"), rows)
