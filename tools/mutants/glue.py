"""Errors in what stands between the physics and the reader: columns, keys, units, labels, conditions, figures."""

import ast
import io
import re
import tokenize

from .draw import IN_TEXT, KINDS, NOT_DECLARED, Mutant, Subject

# Lines without a result: preprocessor, declarations, what is refused.
IDLE_BEGIN = ("#", "*", "/*", "///", "namespace", "using", "template", "static_assert", "friend", "struct", "class", "if constexpr",
              "import", "from", "@", "def", "__all__")
IDLE = re.compile(r"\bassert\b|operator|reserve\(|figsize|fontsize|zorder")
# In the physics the sources compute; here the slips are those below. How much a picture's margin is moves no result.
OF_PHYSICS = {"sign of a term", "plus for minus", "times for divided by", "factor of two left out", "less and greater", "smallest and largest",
              "index off by one", "inner and outer", "and, or, not", "radius and diameter", "other direction", "sun and ring", "sum and mean"}
WORDS = r"rpm|rad/s|MPa|kHz|Hz|mrad|deg|µm|um|mm|nm/N|N/µm|N m|kW|ms|m/s²|m/s|%|h|N|W"
UNITS = {"rpm": "rad/s", "rad/s": "rpm", "MPa": "GPa", "kHz": "Hz", "Hz": "kHz", "mrad": "deg", "deg": "rad", "µm": "mm", "um": "mm", "mm": "µm",
         "nm/N": "µm/N", "N/µm": "N/m", "N m": "N mm", "kW": "W", "ms": "s", "m/s²": "mm/s²", "m/s": "mm/s", "%": "‰", "h": "s", "N": "kN", "W": "kW"}
PAIRS = (("x", "y"), ("mean", "max"), ("max", "min"), ("rms", "max"), ("stiffness", "damping"), ("force", "moment"), ("first", "second"),
         ("low", "high"), ("lower", "upper"), ("front", "back"), ("radial", "axial"), ("tangential", "radial"), ("share", "damage"),
         ("quasi_static", "dynamic"), ("basic", "modified"), ("start", "end"), ("life", "load"), ("speed", "torque"), ("time", "angle"))


def in_text(match: re.Match, searched: str) -> bool:
    """Whether the place is within a text, not in the code around it."""
    return searched[match.start()] == IN_TEXT


def next_key(match: re.Match) -> str:
    """The next other key of the line in its place."""
    keys = re.findall(r'"(\w+)"', match.string)
    after = keys[sum(one.start() < match.start() for one in re.finditer(r'"\w+"', match.string)):]
    return '"' + next((key for key in [*after[1:], *keys] if key != match[1]), match[1]) + '"'


def others(match: re.Match) -> tuple[str, ...]:
    return tuple(dict.fromkeys(pair[pair[0] == match[0]] for pair in PAIRS if match[0] in pair))


def any_place(match: re.Match, searched: str) -> bool:
    """A member, or a part of a key; not a word of a sentence."""
    if searched[match.start()] != IN_TEXT:
        return match.start() > 0 and match.string[match.start() - 1] in "._>"
    begin, end = match.string.rfind('"', 0, match.start()), match.string.find('"', match.end())
    return begin >= 0 and re.fullmatch(r"[A-Za-z0-9_.]+", match.string[begin + 1:end]) is not None


def in_key(match: re.Match, searched: str) -> bool:
    return searched[match.start()] == IN_TEXT and any_place(match, searched)


def in_key_or_code(match: re.Match, searched: str) -> bool:
    return searched[match.start()] != IN_TEXT or any_place(match, searched)


SCALES = r"k(?:Rpm|RadiansPerSecond|Degree|Kilo|Milli|Micro|Mega|Micrometres|Million|Millimetre)|rpm_per_rad_s|million_revolutions" \
         r"|micrometres|microseconds|megapascals|MICRO|RAD_PER_S"
COMMON = (
    ("unit factor", rf"{NOT_DECLARED}(?<![\w.])(?:{SCALES})\b(?! =)", "1.0"),
    ("unit factor", r"(?<![\w.])1e-?\d+(?= [*/])|(?<=[*/] )1e-?\d+(?![\w.])", "1.0"),
    ("unit factor", r"(?<![\w.])(?:60|100|1000|3600)(?:\.0)?(?= [*/])|(?<=[*/] )(?:60|100|1000|3600)(?:\.0)?(?![\w.])", "1.0"),
    ("other key", r'"(\w+)"', next_key, lambda match, _: True),
    ("label or unit", rf"(?<=\()(?:{WORDS})(?=\))|(?<=\[)(?:{WORDS})(?=\])|(?<=[ }}])(?:{WORDS})(?=[\" ,;.:)])", lambda match: UNITS[match[0]], in_text),
    ("label or unit", r"\b5 (to|and) 95\b", r"25 \1 75", in_text),
    ("label or unit", r"\b25 (to|and) 75\b", r"5 \1 95", in_text),
    ("negated condition", r" == ", " != "),
    ("negated condition", r" != ", " == "),
    ("member swapped", rf"{NOT_DECLARED}(?<![A-Za-z0-9])(?:{'|'.join(sorted({name for pair in PAIRS for name in pair}))})(?![A-Za-z0-9(=]| =)", others,
     any_place),
)
CPP = tuple((row[0], r'(?<!")(?<!text)' + row[1] if row[0] == "plus for minus" else row[1], *row[2:])  # texts are put together by a plus
            for row in KINDS if row[0] in OF_PHYSICS) + COMMON + (
    ("negated condition", r"\bif \((?!!)([^;]*)\)(?= (?:\{$|return|continue|break|throw)|$)", r"if (!(\1))"),
    ("negated condition", r"(?<=[=(,] )([\w.>()-]+) \? ", r"!(\1) ? "),
    ("smallest and largest", r"\bmin_element\(", "max_element("),
    ("smallest and largest", r"\bmax_element\(", "min_element("),
    ("index off by one", r"\[0\]", "[1]"),
    ("index off by one", r"\[1\]", "[0]"),
    ("inner and outer", r"inner", "outer", in_key),
    ("inner and outer", r"outer", "inner", in_key),
)
PYTHON = COMMON + (
    ("plus for minus", r"(?<!\") \+ (?=[A-Za-z0-9_(])", " - "),
    ("plus for minus", r" - (?=[A-Za-z0-9_(])", " + "),
    ("times for divided by", r"(?<=[\w)\]]) \* (?=[A-Za-z0-9_(])", " / "),
    ("times for divided by", r"(?<=[\w)\]]) / (?=[A-Za-z0-9_(])", " * "),
    ("unit factor", r"\b(?:np|numpy)\.(?:degrees|radians)\(", "("),
    ("less and greater", r" (<|>)(=?) ", lambda match: f" {'>' if match[1] == '<' else '<'}{match[2]} "),
    ("smallest and largest", r"\b(nan|arg|nanarg|f)?(max|min)\(", lambda match: (match[1] or "") + ("min(" if match[2] == "max" else "max(")),
    ("index off by one", r"(?<=[\w)]) [+-] 1(?![\w.])", ""),
    ("index off by one", r"\[0\]", "[1]"),
    ("index off by one", r"\[1\]", "[0]"),
    ("index off by one", r"\[-1\]", "[-2]"),
    ("index off by one", r"\[1:", "[0:"),
    ("index off by one", r":-1\]", ":]"),
    ("inner and outer", r"inner", "outer", in_key_or_code),
    ("inner and outer", r"outer", "inner", in_key_or_code),
    ("and, or, not", r" and ", " or "),
    ("and, or, not", r" or ", " and "),
    ("and, or, not", r"\bnot (?!in\b)", ""),
    ("and, or, not", r" && ", " || "),
    ("and, or, not", r" \|\| ", " && "),
    ("negated condition", r"\bif (?!not )(.+?)(?=:$| else )", r"if not (\1)"),
    ("negated condition", r" is not None", " is None"),
    ("negated condition", r" is None", " is not None"),
    ("negated condition", r"(?<=\) )\? ", "? !"),
    ("sum and mean", r"\b(nan)?(mean|sum)\(", lambda match: (match[1] or "") + ("sum(" if match[2] == "mean" else "mean(")),
    ("sorted the other way", r", reverse=True", ""),
    ("sorted the other way", r"\bargsort\((?=[a-z])", "argsort(-"),
    ("sorted the other way", r"\bargsort\(-", "argsort("),
)


def masked(line: str, quotes: str, formatted: bool) -> str:
    """The line with the letters of its texts hidden; what a formatted text computes in braces stays."""
    def hidden(match: re.Match) -> str:
        inside = match[2]
        if formatted and match.string[max(0, match.start() - 1)] in "fF" and match.start() > 0:
            parts = re.split(r"(\{[^{}]*\})", inside)
            inside = "".join(part if index % 2 else IN_TEXT * len(part) for index, part in enumerate(parts))
        else:
            inside = IN_TEXT * len(inside)
        return match[1] + inside + match[1]

    return re.sub(rf"([{quotes}])((?:\\.|(?!\1)[^\\])*)\1", hidden, line)


def _shown(bare: str, searched: str) -> tuple[str, str]:
    idle = bare.lstrip().startswith(IDLE_BEGIN) or IDLE.search(searched)
    return ("", "") if idle else (bare, searched)


def _cpp_lines(text: str) -> list[tuple[str, str]]:
    found, raw = [], False
    for line in text.splitlines():
        if raw or 'R"(' in line:
            raw = ')"' not in line.split('R"(')[-1]
            found.append(("", ""))
            continue
        searched = masked(line, '"\'`', False)
        comment = searched.find("//")
        bare = (line if comment < 0 else line[:comment]).rstrip()
        found.append(_shown(bare, searched[:len(bare)]))
    return found


def _python_lines(text: str) -> list[tuple[str, str]]:
    lines = text.splitlines()
    searched = [masked(line, '"\'', True) for line in lines]
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        (first, begin), (last, end) = token.start, token.end
        if token.type == tokenize.COMMENT:
            lines[first - 1] = lines[first - 1][:begin].rstrip()
            searched[first - 1] = searched[first - 1][:len(lines[first - 1])]
        elif token.type == tokenize.STRING and first != last:  # a text of several lines
            for number in range(first - 1, last):
                lines[number] = searched[number] = ""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            for number in range(node.lineno - 1, node.end_lineno):
                lines[number] = searched[number] = ""
    return [_shown(bare, shown) for bare, shown in zip(lines, searched)]


def lines_of(name: str, text: str) -> list[tuple[str, str]]:
    """Each line without its comment, and the same with the letters of its texts hidden; empty where it holds no result."""
    return _python_lines(text) if name.endswith(".py") else _cpp_lines(text)


def is_program(mutant: Mutant, text: str) -> bool:
    """Whether it can be one: a member that is put in another's place stands somewhere in its file."""
    if mutant.kind not in ("member swapped", "inner and outer"):
        return True
    line = text.splitlines()[mutant.line - 1]
    line = line[:mutant.begin] + mutant.fresh + line[mutant.end:]
    word = next(one for one in re.finditer(r"\w+", line) if one.start() < mutant.begin + len(mutant.fresh) <= one.end())
    return re.search(rf"\b{word[0]}\b", text) is not None


GLUE = Subject("glue and figures", ("coupling/analysis", "coupling/system", "app", "page", "python/orbearing"), re.compile(r"app/case/schema\.cpp$"),
               {".cpp": CPP, ".hpp": CPP, ".py": PYTHON, ".js": PYTHON}, {".cpp": "", ".hpp": "", ".py": "python: ", ".js": "python: "}, lines_of, is_program)
