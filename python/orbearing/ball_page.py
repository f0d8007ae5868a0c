"""The page of a ball bearing in time."""

from __future__ import annotations

from typing import Sequence

from orbearing import run_page
from orbearing.blocks import FigureBlock, Table, format_quantity
from orbearing.lives import governing_number
from orbearing.result_folder import Report


def page(report: Report, blocks: Sequence[FigureBlock]) -> str:
    """The whole document."""
    study = report.of("balls")
    return run_page.page(study, "ball bearing in time", headline(study), _summary(study), blocks)


def headline(study: Report) -> str:
    """Life, heat and slip in one sentence."""
    get = study.content.get
    heat, slip = study.record("heat_W").get("total"), get("cage_slip")
    percent = 100 * slip if isinstance(slip, (int, float)) else None
    return (f"The bearing lives {_life(study)} and gives off {format_quantity(heat, 'W', 3)}; its cage slips "
            f"{format_quantity(percent, '%', 2)}.")


def _life(study: Report) -> str:
    """The governing life; that of Lundberg and Palmgren where the run names none."""
    name, number, unit = (study.record("life_table") and governing_number(study.content)) or ("life", study.content.get("life_h"), "h")
    return format_quantity(number, unit, 4) + ("" if name == "life" else f" ({name})")


def _summary(study: Report) -> Table:
    get, inner, outer = study.content.get, study.record("inner"), study.record("outer")

    def race(values: dict) -> str:
        return (f"{format_quantity(values.get('load_rms_N'), 'N', 4)} rms, at most {format_quantity(values.get('load_max_N'), 'N', 4)}; "
                f"contact angle {format_quantity(values.get('contact_angle_deg'), '°', 3)}; film {format_quantity(values.get('central_film_um'), 'µm', 3)}; "
                f"life {format_quantity(values.get('life_Mrev'), 'Mrev', 4)}")

    settled = get("slip_settling_s")
    rows = [("Life", _life(study)), ("Inner race", race(inner)), ("Outer race", race(outer)),
            ("Cage", f"{format_quantity(get('cage_speed_rpm'), 'rpm', 4)}; slip settled after "
                     f"{format_quantity(settled, 's', 3) if settled is not None else 'no time of this run'}"),
            ("Largest load of a ball on the cage", format_quantity(get("cage_impact_max_N"), "N", 3)),
            ("Friction torque", format_quantity(get("friction_torque_N_mm"), "N mm", 4))]
    return Table(("Quantity", "Value"), rows)
