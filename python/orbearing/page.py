"""The page: headings, tables and figures as one HTML document that needs nothing from outside."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any, Sequence

from orbearing import assessor, lives, style
from orbearing.blocks import MISSING, FigureBlock, Table, format_quantity, is_number
from orbearing.result_folder import Report, records
from orbearing.summary import headline, summary_table
from orbearing.tables import table

STYLE_SHEET = Path(__file__).with_name("page.css")
LEAST_CHANGE = 1e-3  # [h]


def page(report: Report, blocks: Sequence[FigureBlock], animations: Sequence[str] = ()) -> str:
    """The whole document; `animations` are pages beside it, by their name below its folder."""
    name = report.record("case").get("name") or "unnamed case"
    head = assessor.sections(report)
    ends = [] if head else [_warnings(report), _versions(report)]
    sections = [title_of(str(name), headline(report)), *head, appendix(blocks, bool(head)), lives.section(report), table(summary_table(report)),
                *(_figure(index, block) for index, block in enumerate(blocks, start=1))]
    sections += [_animations(animations), _failed(report), _assumptions(report), _validation(report), _sensitivities(report), *ends, _reproduce(report)]
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{escape(str(name))}: planet bearing life</title>",
        f"<style>\n{STYLE_SHEET.read_text(encoding='utf-8')}</style>", "</head>", "<body>", "<main>",
        *(section for section in sections if section), "</main>", "</body>", "</html>", "",
    ])


def title_of(name: str, answer: str) -> str:
    """What a page begins with."""
    return f'<header><p class="case">{escape(name)}</p>\n<h1>{escape(answer)}</h1></header>'


def appendix(blocks: Sequence[FigureBlock], has_head: bool) -> str:
    """The list of figures, behind the heading of the long report where an assessor's part stands before it."""
    items = "\n".join(f'<li><a href="#{escape(block.slug, quote=True)}">{escape(block.title)}</a></li>' for block in blocks)
    title = "<h2>Appendix: full report</h2>\n" if has_head else ""
    return f'<nav id="contents">{title}<p>Figures:</p>\n<ol>{items}</ol></nav>' if items else title


def _figure(index: int, block: FigureBlock) -> str:
    parts = [f'<section id="{block.slug}">', f"<h2>{index}. {escape(block.title)}</h2>"]
    if block.pictures:
        pictures = "\n".join(f'<div class="picture">{picture}</div>' for picture in block.pictures)
        parts += ["<figure>", f'<div class="pictures n{len(block.pictures)}">{pictures}</div>',
                  f"<figcaption>{escape(block.caption)}</figcaption>", "</figure>"]
    else:
        parts.append(f'<p class="missing">{escape(block.missing)}</p>')
    if block.summary:
        parts.append(table(block.summary))
    if block.data:
        parts.append(f"<details><summary>Data of this figure ({len(block.data.rows)} rows)</summary>{table(block.data)}</details>")
    return "\n".join([*parts, "</section>"])


def _section(title: str, body: str) -> str:
    return f"<section>\n<h2>{escape(title)}</h2>\n{body}\n</section>"


def _animations(names: Sequence[str]) -> str:
    if not names:
        return ""
    items = "\n".join(f'<li><a href="{escape(name, quote=True)}">{escape(name)}</a></li>' for name in names)
    note = ("<p>Rollers, cage and rings in motion over one orbit, with the loads as bars: a page for each point, in the folder "
            "of this report.</p>")
    return _section("Animations", f"{note}\n<ul>{items}</ul>")


def _failed(report: Report) -> str:
    rows = [(p.get("input_speed_rpm"), p.get("status") or "no reason given") for p in report.failed_points]
    return _section("Points without a life", table(Table(("input speed (rpm)", "reason"), rows))) if rows else ""


def _assumptions(report: Report) -> str:
    rows = report.records("assumptions")
    if not rows:
        return _section("Assumptions", "<p>The case marks no value as assumed.</p>")
    note = ("<p>Values that the source does not give, with reason. The effect is the change of the quasi-static life at the best grid speed under "
            "another choice. The table of effects below states both choices.</p>")
    cells = [(r.get("key"), r.get("value"), r.get("reason"), _effect(r)) for r in rows]
    return _section("Assumptions", note + table(Table(("assumed", "value", "reason", "effect"), cells)))


def _effect(row: dict) -> str:
    hours = row.get("worth_h")
    parts = [_hours(hours)] if is_number(hours) else []
    parts += [str(row["worth_text"])] if row.get("worth_text") else []
    return ": ".join(parts) or "not computed"


def _hours(change: float) -> str:
    """A change of life with its sign; what is below a thousandth of an hour is round-off."""
    if abs(change) < LEAST_CHANGE:
        return "0 h"
    return ("+" if change > 0 else "") + format_quantity(change, "h")


def _warnings(report: Report) -> str:
    value = report.content.get("warnings")
    texts = value if isinstance(value, list) else []
    if not texts:
        return _section("Warnings", "<p>None.</p>")
    return _section("Warnings", "<ul>" + "\n".join(f"<li>{escape(str(text))}</li>" for text in texts) + "</ul>")


def _validation(report: Report) -> str:
    rows = [row for row in report.records("validation") if not row.get("reading")]
    changed = report.content.get("changed_inputs")
    if changed:
        items = "\n".join(f"<li>{escape(str(text))}</li>" for text in changed)
        return _section("Published numbers beside ours", f"<p>Not compared: the published numbers are of a case with other inputs.</p>\n<ul>{items}</ul>")
    if not rows:
        return _section("Published numbers beside ours", "<p>No published numbers are compared for this case.</p>")
    moving = report.fidelity != "quasi-static"
    names = ("source", "quantity", "published", "quasi-static", "deviation", "tolerance", "verdict", *((report.fidelity,) if moving else ()))
    cells = [(row.get("source"), row.get("quantity"), row.get("published"), row.get("ours"), _percent(row.get("deviation")),
              f"{100 * row['tolerance']:.1f} %" if is_number(row.get("tolerance")) else None, row.get("verdict"),
              *((row.get("of_sweep"),) if moving else ())) for row in rows]
    note = "<p>The case as published, computed by the quasi-static model on the speeds of its own sweep, as the sources did theirs."
    if moving:
        note += f" The last column holds the same quantities of the points of this sweep ({escape(report.fidelity)})."
    note += "</p>"
    return _section("Published numbers beside ours", note + table(Table(names, cells)))


def _sensitivities(report: Report) -> str:
    rows = report.records("sensitivities")
    if not rows:
        return ""
    names = ("assumption", "other reading", "peak (rpm)", f"{style.life_name(report.life_key)} at the peak (h)", "effect")
    cells = [(row.get("assumption"), row.get("reading"), row.get("peak_speed_rpm"), row.get("peak_life_h"),
              _hours(row["worth_h"]) if is_number(row.get("worth_h")) else None) for row in rows]
    first = next((row for row in rows if is_number(row.get("peak_life_h")) and is_number(row.get("worth_h"))), None)
    base = f", {format_quantity(first['peak_life_h'] - first['worth_h'], 'h')} as the case stands" if first else ""
    note = ("<p>The quasi-static sweep over the grid of speeds with another reading of one assumption. The effect is the change of the life at its "
            f"best grid speed{base}.</p>")
    return _section("Effect of each assumption", note + table(Table(names, cells)))


def _percent(value: Any) -> Any:
    return f"{100.0 * value:+.1f} %" if is_number(value) else value


def _versions(report: Report) -> str:
    rows = [(key, _text(value)) for key, value in sorted(report.record("versions").items())]
    return _section("Versions", table(Table(("part", "version"), rows)) if rows else "<p>Not recorded.</p>")


def _text(value: Any) -> str:
    """A version is a label, never a number to be rounded."""
    return MISSING if value is None else str(value)


def _reproduce(report: Report) -> str:
    fidelity = f" --fidelity {report.fidelity}" if report.fidelity in ("quasi-static", "dynamic", "co-simulated", "monolithic") else ""
    first = next(iter(records(report.record("branches").get("runs"))), {}).get("name")
    fidelity += f" --continue {first}" if first in ("up", "down") else ""
    commands = f"orbearing sweep case.resolved.yaml -o again{fidelity}\norbearing report again"
    text = "<p>In the folder of this page, which holds the case with every default resolved:</p>"
    return _section("How to reproduce", f"{text}\n<pre>{escape(commands)}</pre>")
