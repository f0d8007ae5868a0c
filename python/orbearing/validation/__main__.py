"""The validation guide from rows: python3 -m orbearing.validation ROWS.json... -o DIR [--references REFERENCES.md] [--record FILE] [--readme FILE]

--record writes the rows of all files as one, with numbers to 9 digits: what the tests and the documentation site read.
--readme puts the numbers of the rows into the table of that README.md.
--against compares with such a file and tells every change of a verdict.
Exit code: 0 done, 1 a verdict is another one.
"""

from __future__ import annotations

import sys
from pathlib import Path

from orbearing.terminal import Parser, finished
from orbearing.validation.guide import write_guide
from orbearing.validation.readme import update
from orbearing.validation.record import write_record
from orbearing.validation.rows import changed_verdicts, read


def main(arguments: list[str]) -> int:
    parser = Parser(prog="python3 -m orbearing.validation", description=__doc__.splitlines()[0])
    parser.add_argument("rows", nargs="+", metavar="ROWS.json")
    parser.add_argument("-o", "--output", required=True, metavar="DIR")
    parser.add_argument("--references", metavar="FILE")
    parser.add_argument("--record", metavar="FILE")
    parser.add_argument("--against", metavar="FILE")
    parser.add_argument("--readme", metavar="FILE")
    given = parser.parse_args(arguments)
    rows = read(given.rows)
    references = Path(given.references).read_text(encoding="utf-8") if given.references else ""
    print(write_guide(rows, given.output, references))
    if given.record:
        write_record(rows, given.record)
    if given.readme:
        update(given.readme, rows)
    changes = changed_verdicts(read([given.against]), rows) if given.against else []
    for line in changes:
        print(line, file=sys.stderr)
    return 1 if changes else 0


if __name__ == "__main__":
    sys.exit(finished(lambda: main(sys.argv[1:])))
