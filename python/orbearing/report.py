"""`python3 -m orbearing.report DIR`: DIR/report.json becomes DIR/report.html, one self-contained page, and with --pdf DIR/report.pdf.

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
from orbearing.terminal import finished

def build(folder: Path) -> str:
    """The page of a result folder as text; the same results give the same bytes."""
    return str(build_all(folder)["report.html"])


def build_all(folder: Path, program: str = "", every_effect: bool = False, quiet: bool = True, pdf: bool = False) -> dict[str, str | bytes]:
    """Every page by its name below the result folder; the report itself comes last."""
    from orbearing import animation, assessor_pdf, ball_page, crown_page, defect_page, pair_page, report_data, static_page, style
    from orbearing.page import page
    from orbearing.result_folder import Report, read_report

    report, pages = read_report(folder), {}
    given, asked = report, report_data.Program(folder, program, quiet)
    if "shown" in report.content:
        report = Report(report_data.complete(report.content, asked, every_effect), folder)
    elif study := report.record("static"):
        report = Report({**report.content, "static": {**study, "influences": report_data.influences(study, asked)}}, folder)
    elif pair := report.record("pair"):
        report = Report({**report.content, "pair": {**pair, "influences": report_data.influences(pair, asked, pair_page.life_key(pair))}}, folder)
    if report is not given:
        pages["report.json"] = json.dumps(report.content, indent=1, ensure_ascii=False) + "\n"
    blocks = blocks_of(report)
    with style.context():
        for kind, draw in (("crown", crown_page.page), ("defect", defect_page.page), ("balls", ball_page.page), ("static", static_page.page),
                           ("pair", pair_page.page)):
            if report.record(kind):
                pages["report.html"] = draw(report, blocks)
        if "report.html" not in pages:
            pages |= animation.pages(report.along_speed())
            pages["report.html"] = page(report, blocks, tuple(name for name in pages if name != "report.json"))
        if pdf:
            pages = {"report.pdf": assessor_pdf.pdf(assessor_pdf.rated(report), blocks), **pages}
    return pages


def blocks_of(report) -> list:
    """The figures of a result of any kind, in the order of its page."""
    from orbearing import figures, style
    from orbearing.figures import ball_motion, crown, defect, static_loads
    from orbearing.point_file import read_only_point

    with style.context():
        if report.record("crown"):
            return list(crown.blocks(report))
        if report.record("defect"):
            return list(defect.blocks(report, read_only_point(report.folder)))
        if report.record("balls"):
            return list(ball_motion.blocks(report, read_only_point(report.folder)))
        for kind in ("static", "pair"):
            if report.record(kind):
                return [static_loads.block(report, kind)]
        return figures.blocks_of(report)


def write_all(folder: Path, pages: dict[str, str | bytes]) -> None:
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


def _write_aside(path: Path, text: str | bytes, aside: dict[Path, Path]) -> None:
    handle, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".tmp", dir=path.parent)
    aside[path] = Path(name)
    with os.fdopen(handle, "wb") as stream:
        stream.write(text if isinstance(text, bytes) else text.encode("utf-8", errors="replace"))
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
    parser.add_argument("--pdf", action="store_true", help="also DIR/report.pdf, at most 8 pages for an assessor")
    parser.add_argument("--quiet", action="store_true", help=argparse.SUPPRESS)
    try:
        options = parser.parse_args(arguments)
    except SystemExit as end:
        return int(end.code or 0)
    folder = options.folder
    try:
        write_all(folder, build_all(folder, options.program, options.every_effect, options.quiet, options.pdf))
    except ImportError as error:
        print(f"report: {error}; numpy and matplotlib are required, and WeasyPrint for --pdf; on Debian install python3-matplotlib"
              f"{' weasyprint' if options.pdf else ''}", file=sys.stderr)
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
    sys.exit(finished(lambda: main(sys.argv[1:])))
