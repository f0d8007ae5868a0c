"""A planet of a multibody model on its bearing: a bushing, the bearing FMU of Orbearing through FMPy, or the same
bearing in this process.

The planet moves in the frame of its carrier, x outward and y in the sense of carrier rotation. All in SI units.
"""

import json
import math
import pathlib
import shutil
from dataclasses import dataclass

import numpy as np

RIPPLE = np.array([0.0, 100.0])  # [N]  of the meshes: an example's
LOST = 1e-3  # [m]  a planet so far from its pin is no longer on a bearing


@dataclass(frozen=True)
class Duty:
    """What everything but the bearing does to the planet, per bearing. Your multibody tool has its own."""

    mass: float  # [kg]  planet per bearing: the whole planet where it has one bearing
    static: np.ndarray  # [N]  (2,)  gears and centrifugal force, on one bearing
    mesh: float  # [Hz]

    def gear_force(self, time):
        return self.static + RIPPLE * math.sin(2.0 * math.pi * self.mesh * time)


def duty_of(check):
    """From what `orbearing check CASE --json` prints into a file, or from case.check() of the Python package."""
    check = check if hasattr(check, "keys") else json.loads(pathlib.Path(check).read_text(encoding="utf-8"))
    value = {row["path"]: float(row["value"]) for row in check["derived"] if row["unit"] in ("kg", "N", "Hz")}
    bearings = next(int(row["value"]) for row in check["inputs"] if row["path"] == "bearing.per_planet")
    return Duty(value["gearset.dynamics.planet.mass"] / bearings,
                np.array([value["operation.bore_load_x"], value["operation.bore_load_y"]]),
                value["gearset.dynamics.mesh_frequency"])


class Bushing:
    """The spring and damper that the FMU replaces."""

    def __init__(self, stiffness, damping, place, force):
        self.stiffness, self.damping = stiffness, damping  # [N/m], [N s/m] (2, 2)
        self.place, self.rest = np.array(place), np.array(force)  # [m], [N] there

    def force(self, displacement, velocity):
        return self.rest - self.stiffness @ (displacement - self.place) - self.damping @ velocity


class Placed:
    """What both bearings below have in common."""

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

    def place_under(self, load):
        """Where the planet rests [m] while `load` [N] and the rollers balance, by Newton."""
        place = 1e-6 * np.sign(load)
        for _ in range(50):
            missing = self.force_at(place) + load
            if np.abs(missing).max() < 1e-6 * np.abs(load).max():
                return place
            place = place + np.clip(np.linalg.solve(self.stiffness_at(place), missing), -5e-6, 5e-6)
        raise RuntimeError(f"no place under {load} N")


class Bearing(Placed):
    """The FMU: motion of the planet in, force on the planet out."""

    def __init__(self, file):
        import fmpy
        import fmpy.fmi2

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

    def damping(self):
        """[N s/m] (2, 2) at the present time, rollers and pin held."""
        columns = [self.fmu.getDirectionalDerivative(self.forces, [reference], [1.0]) for reference in self.motion[2:]]
        return -np.array(columns).T


class LiveBearing(Placed):
    """The same bearing in this process, through the Python package: no file, no FMPy."""

    def __init__(self, case):
        self.machine = case.bearing()

    def close(self):
        pass

    def begin(self, displacement, velocity=(0.0, 0.0)):
        self._move(displacement, velocity)
        self.machine.initialize()

    def step(self, time, size, displacement, velocity, acceleration=None):
        self._move(displacement, velocity, acceleration)
        self.machine.advance(size)

    def _move(self, displacement, velocity, acceleration=None):
        for axis, place, speed, slope in zip("xy", displacement, velocity, acceleration if acceleration is not None else (None, None)):
            self.machine.set_input(f"planet.displacement.{axis}", place)
            self.machine.set_input(f"planet.velocity.{axis}", speed, slope)

    def force(self):
        return self.machine.force

    def get(self, *names):
        return [self.machine.output(name) for name in names]

    def damping(self):
        return self.machine.damping


class Held:
    """An integrator that holds the bearing's force over its step, as leapfrog does: the classical Runge-Kutta scheme,
    so that all error comes from the exchange."""

    def __init__(self, duty, force):
        self.duty = duty

    def move(self, place, velocity, time, size, bearing_force):
        """Place and velocity after the step; `bearing_force` of the time since its start and of place and velocity."""
        def rate(since, y):
            force = bearing_force(since, y[:2], y[2:]) + self.duty.gear_force(time + since)
            return np.concatenate((y[2:], force / self.duty.mass))

        y = np.concatenate((place, velocity))
        k1 = rate(0.0, y)
        k2 = rate(size / 2, y + size / 2 * k1)
        k3 = rate(size / 2, y + size / 2 * k2)
        k4 = rate(size, y + size * k3)
        y = y + size / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return y[:2], y[2:]


class GeneralisedAlpha:
    """What implicit multibody codes use: forces belong to the end of the step, however they came about."""

    RADIUS = 0.5  # [-]  spectral radius at infinite frequency

    def __init__(self, duty, force):
        self.duty = duty
        self.true = self.carried = (force + duty.gear_force(0.0)) / duty.mass  # [m/s2]

    def move(self, place, velocity, time, size, bearing_force):
        r = self.RADIUS
        mass_share, force_share = (2.0 * r - 1.0) / (r + 1.0), r / (r + 1.0)
        gamma = 0.5 - mass_share + force_share
        beta = 0.25 * (gamma + 0.5) ** 2
        true = (bearing_force(size, place, velocity) + self.duty.gear_force(time + size)) / self.duty.mass
        carried = ((1.0 - force_share) * true + force_share * self.true - mass_share * self.carried) / (1.0 - mass_share)
        place = place + size * velocity + size**2 * ((0.5 - beta) * self.carried + beta * carried)
        velocity = velocity + size * ((1.0 - gamma) * self.carried + gamma * carried)
        self.true, self.carried = true, carried
        return place, velocity


INTEGRATORS = {"force held over the step": Held, "generalised alpha": GeneralisedAlpha}


def run_bushing(bushing, duty, place, steps, size):
    """Places [m] (steps + 1, 2) of the planet on the bushing."""
    velocity, places, integrator = np.zeros(2), [np.array(place)], Held(duty, None)
    for k in range(steps):
        place, velocity = integrator.move(places[-1], velocity, k * size, size, lambda _, u, v: bushing.force(u, v))
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


def ahead(share, slopes):
    """The FMU goes that share of a step ahead along the planet's velocity - with slopes, along the acceleration of the
    last step too -, so that its force is that of the middle (1/2) or of the end (1) of the planet's step."""
    def exchange(bearing, time, size, state):
        back = time - state.fmu_time
        bend = state.acceleration if slopes else np.zeros(2)
        bearing.step(state.fmu_time, back + share * size, state.place - back * state.velocity + back**2 / 2 * bend,
                     state.velocity - back * bend, bend if slopes else None)
        state.fmu_time = time + share * size
        velocity = state.velocity
        state.force = bearing.force()
        state.move(time, size, state.force)
        state.acceleration = (state.velocity - velocity) / size
    return exchange


EXCHANGES = {"parallel": parallel, "in turn": in_turn, "in turn, slopes": in_turn_with_slopes,
             "half a step ahead": ahead(0.5, False), "half a step ahead, slopes": ahead(0.5, True),
             "a step ahead": ahead(1.0, False), "a step ahead, slopes": ahead(1.0, True)}


class Planet:
    """What an exchange remembers from step to step."""

    def __init__(self, duty, place, force, integrator):
        self.place, self.velocity, self.acceleration = np.array(place), np.zeros(2), np.zeros(2)
        self.force = self.force_before = np.array(force)
        self.fmu_time = 0.0
        self.integrator = INTEGRATORS[integrator](duty, force)

    def move(self, time, size, force, slope=0.0):
        self.place, self.velocity = self.integrator.move(self.place, self.velocity, time, size,
                                                         lambda since, *_: force + slope * since)


def run_bearing(bearing, duty, place, steps, size, exchange, watch=(), integrator="force held over the step"):
    """Places [m] (steps + 1, 2) of the planet on the FMU, and what was watched (steps + 1, ...)."""
    bearing.begin(place)
    planet = Planet(duty, place, bearing.force(), integrator)
    places, watched = [planet.place], [bearing.get(*watch)]
    for k in range(steps):
        EXCHANGES[exchange](bearing, k * size, size, planet)
        if not np.abs(planet.place).max() < LOST:
            raise ArithmeticError(f"the planet has left its bearing at {k * size} s")
        places.append(planet.place)
        watched.append(bearing.get(*watch))
    return np.array(places), np.array(watched)
