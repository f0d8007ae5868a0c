"""Rows as they are kept from one version to the next: a line each, so that a change shows in a comparison of versions."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from orbearing.validation.rows import Row

DIGITS = 6  # of our numbers; verdicts are compared, not digits


def _rounded(value):
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}")
    if isinstance(value, dict):
        return {key: _rounded(one) for key, one in value.items()}
    return value


def write_record(rows: Sequence[Row], file) -> None:
    lines = []
    for row in rows:
        one = asdict(row)
        one["evidence"] = one.pop("kind")
        for name in ("ours", "band"):
            one[name] = _rounded(one[name])
        lines.append(json.dumps(one, ensure_ascii=False))
    Path(file).write_text('{"rows": [\n' + ",\n".join(lines) + "\n]}\n", encoding="utf-8")
