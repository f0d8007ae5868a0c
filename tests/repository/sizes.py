"""Sizes of the sources without tests, each at most its limit.

A later capability raises a limit by the lines that it declares, with its reason, in the same commit.
"""
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
LIBRARY = ("mechanics", "gearset", "bearing", "coupling", "include", "app")
KINDS = {".hpp", ".cpp", ".inl", ".ipp", ".in"}
BASE = {"lines": 80_373, "lines of app": 27_430, "types": 1_185, "headers": 329}  # when results, analyses and laws were stated once
DECLARED = (  # lines, of these of app, types and headers of later capabilities
    ("the catalogue as a table that users extend, needle roller and cage assemblies", 740, 650, 8, 1),
    ("OpenFAST and spreadsheet tables, several records with --case, damage by file, hours in skid risk", 1_380, 1_370, 20, 2),
    ("requirements and verdicts; torque, torque over speed, K_A; load sharing, defect lines, stiffness of pairs", 890, 800, 6, 2),
    ("the page's server, templates, and what each page request may do", 1_970, 1_960, 22, 4),
    ("folders of results on the page, gone on with; shapes of modes as a result", 130, 130, 1, 0),
    ("a bearing in motion, shown as it is computed", 80, 50, 2, 1),
    ("packages of SSP, lives and a page of duplex pairs, geometry of sets without a bearing, refusals of public cases", 110, 110, 1, 0),
    ("the speed of any member; defaults that follow from size, and warnings of what hangs on a default", 472, 352, 3, 0),
    ("the carrier as a body in three dimensions: loads of each planet bearing over its revolution", 840, 110, 16, 4),
    ("loads over a revolution of the carrier in runs and sweeps, lives of each bearing, back flanks, modes in three dimensions", 890, 215, 13, 2),
    ("the core in a browser: units by a table, stand-ins for threads and files of results", 640, 640, 9, 1),
    ("bounds on what the page's server reads of a connection, and its pages by name", 160, 160, 2, 1),
    ("lives that results go by in tables, K_gamma beside a computed tilt, bounds of tilts, proposals in refusals", 50, 50, 0, 0),
    ("equivalent loads of angular-contact balls", 65, 5, 2, 0),
    ("friction at pure rolling, by formulas of others and at thermal reference speeds; lines that count once a bearing", 910, 400, 18, 4),
    ("tapered, spherical and ball bearings in planets at rest", 1_400, 316, 16, 4),
    ("any number of parallel stages, internal pairs, planets with two gears at rest, flexpins", 660, 255, 6, 1),
    ("oil where it is: fill by flow, outlet temperature, heated and ended inlets, computed rolling resistance of balls", 690, 90, 15, 4),
    ("planets that are unlike, elastic and tilted, of one set or several, in one balance", 300, 0, 2, 1),
    ("a housing that deflects under the carrier, laminae of tapered rollers, planets in pairs", 1_065, 295, 9, 3),
    ("scratched bearings of planets with a computed tilt, and of one of several sets", 249, 111, 1, 0),
    ("slip by drag against traction, bores that move with their gears, rims too soft, rows that compare two variants", 290, 110, 0, 1),
    ("the demo, warnings of former keys, folders of an installation by Debian's rules", 200, 200, 1, 0),
    ("oil of roller bearings: replenished inlets, starvation in motion, temperature by a balance of heats; heated films", 390, 95, 6, 2),
    ("a C interface, with what a case states as JSON; elliptic integrals for libraries without them", 375, 510, 2, 2),
    ("results over up to six inputs as a table with its error", 1_443, 765, 20, 3),
    ("steps of slow motion; sums over laminae with the same bits in all instruction sets", 75, 0, 1, 0),
    ("progress within a motion, its time before it starts, budgets of processor time", 870, 510, 8, 3),
    ("errors of steps that follow the load, slow full complements, the fastest part as the reason of a motion without steps", 140, 11, 2, 0),
)
LIMITS = {name: least + sum(row[1 + i] for row in DECLARED) for i, (name, least) in enumerate(BASE.items())}
LIMITS["headers with a single includer, %"] = 20.0
TYPE = re.compile(r"^[ \t]*(?:template <[^;{]*>\s*)?(?:struct|class|enum class|union)(?: \[\[\w+\]\])?(?: alignas\([^)]*\))?"
                  r" \w+(?: final)?(?: : [^;{]*)?\s*\{", re.MULTILINE)
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def sources():
    """Text of each source by its path from the root."""
    files = (file for folder in LIBRARY for file in (ROOT / folder).rglob("*") if file.suffix in KINDS)
    return {file.relative_to(ROOT).as_posix(): file.read_text(encoding="utf-8") for file in files}


def measured(texts):
    """The sizes that LIMITS names."""
    headers = {path for path in texts if path.endswith(".hpp")}
    includers = {path: set() for path in headers}
    for path, text in texts.items():
        for name in INCLUDE.findall(text):
            header = name if name in headers else f"include/{name}"
            if header in headers and path.removesuffix(".cpp") != header.removesuffix(".hpp"):
                includers[header].add(path)
    single = [header for header, users in includers.items() if len(users) == 1]
    lines = {path: text.count("\n") for path, text in texts.items()}
    return {
        "lines": sum(lines.values()),
        "lines of app": sum(count for path, count in lines.items() if path.startswith("app/")),
        "types": sum(len(TYPE.findall(text)) for text in texts.values()),
        "headers": len(headers),
        "headers with a single includer, %": round(100.0 * len(single) / len(headers), 1),
    }


def main():
    sizes = measured(sources())
    for name, limit in LIMITS.items():
        print(f"{name}: {sizes[name]:,} of {limit:,}")
    return any(sizes[name] > limit for name, limit in LIMITS.items())


if __name__ == "__main__":
    sys.exit(main())
