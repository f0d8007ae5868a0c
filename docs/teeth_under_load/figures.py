"""Figure and tables of docs/teeth_under_load.md: python3 docs/teeth_under_load/figures.py PROGRAM."""

import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
import matplotlib.pyplot as plt  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE.parents[1] / "cases" / "reducer_150kW" / "case.yaml"
LOADED = ("gearset.tooth_contact=loaded",)
RELIEF = tuple(f"gearset.tip_relief.{gear}=15 um" for gear in ("sun", "planet", "ring"))
POWERS = ("1 kW", "30 kW", "150 kW", "600 kW")
OPTIONS = {
    "stepped": (),
    "loaded": LOADED,
    "loaded, crown of the planet 10 um": LOADED + ("gearset.lead_crown.planet=10 um",),
    "loaded, tip relief 15 um": LOADED + RELIEF,
}
SPEEDS = (1000, 3000, 6000, 12000)  # [rpm]


def answer(command, *sets):
    words = [sys.argv[1], *command, "--json"] + [word for value in sets for word in ("--set", value)]
    return json.loads(subprocess.run(words, capture_output=True, text=True, check=True).stdout)


def mesh(name, *sets):
    found = answer(("mesh", str(CASE)), "input.speed=1000 rpm", *sets)["meshes"]
    return next(one for one in found if one["name"].startswith(name))


def over_two_periods(points):
    places, values = zip(*points)
    return places + tuple(1.0 + place for place in places), values * 2


def draw(axes, name):
    stiffness, error = axes
    plain = mesh(name)
    stiffness.plot(*over_two_periods([(f, 1e-6 * k) for f, k in plain["curve"]]), color="0.6", linestyle="-", label="stepped")
    for power in POWERS:
        result = mesh(name, *LOADED, f"input.power={power}")
        found = result["transmission_error"]
        label = f"{found['force_N'] / 1e3:.3g} kN"
        stiffness.plot(*over_two_periods([(f, found["force_N"] / e) for f, e in found["curve_um"]]), label=label)
        error.plot(*over_two_periods([(f, (e - found["mean_um"]) / found["mean_um"]) for f, e in found["curve_um"]]),
                   label=label)
    found = plain["transmission_error"]
    error.plot(*over_two_periods([(f, (e - found["mean_um"]) / found["mean_um"]) for f, e in found["curve_um"]]),
               color="0.6", linestyle="-", zorder=0)
    stiffness.set(title=f"{name} and planet", ylim=(0.0, None))
    error.set(xlabel="mesh periods (-)")
    for one in axes:
        one.set_xlim(0.0, 2.0)


def errors():
    for name in ("sun", "ring"):
        for option, sets in OPTIONS.items():
            found = mesh(name, *sets)["transmission_error"]
            waves = ", ".join(f"{wave:.2f}" for wave in found["harmonics_um"][:3])
            print(f"| {name} | {option} | {found['mean_um']:.2f} | {found['peak_to_peak_um']:.2f} | {waves} |")


def accelerations():
    for option, sets in OPTIONS.items():
        row = [option]
        for speed in SPEEDS:
            result = answer(("run", str(CASE), "--gears"), f"input.speed={speed} rpm", *sets)
            found = result["planet_acceleration_m_per_s2"]
            row.append(f"{found['x']['rms']:.0f}, {found['y']['rms']:.0f}; {found['housing_rms']:.0f}")
        print("| " + " | ".join(row) + " |")


def main():
    figure, axes = plt.subplots(2, 2, figsize=(style.WIDTH, 5.2), sharex=True)
    for column, name in enumerate(("sun", "ring")):
        draw(axes[:, column], name)
    axes[0, 0].set_ylabel("force / transmission error\n(N/µm)")
    axes[1, 0].set_ylabel("(transmission error - mean) / mean\n(-)")
    axes[0, 0].legend(ncols=2, loc="lower center", title="mean force of the mesh")
    figure.savefig(HERE / "reducer.png")
    errors()
    accelerations()


if __name__ == "__main__":
    main()
