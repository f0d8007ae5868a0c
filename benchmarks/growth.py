#!/usr/bin/env python3
"""Memory of whole runs, and how computing time and memory grow with bearings in one system and with points of a sweep.

All by the command line; medians with quartiles, prints one JSON object.

    benchmarks/growth.py --program build/release/bin/orbearing
"""
import argparse
import json
import os

from command import COMPLETE, COMPLETE_SINCE, Run, middle, one_system, say, settings

FEW, MANY = 1, 3  # revolutions of the cage
# Planets and bearings on each, the power shared so that each bearing carries alike.
SYSTEMS = {1: (1, 1), 2: (2, 1), 4: (4, 1), 8: (4, 2)}
POWER = 150.0 / 8.0  # kW  for each bearing
GRIDS = {12: "1000 rpm", 111: "100 rpm", 1101: "10 rpm"}  # points by the step from 1000 to 12000 rpm


def main():
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(here, "build/release/bin/orbearing"))
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args()
    case = os.path.join(here, "cases/reducer_150kW/case.yaml")
    figures = {"spreads": {}}

    def run(command, *values):
        return Run(options.program, [command, case, *settings(COMPLETE + COMPLETE_SINCE), *values])

    def put(key, name, values):
        median, lower, upper = middle(values)
        figures.setdefault(key, {})[name] = median
        figures["spreads"].setdefault(key, {})[name] = [lower, upper]

    say("memory")
    for name, command, values in (("quasi-static point", "run", ["--fidelity", "quasi-static"]),
                                  ("dynamic point", "run", ["--fidelity", "dynamic"]),
                                  ("one system", "run", ["--fidelity", "monolithic", *settings(one_system(FEW))])):
        put("peak_MB", name, [run(command, *values).peak_MB for _ in range(options.runs)])
    for bearings, (planets, per_planet) in SYSTEMS.items():
        say(f"one system of {bearings} bearings")
        same = settings([f"gearset.planets={planets}", f"bearing.per_planet={per_planet}",
                         f"input.power={POWER * bearings:g} kW"])
        runs = [[run("run", "--fidelity", "monolithic", *same, *settings(one_system(n))) for n in (FEW, MANY)]
                for _ in range(options.runs)]
        put("bearings_s_per_revolution", str(bearings), [(many.cpu - few.cpu) / (MANY - FEW) for few, many in runs])
        put("bearings_peak_MB", str(bearings), [many.peak_MB for _, many in runs])
    for points, step in GRIDS.items():
        say(f"sweep of {points} points")
        grid = settings([f"sweep.input.speed={{from: 1000 rpm, to: 12000 rpm, step: {step}}}"])
        runs = [run("sweep", "--grid-only", "--jobs", "1", *grid) for _ in range(options.runs)]
        put("points_s", str(points), [one.cpu for one in runs])
        put("points_peak_MB", str(points), [one.peak_MB for one in runs])
    print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
