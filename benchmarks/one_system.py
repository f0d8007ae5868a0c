#!/usr/bin/env python3
"""What a revolution of the cage costs in one system, and how much less than with another build of the program.

Runs `run CASE --fidelity monolithic` for few and for many observed revolutions and takes the difference, so that
start and settling cancel; both programs in turn, medians over the pairs. Processor time.

    benchmarks/one_system.py --orbearing build/release/bin/orbearing --base ../base/build/release/bin/orbearing
"""
import argparse
import os
import resource
import statistics
import subprocess
import tempfile


def seconds(program, options, rpm, revolutions):
    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([program, "run", options.case, "--quiet", "--fidelity", "monolithic",
                        "-o", os.path.join(folder, "run"), "--set", f"input.speed={rpm:g} rpm",
                        "--set", "simulation.load_drift=1", "--set", "simulation.cage_drift=1",
                        "--set", f"simulation.observed_revolutions={revolutions}"], check=True)
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def of_a_revolution(program, options, rpm):
    few, many = options.revolutions
    return (seconds(program, options, rpm, many) - seconds(program, options, rpm, few)) / (many - few)


def numbers(text):
    return [float(word) for word in text.split(",")]


def main():
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--orbearing", default=os.path.join(root, "build/release/bin/orbearing"))
    parser.add_argument("--base", help="program of the commit to compare with")
    parser.add_argument("--case", default=os.path.join(root, "cases/reducer_150kW/case.yaml"),
                        help="one that both programs know")
    parser.add_argument("--rpm", type=numbers, default=[1000.0, 6000.0, 12000.0])
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--revolutions", type=int, nargs=2, default=[2, 10], metavar=("FEW", "MANY"))
    options = parser.parse_args()
    for rpm in options.rpm:
        own, base = [], []
        for _ in range(options.pairs):
            own.append(of_a_revolution(options.orbearing, options, rpm))
            if options.base:
                base.append(of_a_revolution(options.base, options, rpm))
        line = f"{rpm:6.0f} rpm: {1e3 * statistics.median(own):.1f} ms a revolution of the cage"
        if base:
            gains = sorted(b / o for b, o in zip(base, own))
            line += (f", base {1e3 * statistics.median(base):.1f} ms, gain {statistics.median(gains):.2f} "
                     f"({gains[0]:.2f} to {gains[-1]:.2f})")
        print(line, flush=True)


if __name__ == "__main__":
    main()
