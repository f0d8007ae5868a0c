"""`python3 -m orbearing.animate DIR -o FILE.gif`: a ball bearing in motion, in two projections, from the folder of `orbearing run`.

Left along the axis, right across it. To scale but for the cage's and the inner ring's shifts, which are drawn larger. Of the balls the run
keeps the first one's place and load: the others stand one pocket apart, and each is as dark as the first one was loaded where it stands.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np

from orbearing.terminal import Parser, finite, finished, whole_number

STEEL, BALL, CAGE, MARK = "0.82", "#1f4e79", "#b5651d", "#c0392b"
NEEDED = ("time", "first_ball_angle", "first_ball_inner_load", "inner_speed", "cage_x", "cage_y", "inner_x", "inner_y")
LENGTHS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}
SHOWN_SHIFT = 0.04  # largest drawn shift over the pitch diameter
BINS = 72


def resolved(path: Path) -> dict[str, str]:
    """Values of a resolved case by their paths; lists and texts as they stand."""
    values: dict[str, str] = {}
    parents: list[tuple[int, str]] = []
    for line in path.read_text(encoding="utf-8").splitlines():
        key, colon, value = line.strip().partition(":")
        if not colon or line.lstrip().startswith(("#", "-")):
            continue
        depth = len(line) - len(line.lstrip())
        parents = [one for one in parents if one[0] < depth]
        values[".".join([*(name for _, name in parents), key])] = value.strip()
        if not value.strip():
            parents.append((depth, key))
    return values


def length(values: dict[str, str], path: str) -> float:
    """[m]"""
    number, _, unit = values[path].partition(" ")
    return float(number) * LENGTHS[unit.split("#")[0].strip() or "m"]


def series(folder: Path) -> dict[str, np.ndarray]:
    """What the run kept over time."""
    import netCDF4  # pylint: disable=import-outside-toplevel

    files = sorted((folder / "points").glob("*.nc"))
    if not files:
        raise SystemExit(f"{folder}: found no points; required: the folder of a run of a ball bearing in time")
    with netCDF4.Dataset(files[0]) as data:
        missing = [name for name in NEEDED if name not in data.variables]
        if missing:
            raise SystemExit(f"{files[0]}: found no {', '.join(missing)}; required: a run of a ball bearing in time")
        names = [name for name, one in data.variables.items() if one.dimensions == ("time",)]
        return {name: np.asarray(data.variables[name][...]) for name in names}


def load_by_place(run: dict[str, np.ndarray]) -> np.ndarray:
    """Mean load of the first ball in each bin of its angle."""
    place = (np.mod(run["first_ball_angle"], 2 * np.pi) / (2 * np.pi) * BINS).astype(int) % BINS
    sums = np.bincount(place, weights=run["first_ball_inner_load"], minlength=BINS)
    counts = np.bincount(place, minlength=BINS)
    return np.where(counts > 0, sums / np.maximum(counts, 1), 0.0)


class Drawing:
    """Both projections; `show(t)` draws them at one time."""

    def __init__(self, figure: Any, values: dict[str, str], run: dict[str, np.ndarray]) -> None:
        self.run, self.balls = run, int(values["bearing.balls"])
        self.ball, self.pitch = length(values, "bearing.ball_diameter") / 2, length(values, "bearing.pitch_diameter") / 2
        self.cage = [length(values, f"bearing.cage.{name}_diameter") / 2 for name in ("inner", "outer")]
        self.loads = load_by_place(run)
        self.inner_angle = np.concatenate(([0.0], np.cumsum(0.5 * (run["inner_speed"][1:] + run["inner_speed"][:-1]) * np.diff(run["time"]))))
        largest = max(np.hypot(run["cage_x"], run["cage_y"]).max(), np.hypot(run["inner_x"], run["inner_y"]).max(), 1e-12)
        self.factor = SHOWN_SHIFT * 2 * self.pitch / largest
        self.front, self.side = figure.subplots(1, 2, width_ratios=(2, 1))

    def at(self, name: str, time: float) -> float:
        return float(np.interp(time, self.run["time"], self.run[name]))

    def show(self, time: float) -> None:
        first, turned = self.at("first_ball_angle", time), float(np.interp(time, self.run["time"], self.inner_angle))
        cage = self.factor * np.array([self.at("cage_x", time), self.at("cage_y", time)])
        inner = self.factor * np.array([self.at("inner_x", time), self.at("inner_y", time)])
        for axes in (self.front, self.side):
            axes.clear()
            axes.set_aspect("equal")
            axes.axis("off")
        self._front(first, turned, cage, inner)
        self._side(first, cage, inner)
        self.front.set_title(f"{1e3 * time:7.1f} ms, {self.at('inner_speed', time) * 30 / np.pi:5.0f} rpm", fontsize=9)

    def _colour(self, angle: float) -> tuple[float, float]:
        load = self.loads[int(np.mod(angle, 2 * np.pi) / (2 * np.pi) * BINS) % BINS]
        return 0.15 + 0.85 * load / max(self.loads.max(), 1e-12), load

    # The radial load points along x, drawn downwards.
    @staticmethod
    def _turned(x: float, y: float) -> tuple[float, float]:
        return y, -x

    def _front(self, first: float, turned: float, cage: np.ndarray, inner: np.ndarray) -> None:
        from matplotlib.patches import Annulus, Circle  # pylint: disable=import-outside-toplevel

        thick = 0.45 * self.ball
        self.front.add_patch(Annulus((0, 0), self.pitch + self.ball + thick, thick, color=STEEL))
        self.front.add_patch(Annulus(self._turned(*inner), self.pitch - self.ball, 1.5 * thick, color=STEEL))
        self.front.add_patch(Annulus(self._turned(*cage), self.cage[1], self.cage[1] - self.cage[0], color=CAGE, alpha=0.35))
        ends = [(inner[0] + r * np.cos(turned), inner[1] + r * np.sin(turned)) for r in (self.pitch - self.ball - 1.5 * thick, self.pitch - self.ball)]
        self.front.plot(*zip(*[self._turned(*end) for end in ends]), color=MARK, linewidth=2)
        for k in range(self.balls):
            angle = first + 2 * np.pi * k / self.balls
            place = self._turned(self.pitch * np.cos(angle), self.pitch * np.sin(angle))
            dark, _ = self._colour(angle)
            self.front.add_patch(Circle(place, self.ball, facecolor=BALL, alpha=dark, edgecolor=MARK if k == 0 else "k", linewidth=1.5 if k == 0 else 0.6))
        reach = 1.12 * (self.pitch + self.ball + thick)
        self.front.annotate("", (0, -reach), (0, -0.78 * (self.pitch - self.ball) * 0.4), arrowprops={"arrowstyle": "->", "color": "k"})
        self.front.set_xlim(-reach, reach)
        self.front.set_ylim(-reach, reach)

    def _side(self, first: float, cage: np.ndarray, inner: np.ndarray) -> None:
        from matplotlib.patches import Circle, Rectangle  # pylint: disable=import-outside-toplevel

        thick, wide = 0.45 * self.ball, 1.3 * self.ball
        for side in (-1, 1):
            outside = side * (self.pitch + self.ball + thick)
            self.side.add_patch(Rectangle((-wide, min(outside, outside - side * thick)), 2 * wide, thick, color=STEEL))
            top = -inner[0] + side * (self.pitch - self.ball)
            self.side.add_patch(Rectangle((-wide, min(top, top - side * 1.5 * thick)), 2 * wide, 1.5 * thick, color=STEEL))
            edge = -cage[0] + side * self.cage[0]
            self.side.add_patch(Rectangle((-wide, min(edge, edge + side * (self.cage[1] - self.cage[0]))), 2 * wide, self.cage[1] - self.cage[0],
                                          color=CAGE, alpha=0.35))
        for k in np.argsort([np.sin(first + 2 * np.pi * k / self.balls) for k in range(self.balls)]):  # the near ones last
            angle = first + 2 * np.pi * k / self.balls
            dark, _ = self._colour(angle)
            if np.sin(angle) > -0.2:
                self.side.add_patch(Circle((0, -self.pitch * np.cos(angle)), self.ball, facecolor=BALL, alpha=dark,
                                           edgecolor=MARK if k == 0 else "k", linewidth=1.5 if k == 0 else 0.6))
        reach = 1.12 * (self.pitch + self.ball + thick)
        self.side.set_xlim(-0.5 * reach, 0.5 * reach)
        self.side.set_ylim(-reach, reach)


def animate(folder: Path, into: Path, begin: float, seconds: float, frames: int) -> None:
    """Writes a GIF, or one picture with a few instants side by side where `into` ends on .png."""
    import matplotlib  # pylint: disable=import-outside-toplevel

    matplotlib.use("agg")
    from matplotlib.animation import FuncAnimation, PillowWriter  # pylint: disable=import-outside-toplevel
    from matplotlib.figure import Figure  # pylint: disable=import-outside-toplevel

    run, values = series(folder), resolved(folder / "case.resolved.yaml")
    end = run["time"][-1]
    start = max(run["time"][0], end - seconds) if begin < 0 else min(begin, end)
    times = np.linspace(start, min(start + seconds, end), frames)
    if into.suffix == ".png":
        figure = Figure(figsize=(3.2 * min(frames, 6), 2.2), layout="constrained")
        for part, time in zip(figure.subfigures(1, min(frames, 6), squeeze=False)[0], np.linspace(times[0], times[-1], min(frames, 6))):
            Drawing(part, values, run).show(time)
        figure.savefig(into, dpi=90)
        return
    from matplotlib import pyplot  # pylint: disable=import-outside-toplevel

    figure = pyplot.figure(figsize=(6, 4), layout="constrained")
    drawing = Drawing(figure, values, run)
    movie = FuncAnimation(figure, lambda time: drawing.show(time) or [], frames=times, blit=False)
    movie.save(into, writer=PillowWriter(fps=20), dpi=70)


def main(arguments: list[str] | None = None) -> int:
    parser = Parser(prog="python3 -m orbearing.animate", description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="of `orbearing run CASE -o DIR`")
    parser.add_argument("-o", dest="into", type=Path, required=True, help="FILE.gif, or FILE.png for a strip of six instants")
    parser.add_argument("--begin", type=finite, default=-1.0, help="time of the first picture [s]; left out: the end of the run is shown")
    parser.add_argument("--seconds", type=finite, default=0.05, help="time that is shown [s]")
    parser.add_argument("--frames", type=whole_number(1), default=60, help="pictures")
    given = parser.parse_args(arguments)
    animate(given.folder, given.into, given.begin, given.seconds, given.frames)
    return 0


if __name__ == "__main__":
    sys.exit(finished(main))
