"""What is known of each error of a draw, kept in a file, and the table of those that count."""

import json
import pathlib
from collections.abc import Callable

from .draw import Mutant
from .trial import PROOFS

REDRAWN = ("no program", "same program", "equivalent")  # the next of the draw takes their place


class Results:
    """`listed`: keys of errors that are the same program in other words; `sources`: what an error's folder of sources looks like, by error."""

    def __init__(self, path: pathlib.Path, order: list[Mutant], count: int, listed: set[str], sources: Callable[[Mutant], str], tests: str):
        self.path, self.order, self.count, self.listed = path, order, count, listed
        self.sources, self.tests = sources, tests
        self.known = json.loads(path.read_text()) if path.exists() else {}

    def of(self, number: int) -> dict | None:
        """What was found is known while the sources stay, what survived while the tests stay, too."""
        if self.order[number].key in self.listed:
            return {"found by": "equivalent", "test": "", "seconds": 0.0}
        entry = self.known.get(self.order[number].key)
        if entry is None or entry["sources"] != self.sources(self.order[number]) or (entry["found by"] == "none" and entry["tests"] != self.tests):
            return None
        return entry

    def add(self, number: int, kind: str, test: str, seconds: float) -> None:
        self.known[self.order[number].key] = {"sources": self.sources(self.order[number]), "tests": self.tests, "found by": kind, "test": test,
                                              "seconds": round(seconds, 1)}
        aside = self.path.with_suffix(".new")
        aside.write_text(json.dumps(self.known, indent=1))
        aside.replace(self.path)

    def counting(self) -> list[int]:
        """Numbers of the first `count` errors that are programs of their own, as far as is known."""
        numbers = [number for number in range(len(self.order)) if (self.of(number) or {"found by": ""})["found by"] not in REDRAWN]
        return numbers[:self.count]

    def pending(self) -> list[int]:
        return [number for number in self.counting() if self.of(number) is None]

    def table(self) -> dict:
        """The errors that count, with the test that finds each, and the tally."""
        numbers = self.counting()
        not_asked = {"found by": "not asked", "test": "", "seconds": 0.0}
        rows = []
        for number in numbers:
            mutant, entry = self.order[number], self.of(number) or not_asked
            rows.append({"number": number, "file": mutant.file, "line": mutant.line, "kind": mutant.kind, "before": mutant.before,
                         "after": mutant.after} | {key: entry[key] for key in not_asked})
        asked = [row["found by"] for row in rows if row["found by"] != "not asked"]
        until = numbers[-1] if numbers else -1
        redrawn = [self.of(number)["found by"] for number in range(until) if number not in numbers]
        tally = {"drawn": len(rows), "asked": len(asked), "found": len(asked) - asked.count("none"),
                 "found by unit, identities or literature": sum(kind in PROOFS for kind in asked),
                 "found by regression only": asked.count("regression"),
                 "found by the program from outside only": asked.count("interface"),
                 "surviving": asked.count("none"),
                 "drawn anew, does not compile": redrawn.count("no program"),
                 "drawn anew, same object code": redrawn.count("same program"),
                 "drawn anew, listed as equivalent": redrawn.count("equivalent")}
        return {"tally": tally, "errors": rows}
