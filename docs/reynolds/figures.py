"""Pictures of docs/reynolds.md: python3 docs/reynolds/figures.py PROGRAM (a minute)."""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
import matplotlib.pyplot as plt  # noqa: E402

HERE = Path(__file__).parent
CASE = HERE.parent.parent / "cases" / "spin_film_guo2013" / "case.yaml"


def films(program, points, *settings):
    """Rows of films and, by Reynolds' equation, their maps."""
    with tempfile.TemporaryDirectory() as folder:
        words = ["--set", "contact.ellipticity=3", "--set", "points=[" + ", ".join(f"[{q} N, {v} m/s, {s} rad/s]" for q, v, s in points) + "]"]
        for setting in settings:
            words += ["--set", setting]
        subprocess.run([program, "run", str(CASE), "--output", folder, *words], capture_output=True,
                              text=True, check=True)
        maps = []
        for i in range(len(points)):
            path = Path(folder) / f"film_map_{i + 1}.csv"
            if not path.exists():
                continue
            with path.open() as file:
                rows = [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]
            data = np.array(rows)
            shape = (len(np.unique(data[:, 1])), len(np.unique(data[:, 0])))
            maps.append([column.reshape(shape) for column in data.T])
        films_file = Path(folder) / "film.csv"
        with films_file.open() as file:
            return list(csv.DictReader(file)), maps


def maps(program):
    """Film and pressure, without spin and with much of it."""
    spins = (0, 20000)
    _, found = films(program, [(20, 5, spin) for spin in spins], "film.solver=reynolds")
    figure, axes = plt.subplots(1, 2, figsize=(style.WIDTH, 4.6), sharey=True)
    for axis, spin, (x, y, pressure, film, _) in zip(axes, spins, found):
        levels = np.linspace(0.2, 0.8, 25)
        drawn = axis.contourf(x, y, film, levels, extend="both", cmap="viridis")
        axis.contour(x, y, pressure, [0.05, 0.2, 0.4, 0.6], colors="white", linewidths=0.8)
        axis.grid(False)
        axis.set(xlim=(-0.25, 0.15), ylim=(-0.4, 0.4), xlabel="x, rolling direction (mm)", title=f"spin {spin} rad/s")
    axes[0].set_ylabel("y (mm)")
    figure.colorbar(drawn, ax=axes, label="film (µm)")
    figure.savefig(HERE / "maps.png")


def over_spin(program):
    points = [(20, 5, spin) for spin in (0, 250, 500, 1000, 2000, 4000, 6000, 9000, 12000)]
    solved, _ = films(program, points, "film.solver=reynolds")
    regression, _ = films(program, points)
    figure, axis = plt.subplots(figsize=(style.WIDTH, 3.6))
    x = [float(row["spin_rad_s"]) for row in solved]
    for key, colour in (("h_c_um", style.BLACK), ("h_min_um", style.VERMILION)):
        label = "central" if key == "h_c_um" else "minimum"
        axis.plot(x, [float(row[key]) for row in solved], "o-", color=colour, label=label + ", Reynolds")
        axis.plot(x, [float(row[key]) for row in regression], "--", color=colour, label=label + ", regression")
    axis.set(xlabel="spin (rad/s)", ylabel="film (µm)", title="20 N, 5 m/s, ellipticity 3", ylim=(0, None))
    axis.legend()
    figure.savefig(HERE / "spin.png")


if __name__ == "__main__":
    maps(sys.argv[1])
    over_spin(sys.argv[1])
