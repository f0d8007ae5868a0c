#!/usr/bin/env python3
"""A table of lives over speed, power and clearance: its cost, the time of a query against that of a point, and errors of random queries.

Processor time of one thread, medians; prints one JSON object.

    benchmarks/table.py --build build/release
"""
import argparse
import json
import os
import sys
import tempfile
import time

import numpy as np

from command import middle, say

OVER = {"input.speed": (1000, 12000, "rpm", np.pi / 30), "input.power": (50, 300, "kW", 1e3), "bearing.radial_clearance": (0, 40, "um", 1e-6)}
BOUND = 0.01
QUERIES, POINTS, SEED = 1_000_000, 1000, 3


def seconds(work, runs):
    """Median processor time of the work, and its last result."""
    times = []
    for _ in range(runs):
        start = time.process_time()
        result = work()
        times.append(time.process_time() - start)
    return middle(times)[0], result


def main():
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(here, "build/release"))
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args()
    sys.path.insert(0, os.path.join(options.build, "python"))
    import orbearing._core

    case = os.path.join(here, "cases/reducer_150kW/case.yaml")
    with tempfile.TemporaryDirectory() as place:
        say("table of life over speed, power and clearance")
        ranges = [f"{path}={low} {unit}..{high} {unit}" for path, (low, high, unit, _) in OVER.items()]
        wanted = {"over": ranges, "bound": BOUND, "jobs": 1, "output": os.path.join(place, "table")}
        made_s, (text, _) = seconds(lambda: orbearing._core.compute(orbearing.load(case).core, "table", wanted), 1)
        made = json.loads(text)
        table = orbearing.Table(wanted["output"])
    draw = np.random.default_rng(SEED)
    rows = np.column_stack([draw.uniform(low, high, QUERIES) * si for low, high, _, si in OVER.values()])
    inputs = dict(zip(("speed", "power", "radial_clearance"), rows.T))
    query, found = seconds(lambda: table.life_h(**inputs, jobs=1), options.runs)
    point, (columns, numbers, _) = seconds(lambda: orbearing.load(case).evaluate(list(OVER), rows[:POINTS], jobs=1), options.runs)
    error = np.abs(found.value[:POINTS] / numbers[:, columns.index("life_h")] - 1)
    print(json.dumps({"table_s": made_s, "table_points": made["points"], "table_within_bound": made["within_bound_volume"],
                      "table_query_us": 1e6 * query / QUERIES, "table_point_us": 1e6 * point / POINTS,
                      "table_gain": point / POINTS / (query / QUERIES), "table_largest_error": float(error.max()),
                      "table_mean_error": float(error.mean())}, indent=2))


if __name__ == "__main__":
    main()
