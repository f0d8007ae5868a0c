#!/usr/bin/env python3
"""Progress within a motion, its estimate before the start, and --budget.

Needs ORBEARING and ORBEARING_SOURCE_DIR.
"""

import json
import os
import pathlib
import pty
import re
import subprocess
import tempfile
import threading
import unittest

from program import CASES, REDUCER, SECONDS, answer, run, settings

BALLS = CASES / "deep_groove_motor" / "case.yaml"
STEADY_MESHES = "gearset.mesh_variation=false"  # one run of a bearing alone: short, and its steps are known
TWO_SPEEDS = (STEADY_MESHES, "sweep.input.speed=[6000 rpm, 12000 rpm]")
LINE = re.compile(r"^(?:run (\d) of at most 8: )?([\d.e-]+) s of ([\d.e-]+) s in motion, (\d+) %(?:, (\d+:\d\d) to go)?$")


def on_terminal(*arguments):
    """What a command writes on a terminal as standard error, line by line of what is written over."""
    ours, theirs = pty.openpty()
    written = []

    def read():
        try:
            while part := os.read(ours, 4096):
                written.append(part)
        except OSError:  # the end of a terminal
            pass

    reader = threading.Thread(target=read)
    reader.start()
    done = subprocess.run([os.environ["ORBEARING"], *map(str, arguments)], stdout=subprocess.PIPE, stderr=theirs, timeout=SECONDS, check=False)
    os.close(theirs)
    reader.join()
    os.close(ours)
    assert done.returncode == 0, written
    return [line for line in b"".join(written).decode().split("\r\x1b[K") if line.strip()], done.stdout


def moving(*values, command="run", options=()):
    return command, REDUCER, "--fidelity", "dynamic", *options, *settings(values)


def resolved(folder):
    return (pathlib.Path(folder) / "case.resolved.yaml").read_text()


class Progress(unittest.TestCase):
    def test_a_terminal_shows_how_far_the_motion_is(self):
        lines, _ = on_terminal(*moving(STEADY_MESHES, "simulation.observed_revolutions=150", options=("--json",)))
        shown = [LINE.match(line) for line in lines if "in motion" in line]
        self.assertGreater(len(shown), 3, lines)
        self.assertTrue(all(shown), lines)
        times, totals, shares = ([float(one[i]) for one in shown] for i in (2, 3, 4))
        self.assertEqual(times, sorted(times))
        # Two revolutions on the way and 150 for the means, of 15.223 ms each.
        self.assertAlmostEqual(totals[-1], 152 * 15.223e-3, delta=0.01 * totals[-1])
        for time, total, share in zip(times, totals, shares):
            self.assertAlmostEqual(share, 100 * time / total, delta=1.0)
        self.assertGreater(shares[-1], 50.0)
        self.assertIsNotNone(shown[-1][5], "time to go")

    def test_runs_of_gears_and_bearing_in_turn_are_counted(self):
        lines, _ = on_terminal(*moving("simulation.observed_revolutions=20", options=("--json",)))
        runs = [int(one[1]) for one in map(LINE.match, lines) if one and one[1]]
        self.assertEqual(runs, sorted(runs))
        self.assertGreater(runs[-1], 1, lines)

    def test_a_run_of_balls_shows_its_time(self):
        for duration in ("0.3", "1.2", "4.8", "19.2"):  # as long as a fast machine is done before it says anything
            lines, _ = on_terminal("run", BALLS, "--json", *settings((f"simulation.duration={duration} s",)))
            if any(re.match(rf"^\d\.\d+ s of {re.escape(duration)} s in motion, \d+ %, \d:\d\d to go$", line) for line in lines):
                return
        self.fail(lines)

    def test_quiet_and_files_show_nothing(self):
        quiet = moving(STEADY_MESHES, options=("--json", "--quiet"))
        self.assertEqual(on_terminal(*quiet)[0], [])
        self.assertEqual(run(*moving(STEADY_MESHES, options=("--json",))).stderr, "")

    def test_what_is_shown_changes_no_number(self):
        shown, quiet = moving(options=("--json",)), moving(options=("--json", "--quiet"))
        self.assertEqual(json.loads(on_terminal(*shown)[1]), json.loads(run(*quiet).stdout))


class Estimate(unittest.TestCase):
    def estimate_of(self, revolutions):
        rows = {row["path"]: row for row in answer("check", REDUCER, STEADY_MESHES, f"simulation.observed_revolutions={revolutions}")["derived"]}
        row = rows["simulation.processor_time"]
        self.assertEqual(row["unit"], "s")
        return row["value"]

    def test_check_lists_it(self):
        # Two revolutions come before the means.
        self.assertAlmostEqual(self.estimate_of(198) / self.estimate_of(18), 10.0, delta=0.2)

    def test_it_is_less_exact_of_slow_motion(self):
        """Below some 400 rpm the reducer's rollers pass slowly against their vibrations."""
        for rpm, factor in ((100, 4), (1000, 2)):
            rows = {row["path"]: row for row in answer("check", REDUCER, f"input.speed={rpm} rpm", "input.power=2.5 kW")["derived"]}
            self.assertEqual(rows["simulation.processor_time"]["meaning"], f"estimate of a run with --fidelity dynamic, within a factor of {factor}")

    def first_line(self, *options):
        command = [os.environ["ORBEARING"], *map(str, moving("simulation.observed_revolutions=3000", options=("--json", *options)))]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            timer = threading.Timer(5.0 if options else SECONDS, process.terminate)
            timer.start()
            line = process.stderr.readline()
            timer.cancel()
            process.terminate()
        return line

    def test_a_long_run_states_it_before_the_start(self):
        self.assertRegex(self.first_line(), r"^estimate: about [\d.]+ min for 1 point in motion \([\d.]+ min of processor time on 1 thread\), within a factor of 2\n$")

    def test_not_with_quiet(self):
        self.assertNotIn("estimate", self.first_line("--quiet"))


class Budget(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)

    def sweep(self, name, *options, values=TWO_SPEEDS):
        result = run(*moving(*values, command="sweep", options=("--grid-only", "-o", self.place / name, *options)))
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def table(self, name):
        return (self.place / name / "sweep.csv").read_bytes()

    def test_one_that_is_met_changes_nothing(self):
        self.sweep("free")
        self.assertEqual(self.sweep("met", "--budget", "60s").stderr, "")
        self.assertEqual(self.table("met"), self.table("free"))
        self.assertEqual(resolved(self.place / "met"), resolved(self.place / "free"))

    def test_a_small_one_chooses_fewer_revolutions_and_keeps_the_choice(self):
        budget = ("--budget", "130 ms")
        said = self.sweep("small", *budget, "--jobs", "1").stderr
        found = re.match(r"^--budget 130 ms: simulation.observed_revolutions (\d) instead of 10 \(.* of processor time instead of .*\); scatter of the life ([\d.]+) %"
                         r" \(0\.27 % with the windows as stated\)\n$", said)
        self.assertTrue(found, said)
        self.assertAlmostEqual(float(found[2]), 0.85 / int(found[1]) ** 0.5, delta=0.006)
        text = resolved(self.place / "small")
        self.assertIn(f"observed_revolutions: {found[1]}\n", text)
        self.assertIn('  simulation.observed_revolutions: "chosen by --budget from the number of steps', text)
        # The same whatever the threads and shards, and resumed.
        self.sweep("threads", *budget, "--jobs", "2")
        self.assertEqual(self.table("threads"), self.table("small"))
        self.assertEqual(self.sweep("quiet", *budget, "--quiet").stderr, "")
        self.assertEqual(self.table("quiet"), self.table("small"))
        self.sweep("small", *budget, "--resume")
        other = run(*moving(*TWO_SPEEDS, command="sweep", options=("--grid-only", "-o", self.place / "small", "--resume")))
        self.assertEqual(other.returncode, 2, other.stderr)
        # The resolved case is that computation.
        again = run("sweep", self.place / "small" / "case.resolved.yaml", "--fidelity", "dynamic", "--grid-only", "-o", self.place / "again")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(self.table("again"), self.table("small"))

    def test_errors_of_steps_grow_last(self):
        said = self.sweep("large", "--budget", "0.9 s", values=("sweep.input.speed=[4000 rpm, 6000 rpm]",)).stderr
        self.assertRegex(said, r"simulation\.length_error 1e-6 mm instead of 2e-7 mm .* and up to 2 % by the larger error of steps\n$")
        self.assertIn("  length_error: 1e-6 mm\n", resolved(self.place / "large"))

    def test_one_that_cannot_be_met_is_refused_before_anything_is_written(self):
        result = run(*moving(*TWO_SPEEDS, command="sweep", options=("-o", self.place / "none", "--budget", "1 ms")))
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^--budget: found 1 ms; required: [\d.]+ s of processor time or more by estimate, with the shortest windows: 3 revolutions")
        self.assertFalse((self.place / "none").exists())


if __name__ == "__main__":
    unittest.main()
