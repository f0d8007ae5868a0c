"""Figure of docs/helical.md: python3 docs/helical/figures.py PROGRAM."""

import json
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE.parents[1] / "cases" / "mesh_62_62" / "case.yaml"
ANGLES = (0.0, 7.5, 15.0, 25.0)  # [deg]


def mesh(angle):
    command = [sys.argv[1], "mesh", str(CASE), "--json", "--set", f"pair.helix_angle={angle} deg"]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["meshes"][0]


def main():
    figure, axes = plt.subplots(figsize=(7.0, 3.8), layout="constrained")
    for angle in ANGLES:
        result = mesh(angle)
        fractions, stiffness = zip(*result["curve"])
        fractions, stiffness = fractions + tuple(1.0 + f for f in fractions), stiffness * 2
        axes.plot(fractions, [1e-6 * k for k in stiffness],
                  label=f"{angle:g}°: overlap {result['overlap_ratio']:.2f}")
        mean, standard = 1e-6 * result["mean_N_per_m"], 1e-6 * result["iso6336"]["mean_N_per_m"]
        swing = 100.0 * (result["max_N_per_m"] - result["min_N_per_m"]) / result["mean_N_per_m"]
        print(f"| {angle:g} | {result['contact_ratio']:.3f} | {result['overlap_ratio']:.3f} | {mean:.1f} | {swing:.1f} "
              f"| {standard:.1f} |")
    axes.set(xlabel="mesh periods since a pair came into contact in the middle of the face",
             ylabel="mesh stiffness [N/µm]", xlim=(0.0, 2.0), ylim=(0.0, None))
    axes.legend(ncols=2, frameon=False, loc="lower center")
    axes.grid(alpha=0.3)
    figure.savefig(HERE / "stiffness.png", dpi=130)


if __name__ == "__main__":
    main()
