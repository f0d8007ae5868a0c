"""Files of a result: written aside and renamed, so that none is met half-written."""

from __future__ import annotations

import io
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_svg import FigureCanvasSVG

from orbearing import style
from orbearing.studies.dataset import content_of_xarray, write_netcdf
from orbearing.uncertainties.page import page
from orbearing.whole_files import write_whole

SAMPLES = "samples.nc"
DOTS_PER_INCH = 160


def save(result, folder: Path, resolved: str | None = None) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    if resolved is not None:
        write_whole(folder / "case.resolved.yaml", resolved.encode())
    for name, content in _pictures(result).items():
        write_whole(folder / name, content)
    write_whole(folder / "uncertainty.html", page(result).encode())
    write_netcdf(folder / SAMPLES, content_of_xarray(result.to_xarray()))
    write_whole(folder / "uncertainty.json", result.json().encode())  # last: where it stands, all stands
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
