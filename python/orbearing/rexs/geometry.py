"""Elementary gear geometry that a file leaves to its reader: reference circles, profile shifts from centre distances."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional

SAME_SHIFT = 0.005  # [module] as the check of a case allows


@dataclass(frozen=True)
class Teeth:
    """What a stage's gears have in common."""

    module: float  # [m]
    pressure_angle: float  # [rad]
    helix: float  # [rad]

    @property
    def transverse_module(self) -> float:
        """[m]"""
        return self.module / math.cos(self.helix)

    @property
    def transverse_angle(self) -> float:
        """[rad]"""
        return math.atan(math.tan(self.pressure_angle) / math.cos(self.helix))

    def reference_diameter(self, teeth: float) -> float:
        """[m]"""
        return teeth * self.transverse_module

    def shift_sum(self, teeth_sum: float, centre_distance: float) -> Optional[float]:
        """Sum of the shifts of an external pair at a centre distance [m]; of an internal one, with the difference of its teeth, ring less planet outward."""
        ratio = teeth_sum * self.transverse_module * math.cos(self.transverse_angle) / (2.0 * centre_distance)
        if not 0.0 < ratio <= 1.0 or math.tan(self.pressure_angle) == 0.0:
            return None
        working = math.acos(ratio)
        involute = math.tan(working) - working - math.tan(self.transverse_angle) + self.transverse_angle
        return teeth_sum * involute / (2.0 * math.tan(self.pressure_angle))

    def contact_ratio(self, planet: tuple[float, float], mate: tuple[float, float], distance: float, internal: bool) -> Optional[float]:
        """Transverse contact ratio of two gears, each of teeth and tip diameter [m]; None where they do not mesh."""
        inward = -1.0 if internal else 1.0
        bases = [self.reference_diameter(number) * math.cos(self.transverse_angle) for number, _ in (planet, mate)]
        ratio = 0.5 * (bases[0] + inward * bases[1]) / distance * inward
        paths = [tip * tip - base * base for (_, tip), base in zip((planet, mate), bases)]
        if not 0.0 < ratio <= 1.0 or min(paths) < 0.0:
            return None
        length = 0.5 * math.sqrt(paths[0]) + inward * 0.5 * math.sqrt(paths[1]) - inward * distance * math.sin(math.acos(ratio))
        return length / (math.pi * self.transverse_module * math.cos(self.transverse_angle))


def crown_drop(radius: float, length: float, laminae: int) -> float:
    """Relief [m] of a roller of this crowning radius and length [m] at the middle of the outermost lamina."""
    place = 0.5 * length * (laminae - 1.0) / laminae
    return place * place / (radius + math.sqrt(radius * radius - place * place)) if radius > place else 0.0
