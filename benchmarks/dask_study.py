#!/usr/bin/env python3
"""How fast studies are: 200 sweeps of 12 speeds in one call, and Dask's workers beside threads of one process.

    ORBEARING=build/release/bin/orbearing benchmarks/dask_study.py [--static N] [--dynamic N] [--kills N] [--workers N] [--revolutions N]
        [--speeds RPM ...] [--set PATH=VALUE ...]

N points each; prints one line of JSON for each comparison: seconds, the ratio of throughputs (threads / Dask in time, and in time of the processors), seconds to the first result, workers
killed, how often each point stands in the journal, and whether both stores are the same to the last byte. Needs Dask (Debian: python3-distributed).
"""

import argparse
import json
import logging
import os
import pathlib
import random
import signal
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(pathlib.Path(os.environ.get("ORBEARING", ROOT / "build" / "release" / "bin" / "orbearing")).resolve().parents[1] / "python"))
os.environ["PYTHONPATH"] = sys.path[0]  # of the workers

CASE = ROOT / "cases" / "reducer_150kW" / "case.yaml"
SPEEDS = 12
THREADS = 2


def said(**numbers):
    print(json.dumps({key: round(value, 3) if isinstance(value, float) else value for key, value in numbers.items()}), flush=True)


def cpu_seconds(client=None):
    """Of this process; with a client also of its workers. Work beside on the same machine blurs it less than the time on the clock."""
    return time.process_time() + (sum(client.run(time.process_time).values()) if client else 0.0)


def sweeps(count=200):
    """One call from a case to an xarray Dataset."""
    import orbearing

    begin, cpu = time.monotonic(), cpu_seconds()
    case = orbearing.load(CASE)
    table = orbearing.study(case, {"bearing.radial_clearance": {"from": "0 um", "to": "40 um", "count": count}}, progress=False).to_xarray()
    said(what=f"{count} sweeps of {SPEEDS} quasi-static speeds into one Dataset", seconds=time.monotonic() - begin, cpu_s=cpu_seconds() - cpu, points=int(table.life_h.size))


class Killer(threading.Thread):
    """Kills workers at random moments."""

    def __init__(self, cluster, kills, seconds, seed=1):
        super().__init__(daemon=True)
        self.killed, self.ended = 0, threading.Event()
        self._cluster, self._kills, self._mean, self._chance = cluster, kills, 0.6 * seconds / (kills + 1), random.Random(seed)

    def run(self):
        while self.killed < self._kills and not self.ended.wait(self._chance.uniform(0.0, 2.0 * self._mean)):
            living = [nanny.process.process.pid for nanny in self._cluster.workers.values() if nanny.process and nanny.process.process]
            living = [pid for pid in living if pid]
            if living:
                os.kill(self._chance.choice(living), signal.SIGKILL)
                self.killed += 1


def beside_threads(points, fidelity, workers, kills, settings):
    """The same study by threads and by workers, and by workers that are killed; `settings` change the case."""
    import orbearing
    from distributed import Client, LocalCluster
    from orbearing.studies.folder import DATASET, finished_counts

    samples = max(1, round(points / len(settings.get("sweep.input.speed", range(SPEEDS)))))
    ranges = {"bearing.radial_clearance": {"from": "0 um", "to": "40 um"}}

    def timed(folder, executor, **options):
        first = []
        begin = time.monotonic()
        orbearing.study(orbearing.load(CASE).copy(settings), ranges, sampler="lhs", samples=samples, fidelity=fidelity, executor=executor, output=folder,
                        progress=lambda done, _: first.append(time.monotonic() - begin) if done else None, **options)
        return time.monotonic() - begin, first[0]

    with tempfile.TemporaryDirectory() as name:
        place = pathlib.Path(name)
        cpu = cpu_seconds()
        threads, _ = timed(place / "threads", "threads", jobs=THREADS)
        threads_cpu = cpu_seconds() - cpu
        whole = (place / "threads" / DATASET).read_bytes()
        for killed_on_the_way in dict.fromkeys((0, kills)):
            with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
                cpu = cpu_seconds(client)
                killer = Killer(cluster, killed_on_the_way, threads)
                killer.start()
                folder = place / f"workers{killed_on_the_way}"
                seconds, first = timed(folder, client)
                killer.ended.set()
                killer.join()
                # Killed ones take their count with them.
                cpu_ratio = None if killer.killed else threads_cpu / (cpu_seconds(client) - cpu)
            counts = finished_counts(folder)
            said(what=f"{len(counts)} {fidelity} points", threads=THREADS, threads_s=threads, workers=workers, workers_s=seconds, throughput_ratio=threads / seconds, cpu_ratio=cpu_ratio,
                 first_result_s=first, killed=killer.killed, times_in_journal=[int(counts.min()), int(counts.max())],
                 same_bytes=(folder / DATASET).read_bytes() == whole)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--static", type=int, default=100_000, help="quasi-static points; 0: none")
    options.add_argument("--dynamic", type=int, default=2000, help="points in motion; 0: none")
    options.add_argument("--kills", type=int, default=20, help="workers killed; 0: none")
    options.add_argument("--workers", type=int, default=4)
    options.add_argument("--revolutions", type=int, help="of the carrier that points in motion are observed for; default: the case's")
    options.add_argument("--speeds", nargs="+", help="of points in motion; default: the case's")
    options.add_argument("--set", metavar="PATH=VALUE", dest="settings", action="append", default=[], help="of points in motion; repeatable")
    given = options.parse_args()
    observed = {"simulation.observed_revolutions": given.revolutions, "simulation.most_revolutions": given.revolutions} if given.revolutions else {}
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    sweeps()
    if given.speeds:
        observed["sweep.input.speed"] = given.speeds
    observed |= dict(setting.split("=", 1) for setting in given.settings)
    for points, fidelity, settings in ((given.static, "quasi-static", {}), (given.dynamic, "dynamic", observed)):
        if points:
            beside_threads(points, fidelity, given.workers, given.kills, settings)


if __name__ == "__main__":
    main()
