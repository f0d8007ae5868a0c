"""Python packages that tests want and Debian does not have, in an environment below the build folder."""

import fcntl
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys

import program

SKIPPED = 77
SECONDS = 600  # for the packages to come


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


def left_to_full(reason):
    """Ends the test as skipped where tools/test runs those of every change; by hand and with --full it is run."""
    if program.LEFT_TO_FULL:
        skip(f"{reason}; tools/test --full runs it, or by hand")


def build_folder():
    """The folder in which the program was built: build/release/bin/orbearing -> build/release."""
    return pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1]


def installed(interpreter, packages):
    folder = interpreter.parents[1]
    mark = folder / "installed.txt"
    if mark.exists() and mark.read_text() == "\n".join(packages):
        return None
    shutil.rmtree(folder, ignore_errors=True)
    calls = (
        [sys.executable, "-m", "venv", str(folder)],
        [str(interpreter), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--only-binary=:all:",
         *packages],
    )
    for call in calls:
        try:
            done = subprocess.run(call, capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return f"{' '.join(packages)} did not come within {SECONDS} s"
        if done.returncode:
            text = (done.stderr.strip() or done.stdout.strip()).splitlines()
            return f"{' '.join(call[1:3])} failed: {text[-1] if text else 'no message'}"
    mark.write_text("\n".join(packages))
    return None


def environment(*packages):
    """Interpreter of an environment that has `packages` (kept for the next time), and why there is none, e.g. without
    a network."""
    name = hashlib.sha256("\n".join((sys.version, *packages)).encode()).hexdigest()[:12]
    interpreter = build_folder() / "venv" / name / "bin" / "python"
    interpreter.parents[2].mkdir(parents=True, exist_ok=True)
    with open(interpreter.parents[2] / f"{name}.lock", "w") as lock:  # tests run side by side
        fcntl.flock(lock, fcntl.LOCK_EX)
        return interpreter, installed(interpreter, packages)


def interpreter_with(*packages):
    """The interpreter alone; ends the test as skipped where there is none."""
    interpreter, reason = environment(*packages)
    if reason:
        skip(reason)
    return interpreter
