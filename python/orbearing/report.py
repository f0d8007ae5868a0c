"""`python3 -m orbearing.report DIR`: DIR/report.json becomes DIR/report.html, one self-contained page.

Of a dynamic result each point gets a page that plays its motion, DIR/animations/*.html; the report names them.

Exit codes as of the command line: 0 done, 1 the page could not be made, 2 bad input or usage.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from orbearing.errors import CaseError

USAGE = "usage: python3 -m orbearing.report DIR"


def build(folder: Path) -> str:
    """The page of a result folder as text; the same results give the same bytes."""
    return build_all(folder)["report.html"]


def build_all(folder: Path) -> dict[str, str]:
    """Every page by its name below the result folder; the report itself comes last."""
    from orbearing import animation, ball_page, crown_page, defect_page, style
    from orbearing.page import page
    from orbearing.result_folder import read_report

    report = read_report(folder)
    blocks = blocks_of(report)
    with style.context():
        for kind, draw in (("crown", crown_page.page), ("defect", defect_page.page), ("balls", ball_page.page)):
            if report.record(kind):
                return {"report.html": draw(report, blocks)}
        pages = dict(animation.pages(report.along_speed()))
        return {**pages, "report.html": page(report, blocks, tuple(pages))}


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
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print(USAGE, file=sys.stderr)
        return 0 if arguments in (["-h"], ["--help"]) else 2
    folder = Path(arguments[0])
    try:
        write_all(folder, build_all(folder))
    except ImportError as error:
        print(f"report: {error}; numpy and matplotlib are required; on Debian install python3-matplotlib", file=sys.stderr)
        return 1
    except CaseError as error:
        print(f"report: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"{folder}: report.html cannot be written ({error.strerror}); free space and write permission are required",
              file=sys.stderr)
        # A place that cannot be written to is bad input; a disk that is full is not.
        return 2 if isinstance(error, (IsADirectoryError, NotADirectoryError, PermissionError)) else 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
