"""The assessor's page as PDF: the head of the report with a few figures, at most 8 pages."""

from __future__ import annotations

import base64
import hashlib
import re
from datetime import datetime, timezone
from html import escape
from pathlib import Path
from typing import Sequence

from orbearing import assessor
from orbearing.blocks import FigureBlock
from orbearing.errors import CaseError
from orbearing.result_folder import Report, record

MOST_PAGES = 8
STYLE_SHEET = Path(__file__).with_name("assessor.css")
FIGURES = ("life", "load-spectrum", "polar", "element-loads")
# From the longest to the shortest: rows of tables, and whether there are figures.
LEVELS = ((assessor.Most(), True), (assessor.Most(), False), (assessor.Most(12, 10), False), (assessor.Most(6, 5), False))


def rated(report: Report) -> Report:
    """What the sections are made of: a sweep, or what the run of a single bearing or of a pair printed."""
    for kind in ("static", "balls", "pair"):
        if report.record(kind):
            return report.of(kind)
    return report


def pdf(report: Report, blocks: Sequence[FigureBlock]) -> bytes:
    """The document. Raises CaseError where the result has no rated bearing or cannot be cut to 8 pages."""
    from weasyprint import HTML

    if not assessor.is_rated(report):
        raise CaseError("--pdf: found a result without rated lives; required: a run or sweep with at least one point that was computed")
    pages = 0
    for most, figures in LEVELS:
        document = HTML(string=html(report, blocks, most, figures)).render()
        pages = len(document.pages)
        if pages <= MOST_PAGES:
            return document.write_pdf()
    raise CaseError(f"--pdf: found {pages} pages with the shortest tables; required: at most {MOST_PAGES}. Shorten the reasons of assumptions")


def html(report: Report, blocks: Sequence[FigureBlock], most: assessor.Most, figures: bool = True) -> str:
    """The document before it is cut into pages: one picture is on the first, the others follow the tables."""
    name, source = _name_and_source(report)
    drawn = sorted((block for block in blocks if block.slug in FIGURES and block.pictures and not _is_point(report, block)), key=lambda block: FIGURES.index(block.slug))
    first = [block for block in drawn if block.slug != "load-spectrum"][:1]
    pictures = [_figure(block) for block in drawn if block not in first] if figures else []
    title = f'<header><h1>{escape(name)}: bearing ratings, lives and verdicts</h1>\n<p>{escape(_facts(report, source))}</p>\n<p>{escape(_issue(report))}</p></header>'
    title += "".join(f'\n<div class="first">{_image(block.pictures[0])}<p>{escape(block.title)}.</p></div>' for block in first)
    return "\n".join(["<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">', f"<title>{escape(name)}: bearing assessment</title>",
                      f"<style>\n{STYLE_SHEET.read_text(encoding='utf-8')}</style>", "</head>", "<body>", title,
                      *map(_breakable, assessor.sections(report, most)), *pictures, "</body>", "</html>", ""])


def _name_and_source(report: Report) -> tuple[str, str]:
    case = report.content.get("case")
    if isinstance(case, dict):
        # The pictures of several sets are of one of them, the tables of all.
        return str(case.get("name") or "unnamed case").split(", set ")[0], str(case.get("source") or "")
    return str(case or "unnamed case"), ""


def _facts(report: Report, source: str) -> str:
    versions = record(report.content.get("versions"))
    fidelity = report.content.get("fidelity")
    facts = [f"Source: {source}." if source else "", f"Fidelity: {fidelity}." if fidelity else "",
             f"Computed by orbearing {versions.get('orbearing')}." if versions.get("orbearing") else "",
             "The full report, report.html, is the appendix; case.resolved.yaml holds every input."]
    return " ".join(fact for fact in facts if fact)


def _issue(report: Report) -> str:
    """Date and revision of the results: the day on which they were computed, and a checksum of all inputs."""
    resolved = report.folder / "case.resolved.yaml" if report.folder else None
    if resolved is None or not resolved.is_file():
        return ""
    day = datetime.fromtimestamp(resolved.stat().st_mtime, timezone.utc).date().isoformat()
    revision = hashlib.sha256(resolved.read_bytes()).hexdigest()[:8]
    return f"Date: {day}. Revision: {revision} (begin of the SHA-256 of case.resolved.yaml)."


def _is_point(report: Report, block: FigureBlock) -> bool:
    """Whether a curve over speed has one point."""
    return block.slug == "life" and len(report.records("points")) < 2


def _breakable(section: str) -> str:
    """Keys may be broken behind their dots and underscores."""
    return re.sub(r"(?<=[A-Za-z0-9])([._])(?=[A-Za-z])", r"\1<wbr>", section)


def _image(picture: str) -> str:
    """A picture as a document of its own: WeasyPrint draws the glyphs of these alone."""
    names = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    text = str(picture).replace("<svg", names, 1).replace(' href="#', ' xlink:href="#')
    return f'<img alt="" src="data:image/svg+xml;base64,{base64.b64encode(text.encode("utf-8")).decode("ascii")}">'


def _figure(block: FigureBlock) -> str:
    pictures = "".join(f'<div class="picture">{_image(picture)}</div>' for picture in block.pictures)
    return (f'<section class="figure n{len(block.pictures)}"><h2>{escape(block.title)}</h2>\n<div class="pictures">{pictures}</div>\n'
            f"<p>{escape(block.caption)}</p></section>")
