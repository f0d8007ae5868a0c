"""`python3 figures.py PROGRAM CASE`: figures.png beside this file, the vibration of the case without a scratch, with one on the outer and on the inner race,
and orders.png, the envelope of a run-up over frequency and over orders.

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

TIME = 0.2  # [s]  that the source shows
HIGHEST = 600.0  # [Hz]
RACES = {"none": "no scratch", "outer": "outer race", "inner": "inner race"}


def run(program, case, race, *settings):
    """Variables of the run's file, and its JSON."""
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder) / "out"
        options = [part for setting in (f"defect.race={race}", *settings) for part in ("--set", setting)]
        command = [program, "run", case, "-o", target, *options, "--json"]
        result = json.loads(subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout)
        with netCDF4.Dataset(target / "points" / "00000.nc") as data:
            return {name: np.asarray(variable[...]) for name, variable in data.variables.items()}, result


def over_time(axes, data, values, label):
    brief = data["time"] <= TIME
    axes.plot(1e3 * data["time"][brief], values[brief], linewidth=0.6, color=style.BLUE)
    axes.set_xlabel("time (ms)")
    axes.set_ylabel(label)


def name_peaks(axes, peaks, highest, form):
    """The largest ones, upright, those left out that a larger one is too near to."""
    named = []
    for place, height in peaks[:8]:
        if place <= highest and all(abs(place - other) > 0.06 * highest for other in named):
            named.append(place)
            axes.annotate(form.format(place), (place, height), xytext=(0, 3), textcoords="offset points", fontsize=8.5, rotation=90, ha="center", va="bottom")
    axes.set_ylim(0.0, 1.4 * max(height for _, height in peaks))


def envelope(axes, data, result):
    shown = data["frequency"] <= HIGHEST
    axes.plot(data["frequency"][shown], data["envelope_spectrum"][shown], linewidth=0.8, color=style.BLUE)
    name_peaks(axes, [(peak["frequency_Hz"], peak["amplitude"]) for peak in result["envelope_peaks"]], HIGHEST, "{:.1f}")
    axes.set_xlabel("frequency (Hz)")
    axes.set_ylabel("envelope (m/s²)")


def orders(program, case):
    figure = Figure(figsize=(style.WIDTH, 4.8))
    for row, race in zip(figure.subplots(2, 2), ("outer", "inner")):
        data, result = run(program, case, race, "signal.run_up_from=0.4")
        signal = data["envelope"] - data["envelope"].mean()
        amplitude = 2.0 * np.abs(np.fft.rfft(signal * np.hanning(len(signal)))) / np.hanning(len(signal)).sum()
        frequency = np.fft.rfftfreq(len(signal), 1.0 / float(data["sampling_rate"]))
        shown = (frequency > 1.0) & (frequency <= HIGHEST)
        row[0].plot(frequency[shown], amplitude[shown], linewidth=0.7, color=style.BLUE)
        row[0].set_xlabel("frequency (Hz)")
        shown = (data["order"] > 0.1) & (data["order"] <= HIGHEST / 25.0)
        row[1].plot(data["order"][shown], data["envelope_spectrum"][shown], linewidth=0.7, color=style.BLUE)
        name_peaks(row[1], [(peak["order"], peak["amplitude"]) for peak in result["orders"]], HIGHEST / 25.0, "{:.2f}")
        row[1].set_xlabel("order of the shaft (-)")
        for axes in row:
            axes.set_ylabel("envelope (m/s²)")
            axes.set_title(f"{race} race, run-up")
    figure.savefig(pathlib.Path(__file__).with_name("orders.png"))


def main(program, case):
    figure = Figure(figsize=(9.0, 7.6))
    axes = figure.subplots(3, 3)
    results = {race: run(program, case, race) for race in RACES}
    sound, _ = results["none"]
    over_time(axes[0][0], sound, 1e6 * np.maximum(sound["ball_deflection"], 0.0), "deflection\nof one ball (µm)")
    over_time(axes[0][1], sound, sound["ball_load"], "load of one ball (N)")
    over_time(axes[0][2], sound, sound["acceleration"][0], "acceleration (m/s²)")
    for row, race in ((1, "outer"), (2, "inner")):
        data, result = results[race]
        over_time(axes[row][0], data, data["acceleration"][0], "acceleration (m/s²)")
        over_time(axes[row][1], data, data["ball_load"], "load of one ball (N)")
        envelope(axes[row][2], data, result)
    for row, race in enumerate(RACES):
        for one in axes[row]:
            one.set_title(RACES[race])
    figure.savefig(pathlib.Path(__file__).with_name("figures.png"))


if __name__ == "__main__":
    main(*sys.argv[1:3])
    orders(*sys.argv[1:3])
