"""An answer of the program as a compact record, and how two records differ (recorded_results.py).

By path of keys, without indexes of long lists: numbers as [count, sum weighted by position, sum of magnitudes], the weights 0.5 to 1.5, so that
a swap or a shift of two numbers shows; names, kinds, statuses, labels and units as they are or, where they are many, as a digest; sentences
by their count. Files in the folder of an answer are reduced in the same way, columns of CSV by name, variables of netCDF by name.
"""

import csv
import hashlib
import importlib.util
import io
import json
import math
import re
import zipfile

HAS_NETCDF = importlib.util.find_spec("netCDF4") is not None

FOLDER = "FOLDER"  # in words of a command: a folder of its own
SOURCE = "SOURCE"  # in what is reduced: the folder of the sources
TOLERANCE = 1e-6  # of the sum of magnitudes
# Motion with impacts magnifies round-off, and a search may end a step earlier: a record holds by how much each path changes with the instruction
# set and with the fourteenth digit of an input ("spread"). Answers of other compilers may differ by more than these samples do.
TIMES_THE_SPREAD = 10.0
CHAOTIC, OF_CHAOTIC = 0.1, 0.02  # where this share of the paths has a spread above 1e-6, all paths of the answer have at least this tolerance
# In such an answer a choice may fall otherwise: whether a motion is steady and is warned of, which of like planets lives shortest, a band.
CHOSEN = re.compile(r"steady|shortest_life_planet|_band|band_Hz|envelope_spectrum|^(warnings|standard error|printed: warning|printed \(words\))")
LEAST_COMPONENT = 1e-12  # of the largest number of a vector or a matrix: round-off of what is zero
WORDS_OF_A_SENTENCE = 5
OF_SENTENCE, OF_PRINTED = "numbers of", 0.01  # their tolerance: they are printed with few digits
LEAST_NUMBER = 1e-30
MOST_TEXTS = 6  # as they are
MOST_COMPONENTS = 6  # of a vector or a matrix, each of which is a path of its own
COMPONENT = re.compile(r"\[\d+\]")
LABELS = ("path", "key", "name", "quantity", "requirement", "result")  # of a row
# What hangs on the machine, the version or the day.
LEFT_OUT = {"versions", "version", "program", "program_version", "wall_s", "seconds", "folder", "report", "source_hash", "case_hash", "hash", "token", "bytes"}
HEXADECIMAL = re.compile(r"(?<![\w.])-?[01](?:\.[0-9a-f]+)?p[-+]\d+\b")  # a number to its last bit
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d[\d,]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w])")
def weight(position):
    return 0.5 + (position * 2654435761 % 4294967296) / 4294967296.0


class Reduction:
    """Collects what stands at each path."""

    def __init__(self, with_words=True):
        self.numbers, self.texts, self.sentences, self.nothing, self.with_words = {}, {}, {}, {}, with_words

    def add(self, path, value):
        if value is None or (isinstance(value, float) and not math.isfinite(value)):
            self.nothing[path] = self.nothing.get(path, 0) + 1
        elif isinstance(value, bool):
            self.texts.setdefault(path, []).append(str(value).lower())
        elif isinstance(value, (int, float)):
            one = self.numbers.setdefault(path, [0, 0.0, 0.0])
            one[1] += weight(one[0]) * value
            one[2] += abs(value)
            one[0] += 1
        elif isinstance(value, str):
            if value.count(" ") >= WORDS_OF_A_SENTENCE:
                self.add_sentence(path, value)
            else:
                self.texts.setdefault(path, []).append(value)
        elif isinstance(value, dict):
            if not value:
                self.nothing[path] = self.nothing.get(path, 0) + 1
            label = next((value[key] for key in LABELS if isinstance(value.get(key), str)), None)
            for key, inner in value.items():
                if key not in LEFT_OUT:
                    # Rows of unlike quantities: one sum would hide the small ones.
                    of_row = f"{path}<{label}>" if label and isinstance(inner, (int, float)) and not isinstance(inner, bool) else path
                    self.add(f"{of_row}.{key}" if of_row else key, inner)
        elif isinstance(value, list):
            if not value:
                self.nothing[path] = self.nothing.get(path, 0) + 1
            components = len(value) <= MOST_COMPONENTS and all(isinstance(inner, (int, float, list)) for inner in value)
            for index, inner in enumerate(value):
                self.add(path + (f"[{index}]" if components else "[]"), inner)

    def add_sentence(self, path, text):
        words = NUMBER.sub("#", text)
        self.sentences.setdefault(path, []).append(words)
        if self.with_words:
            for number in NUMBER.findall(text):
                self.add(f"{path} ({OF_SENTENCE} {digest([words])})", math.log10(abs(float(number.replace(",", ""))) + LEAST_NUMBER))

    def add_text(self, path, text):
        """Printed lines: their words by a digest, their numbers by each line's first words."""
        if SOURCE in text or FOLDER in text:  # columns are as wide as the names of folders, which differ between machines
            text = re.sub(r" +", " ", text)
        text = HEXADECIMAL.sub(lambda found: f"{float.fromhex(found[0]):.15g}", text)
        words = []
        for line in text.splitlines():
            label = " ".join(re.findall(r"[A-Za-z_]\S*", NUMBER.sub(" ", line))[:2])
            for number in NUMBER.findall(line):
                self.add(f"{path}: {label}", float(number.replace(",", "")))
            words.append(NUMBER.sub(lambda found: "#" * len(found[0]), line).rstrip())  # columns keep their places
        # The order of lines by size may change in motion, and the widths of numbers: words alone stay.
        self.texts[f"{path} (words)"] = [digest(sorted({re.sub(r"#+", "#", re.sub(r"\s+", " ", line)) for line in words}))]
        if len(words) > MOST_TEXTS:
            self.texts[path] = [f"{len(words)} lines, {digest(words)}"]
        else:
            self.texts[path] = words

    def record(self):
        found = {path: [count, float(f"{weighted:.10g}"), float(f"{size:.10g}")] for path, (count, weighted, size) in self.numbers.items()}
        for path, texts in self.texts.items():
            found[path + " (texts)"] = texts if len(texts) <= MOST_TEXTS else f"{len(texts)} texts, {digest(texts)}"
        for path, sentences in self.sentences.items():
            found[path + " (sentences)"] = f"{len(sentences)}, {digest(sentences)}" if self.with_words else len(sentences)
        for path, count in self.nothing.items():
            found[path + " (nothing)"] = count
        return found


def digest(texts):
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:12]


def number_or_text(word):
    try:
        return float(word)
    except ValueError:
        return word or None


def add_csv(into, name, text):
    rows = [row for row in csv.reader(io.StringIO(text)) if row and not row[0].startswith("#")]
    head = rows[0] if rows and not all(isinstance(number_or_text(word), float) for word in rows[0]) else None
    into.texts[f"{name}: columns"] = [digest(head)] if head else []
    for row in rows[1:] if head else rows:
        for key, word in zip(head or range(len(row)), row):
            into.add(f"{name}: {key}", number_or_text(word))


def add_netcdf(into, name, file):
    if not HAS_NETCDF:
        return
    import netCDF4  # takes a third of a second, and few commands write such files

    with netCDF4.Dataset(file) as data:
        for key, variable in data.variables.items():
            values = variable[...]
            filled = values.filled(math.nan) if hasattr(values, "filled") and values.dtype.kind == "f" else values
            for value in filled.ravel().tolist():
                into.add(f"{name}: {key}", value)
            into.texts[f"{name}: {key}: attributes"] = [digest([f"{one}={variable.getncattr(one)}" for one in sorted(variable.ncattrs())
                                                                if isinstance(variable.getncattr(one), str)] + list(variable.dimensions))]


def add_file(into, folder, file, plain):
    name = re.sub(r"\d{5}", "#", file.relative_to(folder).as_posix())
    if file.suffix == ".json":
        into.add(f"{name}: ", json.loads(plain(file.read_text(encoding="utf-8"))))
    elif file.suffix == ".csv":
        add_csv(into, name, plain(file.read_text(encoding="utf-8")))
    elif file.suffix == ".nc":
        add_netcdf(into, name, file)
    elif file.suffix == ".fmu":
        with zipfile.ZipFile(file) as archive:
            for part in ("modelDescription.xml", "resources/model.txt"):
                own = r"[{]?[0-9a-f-]{16,}[}]?|version=\S+|generationTool=\S+ \S+|\d{4}-\d\d-\d\dT\S+"  # of this version and day
                into.add_text(f"{name}: {part}", re.sub(own, "ID", archive.read(part).decode()))
    elif file.suffix in (".yaml", ".xls", ".txt"):
        into.add_text(name, plain(file.read_text(encoding="utf-8", errors="replace")))
    else:
        into.texts.setdefault("other files", []).append(name)


def reduced_run(done, folder, source, as_json, with_words=True):
    """Of an ended process. What went wrong stands line by line; warnings on standard error by their count."""
    def plain(text):
        return text.replace(str(folder), FOLDER).replace(str(source), SOURCE)

    into = Reduction(with_words)
    if done.returncode != 0:
        lines = [line for line in plain(done.stderr).splitlines() if line.strip()]
    else:
        for line in plain(done.stderr).splitlines():
            into.add_sentence("standard error", line)
        lines = []
    text = plain(done.stdout)
    if as_json and text.strip():
        try:
            into.add("", json.loads(text))
        except ValueError:
            into.add_text("no JSON", text)
    elif text:
        into.add_text("printed", text)
    for file in sorted(folder.rglob("*")):
        if file.is_file() and file.name != "case.yaml":
            add_file(into, folder, file, plain)
    return {"exit": done.returncode, "found": into.record()} | ({"messages": lines} if lines else {})


def spread_of(first, others):
    """By path: by how much answers that should be the same differ, as a share of the sum of magnitudes; infinity for what comes and goes."""
    spread = {}
    for other in others:
        if other.get("exit") != first.get("exit"):
            continue
        before, now = first["found"], other["found"]
        for path in set(before) | set(now):
            one, two = before.get(path), now.get(path)
            if one != two:
                spread[path] = max(spread.get(path, 0.0), deviation(one, two))
    return {path: float(f"{value:.1g}") for path, value in sorted(spread.items()) if value > 0.01 * TOLERANCE}


def deviation(one, two, least=0.0):
    """`least`: a size that counts at least."""
    if not is_number(one) or not is_number(two) or one[0] != two[0]:
        return math.inf
    return max(abs(one[1] - two[1]), abs(one[2] - two[2])) / (max(one[2], two[2], least) or 1.0)


def least_components(found):
    """Sizes that components of a vector or a matrix count at least, by the path without their indexes."""
    largest = {}
    for path, one in found.items():
        if is_number(one):
            whole = COMPONENT.sub("", path)
            largest[whole] = max(largest.get(whole, 0.0), one[2])
    return {whole: LEAST_COMPONENT * size for whole, size in largest.items()}


def differences(expected, found):
    """Sentences, each with the path, what is on record and what was found."""
    for key in ("exit", "messages"):
        if expected.get(key) != found.get(key):
            yield f"{key}: on record {expected.get(key)}; found {found.get(key)}"
    before, now, spread = expected.get("found", {}), found.get("found", {}), expected.get("spread", {})
    changing = sum(value > TOLERANCE for value in spread.values())
    least = OF_CHAOTIC if changing > max(5, CHAOTIC * sum(map(is_number, before.values()))) else TOLERANCE
    components = least_components(before)
    for path in sorted(set(before) | set(now)):
        if least == OF_CHAOTIC and CHOSEN.search(path):
            continue
        one, two = before.get(path), now.get(path)
        bound = max(least, TIMES_THE_SPREAD * spread.get(path, 0.0), OF_PRINTED if OF_SENTENCE in path else 0.0)
        if one == two or bound >= 1.0 or (not HAS_NETCDF and ".nc: " in path):
            continue
        share = deviation(one, two, components.get(COMPONENT.sub("", path), 0.0))
        if share == math.inf:
            yield f"{path}: on record {shown(one)}; found {shown(two)}"
        elif share > bound:
            yield f"{path}: on record {shown(one)}; found {shown(two)}; differs by {share:.2g}, at most {bound:g}"


def is_number(entry):
    return isinstance(entry, list) and len(entry) == 3 and all(isinstance(one, (int, float)) for one in entry)


def shown(entry):
    return f"{entry[0]} numbers, weighted sum {entry[1]:.9g}, magnitudes {entry[2]:.9g}" if is_number(entry) else str(entry)
