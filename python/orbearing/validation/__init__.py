"""The validation guide: published values beside ours, by quantity and kind of evidence.

    rows = validation.read(["rows.json"])       # what `orbearing validate --json` prints, of one or more calls
    validation.write_guide(rows, "guide")       # guide/index.md with its pictures
"""

from orbearing.validation.guide import write_guide
from orbearing.validation.rows import KINDS, Row, calibration, changed_verdicts, distinct, once_a_bearing, read, statistics

__all__ = ["KINDS", "Row", "calibration", "changed_verdicts", "distinct", "once_a_bearing", "read", "statistics", "write_guide"]
