"""Single-line errors of the kinds that people make, and which of them a seed draws from the sources of a subject."""

import dataclasses
import hashlib
import pathlib
import re
from collections.abc import Callable, Iterator

FOLDERS = ("bearing", "gearset", "coupling", "mechanics")
# Interfaces of the FMUs, tables of data sheets, arguments that are refused, messages: no physics.
NO_PHYSICS = re.compile(r"^coupling/fmu/|(^|/)\w*(checks|message|warning|remarks|described|instruction_set)\.[ch]pp$")
# Lines that compute nothing: preprocessor, declarations, checks and messages; and how exactly is searched, which moves no result.
IDLE_BEGIN = ("#", "*", "namespace", "using", "template", "static_assert", "require", "friend", "struct", "class", "if constexpr")
IDLE = re.compile(r'"|\bthrow\b|\bassert\b|\brequire|operator|[Tt]oleran|[Ee]psilon|[Ii]teration|reserve|#')
LEAST_LINES_BETWEEN = 4  # of two errors of one file, which stand in it together
NOT_DECLARED = r"(?<!double )(?<!auto )(?<!int )(?<![&>] )"  # a name that is only given another is the same program
TERM = r"[A-Za-z_][\w:.]*(?:\([^()]*\))?"


def larger_by_tenth(match: re.Match) -> str:
    return repr(round(float(match.group()) * 1.1, 12)) if float(match.group()) >= 1e-4 else match.group()


# Kind of the error, what stands in the line, what a slip of the pen makes of it.
KINDS = (
    ("sign of a term", r"(?:(?<=[=(,] )|(?<=[(\[])|(?<=return ))-(?=[A-Za-z_(])", ""),
    ("plus for minus", r" \+ (?=[A-Za-z0-9_(])", " - "),
    ("plus for minus", r" - (?=[A-Za-z0-9_(])", " + "),
    ("plus for minus", r" \+= ", " -= "),
    ("plus for minus", r" -= ", " += "),
    ("times for divided by", r"(?<=[\w)\]]) \* (?=[A-Za-z0-9_(])", " / "),
    ("times for divided by", r"(?<=[\w)\]]) / (?=[A-Za-z0-9_(])", " * "),
    ("factor of two left out", r"(?<![\w.])(?:2\.0|0\.5) \* ", ""),
    ("factor of two left out", r" / 2\.0(?![\d.e])", ""),
    ("factor of two too many", r"(?<=[\w)\]]) \* (?=[A-Za-z_(])", " * 2.0 * "),
    ("factor of two too many", r"(?<=[\w)\]]) / (?=[A-Za-z_(])", " / 2.0 / "),
    ("sine and cosine", r"\bcos\(", "sin("),
    ("sine and cosine", r"\bsin\(", "cos("),
    ("exponent", r"(?:std::)?\bsqrt\(", "("),
    ("exponent", r"(?<!\.)(?:mechanics::)?\bsquare\(", "("),
    ("exponent", r"\.square\(\)", ""),
    ("exponent", r"(?<!\.)\bcube\(", "square("),
    ("exponent", r"\bpow\(([^(),]+), (\d)\)", lambda match: f"pow({match[1]}, {int(match[2]) + 1})"),
    ("exponent", r"\bpow\(([^(),]+), (\d\.\d+)\)", lambda match: f"pow({match[1]}, {match[2]} + 1.0)"),
    ("exponent", r"10\.0 / 9\.0", "9.0 / 10.0"),
    ("less and greater", r" < (?=[A-Za-z0-9_(-])", " > "),
    ("less and greater", r" > (?=[A-Za-z0-9_(-])", " < "),
    ("less and greater", r" <= (?=[A-Za-z0-9_(-])", " >= "),
    ("less and greater", r" >= (?=[A-Za-z0-9_(-])", " <= "),
    ("smallest and largest", r"\bmax\(", "min("),
    ("smallest and largest", r"\bmin\(", "max("),
    ("smallest and largest", r"\blarger\(", "smaller("),
    ("smallest and largest", r"\bsmaller\(", "larger("),
    ("smallest and largest", r"\bmaxCoeff\(", "minCoeff("),
    ("smallest and largest", r"\bminCoeff\(", "maxCoeff("),
    ("index off by one", r"(?<=[\w)]) [+-] 1(?![\w.])", ""),
    ("index off by one", r"(?<= = )0(?=; [\w.]+ (?:<|!=) )", "1"),
    ("term left out", rf" [+-] {TERM}(?: [*/] {TERM})*(?=[;,)])", ""),
    ("constant wrong by 10 %", r"(?<![\w.])\d+\.\d+(?:e-?\d+)?(?![\w.])", larger_by_tenth),
    ("inner and outer", rf"{NOT_DECLARED}\b(?:(\w+_)|Race::|\.)?inner(_\w+)?\b(?!\()", lambda match: match[0].replace("inner", "outer")),
    ("inner and outer", rf"{NOT_DECLARED}\b(?:(\w+_)|Race::|\.)?outer(_\w+)?\b(?!\()", lambda match: match[0].replace("outer", "inner")),
    ("and, or, not", r" && ", " || "),
    ("and, or, not", r" \|\| ", " && "),
    ("and, or, not", r"(?<=[( ])!(?=[A-Za-z_(])", ""),
    ("radius and diameter", rf"{NOT_DECLARED}\b\w+_diameter\b", lambda match: match[0].replace("diameter", "radius")),
    ("radius and diameter", rf"{NOT_DECLARED}\b\w+_radius\b", lambda match: match[0].replace("radius", "diameter")),
    ("other direction", r"\.x\(\)", ".y()"),
    ("other direction", r"\.y\(\)", ".x()"),
    ("sun and ring", rf"{NOT_DECLARED}\bsun_mesh\b", "ring_mesh"),
    ("sun and ring", rf"{NOT_DECLARED}\bring_mesh\b", "sun_mesh"),
    ("sum and mean", r"\.mean\(\)", ".sum()"),
    ("sum and mean", r"\.sum\(\)", ".mean()"),
)


@dataclasses.dataclass(frozen=True)
class Mutant:
    """One error. `begin` and `end` bound what is replaced by `fresh` in the line, from its first character."""
    kind: str
    file: str
    line: int
    begin: int
    end: int
    before: str
    after: str
    fresh: str
    repeated: int  # how often the same error stood in the same words before it in the file

    @property
    def key(self) -> str:
        """What it is, wherever its line has moved to."""
        return hashlib.sha256("\n".join((self.kind, self.file, self.before, self.after, str(self.repeated))).encode()).hexdigest()[:16]


@dataclasses.dataclass(frozen=True)
class Subject:
    """What a draw is taken from. `kinds` by the end of a file's name; errors of the same group share its turns in the draw."""
    name: str
    folders: tuple[str, ...]
    left_out: re.Pattern  # files
    kinds: dict[str, tuple]
    groups: dict[str, str]
    lines: Callable[[str, str], list[tuple[str, str]]]  # of a file's name and text: each line, and what its kinds are looked for in
    fits: Callable[["Mutant", str], bool] = lambda mutant, text: True  # whether an error can be a program; its file's text

    def sources(self, root: pathlib.Path) -> list[str]:
        """Its files, as paths from the root."""
        names = [path.relative_to(root).as_posix() for folder in self.folders for path in sorted((root / folder).rglob("*"))
                 if path.suffix in self.kinds and path.is_file()]
        return [name for name in names if not self.left_out.search(name)]

    def mutants_of(self, name: str, text: str) -> list[Mutant]:
        """All errors that one file can have."""
        found, seen = [], {}
        kinds = [(kind, re.compile(pattern).finditer, fresh, where) for kind, pattern, fresh, *where in self.kinds[pathlib.PurePosixPath(name).suffix]]
        for number, (bare, searched) in enumerate(self.lines(name, text)):
            if not bare:
                continue
            for kind, matches, fresh, where in kinds:
                for match in matches(bare if where else searched):
                    if where and not where[0](match, searched):
                        continue
                    made = fresh(match) if callable(fresh) else match.expand(fresh)
                    for written in made if isinstance(made, tuple) else (made,):
                        after = (bare[:match.start()] + written + bare[match.end():]).strip()
                        if after == bare.strip() or IN_TEXT in written:
                            continue
                        same = (kind, bare.strip(), after)
                        seen[same] = seen.get(same, -1) + 1
                        mutant = Mutant(kind, name, number + 1, match.start(), match.end(), bare.strip(), after, written, seen[same])
                        if self.fits(mutant, text):
                            found.append(mutant)
        return found

    def draw(self, texts: dict[str, str], seed: int) -> Iterator[Mutant]:
        """All errors in the order of the draw: each kind of each group as often as the others, whatever its number of places.

        The rank of an error is a hash of the seed and of itself, so that a change elsewhere leaves the rest of the draw as it is.
        """
        by_kind: dict[str, list[Mutant]] = {self.groups[suffix] + kind: [] for suffix, kinds in self.kinds.items() for kind, *_ in kinds}
        for name, text in texts.items():
            for mutant in self.mutants_of(name, text):
                by_kind[self.groups[pathlib.PurePosixPath(name).suffix] + mutant.kind].append(mutant)

        def rank(words: str) -> str:
            return hashlib.sha256(f"{seed}\n{words}".encode()).hexdigest()

        for group in by_kind.values():
            group.sort(key=lambda mutant: rank(mutant.key), reverse=True)
        taken: dict[str, list[int]] = {}
        kinds = sorted(by_kind, key=rank)
        while any(by_kind.values()):
            for kind in kinds:
                while by_kind[kind]:
                    mutant = by_kind[kind].pop()
                    lines = taken.setdefault(mutant.file, [])
                    if all(abs(mutant.line - line) >= LEAST_LINES_BETWEEN for line in lines):
                        lines.append(mutant.line)
                        yield mutant
                        break


def code_of(line: str) -> str:
    """The line without its comment; empty where it states no physics."""
    bare = line.split("//")[0].rstrip()
    return "" if bare.lstrip().startswith(IDLE_BEGIN) or IDLE.search(bare) else bare


def _lines_of_physics(_: str, text: str) -> list[tuple[str, str]]:
    return [(code_of(line),) * 2 for line in text.splitlines()]


IN_TEXT = "\x01"  # stands for each letter of a text in what kinds of code are looked for in
PHYSICS = Subject("physics", FOLDERS, NO_PHYSICS, {".cpp": KINDS, ".hpp": KINDS}, {".cpp": "", ".hpp": ""}, _lines_of_physics)
