"""Random but sensible drivetrains in motion: how many complete, why the others do not, and how long a point takes.

    random_motion.py [--count N] [--seed S] [--first K] [--seconds S] [--jobs N] [--keep DIR]

Wind stages, e-drive reducers and industrial stages; caged and full complement; both rings, an outer ring, none; clearance
-10 to +150 um; film on and off. Speeds from 1 to 20,000 rpm. Each is one point of `run --fidelity dynamic`. What `check` refuses
is no drivetrain and is drawn again. Needs ORBEARING.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time

PROGRAM = os.environ["ORBEARING"]
FAMILIES = {  # power [kW], speed [rpm], driving member, sun teeth, planets, permitted pressure number [MPa]
    "wind": ((200, 4000), (1, 30), "carrier", (17, 28), (3, 5), (1.2, 2.5)),
    "e-drive": ((30, 300), (2000, 20000), "sun", (19, 40), (3, 4), (0.8, 2.0)),
    "industrial": ((2, 800), (60, 3600), "sun", (17, 36), (3, 4), (0.8, 2.2)),
}
MODULES = (0.8, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 14, 16, 18, 20, 22, 25)


def between(draw, low, high):
    """Evenly spread over orders of magnitude."""
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def gears(draw, family):
    """Teeth, module and face that carry the torque."""
    power, speed, member, suns, counts, pressure = FAMILIES[family]
    planets, sun = draw.randint(*counts), draw.randint(*suns)
    planet = draw.randint(round(0.7 * sun), round(1.8 * sun))
    ring = sun + 2 * planet
    while (sun + ring) % planets:
        planet += 1
        ring = sun + 2 * planet
    kw, rpm = between(draw, *power), between(draw, *speed)
    torque = kw * 1e3 / (rpm * math.pi / 30)  # N m
    of_sun = torque / (1 + ring / sun) if member == "carrier" else torque
    ratio = planet / sun
    # Tangential force over diameter of the sun and face is the pressure number times ratio / (1 + ratio).
    load = draw.uniform(*pressure) * ratio / (1 + ratio)  # N/mm2
    slender = draw.uniform(0.6, 1.2)                      # face over diameter of the sun
    diameter = (2e3 * of_sun / planets / (load * slender)) ** (1 / 3)
    module = min(MODULES, key=lambda one: abs(math.log(one * sun / diameter)))
    return {"kW": kw, "rpm": rpm, "member": member, "planets": planets, "teeth": (sun, planet, ring), "module": module,
            "face": round(slender * module * sun, 1), "helix": draw.choice((0, 0, 0, 8, 15, 22))}


def bearing(draw, g):
    """Rollers in what the planet leaves."""
    outside = g["module"] * (g["teeth"][1] - 2.5) - 2 * 2.5 * g["module"]  # below a rim of 2.5 modules
    rings = draw.choice(("both", "outer", "none"))
    ring = {"both": 0.10, "outer": 0.10, "none": 0.0}[rings] * outside
    raceway = outside - ring
    roller = draw.uniform(0.10, 0.20) * raceway
    pitch = raceway - roller
    full = draw.random() < 0.35
    most = math.pi / math.asin(roller / pitch)
    count = math.floor(most * (0.99 if full else draw.uniform(0.70, 0.85)))
    rows = draw.choice((1, 1, 2))
    width = g["face"] / rows * 0.95
    length = min(width * 0.85, draw.uniform(1.0, 3.5) * roller)
    width = min(width, 1.25 * length)
    lines = [f"rings: {rings}", f"per_planet: {rows}", f"rollers: {max(count, 6)}", f"roller_diameter: {roller:.3f} mm",
             f"roller_length: {length:.3f} mm", f"pitch_diameter: {pitch:.3f} mm",
             f"radial_clearance: {draw.uniform(-10, 150):.1f} um", f"width: {width:.3f} mm"]
    if rings != "none":
        lines.append(f"outside_diameter: {outside:.3f} mm")
    if rings == "both":
        lines.append(f"bore: {pitch - roller - ring:.3f} mm")
    if full:
        lines.append("complement: full")
    else:
        material = draw.choice(("steel", "brass", "polyamide"))
        half = 0.3 * roller
        lines.append(f"cage: {{material: {material}, inner_diameter: {pitch - half:.3f} mm, outer_diameter: {pitch + half:.3f} mm, "
                     f"width: {width * 0.95:.3f} mm, guide_land_diameter: {pitch + 1.1 * half + 0.05:.3f} mm}}")
    return lines


def case_text(draw):
    """(family, speed in rpm, text of a case)."""
    family = draw.choice(tuple(FAMILIES))
    g = gears(draw, family)
    film = draw.random() < 0.6
    grade = {"wind": 320, "e-drive": 32, "industrial": 150}[family]
    lines = ["name: random", "source: drawn at random", "model: planetary-drivetrain",
             f"input: {{member: {g['member']}, power: {g['kW']:.4g} kW, speed: {g['rpm']:.5g} rpm}}",
             "gearset:", f"  planets: {g['planets']}",
             "  teeth: {{sun: {}, planet: {}, ring: {}}}".format(*g["teeth"]), f"  module: {g['module']} mm",
             f"  profile_shift: {{sun: {draw.uniform(0.0, 0.3):.2f}, ring: 0}}", f"  face_width: {g['face']} mm", f"  helix_angle: {g['helix']} deg", "bearing:", "  type: cylindrical-roller",
             *(f"  {line}" for line in bearing(draw, g)),
             f"lubricant: {{grade: ISO VG {grade}, temperature: {draw.uniform(40, 100):.0f} degC}}",
             f"film: {{enabled: {'true' if film else 'false'}}}", f"contact: {{squeeze: {draw.choice(('true', 'false'))}}}"]
    return family, g["rpm"], "\n".join(lines) + "\n"


def computed(task):
    """One drivetrain: {index, family, rpm, status, seconds, reason}."""
    index, seed, seconds, keep = task
    draw = random.Random(f"{seed}/{index}")
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "case.yaml"
        for _ in range(50):
            family, rpm, text = case_text(draw)
            file.write_text(text, encoding="utf-8")
            refused = subprocess.run([PROGRAM, "check", file, "--json"], capture_output=True, text=True)
            if refused.returncode == 0:
                break
        else:
            return {"index": index, "family": family, "rpm": rpm, "status": "never accepted", "seconds": 0.0, "reason": refused.stderr}
        begin = time.monotonic()
        try:
            done = subprocess.run([PROGRAM, "run", file, "--fidelity", "dynamic", "--json"], capture_output=True, text=True,
                                  timeout=seconds)
            took = time.monotonic() - begin
            status, reason = "completed", ""
            if done.returncode != 0:
                status, reason = "failed", done.stderr.strip()
            else:
                point = json.loads(done.stdout)["points"][0]
                if point["status"] != "ok":
                    status, reason = point["status"], point.get("message", "")
        except subprocess.TimeoutExpired:
            took, status, reason = seconds, "too long", f"not within {seconds} s"
        if keep and status != "completed":
            (pathlib.Path(keep) / f"{index}.yaml").write_text(f"# {status}: {reason[:200]}\n{text}".replace("\n# ", " "), encoding="utf-8")
    return {"index": index, "family": family, "rpm": rpm, "status": status, "seconds": took, "reason": reason}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=50)
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", help="folder of the cases that do not complete")
    options = parser.parse_args()
    if options.keep:
        pathlib.Path(options.keep).mkdir(parents=True, exist_ok=True)
    tasks = [(index, options.seed, options.seconds, options.keep) for index in range(options.first, options.first + options.count)]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = []
        for one in pool.map(computed, tasks):
            results.append(one)
            if one["status"] != "completed":
                print(f"{one['index']}: {one['family']}, {one['rpm']:.4g} rpm: {one['status']} after {one['seconds']:.1f} s: {one['reason'][:300]}", flush=True)
    done = [one for one in results if one["status"] == "completed"]
    took = sorted(one["seconds"] for one in results) or [0.0]
    print(f"{len(done)} of {len(results)} complete ({100 * len(done) / len(results):.1f} %); seconds: median {statistics.median(took):.2f}, "
          f"95 % {took[int(0.95 * (len(took) - 1))]:.2f}, worst {took[-1]:.2f}")
    for family in FAMILIES:
        of = sorted(one["seconds"] for one in results if one["family"] == family)
        if of:
            print(f"  {family}: {sum(one['family'] == family for one in done)} of {len(of)}; median {statistics.median(of):.2f} s, worst {of[-1]:.2f}")
    return len(done) < 0.99 * len(results)


if __name__ == "__main__":
    sys.exit(main())
