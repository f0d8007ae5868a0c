"""A planet of a multibody model on its bearing: a bushing, or the bearing FMU of Orbearing through FMPy.

The planet moves in the frame of its carrier, x outward and y in the sense of carrier rotation. All in SI units.
"""

import math
import shutil

import fmpy
import fmpy.fmi2
import numpy as np

MASS = 0.1858  # [kg]  planet per bearing: the whole planet where it has one bearing
STATIC = np.array([609.0, 532.0])  # [N]  gears and centrifugal force, on one bearing
RIPPLE = np.array([0.0, 100.0])  # [N]  of the meshes
MESH = 2520.0  # [Hz]
LOST = 1e-3  # [m]  a planet so far from its pin is no longer on a bearing


def gear_force(time):
    """What everything but the bearing does to the planet. Your multibody tool has its own."""
    return STATIC + RIPPLE * math.sin(2.0 * math.pi * MESH * time)


class Bushing:
    """The spring and damper that the FMU replaces."""

    def __init__(self, stiffness, damping, place, force):
        self.stiffness, self.damping = stiffness, damping  # [N/m], [N s/m] (2, 2)
        self.place, self.rest = np.array(place), np.array(force)  # [m], [N] there

    def force(self, displacement, velocity):
        return self.rest - self.stiffness @ (displacement - self.place) - self.damping @ velocity


class Bearing:
    """The FMU: motion of the planet in, force on the planet out."""

    def __init__(self, file):
        self.folder = fmpy.extract(str(file))
        about = fmpy.read_model_description(self.folder)
        self.reference = {v.name: v.valueReference for v in about.modelVariables}
        self.start_of = {v.name: float(v.start) for v in about.modelVariables if v.start is not None}
        self.fmu = fmpy.fmi2.FMU2Slave(guid=about.guid, unzipDirectory=self.folder,
                                       modelIdentifier=about.coSimulation.modelIdentifier)
        self.motion = self._references("planet.displacement.x", "planet.displacement.y", "planet.velocity.x",
                                       "planet.velocity.y")
        self.forces = self._references("force.x", "force.y")
        self.begun = False

    def _references(self, *names):
        return [self.reference[name] for name in names]

    def close(self):
        if self.begun:
            self.fmu.freeInstance()
        shutil.rmtree(self.folder, ignore_errors=True)

    def begin(self, displacement, velocity=(0.0, 0.0)):
        """Rollers in balance under `displacement`; carrier and planet turn as the start values say."""
        if self.begun:
            self.fmu.reset()
        else:
            self.fmu.instantiate()
        self.begun = True
        self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()
        self.fmu.setReal(self.motion, [*displacement, *velocity])
        self.fmu.exitInitializationMode()

    def step(self, time, size, displacement, velocity, acceleration=None):
        """Over `size`; inside the step the displacement goes on with the velocity, and that with the acceleration."""
        self.fmu.setReal(self.motion, [*displacement, *velocity])
        if acceleration is not None:
            self.fmu.setRealInputDerivatives(self.motion[2:], [1, 1], list(acceleration))
        self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=size)

    def force(self):
        return np.array(self.fmu.getReal(self.forces))

    def get(self, *names):
        return self.fmu.getReal(self._references(*names))

    def force_at(self, place):
        """Of rollers in balance under `place`."""
        self.begin(place)
        return self.force()

    def stiffness_at(self, place, change=1e-8):
        """[N/m] (2, 2), rollers and pin in balance: what a bushing stands for. The FMU's directional derivatives
        are those with rollers and pin held, which is stiffer: what a solver wants inside a step."""
        force = self.force_at(place)
        moved = [self.force_at(np.add(place, change * axis)) for axis in np.eye(2)]
        return -np.array([(f - force) / change for f in moved]).T

    def damping(self):
        """[N s/m] (2, 2) at the present time, rollers and pin held."""
        columns = [self.fmu.getDirectionalDerivative(self.forces, [reference], [1.0]) for reference in self.motion[2:]]
        return -np.array(columns).T

    def place_under(self, load):
        """Where the planet rests [m] while `load` [N] and the rollers balance, by Newton."""
        place = 1e-6 * np.sign(load)
        for _ in range(50):
            missing = self.force_at(place) + load
            if np.abs(missing).max() < 1e-6 * np.abs(load).max():
                return place
            place = place + np.clip(np.linalg.solve(self.stiffness_at(place), missing), -5e-6, 5e-6)
        raise RuntimeError(f"no place under {load} N")


def move(place, velocity, time, size, bearing_force):
    """The planet over one step, by the classical Runge-Kutta scheme; `bearing_force` of the time since its start."""
    def rate(since, y):
        return np.concatenate((y[2:], (bearing_force(since, y) + gear_force(time + since)) / MASS))

    y = np.concatenate((place, velocity))
    k1 = rate(0.0, y)
    k2 = rate(size / 2, y + size / 2 * k1)
    k3 = rate(size / 2, y + size / 2 * k2)
    k4 = rate(size, y + size * k3)
    y = y + size / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return y[:2], y[2:]


def run_bushing(bushing, place, steps, size):
    """Places [m] (steps + 1, 2) of the planet on the bushing."""
    velocity, places = np.zeros(2), [np.array(place)]
    for k in range(steps):
        place, velocity = move(places[-1], velocity, k * size, size, lambda _, y: bushing.force(y[:2], y[2:]))
        places.append(place)
    return np.array(places)


def parallel(bearing, time, size, state):
    """Both hold what the other said last, as most tools do by themselves."""
    bearing.step(time, size, state.place, state.velocity)
    state.move(time, size, state.force)
    state.force = bearing.force()


def in_turn(bearing, time, size, state):
    """The planet moves first, under the last force; the FMU then gets its mean velocity."""
    begin = state.place
    state.move(time, size, state.force)
    bearing.step(time, size, begin, (state.place - begin) / size)
    state.force = bearing.force()


def in_turn_with_slopes(bearing, time, size, state):
    """The force goes on along a straight line; the FMU gets the velocity at the beginning and its slope."""
    slope = (state.force - state.force_before) / size
    place, velocity = state.place, state.velocity
    state.move(time, size, state.force, slope)
    bearing.step(time, size, place, velocity, (state.velocity - velocity) / size)
    state.force_before, state.force = state.force, bearing.force()


def half_ahead(bearing, time, size, state, slopes=False):
    """The FMU goes half a step ahead along the planet's velocity, so that its force is that of the middle of the
    planet's step."""
    back = time - state.fmu_time
    bend = state.acceleration if slopes else np.zeros(2)
    bearing.step(state.fmu_time, back + size / 2, state.place - back * state.velocity + back**2 / 2 * bend,
                 state.velocity - back * bend, bend if slopes else None)
    state.fmu_time = time + size / 2
    velocity = state.velocity
    state.force = bearing.force()
    state.move(time, size, state.force)
    state.acceleration = (state.velocity - velocity) / size


def half_ahead_with_slopes(bearing, time, size, state):
    """As half_ahead, and along the acceleration of the last step too."""
    half_ahead(bearing, time, size, state, slopes=True)


EXCHANGES = {"parallel": parallel, "in turn": in_turn, "in turn, slopes": in_turn_with_slopes,
             "half a step ahead": half_ahead, "half a step ahead, slopes": half_ahead_with_slopes}


class Planet:
    """What an exchange remembers from step to step."""

    def __init__(self, place, force):
        self.place, self.velocity, self.acceleration = np.array(place), np.zeros(2), np.zeros(2)
        self.force = self.force_before = np.array(force)
        self.fmu_time = 0.0

    def move(self, time, size, force, slope=0.0):
        self.place, self.velocity = move(self.place, self.velocity, time, size,
                                         lambda since, _: force + slope * since)


def run_bearing(bearing, place, steps, size, exchange, watch=()):
    """Places [m] (steps + 1, 2) of the planet on the FMU, and what was watched (steps + 1, ...)."""
    bearing.begin(place)
    planet = Planet(place, bearing.force())
    places, watched = [planet.place], [bearing.get(*watch)]
    for k in range(steps):
        EXCHANGES[exchange](bearing, k * size, size, planet)
        if not np.abs(planet.place).max() < LOST:
            raise ArithmeticError(f"the planet has left its bearing at {k * size} s")
        places.append(planet.place)
        watched.append(bearing.get(*watch))
    return np.array(places), np.array(watched)
