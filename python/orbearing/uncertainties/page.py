"""The page of an uncertain life."""

from __future__ import annotations

from html import escape

from orbearing import page as pages
from orbearing import style
from orbearing.blocks import FigureBlock, Table, format_number
from orbearing.uncertainties.figures import figures, life_name

BAND_CAPTION = (
    "Blue: percentiles of the life that nine tenths of all bearings reach (or the share that the case states), as the uncertain inputs "
    "have it; more knowledge narrows this band. Orange: lives of single bearings at the case's own inputs, by Weibull's distribution about the life that "
    "nine tenths reach; no measurement narrows it. Red: both together.")
PEAK_CAPTION = ("The longest life of each sampled curve and its speed. Each is an operating point that was computed, with shorter ones within 2 rpm on "
                "both sides (a thousandth of the speed below 2000 rpm).")
INDICES_CAPTION = ("Sobol indices with 95 % intervals. First: the share of the variance that goes, as expected, once the input is known. Total: the share that "
                   "stays, as expected, while it alone is not known. At the operating point from lives by pick and freeze, of the peak from a "
                   "polynomial chaos expansion of the computed peaks. Correlated inputs are one group.")


def page(result) -> str:
    """The whole document."""
    with style.context():
        pictures = {name: style.to_svg(figure, name, name.replace("_", " ")) for name, figure in figures(result).items()}
    blocks = [FigureBlock("life-band", "Life over speed", BAND_CAPTION, (pictures["life_band"],), data=_band_table(result.data)),
              FigureBlock("peak", "The peak", PEAK_CAPTION, (pictures["peak"],), _peak_table(result.data)),
              FigureBlock("indices", "Where the spread comes from", INDICES_CAPTION, (pictures["indices"],), _index_table(result.data))]
    name = escape(str(result.data["case"]))
    sections = [answer(result), *(pages._figure(index, block) for index, block in enumerate(blocks, start=1)), _inputs(result.data),
                _motion(result.data), _warnings(result.data), _reproduce(result.data)]
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">', f"<title>{name}: uncertain life</title>",
        f"<style>\n{pages.STYLE_SHEET.read_text(encoding='utf-8')}</style>", "</head>", "<body>", "<main>",
        *(section for section in sections if section), "</main>", "</body>", "</html>", "",
    ])


def headline(data: dict) -> str:
    """The answer in a sentence."""
    point = data["operating_point"]
    band = point["of_uncertain_inputs"]["percentiles"]
    text = (f"At {format_number(point['speed_rpm'])} rpm {life_name(data)} lies between {format_number(band['5'], 4)} and "
            f"{format_number(band['95'], 4)} h (5 to 95 %)")
    first = next(iter(data["measure_first"]), None)
    return text + (f"; measure {first['measure']} first." if first else ".")


def answer(result) -> str:
    data = result.data
    return (f'<header><p class="case">{escape(str(data["case"]))}</p>\n<h1>{escape(headline(data))}</h1></header>\n'
            + pages.table(summary_table(data)))


def summary_table(data: dict) -> Table:
    """The bands at the operating point, apart and together."""
    point = data["operating_point"]
    rows = [(title, *point[band]["percentiles"].values()) for title, band in
            (("of uncertain inputs", "of_uncertain_inputs"), ("of single bearings at the case's inputs", "of_single_bearings_at_the_case"),
             ("of both", "of_both"))]
    peak = data["peak"]
    rows += [("speed of the peak (rpm), of uncertain inputs", *peak["speed_rpm"]["percentiles"].values()),
             (f"{life_name(data)} at the peak, of uncertain inputs", *peak["life_h"]["percentiles"].values())]
    return Table((f"{data['life']} (h) at {point['speed_rpm']:g} rpm", *(f"{percent} %" for percent in point["of_both"]["percentiles"])), rows)


def _band_table(data: dict) -> Table:
    rows = [(row["speed_rpm"], row["life_at_the_case_h"], *row["of_uncertain_inputs"]["percentiles"].values(), row["of_both"]["L10"])
            for row in data["speeds"]]
    percents = data["operating_point"]["of_both"]["percentiles"]
    return Table(("input speed (rpm)", "the case (h)", *(f"inputs {percent} % (h)" for percent in percents), "life that 90 % reach, all uncertain (h)"), rows)


def _peak_table(data: dict) -> Table:
    peak = data["peak"]
    rows = [("speed (rpm)", peak["speed_at_the_case_rpm"], peak["speed_rpm"]["mean"], peak["speed_rpm"]["standard_deviation"],
             *peak["speed_rpm"]["percentiles"].values()),
            (f"{life_name(data)} (h)", peak["life_at_the_case_h"], peak["life_h"]["mean"], peak["life_h"]["standard_deviation"],
             *peak["life_h"]["percentiles"].values())]
    return Table(("of the peak", "the case", "mean", "standard deviation", *(f"{percent} %" for percent in peak["life_h"]["percentiles"])), rows)


def _index_table(data: dict) -> Table:
    rows = []
    for title, one in ((f"life at {data['operating_point']['speed_rpm']:g} rpm", data["operating_point"]),
                       ("speed of the peak", data["peak"]["speed_rpm"]), ("life at the peak", data["peak"]["life_h"])):
        for row in sorted(one["indices"], key=lambda row: -row["first"]):
            rows.append((title, row["inputs"], row["first"], _interval(row["first_95"]), row["total"], _interval(row["total_95"]),
                         row["expected_standard_deviation_after"]))
    return Table(("result", "input", "first", "95 %", "total", "95 %", "expected standard deviation once it is known (h or rpm)"), rows)


def _interval(edges) -> str:
    return f"{format_number(edges[0], 3)} to {format_number(edges[1], 3)}"


def _inputs(data: dict) -> str:
    rows = [(one["path"], one["value"], one["unit"], one["distribution"], one["reason"]) for one in data["inputs"]]
    return pages._section("What is not known for sure", pages.table(Table(("input", "the case", "unit", "distribution", "reason"), rows)))


def _motion(data: dict) -> str:
    if not data["motion"]:
        return ""
    note = "<p>Samples at percentiles of the life at rest, computed in motion too.</p>"
    rows = [(row["percentile"], row["quasi_static_h"], row["dynamic_h"], row["ratio"], row["status"]) for row in data["motion"]]
    return pages._section("Beside points in motion", note + pages.table(
        Table(("percentile", "at rest (h)", "in motion (h)", "ratio", "status"), rows)))


def _warnings(data: dict) -> str:
    texts = "<ul>" + "\n".join(f"<li>{escape(text)}</li>" for text in data["warnings"]) + "</ul>" if data["warnings"] else "<p>None.</p>"
    return pages._section("Warnings", texts)


def _reproduce(data: dict) -> str:
    used = data["settings"]
    words = " ".join(f"--{key.replace('_', '-')} {value}" for key, value in used.items() if value is not None)
    text = f"orbearing uncertainty case.resolved.yaml -o again {words} --life {data['life']}"
    return pages._section("How to reproduce", f"<p>In the folder of this page:</p>\n<pre>{escape(text)}</pre>")
