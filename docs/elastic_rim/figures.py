"""Figures of docs/elastic_rim.md: python3 docs/elastic_rim/figures.py PROGRAM."""
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402

HERE = Path(__file__).parent
CASE = HERE.parent.parent / "cases" / "reducer_150kW" / "case.yaml"
COLOURS = {"rigid": style.BLACK, "elastic": style.VERMILION}
SPEEDS = [1000, 6000, 12000]


def orbearing(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=True).stdout


def life(program, work, axes):
    lives = {}
    for rim, dashes in (("rigid", "--"), ("elastic", "-")):
        orbearing(program, "sweep", CASE, "-o", work / rim, "--set", f"gearset.planet_rim={rim}")
        with open(work / rim / "sweep.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        lives[rim] = {float(row["input_speed_rpm"]): float(row["life_h"]) for row in rows}
        axes.semilogy(lives[rim].keys(), lives[rim].values(), dashes, color=COLOURS[rim], label=f"{rim} rim")
    print("| input speed [rpm] | rigid [h] | elastic [h] | gain [%] |\n|---|---|---|---|")
    for speed in sorted(set(lives["rigid"]) & set(lives["elastic"])):
        if speed % 1000 == 0:
            rigid, elastic = lives["rigid"][speed], lives["elastic"][speed]
            print(f"| {speed:.0f} | {rigid:.0f} | {elastic:.0f} | {100 * (elastic / rigid - 1):+.1f} |")
    axes.set(xlabel="input speed (rpm)", ylabel="life of one bearing (h)")
    style.speed_axis(axes)
    style.life_axis(axes)
    axes.legend()


def few_labels(axes):
    """Angles in quarters, of which two are named; three circles, whose numbers are between two of the angles."""
    axes.set_thetagrids(range(0, 360, 90), ("0°", "90°", "", ""))
    axes.yaxis.set_major_locator(MaxNLocator(3))
    axes.set_rlabel_position(45)


def loads(program, work, speed, axes, form_axes):
    for rim, dashes in (("rigid", "--"), ("elastic", "-")):
        folder = work / f"{rim}{speed}"
        orbearing(program, "run", CASE, "-o", folder, "--quiet", "--set", f"gearset.planet_rim={rim}", "--set", f"input.speed={speed} rpm")
        with netCDF4.Dataset(next((folder / "points").glob("*.nc"))) as file:
            angle = np.append(file["angle"][:], file["angle"][0])
            load = np.append(file["outer_load"][:], file["outer_load"][0])
            axes.plot(angle, load, dashes, color=COLOURS[rim], label=f"{rim} rim")
            if rim == "elastic":
                form = 1e6 * np.append(file["race_form"][:], file["race_form"][0])
                form_axes.plot(angle, form, label=f"{speed} rpm")
    few_labels(axes)
    axes.set_title(f"roller load (N)\n{speed:,} rpm")


def in_motion(program, speed, revolutions):
    """Lives of both rims, each of three runs that differ in the allowed error by 5 %, as a line of the table."""
    lives, loads = {}, {}
    for rim in ("rigid", "elastic"):
        rows = [json.loads(orbearing(program, "run", CASE, "--fidelity", "dynamic", "--json", "--set", f"gearset.planet_rim={rim}",
                                     "--set", f"input.speed={speed} rpm", "--set", f"simulation.observed_revolutions={revolutions}",
                                     "--set", f"simulation.length_error={error} um"))["points"][0] for error in (1.9e-4, 2e-4, 2.1e-4)]
        lives[rim] = np.array([row["life_h"] for row in rows])
        loads[rim] = np.mean([row["inner_load_max_N"] for row in rows])
    gain = lives["elastic"].mean() / lives["rigid"].mean() - 1
    scatter = max(np.ptp(life) / life.mean() / 2 for life in lives.values())
    return (f"| {speed} | {lives['rigid'].mean():.0f} | {lives['elastic'].mean():.0f} | {100 * gain:+.1f} | {100 * scatter:.2f} | "
            f"{loads['rigid']:.0f} -> {loads['elastic']:.0f} |")


def main():
    program = sys.argv[1]
    figure = plt.figure(figsize=(9.0, 7.4))
    grid = figure.add_gridspec(2, 6)
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        life(program, work, figure.add_subplot(grid[1, :3]))
        form = figure.add_subplot(grid[1, 3:], projection="polar")
        for place, speed in enumerate(SPEEDS):
            loads(program, work, speed, figure.add_subplot(grid[0, 2 * place:2 * place + 2], projection="polar"), form)
        few_labels(form)
        form.set_title("outward displacement of the race (µm)\n0°: away from the sun")
        form.legend(loc="upper left", bbox_to_anchor=(-0.38, 0.36), handlelength=1.8).set_in_layout(False)
        modes = {}
        for rim in ("rigid", "elastic"):
            modes[rim] = json.loads(orbearing(program, "modes", CASE, "--json", "--set", f"gearset.planet_rim={rim}"))["modes"]
        print("\n| mode | rigid [Hz] | elastic [Hz] |\n|---|---|---|")
        for rigid, elastic in zip(modes["rigid"], modes["elastic"]):
            print(f"| {rigid['kind']} | {rigid['frequency_Hz']:.0f} | {elastic['frequency_Hz']:.0f} ({elastic['kind']}) |")
    print("\n| input speed [rpm] | rigid [h] | elastic [h] | gain [%] | scatter of a run, +- [%] | largest load [N] |\n|---|---|---|---|---|---|")
    for speed, revolutions in ((1000, 6), (3000, 12), (6000, 20), (12000, 40)):
        print(in_motion(program, speed, revolutions), flush=True)
    figure.savefig(HERE / "reducer.png")


main()
