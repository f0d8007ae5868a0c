"""Files of a result: written aside and renamed, so that none is met half-written."""

from __future__ import annotations

import io
import os
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG

from orbearing import style
from orbearing.uncertainties.page import page

SAMPLES = "samples.nc"
DOTS_PER_INCH = 160


def save(result, folder: Path, resolved: str | None = None) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    if resolved is not None:
        _write(folder / "case.resolved.yaml", resolved.encode())
    for name, content in _pictures(result).items():
        _write(folder / name, content)
    _write(folder / "uncertainty.html", page(result).encode())
    aside = folder / f".{SAMPLES}.tmp"
    try:
        result.to_xarray().to_netcdf(aside, engine="netcdf4")
        os.replace(aside, folder / SAMPLES)
    finally:
        aside.unlink(missing_ok=True)
    _write(folder / "uncertainty.json", result.json().encode())  # last: where it stands, all stands
    return folder


def _pictures(result) -> dict[str, bytes]:
    found = {}
    with style.context():
        for name, figure in result.plot().items():
            for canvas, ending, more in ((FigureCanvasSVG, "svg", {"metadata": {"Date": None, "Creator": None}}),
                                         (FigureCanvasAgg, "png", {"dpi": DOTS_PER_INCH, "metadata": {"Software": None}})):
                canvas(figure)
                target = io.BytesIO()
                figure.savefig(target, format=ending, **more)
                found[f"{name}.{ending}"] = target.getvalue()
    return found


def _write(path: Path, content: bytes) -> None:
    aside = path.with_name(f".{path.name}.tmp")
    try:
        aside.write_bytes(content)
        os.replace(aside, path)
    finally:
        aside.unlink(missing_ok=True)
