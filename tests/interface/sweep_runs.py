"""What the tests of sweeps share: the program, a case with a fine speed grid, folders and their manifests."""

import json
import os
import signal
import subprocess
from pathlib import Path

ROOT = Path(os.environ.get("ORBEARING_SOURCE_DIR", Path(__file__).resolve().parents[2]))
PROGRAM = os.environ.get("ORBEARING", str(ROOT / "build" / "release" / "bin" / "orbearing"))
CASE = ROOT / "cases" / "reducer_150kW" / "case.yaml"
STEP = os.environ.get("FINE_STEP", "50 rpm")  # tools/test --full: 2 rpm
FINE = f"sweep.input.speed={{from: 1000 rpm, to: 12000 rpm, step: {STEP}}}"
COARSE = "sweep.input.speed={from: 1000 rpm, to: 12000 rpm, step: 500 rpm}"
# A parent that ignores SIGINT, as nohup does, would pass that on to every program that is started here.
signal.signal(signal.SIGINT, signal.default_int_handler)
WAIT = 600  # [s] far beyond any run here; a program that hangs must not hang the tests


def sweep_call(folder, *options, grid=COARSE):
    return [PROGRAM, "sweep", str(CASE), "--set", grid, "--quiet", "-o", str(folder), *options]


def sweep(folder, *options, grid=COARSE):
    return run(sweep_call(folder, *options, grid=grid))


def run(call):
    return subprocess.run(call, capture_output=True, text=True, timeout=WAIT, check=False)


def table(folder):
    return (Path(folder) / "sweep.csv").read_bytes()


def manifest_points(folder):
    """Numbers of the points in the manifest, in its order; a torn last line is left out."""
    file = Path(folder) / "manifest.jsonl"
    text = file.read_bytes() if file.exists() else b""
    return [json.loads(line)["point"] for line in text.split(b"\n")[1:-1] if line.strip()]


def point_files(folder):
    """Identity of each finished point's file: a file written again is another one."""
    files = {point: Path(folder) / "points" / f"{point:05d}.nc" for point in manifest_points(folder)}
    return {point: (file.stat().st_ino, file.stat().st_mtime_ns) for point, file in files.items()}


def snapshot(folder):
    """Every path below a folder, with its content."""
    return {str(path): path.read_bytes() if path.is_file() else b"" for path in Path(folder).rglob("*")}
