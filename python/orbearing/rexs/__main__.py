"""`orbearing convert FILE -o DIR`: cases from a REXS file; `python3 -m orbearing.rexs` is the same.

Exit codes as of the command line: 0 done, 1 results cannot be written, 2 bad input or usage, or no planetary stage became a case.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Optional

from orbearing.errors import CaseError, ComputationError
from orbearing.terminal import Parser, exit_code, finished, printable, stated

if TYPE_CHECKING:
    from orbearing.rexs.convert import Conversion


def parser() -> argparse.ArgumentParser:
    """The options; their names are those of the other commands where they mean the same."""
    made = Parser(prog="orbearing convert", allow_abbrev=False,
                  description="Convert a REXS file (.rexs, .rexsj, .rexsz; versions 1.0 to 2.0) to cases: DIR/cases/NAME/case.yaml for each "
                              "planetary stage, and DIR/conversion.json with the values taken, missing and not used. A file "
                              "without a planetary stage gives its gear pairs and bearings, and exit code 2.")
    made.add_argument("file", metavar="FILE", type=stated, help="REXS file")
    made.add_argument("-o", "--output", metavar="DIR", type=stated, help="folder of the cases; created if missing. Optional with --json: nothing is written without it")
    made.add_argument("--results", metavar="RUN", type=stated, action="append", default=[],
                      help="folder of a run of one of these cases: the file is written again into DIR with lives and loads as REXS results; repeatable")
    made.add_argument("--json", action="store_true", help="print only the report, as one JSON object")
    made.add_argument("--quiet", action="store_true", help="print errors only")
    return made


def run(options: argparse.Namespace) -> int:
    """The conversion of the options; the exit code."""
    from orbearing.rexs import convert

    if options.output is None and not options.json:
        raise CaseError("--output: missing; required: a folder for the cases, or --json to print the report alone")
    if options.results and options.output is None:
        raise CaseError("--results: found without --output; required: a folder for the file with its results")
    folder = Path(options.output) if options.output else None
    if folder is not None:
        convert.require_empty(folder)
    file = Path(options.file)
    conversion = _converted(file, [Path(one) for one in options.results], folder)
    if folder is not None:
        convert.write(conversion, folder)
    if options.json:
        print(convert.json_of(conversion))
    elif not options.quiet:
        print_summary(conversion.report, folder)
    return _told(conversion)


def _converted(file: Path, runs: list[Path], folder: Optional[Path]) -> Conversion:
    """The file as cases, and with results where there are runs. What no one thought of in a file is bad input too."""
    from orbearing.rexs import convert, reading, sources

    content = reading.read_bytes(file)
    try:
        model = sources.completed(reading.read(file, content), file)
        conversion = convert.convert(model, file.name, reading.form_of(content))
        if runs:
            from orbearing.rexs import results

            conversion.report["results"] = results.write_back(file, content, conversion, runs, folder)
        return conversion
    except (CaseError, ComputationError, ImportError, OSError):
        raise
    except Exception as error:
        raise CaseError(f"{file}:1:1: found a model that cannot be converted ({type(error).__name__}: {error}); required: one that is complete; "
                        "please report this file") from error


def _say(text: str) -> None:
    """Texts of the file are printed without what moves the cursor."""
    print(printable(text))


def print_summary(report: dict, folder: Path) -> None:
    """What was found, for people."""
    _say(f"{report['source']}: REXS {report['version']}" + (f" of {report['application']}" if report["application"] else ""))
    for kind in ("stages", "pairs", "bearings"):
        for entry in report[kind]:
            where = str(folder / entry["case"]) if entry["case"] else f"no case: {'; '.join(entry['problems'])}"
            _say(f"  {entry['type']} {entry['component']} '{entry['name']}': {where}")
            if kind == "bearings":
                _say_of_bearing(entry)
    for entry in report["shafts"]:
        figures = entry["figures"]
        parts = [f"{figures['speed_rpm']:.6g} rpm"] if "speed_rpm" in figures else []
        if figures.get("outside_diameters_mm"):
            parts.append("outside diameters " + ", ".join(f"{one:.6g}" for one in figures["outside_diameters_mm"]) + " mm")
        _say(f"  {entry['type']} {entry['component']} '{entry['name']}'" + (": " + ", ".join(parts) if parts else ""))
    _say(f"{len(report['taken'])} attributes taken, {len(report['missing'])} keys missing in the file, {len(report['left_out'])} attributes left out")
    for entry in report["missing"]:
        instead = f"; taken instead: {entry['instead']}" if entry["instead"] is not None else ""
        _say(f"  missing {entry['case']}: {entry['key']}: {entry['reason']}{instead}")
    for note in report["notes"]:
        _say(f"warning: {note}")
    _say(str(folder / "conversion.json"))


def _catalogue_text(figures: dict) -> str:
    """Sizes, ratings and factors of a bearing as its file states them."""
    sizes = [f"{figures[name]:.6g}" if name in figures else "?" for name in ("bore_mm", "outside_diameter_mm", "width_mm")]
    parts = [" x ".join(sizes) + " mm"] if set(sizes) != {"?"} else []
    rows = [f"{figures['rows']:.6g} rows"] if figures.get("rows", 1) > 1 else []
    rows += [f"contact angle {figures['contact_angle_deg']:.6g} deg"] if "contact_angle_deg" in figures else []
    parts += rows + [f"{name.removesuffix('_kN')} {figures[name]:.6g}{' kN' if name.endswith('_kN') else ''}" for name in
                     ("C_kN", "C0_kN", "C_u_kN", "e_C", "e", "Y1", "Y2") if name in figures]
    return ", ".join(parts)


def _say_of_bearing(entry: dict) -> None:
    """What is known of a bearing without a case, forces of a bearing at each load, and its lives under all of them together."""
    catalogue = "" if entry["case"] else _catalogue_text(entry.get("figures", {}))
    if catalogue:
        _say(f"    {catalogue}")
    loads = entry.get("load_cases") or [{"load_case": "", "share": None, "figures": entry.get("figures", {})}]
    for load in loads:
        figures = load["figures"]
        if "radial_force_N" in figures:
            name = f"load case {load['load_case']}: " if load["load_case"] else ""
            share = f" for {100 * load['share']:.4g} % of the time" if load["share"] is not None else ""
            _say(f"    {name}{figures['radial_force_N']:.6g} N radial, {figures['axial_force_N']:.6g} N axial{share}")
    if entry.get("lives"):
        _say("    all load cases together: " + ", ".join(f"{life} {hours:.6g} h" for life, hours in entry["lives"].items()))


def _told(conversion: Conversion) -> int:
    """0 where each planetary stage is a case; else 2, with the reason on standard error."""
    if conversion.is_complete:
        return 0
    report = conversion.report
    if not report["stages"]:
        counts = ", ".join(f"{len(report[kind])} {name if len(report[kind]) == 1 else name + 's'}"
                           for kind, name in (("pairs", "gear pair"), ("bearings", "bearing"), ("shafts", "shaft")))
        _complain(f"{report['source']}: no planetary stage found; {counts} in conversion.json, {len(conversion.cases)} cases")
    for stage in report["stages"]:
        for problem in stage.get("problems", []):
            _complain(f"{report['source']}: planetary stage {stage['component']} '{stage['name']}': {problem}")
    return 2


def _complain(text: str) -> None:
    print(printable(text), file=sys.stderr)


def main(arguments: list[str]) -> int:
    """Convert a file; messages go to standard error."""
    options = parser().parse_args(arguments)
    return exit_code("convert", lambda: run(options), "numpy, and netCDF4 for --results; on Debian install python3-numpy python3-netcdf4")


if __name__ == "__main__":
    sys.exit(finished(lambda: main(sys.argv[1:])))
