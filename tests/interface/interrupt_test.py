#!/usr/bin/env python3
"""Ctrl-C ends every long computation with exit code 1, long before its end; of a sweep it keeps the points that
are finished and no other, and --resume continues to the bytes of an undisturbed one."""

import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import program
from sweep_runs import PROGRAM, ROOT, manifest_points, run, snapshot

CASES = ROOT / "cases"
HANG = 120.0  # [s]  a hang guard: a second is promised, and printed here; each of these takes many minutes
BEFORE = 0.4  # [s]  of the processor until the signal: reading a case takes a tenth of it
# Long before its end at the time of the signal, whatever the machine.
LONG = "simulation.most_revolutions=2000", "simulation.observed_revolutions=1000"
IN_TIME = ("simulation.duration=100 s",)
FINE = "sweep.input.speed={from: 1000 rpm, to: 12000 rpm, step: 0.2 rpm}"
SCRATCH = ("signal.revolutions=3000",)


def case(name, file="case.yaml"):
    return str(CASES / name / file)


def settings(values):
    return [part for value in values for part in ("--set", value)]


def sweep(fidelity, *values, of="reducer_150kW"):
    return ["sweep", case(of), "--fidelity", fidelity, *settings(values)]


COMPUTATIONS = {
    "quasi-static": sweep("quasi-static", FINE),
    "dynamic": sweep("dynamic", *LONG),
    "dynamic, explicit steps": sweep("dynamic", "simulation.integrator=dopri5", *LONG),
    "dynamic, continued": [*sweep("dynamic", *LONG), "--continue", "up"],
    "dynamic, as built": sweep("dynamic", *LONG, of="reducer_150kW_as_built"),
    "co-simulated": sweep("co-simulated", *LONG),
    "one system": sweep("monolithic", *LONG),
    "one point of one system": ["run", *sweep("monolithic", *LONG)[1:]],
    "several sets": sweep("dynamic", *LONG, of="three_sets_150kW"),
    "gears": ["run", case("reducer_150kW"), "--gears", *settings(["gearset.dynamics.observed_periods=1000000"])],
    "crown": ["crown", case("reducer_150kW"), "--drops", "0 um : 20 um : 0.02 um"],
    "balls in time": ["run", case("deep_groove_motor"), *settings(IN_TIME)],
    "heated balls": ["run", case("deep_groove_motor"), *settings([*IN_TIME, "heat.enabled=true", "heat.surroundings=40 degC"])],
    "scratch": ["run", case("scratch_defect"), *settings(SCRATCH)],
    "scratch in motion": ["run", case("scratch_defect"), "--fidelity", "dynamic", *settings(SCRATCH)],
    "scratched planet": ["run", case("planet_scratch")],
    "signals": ["signals", case("scratch_defect"), "--vary", "defect.race=[none, outer, inner, ball]", *settings(SCRATCH)],
    "film": ["run", case("reynolds_point"), *settings([f"points=[{', '.join(['[2.5217 N, 0.19186 m/s, 0 rad/s]'] * 300)}]"])],
    "stiffness": ["stiffness", case("reducer_150kW_as_built"), *settings(["sweep.input.speed={from: 1000 rpm, to: 12000 rpm, step: 20 rpm}"])],
    "validation": ["validate"],
    "validation in motion": ["validate", "--motion", case("reducer_150kW")],
}


def interrupted(arguments, ready):
    """Exit code, words and seconds from the signal to the end; None where it ended before."""
    with subprocess.Popen([PROGRAM, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        ready(process)
        if process.poll() is not None:
            return process.returncode, process.stderr.read(), None
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        try:
            words = process.communicate(timeout=HANG)[1]
        except subprocess.TimeoutExpired:
            process.kill()
            raise
        return process.returncode, words, time.monotonic() - begin


class Interrupted(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def test_ends_long_before_its_end(self):
        only = os.environ.get("INTERRUPT_ONLY")
        for name, arguments in COMPUTATIONS.items():
            if only and name != only:
                continue
            with self.subTest(name):
                output = [] if arguments[0] == "validate" else ["-o", str(self.place / name)]
                code, words, seconds = interrupted([*arguments, "--quiet", *output], lambda process: program.wait_until_it_computes(process, BEFORE))
                print(f"{name}: {'ended before' if seconds is None else f'{seconds:.2f} s'}", flush=True)
                self.assertIsNotNone(seconds, f"it ended before the signal: {words}")
                self.assertEqual(code, 1, words)
                self.assertIn("interrupted", words)

    def test_a_parent_that_ignores_it_is_respected(self):
        """As `nohup` does for work in the background."""
        def ignore():
            signal.signal(signal.SIGINT, signal.SIG_IGN)

        with subprocess.Popen([PROGRAM, *sweep("quasi-static"), "--quiet", "-o", str(self.place / "ignored")], preexec_fn=ignore,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            while process.poll() is None:
                process.send_signal(signal.SIGINT)
                time.sleep(0.01)
            self.assertEqual((process.returncode, process.stderr.read()), (0, ""))


# Short runs: what is tested is what is kept, not the steady state.
CHEAP = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2", "simulation.length_error=2e-6 mm",
         "sweep.input.speed=[" + ", ".join(f"{speed} rpm" for speed in range(2500, 8500, 500)) + "]")
POINTS = 12  # so many that the sweep lasts when this process is told late of the first


class Resumed(unittest.TestCase):
    def test_bytes_of_an_undisturbed_sweep(self):
        for fidelity in ("dynamic",) if program.LEFT_TO_FULL else ("dynamic", "co-simulated", "monolithic"):
            with self.subTest(fidelity), tempfile.TemporaryDirectory() as place:
                call = [*sweep(fidelity, *CHEAP), "--quiet", "--grid-only", "--jobs", "1"]
                folder, whole = Path(place) / "folder", Path(place) / "whole"

                def one_is_done(process):
                    while process.poll() is None and not manifest_points(folder):
                        time.sleep(0.01)

                code, words, seconds = interrupted([*call, "-o", str(folder)], one_is_done)
                self.assertIsNotNone(seconds, words)
                self.assertEqual(code, 1, words)
                kept = manifest_points(folder)
                self.assertIn(f"interrupted with {len(kept)} of {POINTS} points done; continue with --resume", words)
                self.assertTrue(0 < len(kept) < POINTS, kept)
                self.assertNotIn("interrupted", (folder / "manifest.jsonl").read_text())
                self.assertEqual(len(list((folder / "points").iterdir())), len(kept))
                self.assertFalse((folder / "sweep.csv").exists())
                self.assertEqual(run([PROGRAM, *call, "--resume", "-o", str(folder)]).returncode, 0)
                self.assertEqual(run([PROGRAM, *call, "-o", str(whole)]).returncode, 0)
                once, again = ({Path(path).relative_to(where): content for path, content in snapshot(where).items()}
                               for where in (whole, folder))
                self.assertEqual(sorted(once), sorted(again))
                self.assertEqual([path for path in once if once[path] != again[path]], [])


if __name__ == "__main__":
    unittest.main()
