"""What a wheel must do by itself, in an environment that has nothing but it: sweep in two rungs, plot, report, FMU, a
study, sensitivities and command line, the table of the command line and that of the module equal to the last digit.
Uncertainty wants OpenTURNS, which is an extra: without, it must say so.

    python wheel_check.py FOLDER      FOLDER is made and filled
"""

# The wheel alone.
import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys
import time
import zipfile

SHORT_MOTION = {"simulation.observed_revolutions": 2, "simulation.most_revolutions": 2}


def command_line(*arguments):
    program = pathlib.Path(sys.executable).with_name("orbearing")
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def check_records(folder):
    """Of a wheel: classic netCDF is read, netCDF-4 refused with what to do."""
    import netCDF4

    ended = []
    for form in ("NETCDF3_CLASSIC", "NETCDF4"):
        with netCDF4.Dataset(folder / f"{form}.nc", "w", format=form) as record:
            record.createDimension("time", 4)
            for name, unit, values in (("time", "s", range(4)), ("speed", "rpm", [900.0] * 4), ("torque", "N m", [100.0, 120.0, 90.0, 100.0])):
                variable = record.createVariable(name, "f8", ("time",))
                variable.units, variable[:] = unit, list(values)
        words = [pathlib.Path(sys.executable).with_name("orbearing"), "spectrum", folder / f"{form}.nc", "--json"]
        ended.append(subprocess.run(list(map(str, words)), capture_output=True, text=True))
    assert ended[0].returncode == 0, ended[0].stderr
    assert ended[1].returncode == 2 and "classic format" in ended[1].stderr, ended[1].stderr


def main(folder):
    begin = time.perf_counter()
    import orbearing

    print(f"import: {time.perf_counter() - begin:.2f} s")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    file = orbearing.cases()["reducer_150kW"]
    case = orbearing.load(file)
    sweep = case.sweep()
    assert json.loads(command_line("sweep", file, "--json")) == sweep.data
    print(f"quasi-static sweep: {len(sweep.life_h)} points, peak at {sweep.peak['refined_speed_rpm']} rpm, as by the command line")
    moving = case.copy({"sweep.input.speed": ["5000 rpm", "6000 rpm"], **SHORT_MOTION})
    motion = moving.sweep(fidelity="dynamic", grid_only=True)
    settings = [word for path, value in SHORT_MOTION.items() for word in ("--set", f"{path}={value}")]
    printed = command_line("sweep", file, "--json", "--fidelity", "dynamic", "--grid-only", "--set",
                           "sweep.input.speed=[5000 rpm, 6000 rpm]", *settings)
    assert json.loads(printed)["points"] == motion.data["points"]
    print(f"dynamic sweep: lives {motion.life_h}, as by the command line; series: {dict(motion.series(0).sizes)}")
    import matplotlib

    matplotlib.use("agg")
    sweep.plot().figure.savefig(folder / "life.png")
    page = sweep.report(folder / "report.html")
    assert b"<svg" in page.read_bytes()
    case.fmu(folder / "planet.fmu")
    with zipfile.ZipFile(folder / "planet.fmu") as archive:
        libraries = [name for name in archive.namelist() if name.startswith("binaries/") and name.endswith((".so", ".dll"))]
    assert libraries, "the FMU holds no library"
    print(f"plot, report ({page.stat().st_size} bytes), FMU with {', '.join(libraries)}")
    study = orbearing.study(case, {"bearing.radial_clearance": ["0 um", "20 um"]}, output=folder / "study", progress=False)
    assert study.to_xarray().life_h.shape == (2, 12), study.to_xarray().life_h.shape
    command_line("study", file, "--vary", "bearing.radial_clearance=[0 um, 20 um]", "-o", folder / "study_by_command")
    assert json.loads(command_line("sensitivities", file, "--json")) == case.sensitivities().data
    uncertain = orbearing.load(orbearing.cases()["reducer_150kW_uncertain"])
    if importlib.util.find_spec("openturns"):
        band = uncertain.uncertainty(samples=64, curves=16)
        print(f"uncertainty: {band!r}")
    else:
        try:
            uncertain.uncertainty(samples=64)
            raise AssertionError("nothing said that OpenTURNS is missing")
        except orbearing.CaseError as error:
            assert "required: openturns" in str(error), error
            print(error)
    print(f"study: {dict(study.to_xarray().sizes)}, peaks {study.to_xarray().peak_speed_rpm.values.tolist()} rpm; sensitivities as by the command line")
    check_records(folder)
    assert orbearing._core.__file__.startswith(sys.prefix), "another package was imported"
    print(command_line("check", file).splitlines()[0])


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
