"""Results of the program for pages_recorded.py: of few digits, and of long lists the beginning. Needs ORBEARING and ORBEARING_SOURCE_DIR."""

import json
import lzma
import os
import subprocess
import tempfile
from pathlib import Path

SOURCE = Path(os.environ["ORBEARING_SOURCE_DIR"])
SINGLE = """name: single
source: catalogue
model: ball-bearing
load: {radial: 2000 N}
operation: {shaft_speed: 1500 rpm}
bearing: {designation: "6205", clearance_class: CN}
lubricant: {grade: ISO VG 68, temperature: 70 degC}
life: {cleanliness: -/17/14}
requirements: {life: 20000 h, life_key: L10mrh, contact_pressure_max: 2500 MPa, S0: 2, kappa: 1}
"""
PAIR = """name: pair
source: catalogue
model: duplex-pair
arrangement: back-to-back
preload: 1500 N
bearing: {designation: 7210 B, radial_clearance: 0 um}
spindle: {mass: 6 kg, first_lever: 20 mm, second_lever: 20 mm, diameter: 50 mm, density: 7850 kg/m3}
operation: {shaft_speed: 1500 rpm}
"""
SPECTRUM = "spectrum=[{power: 750 kW, speed: 22 rpm, share: 0.2}, {power: 400 kW, speed: 20 rpm, share: 0.5}, {power: 100 kW, speed: 16 rpm, share: 0.3}]"
JUDGED = ["requirements.life=60000 h", "requirements.S0=3", "requirements.contact_pressure_max=1500 MPa", "requirements.load_share=1.2"]
RESULTS = {"single": ("run", SINGLE, []), "pair": ("run", PAIR, []),
           "spectrum": ("run", "wind_stage_750kW", [SPECTRUM, *JUDGED]),
           "stage": ("run", "wind_stage_750kW", JUDGED), "sets": ("run", "three_sets_150kW", JUDGED)}
LISTS = 5  # entries of a stored list at most; of numbers 12


def stored(value):
    """Six digits, and of long lists the beginning."""
    if isinstance(value, dict):
        return {key: stored(one) for key, one in value.items()}
    if isinstance(value, list):
        return [stored(one) for one in value[:12 if all(isinstance(one, (int, float)) for one in value) else LISTS]]
    return float(f"{value:.6g}") if isinstance(value, float) else value


def make(file):
    """By the program; what differs from machine to machine has a name in its place."""
    program, found = os.environ["ORBEARING"], {}
    for name, (command, case, values) in RESULTS.items():
        with tempfile.TemporaryDirectory() as folder:
            path = SOURCE / "cases" / case / "case.yaml"
            if "\n" in case:
                path = Path(folder, "case.yaml")
                path.write_text(case, encoding="utf-8")
            settings = [word for value in values for word in ("--set", value)]
            subprocess.run([program, command, path, "-o", f"{folder}/out", *settings], check=True, stdout=subprocess.DEVNULL)
            said = subprocess.run([program, "report", f"{folder}/out", "--data-only", "--json"], check=True, stdout=subprocess.PIPE, text=True).stdout
            content = stored(json.loads(said))
        for part in (content, *(one for one in content.values() if isinstance(one, dict))):
            if isinstance(part.get("versions"), dict):
                part["versions"] = {key: f"{key} of the test" for key in part["versions"]}
        found[name] = {key: value for key, value in content.items() if key not in ("gears", "units", "polar", "ablation", "dynamic", "carrier")}
    file.write_bytes(lzma.compress(json.dumps(found, ensure_ascii=False, separators=(",", ":")).encode(), preset=9 | lzma.PRESET_EXTREME))
