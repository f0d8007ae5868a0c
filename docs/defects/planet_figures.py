"""`python3 planet_figures.py PROGRAM CASE`: planet.png beside this file, spectra of envelopes of the case with a scratch on bore, pin and roller, in the
carrier's frame and on the housing, with the lines that are derived on paper (planet.md).

Needs numpy, matplotlib and netCDF4, as the reports do.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import netCDF4
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
from matplotlib.figure import Figure  # noqa: E402

HIGHEST = 1300.0  # [Hz]
SURFACES = {"outer": "planet's bore", "inner": "pin", "roller": "roller"}
UNITS = {"carrier": "m/s²", "housing": "N"}


def run(program, case, race):
    """Variables of the run's file, and its JSON."""
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder) / "out"
        command = [program, "run", case, "-o", target, "--set", f"defect.race={race}", "--json", "--quiet"]
        result = json.loads(subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout)
        with netCDF4.Dataset(target / "points" / "00000.nc") as data:
            return {name: np.asarray(variable[...]) for name, variable in data.variables.items()}, result


def lines(race, at, housing):
    """Name and frequency of the lines on paper, with the slip that the run has."""
    if race == "inner":
        base = [("f_i", at["inner_pass_Hz"])]
    elif race == "outer":
        base = [(f"f_o {n:+d} f_p" if n else "f_o", at["outer_pass_Hz"] + n * at["planet_Hz"]) for n in (-2, -1, 0, 1, 2)] + [("f_p", at["planet_Hz"])]
    else:
        base = [(f"f_w {n:+d} f_k" if n else "f_w", at["roller_pass_Hz"] + n * at["cage_Hz"]) for n in (-1, 0, 1)] + [("f_k", at["cage_Hz"])]
    beside = [(f"{name} {sign:+d} f_c", line + sign * at["carrier_Hz"]) for name, line in base[:1] for sign in (-1, 1)] if race == "inner" else []
    return base + ([("f_c", at["carrier_Hz"]), *beside] if housing else [])


def envelope(axes, data, view, marks):
    place, level = data[f"{view}_envelope_spectrum_place"], data[f"{view}_envelope_spectrum"]
    shown = (place > 8.0) & (place <= HIGHEST)
    axes.plot(place[shown], level[shown], linewidth=0.7, color=style.BLUE)
    top = level[shown].max()
    last = -np.inf
    for name, line in sorted(marks, key=lambda mark: mark[1]):
        axes.axvline(line, color=style.VERMILION, linewidth=0.8, linestyle=(0, (2, 2)), zorder=0)
        # Names of lines that are close begin where the former one ends.
        shown = max(line, last + 0.045 * HIGHEST)
        axes.text(shown, 1.05 * top, name.replace(" ", ""), rotation=90, fontsize=8.5, ha="center", va="bottom", color=style.BLACK,
                  bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5})
        last = shown
    axes.set_xlim(0.0, HIGHEST)
    axes.set_ylim(0.0, 1.6 * top)
    axes.set_xlabel("frequency (Hz)")
    axes.set_ylabel(f"envelope ({UNITS[view]})")


def main(program, case):
    figure = Figure(figsize=(9.0, 8.4))
    axes = figure.subplots(3, 2)
    for row, race in enumerate(SURFACES):
        data, result = run(program, case, race)
        for column, view in enumerate(UNITS):
            envelope(axes[row][column], data, view, lines(race, result["turned"], view == "housing"))
            axes[row][column].set_title(f"{SURFACES[race]}, {'carrier frame' if view == 'carrier' else 'housing'}")
    figure.savefig(pathlib.Path(__file__).with_name("planet.png"))


if __name__ == "__main__":
    main(*sys.argv[1:3])
