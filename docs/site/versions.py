"""Versions of the site: the present one, and releases in its folder `versions`, each as its own tools/site built it.

    versions.py SITE              writes SITE/versions.js, and one for each release, from which pages offer the other versions
    versions.py SITE --missing    prints the tags of releases whose pages SITE does not have, newest first

A release is a tag of git such as v1.2.0.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = "versions"
_TAG = re.compile(r"v(\d+)\.(\d+)\.(\d+)")


def _order(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def present() -> str:
    """The version that these sources state."""
    return re.search(r"^project\(Orbearing VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)[1]


def releases(repository: Path = ROOT) -> list[str]:
    """Versions of the tags, newest first; none where there is no git."""
    try:
        done = subprocess.run(["git", "-C", repository, "tag", "--list", "v*"], capture_output=True, text=True, check=False)
    except OSError:
        return []
    return sorted((tag[1:] for tag in done.stdout.split() if _TAG.fullmatch(tag)), key=_order, reverse=True)


def built(site: Path) -> list[str]:
    """Releases whose pages are in the site, newest first."""
    folders = (folder.name for folder in (site / FOLDER).glob("*") if (folder / "docs" / "index.html").exists())
    return sorted((name for name in folders if _TAG.fullmatch(f"v{name}")), key=_order, reverse=True)


def missing(site: Path, repository: Path = ROOT) -> list[str]:
    there = built(site)
    return [f"v{version}" for version in releases(repository) if version not in there]


def write(site: Path) -> None:
    """Into each version the list of all, with the way to their first pages."""
    names = built(site)
    entries = [{"name": f"{present()} (present)", "page": "docs/index.html"}]
    entries += [{"name": name, "page": f"{FOLDER}/{name}/docs/index.html"} for name in names]
    for index, (folder, up) in enumerate([(site, ""), *((site / FOLDER / name, "../../") for name in names)]):
        listed = [{**entry, "page": up + entry["page"], "here": position == index} for position, entry in enumerate(entries)]
        (folder / "versions.js").write_text(f"window.orbearingVersions = {json.dumps(listed)};\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[2] == "--missing":
        print("\n".join(missing(Path(sys.argv[1]))))
    elif len(sys.argv) == 2:
        write(Path(sys.argv[1]))
    else:
        raise SystemExit(__doc__)
