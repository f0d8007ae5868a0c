#!/usr/bin/env python3
"""compare.py ONE_WAY.csv ONE_SYSTEM.csv: table and picture of ../coupled_steady_state.md, from the sweep.csv of two sweeps.

    speeds="[$(python3 compare.py --speeds)]"
    case=cases/reducer_150kW/case.yaml
    orbearing sweep $case -o one_way    --grid-only --fidelity dynamic    --set "sweep.input.speed=$speeds"
    orbearing sweep $case -o one_system --grid-only --fidelity monolithic --set "sweep.input.speed=$speeds"
    python3 compare.py one_way/sweep.csv one_system/sweep.csv

Beside this file: one_pass.csv, lives of the first one-way scheme (commit d33b5f5: one pass, bearings of equal
stiffness in all directions, 5 % damping). Needs matplotlib. Ends with 1 where both differ by more than 5 %.
"""

import csv
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
SPEEDS = sorted({*range(1000, 12001, 500), *range(5000, 7001, 50)})  # [rpm]
NEAR = (5000, 7000)  # [rpm]  of the second picture
DIP = (5400, 6400)  # [rpm]  where the second mesh harmonic meets the planets' mode
ALLOWED = 0.05  # [-]


def lives(path):
    with open(path, newline="") as file:
        return {round(float(row["input_speed_rpm"])): row for row in csv.DictReader(file) if row["life_h"]}


def life(rows, speed):
    return float(rows[speed]["life_h"])


def dip_of(rows):
    return min((s for s in rows if DIP[0] <= s <= DIP[1]), key=lambda s: life(rows, s))


def peak_below(rows, dip):
    return max((s for s in rows if NEAR[0] <= s < dip), key=lambda s: life(rows, s))


def peak_above(rows, dip):
    return max((s for s in rows if dip < s <= NEAR[1]), key=lambda s: life(rows, s))


def table(speeds, one_pass, one_way, one_system):
    print("| rpm | one pass (d33b5f5) | one way | one system | one pass over one system | one way over one system | runs |")
    print("|---:|---:|---:|---:|---:|---:|---:|")
    worst = 0.0
    for speed in speeds:
        first, way, system = life(one_pass, speed), life(one_way, speed), life(one_system, speed)
        runs = round(float(one_way[speed]["one_way_runs"]))
        settled = "" if float(one_way[speed]["one_way_accepted"]) else " (not settled)"
        print(
            f"| {speed} | {first:.0f} | {way:.0f} | {system:.0f} | {100 * (first / system - 1):+.1f} % "
            f"| {100 * (way / system - 1):+.1f} % | {runs}{settled} |"
        )
        worst = max(worst, abs(way / system - 1))
    print(f"\nlargest difference: {100 * worst:.1f} %; dips at", *(dip_of(r) for r in (one_pass, one_way, one_system)), "rpm")
    return worst


def picture(speeds, one_pass, one_way, one_system):
    sys.path.insert(0, str(HERE.resolve().parents[1] / "python"))
    from orbearing import style

    style.use()
    import matplotlib.pyplot as plt

    figure, (wide, near) = plt.subplots(2, 1, figsize=(style.WIDTH, 7.0))
    for axes, least, most in ((wide, 0, 99999), (near, *NEAR)):
        for rows, dashes, colour, name in (
            (one_pass, "--", style.GREY, "one way, one pass (d33b5f5)"),
            (one_system, "-", style.BLUE, "one system"),
            (one_way, "o", style.VERMILION, "one way, bearing fitted"),
        ):
            shown = [s for s in (speeds if rows is one_way else SPEEDS) if least <= s <= most and s in rows]
            axes.plot(shown, [life(rows, s) for s in shown], dashes, color=colour, label=name, markersize=4)
        style.speed_axis(axes)
        axes.set_ylabel("life of one bearing (h)")
        style.thousands(axes.yaxis)
    dip = dip_of(one_system)
    for speed, what, at, side in ((peak_below(one_system, dip), "maximum", 50800, "right"), (dip, "dip: 2 x mesh frequency,\nmode of the planets", 36000, "right"),
                                  (peak_above(one_system, dip), "maximum", 50800, "left")):
        near.annotate(f"{what}\n{speed:,} rpm, {life(one_system, speed):,.0f} h", (speed, life(one_system, speed)), xytext=(speed, at), ha=side, va="bottom",
                      arrowprops={"arrowstyle": "-", "color": style.GREY})
    near.set_ylim(30000, 55000)
    wide.legend(loc="upper right")
    figure.savefig(HERE / "one_way.png")


def main():
    if sys.argv[1:] == ["--speeds"]:
        print(", ".join(f"{speed} rpm" for speed in SPEEDS))
        return 0
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    one_way, one_system = (lives(path) for path in sys.argv[1:])
    one_pass = lives(HERE / "one_pass.csv")
    speeds = [s for s in SPEEDS if s in one_way and s in one_system]
    worst = table(speeds, one_pass, one_way, one_system)
    picture(speeds, one_pass, one_way, one_system)
    if len(speeds) < len(SPEEDS):
        print(f"{len(SPEEDS) - len(speeds)} of {len(SPEEDS)} speeds are missing in one of both", file=sys.stderr)
    return 0 if worst <= ALLOWED else 1


if __name__ == "__main__":
    sys.exit(main())
