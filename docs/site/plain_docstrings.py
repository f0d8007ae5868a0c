"""Sphinx extension: docstrings of plain text, as the package has them, become reStructuredText.

Lines "name: meaning" about parameters become a list, indented and tabulated paragraphs stay as they are written.
"""

from __future__ import annotations

import inspect
import re

_PARAMETERS = re.compile(r"(?P<names>\w+(?:, \w+)*): (?P<meaning>.+)")


def paragraphs(lines: list[str]) -> list[list[str]]:
    found: list[list[str]] = [[]]
    for line in lines:
        if line.strip():
            found[-1].append(line.rstrip())
        elif found[-1]:
            found.append([])
    return [one for one in found if one]


def rendered(paragraph: list[str], parameters: set[str]) -> list[str]:
    """A paragraph's lines as reStructuredText."""
    if any(line.startswith(" ") or re.search(r"\S {2,}\S", line) for line in paragraph):
        return ["::", "", *("    " + line for line in paragraph)]
    lines: list[str] = []
    listed = False
    for line in paragraph:
        found = _PARAMETERS.fullmatch(line)
        if found and set(found["names"].split(", ")) <= parameters:
            lines += ([] if listed or not lines else [""]) + [f"- **{found['names']}**: {found['meaning']}"]
            listed = True
        elif listed and re.match(r"(Returns|Raises)\b", line):
            lines += ["", line]
            listed = False
        else:
            lines.append(("  " if listed else "") + line)
    return lines


def parameters_of(thing) -> set[str]:
    try:
        return set(inspect.signature(thing).parameters)
    except (TypeError, ValueError):
        return set()


def rewrite(app, what, name, thing, options, lines: list[str]) -> None:
    known = parameters_of(thing)
    if what in ("class", "exception"):
        known |= {one for one in dir(thing) if not one.startswith("_")}
    lines[:] = [line for paragraph in paragraphs(lines) for line in [*rendered(paragraph, known), ""]]


def setup(app):
    app.connect("autodoc-process-docstring", rewrite)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
