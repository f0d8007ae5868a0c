"""Random but sensible designs: how many complete, why the others do not, how long one takes, and how well `check` estimates it.

    random_motion.py [--kind drivetrains|system|balls] [--short] [--count N] [--seed S] [--first K] [--seconds S] [--jobs N] [--keep DIR]

drivetrains  wind stages, e-drive reducers and industrial stages; caged and full complement; both rings, an outer ring, none;
             clearance -10 to +150 um; film on and off; 1 to 20,000 rpm. Each is one point of `run --fidelity dynamic`.
system       the same with gears and bearings solved as one system (`--fidelity monolithic`)
balls        deep groove and angular-contact ball bearings, half of them quasi-static, half in motion over some revolutions of the shaft

Of motions of drivetrains that take a second or more the processor time is compared with the estimate of `check`. `--families` draws from
some kinds of drivetrains alone. `--short` observes one revolution of the cage after at most two. `--seconds` bounds the processor time of a design, and times are processor times.
What `check` or `run` refuse as input is no design and is drawn again, and so is a drivetrain whose point at rest is told to be implausible
(C/P below 0.2, say). Needs ORBEARING.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import resource
import signal
import statistics
import subprocess
import sys
import tempfile

PROGRAM = os.environ["ORBEARING"]
FAMILIES = {  # power [kW], speed [rpm], driving member, sun teeth, planets, permitted pressure number [MPa]
    "wind": ((200, 4000), (1, 30), "carrier", (17, 28), (3, 5), (1.2, 2.5)),
    "e-drive": ((30, 300), (2000, 20000), "sun", (19, 40), (3, 4), (0.8, 2.0)),
    "industrial": ((2, 800), (60, 3600), "sun", (17, 36), (3, 4), (0.8, 2.2)),
}
BALL_RUNS = ("quasi-static", "in motion")
BAD_INPUT = 2  # exit code
REVOLUTIONS = 6  # of the shaft of a ball bearing in motion
SHORT = ("simulation.observed_revolutions=1", "simulation.most_revolutions=2")
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


def case_text(draw, _, families):
    """(family, speed in rpm, text of a case)."""
    family = draw.choice(families)
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


def ball_text(draw, index, _):
    """(quasi-static or in motion, speed in rpm, text of a case)."""
    run = BALL_RUNS[index % 2]
    ball = between(draw, 3, 40)  # mm
    count = draw.randint(6, 20)
    pitch = ball / math.sin(math.pi / count) * draw.uniform(1.1, 1.5)
    angle = draw.choice((0, 0, 15, 25, 40))
    rpm = min(between(draw, 1, 20000), 1.2e6 / pitch)  # pitch diameter times speed, as oil-jet lubrication takes it
    size = 1e7 * (1e-3 * ball) ** 2  # N
    radial = draw.uniform(0.0 if angle else 0.1, 1.0) * size
    axial = draw.uniform(0.5, 2.0) * size if angle else draw.uniform(0.0, 0.2) * size
    steel = draw.random() < 0.5
    outer = draw.random() < 0.5
    guide = pitch + 0.3 * ball + 0.03 * ball if outer else pitch - 0.3 * ball - 0.03 * ball
    lines = ["name: random", "source: drawn at random", "model: ball-bearing",
             f"load: {{radial: {radial:.4g} N, axial: {axial:.4g} N}}", "bearing:", f"  balls: {count}", f"  ball_diameter: {ball:.4g} mm",
             f"  pitch_diameter: {pitch:.5g} mm", f"  inner_osculation: {draw.uniform(0.515, 0.54):.4f}", f"  outer_osculation: {draw.uniform(0.515, 0.54):.4f}",
             f"  contact_angle: {angle} deg",
             f"  radial_clearance: {0.0 if angle else draw.uniform(-0.3, 2.0) * ball:.2f} um",
             f"lubricant: {{grade: ISO VG {draw.choice((32, 68, 150))}, temperature: {draw.uniform(40, 100):.0f} degC}}",
             f"operation: {{shaft_speed: {rpm:.5g} rpm}}"]
    if run == "in motion":
        lines += ["simulation:", f"  duration: {REVOLUTIONS * 60 / rpm:.5g} s"]
        cage = [f"inner_diameter: {pitch - 0.3 * ball:.5g} mm", f"outer_diameter: {pitch + 0.3 * ball:.5g} mm", f"width: {1.5 * ball:.4g} mm",
                f"density: {7850 if steel else 1310} kg/m3", f"guidance: {'outer' if outer else 'inner'}", f"guide_land_diameter: {guide:.5g} mm"]
        bodies = (f"  cage: {{{', '.join(cage)}}}", f"  bore: {max(0.3 * pitch, pitch - 2 * ball):.5g} mm",
                  f"  outside_diameter: {pitch + 2 * ball:.5g} mm", f"  width: {1.8 * ball:.4g} mm")
        lines[lines.index("bearing:") + 1:lines.index("bearing:") + 1] = bodies
    return run, rpm, "\n".join(lines) + "\n"


KINDS = {"drivetrains": (case_text, tuple(FAMILIES), "dynamic"), "system": (case_text, tuple(FAMILIES), "monolithic"), "balls": (ball_text, BALL_RUNS, None)}


def processor_time():
    """Of all that this process has run [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def outcome(done):
    """(status, reason) of a run that ended."""
    if done.returncode != 0:
        return "failed", done.stderr.strip()
    status = json.loads(done.stdout).get("points", [{"status": "ok"}])[0]["status"]
    return ("completed", "") if status == "ok" else ("failed", status)


def implausible(file):
    """Whether no machine is built like this, as the point at rest says."""
    done = subprocess.run([PROGRAM, "run", file, "--fidelity", "quasi-static", "--json"], capture_output=True, text=True)
    return done.returncode == 0 and json.loads(done.stdout)["points"][0]["status"].startswith("implausible")


def estimated(checked):
    """Processor time of the motion by `check` [s]."""
    return next((value["value"] for value in json.loads(checked)["derived"] if value["path"] == "simulation.processor_time"), None)


def accuracy(results):
    """Estimates over times, of those that take a second or more."""
    ratios = sorted(one["estimate"] / one["seconds"] for one in results if one.get("estimate") and one["seconds"] >= 1.0)
    if not ratios:
        return "no estimates"
    within = sum(0.5 <= ratio <= 2.0 for ratio in ratios)
    return f"estimate over time: {within} of {len(ratios)} within a factor of 2, {ratios[0]:.2g} to {ratios[-1]:.2g}"


def computed(task):
    """One design: {index, family, rpm, status, seconds, reason, estimate}."""
    index, options = task
    seconds, keep = options.seconds, options.keep
    text_of, _, fidelity = KINDS[options.kind]
    draw = random.Random(f"{options.seed}/{index}")
    wanted = ["--fidelity", fidelity] if fidelity else []
    settings = [word for value in SHORT for word in ("--set", value)] if fidelity and options.short else []
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "case.yaml"
        for _ in range(50):
            family, rpm, text = text_of(draw, index, options.families)
            file.write_text(text, encoding="utf-8")
            checked = subprocess.run([PROGRAM, "check", file, *settings, "--json"], capture_output=True)
            if checked.returncode != 0:
                continue
            if fidelity and implausible(file):
                continue
            before = processor_time()
            done = subprocess.run([PROGRAM, "run", file, *wanted, *settings, "--json"], capture_output=True, text=True,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1)))
            took = processor_time() - before
            if done.returncode != BAD_INPUT:
                break
        else:
            return {"index": index, "family": family, "rpm": rpm, "status": "never accepted", "seconds": 0.0, "reason": "50 draws were refused"}
        estimate = estimated(checked.stdout) if fidelity == "dynamic" else None
        late = done.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
        status, reason = ("too long", f"not within {seconds} s") if late else outcome(done)
        if keep and status != "completed":
            (pathlib.Path(keep) / f"{index}.yaml").write_text(f"# {status}: {reason[:200]}\n{text}".replace("\n# ", " "), encoding="utf-8")
    return {"index": index, "family": family, "rpm": rpm, "status": status, "seconds": took, "reason": reason, "estimate": estimate}


def times(results):
    took = sorted(one["seconds"] for one in results)
    return f"seconds: median {statistics.median(took):.2f}, 95 % {took[math.ceil(0.95 * len(took)) - 1]:.2f}, worst {took[-1]:.2f}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kind", choices=tuple(KINDS), default="drivetrains")
    parser.add_argument("--families", nargs="+", choices=tuple(FAMILIES), default=tuple(FAMILIES))
    parser.add_argument("--short", action="store_true", help="few revolutions of the cage")
    parser.add_argument("--count", type=int, default=2000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=50)
    parser.add_argument("--seconds", type=int, default=120)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", help="folder of the cases that do not complete")
    parser.add_argument("--each", action="store_true", help="a line for each design")
    options = parser.parse_args()
    if options.keep:
        pathlib.Path(options.keep).mkdir(parents=True, exist_ok=True)
    tasks = [(index, options) for index in range(options.first, options.first + options.count)]
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        results = []
        for one in pool.map(computed, tasks):
            results.append(one)
            if one["status"] != "completed":
                print(f"{one['index']}: {one['family']}, {one['rpm']:.4g} rpm: {one['status']} after {one['seconds']:.1f} s: {one['reason'][:300]}", flush=True)
            elif options.each:
                print(f"{one['index']}: {one['family']}, {one['rpm']:.4g} rpm: {one['seconds']:.2f} s, estimate {one.get('estimate')}", flush=True)
    done = [one for one in results if one["status"] == "completed"]
    late = sum(one["status"] == "too long" for one in results)
    print(f"{len(done)} of {len(results)} complete ({100 * len(done) / len(results):.1f} %), {len(results) - len(done) - late} failed, "
          f"{late} over {options.seconds} s; {times(results)}; {accuracy(done)}")
    for family in KINDS[options.kind][1]:
        of = [one for one in results if one["family"] == family]
        if of:
            print(f"  {family}: {sum(one['family'] == family for one in done)} of {len(of)}; {times(of)}; {accuracy([one for one in of if one in done])}")
    for low, high in ((0, 10), (10, 100), (100, 1000), (1000, math.inf)):
        of = [one for one in results if low <= one["rpm"] < high]
        if of:
            print(f"  {low} to {high:g} rpm: {sum(low <= one['rpm'] < high for one in done)} of {len(of)}; {times(of)}; {accuracy([one for one in of if one in done])}")
    return len(done) < 0.99 * len(results)


if __name__ == "__main__":
    sys.exit(main())
