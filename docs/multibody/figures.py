#!/usr/bin/env python3
"""figures.py BEARING.fmu CHECK.json: the figures and numbers of README.md beside this file.

Needs numpy, matplotlib and FMPy. The bearing and what presses on it come from
    orbearing fmu cases/reducer_150kW/case.yaml -o bearing.fmu --fmi 2
    orbearing check cases/reducer_150kW/case.yaml --json > check.json
"""

import pathlib
import sys
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
import matplotlib.pyplot as plt  # noqa: E402
from planet_bearing import EXCHANGES, INTEGRATORS, Bearing, Bushing, duty_of, run_bearing, run_bushing  # noqa: E402

HERE = pathlib.Path(__file__).parent
SIZES = [1e-6, 2e-6, 3e-6, 5e-6, 7e-6, 10e-6, 15e-6, 20e-6, 25e-6, 30e-6, 35e-6, 40e-6, 45e-6, 50e-6, 60e-6, 80e-6]
LONG = 5e-3  # [s]
SHORT = 3e-4  # [s]  beyond some 0.5 ms neighbouring motions part, whatever the step
FINE = 1e-7  # [s]
ROOM = 3.0  # [-]  a run is stable while it does not swing wider than so many times a fine one
COLOURS = dict(zip(EXCHANGES, style.SERIES))
MARKERS = dict(zip(EXCHANGES, "osD^vPX"))


def against_bushing(bearing, duty, place, seconds=0.03, size=4e-6):
    steps = round(seconds / size)
    rollers = range(1, 4)
    watch = [f"roller[{k}].inner_load" for k in rollers] + ["cage.slip", "life_used"]
    places, watched = run_bearing(bearing, duty, place, steps, size, "half a step ahead, slopes", watch)
    stiffness = bearing.stiffness_at(place)
    bearing.begin(place)
    damping = bearing.damping()
    on_bushing = run_bushing(Bushing(stiffness, damping, place, -duty.static), duty, place, steps, size)
    k, c = stiffness.trace() / 2.0, damping.trace() / 2.0
    share = c / 2.0 / np.sqrt(k * duty.mass)
    print(f"{duty.mass} kg under {duty.static} N, {duty.mesh:.0f} Hz; rest at {place * 1e6} um; k = {k / 1e6:.1f} N/um, c = {c:.0f} N s/m, {share:.3f} of critical")
    print(f"2 c/k = {2e6 * c / k:.2f} us, 2/omega = {2e6 * np.sqrt(duty.mass / k):.1f} us")
    print(f"root mean square of the way about its mean, um: bushing {1e6 * on_bushing[steps // 2:].std(0)}, "
          f"FMU {1e6 * places[steps // 2:].std(0)}")
    times = 1e3 * size * np.arange(steps + 1)
    figure, (way, load) = plt.subplots(2, 1, figsize=(style.WIDTH, 5.4))
    last = times > times[-1] - 3.0
    for which, name, colour in ((places, "FMU", style.BLUE), (on_bushing, "bushing", style.VERMILION)):
        for axis, letter, dashes in ((1, "y", "-"), (0, "x", "--")):
            way.plot(times[last], 1e6 * which[last, axis], dashes, label=f"{name}, {letter}", color=colour, lw=1.0)
    way.set(xlabel="time (ms)", ylabel="planet from its pin (µm)")
    for k in rollers:
        load.plot(times, watched[:, k - 1], lw=0.8, label=f"roller {k}")
    load.set(xlabel="time (ms)", ylabel="load on the pin (N)")
    for axes in (way, load):
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.savefig(HERE / "bearing_against_bushing.png")


def error(bearing, duty, place, fine, size, exchange, integrator):
    """[m] largest distance from the fine run over the short path; NaN where the planet leaves."""
    try:
        places, _ = run_bearing(bearing, duty, place, int(SHORT / size), size, exchange, integrator=integrator)
    except (ArithmeticError, RuntimeError):
        return np.nan
    return np.abs(places - fine[::round(size / FINE)][:len(places)]).max()


def stable(bearing, duty, place, swing, size, exchange, integrator):
    try:
        places, _ = run_bearing(bearing, duty, place, round(LONG / size), size, exchange, integrator=integrator)
    except (ArithmeticError, RuntimeError, OSError):
        return False
    return np.abs(places - place).max() < ROOM * swing


def longest_stable(*run):
    """[s] the longest step of SIZES up to which all are stable."""
    longest = 0.0
    for size in SIZES:
        if not stable(*run[:4], size, *run[4:]):
            break
        longest = size
    return longest


def step_sizes(bearing, duty, place):
    fine, _ = run_bearing(bearing, duty, place, round(SHORT / FINE), FINE, "half a step ahead, slopes")
    begin = time.perf_counter()
    path = run_bearing(bearing, duty, place, round(LONG / 1e-6), 1e-6, "half a step ahead, slopes")[0]
    swing = np.abs(path - place).max()
    print(f"swing {swing * 1e6:.3f} um; {LONG / 1e-6:.0f} steps of 1 us in {time.perf_counter() - begin:.2f} s")
    figure, panels = plt.subplots(1, 2, figsize=(style.WIDTH, 4.6), sharey=True)
    for axes, integrator in zip(panels, INTEGRATORS):
        print(f"{integrator}: error at 1, 2, 5, 10, 20 us, um, and longest stable step, us")
        for exchange in EXCHANGES:
            errors = [error(bearing, duty, place, fine, size, exchange, integrator) for size in SIZES]
            limit = longest_stable(bearing, duty, place, swing, exchange, integrator)
            print(f"  {exchange:28s}", *(f"{1e6 * errors[SIZES.index(s)]:.4f}" for s in (1e-6, 2e-6, 5e-6, 10e-6, 20e-6)),
                  f"; {limit * 1e6:.0f}")
            shown = np.where([size <= limit for size in SIZES], errors, np.nan)
            axes.loglog(1e6 * np.array(SIZES), 1e6 * shown, "-", marker=MARKERS[exchange], ms=4, color=COLOURS[exchange], label=exchange)
            axes.loglog(1e6 * np.array(SIZES), 1e6 * np.array(errors), ":", color=COLOURS[exchange], lw=0.8)
        axes.set(xlabel="communication step (µs)", title=integrator, ylim=(1e-4, 1e2))
    panels[0].set_ylabel("error of position after 0.3 ms (µm)")
    style.legend_on_top(figure, panels[0], 3)
    figure.savefig(HERE / "step_size.png")


def main():
    bearing, duty = Bearing(sys.argv[1]), duty_of(sys.argv[2])
    try:
        place = bearing.place_under(duty.static)
        against_bushing(bearing, duty, place)
        step_sizes(bearing, duty, place)
    finally:
        bearing.close()


if __name__ == "__main__":
    main()
