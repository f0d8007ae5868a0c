#!/usr/bin/env python3
"""Life over the allowed error of a step: means over several starts, with their standard errors.

Runs the case again and again by the program itself. Paths part company within a millisecond, so a speed that
differs by some 1e-7 of itself is another start of the same motion. Each line: speed, allowed error, mean life,
its standard error, life over that at the finest error, processor time of a run.

    benchmarks/tolerance.py --starts 8 --output DIR       # resumes: runs that stand in DIR are not done again
"""
import argparse
import json
import math
import os
import resource
import subprocess
import sys

SHIFT = 1e-7  # [-]  of the speed from start to start


def run(options, rpm, error, start):
    folder = os.path.join(options.output, f"{rpm:g}rpm_{error:g}mm_{start}")
    kept = folder + ".json"
    if os.path.exists(kept):
        with open(kept) as file:
            return json.load(file)
    command = [options.orbearing, "run", options.case, "--json", "--quiet", "--fidelity", options.fidelity,
               "-o", folder,
               "--set", f"input.speed={rpm * (1.0 + SHIFT * start):.10g} rpm",
               "--set", f"simulation.length_error={error:g} mm",
               "--set", f"simulation.observed_revolutions={options.revolutions}"]
    for setting in options.set:
        command += ["--set", setting]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: {done.stderr}")
    result = json.loads(done.stdout)
    result["computing_s"] = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    with open(kept + ".part", "w") as file:
        json.dump(result, file)
    os.replace(kept + ".part", kept)
    return result


def mean_and_error(values):
    mean = sum(values) / len(values)
    if len(values) < 2:
        return mean, math.nan
    variance = sum((value - mean) ** 2 for value in values) / (len(values) - 1)
    return mean, math.sqrt(variance / len(values))


def numbers(text):
    return [float(word) for word in text.split(",")]


def arguments():
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--orbearing", default=os.path.join(root, "build/release/bin/orbearing"))
    parser.add_argument("--case", default=os.path.join(root, "cases/reducer_150kW/case.yaml"))
    parser.add_argument("--fidelity", default="monolithic", choices=["monolithic", "co-simulated", "dynamic"])
    parser.add_argument("--rpm", type=numbers, default=[3000.0, 6000.0, 12000.0])
    parser.add_argument("--errors", type=numbers, default=[2e-7, 1e-8], help="mm, the finest last")
    parser.add_argument("--starts", type=int, default=8)
    parser.add_argument("--revolutions", type=int, default=30, help="of the cage, averaged in each run")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="of the case, as for orbearing")
    parser.add_argument("--output", required=True, help="folder for the runs")
    return parser.parse_args()


def main():
    options = arguments()
    os.makedirs(options.output, exist_ok=True)
    print("   rpm  error mm     life h   std.err. %  over finest  CPU s", flush=True)
    for rpm in options.rpm:
        finest = None
        for error in reversed(options.errors):
            runs = [run(options, rpm, error, start) for start in range(options.starts)]
            mean, deviation = mean_and_error([one["points"][0]["life_h"] for one in runs])
            finest = finest or mean
            print(f"{rpm:6.0f}  {error:8.3g}  {mean:9.0f}   {100 * deviation / mean:10.3f}  {mean / finest:11.4f}"
                  f"  {sum(one['computing_s'] for one in runs) / len(runs):5.1f}", flush=True)


if __name__ == "__main__":
    main()
