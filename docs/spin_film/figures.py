"""Pictures of docs/spin_film.md: python3 docs/spin_film/figures.py PROGRAM (seconds)."""
import json
import subprocess
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = Path(__file__).parent
CASES = HERE.parent.parent / "cases"


def call(program, command, case, *settings):
    options = [word for setting in settings for word in ("--set", setting)]
    done = subprocess.run([program, command, str(CASES / case / "case.yaml"), "--json", *options], capture_output=True,
                          text=True, check=True)
    return json.loads(done.stdout)


def spin(program):
    """As far as regressions go: Fig. 4 of the source draws whole films."""
    points = ", ".join(f"[200 N, 5 m/s, {spin} rad/s]" for spin in range(0, 501, 10))
    rows = call(program, "run", "spin_film_guo2013", f"points=[{points}]")["film"]
    figure, axis = plt.subplots(figsize=(5, 3.4), constrained_layout=True)
    x = [row["spin_rad_s"] for row in rows]
    for key, label in (("h_c_um", "central"), ("h_min_um", "least"), ("h_min_HamrockDowson_um", "least, without spin")):
        axis.plot(x, [row[key] for row in rows], "--" if "without" in label else "-", label=label)
    axis.set(xlabel="spin (rad/s)", ylabel="film (um)", title="200 N, 5 m/s", ylim=(0, None))
    axis.legend()
    figure.savefig(HERE / "spin.png", dpi=90)


def bearing(program):
    result = call(program, "run", "spin_bearing_7210")
    rows = [row for row in result["over_speed"] if row["speed_rpm"] > 0]
    x = [row["speed_rpm"] for row in rows]

    def draw(axis, key, label, **style):
        axis.plot(x, [row[key] for row in rows], label=label, **style)

    figure, axes = plt.subplots(3, 2, figsize=(10, 10), constrained_layout=True)
    for axis, quantity, title in ((axes[0, 0], "load_N", "contact load (N)"), (axes[0, 1], "contact_angle_deg", "contact angle (deg)"),
                                  (axes[1, 1], "approach_um", "approach of the bodies (um)")):
        for race, colour in (("inner", "C0"), ("outer", "C1")):
            draw(axis, f"hertz_{race}_{quantity}", f"{race}, Hertz", color=colour, ls="--")
            draw(axis, f"film_{race}_{quantity}", f"{race}, film", color=colour)
        axis.set(ylabel=title)
    draw(axes[1, 0], "hertz_axial_um", "Hertz", ls="--")
    draw(axes[1, 0], "film_axial_um", "film")
    axes[1, 0].set(ylabel="axial displacement (um)")
    for axis, race in ((axes[2, 0], "inner"), (axes[2, 1], "outer")):
        for key, label, style in (("h_c_um", "central", "-"), ("h_min_um", "least", "-"), ("h_min_HamrockDowson_um", "least, without spin", "--")):
            draw(axis, f"film_{race}_{key}", label, ls=style)
        turn = result["least_film_turns_at_rpm"][race]
        if turn:
            axis.axvline(turn, color="0.7", lw=0.8)
            axis.text(turn, 0, f" {turn:.0f} rpm", fontsize=8, va="bottom")
        fast = [row["speed_rpm"] for row in rows if row[f"film_{race}_spin_rad_s"] and abs(row[f"film_{race}_spin_rad_s"]) > 500]
        if fast:
            axis.axvspan(min(fast), max(x), color="0.9")
        axis.set(ylabel=f"film, {race} contact (um)", ylim=(0, None))
    for axis in axes.flat:
        axis.set(xlabel="speed (rpm)")
        axis.legend(fontsize=8)
    figure.savefig(HERE / "bearing_7210.png", dpi=90)
    print("turning points of the least film:", result["least_film_turns_at_rpm"])
    for row in rows[::5]:
        print(f"{row['speed_rpm']:6.0f} rpm: axial {row['hertz_axial_um']:.3f} / {row['film_axial_um']:.3f} um, "
              f"difference {row['hertz_axial_um'] - row['film_axial_um']:.3f}; spin {row['film_inner_spin_rad_s']:.0f}, "
              f"{row['film_outer_spin_rad_s']:.0f} rad/s")


def stiffness(program):
    points = call(program, "stiffness", "spin_bearing_7210")["points"]
    dry = call(program, "stiffness", "spin_bearing_7210", "film.enabled=false")["points"]
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.4), constrained_layout=True)
    for axis, i, title in ((axes[0], 0, "across (N/m)"), (axes[1], 2, "axial (N/m)"), (axes[2], 3, "tilt (N m/rad)")):
        for rows, label, style in ((dry, "Hertz", "--"), (points, "film", "-")):
            axis.plot([row["speed_rpm"] for row in rows], [row["stiffness"][i][i] for row in rows], style, label=label)
        axis.set(xlabel="speed (rpm)", ylabel=title)
        axis.legend()
    figure.savefig(HERE / "stiffness.png", dpi=90)


if __name__ == "__main__":
    spin(sys.argv[1])
    bearing(sys.argv[1])
    stiffness(sys.argv[1])
