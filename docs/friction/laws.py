"""Tables of docs/friction.md on laws of rolling resistance: python3 docs/friction/laws.py PROGRAM (half a minute).

Prints the tables between the marks of that page. `--write` puts them there.
"""
import json
import math
import statistics
import subprocess
import sys
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
CASES = ROOT / "cases" / "validation"
PAGE = ROOT / "docs" / "friction.md"
BEGIN, END = "<!-- laws: tables of docs/friction/laws.py -->", "<!-- end of laws -->"

MODULUS = 206e9 / (1 - 0.3**2)  # [Pa]  E' of steel on steel
DENSITY = 7850.0  # [kg/m3]
OIL_DENSITY = 850.0  # [kg/m3]
STIFFNESS = 8.06e4 / 2 ** (10 / 9)  # [N/mm^(10/9) per mm^(8/9)]  both contacts of a roller in series, Palmgren

# Backward force on each surface of a rolling line contact, over E' R l. U = eta u/(E' R), u the mean of the surface
# speeds, W = w/(E' R), G = alpha E'. The power of a contact is 2 F u, the moment of its pressure 2 F R.


def rigid(U, W, G):
    """Rigid cylinders in oil of one viscosity: closed form."""
    return 1.4705 * (2 * U) ** 0.75 * (W / (2 * U) ** 0.5) ** 0.5


def blended(elastic):
    """A law of elastic bodies that does not exceed that of rigid ones at light loads."""
    return lambda U, W, G: (rigid(U, W, G) ** -3 + elastic(U, W, G) ** -3) ** (-1 / 3)


def reynolds(U, W, G):
    M, L = W / (2 * U) ** 0.5, G * (2 * U) ** 0.25
    return 2.2818 * M**-0.04543 * L**-0.0923 * (2 * U) ** 0.75


def goksem_hargreaves(U, W, G):
    return 4.318 / G * (G * U) ** 0.658 * W**0.0126


def zhou_hoeprich(U, W, G):
    return 29.2 / G * (G * U) ** 0.648 * W**0.246


def aihara(U, W, G):
    return 88.0 / G * (G * U) ** 0.658 * W**0.31


def biboulet_houpert(U, W, G):
    M = W / (2 * U) ** 0.5
    return (2 * U) ** 0.75 * 1.42 * M**0.5 / (1 + (1.42 / 1.47 * M**0.5) ** 10) ** 0.1


def matsuyama(U, W, G):
    return 7.1 * U**0.75 * G**-0.04 * W**0.08


def hamrock(U, W, G):
    """From the shift of the centre of pressure, as [BibouletHoupert2010] states it."""
    return 0.0295 * (2 * U) ** 0.44 * W**0.37


LAWS = {
    "of the program (default)": blended(reynolds),
    "Biboulet and Houpert, 2010": biboulet_houpert,
    "Goksem and Hargreaves, 1978": blended(goksem_hargreaves),
    "Zhou and Hoeprich, 1991": blended(zhou_hoeprich),
    "Aihara, 1987": blended(aihara),
    "Matsuyama, 1998": blended(matsuyama),
    "Hamrock, 1984": blended(hamrock),
}

DEFAULT = LAWS["of the program (default)"]

# [ZhouHoeprich1991], Table 1: U 1e11, W 1e4, moment of the pressure N e [N] of a metre. G = 3745, E' R_e = 8.61e8 N/m.
# R_e is not printed: with 2.5 mm the source's own Eq. (17) has these moments in the mean.
MOMENTS = ((35, 1.0, 0.5561), (35, 1.5, 0.6248), (35, 2.0, 0.6473), (35, 2.5, 0.6849), (35, 3.0, 0.7133),
           (1, 2.0, 0.0684), (3, 2.0, 0.1358), (10, 2.0, 0.3154), (60, 2.0, 0.8649), (100, 2.0, 1.1148))
MOMENTS_G, MOMENTS_ER, MOMENTS_R = 3745.0, 8.61e8, 2.5e-3


def moment(law, U, W):
    return 2 * law(U, W, MOMENTS_G) * MOMENTS_ER * MOMENTS_R


# [Aihara1987], discs: R_e = 25 mm, 0.13 to 0.9 MN/m, 2 to 6 m/s, oils of 13 and 70 mm2/s.
DISC, LIGHT, HEAVY, SLOW, FAST = 0.025, 0.13e6, 0.9e6, 2.0, 6.0
DISC_OILS = (13e-6, 70e-6)
DISC_PRESSURE_VISCOSITY = 20e-9  # [1/Pa]  not printed; as in cases/reynolds_line


def disc_groups(viscosity, load, speed):
    return viscosity * OIL_DENSITY * speed / (MODULUS * DISC), load / (MODULUS * DISC), DISC_PRESSURE_VISCOSITY * MODULUS


def disc_exponents(law, viscosity=DISC_OILS[0]):
    """Of load at 4 m/s between the ends of its range, and of speed at 0.3 MN/m."""
    ratio = math.log(law(*disc_groups(viscosity, HEAVY, 4.0)) / law(*disc_groups(viscosity, LIGHT, 4.0)))
    faster = math.log(law(*disc_groups(viscosity, 0.3e6, FAST)) / law(*disc_groups(viscosity, 0.3e6, SLOW)))
    return ratio / math.log(HEAVY / LIGHT), faster / math.log(FAST / SLOW)


# Cylindrical bearings that stand for tapered ones: same rollers, loads normal to the races, so the same rolling resistance.


def stand_in(axial, radial, angle, rollers, length):
    """Radial load [N] and clearance [um] of the cylindrical bearing whose rollers carry what those of a tapered one do under
    `axial` and `radial` [N]; `angle` [deg] of the outer race, `length` [mm] of `rollers`. The tapered ring does not tilt."""
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    across, along = radial / cosine, axial / sine  # sum of Q cos(psi), sum of Q
    constant = STIFFNESS * length ** (8 / 9)
    angles = [2 * math.pi * j / rollers for j in range(rollers)]

    def loads(press, shift):
        return [constant * max(0.0, press + shift * math.cos(one)) ** (10 / 9) for one in angles]

    def press_of(shift):  # bisection: sum of the loads
        low, high = -abs(shift), 1.0
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if sum(loads(middle, shift)) < along else (low, middle)
        return 0.5 * (low + high)

    low, high = 0.0, 1.0
    for _ in range(200):
        shift = 0.5 * (low + high)
        found = sum(q * math.cos(one) for q, one in zip(loads(press_of(shift), shift), angles))
        low, high = (shift, high) if found < across else (low, shift)
    return across, -2e3 * press_of(low)


def answer(program, command, case, *settings):
    words = [word for setting in settings for word in ("--set", setting)]
    done = subprocess.run([program, command, str(case / "case.yaml"), *(("--json",) if command == "run" else ()), *words],
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout) if command == "run" else done.stdout


# What is read from the table of `check`, in SI units by the unit that stands there.
USED = ("bearing.roller_diameter", "bearing.roller_length", "bearing.pitch_diameter", "lubricant.viscosity", "lubricant.pressure_viscosity",
        "operation.shaft_speed")
UNITS = {"mm": 1e-3, "GPa-1": 1e-9, "Pa-1": 1.0, "rpm": math.pi / 30, "Pa.s": 1.0}


class Bearing:
    """A case of a cylindrical bearing: loads of its rollers and power by the program, resistance by any law."""

    def __init__(self, program, name, *settings):
        lines = [line.split() for line in answer(program, "check", CASES / name, *settings).splitlines()]
        given = {words[0]: float(words[1]) * UNITS[words[2]] for words in lines if len(words) > 2 and words[0] in USED}
        self.diameter, self.length, self.pitch = (given[key] for key in USED[:3])
        self.viscosity, self.pressure_viscosity, self.speed = (given[key] for key in USED[3:])
        found = answer(program, "run", CASES / name, *settings)
        self.loads = [max(0.0, load) for load in found["contact_loads_N"]]
        self.friction, self.heat_W = found["friction"], found["friction_by_standards"]["reference_heat_W"]

    def isothermal(self, law):
        """Power [W] of all contacts by `law` at pure rolling, flooded; on the outer race rollers press with their inertia, too."""
        inner, outer, middle = (0.5 * (self.pitch + sign * self.diameter) for sign in (-1, 1, 0))
        cage = self.speed * inner / (2 * middle)
        thrown = DENSITY * math.pi * self.diameter**2 / 4 * self.length * middle * cage**2
        power = 0.0
        for radius, sign, rolling, more in ((inner, 1, (self.speed - cage) * inner, 0.0), (outer, -1, cage * outer, thrown)):
            equivalent = 1 / (2 / self.diameter + sign / radius)
            unit = MODULUS * equivalent * self.length
            U = self.viscosity * rolling / (MODULUS * equivalent)
            power += sum(2 * rolling * unit * law(U, (load + more) / unit, self.pressure_viscosity * MODULUS) for load in self.loads if load + more > 0.0)
        return power

    def power(self, law):
        """Power [W] with the program's drag and heated inlets. Inlets end where the program's do: exp(-far), far as 1/F."""
        over = self.isothermal(law) / self.isothermal(DEFAULT)
        ended = (self.friction["rolling_W"] / self.friction["flooded_rolling_W"]) ** (1 / over)
        return self.friction["flooded_rolling_W"] * over * ended + self.friction["drag_W"]

    def torque(self, law):
        return 1e3 * self.power(law) / self.speed  # [N mm]


def published(case):
    """Rows of the expected.yaml in the folder of a case."""
    return yaml.safe_load((case / "expected.yaml").read_text(encoding="utf-8"))["published"]


def rows_of(name):
    """Measured rows of friction of a case of validation."""
    return [row for row in published(CASES / name) if row["kind"] == "measurement" and row["of"] == "friction"]


TAPERED = {"wingertszahn_32216": "32216", "zhou_hoeprich_lm12700": "LM12700", "cruz_hm801349": "HM801349"}


def measured(program):
    """(ln of computed over measured, tolerance) by law: of torques, and of ratios of torques, by bearing."""
    found = {law: {} for law in LAWS}
    for name, bearing in TAPERED.items():
        for row in rows_of(name):
            here = Bearing(program, name, *row.get("settings", []))
            there = Bearing(program, name, *row["against"]) if "against" in row else None
            kind = f"{bearing}, {'ratios' if there else 'torques'}"
            for title, law in LAWS.items():
                value = here.torque(law) / (there.torque(law) if there else 1.0)
                found[title].setdefault(kind, []).append((math.log(value / row["value"]), row["tolerance"]))
    for title, law in LAWS.items():
        aihara_rows = [(0.3, disc_exponents(law, oil)[0]) for oil in DISC_OILS] + [(0.2, disc_exponents(law)[0])]
        found[title]["discs, loads"] = [((ours - theirs) * math.log(HEAVY / LIGHT), 0.1) for theirs, ours in aihara_rows]
        found[title]["discs, speeds"] = [((disc_exponents(law)[1] - 0.658) * math.log(FAST / SLOW), 0.06)]
    return found


def at_reference_speeds(program):
    """Median of power over the heat of ISO 15312 for the cylindrical bearings of a catalogue, by law. No measurement."""
    name = "thermal_reference_rollers"
    bearings = [Bearing(program, name, *row["settings"]) for row in published(CASES / name)]
    return {title: statistics.median(one.power(law) / one.heat_W for one in bearings) for title, law in LAWS.items()}


def root_mean_square(values):
    return statistics.fmean(value**2 for value in values) ** 0.5


def table(heads, rows):
    return "\n".join(["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)] + ["| " + " | ".join(row) + " |" for row in rows])


def exponents_table():
    rows = []
    for title, law in LAWS.items():
        light, heavy = (disc_exponents(law, oil) for oil in DISC_OILS)
        moments = [moment(law, U * 1e-11, W * 1e-4) / of for U, W, of in MOMENTS]
        rows.append((title, f"{light[0]:.3f} / {heavy[0]:.3f}", f"{light[1]:.3f} / {heavy[1]:.3f}",
                     f"{math.exp(statistics.fmean(math.log(one) for one in moments)):.2f}", f"{min(moments):.2f} to {max(moments):.2f}"))
    rows.append(("measured ([Aihara1987]; [EguchiYamamoto1981])", "0.3; 0.2", "0.658", "", ""))
    return table(("law", "exponent of load, 13 / 70 mm2/s", "exponent of speed", "ten moments, mean ratio", "range"), rows)


def moments_table():
    heads = ("U", "W", "moment [N]", *LAWS)
    return table(heads, [(f"{U:g}e-11", f"{W:g}e-4", f"{of:.4f}", *(f"{moment(law, U * 1e-11, W * 1e-4):.4f}" for law in LAWS.values()))
                         for U, W, of in MOMENTS])


def measured_table(found, at_speeds):
    kinds = list(next(iter(found.values())))
    rows = []
    for title, by_kind in found.items():
        everything = [value for values in by_kind.values() for value in values]
        within = sum(abs(math.exp(value) - 1.0) <= tolerance for value, tolerance in everything)
        rows.append((title, *(f"{math.exp(statistics.fmean(value for value, _ in by_kind[kind])):.2f}" for kind in kinds),
                     f"{math.exp(root_mean_square([value for value, _ in everything])):.2f}", f"{within} of {len(everything)}", f"{at_speeds[title]:.2f}"))
    heads = ("law, computed / measured in the mean", *(f"{kind} ({len(found[next(iter(found))][kind])})" for kind in kinds), "all rows, root mean square", "within their tolerance",
             "109 bearings over the heat of ISO 15312, median")
    return table(heads, rows)


def text(program):
    return "\n\n".join([BEGIN, exponents_table(), moments_table(), measured_table(measured(program), at_reference_speeds(program)), END])


def show(found, page, begin, end, write):
    """Prints what stands between two marks of a page, or writes it there."""
    if not write:
        print(found)
        return
    before, _, rest = page.read_text(encoding="utf-8").partition(begin)
    page.write_text(before + found + rest.partition(end)[2], encoding="utf-8")


if __name__ == "__main__":
    show(text(sys.argv[1]), PAGE, BEGIN, END, "--write" in sys.argv)
