#!/usr/bin/env python3
"""The planet of planet_bearing.py in Exudyn, an implicit multibody code, on the FMU or on the bearing in this process.

    exudyn_planet.py BEARING.fmu CHECK.json     needs numpy, FMPy and Exudyn (PyPI)
    exudyn_planet.py CASE.yaml                  needs numpy, Exudyn and the Python package orbearing

Prints, for exchanges half a step and a step ahead, the error of the planet's place over 0.3 ms against a fine run of
planet_bearing.py, which knows nothing of Exudyn.
"""

import sys

import exudyn as exu
import numpy as np
from exudyn.utilities import LoadForceVector, MarkerNodePosition, NodePoint2D, ObjectMassPoint2D
from planet_bearing import LOST, Bearing, LiveBearing, duty_of, run_bearing

SIZES = (2e-6, 5e-6, 10e-6, 20e-6)  # [s]
SHORT, FINE = 3e-4, 1e-7  # [s]
SOLVERS = {"generalised alpha": exu.DynamicSolverType.GeneralizedAlpha, "Runge-Kutta": exu.DynamicSolverType.RK44}


class Exchange:
    """Before each step of the multibody code the FMU goes that share of a step ahead; its force holds over the step."""

    def __init__(self, bearing, node, size, share, slopes):
        self.bearing, self.node, self.size, self.share, self.slopes = bearing, node, size, share, slopes
        self.force, self.velocity, self.fmu_time, self.places = bearing.force(), np.zeros(2), 0.0, []

    def before_step(self, mbs, _):
        place = np.array(mbs.GetNodeOutput(self.node, exu.OutputVariableType.Displacement))[:2]
        velocity = np.array(mbs.GetNodeOutput(self.node, exu.OutputVariableType.Velocity))[:2]
        if not np.abs(place).max() < LOST:
            return False
        time = self.size * len(self.places)
        back = time - self.fmu_time
        bend = (velocity - self.velocity) / self.size if self.slopes and self.places else np.zeros(2)
        self.bearing.step(self.fmu_time, back + self.share * self.size, place - back * velocity + back**2 / 2 * bend,
                          velocity - back * bend, bend if self.slopes else None)
        self.fmu_time, self.velocity, self.force = time + self.share * self.size, velocity, self.bearing.force()
        self.places.append(place)
        return True


def run_exudyn(bearing, duty, place, steps, size, share, slopes, solver="generalised alpha"):
    """Places [m] (steps, 2) at the beginning of each step; fewer where the planet leaves its bearing."""
    bearing.begin(place)
    system = exu.SystemContainer()
    mbs = system.AddSystem()
    node = mbs.AddNode(NodePoint2D(referenceCoordinates=[0, 0], initialCoordinates=list(place), initialVelocities=[0, 0]))
    mbs.AddObject(ObjectMassPoint2D(mass=duty.mass, nodeNumber=node))
    exchange = Exchange(bearing, node, size, share, slopes)
    marker = mbs.AddMarker(MarkerNodePosition(nodeNumber=node))
    mbs.AddLoad(LoadForceVector(markerNumber=marker, loadVector=[0, 0, 0], loadVectorUserFunction=lambda _, time, __:
                                [*(exchange.force + duty.gear_force(time)), 0.0]))
    mbs.SetPreStepUserFunction(exchange.before_step)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = steps, steps * size
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
    settings.solution.file.write = False
    try:
        mbs.SolveDynamic(settings, solverType=SOLVERS[solver])
    except (RuntimeError, ValueError):
        pass  # the planet has left its bearing: the places say when
    return np.array(exchange.places)


def errors(bearing, duty, sizes=SIZES):
    """[m] by solver, share of a step ahead and slopes: the largest distance for each size, NaN where the planet leaves."""
    rest = bearing.place_under(duty.static)
    fine, _ = run_bearing(bearing, duty, rest, round(SHORT / FINE), FINE, "half a step ahead, slopes")
    found = {}
    for solver in SOLVERS:
        for share in (0.5, 1.0):
            for slopes in (False, True):
                row = found.setdefault((solver, share, slopes), [])
                for size in sizes:
                    steps = round(SHORT / size)
                    places = run_exudyn(bearing, duty, rest, steps, size, share, slopes, solver)
                    whole = len(places) == steps
                    row.append(np.abs(places - fine[::round(size / FINE)][:steps]).max() if whole else np.nan)
    return found


def bearing_and_duty(file, check=None):
    if file.endswith(".fmu"):
        return Bearing(file), duty_of(check)
    import orbearing

    case = orbearing.load(file)
    return LiveBearing(case), duty_of(case.check())


def main():
    bearing, duty = bearing_and_duty(*sys.argv[1:])
    try:
        print("error in um at", *(f"{1e6 * size:g}" for size in SIZES), "us")
        for (solver, share, slopes), row in errors(bearing, duty).items():
            name = ("half a step ahead" if share < 1.0 else "a step ahead") + (", slopes" if slopes else "")
            print(f"{solver:20s} {name:28s}", *(f"{1e6 * error:.4f}" for error in row))
    finally:
        bearing.close()


if __name__ == "__main__":
    main()
