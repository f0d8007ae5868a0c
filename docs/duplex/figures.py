"""Pictures and table of docs/duplex: python3 docs/duplex/figures.py PROGRAM (a minute)."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import netCDF4
import numpy as np
import yaml

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import MaxNLocator, NullFormatter  # noqa: E402

HERE = Path(__file__).parent
CASE = HERE.parent.parent / "cases" / "duplex_7020"
DASHED = {"tilt_y": (0, (3, 3)), "radial_y": (0, (3, 3))}  # over the curve of the other direction
COLOURS = (style.BLACK, style.ORANGE, style.GREEN, style.BLUE, style.SKY)
KINDS = ["tilt_x", "tilt_y", "axial_z", "radial_x", "radial_y"]
NAMES = {15: "7020C", 30: "7020A"}
# The linear formulas with the least squares of the measured frequencies of 7020C.
LINEAR = ("stiffness=linear", "linear.mass=10.349029 kg", "linear.first_lever=39.900883 mm", "linear.second_lever=0.146069 mm",
          "linear.inertia_x=0.10208535 kg.m2", "linear.inertia_y=0.08735217 kg.m2")


def call(program, command, *settings, more=()):
    options = [word for setting in settings for word in ("--set", setting)]
    done = subprocess.run([program, command, str(CASE / "case.yaml"), "--json", *options, *more],
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def frequencies(program, *settings):
    return [mode["frequency_Hz"] for mode in call(program, "modes", *settings)["modes"]]


def published(calculated):
    """A column of the source by contact angle and preload."""
    table = {}
    for row in yaml.safe_load((CASE / "expected.yaml").read_text())["published"]:
        settings = dict(setting.split("=") for setting in row.get("settings", []))
        if (settings.get("stiffness") == "linear") == calculated:
            pair = int(settings["bearing.contact_angle"].split()[0]), int(settings["preload"].split()[0])
            mode = int(row["quantity"].split("/")[2])  # modes:/modes/MODE/frequency_Hz
            table.setdefault(pair, {})[KINDS[mode]] = row["value"]
    return table


def over_preload(program):
    calculated, measured = published(True), published(False)
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH, 4.2), sharey=True)
    preloads = np.linspace(300, 4600, 18)
    for axis, angle in zip(axes, NAMES):
        curves = np.array([frequencies(program, f"bearing.contact_angle={angle} deg", f"preload={f:.0f} N")
                           for f in preloads])
        at = [f for of, f in measured if of == angle]
        linear = np.array([frequencies(program, f"bearing.contact_angle={angle} deg", f"preload={f} N", *LINEAR) for f in at])
        for k, kind in enumerate(KINDS):
            color = COLOURS[k]
            axis.plot(preloads, curves[:, k], color=color, label=kind, ls=DASHED.get(kind, "-"), zorder=2.2 if kind in DASHED else 2)
            axis.plot(at, [measured[angle, f][kind] for f in at], "o", color=color)
            axis.plot(at, [calculated[angle, f][kind] for f in at], "x", color=color)
            axis.plot(at, linear[:, k], ":", color=color, lw=1)
        axis.set(title=NAMES[angle], xlabel="preload (N)", yscale="log")
    axes[0].set_ylabel("natural frequency (Hz)")
    axes[1].plot([], [], "ko", label="measured")
    axes[1].plot([], [], "kx", label="calculated by the source")
    axes[1].plot([], [], "k:", label="linear, fitted to 7020C measured")
    style.legend_on_top(figure, axes[1], 3, 0.17)
    axes[1].set_yticks([200, 300, 500, 1000, 2000], ["200", "300", "500", "1000", "2000"])
    axes[1].yaxis.set_minor_formatter(NullFormatter())
    figure.savefig(HERE / "preload.png")


def over_geometry(program):
    figure, axes = plt.subplots(1, 3, figsize=(style.WIDTH, 3.4), sharey=True)
    angles, places, balls = np.linspace(12, 40, 29), np.linspace(0, 18, 7), np.arange(8, 25, 2)
    sets = [("contact angle (deg)", angles, lambda v: ("preload=1960 N", f"bearing.contact_angle={v} deg")),
            ("angle of the first ball (deg)", places,
             lambda v: ("preload=1960 N", "bearing.contact_angle=25 deg", f"bearing.first_element_angle={v} deg")),
            ("number of balls (-)", balls,
             lambda v: ("preload=1960 N", "bearing.contact_angle=25 deg", f"bearing.balls={v}"))]
    for axis, (label, values, settings) in zip(axes, sets):
        for stiffness, dashes in (("nonlinear", "-"), ("linear", ":")):
            curves = np.array([frequencies(program, f"stiffness={stiffness}", *settings(v)) for v in values])
            for k, kind in enumerate(KINDS):
                axis.plot(values, curves[:, k], dashes, color=COLOURS[k], lw=1.2, label=kind if dashes == "-" else None)
        axis.set(xlabel=label)
    axes[0].set_ylabel("natural frequency (Hz); dotted: linear")
    style.legend_on_top(figure, axes[0], 5)
    figure.savefig(HERE / "geometry.png")


def over_speed(program):
    """Also prints the table of the text, of both arrangements."""
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH, 3.8), sharey=True)
    speeds = "operation.speeds=[" + ", ".join(f"{v} rpm" for v in range(0, 15001, 500)) + "]"
    for axis, arrangement in zip(axes, ("tandem", "face-to-face")):
        rows = call(program, "modes", f"arrangement={arrangement}", speeds)["over_speed"]
        for k, kind in enumerate(KINDS):
            axis.plot([row["speed_rpm"] for row in rows], [row[f"{kind}_Hz"] for row in rows], color=COLOURS[k], lw=1.2,
                      ls=DASHED.get(kind, "-"), zorder=2.2 if kind in DASHED else 2, label=kind)
        axis.set(title=f"7020C, {arrangement}, 540 N", xlabel="shaft speed (rpm)")
        axis.xaxis.set_major_locator(MaxNLocator(4))
        style.thousands(axis.xaxis)
        for row in rows[::10]:
            print("| " + " | ".join([arrangement, f"{row['speed_rpm']:.0f}", *(f"{row[kind + '_Hz']:.0f}" for kind in KINDS),
                                     f"{row['inner_angle_deg']:.1f}, {row['outer_angle_deg']:.1f}",
                                     f"{row['inner_load_max_N']:.0f}, {row['outer_load_max_N']:.0f}"]) + " |")
    axes[0].set_ylabel("natural frequency (Hz)")
    style.legend_on_top(figure, axes[1], 5)
    figure.savefig(HERE / "speed.png")


def shapes_and_response(program, work):
    result = call(program, "run", "bearing.contact_angle=25 deg", "preload=830 N", more=("-o", str(work / "a5")))
    file = netCDF4.Dataset(next((work / "a5" / "points").glob("*.nc")))
    figure, axes = plt.subplots(2, 5, figsize=(style.WIDTH, 5.2))
    lever = np.array([-85.0, 85.0])  # ends of the cylinder, from its mass centre
    for axis, mode in zip(axes[0], result["modes"]):
        shape = np.array(list(mode["shape"].values()))
        size = max(np.abs(shape[:3]).max(), 0.085 * np.abs(shape[3:]).max())
        across, tilt = (0, 3) if abs(shape[0]) + abs(shape[3]) >= abs(shape[1]) + abs(shape[4]) else (1, 4)
        for scale, dashes in ((0.0, "--"), (30.0 / size, "-")):
            along = lever + scale * shape[2]
            offset = scale * (shape[across] - 1e-3 * lever * shape[tilt])
            for edge in (-50, 50):
                axis.plot(along, offset + edge, "k" + dashes, lw=0.8 if scale == 0 else 1.5)
            for end in (0, 1):
                axis.plot([along[end]] * 2, [offset[end] - 50, offset[end] + 50], "k" + dashes, lw=0.8 if scale == 0 else 1.5)
        axis.set(title=f"{mode['kind']}\n{mode['frequency_Hz']:.0f} Hz", aspect="equal", xlabel="z (mm)", xticks=(-100, 100), yticks=(-100, 0, 100),
                 ylabel="xy"[across] + " (mm)", xlim=(-130, 130), ylim=(-130, 130))
    for axis in axes[1]:
        axis.remove()
    grid = axes[1][0].get_gridspec()
    response = figure.add_subplot(grid[1, :])
    for direction in "xyz":
        value = file[f"accelerance_{direction}_real"][:] + 1j * file[f"accelerance_{direction}_imaginary"][:]
        response.semilogy(file["frequency"][:], np.abs(value), label=direction, lw=1.2,
                          ls="--" if direction == "y" else "-")
    response.set(xlim=(20, None), ylim=(1e-4, 50), xlabel="frequency (Hz)", ylabel="acceleration / force (1/kg)")
    response.legend()
    figure.savefig(HERE / "shapes.png")


def errors(program, measured, angle, settings):
    """Mean and largest magnitude over the frequencies of one bearing [%]."""
    found = [100 * abs(ours / theirs - 1) for (of, f), row in measured.items() if of == angle
             for ours, theirs in zip(frequencies(program, f"bearing.contact_angle={of} deg", f"preload={f} N", *settings), row.values())]
    return f"{np.mean(found):.1f}, {max(found):.1f}"


def table(program):
    """Errors with the shaft of each choice, which is the least squares of 7020C."""
    print("| choice | m [kg] | L [mm] | J [kg m2] | fit 7020C mean, worst [%] | 7020A mean, worst [%] |\n|---|---|---|---|---|---|")
    choices = [("as the case has it", 11.38, 12.38, 0.0394), ("cylinder of 90 mm", 11.16, 14.37, 0.0521), ("cylinder of 110 mm", 12.08, 12.00, 0.0355),
               ("outer osculation 0.515, as Table 1 prints", 12.04, 12.92, 0.0458, "bearing.outer_osculation=0.515"),
               ("free housing of 30 kg, 0.25 kg m2", 17.19, 18.25, 0.1222, "housing.mass=30 kg", "housing.inertia=0.25 kg.m2"),
               ("rows face to face", 10.50, 29.24, 0.0319, "arrangement=face-to-face")]
    measured = published(False)
    for name, mass, lever, inertia, *more in choices:
        shaft = [f"spindle.mass={mass} kg", f"spindle.first_lever={lever} mm", f"spindle.second_lever={lever} mm", "spindle.diameter=null",
                 "spindle.density=null", f"spindle.inertia_x={inertia} kg.m2", f"spindle.inertia_y={inertia} kg.m2"]
        print(f"| {name} | {mass:.2f} | {lever:.2f} | {inertia:.4f} | " +
              " | ".join(errors(program, measured, angle, [*shaft, *more]) for angle in NAMES) + " |")


if __name__ == "__main__":
    program = str(Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        table(program)
        over_preload(program)
        over_geometry(program)
        over_speed(program)
        shapes_and_response(program, Path(folder))
