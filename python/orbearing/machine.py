"""Bearings and gears that a script moves: the participants of the co-simulation, in this process."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Sequence

import numpy as np

from orbearing import _core
from orbearing.errors import CaseError

if TYPE_CHECKING:
    from orbearing.results import ComputedCase


class _Machine:
    """Inputs by name, a step in time, outputs by name. Axes x (outward) and y (in the sense of carrier rotation) turn with
    the carrier; SI throughout. See `inputs` and `outputs` for names, units and meanings."""

    _model = ""

    def __init__(self, case: "ComputedCase"):
        try:
            self._machine = _core.Machine(case.core, self._model)
        except CaseError as error:
            raise error.without_option() from None

    @property
    def inputs(self) -> list[tuple[str, str, str]]:
        """Name, unit and meaning of each input."""
        return self._machine.inputs

    @property
    def outputs(self) -> list[tuple[str, str, str]]:
        """Name, unit and meaning of each output."""
        return self._machine.output_list

    @property
    def time(self) -> float:
        """[s]"""
        return self._machine.time

    def set_input(self, name: Optional[str] = None, value: Optional[float] = None, slope: Optional[float] = None, **several) -> None:
        """One input, with its slope by time over the next step where it is known; or several by keyword, with _ for the
        dots of their names: planet_displacement_x=1e-6."""
        if name is not None:
            self._machine.set_input(name, value, slope)
        if several:
            names = {one.replace(".", "_"): one for one, _, _ in self._machine.inputs}
            for key, number in several.items():
                self._machine.set_input(names.get(key, key), number)

    def initialize(self, time: float = 0.0) -> None:
        """In balance under the present inputs, all turning at pure rolling. Done by the first step where it was not."""
        self._machine.initialize(time)

    def advance(self, step: float) -> None:
        """By `step` [s] under the inputs: displacements go on with the velocities beside them, all else with its slope,
        and they stand there afterwards. On an error the state is that before."""
        self._machine.advance(step)

    def output(self, name: str) -> float:
        """At the present time, under the present inputs."""
        return self._machine.output(name)

    def all_outputs(self) -> dict[str, float]:
        """Every output by its name, at the present time."""
        return dict(zip((name for name, _, _ in self._machine.output_list), self._machine.outputs()))

    def directional_derivative(self, outputs: Sequence[str], inputs: Sequence[str], direction: Sequence[float]) -> np.ndarray:
        """Of the outputs along a direction of the inputs, the inner state held, as FMI has it."""
        return np.array([sum(self._machine.slope(output, name) * part for name, part in zip(inputs, direction)) for output in outputs])

    def save(self) -> np.ndarray:
        """All that the future depends on: save, advance, restore, advance gives the same bits, in another process too."""
        return np.array(self._machine.save())

    def restore(self, state: np.ndarray) -> None:
        """Back to a state that save() gave."""
        self._machine.restore(np.asarray(state, dtype=float).tolist())


class Bearing(_Machine):
    """One bearing of one planet."""

    _model = "bearing"

    @property
    def force(self) -> np.ndarray:
        """[N] of the bearing on the planet, x outward and y in the sense of carrier rotation."""
        return np.array([self.output("force.x"), self.output("force.y")])

    @property
    def moment(self) -> float:
        """[N m] of the bearing on the planet, about its axis."""
        return self.output("moment")

    @property
    def stiffness(self) -> np.ndarray:
        """[N/m] (2, 2): the force grows by -stiffness times the displacement, the inner state held."""
        return -self._slopes("planet.displacement")

    @property
    def damping(self) -> np.ndarray:
        """[N s/m] (2, 2): the force grows by -damping times the velocity, the inner state held."""
        return -self._slopes("planet.velocity")

    def _slopes(self, motion: str) -> np.ndarray:
        return np.array([[self._machine.slope(f"force.{force}", f"{motion}.{along}") for along in "xy"] for force in "xy"])


class Gears(_Machine):
    """The gear set without its planet bearings, whose forces are its inputs."""

    _model = "gearset"
