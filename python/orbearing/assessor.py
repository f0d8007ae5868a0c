"""What an assessor reads first: ratings and lives with their clauses, verdicts, damage by bin, influence of assumptions, warnings, versions.

The sections are the head of report.html and all of report.pdf. Numbers are those of `--json`, rounded for reading.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from html import escape
from typing import Callable

from orbearing.blocks import Table, format_number, is_number
from orbearing.lives import LIVES
from orbearing.point_file import read_point
from orbearing.result_folder import Report, record, records, same
from orbearing.style import life_name
from orbearing.tables import table

NOTE_16281 = "ISO/TS 16281:2008 has since become ISO 16281:2025."
RELIABILITY = "life.reliability"  # 90 % is what defines L10: no uncertain value
LEAST_INFLUENCE = 0.01  # [%] of the life; assumptions below are listed without a line of their own
DOCUMENT = "docs/requirements.md"
VERDICTS = {True: "passed", False: "FAILED", None: "not judged"}


@dataclass(frozen=True)
class Quantity:
    """A line of the first table: key of the result, symbol, words, unit, and the clause for balls and for rollers."""

    key: str
    symbol: str
    words: str
    unit: str
    balls: str
    rollers: str

    def clause(self, of_balls: bool) -> str:
        return self.balls if of_balls else self.rollers


QUANTITIES = (
    Quantity("C_N", "C", "basic dynamic load rating", "N", "ISO 281:2007, 5.1", "ISO 281:2007, 7.1"),
    Quantity("C0_N", "C0", "basic static load rating", "N", "ISO 76:2006, 5.1", "ISO 76:2006, 7.1"),
    Quantity("Cu_N", "Cu", "fatigue load limit", "N", "ISO 281:2007, 9.3, Annex B", "ISO 281:2007, 9.3, Annex B"),
    Quantity("P_N", "P", "dynamic equivalent load", "N", "ISO 281:2007, 5.2", "ISO 281:2007, 7.2"),
    Quantity("P0_N", "P0", "static equivalent load", "N", "ISO 76:2006, 5.2", "ISO 76:2006, 7.2"),
    Quantity("L10h", "L10h", "basic rating life", "h", "ISO 281:2007, 5.3", "ISO 281:2007, 7.3"),
    Quantity("L10rh", "L10rh", "basic reference rating life", "h", "ISO/TS 16281:2008, 4.3", "ISO/TS 16281:2008, 5.3"),
    Quantity("L10mh", "L10mh", "modified rating life", "h", "ISO 281:2007, 9.1", "ISO 281:2007, 9.1"),
    Quantity("L10mrh", "L10mrh", "modified reference rating life", "h", "ISO/TS 16281:2008, 4.3, 7", "ISO/TS 16281:2008, 5.3, 7"),
    Quantity("life_h", "life_h", "Lundberg-Palmgren, loads of this analysis", "h", "no clause", "no clause"),
    Quantity("S0", "S0", "static safety factor C0/P0", "", "ISO 76:2006, 9", "ISO 76:2006, 9"),
    Quantity("contact_pressure_max_MPa", "p_max", "largest contact pressure", "MPa", "Hertz; no clause", "Hertz; no clause"),
    Quantity("kappa", "kappa", "viscosity ratio", "", "ISO 281:2007, 9.3", "ISO 281:2007, 9.3"),
    Quantity("e_C", "e_C", "contamination factor", "", "ISO 281:2007, 9.3, Annex A", "ISO 281:2007, 9.3, Annex A"),
    Quantity("a_ISO", "a_ISO", "life modification factor", "", "ISO 281:2007, 9.3", "ISO 281:2007, 9.3"),
    Quantity("largest_load_share", "K_gamma", "largest load of a planet / mean load", "", "no clause", "no clause"),
)
LARGER_IS_WORSE = ("contact_pressure_max_MPa", "largest_load_share")
# Columns of the worst bearing over a revolution of the carrier that are no lives.
WORST_BY_CARRIER = {"P0_N": ("carrier_P0_N",), "S0": ("carrier_S0",), "contact_pressure_max_MPa": ("carrier_contact_pressure_max_MPa",),
                    "largest_load_share": ("carrier_K_gamma",)}
# For bins of a spectrum the worst is shown; other quantities belong to one bin.
WORST_OF_BINS = ("S0", "contact_pressure_max_MPa", "kappa", "largest_load_share")


@dataclass(frozen=True)
class Most:
    """Rows at most of the tables that a case makes long."""

    bins: int = 24
    influences: int = 20


@dataclass(frozen=True)
class Column:
    """A bearing, or all of them: the number by its key, None where there is none."""

    head: str
    number: Callable[[str], float | str | None]


def is_rated(report: Report) -> bool:
    """Whether there are lives to judge."""
    return bool(_columns(report))


def sections(report: Report, most: Most = Most()) -> list[str]:
    """The sections in their order; none where the result has no rated bearing."""
    if not is_rated(report):
        return []
    parts = (_ratings(report), _requirements(report), _given(report), _pair(report), _bearings(report), _damage(report, most), _influences(report, most), _warnings(report), _versions(report))
    return [part for part in parts if part]


def section(slug: str, title: str, body: str) -> str:
    return f'<section id="{slug}">\n<h2>{escape(title)}</h2>\n{body}\n</section>'


def verdict_in_words(report: Report) -> str:
    """How many requirements are met."""
    verdicts = report.records("verdicts")
    if not verdicts:
        return "The case states no requirements."
    failed, open_ones = (sum(one.get("passed") is value for one in verdicts) for value in (False, None))
    text = f"{len(verdicts) - failed - open_ones} of {len(verdicts)} requirements are met"
    return text + (f", {failed} failed" if failed else "") + (f", {open_ones} not judged" if open_ones else "") + "."


def _judged(html: str) -> str:
    """Verdicts in a table as a style sheet finds them."""
    for word, name in ((VERDICTS[True], "passed"), (VERDICTS[False], "failed")):
        html = re.sub(rf'<td( class="short)?"?>({word}(?:[:,] [^<]*)?)</td>', lambda found, name=name: f'<td class="{"short " if found[1] else ""}{name}">{found[2]}</td>', html)
    return html


def _verdict(verdict: dict | None, shown: list) -> str:
    """The verdict, with the set that decides; where the value that decides is none of those beside it, that value with its speed, bin or bearing."""
    if not verdict:
        return " "
    word, value, place = VERDICTS[verdict.get("passed")], verdict.get("value"), _place(str(verdict.get("at") or ""))
    word += f", set {verdict['of_set']}" if verdict.get("of_set") else ""
    beside = {format_number(number) for number in shown if is_number(number)}
    return f"{word}: {format_number(value)} at {place}" if is_number(value) and place and format_number(value) not in beside else word


def _place(at: str) -> str:
    """An operating point or bin of a verdict in words: "bin 2, 3,000 rpm"."""
    return re.sub(r"\binput_speed_rpm = ([-+.\de]+)", lambda found: f"{format_number(float(found[1]))} rpm", at)


def _ratings(report: Report) -> str:
    columns, balls = _columns(report), _has_balls(report)
    judged = {one.get("key"): one for one in report.records("verdicts")}
    rows = []
    for one in QUANTITIES:
        numbers = [column.number(one.key) for column in columns]
        verdict = judged.get(one.key)
        if not any(map(is_number, numbers)) and one.key in ("largest_load_share", "life_h") and not verdict:
            continue
        unit = f" [{one.unit}]" if one.unit else ""
        of_one_bearing = [number for column, number in zip(columns, numbers) if not column.head.startswith("All")]
        rows.append((one.symbol + unit, one.words, one.clause(balls), *numbers, _limit(verdict), _verdict(verdict, of_one_bearing)))
    head = ("Symbol", "Meaning", "Clause", *(column.head for column in columns), "Required", "Verdict")
    return section("ratings", "Ratings and lives", f"<p><strong>{escape(verdict_in_words(report))}</strong> {escape(_where(report))}</p>\n"
                   + _judged(table(Table(head, rows))) + f"\n<p>{escape(_reliability(report))} {NOTE_16281}</p>")


def _reliability(report: Report) -> str:
    """Of the lives: a_1 of ISO 281 is in the modified ones alone."""
    value = report.record("influences").get("reliability")
    stated = f"{format_number(100 * value)} %" if is_number(value) else "life.reliability of the case"
    if stated == "90 %":
        return "Lives hold for a reliability of 90 %."
    return f"L10mh and L10mrh hold for a reliability of {stated} (a_1 of ISO 281), the other lives for 90 %."


def _limit(verdict: dict | None) -> str:
    return f"{verdict.get('bound')} {format_number(verdict.get('limit'))} {verdict.get('unit') or ''}".strip() if verdict else " "


def _requirements(report: Report) -> str:
    verdicts = report.records("verdicts")
    if not verdicts:
        why = "A duplex pair takes no block requirements." if _is_pair(report) else f"A block requirements in the case gives verdicts ({DOCUMENT})."
        return section("requirements", "Requirements", f"<p>None. {why}</p>")
    rows = [(one.get("requirement"), one.get("key"), _limit(one), one.get("value"), VERDICTS[one.get("passed")], _judged_at(one)) for one in verdicts]
    note = "" if _single(report) else (
        "<p>The value is the worst of all operating points of this result. Under a load spectrum a life is that of the whole spectrum, load_share is that of the bin "
        "with the largest torque, every other value is that of the worst bin. Where bearings carry unlike loads, the bearing with the shortest life decides.</p>")
    return section("requirements", "Requirements", note + _judged(table(Table(("Requirement", "Result", "Required", "Value", "Verdict", "Worst at, or why not judged"), rows))))


def _given(report: Report) -> str:
    """What the case states, block by block, as it is written there."""
    blocks: dict[str, list[str]] = {}
    for one in report.records("given"):
        block, _, key = str(one.get("key")).partition(".")
        if block in ("name", "model"):  # in the heading
            continue
        blocks.setdefault(block, []).append(f"{key} {_shorter(one.get('value'))}".strip())
    rows = [(block, "; ".join(values)) for block, values in blocks.items()]
    note = "<p>Values of the case, as they are written there. All other values are in the list of assumptions.</p>"
    return section("given", "Given", note + table(Table(("Block", "Values"), rows))) if rows else ""


def _judged_at(verdict: dict) -> str:
    points, failed = verdict.get("points"), verdict.get("points_failed")
    shortest = str(verdict.get("result") or "") not in ("", str(verdict.get("key"))) and verdict.get("requirement") == "life"
    parts = ["bearing with the shortest life" if shortest else "", f"set {verdict['of_set']}" if verdict.get("of_set") else "",
             str(verdict.get("at") or ""), str(verdict.get("reason") or "")]
    if is_number(points) and points > 1:
        parts.append(f"{format_number(failed)} of {format_number(points)} points fail")
    return "; ".join(part for part in parts if part) or " "


def _columns(report: Report) -> list[Column]:
    if _single(report):
        if _is_pair(report):
            return [Column("One row", report.content.get), Column("All rows", lambda key: _of_all(report.content, key))]
        return [Column("One bearing", report.content.get)] if "L10_Mrev" in report.content else []
    row, spectrum = operating_row(report), _spectrum(report)
    sets = sorted({key.split(".")[1] for key in row if key.startswith("sets.") and key.endswith(".L10h")})
    if not sets and not any(is_number(row.get(key)) for key in LIVES[:4]):
        return []
    speed = f"{format_number(row.get('input_speed_rpm'))} rpm"
    named = [(f"One bearing of set {name}", f"sets.{name}.") for name in sets] or [("One bearing", "")]
    columns: list[Column] = []
    for words, before in named if not (spectrum and sets) else []:
        columns += _mean_and_worst(words, speed, row, before, lambda key, before=before: row.get(before + key), lambda key, before=before: _worst(row, key, before))
    if not spectrum:
        return [*columns, Column(f"All bearings, {speed}", lambda key: _of_all(row, key))]
    for words, before in named:
        columns += _mean_and_worst(words, "load spectrum", spectrum, before, lambda key, before=before: _under(spectrum, before, key),
                                   lambda key, before=before: _worst_under(spectrum, key, before))
    return [*columns, Column("All bearings, load spectrum", lambda key: _of_all(spectrum, key))]


def _mean_and_worst(words: str, where: str, lives: dict, before: str, one: Callable, worst: Callable) -> list[Column]:
    """One bearing of a set; where its bearings carry unlike loads, their mean and the worst of them."""
    if not any(is_number(_worst(lives, life, before)) for life in LIVES[:4]):
        return [Column(f"{words}, {where}", one)]
    return [Column(f"{words.replace('One bearing', 'Mean of bearings')}, {where}", one), Column(f"{words.replace('One bearing', 'Worst bearing')}, {where}", worst)]


def _of_all(row: dict, key: str) -> float | str | None:
    """Ratings, loads and factors are those of one bearing."""
    if key not in LIVES:
        return " "
    return row.get(f"system_{key}")


def _worst(row: dict, key: str, before: str = "") -> float | str | None:
    """Of the bearing that requirements are judged by: over a revolution of the carrier where that is computed, else the one with the shortest life."""
    names = WORST_BY_CARRIER.get(key, (f"carrier_{key}", f"shortest_{key}") if key in LIVES else ())
    blank = None if key in LIVES else " "
    return next((row[before + name] for name in names if is_number(row.get(before + name))), blank)


def _worst_under(spectrum: dict, key: str, before: str = "") -> float | str | None:
    """The same under the spectrum: a life of the whole of it, else the worst of its bins that take time."""
    if key in LIVES or key not in WORST_OF_BINS:
        return _worst(spectrum, key, before)
    numbers = [number for number in (_worst(one, key, before) for one in records(spectrum.get("bins")) if one.get("share")) if is_number(number)]
    return (max if key in LARGER_IS_WORSE else min)(numbers, default=" ")


def _under(spectrum: dict, before: str, key: str) -> float | None:
    """Under the spectrum: a life of the whole of it, else the worst of its bins that take time."""
    if key in ("C_N", "C0_N", "Cu_N"):
        return next((one.get(before + key) for one in records(spectrum.get("bins")) if is_number(one.get(before + key))), None)
    if key in LIVES:
        return spectrum.get(before + key)
    numbers = [one.get(before + key) for one in records(spectrum.get("bins")) if one.get("share")]
    numbers = [number for number in numbers if is_number(number)]
    if key not in WORST_OF_BINS or not numbers:
        return None
    return max(numbers) if key in LARGER_IS_WORSE else min(numbers)


def operating_row(report: Report) -> dict:
    """The point at the case's own speed, computed for the page where the sweep has none; else the one with the longest governing life, else the first."""
    points = report.along_speed().records("points")
    own = report.content.get("own_speed_rpm")
    alive = [point for point in points if is_number(point.get(report.life_key))]
    longest = max(alive, key=lambda point: point[report.life_key], default=next(iter(points), {}))
    return next((point for point in points if same(point.get("input_speed_rpm"), own)), report.record("own_point") or longest)


def _where(report: Report) -> str:
    if _is_pair(report):
        return "Values under the preload of the case alone. P and L10h of ISO 281 require a load from outside and are not computed; L10rh is by the load of each ball."
    if _single(report):
        governing = report.record("life_table").get("governing")
        return "Values of the bearing under the load of the case." + (f" The governing life is {governing} (life.method)." if governing else "")
    speed, own = operating_row(report).get("input_speed_rpm"), report.content.get("own_speed_rpm")
    computed = not any(same(point.get("input_speed_rpm"), own) for point in report.along_speed().records("points"))
    own_words = "of the case" + (", which the sweep does not have and which was computed for this page" if computed else "")
    which = own_words if same(speed, own) else f"with the longest {life_name(report.life_key)} of this sweep, which has no point at the speed of the case"
    text = f"Values at the operating point {which}, {format_number(speed)} rpm input speed. The governing life is {report.life_key} (life.method)."
    return text + (" Under the load spectrum: lives by the rule of Palmgren and Miner; S0, p_max, kappa of the worst bin." if _spectrum(report) else "")


def _pair(report: Report) -> str:
    """Of a duplex pair: what the preload does, and the stiffness and natural frequencies of the shaft."""
    if not _is_pair(report):
        return ""
    get = report.content.get
    names = (("approach_um", "approach of each row [µm]"), ("contact_angle_deg", "contact angle, inner race [deg]"), ("outer_contact_angle_deg", "contact angle, outer race [deg]"),
             ("inner_load_max_N", "largest load of a ball, inner race [N]"), ("outer_load_max_N", "largest load of a ball, outer race [N]"))
    matrix = get("stiffness_matrix") or []
    diagonal = [(f"stiffness, {words}", row[index]) for index, (row, words) in
                enumerate(zip(matrix, ("x [N/m]", "y [N/m]", "z [N/m]", "tilt in xz [N m/rad]", "tilt in yz [N m/rad]")))]
    rows = [(words, get(key)) for key, words in names if is_number(get(key))] + diagonal
    modes = [(one.get("kind"), one.get("frequency_Hz")) for one in report.records("modes")]
    return section("pair", "The pair under its preload", table(Table(("Quantity", "Value"), rows)) + table(Table(("Natural mode of the shaft", "Frequency [Hz]"), modes)))


def _bearings(report: Report) -> str:
    """Bearings and planets that carry unlike loads."""
    if _single(report):
        return ""
    point = read_point(report, operating_row(report).get("input_speed_rpm"))
    parts = []
    for kind, title, load, loads in (("bearing", "Bearing of a planet", "bearing_load", ()), ("planet", "Planet", "planet_bearing_load", ("planet_load_share",))):
        columns = point.get(load, *loads, *(f"{kind}_{life}" for life in ("L10h", "life")))
        if columns is None or any(column.ndim != 1 or len(column) < 2 for column in columns):
            continue
        lives = [point.values.get(f"{kind}_{life}") for life in ("L10h", "L10rh", "L10mh", "L10mrh", "life")]
        rows = [(index + 1, *(float(column[index]) for column in (columns[0], *columns[1:1 + len(loads)])), *(None if life is None else float(life[index]) for life in lives))
                for index in range(len(columns[0]))]
        head = (title, "Load [N]", *("Load / mean load" for _ in loads), *(f"{life} [h]" for life in LIVES))
        parts.append(table(Table(head, rows)))
    if not parts:
        return ""
    speed = format_number(operating_row(report).get("input_speed_rpm"))
    return section("unlike-bearings", "Bearings that carry unlike loads", f"<p>At {speed} rpm input speed.</p>" + "\n".join(parts))


def _damage(report: Report, most: Most) -> str:
    from orbearing.figures.load_spectrum import damage_columns, files_table, in_words, life_in_bin, of_set, skid_text, worst_key, worst_life

    spectrum = _spectrum(report)
    bins = records(spectrum.get("bins"))
    if not bins:
        return ""
    life, worst = spectrum.get("life_key") or "life_h", in_words(worst_key(spectrum))
    order = sorted(bins, key=lambda one: -(one.get("damage_share") or 0.0))
    rows = [(f"{one.get('bin')}", one.get("power_kW"), one.get("torque_N_m"), one.get("speed_rpm"), _percent(one.get("share")), life_in_bin(one, spectrum),
             *(_percent(one.get(name)) for name in damage_columns(worst).values())) for one in order[:most.bins]]
    head = ("Bin", "Power [kW]", "Torque [N m]", "Speed [rpm]", "Time [%]", f"{worst} [h]", *damage_columns(worst))
    left = f"<p>{len(order) - most.bins} more bins with less damage are in spectrum.csv.</p>" if len(order) > most.bins else ""
    hours = spectrum.get("hours")
    used = f" In {format_number(hours)} h the spectrum uses {format_number(100 * spectrum['used_up'])} % of the life." if is_number(hours) and is_number(spectrum.get("used_up")) else ""
    note = (f"<p>{len(bins)} bins, largest damage first. Torque and speed of the driving member. The governing life is {escape(life)} (life.method): "
            f"{worst}{of_set(spectrum)} {format_number(worst_life(spectrum))} h, {format_number(spectrum.get('system_' + life))} h for all bearings together.{used} {escape(skid_text(spectrum))}</p>")
    by_file, more = files_table(spectrum, most.bins), len(records(spectrum.get("files"))) - most.bins
    left += table(by_file) if by_file else ""
    left += f"<p>{more} more records with less damage are in --json.</p>" if more > 0 else ""
    return section("damage", "Load spectrum and damage by bin", note + table(Table(head, rows)) + left)


def _percent(share: object) -> float | None:
    return 100.0 * share if is_number(share) else None


def _influences(report: Report, most: Most) -> str:
    from orbearing.figures.load_spectrum import in_words

    found = report.record("influences")
    rows = records(found.get("inputs"))
    reasons = {row.get("key"): row for row in report.records("assumptions")}
    if not rows:
        in_time = "Not computed for a bearing in time; orbearing sensitivities --by INPUT gives the effect of a single input."
        why = str(found.get("problem") or ("No assumption has a number." if "influences" in report.content else in_time))
        return section("influences", "Assumptions by influence", f"<p>{escape(why)}</p>")
    result, unit = in_words(str(found.get("quantity"))), found.get("unit") or ""
    ordered = sorted((row for row in rows if not _is_stated(record(reasons.get(row.get("path")))) and row.get("path") != RELIABILITY), key=_influence, reverse=True)
    shown = [row for row in ordered if abs(_relative(row, found) or 0.0) >= LEAST_INFLUENCE]
    cells = [(row.get("path"), _short(record(reasons.get(row.get("path"))).get("value") or row.get("value")), f"{row.get('step')}", _signed(row.get("change"), unit),
              _signed(_relative(row, found)), record(reasons.get(row.get("path"))).get("reason")) for row in shown[:most.influences]]
    left = len(shown) - len(cells)
    note = (f"<p>Values that the source of the case does not give, ordered by their effect on {escape(str(result))} at the operating point, by the quasi-static model. "
            "The change is to first order.</p>")
    more = f"<p>{left} more assumed numbers have less effect.</p>" if left > 0 else ""
    varied = {row.get("path") for row in ordered}
    small = varied - {row.get("path") for row in shown}
    assumed = [row for row in report.records("assumptions") if not _is_stated(row)]
    for words, those in ((f"Assumed values with an effect on {result} below {LEAST_INFLUENCE:g} %", [row for row in assumed if row.get("key") in small]),
                         ("Assumed choices, and values that were not varied", [row for row in assumed if row.get("key") not in varied])):
        if those:
            names = "; ".join(f"{row.get('key')}: {_short(row.get('value'))}" for row in those)
            more += f"<p class=\"compact\">{escape(words)}: {escape(names)}.</p>"
    head = ("Assumption", "Value", "Step", f"Change of {result}", "Change [%]", "Reason")
    return section("influences", "Assumptions by influence", note + table(Table(head, cells)) + more)


def _is_stated(assumption: dict) -> bool:
    """A power that follows from the torque of the case."""
    return str(assumption.get("reason") or "").startswith("input.torque")


MOST_LETTERS = 60  # of a list in the table of what is given


def _shorter(value: object) -> str:
    """The same, of a long list its beginning."""
    text = _short(value)
    return text if len(text) <= MOST_LETTERS or not text.startswith("[") else text[:MOST_LETTERS].rsplit(",", 1)[0] + ", …"


def _short(value: object) -> str:
    """A value with its unit, its numbers to six digits."""
    return re.sub(r"-?\d+\.\d{5,}(?:e[-+]?\d+)?", lambda found: f"{float(found.group()):.6g}", str(value))


def _relative(row: dict, found: dict) -> float | None:
    whole = found.get(found.get("quantity"))
    return 100.0 * row["change"] / whole if is_number(row.get("change")) and is_number(whole) and whole else None


def _influence(row: dict) -> float:
    return abs(row["change"]) if is_number(row.get("change")) else 0.0


def _signed(value: object, unit: str = "") -> str:
    if not is_number(value):
        return " "
    return ("+" if value > 0 else "") + format_number(value, 4) + (f" {unit}" if unit else "")


def _warnings(report: Report) -> str:
    value = report.content.get("warnings")
    texts = value if isinstance(value, list) else []
    body = "<ul>" + "\n".join(f"<li>{escape(str(text))}</li>" for text in texts) + "</ul>" if texts else "<p>None.</p>"
    return section("warnings", "Warnings", body)


def _versions(report: Report) -> str:
    rows = [(key, "–" if value is None else str(value)) for key, value in sorted(report.record("versions").items())]
    return section("versions", "Versions", table(Table(("Part", "Version"), rows)) if rows else "<p>Not recorded.</p>")


def _single(report: Report) -> bool:
    """Whether the content is what a run of one bearing printed."""
    return "points" not in report.content


def _is_pair(report: Report) -> bool:
    return "system_L10r_Mrev" in report.content


def _has_balls(report: Report) -> bool:
    return _is_pair(report) or str(report.content.get("model") or "").startswith("ball")


def _spectrum(report: Report) -> dict:
    from orbearing.figures.load_spectrum import spectrum_of

    return spectrum_of(report)
