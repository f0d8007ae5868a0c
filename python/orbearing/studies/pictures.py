"""Pictures and the page of a study; `result` is its orbearing.StudyResult."""

from __future__ import annotations

from html import escape
from pathlib import Path

import numpy as np

from orbearing import page, style
from orbearing.blocks import FigureBlock, Table, format_number, format_quantity
from orbearing.studies.dataset import in_rpm
from orbearing.studies.design import SPEED
from orbearing.whole_files import write_whole

PICTURE = (6.0, 4.0)  # [inch]
MOST_CURVES = 60  # that a picture shows one by one
MOST_ROWS = 200  # of a table on a page
QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)


def life_picture(result, axes=None):
    """Life over speed, or over the first parameter where the speed is no dimension; returns the axes."""
    if axes is None:
        from matplotlib import pyplot

        _, axes = pyplot.subplots(figsize=PICTURE, layout="constrained")
    life = result.table.column(result.life_key)
    if not result.design.over_speed:
        parameter = next((p for p in result.design.parameters if p.is_number and p.path != SPEED), result.design.parameters[0])
        _over_parameter(axes, result, parameter, life)
        return axes
    curves = life.reshape(-1, result.design.shape[-1])
    speed = in_rpm(next(p for p in result.design.parameters if p.path == SPEED))
    order = np.argsort(speed)
    if len(curves) <= MOST_CURVES:
        _curves(axes, result, speed[order], curves[:, order])
    else:
        _quantiles(axes, speed[order], curves[:, order])
    style.speed_axis(axes)
    style.life_axis(axes, result.life_key)
    return axes


def _colouring(result):
    """The first parameter but the speed, which colours curves; None where nothing else varies."""
    return next((p for p in result.design.parameters if p.path != SPEED), None)


def _curves(axes, result, speed: np.ndarray, curves: np.ndarray) -> None:
    from matplotlib import colormaps
    from matplotlib.colors import Normalize

    parameter = _colouring(result)
    first = np.arange(len(curves)) * len(speed)
    places = result.design.along(parameter, first) if parameter else np.zeros(len(curves), int)
    lengths = dict(result.design.dimensions)
    if parameter is None or lengths[parameter.dimension] <= len(style.SERIES):
        named = set()
        for place, curve in zip(places, curves):
            label = None if parameter is None or place in named else f"{parameter.path} {parameter.texts[place]}"
            named.add(place)
            axes.plot(speed, curve, color=style.SERIES[place % len(style.SERIES)], label=label, **style.points_look(len(speed)))
        if parameter is not None:
            style.legend_above(axes)
        return
    shades = parameter.values if parameter.is_number else np.arange(len(parameter.texts), dtype=float)
    norm = Normalize(float(shades.min()), float(shades.max()))
    for place, curve in zip(places, curves):
        axes.plot(speed, curve, color=colormaps["viridis"](norm(shades[place])), linewidth=1.0)
    from matplotlib.cm import ScalarMappable

    bar = axes.figure.colorbar(ScalarMappable(norm, "viridis"), ax=axes)
    bar.set_label(f"{parameter.path} ({parameter.unit})" if parameter.is_number else parameter.path)


def _quantiles(axes, speed: np.ndarray, curves: np.ndarray) -> None:
    known = np.where(np.isfinite(curves), curves, np.nan)
    some = np.isfinite(known).any(axis=0)
    low, lower, middle, upper, high = np.nanquantile(known[:, some], QUANTILES, axis=0)
    axes.fill_between(speed[some], low, high, color=style.SKY, alpha=0.35, linewidth=0, label="5 to 95 % of the variants")
    axes.fill_between(speed[some], lower, upper, color=style.BLUE, alpha=0.4, linewidth=0, label="25 to 75 %")
    axes.plot(speed[some], middle, color=style.BLACK, label="median")
    style.legend_above(axes, columns=3)


def _over_parameter(axes, result, parameter, life: np.ndarray) -> None:
    places = result.design.along(parameter, np.arange(result.points))
    values = parameter.values if parameter.is_number else np.arange(len(parameter.texts), dtype=float)
    axes.plot(values[places], life, linestyle="", marker=".", color=style.BLUE)
    axes.set_xlabel(f"{parameter.path} ({parameter.unit})" if parameter.is_number else parameter.path)
    style.life_axis(axes, result.life_key)


def _peak_block(result) -> FigureBlock | None:
    """Where the peak stands, over the first parameter."""
    parameter = _colouring(result)
    if parameter is None or not result.design.over_speed:
        return None
    variants = result.variants()
    number = parameter.is_number
    found = [(v[parameter.path] if number else parameter.texts.index(str(v[parameter.path])), v["peak_speed_rpm"], v["peak_life_h"])
             for v in variants if v.get("peak_life_h") is not None]
    if not found:
        return None
    along, speed, life = np.array(found, float).T
    figure, axes = style.panel(PICTURE)
    shown = axes.scatter(along, life, c=speed, cmap="viridis", s=14)
    bar = figure.colorbar(shown, ax=axes)
    bar.set_label("speed of the peak (rpm)")
    axes.set_xlabel(f"{parameter.path} ({parameter.unit})" if number else parameter.path)
    axes.set_ylabel(f"longest {style.life_label(result.life_key)}")
    caption = f"The longest {style.life_name(result.life_key)} over the grid of speeds of each variant, and the speed at which it stands."
    return FigureBlock("peaks", f"Peak over {parameter.path}", caption, (style.to_svg(figure, "peaks", caption),))


def headline(result) -> str:
    """The answer in one sentence."""
    def life(variant):
        return variant.get("peak_life_h", variant.get(result.life_key))

    lives = [v for v in result.variants() if life(v) is not None]
    if not lives:
        return f"None of {result.points} points has {style.a_life(result.life_key)}."

    best, worst = max(lives, key=life), min(lives, key=life)
    said = ", ".join(f"{p.path} {_shown(best[p.path])}{'' if p.unit in ('', '1') else ' ' + p.unit}" for p in result.design.parameters if p.path in best)
    return (f"Of {result.design.variants} variants the longest {style.life_name(result.life_key)} is {format_quantity(life(best), 'h')}"
            f"{' (' + said + ')' if said else ''}, the shortest {format_quantity(life(worst), 'h')}.")


def _shown(value) -> str:
    return format_number(value) if isinstance(value, float) else str(value)


def _variants_table(result) -> str:
    rows = result.variants()
    units = {p.path: p.unit for p in result.design.parameters if p.unit not in ("", "1")}
    head = tuple(f"{name} ({units[name]})" if name in units else name for name in (rows[0] if rows else {}))
    note = f"<p>The first {MOST_ROWS} of {len(rows)}; all are in study.nc.</p>" if len(rows) > MOST_ROWS else ""
    return f"<section>\n<h2>Variants</h2>\n{note}{page.table(Table(head, [tuple(row.values()) for row in rows[:MOST_ROWS]]))}\n</section>"


def _warnings(result) -> str:
    said = "<ul>" + "\n".join(f"<li>{escape(text)}</li>" for text in result.warnings) + "</ul>" if result.warnings else "<p>None.</p>"
    return f"<section>\n<h2>Warnings</h2>\n{said}\n</section>"


def page_of(result) -> str:
    """The whole document; the same results give the same bytes."""
    with style.context():
        figure, axes = style.panel(PICTURE)
        life_picture(result, axes)
        whose = "of each variant" if result.design.variants <= MOST_CURVES else "over all variants"
        caption = f"Governing life of one bearing {whose}, {result.life_key}."
        blocks = [FigureBlock("lives", "Life", caption, (style.to_svg(figure, "lives", caption),)), _peak_block(result)]
    name = escape(result.header["case"])
    sizes = " × ".join(f"{escape(dimension)} {length}" for dimension, length in result.design.dimensions)
    failures = result.failures()
    rows = [("Points", f"{sizes} = {result.points}"), ("Fidelity", result.header["fidelity"]), ("Governing life", result.life_key), ("Sampler", result.design.sampler),
            ("Points without a result", str(result.failed)), *((f"{count} points", reason) for reason, count in failures.items())]
    figures = [page._figure(index, block) for index, block in enumerate((b for b in blocks if b), start=1)]
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">', '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{name}: study</title>", f"<style>\n{page.STYLE_SHEET.read_text(encoding='utf-8')}</style>", "</head>", "<body>", "<main>",
        f'<header><p class="case">{name}</p>\n<h1>{escape(headline(result))}</h1></header>', page.table(Table(("study", ""), rows)), *figures,
        _variants_table(result), _warnings(result), "</main>", "</body>", "</html>", ""])


def write_report(result, path: Path) -> Path:
    """Writes the page aside and renames it."""
    write_whole(path, page_of(result))
    return path
