#!/usr/bin/env python3
"""Every warning, refusal and error message is provoked by a test that asserts all of its text and numbers.

The id of a message is the file that makes it and its words, as in
'app/study/sweep_warnings.cpp: contact: pressure above'; words are what stands between its numbers and names. This test
draws all ids from the sources, but for those of a std::logic_error, and fails for one whose words stand in no answer that a test expects:

  tests/interface/messages/*.txt    commands and all that they answer, run here; several in one block share a folder
  tests/interface/messages/*.pytxt  the same of the Python package (doctest), all in one process
  tests/messages.txt                what C++ tests expect of calls that no command makes: EXPECT_REFUSED(Error, "id", call)

messages/not_yet.list holds the ids that nothing provokes yet, under the reason for which they stand there: it may only
shrink.
`messages.py --record FILE...` writes the present answers into files of commands; read each before you commit it.
"""

import ast
import concurrent.futures
import contextlib
import doctest
import importlib.util
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
HERE = SOURCE / "tests" / "interface" / "messages"
SECONDS = int(os.environ.get("LIMIT", "300"))  # this stops a hang
MOST_NOT_YET = 90
HAS_NETCDF = importlib.util.find_spec("netCDF4") is not None

CPP = re.compile(r"""//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|[A-Za-z_]\w*|\d[\w.']*|->|\S""", re.S)
REFUSING = {"refuse", "require", "require_positive", "require_not_negative", "add_error_at", "problem", "fail", "warn"}
CHECKS = {"refuse", "require", "require_positive", "require_not_negative"}
SHORTEST = 12  # letters of a piece of text by which a message is known
COLLECTING = re.compile(r"warning|mistake|problem|validation_error|list$|texts$|noted$|missing$", re.I)
# Words of a text that is composed before it is thrown or listed.
SPOKEN = re.compile(r"\brequired\b|\bfound\b|\bcannot be\b|\bno static equilibrium\b|\bno longer\b|\bnot finite\b|\bhas no effect\b"
                    r"|\bleft the bearing\b|\bdrifted\b|\bit is not\b|\bits unit\b|\bits value\b|\bis out of range\b|\bis none of\b")
UNSPOKEN_FILES = re.compile(r"_fields\.(cpp|hpp)$|_output\.cpp$|/schema\.cpp$|/export/|/sweep_row\.cpp$|^app/commands/\w+\.hpp$|^python/")
RECORDED = {"value", "array", "series", "table", "child", "nothing"}  # of a record of results: what a value means
NO_MESSAGES = {"app/study/effects.cpp"}  # its lists are of names


def cpp_tokens(text):
    """Words and whole string literals, adjacent ones joined."""
    tokens = []
    for match in CPP.finditer(text):
        word = match.group()
        if word.startswith(("//", "/*")):
            continue
        if word[0] == '"' and tokens and tokens[-1][0] == '"':
            tokens[-1] = tokens[-1][:-1] + word[1:]
        else:
            tokens.append(word)
    return tokens


def end_of(tokens, start, statement=False):
    """Behind the bracket that closes the one at `start`, or behind the statement."""
    depth = 0
    for i in range(start, len(tokens)):
        if tokens[i] in "([{":
            depth += 1
        elif tokens[i] in ")]}":
            depth -= 1
            if depth == 0 and not statement:
                return i + 1
        elif tokens[i] == ";" and depth == 0 and statement:
            return i
    return len(tokens)


def literal(token):
    return token[1:-1].replace('\\"', '"').replace("\\u00b5", "µ")


def words_of(text):
    """What stands between the numbers and names of a text: pieces of two words or more."""
    pieces = re.split(r"\{\{|\}\}|\{[^{}\s]*\}|\\n|%[.\d]*[a-z]\b(?! )", text)
    stripped = [piece.strip() for piece in pieces]
    return [piece for piece in stripped if len(piece) >= SHORTEST and re.search(r"[A-Za-z]\S* +\S*[A-Za-z]", piece)]


def arguments_of(tokens):
    """Of a call: the text of each argument that is one literal and nothing else, None for another."""
    arguments, depth, part = [], 0, []
    for token in tokens:
        depth += (token in "([{") - (token in ")]}")
        if depth == 1 and token in "(,":
            arguments.append(part)
            part = []
        elif depth:
            part.append(token)
    arguments.append(part)
    return [literal(part[0]) if len(part) == 1 and part[0][0] == '"' else None for part in arguments[1:]]


FINITE = {"require_positive": "a finite number greater than 0", "require_not_negative": "a finite number of at least 0"}


def checked_argument(word, tokens):
    """'what: found ...; required: ...' of mechanics/checks.hpp, or nothing."""
    arguments = arguments_of(tokens)
    what = arguments[0 if word == "refuse" else 1] if len(arguments) > 1 else None
    required = FINITE.get(word) or arguments[-1]
    return [f"{what}: found ...; required: {required}"] if what and required else []


def cpp_messages(text, file):
    tokens = cpp_tokens(text)
    taken = [False] * len(tokens)
    for i, word in enumerate(tokens[:-1]):
        called = tokens[i + 1] == "("
        collects = word in ("push_back", "emplace_back", "add") and i >= 2 and COLLECTING.search(tokens[i - 2])
        if called and word in RECORDED and tokens[i - 1] == ".":
            depth = 0
            for k in range(i + 1, end_of(tokens, i + 1)):
                depth += (tokens[k] in "([{") - (tokens[k] in ")]}")
                taken[k] = taken[k] or (depth == 1 and tokens[k][0] == '"')
            continue
        if word == "throw":
            end = end_of(tokens, i, statement=True)
            if "logic_error" in tokens[i:i + 5]:  # an error of the program, which no user can make
                taken[i:end] = [True] * (end - i)
                continue
        elif called and (word in REFUSING or collects):
            end = end_of(tokens, i + 1)
        else:
            continue
        whole = checked_argument(word, tokens[i + 1:end]) if word in CHECKS else []
        yield from whole
        for k in range(i, end):
            if tokens[k][0] == '"' and not taken[k] and not whole:
                yield from words_of(literal(tokens[k]))
            taken[k] = True
    if not UNSPOKEN_FILES.search(file):
        for token, known in zip(tokens, taken):
            if token[0] == '"' and not known and SPOKEN.search(token):
                yield from words_of(literal(token))


def python_messages(text):
    for node in ast.walk(ast.parse(text)):
        called = node.func if isinstance(node, ast.Call) else None
        name = getattr(called, "attr", getattr(called, "id", ""))
        if isinstance(node, ast.Raise) or name in ("warn", "exit", "error", "fail", "refuse") or name.endswith("Error"):
            for part in ast.walk(node):
                if isinstance(part, ast.Constant) and isinstance(part.value, str):
                    yield from words_of(part.value)


def all_ids():
    """id -> words, of all messages in the sources."""
    ids = {}
    for folder in ("mechanics", "gearset", "bearing", "coupling", "app", "page", "python"):
        for path in sorted((SOURCE / folder).rglob("*")):
            file = path.relative_to(SOURCE).as_posix()
            if file in NO_MESSAGES:
                continue
            if path.suffix in (".cpp", ".hpp"):
                found = cpp_messages(path.read_text(encoding="utf-8"), file)
            elif path.suffix == ".py":
                found = python_messages(path.read_text(encoding="utf-8"))
            else:
                continue
            ids.update((f"{file}: {words}", words) for words in found)
    return ids


# --- what tests expect

def blocks(file):
    """Blocks of a file of commands; each a list of (command, expected lines)."""
    block = []
    for line in [*file.read_text(encoding="utf-8").splitlines(), ""]:
        if line.startswith("$ "):
            block.append((line[2:], []))
        elif line.startswith("> "):
            block[-1] = (block[-1][0] + "\n" + line[2:], [])
        elif line and not line.startswith("#"):
            block[-1][1].append(line)
        elif not line and block:
            yield block
            block = []


# Beside what a shell has: `check CASE SETTING...` without its table; `with COMMAND CASE SETTING...`; of what that says,
# `warnings COMMAND CASE SETTING...`; `plainly COMMAND` as one who may not do more than modes of files allow;
# `stopped COMMAND` after 0.4 s of processor time.
# $reducer_150kW is the file of that case.
WORDS = """
with() { it=$1; file=$2; shift 2; n=$#; for one in "$@"; do case $one in -*) set -- "$@" "$one";; *) set -- "$@" --set "$one";; esac; done; shift $n; orbearing $it $file "$@"; }
check() { with check "$@" > checked; code=$?; grep '^warning' checked; return $code; }
plainly() { [ $(id -u) != 0 ] || set -- setpriv --bounding-set -dac_override,-dac_read_search --inh-caps -dac_override,-dac_read_search "$@"; "$@"; }
warnings() { with "$@" 2>&1 | grep -E '^(warning|error)'; }
stopped() { "$@" & for _ in $(seq 6000); do [ $(cut -d' ' -f14 /proc/$!/stat) -lt 40 ] || break; sleep 0.01; done; kill -TERM $!; wait $!; }
"""


def answers_of(block):
    """What the commands of a block answer, in a folder of its own in which `cases` are those that ship."""
    folder_of_program = str(pathlib.Path(os.environ["ORBEARING"]).resolve().parent)
    environment = {**os.environ, "PATH": folder_of_program + os.pathsep + os.environ["PATH"], "LC_ALL": "C.UTF-8",
                   "COLUMNS": "200",
                   "PYTHON": sys.executable, **{case.name: f"cases/{case.relative_to(SOURCE / 'cases')}/case.yaml" for case in (SOURCE / "cases").glob("**/*/")}}
    answers = []
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "cases").symlink_to(SOURCE / "cases")
        for command, _ in block:
            try:
                done = subprocess.run(["sh", "-c", WORDS + command], cwd=folder, env=environment, stdout=subprocess.PIPE,
                                      stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=SECONDS, check=False)
            except subprocess.TimeoutExpired:
                answers.append([f"[did not end in {SECONDS} s]"])
                continue
            text = done.stdout.decode("utf-8", "backslashreplace").replace(str(SOURCE), "SOURCE").replace(folder, "HERE")
            text = re.sub(r"'[0-9a-f]{16}'", "'HASH'", text)
            lines = [line.rstrip() for line in re.split(r"[\n\r]", text) if line.strip()]
            answers.append(lines + ([f"[{done.returncode}]"] if done.returncode else []))
    return answers


def answers_of_all(files):
    """(file, block, answers) of all blocks, as many at once as there are processors."""
    every = [(file, block) for file in files for block in blocks(file)
             if HAS_NETCDF or not any("netCDF4" in command for command, _ in block)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        return [(*one, answers) for one, answers in zip(every, pool.map(answers_of, [block for _, block in every]))]


def record(files):
    for file in files:
        path = pathlib.Path(file).resolve()
        if path.suffix == ".pytxt":
            with folder_of_its_own():
                record_python(path)
            continue
        lines, taken = [], iter([answer for _, _, answers in answers_of_all([path]) for answer in answers])
        text = path.read_text(encoding="utf-8").splitlines()
        for line, after in zip(text, [*text[1:], ""]):
            if line.startswith(("$ ", "> ", "#")) or not line:
                lines.append(line)
            if line.startswith(("$ ", "> ")) and not after.startswith("> "):
                lines += next(taken)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def python_globals():
    import program  # beside this file
    orbearing = program.package()

    def refused(call, *arguments, **named):
        """Prints what the call says when it refuses."""
        try:
            call(*arguments, **named)
        except (Exception, SystemExit) as error:
            print(f"{type(error).__name__}: {error}".replace(str(SOURCE), "SOURCE").replace(os.getcwd(), "HERE"))

    return {"orbearing": orbearing, "CASES": SOURCE / "cases", "REDUCER": SOURCE / "cases" / "reducer_150kW", "refused": refused}


@contextlib.contextmanager
def folder_of_its_own():
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)


def record_python(path):
    """Runs what stands behind >>> and writes what it prints beneath."""
    parts, known = [], python_globals()
    for part in doctest.DocTestParser().parse(path.read_text(encoding="utf-8")):
        if isinstance(part, str):
            parts.append(part)
            continue
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            exec(compile(part.source, str(path), "single"), known)  # pylint: disable=exec-used
        lines = part.source.rstrip("\n").split("\n")
        parts.append("".join(f"{'...' if n else '>>>'} {line}\n" for n, line in enumerate(lines)) + said.getvalue())
    path.write_text("".join(parts), encoding="utf-8")


def command_files():
    return sorted(HERE.glob("*.txt"))


def expected_texts():
    """All texts of which a test asserts every letter."""
    texts = [line for file in command_files() for block in blocks(file) for _, lines in block for line in lines]
    for file in sorted(HERE.glob("*.pytxt")):
        texts += file.read_text(encoding="utf-8").splitlines()
    texts += [line for line in (SOURCE / "tests" / "messages.txt").read_text(encoding="utf-8").splitlines()[3:] if not line.startswith("[")]
    return texts


def provoked(words, texts):
    """How many of the texts hold the words."""
    if ": found ...; required: " in words:
        pattern = re.compile(re.escape(words).replace(re.escape("..."), ".*", 1))
        return sum(bool(pattern.search(text)) for text in texts)
    return sum(words in text for text in texts)


def missing_ids():
    """Ids that no test provokes. Words that several files have count as often as texts hold them."""
    texts, places = expected_texts(), {}
    for name, words in all_ids().items():
        places.setdefault(words, []).append(name)
    return {name for words, names in places.items() for name in names[provoked(words, texts):]}


def not_yet():
    return [line for line in (HERE / "not_yet.list").read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]


class Messages(unittest.TestCase):
    maxDiff = None

    def test_commands_answer_what_is_written(self):
        for file, block, answers in answers_of_all(command_files()):
            for (command, expected), answer in zip(block, answers):
                with self.subTest(file.name, command=command):
                    self.assertEqual(answer, expected)

    def test_python_answers_what_is_written(self):
        for file in sorted(HERE.glob("*.pytxt")):
            said = io.StringIO()
            with contextlib.redirect_stdout(said), folder_of_its_own():
                failed, _ = doctest.testfile(str(file), module_relative=False, globs=python_globals(), encoding="utf-8")
            self.assertEqual(failed, 0, said.getvalue())

    def test_every_refusal_of_the_table_is_expected_by_a_test(self):
        table = re.findall(r"(?m)^\[(.*)\]$", (SOURCE / "tests" / "messages.txt").read_text(encoding="utf-8"))
        tests = "".join(path.read_text(encoding="utf-8") for path in sorted((SOURCE / "tests").rglob("*_test.cpp")))
        used = re.findall(r'EXPECT_(?:\w*REFUSED|SAID)\(\s*(?:[\w:]+,\s*)?"([^"]*)"', tests)
        self.assertEqual(sorted(table), sorted(set(used)))
        self.assertEqual(len(used), len(set(used)), "an id stands for one call")

    @unittest.skipIf("ORBEARING_MUTANT" in os.environ, "sources that hold errors have their messages twice")
    def test_every_message_is_provoked(self):
        ids, missing = all_ids(), missing_ids()
        left = set(not_yet())
        print(f"{len(ids)} ids, {len(ids) - len(missing)} provoked, {len(left)} not yet", file=sys.stderr)
        self.assertFalse(sorted(missing - left), "ids that no test provokes; write one into tests/interface/messages")
        self.assertFalse(sorted(left - missing), "ids of not_yet.list that are gone or provoked; take them out")
        self.assertLessEqual(len(left), MOST_NOT_YET, "not_yet.list may only shrink")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--record"]:
        record(sys.argv[2:])
    elif sys.argv[1:2] == ["--missing"]:
        print("\n".join(sorted(missing_ids())))
    else:
        unittest.main()
