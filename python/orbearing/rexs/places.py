"""Where parts are along their shafts.

All versions state the middle of a part in space (support_vector). The coordinate on the shaft is the middle as well, but the beginning
of the face in files of version 1.0. So the place in space is taken, where file has that of the part and of its shaft.
"""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from orbearing.rexs.model import Component, Model
from orbearing.rexs.names import KNOWN, direction_of, in_unit, number_of, place_of

SAME_PLACE = 1e-5  # [m] positions in files have a hundredth of a millimetre at least
MOST_NAMED = 5


class Places:
    """Places along shafts [m]; what contradicts itself is kept for the notes."""

    def __init__(self, model: Model):
        self._model = model
        self._beginnings: dict[int, None] = {}
        self._contradictions: dict[tuple, str] = {}

    def along(self, part: Component, shaft: Optional[Component], name: str) -> Optional[float]:
        """Where a part is along a shaft; `name`: the attribute of its coordinate."""
        stated = number_of(part, name).number
        space = self._in_space(part, shaft) if shaft is not None and shaft.type == "shaft" else None
        if space is None:
            return stated
        if stated is not None and abs(space - stated) > SAME_PLACE:
            self._contradict(part, name, stated, space)
        return space

    def _in_space(self, part: Component, shaft: Component) -> Optional[float]:
        here, there = place_of(part), place_of(shaft)
        if here is None:
            return None
        reference = _reference(part)
        if reference == shaft.id:
            return here[0]
        if there is None or reference != _reference(shaft):
            return None
        axis = np.array(direction_of(shaft, "u_axis_vector") or [1.0, 0.0, 0.0])
        return float(np.dot(np.subtract(here, there), axis / np.linalg.norm(axis)))

    def _contradict(self, part: Component, name: str, stated: float, space: float) -> None:
        width = number_of(part, "face_width").number if part.type in KNOWN["face_width"].components else None
        if width is not None and abs(space - stated - 0.5 * width) <= SAME_PLACE:
            self._beginnings[part.id] = None
        else:
            self._contradictions[part.id, name] = (f"component {part.id} ('{part.name}'): {KNOWN[name].names[0]} is {in_unit(stated, 'mm'):.6g} mm; "
                                                   f"its support_vector gives {in_unit(space, 'mm'):.6g} mm, which is taken")

    @property
    def notes(self) -> list[str]:
        """What the file says twice and differently, of what has been read so far."""
        found = []
        if self._beginnings:
            named = ", ".join(map(str, list(self._beginnings)[:MOST_NAMED])) + (", ..." if len(self._beginnings) > MOST_NAMED else "")
            found.append(f"u_coordinate_on_shaft of {len(self._beginnings)} gears ({named}) is that of the face's beginning, half a face width before "
                         "their support_vector; the support_vector is taken")
        return found + list(self._contradictions.values())


def _reference(component: Component) -> Any:
    """The component from which a place in space counts; None where it is not stated."""
    attribute = component.attributes.get("reference_component_for_position")
    return attribute.value if attribute is not None else None
