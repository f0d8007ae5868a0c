#!/usr/bin/env python3
"""The Windows library of our FMUs under wine64 beside that for Linux: same steps, same results.

Needs ORBEARING and ORBEARING_FMU_LOADER (tests/fmu/loader.cpp, also built for Windows). Skipped where wine64 or the
Windows library is missing.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
import zipfile

SKIPPED = 77
SECONDS = 600
CASE = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"], "cases", "reducer_150kW", "case.yaml")
WINDOWS = pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1] / "lib" / "orbearing" / "fmu" / "win64"
# [-] Other instructions and another C library round unlike; 0.3 ms is too short for that to grow (chaotic beyond
# half a millisecond).
NEAR = 1e-9
STEPS, STEP = 30, 1e-5
INPUTS = {"bearing": {"planet.displacement.x": 2e-6, "planet.displacement.y": 25e-6},
          "gearset": {"planet[1].force.y": -1900.0}}
OUTPUTS = {"bearing": ("force.x", "force.y", "moment", "cage.speed", "roller[1].inner_load", "life_used"),
           "gearset": ("planet[1].displacement.y", "planet[2].speed", "planet[3].sun_mesh_force")}


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def arguments_of(file, model, folder):
    with zipfile.ZipFile(file) as archive:
        archive.extractall(folder)
        root = xml.fromstring(archive.read("modelDescription.xml"))
    references = {v.get("name"): v.get("valueReference") for v in root.iter("ScalarVariable")}
    inputs = [f"{references[name]}={value!r}" for name, value in INPUTS[model].items()]
    return [root.get("guid"), str(STEPS), str(STEP), *inputs, *(references[name] for name in OUTPUTS[model])]


def rows_of(command, environment):
    done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, env=environment)
    if done.returncode:
        sys.exit(f"{command[0]}: {done.stderr}")
    rows = {line.split()[0]: [float(word) for word in line.split()[1:]]
            for line in re.findall(r"^fmi[23] .*$", done.stdout, re.MULTILINE)}
    assert set(rows) == {"fmi2", "fmi3"}, done.stdout + done.stderr
    return rows


def compare(model, folder, wine):
    file = folder / f"{model}.fmu"
    subprocess.run([os.environ["ORBEARING"], "fmu", CASE, "-o", file, "--model", model, "--windows", "--quiet"], check=True)
    unpacked = folder / f"unpacked {model}"
    arguments = arguments_of(file, model, unpacked)
    here = dict(os.environ, WINEPREFIX=str(folder / "wine"), WINEDEBUG="-all", DISPLAY="")
    library = unpacked / "binaries" / "{}" / f"orbearing_{model}"
    linux = rows_of([os.environ["ORBEARING_FMU_LOADER"], str(library).format("linux64") + ".so",
                     str(unpacked / "resources"), *arguments], here)
    windows = rows_of([wine, str(WINDOWS / "fmu_loader.exe"), "Z:" + str(library).format("win64") + ".dll",
                       "Z:" + str(unpacked / "resources"), *arguments], here)
    worst = max(abs(a - b) / abs(a) for version in linux for a, b in zip(linux[version], windows[version]))
    assert linux["fmi2"] == linux["fmi3"] and windows["fmi2"] == windows["fmi3"]
    print(json.dumps({"model": model, "largest relative difference": worst}))
    assert worst < NEAR, (linux, windows)


def main():
    wine = shutil.which("wine64") or shutil.which("wine") or shutil.which("/usr/lib/wine/wine64")
    if wine is None:
        skip("no wine64")
    if not (WINDOWS / "orbearing.dll").exists():
        skip("no Windows library was built")
    with tempfile.TemporaryDirectory(prefix="wine ", ignore_cleanup_errors=True) as folder:
        for model in ("bearing", "gearset"):
            compare(model, pathlib.Path(folder), wine)


if __name__ == "__main__":
    main()
