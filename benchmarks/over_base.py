#!/usr/bin/env python3
"""How many times faster than commit d33b5f5 (the base), both on this machine in turn.

Of one bearing and of the sweep each version is asked by its orbearing_pace (pace.cpp): the same simulated time at the
standard settings of each, loads gathered, nothing but computing in the loop. Of one system both run by their command
line, few revolutions of the cage and many: the difference is without start-up. Medians of ratios of pairs, with
quartiles; prints one JSON object.

    benchmarks/over_base.py --ours build/release/bin --base DIR/build/release/bin --base-root DIR
"""
import argparse
import json
import os
import subprocess

from command import COMPLETE, COMPLETE_SINCE, Run, middle, one_system, say, settings

POINTS = [(6000, 0), (12000, 37)]  # 1/min, um
FEW, MANY = 1, 5  # revolutions of the cage


class Pace:
    """A version's orbearing_pace."""

    def __init__(self, folder):
        self.process = subprocess.Popen([os.path.join(folder, "orbearing_pace")], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True)

    def ask(self, request):
        self.process.stdin.write(request + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline().split()
        if not answer:
            raise RuntimeError(f"orbearing_pace gave up at \"{request}\"")
        return answer

    def number(self, request):
        return float(self.ask(request)[0])

    def close(self):
        self.process.communicate()


def ratios(ours, base, pairs, time_of):
    """time_of(base) / time_of(ours) in turn, each first every other time."""
    found = []
    for pair in range(pairs):
        order = (ours, base) if pair % 2 == 0 else (base, ours)
        times = {id(version): time_of(version) for version in order}
        found.append(times[id(base)] / times[id(ours)])
    return found


def put(figures, key, found):
    median, lower, upper = middle(found)
    figures[key] = median
    figures["spreads"][key] = [lower, upper]


def bearings(ours, base, pairs, meshes, figures):
    for rpm, clearance in POINTS:
        name = f"{rpm}/{clearance}"
        say(f"{name} over base, meshes {meshes}")
        key = "gain_over_base" if meshes == "constant" else "gain_over_base_real_meshes"
        for version in (ours, base):
            version.ask(f"bearing {rpm} {clearance} {meshes}")
        median, lower, upper = middle(ratios(ours, base, pairs, lambda version: version.number("run")))
        figures.setdefault(key, {})[name] = median
        figures["spreads"].setdefault(key, {})[name] = [lower, upper]
        if meshes != "constant":
            continue
        for version, owner in ((ours, "ours"), (base, "base")):
            errors = [float(word) for word in version.ask("errors")]
            figures.setdefault("over_base_errors", {}).setdefault(name, {})[owner] = dict(
                zip(("rms_relative", "max_relative", "cage_speed_relative"), errors))


class Program:
    """A version's command line and its case. `grid_only`: what keeps a sweep from adding points about its peak."""

    def __init__(self, folder, root, extra, grid_only):
        self.program = os.path.join(folder, "orbearing")
        self.case = os.path.join(root, "cases/reducer_150kW/case.yaml")
        self.extra = extra
        self.grid_only = grid_only
        self.seconds = []

    def run(self, command, *values):
        return Run(self.program, [command, self.case, "--fidelity", "monolithic", *settings(self.extra), *values])

    def revolutions(self):
        """CPU time [s] of MANY - FEW revolutions of the cage in one system."""
        few, many = (self.run("run", *settings(one_system(n))).cpu for n in (FEW, MANY))
        return many - few

    def twelve(self):
        """CPU time [s] of twelve points on two threads; `seconds` keeps the wall times."""
        run = self.run("sweep", "--jobs", "2", *self.grid_only)
        self.seconds.append(run.wall)
        return run.cpu


def main():
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ours", default=os.path.join(here, "build/release/bin"), help="folder of our programs")
    parser.add_argument("--base", required=True, help="folder of the base's programs")
    parser.add_argument("--base-root", required=True, help="the base's checkout")
    parser.add_argument("--pairs", type=int, default=15, help="of runs of one bearing; fewer of what takes longer")
    parser.add_argument("--system-sweeps", type=int, default=1, help="pairs of twelve points of one system; 0: none")
    options = parser.parse_args()
    figures = {"spreads": {}}
    ours, base = Pace(options.ours), Pace(options.base)
    for meshes in ("constant", "varying"):
        bearings(ours, base, options.pairs, meshes, figures)
    say("sweeps over base")
    few = max(1, options.pairs // 5)
    put(figures, "sweep12_gain_over_base", ratios(ours, base, few, lambda version: version.number("sweep 0")))
    ours.close()
    base.close()
    own = Program(options.ours, here, COMPLETE + COMPLETE_SINCE, ["--grid-only"])
    old = Program(options.base, options.base_root, COMPLETE, [])  # which adds none
    say("one system over base")
    put(figures, "system_gain_over_base", ratios(own, old, max(1, options.pairs // 3), Program.revolutions))
    if options.system_sweeps > 0:
        say("twelve points of one system over base")
        put(figures, "system_sweep12_gain_over_base", ratios(own, old, options.system_sweeps, Program.twelve))
        figures["system_sweep12_s"] = {"ours": middle(own.seconds)[0], "base": middle(old.seconds)[0]}
    print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
