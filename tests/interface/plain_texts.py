#!/usr/bin/env python3
"""The program's texts are short sentences of plain technical English.

It measures all messages on record (tests/interface/messages and tests/messages.txt), the help of each command, the
descriptions in the schemas of inputs and results, and the reasons and meanings that `check` gives.

  plain_texts.py --list            long sentences and words to avoid
  plain_texts.py --write FOLDER    all the texts, one a line
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

import messages

SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
MEAN_WORDS = 17.0  # of a sentence
LONG = 30  # words
LONG_PERCENT = 3.0
AVOIDED_PER_THOUSAND = 0.5  # words
SHORTEST = 3  # words of what counts as a sentence

# Words to avoid, and what to write instead.
AVOID = {
    r"(?:is|are|was|were) (?:it )?worth": "the effect of it, or the sensitivity to it",
    r"lives? (?:the )?(?:longest|shortest|longer|shorter)": "has the longest or shortest life",
    r"thrown": "under centrifugal load",
    r"told|tells?|asked|asks?|nobody": "required, requested, reported; no participant",
    r"gives? way|gave way|gives? in": "deflects",
    r"by itself|by themselves|lone": "single, standalone, separately",
    r"feels?|felt|knows?|believes?|believed|wants?": "is affected by, includes, requires",
    r"by nature": "at this fidelity",
    r"beside": "together with, compared with, next to",
    r"places?": "position, angle, point, element, path",
    r"in (?:its|their|whose) place|in place of": "instead, replaces",
    r"(?:in|the|a|no|finds?|found) balance": "static equilibrium",
    r"stands? (?:still|in|in no|there|twice|to|for)|standing|turning (?:ring|cage|shaft)": "stationary, rotating; is listed; is equivalent to",
    r"comes? out|came out": "is, results in, leaves",
    r"pressed out": "squeeze film",
    r"looks? (?:at|among)|a look": "a sample, a check",
    r"sinks?|sunk": "enters; depth",
    r"thaws?|thawed": "includes inertia",
    r"owed to": "caused by",
    r"of before": "previous",
    r"gone over|gone on|go(?:es)? on|goes? with": "repeat, continue; is proportional to, corresponds to",
    r"none of it|deserves?|holds? good|as it was|what is there|who is right|at which price": "the fact, the quantity",
    r"blows?|knocks?": "impacts",
    r"afresh|anew": "again, from the start",
    r"carr(?:y|ies) (?:most|alike)": "has the largest load, the same load",
    r"law of (?:balls|rollers|traction)|(?:fitted|one) law": "model",
    r"nothing to join|dig into|left open|how (?:far|often|much|long)": "cannot be joined, interferes with, undetermined; the quantity",
    r"ours": "computed value",
}
AVOIDED = {re.compile(rf"\b(?:{pattern})\b", re.I): instead for pattern, instead in AVOID.items()}


def plain(text):
    """Without what is not prose: quoted values, lists, placeholders, paths of keys and files count as one word each."""
    text = re.sub(r"\[[^\[\]]*\]", "X", text)
    while re.search(r"\{[^{}]*\}", text):
        text = re.sub(r"\{[^{}]*\}", "X", text)
    text = re.sub(r"'[^'\n]{0,200}'(?!\w)", "X", re.sub(r"(?<=\w)'(?=\w)", "’", text))
    text = re.sub(r"`[^`\n]*`|\"[^\"\n]*\"", "X", text)
    # a choice of four names or more
    return re.sub(r"(?<![\w.])[\w./-]+(?:, [\w./-]+){3,}(?:,? (?:or|and) [\w./-]+)?", "X", text)


def sentences(text):
    """A sentence ends at . ! ? or the end of the text; 'found ...; required: ...' are two."""
    parts = re.split(r"[.!?](?=\s|$)|; (?=required)|\n", plain(text))
    return [part for part in (" ".join(part.split()) for part in parts) if len(part.split()) >= SHORTEST]


def messages_on_record():
    """Each text once whatever its numbers, without the kind and the place before it."""
    words = set(messages.all_ids().values())
    known = [one for one in words if ": found ...; required: " not in one]
    texts = {}
    for line in messages.expected_texts():
        if "; required: " in line or line.startswith(("warning: ", "error: ")) or any(one in line for one in known):
            text = re.sub(r"^(?:warning|error|discard|\w*Error|--set|orbearing(?: \w+)?): ", "", line)
            while (shorter := re.sub(r"^(?:\S+|\(file\)): ", "", text)) != text:
                text = shorter
            texts.setdefault(re.sub(r"\d+", "9", text), text)
    return sorted(texts.values())


def helps():
    """Texts of --help: descriptions of commands and options, without names and values."""
    def text_of(*command):
        return subprocess.run([os.environ["ORBEARING"], *command, "--help"], check=True, stdout=subprocess.PIPE,
                              encoding="utf-8", env={**os.environ, "COLUMNS": "1000"}).stdout

    first = text_of()
    commands = re.findall(r"(?m)^  ([a-z]+) {2,}\S", first)
    found = set()
    for text in [first, *(text_of(command) for command in commands)]:
        for line in text.splitlines():
            described = re.match(r" +(?:\S.*? {2,}|)(\S.*)$", line)
            if described and not line.lower().startswith("usage"):
                found.add(described.group(1) if described.group(1)[0] != "-" else "")
            elif line and line[0] != " " and not line.lower().startswith("usage") and not line.endswith(":"):
                found.add(line)
    return sorted(found - {""})


def described(node):
    """All texts of a schema, each once."""
    if isinstance(node, dict):
        for key, value in node.items():
            if key == "description" and isinstance(value, str):
                yield value
            else:
                yield from described(value)
    elif isinstance(node, list):
        for value in node:
            yield from described(value)


def meanings(name):
    """Of inputs or results; without the range of values behind an input's meaning."""
    schema = json.loads((SOURCE / "cases" / f"{name}.schema.json").read_text(encoding="utf-8"))
    found = set()
    for text in described(schema):
        found.add(re.sub(r" \((?:an? |one of |true or false|whole |path)[^()]*\)", "", text))
    return sorted(found)


def checked():
    """Reasons of defaults and meanings of derived quantities, as `check` gives them of the cases supplied."""
    found = set()
    for case in sorted((SOURCE / "cases").glob("*/case.yaml")):
        answer = subprocess.run([os.environ["ORBEARING"], "check", str(case), "--json"], check=True, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL)
        record = json.loads(answer.stdout)
        reasons = (str(row.get("reason")) for row in record["inputs"])
        found |= {reason.removeprefix("default: ") for reason in reasons if reason.startswith("default: ")}
        found |= {str(row["meaning"]) for row in record["derived"]}
    return sorted(found)


def all_texts():
    return {"messages": messages_on_record(), "help": helps(), "inputs": meanings("case"), "results": meanings("result"),
            "reasons": checked()}


def measured(texts):
    """Mean words of a sentence, percentage of long ones, avoided words in a thousand; and the findings."""
    lengths, findings = [], []
    for text in texts:
        for sentence in sentences(text):
            lengths.append(len(sentence.split()))
            if lengths[-1] > LONG:
                findings.append(f"{lengths[-1]} words: {text}")
            findings += [f"'{hit.group()}' -> {instead}: {sentence}" for word, instead in AVOIDED.items()
                         for hit in word.finditer(sentence)]
    words = sum(lengths)
    avoided = sum(one.startswith("'") for one in findings)
    long = len(findings) - avoided
    return words / max(len(lengths), 1), 100.0 * long / max(len(lengths), 1), 1000.0 * avoided / max(words, 1), findings


class PlainTexts(unittest.TestCase):
    def test_texts_are_plain(self):
        for kind, texts in all_texts().items():
            self.assertGreater(len(texts), 100, kind)
            mean, long, avoided, findings = measured(texts)
            print(f"{kind}: {len(texts)} texts, {mean:.1f} words a sentence, {long:.1f} % over {LONG}, "
                  f"{avoided:.2f} words to avoid in a thousand", file=sys.stderr)
            with self.subTest(kind):
                self.assertLessEqual(mean, MEAN_WORDS)
                self.assertLessEqual(long, LONG_PERCENT, "\n".join(findings))
                self.assertLessEqual(avoided, AVOIDED_PER_THOUSAND, "\n".join(findings))

    def test_checker_finds_what_it_is_for(self):
        long = " ".join(["word"] * 31) + ". Two words here."
        self.assertEqual(measured([long])[:2], (17.0, 50.0))
        self.assertEqual(measured(["The bearing that lives longest is it."])[2], 1000.0 / 7)
        self.assertEqual(sentences("a: found 3 'a b. c'; required: a number of 0.5 mm"), ["a: found 3 X", "required: a number of 0.5 mm"])


if __name__ == "__main__":
    if sys.argv[1:2] == ["--list"]:
        for kind, texts in all_texts().items():
            mean, long, avoided, findings = measured(texts)
            print(f"== {kind}: {len(texts)} texts, mean {mean:.1f}, {long:.1f} % long, {avoided:.2f} avoided")
            print("\n".join(findings))
    elif sys.argv[1:2] == ["--write"]:
        for kind, texts in all_texts().items():
            (pathlib.Path(sys.argv[2]) / f"{kind}.txt").write_text("\n".join(texts) + "\n", encoding="utf-8")
    else:
        unittest.main()
