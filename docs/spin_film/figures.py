"""Pictures of docs/spin_film.md: python3 docs/spin_film/figures.py PROGRAM (seconds)."""
import json
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402

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
    figure, axis = plt.subplots(figsize=(style.WIDTH, 3.6))
    x = [row["spin_rad_s"] for row in rows]
    for key, label in (("h_c_um", "central"), ("h_min_um", "minimum"), ("h_min_HamrockDowson_um", "minimum, without spin")):
        axis.plot(x, [row[key] for row in rows], "--" if "without" in label else "-", label=label)
    axis.set(xlabel="spin (rad/s)", ylabel="film (µm)", title="200 N, 5 m/s", ylim=(0, None))
    axis.legend()
    figure.savefig(HERE / "spin.png")


def bearing(program):
    result = call(program, "run", "spin_bearing_7210")
    rows = [row for row in result["over_speed"] if row["speed_rpm"] > 0]
    x = [row["speed_rpm"] for row in rows]

    def draw(axis, key, label, **look):
        axis.plot(x, [row[key] for row in rows], label=label, **look)

    figure, axes = plt.subplots(3, 2, figsize=(style.WIDTH, 8.6))
    for axis, quantity, title in ((axes[0, 0], "load_N", "contact load (N)"), (axes[0, 1], "contact_angle_deg", "contact angle (deg)"),
                                  (axes[1, 1], "approach_um", "approach of the bodies (µm)")):
        for race, colour in (("inner", style.BLACK), ("outer", style.VERMILION)):
            draw(axis, f"hertz_{race}_{quantity}", f"{race}, Hertz", color=colour, ls="--")
            draw(axis, f"film_{race}_{quantity}", f"{race}, film", color=colour, ls="-")
        axis.set(ylabel=title)
    draw(axes[1, 0], "hertz_axial_um", "Hertz", ls="--")
    draw(axes[1, 0], "film_axial_um", "film", ls="-")
    axes[1, 0].set(ylabel="axial displacement (µm)")
    for axis, race in ((axes[2, 0], "inner"), (axes[2, 1], "outer")):
        for key, label, dashes in (("h_c_um", "central", "-"), ("h_min_um", "minimum", "-"), ("h_min_HamrockDowson_um", "minimum, without spin", "--")):
            draw(axis, f"film_{race}_{key}", label, ls=dashes)
        turn = result["least_film_turns_at_rpm"][race]
        if turn:
            axis.axvline(turn, color="0.7", lw=0.8, ls="-")
            axis.text(turn, 0, f"largest minimum {turn:,.0f} rpm ", fontsize=8.5, va="bottom", ha="right")
        fast = [row["speed_rpm"] for row in rows if row[f"film_{race}_spin_rad_s"] and abs(row[f"film_{race}_spin_rad_s"]) > 500]
        if fast:
            axis.axvspan(min(fast), max(x), color="0.9")
        axis.set(ylabel=f"film, {race} contact (µm)", ylim=(0, None))
    for axis in axes.flat:
        axis.set(xlabel="speed (rpm)")
        axis.xaxis.set_major_locator(MaxNLocator(4))
        style.thousands(axis.xaxis)
        axis.legend()
    figure.savefig(HERE / "bearing_7210.png")
    print("turning points of the least film:", result["least_film_turns_at_rpm"])
    for row in rows[::5]:
        print(f"{row['speed_rpm']:6.0f} rpm: axial {row['hertz_axial_um']:.3f} / {row['film_axial_um']:.3f} um, "
              f"difference {row['hertz_axial_um'] - row['film_axial_um']:.3f}; spin {row['film_inner_spin_rad_s']:.0f}, "
              f"{row['film_outer_spin_rad_s']:.0f} rad/s")


def stiffness(program):
    points = call(program, "stiffness", "spin_bearing_7210")["points"]
    dry = call(program, "stiffness", "spin_bearing_7210", "film.enabled=false")["points"]
    figure, axes = plt.subplots(1, 3, figsize=(style.WIDTH, 3.0))
    for axis, i, title in ((axes[0], 0, "radial stiffness (N/µm)"), (axes[1], 2, "axial stiffness (N/µm)"), (axes[2], 3, "tilt stiffness (N m/mrad)")):
        for rows, label, dashes in ((dry, "Hertz", "--"), (points, "film", "-")):
            axis.plot([row["speed_rpm"] for row in rows], [row["stiffness"][i][i] * (1e-3 if i == 3 else 1e-6) for row in rows], dashes, label=label)
        axis.set(xlabel="speed (rpm)", ylabel=title)
        axis.xaxis.set_major_locator(MaxNLocator(3))
        style.thousands(axis.xaxis)
        axis.legend()
    figure.savefig(HERE / "stiffness.png")


if __name__ == "__main__":
    spin(sys.argv[1])
    bearing(sys.argv[1])
    stiffness(sys.argv[1])
