"""Sources of the documentation site: the repository's Markdown as it stands, with generated parts filled in.

    stage.py FOLDER      needs ORBEARING (the program) and the package orbearing on PYTHONPATH
    stage.py --record    writes the parts that the repository shows as well into its documents

Every document keeps its path, so that links between documents are those of the repository. A line
`<!-- generated: NAME ARGUMENTS -->` is replaced by what the function of that name below writes; tutorials are run, and
shown with their outputs. Files whose content did not change are not touched. A part that the repository shows as well
stands between that line and `<!-- end of generated -->`, as --record wrote it last.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
import textwrap
from pathlib import Path

import tutorial

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("mechanics", "gearset", "bearing", "coupling", "app", "page", "python", "cases", "tests", "benchmarks", "docs")
FRONT = ("README.md", "CHANGELOG.md", "REFERENCES.md", "CONTRIBUTING.md")
PICTURES = (".png", ".jpg", ".svg")
PAPER = Path("docs/paper")  # for a journal, in its own form of Markdown
_END = "<!-- end of generated -->"
_GENERATED = re.compile(rf"^(?P<head><!-- generated: (?P<name>[\w-]+) ?(?P<arguments>[^\n]*?) -->)$(?:\n\n(?P<recorded>(?:(?!^<!-- generated: ).)*?)\n\n{_END}$)?",
                        re.M | re.S)


def documents() -> list[Path]:
    """Markdown and pictures of the repository that belong to the site, relative to its root."""
    found = [Path(name) for name in FRONT]
    for folder in FOLDERS:
        for name in ("*.md", *("*" + end for end in PICTURES)):
            found += [file.relative_to(ROOT) for file in sorted((ROOT / folder).rglob(name))]
    return [name for name in found if PAPER not in name.parents]


def program(*arguments: str) -> str:
    return subprocess.run([os.environ["ORBEARING"], *arguments], check=True, capture_output=True, text=True).stdout.strip("\n")


def code(text: str, language: str = "text") -> str:
    return f"```{language}\n{text}\n```"


def cell(text) -> str:
    """A text within a table."""
    return str(text).replace("\\", "\\\\").replace("|", "\\|").replace("*", "\\*").replace("<", "&lt;").replace("\n", " ")


def table(heads: list[str], rows) -> str:
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


# What `<!-- generated: ... -->` can name: each takes the staged folder of the page and the words behind the name.

def commands(_) -> str:
    """Every command with its options, as the program prints them."""
    front = program("--help")
    names = re.findall(r"^  ([a-z]+) {2,}", front.split("Subcommands:")[1], re.M)
    # Those that are Python need not be in every build.
    def narrow(text):
        """Lines of at most 88 letters; what an option means goes on below where it begins."""
        lines = []
        for line in text.splitlines():
            found = re.match(r"  \S.*? {2,}(?=\S)", line)
            lines += textwrap.wrap(line, 88, subsequent_indent=" " * (len(found[0]) if found else 2), drop_whitespace=True, replace_whitespace=False,
                                   break_long_words=False, break_on_hyphens=False) or [""]
        return "\n".join(lines)

    return "\n\n".join([code(narrow(front)), *(f"## orbearing {name}\n\n{code(narrow(program(name, '--help')))}" for name in names)])


def file(_, path: str, language: str = "text") -> str:
    """A file as it stands."""
    return code((ROOT / path).read_text(encoding="utf-8").rstrip("\n"), language)


def inputs(_) -> str:
    """Every key of a case file, by the schema of case files; then what an element of `uncertain` can be."""
    schema = json.loads((ROOT / "cases" / "case.schema.json").read_text(encoding="utf-8"))
    parts = []
    for model, described in schema["$defs"].items():
        if "properties" not in described:
            choices = table(["key", "required", "optional"], _distributions(described))
            parts.append(f"## {model}\n\nAn element of `uncertain` is one of these.\n\n{choices}")
            continue
        rows = [[f"`{path}`", cell(meaning), f"`{default}`" if default else ""] for path, meaning, default, _ in _keys(described, "")]
        parts.append(f"## {model}\n\n" + table(["key", "meaning, what it takes", "default"], rows))
    return "\n\n".join(['<p class="key-filter"></p>', *parts])  # static/key_filter.js


def numerical(_) -> str:
    """The keys of the way results are computed."""
    schema = json.loads((ROOT / "cases" / "case.schema.json").read_text(encoding="utf-8"))
    found: dict[str, list] = {}
    for model, described in schema["$defs"].items():
        for path, meaning, default, one in _keys(described, ""):
            if one.get("numerical") and "NAME" not in path:
                found.setdefault(path, [cell(meaning), f"`{default}`" if default else "", []])[2].append(model)
    return table(["key", "meaning, what it takes", "default", "models"],
                 [[f"`{path}`", meaning, default, ", ".join(models)] for path, (meaning, default, models) in sorted(found.items())])


def _keys(described: dict, before: str):
    for name, one in described.get("properties", {}).items():
        path = before + name
        if path in ("model", "assumed"):
            continue
        one = {**one.get("oneOf", [{}])[0], **one} if "properties" not in one and "oneOf" in one else one
        default = json.dumps(one["default"], ensure_ascii=False).strip('"') if "default" in one else ""
        if "description" in one:
            yield path, one["description"], default, one
        if before + name != "sweep":
            yield from _keys(one, path + ".")
    for one in described.get("patternProperties", {}).values():
        yield from _keys(one, before + "NAME.")


def _distributions(described: dict):
    """One row for each distribution that an uncertain number can have."""
    for choice in described["oneOf"]:
        (kind,) = choice["required"]
        one = choice["properties"][kind]
        groups = one.get("oneOf", [])
        alternatives = [group["required"][0] for group in groups]
        required = [f"`{name}`" for name in one.get("required", [])] + ([" or ".join(f"`{name}`" for name in alternatives)] if groups else [])
        optional = [f"`{name}`" for name in one.get("properties", {}) if name not in (*one.get("required", []), *alternatives)]
        if "enum" in one:
            required = [" or ".join(one["enum"])]
        yield [f"`{kind}`", ", ".join(required), ", ".join([*optional, *(f"`{name}` beside it" for name in choice["properties"] if name != kind)])]


def assumptions(_) -> str:
    """What each case that ships assumes, with the reason."""
    import orbearing

    parts = []
    for name, path in orbearing.cases().items():
        case = orbearing.load(path)
        rows = [[f"`{row['path']}`", cell(row["given"]), cell(row["reason"])] for row in case.inputs
                if row["source"] == "assumed" and row["given"] is not None]
        if rows:
            parts.append(f"## {name}\n\n" + table(["input", "taken as", "reason"], rows))
    return "\n\n".join(parts)


def life_peak(folder: Path) -> str:
    """Picture of life over speed of the reducer."""
    import matplotlib

    matplotlib.use("Agg")
    import orbearing
    from matplotlib import pyplot
    from orbearing import style

    sweep = orbearing.load(orbearing.cases()["reducer_150kW"]).sweep()
    with style.context():
        figure, axes = pyplot.subplots(figsize=(style.WIDTH, 4.0))
        sweep.plot(axes)
        figure.savefig(folder / "life_peak.png", dpi=style.DOTS, metadata={"Software": None})
        pyplot.close(figure)
    peak = sweep.peak
    return (f"![Life of one planet bearing over input speed, 150 kW held constant](life_peak.png)\n\n"
            f"Longest life of a planet bearing of the 150 kW reducer: {peak['refined_life_h']:,.0f} h (`life_h`, quasi-static) "
            f"at {peak['refined_speed_rpm']:,.0f} rpm of the sun.")


def pages_of_first_page(caption: str = "") -> list[str]:
    """Documents in the contents of docs/index.md, relative to docs; those of one caption."""
    text = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    contents = re.findall(r"^```\{toctree\}\n:caption: ([^\n]*)\n:maxdepth: 1\n\n(.*?)^```$", text, re.M | re.S)
    entries = [line for title, lines in contents if caption in ("", title) for line in lines.splitlines()]
    return [re.sub(r"^.*<(.*)>$", r"\1", entry) for entry in entries]


def topics(_) -> str:
    """A contents of the documents in docs/ that are no frame of the site and not in the contents of its first page."""
    frame = {"README", "index", "theory", *pages_of_first_page()}
    documents_there = [*sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "docs").glob("*/*.md"))]
    stems = [name.relative_to(ROOT / "docs").with_suffix("").as_posix() for name in documents_there
             if name.parent.name not in ("guide", "tutorials", PAPER.name)]
    names = [f"../{stem}" for stem in stems if stem not in frame]
    return "```{toctree}\n:hidden:\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```"


def validation_guide(folder: Path) -> str:
    """The validation guide from the rows that tools/validation recorded."""
    from orbearing import validation
    from orbearing.validation.guide import guide, save

    text, pictures = guide(validation.read([ROOT / "docs" / "validation" / "rows.json"]),
                           (ROOT / "REFERENCES.md").read_text(encoding="utf-8"), prefix="validation_")
    for name, figure in pictures.items():
        save(figure, folder / name)
    return text


def explorer(_, path: str, text: str) -> str:
    """A link to the page with its core in the browser, where the site has it."""
    there = (Path(os.environ.get("ORBEARING_EXPLORER", "/nowhere")) / "index.html").exists()
    return f'<p class="explorer"><a href="{path}">{text}</a></p>' if there else ""


GENERATED = {"commands": commands, "file": file, "inputs": inputs, "numerical": numerical, "assumptions": assumptions,
             "life-peak": life_peak, "topics": topics, "explorer": explorer,
             "validation-guide": validation_guide}


def generated_part(found: re.Match, folder: Path) -> str:
    """What stands in place of a line `<!-- generated: ... -->`."""
    return GENERATED[found["name"]](folder, *shlex.split(found["arguments"]))


def filled(text: str, folder: Path) -> str:
    return _GENERATED.sub(lambda found: generated_part(found, folder), text)


def recorded(text: str, folder: Path) -> str:
    """A document of the repository with its recorded parts as they are now."""
    return _GENERATED.sub(lambda found: found[0] if found["recorded"] is None else f"{found['head']}\n\n{generated_part(found, folder)}\n\n{_END}", text)


def record() -> None:
    for name in documents():
        path = ROOT / name
        if name.suffix == ".md" and _END in (text := path.read_text(encoding="utf-8")):
            path.write_text(recorded(text, path.parent), encoding="utf-8")


def run_tutorial(path: Path, folder: Path) -> str:
    """A tutorial's page with its outputs, and the notebook beside; without outputs where it cannot be run."""
    missing = tutorial.missing_modules(path)
    if missing:
        text, note = path.read_text(encoding="utf-8"), f"*Shown without outputs: {', '.join(missing)} was missing where this site was built.*"
    else:
        done = tutorial.run(path)
        (folder / f"{path.stem}.ipynb").write_text(done.notebook(), encoding="utf-8")
        text, note = done.markdown(folder), f"{{download}}`Download as a notebook <{path.stem}.ipynb>`"
    return re.sub(r"^# .*$", lambda title: f"{title[0]}\n\n{note}", text, count=1, flags=re.M)


def stage(target: Path) -> None:
    kept = set()
    for name in documents():
        out = target / name
        out.parent.mkdir(parents=True, exist_ok=True)
        if name.suffix in PICTURES:
            _write(out, (ROOT / name).read_bytes())
        elif name.parent == Path("docs/tutorials") and name.name != "index.md":
            _write(out, run_tutorial(ROOT / name, out.parent).encode())
        else:
            _write(out, filled((ROOT / name).read_text(encoding="utf-8"), out.parent).encode())
        kept.add(out)
    for old in target.rglob("*.md"):
        if old not in kept:
            old.unlink()


def _write(path: Path, content: bytes) -> None:
    if not path.exists() or path.read_bytes() != content:
        path.write_bytes(content)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    if sys.argv[1] == "--record":
        record()
    else:
        stage(Path(sys.argv[1]))
