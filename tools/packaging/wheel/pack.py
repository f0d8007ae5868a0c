#!/usr/bin/env python3
"""Writes a wheel for every Python from 3.9 on: pack.py BUILD FOLDER.

BUILD is where tools/wheel built the libraries. What the wheel is called, requires and offers is in pyproject.toml. Prints the name of the file.
The same files give the same bytes.
"""
import base64
import hashlib
import re
import sys
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
TAG = "py3-none-manylinux_2_28_x86_64"
PACKAGE = {".py", ".css", ".js", ".mplstyle", ".typed"}
FIRST_DAY = (1980, 1, 1, 0, 0, 0)


def version() -> str:
    return re.search(r"project\(Orbearing VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def files_below(folder: Path, to: str):
    for file in sorted(folder.rglob("*")):
        if file.is_file() and "__pycache__" not in file.parts:
            yield f"{to}/{file.relative_to(folder).as_posix()}", file.read_bytes()


def metadata(project: dict) -> str:
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version()}", f"Summary: {project['description']}",
             "License: BSD-3-Clause", f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {one}" for one in project["dependencies"]]
    for extra, packages in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {one}; extra == "{extra}"' for one in packages]
    readme = (ROOT / project["readme"]).read_text(encoding="utf-8")
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", readme])


def content(build: Path):
    """Names and bytes of all files but the list of them."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    yield from ((name, data) for name, data in files_below(ROOT / "python" / "orbearing", "orbearing") if Path(name).suffix in PACKAGE)
    yield "orbearing/lib/liborbearing.so", (build / "lib" / "liborbearing.so").resolve().read_bytes()
    for name, data in files_below(build / "lib" / "orbearing" / "fmu", "orbearing/lib/orbearing/fmu"):
        if name.endswith((".so", ".dll")):
            yield name, data
    yield from files_below(ROOT / "cases", "orbearing/share/orbearing/cases")
    yield from files_below(ROOT / "page" / "web", "orbearing/share/orbearing/page")
    info = f"orbearing-{version()}.dist-info"
    yield f"{info}/METADATA", metadata(project).encode()
    yield f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: orbearing\nRoot-Is-Purelib: false\nTag: {TAG}\n".encode()
    scripts = "".join(f"{name} = {target}\n" for name, target in project["scripts"].items())
    yield f"{info}/entry_points.txt", f"[console_scripts]\n{scripts}".encode()
    yield f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes()
    yield from files_below(build / "licences", f"{info}/licences")


def pack(build: Path, folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("orbearing-*.whl"):
        old.unlink()
    wheel = folder / f"orbearing-{version()}-{TAG}.whl"
    record = ""
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        def add(name: str, data: bytes) -> None:
            entry = zipfile.ZipInfo(name, FIRST_DAY)
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o100644 << 16
            archive.writestr(entry, data)

        for name, data in content(build):
            add(name, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record += f"{name},sha256={digest},{len(data)}\n"
        name = f"orbearing-{version()}.dist-info/RECORD"
        add(name, f"{record}{name},,\n".encode())
    return wheel


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    print(pack(Path(sys.argv[1]), Path(sys.argv[2])))
