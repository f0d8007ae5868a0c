"""Tutorials: Markdown whose Python blocks are run in order, in one namespace, with what they print and draw.

A block marked ```python is run and shown. What stands in a comment <!-- check ... --> is run and not shown: it asserts what
the text around it says. <!-- needs MODULE, ... --> names modules without which the tutorial is not run. Of each block the site
shows what it printed, the value of its last expression and its figures.

    missing_modules(file)        those that it needs and that are not there
    run(file) -> Tutorial        raises TutorialError with file and line where a block fails
    tutorial.markdown(folder)    the page with outputs; figures are written into the folder
    tutorial.notebook()          the same as an .ipynb, outputs included
"""

from __future__ import annotations

import ast
import base64
import contextlib
import importlib.util
import io
import json
import linecache
import os
import re
import tempfile
import time
import traceback
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

_NEEDS = re.compile(r"^<!-- needs (?P<modules>[\w., ]+) -->$", re.M)
_PART = re.compile(r"^```python\n(?P<code>.*?)^```$|^<!-- check\n(?P<check>.*?)^-->$", re.S | re.M)


class TutorialError(Exception):
    """A block that failed, with its place and the traceback."""


@dataclass
class Output:
    """What a block left behind: text, HTML beside it, figures."""

    printed: str = ""
    text: str = ""
    html: str = ""
    figures: list[bytes] = field(default_factory=list)  # PNG


@dataclass
class Part:
    """A stretch of the text (kind "text"), or a block that is run ("code"; "check": not shown)."""

    kind: str
    source: str
    line: int  # of the first line, from 1
    output: Output = field(default_factory=Output)


@dataclass
class Tutorial:
    name: str
    parts: list[Part]
    seconds: float

    def markdown(self, folder: Path) -> str:
        """The page; its figures become files in `folder`, named after the tutorial."""
        lines = []
        drawn = 0
        for part in self.parts:
            if part.kind == "text":
                lines.append(part.source.strip("\n"))
            elif part.kind == "code":
                lines.append(f"```python\n{part.source}```")
                lines += _shown(part.output)
                for figure in part.output.figures:
                    drawn += 1
                    picture = folder / f"{self.name}_{drawn}.png"
                    picture.write_bytes(figure)
                    lines.append(f"![Figure {drawn}, drawn by the block above]({picture.name})")
        return "\n\n".join(line for line in lines if line) + "\n"

    def notebook(self) -> str:
        """As nbformat 4.5 has it."""
        cells = []
        for part in self.parts:
            cell = {"id": f"cell-{len(cells)}", "metadata": {}}
            if part.kind == "text" and part.source.strip():
                cells.append({**cell, "cell_type": "markdown", "source": part.source.strip("\n")})
            elif part.kind == "code":
                count = 1 + sum(one["cell_type"] == "code" for one in cells)
                cells.append({**cell, "cell_type": "code", "source": part.source.rstrip("\n"), "execution_count": count,
                              "outputs": _cell_outputs(part.output, count)})
        about = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
                 "language_info": {"name": "python"}}
        return json.dumps({"cells": cells, "metadata": about, "nbformat": 4, "nbformat_minor": 5}, indent=1) + "\n"


def split(text: str) -> list[Part]:
    """A tutorial's text as parts in their order."""
    parts, place = [], 0
    for found in _PART.finditer(text):
        parts.append(Part("text", text[place:found.start()], 1 + text.count("\n", 0, place)))
        kind = "code" if found["code"] is not None else "check"
        parts.append(Part(kind, found["code"] if kind == "code" else found["check"], 2 + text.count("\n", 0, found.start())))
        place = found.end()
    parts.append(Part("text", text[place:], 1 + text.count("\n", 0, place)))
    return parts


def missing_modules(file: Path) -> list[str]:
    """Modules that a tutorial needs and that are not there."""
    needs = _NEEDS.search(Path(file).read_text(encoding="utf-8"))
    names = [name.strip() for name in needs["modules"].split(",")] if needs else []
    return [name for name in names if importlib.util.find_spec(name) is None]


def run(file: Path) -> Tutorial:
    """Runs a tutorial's blocks in a folder of their own, which is removed afterwards."""
    import matplotlib

    matplotlib.use("Agg")
    file = Path(file).resolve()
    text = file.read_text(encoding="utf-8")
    parts = split(text)
    # What a block defines finds its source under the file's own name and line.
    linecache.cache[str(file)] = (len(text), None, text.splitlines(keepends=True), str(file))
    space = {"__name__": "__tutorial__"}
    begin = time.perf_counter()
    before = os.getcwd()
    with tempfile.TemporaryDirectory(prefix="orbearing-tutorial-") as folder:
        os.chdir(folder)
        try:
            for part in parts:
                if part.kind != "text":
                    part.output = _run(part, file, space)
        finally:
            os.chdir(before)
            linecache.cache.pop(str(file), None)
    return Tutorial(file.stem, parts, time.perf_counter() - begin)


def _run(part: Part, file: Path, space: dict) -> Output:
    from matplotlib import pyplot

    output, printed, value = Output(), io.StringIO(), None
    pyplot.close("all")
    try:
        with contextlib.redirect_stdout(printed):
            tree = ast.increment_lineno(ast.parse(part.source, str(file)), part.line - 1)
            last = ast.Expression(tree.body.pop().value) if tree.body and isinstance(tree.body[-1], ast.Expr) else None
            exec(compile(tree, str(file), "exec"), space)
            if last is not None:
                value = eval(compile(last, str(file), "eval"), space)
    except Exception as error:
        raise TutorialError(f"{file}: the block at line {part.line} failed\n{printed.getvalue()}{traceback.format_exc()}") from error
    output.printed = printed.getvalue()
    for figure in {id(one): one for one in [*map(pyplot.figure, pyplot.get_fignums()), *_figures_in(value)]}.values():
        picture = io.BytesIO()
        figure.savefig(picture, format="png", dpi=110, metadata={"Software": None})
        output.figures.append(picture.getvalue())
    pyplot.close("all")
    if value is not None and not output.figures:
        output.text = repr(value)
        output.html = value._repr_html_() if hasattr(value, "_repr_html_") else ""
    return output


def _figures_in(value) -> list:
    """Figures that a value is or holds and pyplot need not know of."""
    from matplotlib.figure import Figure

    several = value.values() if isinstance(value, Mapping) else value if isinstance(value, (list, tuple)) else [value]
    return [one for one in several if isinstance(one, Figure)]


def _shown(output: Output) -> list[str]:
    lines = []
    for text in (output.printed, "" if output.html else output.text):
        if text:
            lines.append("```{code-block} text\n:class: output\n\n" + text.rstrip("\n") + "\n```")
    if output.html:
        lines.append("```{raw} html\n<div class=\"output\">" + output.html + "</div>\n```")
    return lines


def _cell_outputs(output: Output, count: int) -> list[dict]:
    outputs: list[dict] = []
    if output.printed:
        outputs.append({"output_type": "stream", "name": "stdout", "text": output.printed})
    for figure in output.figures:
        outputs.append({"output_type": "display_data", "metadata": {}, "data": {"image/png": base64.b64encode(figure).decode()}})
    if output.text:
        data = {"text/plain": output.text, **({"text/html": output.html} if output.html else {})}
        outputs.append({"output_type": "execute_result", "execution_count": count, "metadata": {}, "data": data})
    return outputs
