#!/usr/bin/env python3
"""Puts the page with engine B together as a folder of static files: assemble.py BUILD FOLDER.

BUILD is where engine_wasm.js and engine_wasm.wasm were built. Any file server shows the folder.
"""
import json
import re
import shutil
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]


def template(file):
    """A case to begin from; its first line is "# TITLE: PURPOSE"."""
    text = file.read_text(encoding="utf-8")
    title, purpose = text.splitlines()[0].removeprefix("# ").split(": ", 1)
    return {"name": file.stem, "title": title, "purpose": purpose, "text": text}


def template_names():
    """In the order in which the program offers them, which app/interface/templates.cpp states."""
    text = (SOURCE / "app" / "interface" / "templates.cpp").read_text(encoding="utf-8")
    return re.findall(r'"([\w-]+)"', re.search(r"& template_names\(\) \{(.*?)\}", text, re.S)[1])


def assemble(build, folder):
    shutil.rmtree(folder, ignore_errors=True)
    pages = SOURCE / "page" / "web"
    web = folder / "web"
    shutil.copytree(pages, web)
    if (web / "index.html").exists():
        (web / "index.html").rename(folder / "index.html")
    for name in ("engine_wasm.js", "engine_wasm.wasm"):
        shutil.copy(build / name, web)
    (web / "schema").mkdir()
    for which in ("case", "result"):
        shutil.copy(SOURCE / "cases" / f"{which}.schema.json", web / "schema" / f"{which}.json")
    templates = [template(SOURCE / "cases" / "templates" / f"{name}.yaml") for name in template_names()]
    (web / "templates.json").write_text(json.dumps(templates, ensure_ascii=False), encoding="utf-8")


if __name__ == "__main__":
    assemble(Path(sys.argv[1]), Path(sys.argv[2]))
