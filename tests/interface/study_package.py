"""The compiled package and the program, for tests of studies."""

import os
import pathlib
import subprocess
import sys

from virtual_environment import build_folder, skip

ROOT = pathlib.Path(os.environ["ORBEARING_SOURCE_DIR"])
CASE = ROOT / "cases" / "reducer_150kW" / "case.yaml"
PROGRAM = os.environ["ORBEARING"]
SECONDS = 240


def require_package():
    """Makes the package beside the program the one that is imported; ends the test as skipped where it has no compiled part."""
    package = build_folder() / "python"
    if not list((package / "orbearing").glob("_core*")):
        skip(f"{package} holds no compiled part of the package; it is built where pybind11 is")
    sys.path.insert(0, str(package))
    os.environ["PYTHONPATH"] = os.pathsep.join((str(package), str(pathlib.Path(__file__).parent)))  # for processes that tests start


def call(*arguments):
    return [PROGRAM, "study", str(CASE), *map(str, arguments)]


def run(*arguments):
    return subprocess.run(call(*arguments), capture_output=True, text=True, timeout=SECONDS, check=False)
