"""The page of one run of a single bearing: a sentence, a table, figures, what was assumed."""

from __future__ import annotations

from html import escape
from typing import Sequence

from orbearing import assessor, lives
from orbearing import page as pages
from orbearing.blocks import FigureBlock, Table
from orbearing.result_folder import Report


def page(study: Report, what: str, headline: str, summary: Table, blocks: Sequence[FigureBlock]) -> str:
    """The whole document; `study` is what the run printed."""
    name = escape(str(study.content.get("case") or "unnamed case"))
    head = assessor.sections(study)
    ends = [] if head else [pages._warnings(study), pages._versions(study)]
    sections = [pages.title_of(str(study.content.get("case") or "unnamed case"), headline), *head, pages.appendix(blocks, bool(head)), lives.section(study),
                pages.table(summary), *(pages._figure(index, block) for index, block in enumerate(blocks, start=1)), pages._assumptions(study), *ends,
                _reproduce()]
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">', f"<title>{name}: {escape(what)}</title>",
        f"<style>\n{pages.STYLE_SHEET.read_text(encoding='utf-8')}</style>", "</head>", "<body>", "<main>", *sections, "</main>", "</body>",
        "</html>", "",
    ])


def _reproduce() -> str:
    text = "orbearing run case.resolved.yaml -o again\norbearing report again"
    return pages._section("How to reproduce", f"<p>In the folder of this page:</p>\n<pre>{escape(text)}</pre>")
