"""`python3 -m orbearing.report DIR`: DIR/report.json becomes DIR/report.html, one self-contained page.

What the program wrote of a sweep is completed by what only pictures show, for which it is asked again.

Of a dynamic result each point gets a page that plays its motion, DIR/animations/*.html; the report names them.

Exit codes as of the command line: 0 done, 1 the page could not be made, 2 bad input or usage.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from pathlib import Path

from orbearing.errors import CaseError, ComputationError

def build(folder: Path) -> str:
    """The page of a result folder as text; the same results give the same bytes."""
    return build_all(folder)["report.html"]


def build_all(folder: Path, program: str = "", every_effect: bool = False, quiet: bool = True) -> dict[str, str]:
    """Every page by its name below the result folder; the report itself comes last."""
    from orbearing import animation, ball_page, crown_page, defect_page, report_data, style
    from orbearing.page import page
    from orbearing.result_folder import Report, read_report

    report, data = read_report(folder), {}
    if "shown" in report.content:
        report = Report(report_data.complete(report.content, report_data.Program(folder, program, quiet), every_effect), folder)
        data["report.json"] = json.dumps(report.content, indent=1, ensure_ascii=False) + "\n"
    blocks = blocks_of(report)
    with style.context():
        for kind, draw in (("crown", crown_page.page), ("defect", defect_page.page), ("balls", ball_page.page)):
            if report.record(kind):
                return {"report.html": draw(report, blocks)}
        pages = dict(animation.pages(report.along_speed()))
        return {**data, **pages, "report.html": page(report, blocks, tuple(pages))}


def blocks_of(report) -> list:
    """The figures of a result of any kind, in the order of its page."""
    from orbearing import figures, style
    from orbearing.figures import ball_motion, crown, defect
    from orbearing.point_file import read_only_point

    with style.context():
        if report.record("crown"):
            return list(crown.blocks(report))
        if report.record("defect"):
            return list(defect.blocks(report, read_only_point(report.folder)))
        if report.record("balls"):
            return list(ball_motion.blocks(report, read_only_point(report.folder)))
        return figures.blocks_of(report)


def write_all(folder: Path, pages: dict[str, str]) -> None:
    """Write beside the targets and rename when all are whole, so that a reader never meets half a page or half of the pages."""
    made: list[Path] = []
    aside: dict[Path, Path] = {}
    try:
        for name, text in pages.items():
            path = folder / name
            if path.parent != folder and path.parent.is_symlink():
                raise CaseError(f"{path.parent}: found a link to {os.readlink(path.parent)}; required: a folder of its own, so that nothing outside is "
                                "written to. Remove the link")
            if not path.parent.exists():
                path.parent.mkdir()
                made.append(path.parent)
            _write_aside(path, text, aside)
        for path, name in aside.items():
            os.replace(name, path)
    except BaseException:
        for name in aside.values():
            name.unlink(missing_ok=True)
        for empty in made:
            empty.rmdir()
        raise


def _write_aside(path: Path, text: str, aside: dict[Path, Path]) -> None:
    handle, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".tmp", dir=path.parent)
    aside[path] = Path(name)
    with os.fdopen(handle, "w", encoding="utf-8", errors="replace", newline="\n") as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())
    umask = os.umask(0)
    os.umask(umask)
    os.chmod(name, 0o666 & ~umask)


def main(arguments: list[str]) -> int:
    """Make the page; messages go to standard error."""
    parser = argparse.ArgumentParser(prog="python3 -m orbearing.report", description="DIR/report.json becomes DIR/report.html.")
    parser.add_argument("folder", metavar="DIR", type=Path)
    parser.add_argument("--program", default="", help=argparse.SUPPRESS)
    parser.add_argument("--every-effect", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--quiet", action="store_true", help=argparse.SUPPRESS)
    try:
        options = parser.parse_args(arguments)
    except SystemExit as end:
        return int(end.code or 0)
    folder = options.folder
    try:
        write_all(folder, build_all(folder, options.program, options.every_effect, options.quiet))
    except ImportError as error:
        print(f"report: {error}; numpy and matplotlib are required; on Debian install python3-matplotlib", file=sys.stderr)
        return 1
    except CaseError as error:
        print(f"report: {error}", file=sys.stderr)
        return 2
    except (ComputationError, KeyboardInterrupt) as error:
        print(f"report: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"{folder}: report.html cannot be written ({error.strerror}); free space and write permission are required",
              file=sys.stderr)
        # A place that cannot be written to is bad input; a disk that is full is not.
        return 2 if isinstance(error, (IsADirectoryError, NotADirectoryError, PermissionError)) else 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
