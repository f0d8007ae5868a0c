#!/usr/bin/env python3
"""The validation guide of made-up rows is as recorded: statistics, tables, pictures, files, changed verdicts.

`--record` writes records/validation.json.xz anew. Exit code 77 (skipped) where matplotlib or numpy is missing.
"""

import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest.mock
from dataclasses import asdict, replace

try:
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "interface")]

import kept_records  # noqa: E402
import whole_drawing  # noqa: E402
from orbearing import style  # noqa: E402
from orbearing.validation import guide, record, rows as of_rows  # noqa: E402
from orbearing.validation.__main__ import main  # noqa: E402
from orbearing.validation.pictures import scatter  # noqa: E402
from orbearing.validation.rows import Row  # noqa: E402

RECORDS = kept_records.Records("validation")
CLASSES = ("friction", "friction and heat", "slip", "contact load", "load sharing", "stiffness", "natural frequency", "characteristic frequency", "trend", "rating|life")


def made_rows():
    rng, found = np.random.default_rng(5), []
    for i in range(72):
        published = round(float(10.0 ** rng.uniform(-1, 1 if i % 3 else 3)), 4) * (-1 if i % 17 == 0 else 1)
        ours = None if i % 13 == 5 else published * round(float(rng.uniform(0.7, 1.3)), 4)
        width = abs(published) * round(float(rng.uniform(0.02, 0.3)), 4)
        band = {"low_90": published - 2 * width, "low_50": published - width, "high_50": published + 0.7 * width, "high_90": published + 1.6 * width, "samples": 9, "lost": 0} if i % 4 == 0 and ours else None
        if band and i % 8 == 0:
            band = {key: value + (2.2 * width if isinstance(value, float) else 0) for key, value in band.items()}
        kind = of_rows.KINDS[(i * 7) % 5 if i % 2 else 0]
        found.append(Row(case=f"case {i % 9}", source=f"[Src{i % 7}], Table {i % 3}" if i % 11 else f"no key {i}", kind=kind, of=CLASSES[i % 10], quantity=f"q{i}", meaning=f"meaning *{i}* | a<b", reading="" if i % 5 else f"b={i}, a=2",
                         published=None if i % 29 == 3 else published, ours=ours, tolerance=0.01 * (1 + i % 9), scatter=round(float(rng.uniform(0.005, 0.1)), 4) if i % 3 == 0 else None, band=band,
                         verdict=("reproduced", "missed", "trend", "input missing", "missed")[(i * 3) % 5], why=("", "a reason", "another\nreason")[i % 3], memory=i % 23 == 4, fitted=i % 16 == 8))
    return found


ROWS = made_rows()
REFERENCES = "| [Old" "1990] | A book, from memory |\n| [New" "2000] | A paper |\n| [Mem" "2001] | partly memory, a table |\n"


class Validation(kept_records.Recorded):
    records = RECORDS

    def test_statistics(self):
        few = ROWS[:1]
        found = {"each": [[row.counts, row.key, row.log_ratio, [str(one) for one in row.name]] for row in ROWS]}
        for name, rows in {"all": ROWS, "one": few, "none": [], **{kind: [row for row in ROWS if row.kind == kind] for kind in of_rows.KINDS}}.items():
            one = of_rows.statistics(rows)
            found[name] = [vars(one), one.of_model, vars(of_rows.calibration(rows))]
        found["distinct"] = [row.quantity for row in of_rows.distinct([*ROWS, replace(ROWS[6], case="other"), replace(ROWS[5], reading="a=2, b=5")])]
        found["once"] = [row.quantity for row in of_rows.once_a_bearing(ROWS)]
        changed = [replace(row, verdict="reproduced") if i % 9 == 1 else row for i, row in enumerate(ROWS[4:])]
        found["changed"] = of_rows.changed_verdicts(ROWS, changed)
        found["ends"] = [of_rows._ends(row, share, wide) for row in ROWS if row.band for share in (50, 90) for wide in (False, True)]
        self.check("statistics", found)

    def test_the_page(self):
        with style.context():
            text, pictures = guide.guide(ROWS, REFERENCES, "a_")
            bare, none = guide.guide([row for row in ROWS if row.memory or row.kind == "recomputed"], "")
        self.check("page", {"text": text.splitlines(), "names": list(pictures), "pictures": {name: whole_drawing.whole(figure) for name, figure in pictures.items()}, "bare": bare.splitlines(), "bare pictures": list(none)})
        self.check("words", [[guide.percent(value, sign) for value in (None, 0.0, 0.0004, 0.004, 0.04, 0.4, -0.04) for sign in (False, True)], guide.cell("a\\b|c*d<e\nf"), guide.slug("Friction & heat, (1)"), guide.misses([]), guide.calibration_text([]),
                             guide.from_memory(""), guide.most_missed([]), guide.verdict_counts({"missed": 3}), guide.table(("a", "b"), [(1, "x|")])])
        with style.context():
            self.check("empty picture", whole_drawing.whole(scatter("x", [replace(ROWS[0], ours=None)])))

    def test_files(self):
        found = {}
        with tempfile.TemporaryDirectory() as place:
            home = pathlib.Path(place)
            for name, rows in (("a", ROWS[:40]), ("b", ROWS[30:]), ("before", [replace(ROWS[0], verdict="x"), *ROWS[1:]])):
                record.write_record(rows, home / f"{name}.json")
            found["record"] = json.loads((home / "a.json").read_text(encoding="utf-8"))["rows"][::5]
            found["lines"] = len((home / "a.json").read_text(encoding="utf-8").splitlines())
            again = of_rows.read([home / "a.json", home / "b.json"])
            self.assertEqual([row.name for row in again], [row.name for row in ROWS])
            found["read"] = [{key: value for key, value in asdict(row).items()} for row in again[::9]]
            (home / "references.md").write_text(REFERENCES, encoding="utf-8")
            saved = []
            with unittest.mock.patch("matplotlib.figure.Figure.savefig", lambda figure, file, **more: saved.append([pathlib.Path(file).name, more])):
                for words in (["--against", f"{place}/before.json", "--record", f"{place}/all.json", "--references", f"{place}/references.md"], []):
                    printed, said = io.StringIO(), io.StringIO()
                    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(said):
                        code = main([f"{place}/a.json", f"{place}/b.json", "-o", f"{place}/out/guide", *words])
                    text = (home / "out" / "guide" / "index.md").read_text(encoding="utf-8")
                    found[f"command {len(words)}"] = [code, printed.getvalue().replace(place, "DIR"), said.getvalue().splitlines(), text.splitlines()[:6], text.splitlines()[-6:]]
            found["saved"] = saved
            found["whole record"] = len(of_rows.read([home / "all.json"]))
        self.check("files", found)


if __name__ == "__main__":
    kept_records.main(RECORDS)
