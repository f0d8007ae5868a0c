"""Figures of docs/elastic_rim.md: python3 docs/elastic_rim/figures.py PROGRAM."""
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import netCDF4
import numpy as np

HERE = Path(__file__).parent
CASE = HERE.parent.parent / "cases" / "reducer_150kW" / "case.yaml"
SPEEDS = [1000, 6000, 12000]


def orbearing(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=True).stdout


def life(program, work, axes):
    lives = {}
    for rim, style in (("rigid", "--"), ("elastic", "-")):
        orbearing(program, "sweep", CASE, "-o", work / rim, "--set", f"gearset.planet_rim={rim}")
        with open(work / rim / "sweep.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        lives[rim] = {float(row["input_speed_rpm"]): float(row["life_h"]) for row in rows}
        axes.semilogy(lives[rim].keys(), lives[rim].values(), style, label=f"{rim} rim")
    print("| input speed [rpm] | rigid [h] | elastic [h] | gain [%] |\n|---|---|---|---|")
    for speed in sorted(set(lives["rigid"]) & set(lives["elastic"])):
        if speed % 1000 == 0:
            rigid, elastic = lives["rigid"][speed], lives["elastic"][speed]
            print(f"| {speed:.0f} | {rigid:.0f} | {elastic:.0f} | {100 * (elastic / rigid - 1):+.1f} |")
    axes.set(xlabel="input speed (rpm)", ylabel="life of one bearing (h)")
    axes.legend()


def loads(program, work, speed, axes, form_axes):
    for rim, style in (("rigid", "--"), ("elastic", "-")):
        folder = work / f"{rim}{speed}"
        orbearing(program, "run", CASE, "-o", folder, "--quiet", "--set", f"gearset.planet_rim={rim}", "--set", f"input.speed={speed} rpm")
        with netCDF4.Dataset(next((folder / "points").glob("*.nc"))) as file:
            angle = np.append(file["angle"][:], file["angle"][0])
            load = np.append(file["outer_load"][:], file["outer_load"][0])
            axes.plot(angle, load, style, label=f"{rim} rim")
            if rim == "elastic":
                form = 1e6 * np.append(file["race_form"][:], file["race_form"][0])
                form_axes.plot(angle, form, label=f"{speed} rpm")
    axes.set_rlabel_position(60)
    axes.set_title(f"{speed} rpm: roller on outer race (N)", fontsize=9)


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
    figure = plt.figure(figsize=(11, 7.5), constrained_layout=True)
    grid = figure.add_gridspec(2, 6)
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        life(program, work, figure.add_subplot(grid[1, :3]))
        form = figure.add_subplot(grid[1, 3:], projection="polar")
        for place, speed in enumerate(SPEEDS):
            loads(program, work, speed, figure.add_subplot(grid[0, 2 * place:2 * place + 2], projection="polar"), form)
        form.set_rlabel_position(30)
        form.set_title("outward displacement of the race (um); 0 deg: away from the sun", fontsize=9)
        form.legend(loc="lower left", bbox_to_anchor=(-0.25, -0.1), fontsize=8)
        figure.axes[2].legend(loc="lower left", bbox_to_anchor=(-0.25, -0.15), fontsize=8)
        modes = {}
        for rim in ("rigid", "elastic"):
            modes[rim] = json.loads(orbearing(program, "modes", CASE, "--json", "--set", f"gearset.planet_rim={rim}"))["modes"]
        print("\n| mode | rigid [Hz] | elastic [Hz] |\n|---|---|---|")
        for rigid, elastic in zip(modes["rigid"], modes["elastic"]):
            print(f"| {rigid['kind']} | {rigid['frequency_Hz']:.0f} | {elastic['frequency_Hz']:.0f} ({elastic['kind']}) |")
    print("\n| input speed [rpm] | rigid [h] | elastic [h] | gain [%] | scatter of a run, +- [%] | largest load [N] |\n|---|---|---|---|---|---|")
    for speed, revolutions in ((1000, 6), (3000, 12), (6000, 20), (12000, 40)):
        print(in_motion(program, speed, revolutions), flush=True)
    figure.savefig(HERE / "reducer.png", dpi=90)


main()
