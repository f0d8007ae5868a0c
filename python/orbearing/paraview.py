"""`python3 -m orbearing.paraview DIR -o OUT`: rollers as ParaView draws them, from the folder of a run or a sweep.

Of a roller bearing under a static load OUT/rollers.vtp: each lamina of each roller with its load. Of a dynamic run OUT/rollers.pvd: a file for
each instant, each roller with its loads, sliding speeds, films and spin. Lengths in m, loads in N; z along the axis. XML files of VTK 0.1, in
PolyData with base64.
"""

from __future__ import annotations

import base64
import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from orbearing.animate import length, resolved
from orbearing.terminal import Parser, finished, whole_number
from orbearing.whole_files import write_whole

SIDES = 24  # of the prism that stands for a roller
TYPES = {"f": "Float64", "i": "Int32"}


@dataclass
class Surface:
    """Polygons with numbers on each of them."""

    points: np.ndarray  # [m] (points, 3)
    polygons: np.ndarray  # (polygons, corners)
    numbers: dict[str, np.ndarray] = field(default_factory=dict)  # (polygons)


def rollers(centres: np.ndarray, radius: float, edges: np.ndarray) -> Surface:
    """Prisms about `centres` [m] (rollers, 2), cut along z at `edges` [m]: a polygon for each side of each slice, roller by roller, slice by slice."""
    angles = 2 * np.pi * np.arange(SIDES) / SIDES
    ring = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    flat = centres[:, None, None, :] + ring[None, None, :, :] + np.zeros((1, len(edges), 1, 1))
    height = np.broadcast_to(edges[None, :, None, None], (*flat.shape[:3], 1))
    points = np.concatenate([flat, height], axis=3).reshape(-1, 3)
    roller, slice_, side = np.meshgrid(np.arange(len(centres)), np.arange(len(edges) - 1), np.arange(SIDES), indexing="ij")
    first = (roller * len(edges) + slice_) * SIDES
    after = (side + 1) % SIDES
    corners = np.stack([first + side, first + after, first + SIDES + after, first + SIDES + side], axis=-1)
    return Surface(points, corners.reshape(-1, 4))


def array(name: str, values: np.ndarray) -> str:
    """A DataArray of VTK: the number of bytes, then these."""
    values = np.ascontiguousarray(values, dtype="<f8" if values.dtype.kind == "f" else "<i4")
    content = base64.b64encode(np.uint32(values.nbytes).tobytes() + values.tobytes()).decode()
    width = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 else ""
    return f'<DataArray type="{TYPES[values.dtype.kind]}" Name="{name}"{width} format="binary">{content}</DataArray>\n'


def text_of(surface: Surface) -> str:
    """The surface as a .vtp file."""
    corners = surface.polygons
    ends = corners.shape[1] * np.arange(1, len(corners) + 1)
    cells = "".join(array(name, values) for name, values in surface.numbers.items())
    return ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32">\n<PolyData>\n'
            f'<Piece NumberOfPoints="{len(surface.points)}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{len(corners)}">\n'
            f"<CellData>\n{cells}</CellData>\n<Points>\n{array('position', surface.points)}</Points>\n"
            f"<Polys>\n{array('connectivity', corners.ravel())}{array('offsets', ends)}</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n")


def collection(names: list[str], times: np.ndarray) -> str:
    """A .pvd file: the files by their times [s]."""
    rows = "".join(f'<DataSet timestep="{time:.12g}" file="{name}"/>\n' for name, time in zip(names, times))
    return f'<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n<Collection>\n{rows}</Collection>\n</VTKFile>\n'


class Folder:
    """Sizes and numbers of one point of a result folder."""

    def __init__(self, folder: Path, point: int):
        import netCDF4  # pylint: disable=import-outside-toplevel

        files = sorted((folder / "points").glob("*.nc"))
        if not 0 <= point < len(files):
            raise SystemExit(f"--point: found {point} of {len(files)} points of {folder}; required: one that is there, counted from 0")
        values = resolved(folder / "case.resolved.yaml")
        missing = [path for path in ("bearing.roller_diameter", "bearing.roller_length", "bearing.pitch_diameter") if path not in values]
        if missing:
            raise SystemExit(f"{folder}: found no {', '.join(missing)}; required: results of one set with roller bearings, or of one roller bearing")
        self.radius, self.pitch = (0.5 * length(values, f"bearing.{size}_diameter") for size in ("roller", "pitch"))
        self.length = length(values, "bearing.roller_length")
        with netCDF4.Dataset(files[point]) as data:
            self.data = {name: np.ma.filled(one[...], np.nan) for name, one in data.variables.items() if one.dtype != str and one.dtype.kind == "f"}

    def centres(self, angles: np.ndarray) -> np.ndarray:
        return self.pitch * np.stack([np.cos(angles), np.sin(angles)], axis=-1)

    def edges(self, slices: int) -> np.ndarray:
        return self.length * (np.arange(slices + 1) / slices - 0.5)


def write_loads(folder: Folder, out: Path) -> Path:
    """Each lamina of each roller with its load [N] and the load per length [N/m]."""
    loads = folder.data["lamina_load"]
    surface = rollers(folder.centres(folder.data["steps_element_angles"]), folder.radius, folder.edges(loads.shape[1]))
    on_sides = np.repeat(loads.ravel(), SIDES)
    surface.numbers = {"load_N": on_sides, "load_per_length_N_per_m": on_sides * loads.shape[1] / folder.length}
    file = out / "rollers.vtp"
    write_whole(file, text_of(surface))
    return file


def write_motion(folder: Folder, out: Path, frames: int) -> Path:
    """Each roller with what the run kept of it, over `frames` instants."""
    data = folder.data
    names = [name for name in data if name.startswith("roller_") and data[name].shape == data["roller_angle"].shape]
    instants = np.unique(np.linspace(0, len(data["time"]) - 1, frames).round().astype(int))
    files = [f"rollers_{count:04d}.vtp" for count in range(len(instants))]
    for file, at in zip(files, instants):
        surface = rollers(folder.centres(data["roller_angle"][:, at]), folder.radius, folder.edges(1))
        surface.numbers = {name: np.repeat(data[name][:, at], SIDES) for name in names}
        write_whole(out / file, text_of(surface))
    whole = out / "rollers.pvd"
    write_whole(whole, collection(files, data["time"][instants]))
    return whole


def main(arguments: list[str] | None = None) -> int:
    parser = Parser(prog="python3 -m orbearing.paraview", description="Rollers with loads and motion as files that ParaView opens.")
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of `orbearing run` or `sweep`")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT", help="folder of the files; made where it is missing")
    parser.add_argument("--point", type=whole_number(0), default=0, help="point of a sweep, counted from 0 (0)")
    parser.add_argument("--frames", type=whole_number(1), default=100, help="most instants of a motion (100)")
    options = parser.parse_args(arguments)
    folder = Folder(options.folder, options.point)
    options.output.mkdir(parents=True, exist_ok=True)
    if "roller_angle" in folder.data:
        print(write_motion(folder, options.output, options.frames))
    elif "lamina_load" in folder.data and "steps_element_angles" in folder.data:
        print(write_loads(folder, options.output))
    else:
        raise SystemExit(f"{options.folder}: found neither a motion nor loads of laminae; required: a dynamic run, or a single roller bearing under a "
                         "static load")
    return 0


if __name__ == "__main__":
    sys.exit(finished(main))
