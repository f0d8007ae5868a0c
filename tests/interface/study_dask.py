#!/usr/bin/env python3
"""A study on the workers of a Dask cluster: workers and scheduler killed at any moment, the same store as by one process.

KILLS (default 3; 20 with ORBEARING_FULL=yes) sets how many workers are killed, SEED the moments.
"""

import importlib.util
import logging
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from unittest import mock

import program
from virtual_environment import skip

orbearing = program.package()
os.environ["PYTHONPATH"] = sys.path[0]  # of the workers
if importlib.util.find_spec("distributed") is None:
    skip("Dask is missing; on Debian install python3-distributed")

from distributed import Client, LocalCluster  # noqa: E402

from orbearing.studies.executors import Cluster, Lost, compute_portion  # noqa: E402
from orbearing.studies.folder import DATASET, finished_counts  # noqa: E402
from orbearing.studies.plan import Portion  # noqa: E402

CASE = str(program.REDUCER)
FULL = os.environ.get("ORBEARING_FULL") == "yes"
KILLS = int(os.environ.get("KILLS", "20" if FULL else "3"))
SEED = int(os.environ.get("SEED", str(time.time_ns() % 1_000_000)))
SAMPLES = 8192 if FULL else 512
RANGE = {"bearing.radial_clearance": {"from": "0 um", "to": "40 um"}}
PATIENCE = 3  # [s] of a client for its scheduler


def study(folder, executor, **options):
    return orbearing.study(CASE, RANGE, sampler="sobol", samples=SAMPLES, executor=executor, output=folder, **{"progress": False, **options})


class LateWorkers(Cluster):
    """A cluster whose workers come after it has been asked so many times."""

    def __init__(self, times):
        super().__init__(client=None)
        self.times = times

    @property
    def lanes(self):
        self.times -= 1
        return max(0, -self.times)


class Waiting(unittest.TestCase):
    def test_workers_may_come_late(self):
        cluster = LateWorkers(3)
        cluster._await_workers()
        self.assertLess(cluster.times, 0)

    def test_a_cluster_without_workers_is_lost(self):
        with mock.patch("orbearing.studies.executors.AT_FIRST_SECONDS", 0.25):
            with self.assertRaisesRegex(Lost, "has had no worker for 0 s; start workers, then continue with --resume"):
                LateWorkers(1000)._await_workers()


class Killer(threading.Thread):
    """Kills workers of a local cluster at random moments once the first points are there, as a failing machine or as a queue whose time is over."""

    def __init__(self, cluster, seconds):
        super().__init__(daemon=True)
        self.killed, self.begun, self.ended = 0, threading.Event(), threading.Event()
        self._cluster, self._mean, self._chance = cluster, seconds / (KILLS + 1), random.Random(SEED)

    def run(self):
        self.begun.wait()
        while self.killed < KILLS and not self.ended.wait(self._chance.uniform(0.0, 2.0 * self._mean)):
            living = [nanny.process.process.pid for nanny in self._cluster.workers.values() if nanny.process and nanny.process.process]
            living = [pid for pid in living if pid]
            if living:
                os.kill(self._chance.choice(living), self._chance.choice((signal.SIGKILL, signal.SIGTERM)))
                self.killed += 1


class Sampled:
    """An engine whose results are whether the profiler of its worker is running meanwhile."""

    def compute(self, ids, settings, values, jobs):
        from distributed import get_worker

        time.sleep(0.1)  # the event loop stops the profiler
        return get_worker().periodic_callbacks["profile"].is_running()


def profilers(dask_worker):
    return dask_worker.periodic_callbacks["profile"].is_running()


class OnWorkers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.place = pathlib.Path(place.name)
        begin = time.monotonic()
        study(cls.place / "here", "threads")
        cls.seconds = time.monotonic() - begin
        cls.whole = (cls.place / "here" / DATASET).read_bytes()

    def check(self, folder):
        self.assertEqual(set(finished_counts(folder)), {1}, "a point was lost or came twice")
        self.assertTrue((folder / DATASET).read_bytes() == self.whole, f"another store, SEED={SEED}")

    @unittest.skipIf(program.LEFT_TO_FULL, "left to tools/test --full")
    def test_workers_killed(self):
        with LocalCluster(n_workers=4 if FULL else 2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            killer = Killer(cluster, self.seconds)
            killer.start()
            begin, first = time.monotonic(), []

            def seen(done, points):
                if done:
                    first.append(time.monotonic() - begin)
                    killer.begun.set()

            study(self.place / "killed", client, progress=seen)
            killer.ended.set()
            killer.join()
        self.check(self.place / "killed")
        self.assertGreater(killer.killed, 0)
        print(f"{killer.killed} workers killed, SEED={SEED}; first result after {first[0]:.1f} s, all after {first[-1]:.1f} s, {self.seconds:.1f} s by threads",
              file=sys.stderr)

    @unittest.skipIf(program.LEFT_TO_FULL, "two more clusters: tools/test --full, or by hand")
    def test_no_stack_is_sampled_while_the_core_computes(self):
        portion = Portion(None, (), None)
        for kind in ({"n_workers": 1, "threads_per_worker": 2}, {"n_workers": 2, "threads_per_worker": 1, "processes": False}):
            with self.subTest(kind), LocalCluster(dashboard_address=None, **kind) as cluster, Client(cluster) as client:
                self.assertEqual(set(client.run(profilers).values()), {True})
                self.assertEqual(client.gather([client.submit(compute_portion, Sampled(), portion, pure=False) for _ in range(4)]), [False] * 4)
                self.assertEqual(set(client.run(profilers).values()), {True}, "it goes on after the last portion")

    @unittest.skipIf(program.LEFT_TO_FULL, "a third cluster; workers are killed every day: tools/test --full, or by hand")
    def test_scheduler_killed(self):
        log = open(self.place / "scheduler.log", "w")
        self.addCleanup(log.close)
        file = self.place / "scheduler.json"
        module = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(file)]
        scheduler = subprocess.Popen(module, stdout=log, stderr=log)
        worker = subprocess.Popen([sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", str(file), "--nthreads", "2", "--no-dashboard",
                                   "--no-nanny", "--death-timeout", "20"], stdout=log, stderr=log)
        folder = self.place / "lost"
        try:
            # Stopped at another moment each time: after the first, second or third portion of results.
            after = random.Random(SEED).randint(1, 6)
            seen = []

            def look(done, points):
                seen.append(done)
                if len(seen) == after + 1:
                    scheduler.kill()

            with Client(scheduler_file=str(file), timeout=20) as client:
                client._timeout = PATIENCE
                with self.assertRaises(Lost):
                    study(folder, client, progress=look)
        finally:
            for process in (scheduler, worker):
                process.kill()
                process.wait()
        part = orbearing.open_study(folder)
        self.assertTrue(0 < part.missing < part.points, part)
        begun = part.points - part.missing
        seen_first = []
        study(folder, "threads", resume=True, progress=lambda done, points: seen_first.append(done))
        self.assertEqual(seen_first[0], begun, "what was finished is not computed again")
        self.check(folder)

    def test_no_scheduler(self):
        result = program.run("study", CASE, "-o", self.place / "none", "--vary", "bearing.rollers=[14, 15]", "--scheduler", "tcp://127.0.0.1:9")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("where no scheduler answers", result.stderr)
        self.assertFalse((self.place / "none").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
