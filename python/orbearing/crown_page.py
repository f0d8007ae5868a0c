"""The page of a crowning study."""

from __future__ import annotations

from html import escape
from typing import Sequence

from orbearing import page as pages
from orbearing.blocks import FigureBlock, Table, format_change, format_number, format_quantity
from orbearing.figures.crown import half_space_life_key, life_key_of
from orbearing.result_folder import Report, record, records
from orbearing.style import life_name


def page(report: Report, blocks: Sequence[FigureBlock]) -> str:
    """The whole document."""
    study = Report(report.record("crown"), report.folder)
    name = escape(str(study.content.get("case") or "unnamed case"))
    answer = f'<header><p class="case">{name}</p>\n<h1>{escape(headline(study))}</h1></header>\n{pages.table(_summary(study))}'
    sections = [answer, *(pages._figure(index, block) for index, block in enumerate(blocks, start=1)), _points(study), _starts(study),
                pages._assumptions(study), pages._warnings(study), pages._versions(study), _reproduce(study)]
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">', f"<title>{name}: crowning</title>",
        f"<style>\n{pages.STYLE_SHEET.read_text(encoding='utf-8')}</style>", "</head>", "<body>", "<main>", *sections, "</main>", "</body>",
        "</html>", "",
    ])


def headline(study: Report) -> str:
    """The advice in one sentence, behind the governing life that it shortens."""
    advice = study.record("recommended")
    shortened = f"The recommended drop of {format_number(advice.get('drop_um'), 3)} µm {advice.get('status')}. " if advice.get("shortens_governing_life") else ""
    left = f"{format_number(100 * (advice.get('straight_life_share') or 0.0), 3)} %"
    within = record(advice.get("within_tolerances"))
    life = format_quantity((within or advice).get("half_space_life_h"), "h", 3) + (" within the tolerances" if within else "")
    if advice.get("no_crown_needed"):
        ends = " with relieved ends" if advice.get("rollers") == "straight with relieved ends" else ""
        return f"{shortened}No crown is needed: straight rollers{ends} keep {left} of the {life} that the best drop gives."
    return (f"{shortened}A drop of {format_number(advice.get('drop_um'), 3)} µm ({advice.get('profile')}) gives {life}, "
            f"of which straight rollers leave {left}.")


def _summary(study: Report) -> Table:
    spectrum, best, straight = study.records("spectrum"), study.record("optimum"), study.record("straight")
    speeds = [format_number(point.get("input_speed_rpm")) for point in spectrum]
    where = f"{speeds[0]} rpm" if len(speeds) == 1 else f"{len(speeds)} points, {speeds[0]} to {speeds[-1]} rpm, by Miner's sum"
    advice = study.record("recommended")
    beyond = "beyond " if advice.get("most_is_greatest_studied") else ""
    band = f"{format_number(advice.get('least_drop_um'), 3)} to {beyond}{format_quantity(advice.get('most_drop_um'), 'µm', 3)}"
    kept = format_number(100 * advice.get("life_kept_in_band", 0), 3)
    computed, life = study.content.get("tilt") == "computed", life_name(life_key_of(study.content))
    tilts = sorted({point["tilt_mrad"] for point in (records(advice.get("points")) if computed else study.records("points"))})
    shown = [format_number(tilt) for tilt in dict.fromkeys((tilts[0], tilts[-1]) if computed else tilts)]
    rows = [("Operating points", where),
            ("Recommended by", f"{half_space_life_key(study.content)} from half-space pressures of both races" + (" of all bearings of a planet" if computed else ", the shortest over the tilts")),
            ("Optimum by", f"{study.content.get('life_key')} on {study.content.get('laminae')} laminae"),
            ("Tilts of the bore on its pin", (" to ".join(shown) + " mrad, computed from planet, pin and bearings") if computed else ", ".join(shown) + " mrad"),
            *_tolerances(record(advice.get("within_tolerances"))),
            ("Optimum by laminae", f"{best.get('profile')}, drop {format_quantity(best.get('drop_um'), 'µm', 4)}"),
            ("Recommended drop", f"{format_quantity(advice.get('drop_um'), 'µm', 3)}; {band} leaves at least {kept} % of the life"
                                 + (f"; no crown is needed: {advice.get('rollers')}" if advice.get("no_crown_needed") else "")),
            *([] if computed else [("Without tilt", f"{life} {format_quantity(best.get('untilted_governing_life_h'), 'h')}, "
                                    f"{format_change(best.get('untilted_governing_life_h'), straight.get('untilted_governing_life_h'))} against straight rollers")]),
            ("Greatest peak pressure", f"{format_quantity(best.get('peak_pressure_MPa'), 'MPa', 4)}, straight rollers "
                                       f"{format_quantity(straight.get('peak_pressure_MPa'), 'MPa', 4)}")]
    return Table(("Study", "Value"), rows)


def _tolerances(asked: dict) -> list[tuple[str, str]]:
    if not asked:
        return []
    lean = f"pins inclined by {format_number(asked['pin_inclination_mrad'])}" if "pin_inclination_mrad" in asked else f"tilts by {format_number(asked.get('tilt_mrad'))}"
    kind = asked.get("distribution")
    what = "the shortest life within them" if kind == "worst" else f"{kind} distribution; nine tenths of all bearings live"
    return [("Tolerances", f"drop by {format_quantity(asked.get('drop_um'), 'µm', 3)}, {lean} mrad"),
            ("Within the tolerances", f"{what} {format_quantity(asked.get('half_space_life_h'), 'h')}")]


def _points(study: Report) -> str:
    """What the recommended crown meets at each operating point."""
    names = {"input_speed_rpm": "input speed (rpm)", "power_kW": "power (kW)", "share": "share of time", "tilt_mrad": "tilt (mrad)",
             "load_share": "largest share of the load", "half_space_life_h": "life from half-space pressures (h)", "governing_life_h": f"{life_name(life_key_of(study.content))} by laminae (h)", "damage_share": "share of damage", "peak_pressure_MPa": "peak pressure (MPa)",
             "edge_ratio": "edge ratio"}
    rows = [tuple(point.get(name) for name in names) for point in records(study.record("recommended").get("points"))]
    if not rows:
        return ""
    note = "<p>The recommended crown at each operating point, at the tilt under which all of them together leave the shortest life.</p>"
    return pages._section("Operating points", note + pages.table(Table(tuple(names.values()), rows)))


def _starts(study: Report) -> str:
    rows = []
    for best in study.records("optima"):
        for end in records(record(best.get("starts")).get("ends")):
            rows.append((best.get("profile"), end.get("start_um"), end.get("drop_um"), end.get("crowned_share"), end.get("governing_life_h"), end.get("evaluations")))
    note = "<p>Random starts of the search and where each ended.</p>"
    head = ("profile", "started at drop (µm)", "ended at drop (µm)", "crowned share", f"shortest {life_name(life_key_of(study.content))} (h)", "evaluations")
    return pages._section("The search for the best", note + pages.table(Table(head, rows)))


def _reproduce(study: Report) -> str:
    words = " ".join(f'--{key.replace("_", "-")} "{value}"' if value is not True else f"--{key}" for key, value in study.record("options").items()
                     if value not in ("", False, None))
    text = f"orbearing crown case.resolved.yaml -o again {words}\norbearing report again"
    return pages._section("How to reproduce", f"<p>In the folder of this page:</p>\n<pre>{escape(text)}</pre>")
