"""Figure of docs/helical.md: python3 docs/helical/figures.py PROGRAM."""

import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from orbearing import style  # noqa: E402

style.use()
import matplotlib.pyplot as plt  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE.parents[1] / "cases" / "mesh_62_62" / "case.yaml"
ANGLES = (0.0, 7.5, 15.0, 25.0)  # [deg]


def mesh(angle):
    command = [sys.argv[1], "mesh", str(CASE), "--json", "--set", f"pair.helix_angle={angle} deg"]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["meshes"][0]


def main():
    figure, axes = plt.subplots(figsize=(style.WIDTH, 3.8))
    for angle in ANGLES:
        result = mesh(angle)
        fractions, stiffness = zip(*result["curve"])
        fractions, stiffness = fractions + tuple(1.0 + f for f in fractions), stiffness * 2
        axes.plot(fractions, [1e-6 * k for k in stiffness],
                  label=f"helix angle {angle:g}°, overlap ratio {result['overlap_ratio']:.2f}")
        mean, standard = 1e-6 * result["mean_N_per_m"], 1e-6 * result["iso6336"]["mean_N_per_m"]
        swing = 100.0 * (result["max_N_per_m"] - result["min_N_per_m"]) / result["mean_N_per_m"]
        print(f"| {angle:g} | {result['contact_ratio']:.3f} | {result['overlap_ratio']:.3f} | {mean:.1f} | {swing:.1f} "
              f"| {standard:.1f} |")
    axes.set(xlabel="mesh periods after contact of a pair at the middle of the face",
             ylabel="mesh stiffness (N/µm)", xlim=(0.0, 2.0), ylim=(0.0, None))
    axes.legend(ncols=2, loc="lower center")
    figure.savefig(HERE / "stiffness.png")


if __name__ == "__main__":
    main()
