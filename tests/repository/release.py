"""What a release is made of agrees with the sources: one version and one date everywhere, a changelog in its form, packages with the
libraries that the build requires, a paper with the counts of the last validation, and names that stay.

    release.py --record      writes the names that are there into stable_names.txt; a name that is gone needs the next major version
"""
import datetime
import email.utils
import importlib.util
import json
import os
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
NAMES = ROOT / "tests" / "repository" / "stable_names.txt"
GROUPS = ["Added", "Changed", "Fixed"]
LONGEST = 200  # letters of a line of the changelog
WORDS = (750, 1250)  # of the paper
HIDDEN = {"--bearing-points", "--data-only", "--linger", "--worker"}  # options of the program for itself


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def version():
    return re.search(r"^project\(Orbearing VERSION ([0-9.]+)", text_of("CMakeLists.txt"), re.M)[1]


def keys_of(schema, before=""):
    """Paths of all keys that a schema describes; those of many members as NAME."""
    for name, one in sorted(schema.get("properties", {}).items()):
        yield before + name
        yield from keys_of(one, f"{before}{name}.")
    for part in ("items", "additionalProperties"):
        if isinstance(schema.get(part), dict):
            yield from keys_of(schema[part], before)
    for one in schema.get("patternProperties", {}).values():
        yield from keys_of(one, before + "NAME.")
    for one in schema.get("oneOf", []) + schema.get("anyOf", []):
        yield from keys_of(one, before)


def is_former(name):
    """Whether the program reads a key of a case by this name, though the schema has another one."""
    formers = re.findall(r'^    \{"([\w.]+)", "[\w.]+"\},$', text_of("app/case/settings.cpp"), re.M)
    return any(name == f"case {former}" or name.startswith(f"case {former}.") for former in formers)


def stable_names():
    """Names that scripts rely on: commands, options, keys of cases and of JSON results, headers, functions of the Python package."""
    commands = ROOT / "app" / "commands"
    files = [*commands.glob("*.hpp"), commands / "common_options.cpp", commands / "command_line.cpp", ROOT / "app/study/crown/crown_options.hpp"]
    rows = "".join(file.read_text(encoding="utf-8") for file in files)  # of commands and their options
    names = {f"command {name}" for name in re.findall(r'command = "(\w+)"', rows)}
    names |= {f"command {name}" for name in re.findall(r'^\s*\{+"(\w+)", "', text_of("app/commands/python_part.cpp"), re.M)}
    names |= {f"option {name}" for name in set(re.findall(r'"(?:-\w,)?(--[a-z-]+)"', rows)) - HIDDEN}
    for schema in json.loads(text_of("cases/case.schema.json"))["$defs"].values():
        names |= {f"case {key}" for key in keys_of(schema) if not key.startswith(("assumed.", "sweep."))}
    for group, schema in json.loads(text_of("cases/result.schema.json"))["$defs"].items():
        names |= {f"result {group}: {key}" for key in keys_of(schema)}
    names |= {f"header {file.name}" for file in (ROOT / "include" / "orbearing").glob("*.h*")}
    names |= {f"c {name}" for name in re.findall(r"\b(orbearing_\w+)\(", text_of("include/orbearing/c_interface.h"))}
    names |= {f"python {name}" for name in re.findall(r'^    "(\w+)": "', text_of("python/orbearing/__init__.py"), re.M)}
    return names


class Release(unittest.TestCase):
    def test_every_file_states_the_same_version(self):
        stated = {
            "CITATION.cff": re.search(r"^version: (\S+)$", text_of("CITATION.cff"), re.M)[1],
            "codemeta.json": json.loads(text_of("codemeta.json"))["version"],
            ".zenodo.json": json.loads(text_of(".zenodo.json"))["version"],
            "conda": re.search(r'set version = "([^"]+)"', text_of("tools/packaging/conda/meta.yaml"))[1],
            "debian": re.match(r"orbearing \(([0-9.]+)-\d+\)", text_of("tools/packaging/debian/changelog"))[1],
            "CHANGELOG.md": re.search(r"^## ([0-9.]+)", text_of("CHANGELOG.md"), re.M)[1],
        }
        self.assertEqual(stated, dict.fromkeys(stated, version()))
        self.assertEqual(version().partition(".")[0], re.search(r"^Package: liborbearing([0-9.]+)$", text_of("tools/packaging/debian/control"), re.M)[1])

    def test_every_file_states_the_date_of_the_release(self):
        """The changelog has it. A version that is not yet released has none."""
        heading = re.search(r"^## [0-9.]+, (.*)$", text_of("CHANGELOG.md"), re.M)[1]
        if heading == "not yet released":
            return
        debian = re.search(r"^ -- .*>  (.*)$", text_of("tools/packaging/debian/changelog"), re.M)[1]
        stated = {
            "CITATION.cff": re.search(r"^date-released: (\S+)$", text_of("CITATION.cff"), re.M)[1],
            "codemeta.json": json.loads(text_of("codemeta.json"))["datePublished"],
            ".zenodo.json": json.loads(text_of(".zenodo.json"))["publication_date"],
            "debian": email.utils.parsedate_to_datetime(debian).date().isoformat(),
        }
        self.assertEqual(stated, dict.fromkeys(stated, datetime.date.fromisoformat(heading).isoformat()))

    def test_the_changelog_has_one_line_a_change(self):
        """Newest version first; in each version Added, Changed, Fixed in this order, and nothing else."""
        parts = re.split(r"^## ", text_of("CHANGELOG.md"), flags=re.M)[1:]
        versions = [tuple(map(int, part.split(",")[0].split()[0].split("."))) for part in parts]
        self.assertEqual(versions, sorted(versions, reverse=True))
        for part in parts:
            groups = re.findall(r"^### (.*)$", part, re.M)
            self.assertEqual(groups, [group for group in GROUPS if group in groups])
            for line in part.splitlines()[1:]:
                if line and not line.startswith("### "):
                    self.assertTrue(line.startswith("- "), f"under no group, or on a second line: {line}")
                    self.assertLessEqual(len(line), LONGEST, line)

    def test_packages_build_with_what_the_build_requires(self):
        """Each package of tools/packages.sh that the build needs is a build dependency of Debian's; those of every Debian are left out."""
        blocks = re.findall(r"^(?:build|windows)_packages='\n(.*?)^'", text_of("tools/packages.sh"), re.M | re.S)
        wanted = {line.split(":")[0] for block in blocks for line in block.splitlines()} - {"g++"}
        control = text_of("tools/packaging/debian/control")
        listed = set(re.findall(r"[\w.+-]+", re.search(r"^Build-Depends:(.*?)^\S", control, re.M | re.S)[1]))
        self.assertEqual(wanted - listed, set())

    def test_the_library_package_depends_on_what_is_loaded(self):
        """It is not linked, so that the tools of packages do not see it."""
        depends = re.search(r"^Package: liborbearing1$.*?^Depends: (.*?)^\S", text_of("tools/packaging/debian/control"), re.M | re.S)[1]
        for name in ("netcdf", "zip"):
            with self.subTest(name):
                stated = re.search(rf"\blib{name}(\d+),$", depends, re.M)[1]
                found = [file.name for file in pathlib.Path("/usr/lib").glob(f"*/lib{name}.so.*") if file.name.count(".") == 2]
                if not found:
                    self.skipTest(f"no shared library of {name} in /usr/lib")
                self.assertIn(f"lib{name}.so.{stated}", found)

    def test_units_by_table_have_what_is_called(self):
        """The wheel and the page in a browser have a table in place of udunits2."""
        called = set(re.findall(r"\b((?:ut|cv)_\w+)\(", (ROOT / "app" / "case" / "units.cpp").read_text(encoding="utf-8")))
        defined = set(re.findall(r"^\w[\w *]*?[ *]((?:ut|cv)_\w+)\(", (ROOT / "page" / "wasm" / "units_by_table.cpp").read_text(encoding="utf-8"), re.MULTILINE))
        self.assertGreater(len(called), 8)
        self.assertEqual(called - defined, set())

    def test_the_browser_has_the_ranges_that_are_used(self):
        """The library of the page's compiler has comparisons of std::ranges alone: missing_library.hpp has the rest, by name."""
        has = (ROOT / "page" / "wasm" / "missing_library.hpp").read_text(encoding="utf-8")
        defined = set(re.findall(r"^(?:constexpr )?(?:auto|bool|void) (\w+)\(|^struct (\w+) {", has.split("namespace std::ranges {")[1].split("namespace std::ranges\n")[0], re.MULTILINE))
        defined = {name for pair in defined for name in pair if name}
        used = {name for folder in ("mechanics", "gearset", "bearing", "coupling", "app", "page", "include") for file in (ROOT / folder).rglob("*.[ch]pp")
                for name in re.findall(r"std::ranges::(\w+)", file.read_text(encoding="utf-8"))}
        self.assertGreater(len(used), 15)
        self.assertEqual(used - defined - {"greater", "less"}, set())

    def test_the_browser_has_the_templates_of_the_program(self):
        spec = importlib.util.spec_from_file_location("assemble", ROOT / "page" / "wasm" / "assemble.py")
        assemble = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(assemble)
        self.assertEqual(sorted(assemble.template_names()), sorted(file.stem for file in (ROOT / "cases" / "templates").glob("*.yaml")))

    def test_the_paper_has_the_counts_of_the_last_validation(self):
        paper, record = text_of("docs/paper/paper.md"), text_of("docs/validation.txt")
        for kind, name in (("measurement", "measurement"), ("program", "program"), ("worked-example", "worked example")):
            total, rest = re.search(rf"^  {kind} +([0-9]+): (.*)$", record, re.M).groups()
            counts = {word: number for number, word in re.findall(r"([0-9]+) (missed|reproduced)", rest)}
            self.assertIn(f"| {name} | {total} | {counts['reproduced']} | {counts['missed']} |", paper)
        words = len(paper.split("---", 2)[2].split())
        self.assertTrue(WORDS[0] <= words <= WORDS[1], words)

    def test_the_paper_cites_what_its_list_has(self):
        cited = set(re.findall(r"@(\w+)", text_of("docs/paper/paper.md").split("---", 2)[2]))
        self.assertEqual(cited, set(re.findall(r"^@\w+\{(\w+),", text_of("docs/paper/paper.bib"), re.M)))
        for key in cited:
            self.assertIn(f"[{key}]", text_of("REFERENCES.md"))

    def test_names_stay(self):
        """Within a major version, and before 1.0 unless they are recorded again: a script of today runs tomorrow."""
        recorded = [line for line in NAMES.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
        self.assertGreater(len(recorded), 500)
        gone = [name for name in sorted(set(recorded) - stable_names()) if not is_former(name)]
        self.assertEqual(gone, [], "names that are gone: keep the former ones, with a warning")


if __name__ == "__main__":
    if sys.argv[1:] == ["--record"]:
        NAMES.write_text("# Names that stay within a major version; release.py --record adds new ones.\n" + "".join(f"{name}\n" for name in sorted(stable_names())),
                         encoding="utf-8")
    else:
        unittest.main()
