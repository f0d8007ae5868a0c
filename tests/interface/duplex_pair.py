"""A shaft on a duplex pair: five modes in their order, both columns of the source by one key, what run writes, what is refused."""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import netCDF4

PROGRAM = os.environ.get("ORBEARING", "build/release/bin/orbearing")
CASE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", ".")) / "cases" / "duplex_7020" / "case.yaml"
KINDS = ["tilt_x", "tilt_y", "axial_z", "radial_x", "radial_y"]


def call(*words):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)


def modes(*settings):
    done = call("modes", CASE, "--json", *[word for setting in settings for word in ("--set", setting)])
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)["modes"]


def five_rows_always():
    for settings in ([], ["stiffness=linear"], ["bearing.contact_angle=25 deg", "preload=830 N"],
                     ["bearing.contact_angle=25 deg", "preload=3920 N", "stiffness=linear"],
                     ["arrangement=back-to-back"], ["arrangement=tandem"], ["preload=0 N"]):
        rows = modes(*settings)
        assert [row["kind"] for row in rows] == KINDS, settings
        assert all(row["multiplicity"] == 1 for row in rows), settings
    assert all(row["frequency_Hz"] == 0.0 for row in modes("preload=0 N"))
    assert abs(modes("stiffness=linear")[0]["frequency_Hz"] - 288.27) < 0.001 * 288.27


def the_shaft_may_turn(work):
    speeds = ["--set", "operation.speeds=[0 rpm, 6000 rpm, 12000 rpm]"]
    at_rest, fast = modes(), json.loads(call("modes", CASE, "--json", "--speed", "12000 rpm", *speeds).stdout)
    rows = fast["over_speed"]
    assert [row["speed_rpm"] for row in rows] == [0.0, 6000.0, 12000.0] and all(row["status"] == "ok" for row in rows)
    for first, last, k in zip(at_rest, fast["modes"], KINDS):
        assert abs(rows[0][f"{k}_Hz"] / first["frequency_Hz"] - 1) < 1e-9 and rows[2][f"{k}_Hz"] == last["frequency_Hz"]
    assert rows[2]["radial_x_Hz"] < rows[1]["radial_x_Hz"] < rows[0]["radial_x_Hz"], rows
    assert rows[2]["outer_angle_deg"] < rows[0]["outer_angle_deg"] < rows[2]["inner_angle_deg"], rows
    assert "other" not in fast and any("gyroscopic" in warning for warning in fast["warnings"]), fast
    done = call("run", CASE, "-o", work / "fast", "--json", "--set", "operation.shaft_speed=12000 rpm", *speeds)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["over_speed"] == rows
    table = list(csv.DictReader((work / "fast" / "modes_over_speed.csv").open()))
    assert [round(float(row["axial_z_Hz"]), 4) for row in table] == [round(row["axial_z_Hz"], 4) for row in rows]
    file = netCDF4.Dataset(work / "fast" / "points" / "00000.nc")
    assert file["over_speed_natural_frequency"].shape == (3, 5) and "outer_contact_load" in file.variables


def run_writes_its_files(work):
    done = call("run", CASE, "-o", work / "pair", "--json")
    assert done.returncode == 0, done.stderr
    result = json.loads(done.stdout)
    assert result == json.loads((work / "pair" / "duplex.json").read_text())
    file = netCDF4.Dataset(work / "pair" / "points" / "00000.nc")
    assert file["mode_shape"].shape == (5, 5) and file["accelerance_z_real"].shape == file["frequency"].shape
    assert result["units"]["mass_kg"] == "kg" and result["units"]["accelerance_max_per_kg"] == "kg-1", result["units"]
    assert any("bore of the bearings" in json.dumps(one) for one in result["assumptions"]), result["assumptions"]
    again = call("run", work / "pair" / "case.resolved.yaml", "--json")
    assert json.loads(again.stdout)["modes"] == result["modes"]


def mistakes_are_named():
    for setting, word in (("preload=-1 N", "preload"), ("stiffness=elastic", "stiffness"),
                          ("measured.preload=[3 N]", "no longer identified"), ("spindle.inertia_x=1 kg.m2", "spindle.diameter"),
                          ("identification.contact_angle=25 deg", "no longer identified"),
                          ("operation.outer_speed=100 rpm", "operation"), ("housing.mass=3 kg", "housing.inertia")):
        done = call("modes", CASE, "--set", setting)
        assert done.returncode == 2 and word in done.stderr, (setting, done.stderr)
    for settings in (["--speed", "100 rpm"], ["--set", "operation.speeds=[0 rpm, 100 rpm]"]):
        refused = call("modes", CASE, "--set", "stiffness=linear", *settings)
        assert refused.returncode == 2 and "the linear formulas include no speed" in refused.stderr, refused.stderr
    assert "--speed" in call("modes", CASE, "--speed", "fast").stderr
    warned = call("modes", CASE, "--set", "response.loss_factor=0.01")
    assert "response.loss_factor" in warned.stdout, warned.stdout


if __name__ == "__main__":
    five_rows_always()
    with tempfile.TemporaryDirectory() as folder:
        run_writes_its_files(pathlib.Path(folder))
        the_shaft_may_turn(pathlib.Path(folder))
    mistakes_are_named()
    sys.exit(0)
