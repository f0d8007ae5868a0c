#!/usr/bin/env python3
"""live_planet.py [CASE.yaml]: a planet on its bearing in a few lines of numpy, the bearing in this process.

The planet is a mass in the frame of its carrier; the gears press on it with the mean load of the case and a ripple at mesh
frequency. The bearing runs half a step ahead of the planet, along its velocity and acceleration, since its force holds over a
step (see the README beside). Needs numpy and the Python package orbearing.
"""

import sys

import numpy as np
import orbearing
from planet_bearing import duty_of


def run(case, steps=2000, size=1e-6):
    """Places of the planet [m] (steps, 2), forces of the bearing on it [N] (steps, 2), and the bearing."""
    duty, planet = duty_of(case.check()), case.bearing()
    planet.initialize()  # in balance under the load of the case
    place = np.array([planet.output("planet.start_displacement.x"), planet.output("planet.start_displacement.y")])
    velocity, acceleration, places, forces = np.zeros(2), np.zeros(2), [], []
    for step in range(steps):
        time = step * size
        back = time - planet.time
        at, speed = place - back * velocity + 0.5 * back**2 * acceleration, velocity - back * acceleration
        for axis in (0, 1):
            planet.set_input(f"planet.displacement.{'xy'[axis]}", at[axis])
            planet.set_input(f"planet.velocity.{'xy'[axis]}", speed[axis], acceleration[axis])
        planet.advance(back + 0.5 * size)
        force = planet.force
        acceleration = (force + duty.gear_force(time + 0.5 * size)) / duty.mass
        velocity = velocity + size * acceleration
        place = place + size * (velocity - 0.5 * size * acceleration)
        places.append(place)
        forces.append(force)
    return np.array(places), np.array(forces), planet


def main():
    case = orbearing.load(sys.argv[1] if len(sys.argv) > 1 else orbearing.cases()["reducer_150kW"])
    places, forces, planet = run(case)
    print(f"{case.name}: after {1e3 * planet.time:.2f} ms the planet stands {1e6 * places[-1][0]:.3f} um outward, {1e6 * places[-1][1]:.3f} um ahead")
    print(f"it sways by {1e6 * places[:, 1].std():.3f} um (rms) along y; largest force {np.abs(forces).max():.0f} N; "
          f"life used {planet.output('life_used'):.2e}")


if __name__ == "__main__":
    main()
