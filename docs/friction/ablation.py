"""Table of docs/ablation.md on missed measurements: python3 docs/friction/ablation.py PROGRAM [--write] (ten minutes of a core).

Each group is rows of expected.yaml of one case. Each variant changes one part of the model or one input; the table has
computed over measured value for each row.
"""
import json
import operator
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "friction"))
import laws  # noqa: E402

PAGE = ROOT / "docs" / "ablation.md"
BEGIN, END = "<!-- missed measurements: table of docs/friction/ablation.py -->", "<!-- end of missed measurements -->"

AS_STATED = ("as the case", ())


def angle(degrees, axial, radial):
    """Settings of the stand-in for 32216 with another contact angle."""
    across, clearance = laws.stand_in(axial, radial, degrees, 16, 22.7)
    return (f"load.radial={max(across, 100.0):.5g} N", f"bearing.radial_clearance={clearance:.4f} um")


# Title; case; rows by a part of their meaning, with the head of their column; variants.
GROUPS = (
    ("Torque of the tapered bearing 32216", "validation/wingertszahn_32216",
     (("torque at 500 rpm and 50", "500 rpm, 50 degC"), ("torque at 2000 rpm and 50", "2000 rpm, 50 degC"), ("torque at 4000 rpm and 50", "4000 rpm, 50 degC"),
      ("torque at 500 rpm and 42", "500 rpm, 42 degC")),
     (AS_STATED, ("oil in 1 instead of 12 % of the volume: inlets end sooner", ("lubricant.share=0.01",)),
      ("starvation by SKF's factor", ("traction.starvation=skf",)),
      ("starvation by the oil that returns", ("traction.starvation=replenished",)),
      ("starvation by the oil that returns, oil in 1 % of the volume", ("traction.starvation=replenished", "lubricant.share=0.01")),
      ("oil in the contacts at 60 degC", ("lubricant.temperature=60 degC",)),
      ("contact angle 14 deg", angle(14.0, 6000.0, 0.0)))),
    ("Ratios of torques of 32216", "validation/wingertszahn_32216",
     (("under 15 kN radial", "15 over 1 kN radial"), ("torque at 4000 rpm over", "4000 over 500 rpm"),
      ("torque at 42 degC over", "42 over 50 degC"), ("under 12 kN axial", "12 over 3 kN axial")),
     (AS_STATED, ("oil in 1 instead of 12 % of the volume: inlets end sooner", ("lubricant.share=0.01",)),
      ("starvation by SKF's factor", ("traction.starvation=skf",)),
      ("starvation by the oil that returns", ("traction.starvation=replenished",)))),
    ("Torque of the tapered bearing LM12700", "validation/zhou_hoeprich_lm12700",
     (("at 1600", "1600 rpm"), ("at 2400", "2400 rpm"), ("at 3200", "3200 rpm"), ("at 4000", "4000 rpm"), ("at 4800", "4800 rpm")),
     (AS_STATED, ("oil a third thinner", ("lubricant.viscosity_40=14.7 mm2/s", "lubricant.viscosity_100=2.9 mm2/s")),
      ("oil a third thicker", ("lubricant.viscosity_40=29.3 mm2/s", "lubricant.viscosity_100=5.7 mm2/s")),
      ("oil in 1 instead of 5 % of the volume: inlets end sooner", ("lubricant.share=0.01",)),
      ("starvation by SKF's factor", ("traction.starvation=skf",)),
      ("rollers of 5.2 mm", ("bearing.roller_diameter=5.2 mm",)))),
    ("Ratios of torques of the pair HM801349", "validation/cruz_hm801349",
     (("under 8336", "8336 over 2083 N"), ("under 5279", "5279 over 2083 N")),
     (AS_STATED, ("oil in 1 instead of 5 % of the volume: inlets end sooner", ("lubricant.share=0.01",)),
      ("starvation by SKF's factor", ("traction.starvation=skf",)),
      ("starvation by the oil that returns", ("traction.starvation=replenished",)),
      ("oil at 90 degC", ("lubricant.temperature=90 degC",)))),
    ("Discs: rolling resistance by Reynolds' equation", "reynolds_line",
     (("exponent 0.3, oil of 13", "load, 13 mm2/s"), ("exponent 0.3, oil of 70", "load, 70 mm2/s"), ("exponent 0.658", "speed")),
     (AS_STATED, ("pressure-viscosity coefficient 10 instead of 20 GPa-1", ("lubricant.pressure_viscosity=10 GPa-1",)),
      ("pressure-viscosity coefficient 30 GPa-1", ("lubricant.pressure_viscosity=30 GPa-1",)),
      ("softer discs: modulus 100 GPa", ("contact.modulus=100 GPa",)))),
    ("Three balls of 3 mm", "validation/balan_2015_small_balls",
     (("at 60 rpm", "60 rpm"), ("at 120 rpm", "120 rpm"), ("at 210 rpm", "210 rpm")),
     (AS_STATED, ("oil 20 % thicker", ("lubricant.kinematic_viscosity=70.6 mm2/s",)),
      ("load 20 % larger", ("load.axial=2.27016 N",)),
      ("grooves of 1 instead of 1.387 of the ball", ("bearing.inner_osculation=1", "bearing.outer_osculation=1")))),
    ("Three balls of 6.35 mm", "validation/balan_2015",
     (("at 60 rpm", "60 rpm"), ("at 120 rpm", "120 rpm"), ("at 210 rpm", "210 rpm")),
     (AS_STATED, ("oil 20 % thicker", ("lubricant.kinematic_viscosity=70.6 mm2/s",)),
      ("load 20 % larger", ("load.axial=0.44828 N",)),
      ("grooves of 0.6 instead of 0.655 of the ball", ("bearing.inner_osculation=0.6", "bearing.outer_osculation=0.6")))),
    ("Mesh load factor and largest bearing load, 750 kW stage", "wind_stage_750kW",
     (("no rotor moment", "K_gamma, no moment"), ("extreme rotor moments", "K_gamma, 300 kN m"), ("torque alone", "largest bearing load")),
     (AS_STATED, ("no gravity", ("gearset.carrier.gravity=0 m/s2",)),
      ("no clearance of the carrier's bearings", ("gearset.carrier.bearing_clearance=[0 um, 0 um]",)),
      ("900 um of it", ("gearset.carrier.bearing_clearance=[900 um, 900 um]",)),
      ("carrier's bearings a third as stiff", ("gearset.carrier.bearing_stiffness=[1e9 N/m, 1e9 N/m]",)),
      ("sun held by 1e9 N/m", ("gearset.dynamics.sun.support_stiffness=1e9 N/m",)),
      ("one pin 50 um off", ("gearset.dynamics.pin_error.tangential=[50 um, 0 um, 0 um]",)),
      ("one pin 50 um off and sun held by 1e9 N/m", ("gearset.dynamics.pin_error.tangential=[50 um, 0 um, 0 um]", "gearset.dynamics.sun.support_stiffness=1e9 N/m")),
      ("planet bearings with 200 instead of 60 um", ("bearing.radial_clearance=200 um",)))),
    ("Heat of the 35 mm bearing", "nasa_35mm",
     (("heat at 28000", "28,000 rpm"), ("heat at 48000", "48,000 rpm"), ("heat at 64000", "64,000 rpm"), ("heat at 72000", "72,000 rpm")),
     (AS_STATED, ("no drag of the oil", ("drag.enabled=false",)),
      ("no rolling resistance", ("traction.rolling_resistance=false",)),
      ("rolling resistance by [Houpert1987]", ("traction.ball_rolling_law=houpert",)),
      ("inlets not heated", ("traction.inlet_heating=none",)),
      ("no starvation", ("traction.starvation=none",)),
      ("limiting shear instead of Ree-Eyring", ("traction.law=limiting-shear",)),
      ("cage guided by the inner ring", ("bearing.cage.guidance=inner", "bearing.cage.guide_land_diameter=43.6 mm")),
      ("oil flow 0.3 L/min", ("lubricant.flow=0.3 L/min",)),
      ("oil flow 1.9 L/min", ("lubricant.flow=1.9 L/min",)))),
    ("Ring temperatures of the 35 mm bearing (rise over 121 degC)", "nasa_35mm",
     (("inner ring at 28000", "inner, 28,000 rpm"), ("outer ring at 28000", "outer, 28,000 rpm"), ("inner ring at 72000", "inner, 72,000 rpm"),
      ("outer ring at 72000", "outer, 72,000 rpm")),
     (AS_STATED, ("surroundings at 25 degC", ("heat.surroundings=25 degC",)),
      ("balls to rings 1 instead of 2 W/K", ("heat.contact_conductance=1 W/K",)),
      ("balls and rings to oil 1.5 instead of 3 W/K", ("heat.oil_conductance=1.5 W/K",)),
      ("outer ring to housing 10 instead of 20 W/K", ("heat.fit_conductance=10 W/K",)),
      ("housing to surroundings 1.5 instead of 3 W/K", ("heat.housing_conductance=1.5 W/K",)),
      ("inner ring along the shaft 0 instead of 1 W/K", ("heat.shaft_conductance=0 W/K",)),
      ("oil flow 0.5 instead of 1.1 L/min", ("lubricant.flow=0.5 L/min",)))),
    ("Slip of loaded ball bearings (cage slip less the measured one, in % of speed)", "validation/paderborn_6203",
     (("under 1000 N, slip 0.06", "1500 rpm, 1000 N"), ("under 400 N", "1500 rpm, 400 N"), ("slip -0.26", "900 rpm, 1000 N")),
     (AS_STATED, ("no rolling resistance", ("traction.rolling_resistance=false",)),
      ("no drag of the oil", ("drag.enabled=false",)),
      ("clearance 0 um", ("bearing.radial_clearance=0 um",)),
      ("oil of 0.005 Pa s", ("lubricant.viscosity=0.005 Pa.s",)),
      ("Ree-Eyring instead of limiting shear", ("traction.law=ree-eyring",)))),
)

INLET = 121.0  # [degC]  of the oil of the 35 mm bearing
# Rows of slip have the speed of the cage. All else is computed over measured.
KINDS = {"temperature": lambda ours, theirs: (ours - INLET) / (theirs - INLET), "slip": lambda ours, theirs: 100.0 * (1.0 - ours / theirs)}


def row_of(case, part):
    """The row of a case whose meaning holds `part`."""
    found = [row for row in laws.published(ROOT / "cases" / case) if part in row["meaning"] and row["kind"] == "measurement"]
    assert len(found) == 1, (case, part, len(found))
    return found[0]


def value_of(program, case, row, settings):
    command, pointer = row["quantity"].split(":", 1)
    words = [word for setting in settings for word in ("--set", setting)]
    fidelity = ["--fidelity", row["fidelity"]] if "fidelity" in row else []
    done = subprocess.run([program, command, str(ROOT / "cases" / case / "case.yaml"), "--json", *fidelity, *words], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{case} {settings}: {done.stderr}")
    found = json.loads(done.stdout)
    for key in pointer.strip("/").split("/"):
        found = found[int(key)] if isinstance(found, list) else found[key]
    return found


def compared(program, case, row, change):
    """Settings of a variant come last, so that they replace those of the row."""
    ours = value_of(program, case, row, [*row.get("settings", []), *change])
    if "against" in row:
        ours /= value_of(program, case, row, [*row["against"], *change])
    return KINDS.get(row["of"], operator.truediv)(ours, row["value"])


def group_table(program, group):
    title, case, parts, variants = group
    rows = [row_of(case, part) for part, _ in parts]
    cells = [[f"{compared(program, case, row, change):.2f}" for row in rows] for _, change in variants]
    lines = ["| " + " | ".join((title, *(head for _, head in parts))) + " |", "|" + "---|" * (len(parts) + 1)]
    return "\n".join(lines + ["| " + " | ".join((name, *found)) + " |" for (name, _), found in zip(variants, cells)])


def text(program):
    return "\n\n".join([BEGIN, *(group_table(program, group) for group in GROUPS), END])


if __name__ == "__main__":
    laws.show(text(sys.argv[1]), PAGE, BEGIN, END, "--write" in sys.argv)
