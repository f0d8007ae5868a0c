"""The page of a crowning study."""

from __future__ import annotations

from html import escape
from typing import Sequence

from orbearing import page as pages
from orbearing.blocks import FigureBlock, Table, format_change, format_number, format_quantity
from orbearing.result_folder import Report, record, records


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
    """The best crown in one sentence."""
    best, straight = study.record("optimum"), study.record("straight")
    worst = max((point["tilt_mrad"] for point in study.records("points")), default=0.0)
    return (f"A drop of {format_number(best.get('drop_um'), 3)} µm ({best.get('profile')}) gives {format_quantity(best.get('life_h'), 'h', 3)} "
            f"at tilts up to {format_number(worst)} mrad, {format_change(best.get('life_h'), straight.get('life_h'))} against straight rollers.")


def _summary(study: Report) -> Table:
    spectrum, best, straight = study.records("spectrum"), study.record("optimum"), study.record("straight")
    speeds = [format_number(point.get("input_speed_rpm")) for point in spectrum]
    where = f"{speeds[0]} rpm" if len(speeds) == 1 else f"{len(speeds)} points, {speeds[0]} to {speeds[-1]} rpm, by Miner's sum"
    advice = study.record("recommended")
    band = f"{format_number(advice.get('least_drop_um'), 3)} to {format_quantity(advice.get('most_drop_um'), 'µm', 3)}"
    kept = format_number(100 * advice.get("life_kept_in_band", 0), 3)
    tilts = sorted({point["tilt_mrad"] for point in study.records("points")})
    rows = [("Operating points", where),
            ("Life", f"by {study.content.get('laminae')} laminae after {study.content.get('life_measure')}; the shortest over the tilts"),
            ("Tilts of the bore on its pin", ", ".join(format_number(tilt) for tilt in tilts) + " mrad"),
            ("Best crown", f"{best.get('profile')}, drop {format_quantity(best.get('drop_um'), 'µm', 4)}"),
            ("Recommended drop", f"{format_quantity(advice.get('drop_um'), 'µm', 3)}; {band} leaves at least {kept} % of the life"
                                 + ("; no crown is needed" if advice.get("no_crown_needed") else "")),
            ("Without tilt", f"{format_quantity(best.get('untilted_life_h'), 'h')}, "
                             f"{format_change(best.get('untilted_life_h'), straight.get('untilted_life_h'))} against straight rollers"),
            ("Greatest peak pressure", f"{format_quantity(best.get('peak_pressure_MPa'), 'MPa', 4)}, straight rollers "
                                       f"{format_quantity(straight.get('peak_pressure_MPa'), 'MPa', 4)}")]
    return Table(("Study", "Value"), rows)


def _points(study: Report) -> str:
    """What the recommended crown meets at each operating point."""
    names = {"input_speed_rpm": "input speed (rpm)", "power_kW": "power (kW)", "share": "share of time", "tilt_mrad": "tilt (mrad)",
             "life_h": "life at this point alone (h)", "damage_share": "share of damage", "peak_pressure_MPa": "peak pressure (MPa)",
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
            rows.append((best.get("profile"), end.get("start_um"), end.get("drop_um"), end.get("crowned_share"), end.get("life_h"), end.get("evaluations")))
    note = "<p>Random starts of the search and where each ended.</p>"
    head = ("profile", "started at drop (µm)", "ended at drop (µm)", "crowned share", "shortest life (h)", "evaluations")
    return pages._section("The search for the best", note + pages.table(Table(head, rows)))


def _reproduce(study: Report) -> str:
    words = " ".join(f'--{key.replace("_", "-")} "{value}"' if value is not True else f"--{key}" for key, value in study.record("options").items()
                     if value not in ("", False, None))
    text = f"orbearing crown case.resolved.yaml -o again {words}\norbearing report again"
    return pages._section("How to reproduce", f"<p>In the folder of this page:</p>\n<pre>{escape(text)}</pre>")
