"""The pages of the guide, in Markdown."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Optional

from matplotlib.backends.backend_agg import FigureCanvasAgg

from orbearing.validation.pictures import scatter
from orbearing.validation.rows import COUNTED, KINDS, TREND, Row, calibration, distinct, once_a_bearing, statistics

VERDICTS = ("reproduced", "trend", "missed", "input missing")
NOT_UNDERSTOOD = "not understood"
DOTS = 110  # per inch


def cell(text) -> str:
    """A text within a table."""
    return str(text).replace("\\", "\\\\").replace("|", "\\|").replace("*", "\\*").replace("<", "&lt;").replace("\n", " ")


def table(heads: Sequence[str], rows: Iterable[Sequence]) -> str:
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(cell(value) for value in row) + " |" for row in rows])


def percent(value: Optional[float], sign: bool = False) -> str:
    """Of a logarithm, small or not, as a ratio less one."""
    if value is None:
        return ""
    number = 100.0 * math.expm1(value)
    digits = 1 if abs(number) >= 1.0 else 2 if abs(number) >= 0.1 else 3
    return f"{number:{'+' if sign else ''}.{digits}f} %"


def slug(name: str) -> str:
    return re.sub(r"\W+", "_", name).strip("_").lower()


def classes_of(rows: Iterable[Row]) -> dict[str, list[Row]]:
    """Rows by the class of their quantity; those with most counted values first."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row.of, []).append(row)
    return dict(sorted(found.items(), key=lambda one: (-sum(row.counts for row in one[1]), one[0])))


def verdict_counts(found: dict[str, int]) -> list[int]:
    """Of each verdict: together they are all values."""
    return [found.get(verdict, 0) for verdict in VERDICTS]


def most_missed(rows: Iterable[Row]) -> str:
    """The reason that most of the misses share: how many, of what, why."""
    reasons = Counter((row.of, row.why or NOT_UNDERSTOOD) for row in rows if row.verdict == "missed")
    if not reasons:
        return ""
    (of, why), count = reasons.most_common(1)[0]
    return f"{count} of {of}: {why}"


def counts_table(rows: Sequence[Row]) -> str:
    """Distinct values by kind and verdict."""
    read = [row for row in rows if not row.memory]
    lines = []
    for kind in KINDS:
        of_kind = [row for row in read if row.kind == kind]
        found = statistics(of_kind)
        lines.append((kind, found.values, found.sources, *verdict_counts(found.verdicts), "yes" if kind in COUNTED else "no",
                      most_missed(of_kind)))
    counted = [row for row in read if row.counts]
    total = statistics(counted)
    lines.append(("all that count", total.values, total.sources, *verdict_counts(total.verdicts), "", most_missed(counted)))
    return table(("kind of evidence", "values", "sources", *VERDICTS, "counts", "most frequent reason of a miss"), lines)


# The first questions of a specialist, and the classes of quantities for them.
FIRST_ASKED = {"friction": ("friction", "rolling resistance"), "heat": ("friction and heat", "temperature"), "slip": ("cage speed", "slip"), "loads": ("contact load", "bearing load"),
               "load sharing": ("load sharing",), "stiffness": ("stiffness", "displacement", "tilt"),
               "vibration": ("natural frequency", "characteristic frequency", "acceleration")}


def first_table(rows: Sequence[Row]) -> str:
    """Values that count, by what is asked first."""
    lines = []
    for name, classes in FIRST_ASKED.items():
        of_name = [row for row in rows if row.of in classes and row.counts]
        found = statistics(of_name)
        lines.append((name, found.values, sum(row.kind == "measurement" for row in of_name), found.sources, percent(found.bias, True),
                      percent(found.deviation), *verdict_counts(found.verdicts), most_missed(of_name)))
    return table(("quantity", "values", "of them measured", "sources", "bias", "standard deviation", *VERDICTS, "most frequent reason of a miss"), lines)


def statistics_table(classes: dict[str, list[Row]]) -> str:
    """Bias and spread of each class and kind."""
    lines = []
    for name, rows in classes.items():
        for kind in KINDS:
            of_kind = [row for row in rows if row.kind == kind and not row.memory]
            if of_kind and name != TREND:
                found = statistics(of_kind)
                lines.append((name, kind, found.values, found.sources, percent(found.of_measurement), percent(found.bias, True),
                              percent(found.deviation), percent(found.of_model), *verdict_counts(found.verdicts)))
    return table(("quantity", "kind", "values", "sources", "scatter of the measurement", "bias", "standard deviation",
                  "left to the model", *VERDICTS), lines)


def rows_table(rows: Sequence[Row]) -> str:
    def number(value: Optional[float]) -> str:
        return "" if value is None else f"{value:.5g}"

    def band(row: Row) -> str:
        return f"{row.band['low_90']:.4g} to {row.band['high_90']:.4g}" if row.band else ""

    banded = any(row.band for row in rows)
    heads = ("source", "meaning", "kind", "published", "ours", "deviation", "tolerance", "scatter", *(("ours, 90 %",) if banded else ()),
             "verdict", "case and settings")
    return table(heads, ((row.source, row.meaning, row.kind + (", identified from" if row.fitted else ""), number(row.published),
                          number(row.ours), "" if row.log_ratio is None else f"{100 * (row.ours / row.published - 1):+.2f} %",
                          f"{100 * row.tolerance:.3g} %", "" if row.scatter is None else f"{100 * row.scatter:.3g} %",
                          *((band(row),) if banded else ()), row.verdict, row.case + (": " + row.reading if row.reading else ""))
                         for row in rows))


def misses(rows: Iterable[Row]) -> str:
    missed = [row for row in rows if row.verdict == "missed" and not row.memory]
    if not missed:
        return "None."
    return table(("case", "source", "what", "kind", "published", "ours", "deviation", "reason"),
                 ((row.case, row.source, row.meaning, row.kind, f"{row.published:.5g}", "" if row.ours is None else f"{row.ours:.5g}",
                   "" if row.log_ratio is None else f"{100 * (row.ours / row.published - 1):+.1f} %", row.why or NOT_UNDERSTOOD)
                  for row in missed))


def calibration_text(rows: Sequence[Row]) -> str:
    found = calibration(rows)
    if found.values == 0:
        return "No measurement of a case with uncertain inputs."
    by_source = {}
    for row in rows:
        by_source.setdefault(row.key, []).append(row)

    def inside(one) -> list[str]:
        return [f"{count} ({100 * count / one.values:.0f} %)" for count in (one.in_50, one.in_90, one.in_both_50, one.in_both_90)]

    lines = [(key, one.values, *inside(one)) for key, of_source in by_source.items() if (one := calibration(of_source)).values]
    lines.append(("all", found.values, *inside(found)))
    return table(("source", "measurements with stated input uncertainty", "within our 50 %", "within our 90 %",
                  "50 %, with the measurement's scatter", "90 %, with the measurement's scatter"), lines)


def from_memory(references: str) -> str:
    """Entries of REFERENCES.md that say so: formulas behind them rest on memory."""
    found = re.findall(r"^\| (\[\w+\]) \| (.*memory.*?) \|$", references, re.M)
    return table(("source", "entry"), found) if found else "None."


INTRODUCTION = """Every published value that could be read, beside ours. Nothing is tuned to them; misses stand in the tables, and [below](#misses) with their
reasons. A value counts once, however many rows or readings show it; lines of passing elements, which follow from one formula, count once a bearing.
Kinds of evidence, the strongest first: *measurement*, somebody measured it; *program*, another program or the source's own model computed it; *worked-example*, a textbook, standard or catalogue prints it; *closed-form*, a formula;
*recomputed*, from the source's data by scripts of ours. The last two do not count. *Identified from*: constants of the case were identified from the value, which
therefore says little.

Bias is the mean of ln(ours/published), the standard deviation that of the same logarithm, both shown as ratios less one. *Scatter of the measurement* is the root
mean square of the relative standard deviations that the sources state; *left to the model* is what the standard deviation has beyond it. Bars in the
pictures: the measurement's standard deviation (grey on the right), and the middle 90 % of ours where the case says how uncertain its inputs are."""


def guide(rows: Sequence[Row], references: str, prefix: str = "") -> tuple[str, dict]:
    """The page, its first title left out, and its pictures by file name."""
    values = distinct(rows)
    classes = classes_of(values)
    counted = once_a_bearing(values)
    pictures = {}
    parts = [INTRODUCTION, "## What is asked first", first_table(counted), "## What counts", counts_table(counted),
             "## Quantities", statistics_table(classes_of(counted)),
             "## Misses", misses(values), "## Our bands",
             "How many measurements lie within the bands that the stated uncertainty of our inputs gives, and within these bands widened by the "
             "measurement's own scatter where that is known. Values that constants were identified from are left out. Sound bands hold half and nine "
             "tenths; fewer say that the model is off by more than its inputs are, more that inputs are stated with too much caution.",
             calibration_text(values)]
    for name, of_class in classes.items():
        read = [row for row in of_class if not row.memory]
        if not read:
            continue
        parts.append(f"## {name[0].upper()}{name[1:]}")
        if sum(row.log_ratio is not None for row in read) > 1:
            picture = f"{prefix}{slug(name)}.png"
            pictures[picture] = scatter(name, read)
            parts.append(f"![{name}: ours over published values]({picture})")
        parts.append(rows_table(read))
    remembered = [row for row in values if row.memory]
    parts += ["## Remembered", "Values remembered, not read: they do not count.", rows_table(remembered) if remembered else "None.",
              "Sources cited from memory, at least in part: formulas that lean on them lean on that.", from_memory(references)]
    return "\n\n".join(parts), pictures


def save(figure, file: Path) -> None:
    FigureCanvasAgg(figure)
    figure.savefig(file, dpi=DOTS, metadata={"Software": None})


def write_guide(rows: Sequence[Row], folder, references: str = "", title: str = "# Validation guide") -> Path:
    """FOLDER/index.md with its pictures beside; returns that page."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    text, pictures = guide(rows, references)
    for name, figure in pictures.items():
        save(figure, folder / name)
    page = folder / "index.md"
    page.write_text(f"{title}\n\n{text}\n", encoding="utf-8")
    return page
