"""Words of sources and documents are spelt as codespell has them, but for those of words.txt.

Exit code 77 (skipped) where codespell is missing (Debian: codespell).
"""
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
HERE = pathlib.Path(__file__).parent
PARTS = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "app", "bearing", "benchmarks", "cases", "cmake", "coupling", "docs", "gearset", "include",
         "mechanics", "page", "python", "tests", "tools")
KINDS = {".md", ".py", ".cpp", ".hpp", ".yaml", ".js", ".css", ".html", ".sh", ".txt", ".cmake", ".pytxt", ".cff", ".bib", ""}
FOREIGN = {"words.txt", "not_yet.list"}  # the list itself; words that are no words


def files():
    for part in PARTS:
        path = ROOT / part
        for file in [path] if path.is_file() else sorted(path.rglob("*")):
            if file.is_file() and not file.is_symlink() and file.suffix in KINDS and file.name not in FOREIGN and "__pycache__" not in file.parts:
                yield str(file)


def misspelt(paths):
    known = [line for line in (HERE / "words.txt").read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    # -q 3: no word on encodings and binary files
    done = subprocess.run(["codespell", "-q", "3", "-L", ",".join(known), *paths], capture_output=True, text=True, check=False)
    return done.stdout.splitlines()


def main():
    if shutil.which("codespell") is None:
        print("skipped: codespell is missing (Debian: codespell)")
        return 77
    paths = list(files())
    assert len(paths) > 1000, f"only {len(paths)} files were found"
    found = misspelt(paths)
    print("\n".join(found) or f"{len(paths)} files")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
