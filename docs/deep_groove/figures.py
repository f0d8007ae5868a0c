"""Tables and pictures of docs/deep_groove.md: python3 docs/deep_groove/figures.py PROGRAM (some minutes)."""
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

HERE = Path(__file__).parent
CASES = HERE.parent.parent / "cases"
CONDITIONS = [(1730, 938), (3703, 903), (1785, 266), (3998, 206)]
NASA_RPM, NASA_HEAT = [28000, 48000, 64000, 72000], [350, 700, 1100, 1400]
CAUSES = ["sliding", "differential_slip", "spin", "rolling", "contact_damping", "cage", "churning"]


def run(program, case, folder, *settings):
    options = [word for setting in settings for word in ("--set", setting)]
    command = [program, "run", str(CASES / case / "case.yaml"), "--json", "-o", str(folder), *options]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(done.stdout), netCDF4.Dataset(next((Path(folder) / "points").glob("*.nc")))


def motor(program, work):
    figure, axes = plt.subplots(2, 2, figsize=(style.WIDTH, 5.6))
    print("| condition | settled [ms] | slip [%] | largest impact [N] | heat [W] | life [h] |\n|---|---|---|---|---|---|")
    for number, (rpm, load) in enumerate(CONDITIONS, 1):
        result, file = run(program, "deep_groove_motor", work / f"motor{number}", f"operation.shaft_speed={rpm} rpm",
                           f"load.radial={load} N")
        label = f"{number}: {rpm} rpm, {load} N"
        settled = result["slip_settling_s"]
        print(f"| {label} | {'-' if settled is None else f'{1e3 * settled:.2f}'} | {100 * result['cage_slip']:.2f} | "
              f"{result['cage_impact_max_N']:.0f} | {result['heat_W']['total']:.2f} | {result['life_h']:.3g} |")
        time, slip = file["time"][:], 100 * file["cage_slip"][:]
        axes[0, 0].plot(1e3 * time, slip, label=label, lw=1.0)
        axes[0, 1].plot(1e3 * time, file["pocket_load"][:], label=label, lw=0.6)
        last = time > time[-1] - 0.1
        axes[1, 0].plot(1e3 * (time[last] - time[last][0]), file["first_ball_inner_load"][:][last], label=label, lw=0.8)
        axes[1, 1].plot(1e6 * file["cage_x"][:][last], 1e6 * file["cage_y"][:][last], label=label, lw=0.5)
    axes[0, 0].set(xlim=(0, 30), ylim=(-10, 100), xlabel="time (ms)", ylabel="slip of the cage (%)")
    axes[0, 1].set(xlabel="time (ms)", ylabel="largest load\non the cage (N)", yscale="symlog", ylim=(0, None))
    axes[1, 0].set(xlabel="time in the last 0.1 s (ms)", ylabel="load of one ball\non the inner race (N)")
    axes[1, 1].set(xlabel="centre of the cage\nalong the load (µm)", ylabel="across the load (µm)", aspect="equal")
    style.legend_on_top(figure, axes[0, 0], 2)
    figure.savefig(HERE / "motor.png")


def run_up(program, work):
    result, file = run(program, "deep_groove_acceleration", work / "up")
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH, 3.2))
    axes[0].plot(file["time"][:], file["first_ball_inner_load"][:], lw=0.6)
    axes[0].set(xlabel="time (s)", ylabel="load of one ball\non the inner race (N)")
    axes[1].plot(file["time"][:], 100 * file["cage_slip"][:], lw=0.6)
    axes[1].set(xlabel="time (s)", ylabel="slip of the cage (%)", ylim=(-10, 30))
    figure.savefig(HERE / "run_up.png")
    time, load = file["time"][:], file["first_ball_inner_load"][:]
    print(f"\nrun-up: largest load of the ball {load.max():.0f} N before 0.2 s {load[time < 0.2].max():.0f} N, "
          f"after 0.5 s {load[time > 0.5].max():.0f} N; slip {100 * result['cage_slip']:.2f} %")


def nasa(program, work):
    print("\n| speed [rpm] | measured [W] | ours [W] | " + " | ".join(CAUSES) + " | slip [%] |\n|" + "---|" * (4 + len(CAUSES)))
    shares = []
    for rpm, measured in zip(NASA_RPM, NASA_HEAT):
        result, _ = run(program, "nasa_35mm", work / f"nasa{rpm}", f"operation.shaft_speed={rpm} rpm")
        heat = result["heat_W"]
        shares.append([heat[cause] for cause in CAUSES])
        print(f"| {rpm} | {measured} | {heat['total']:.0f} | " + " | ".join(f"{heat[c]:.1f}" for c in CAUSES)
              + f" | {100 * result['cage_slip']:.2f} |")
    figure, axes = plt.subplots(figsize=(style.WIDTH, 4.0))
    axes.stackplot(NASA_RPM, np.maximum(np.array(shares).T, 0.0), labels=[cause.replace("_", " ") for cause in CAUSES], colors=plt.get_cmap("cividis")(np.linspace(0.05, 1.0, len(CAUSES))), edgecolor="white", lw=0.8)
    axes.errorbar(NASA_RPM, NASA_HEAT, yerr=0.05 * np.array(NASA_HEAT), fmt="ko", label="measured, as read")
    axes.set(xlabel="shaft speed (rpm)", ylabel="heat (W)", ylim=(0, None))
    axes.legend(loc="upper left")
    style.thousands(axes.xaxis)
    figure.savefig(HERE / "nasa.png")


def nasa_worth(program, work):
    """What single assumptions are worth at 64,000 rpm, in the base model: constant share of oil at the inlet's temperature."""
    base = ["lubricant.fill=stated", "lubricant.share=0.05", "heat.enabled=false", "traction.inlet_heating=none",
            "traction.ball_rolling_law=houpert", "traction.starvation=none"]
    changes = {"as assumed": [], "viscosity 0.0025 Pa s": ["lubricant.viscosity=0.0025 Pa.s"],
               "viscosity 0.005 Pa s": ["lubricant.viscosity=0.005 Pa.s"], "oil share 0.02": ["lubricant.share=0.02"],
               "oil share 0.15": ["lubricant.share=0.15"],
               "oil at rest": ["drag.mixture=at-rest"], "oil flow 0.3 L/min": ["lubricant.flow=0.3 L/min"],
               "oil flow 1.9 L/min": ["lubricant.flow=1.9 L/min"], "cage guided by the inner ring":
               ["bearing.cage.guidance=inner", "bearing.cage.guide_land_diameter=43.6 mm"],
               "limiting friction 0.04": ["traction.limiting_friction=0.04"],
               "Newtonian up to the limit": ["traction.law=limiting-shear"], "pocket clearance 0.2 mm":
               ["bearing.cage.pocket_clearance=0.2 mm"], "no rolling resistance": ["traction.rolling_resistance=false"]}
    print("\n| 64,000 rpm | heat [W] |\n|---|---|")
    for number, (name, settings) in enumerate(changes.items()):
        result, _ = run(program, "nasa_35mm", work / f"worth{number}", "operation.shaft_speed=64000 rpm", *base, *settings)
        print(f"| {name} | {result['heat_W']['total']:.0f} |")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        for part in (motor, run_up, nasa, nasa_worth):
            part(sys.argv[1], Path(place))
