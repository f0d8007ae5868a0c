#!/usr/bin/env python3
"""A ball bearing beside the general multibody code Exudyn: simulated over computing time, and the loads.

Exudyn's own model of a ball bearing (exudyn.machines.CreateBallBearing: balls as rigid bodies, contacts of sphere and
torus) with the geometry of cases/deep_groove_motor at 4000 rpm under 500 N, and ours, both dry and as alike as the two
allow; what stays unlike is in benchmarks/README.md. Exudyn's step is the fastest of several whose loads agree with those
of steps of a microsecond. Needs the Python package exudyn; prints one JSON object.

    benchmarks/exudyn_ball.py --orbearing build/release/bin/orbearing
"""
import argparse
import json
import math
import os
import time

from command import Run, middle, say, settings

RPM, LOAD = 4000.0, 500.0  # 1/min, N
# As cases/deep_groove_motor has them.
BALLS, BALL, PITCH, CLEARANCE = 7, 9.52e-3, 36e-3, 20e-6  # -, m
OSCULATION = {"inner": 0.52, "outer": 0.53}
WIDTH, BORE, OUTSIDE = 15e-3, 20e-3, 52e-3  # m
YOUNG, POISSON, DENSITY = 206e9, 0.3, 7850.0  # Pa, -, kg/m3
CAGE_DENSITY = 1310.0  # kg/m3
CAGE_STIFFNESS, CAGE_DAMPING = 1e5, 1e2  # N/m, N s/m  of Exudyn's springs in place of pockets, as in its example
FRICTION, SLIDING_SCALE = 0.05, 0.1  # -, m/s
DAMPING = 0.1  # s/m  of the contact's load, ours
RING_MASS = 0.03  # kg  of the inner ring
SETTLING, WATCHED = 0.1, 0.09  # s  two revolutions of the cage are watched
RMS_EQUAL, MAX_EQUAL = 2e-3, 1e-2
STEPS = [2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6]  # s  the longest; it cuts them where it must
REFERENCE_STEP = 1e-6  # s


def elliptic(parameter):
    """Complete elliptic integrals of the first and second kind by the arithmetic-geometric mean."""
    a, b, c, power = 1.0, math.sqrt(1.0 - parameter), math.sqrt(parameter), 0.5
    total = power * c * c
    while c > 1e-12:  # its square is what counts
        a, b, c, power = 0.5 * (a + b), math.sqrt(a * b), 0.5 * (a - b), 2.0 * power
        total += power * c * c
    first = math.pi / (2.0 * a)
    return first, first * (1.0 - total)


def hertz_stiffness(race):
    """K of Q = K approach^1.5 [N/m^1.5] of a ball on its race [Harris2006, ch. 6]."""
    gamma = BALL / PITCH
    sign = 1.0 if race == "inner" else -1.0
    turning = 2.0 * sign * gamma / (1.0 - sign * gamma)  # of the race along rolling, times the ball's diameter
    groove = 1.0 / OSCULATION[race]
    total = (4.0 + turning - groove) / BALL
    difference = (turning + groove) / (4.0 + turning - groove)
    low, high = 1.0 + 1e-9, 1e3  # ratio of the axes
    for _ in range(200):
        ratio = math.sqrt(low * high)
        first, second = elliptic(1.0 - 1.0 / ratio**2)
        value = ((ratio**2 + 1.0) * second - 2.0 * first) / ((ratio**2 - 1.0) * second)
        low, high = (ratio, high) if value < difference else (low, ratio)
    first, second = elliptic(1.0 - 1.0 / ratio**2)
    per_load = 2.0 * first / math.pi * (math.pi / (2.0 * ratio**2 * second)) ** (1.0 / 3.0)
    modulus = YOUNG / (2.0 * (1.0 - POISSON**2))  # of both bodies
    approach = per_load * (3.0 / (2.0 * total * modulus)) ** (2.0 / 3.0) * total / 2.0  # under 1 N
    return approach**-1.5


class Exudyn:
    """Exudyn's ball bearing, whose inner ring turns at constant speed under a radial load."""

    def __init__(self):
        import exudyn as exu
        from exudyn.itemInterface import MarkerBodyRigid, SensorObject
        from exudyn.machines import CreateBallBearing, GetBallBearingData
        from exudyn.rigidBodyUtilities import RigidBodyInertia
        import numpy as np

        self.exu = exu
        self.container = exu.SystemContainer()
        self.mbs = mbs = self.container.AddSystem()
        speed = RPM * 2.0 * math.pi / 60.0
        gamma = BALL / PITCH
        cage = 0.5 * speed * (1.0 - gamma)
        spin = cage - 0.5 * speed / gamma * (1.0 - gamma**2)
        data = GetBallBearingData([0, 0, 1], OUTSIDE, BORE, WIDTH, BALLS, radiusBalls=0.5 * BALL, radiusCage=0.5 * PITCH,
                                  innerGrooveRadius=OSCULATION["inner"] * BALL,
                                  outerGrooveRadius=OSCULATION["outer"] * BALL)
        data["innerGrooveTorusRadius"] -= 0.25 * CLEARANCE
        data["outerGrooveTorusRadius"] += 0.25 * CLEARANCE
        ground = mbs.CreateGround()
        ring = mbs.CreateRigidBody(inertia=RigidBodyInertia(RING_MASS, np.diag([1e-5, 1e-5, 1e-5])),
                                   nodeType=exu.NodeType.RotationRxyz, initialAngularVelocity=[0, 0, speed])
        for coordinate, value in ((2, 0.0), (3, 0.0), (4, 0.0), (5, speed)):
            mbs.CreateCoordinateConstraint(itemNumbers=[ring, None], coordinates=[coordinate, None],
                                           velocityLevel=True, offset=value, show=False)
        mbs.CreateForce(itemNumber=ring, loadVector=[LOAD, 0, 0])
        stand, turn = (mbs.AddMarker(MarkerBodyRigid(bodyNumber=body)) for body in (ground, ring))
        contact = {"contactStiffness": 1.0, "contactDamping": DAMPING * LOAD / BALLS,
                   "dynamicFriction": FRICTION, "contactStiffnessExponent": 1.5,
                   "frictionProportionalZone": SLIDING_SCALE}
        items = CreateBallBearing(mbs, data, turn, stand, DENSITY, CAGE_DENSITY,
                                  cageInitialAngularVelocity=[0, 0, cage], ballsInitialAngularVelocity=[0, 0, spin],
                                  springStiffnessCage=CAGE_STIFFNESS, springDampingCage=CAGE_DAMPING,
                                  contactParametersRingBalls=contact)
        for race, contacts in (("inner", items["innerRingBallContacts"]), ("outer", items["outerRingBallContacts"])):
            for item in contacts:
                mbs.SetObjectParameter(item, "contactStiffness", hertz_stiffness(race))
        self.sensors = [mbs.AddSensor(SensorObject(objectNumber=item, storeInternal=True,
                                                   outputVariableType=exu.OutputVariableType.Force))
                        for item in items["innerRingBallContacts"]]
        mbs.Assemble()
        self.time = 0.0  # s

    def advance(self, duration, step, watched):
        """Computing time [s] of `duration` [s]."""
        options = self.exu.SimulationSettings()
        options.solution.file.write = False
        options.solution.sensors.writePeriod = max(step, 2e-5) if watched else 2.0 * duration
        options.linearSolver.solverType = self.exu.LinearSolverType.EigenSparse
        options.parallel.numberOfThreads = 1
        run = options.timeIntegration
        run.numberOfSteps = max(1, round(duration / step))
        run.startTime, run.endTime = self.time, self.time + duration
        run.newton.useModifiedNewton = True
        run.newton.absoluteTolerance, run.newton.relativeTolerance = 1e-8, 1e-6
        # It recommends none where a contact closes that is neither in force nor at rest.
        run.discontinuous.useRecommendedStepSize = False
        run.verboseMode = 0
        before = time.thread_time()
        self.mbs.SolveDynamic(options, showHints=False, showCausingItems=False)
        used = time.thread_time() - before
        state = self.mbs.systemData
        for part in ("ODE2Coordinates", "ODE2Coordinates_t", "DataCoordinates"):
            getattr(state, "Set" + part)(getattr(state, "Get" + part)(), configuration=self.exu.ConfigurationType.Initial)
        self.time += duration
        return used

    def loads(self):
        import numpy as np
        forces = [np.linalg.norm(self.mbs.GetSensorStoredData(sensor)[:, 1:], axis=1) for sensor in self.sensors]
        return {"inner_load_rms_N": float(np.sqrt(np.mean(np.concatenate(forces)**2))),
                "inner_load_max_N": float(max(force.max() for force in forces))}


def exudyn_run(step):
    model = Exudyn()
    model.advance(SETTLING, step, False)
    seconds = model.advance(WATCHED, step, True)
    return model.loads(), WATCHED / seconds


def equal(found, reference):
    return (abs(found["inner_load_rms_N"] / reference["inner_load_rms_N"] - 1.0) <= RMS_EQUAL
            and abs(found["inner_load_max_N"] / reference["inner_load_max_N"] - 1.0) <= MAX_EQUAL)


def exudyn_figures(runs):
    """Its longest step need not be its fastest: Newton's method cuts steps that it cannot do."""
    reference, _ = exudyn_run(REFERENCE_STEP)
    best = None
    for step in STEPS:
        try:
            loads, factor = exudyn_run(step)
        except RuntimeError as error:  # its solver gave up
            say(f"Exudyn with steps of {step:g} s: {error}")
            continue
        if equal(loads, reference) and (best is None or factor > best[2]):
            best = step, loads, factor
    if best is None:
        return None, None, []
    step, loads, _ = best
    return step, loads, [exudyn_run(step)[1] for _ in range(runs)]


def ours(program, case, runs):
    """Loads of a whole run, and simulated over computing time between a long run and a short one."""
    same = [f"operation.shaft_speed={RPM:g} rpm", f"load.radial={LOAD:g} N", "simulation.start=rolling",
            "bearing.cage.pocket_film=none", "traction.law=regularised-coulomb", f"traction.friction={FRICTION:g}",
            f"traction.sliding_scale={SLIDING_SCALE:g} m/s", "traction.rolling_resistance=false",
            "drag.enabled=false", f"contact.damping={DAMPING:g} s/m"]
    short, long = 0.1, 0.1 + 10.0 * WATCHED

    def run(duration):
        return Run(program, ["run", case, *settings(same + [f"simulation.duration={duration:g} s"])])

    factors = []
    for _ in range(runs):
        last = run(long)
        factors.append((long - short) / (last.cpu - run(short).cpu))
    inner = last.result["inner"]
    return {"inner_load_rms_N": inner["load_rms_N"], "inner_load_max_N": inner["load_max_N"]}, factors


def main():
    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--orbearing", default=os.path.join(root, "build/release/bin/orbearing"))
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    say("ball bearing by Exudyn")
    step, theirs, their_factors = exudyn_figures(options.runs)
    say("the same by the program")
    loads, factors = ours(options.orbearing, os.path.join(root, "cases/deep_groove_motor/case.yaml"), options.runs)
    figures = {"exudyn_step_s": step, "exudyn_loads": theirs, "exudyn_beside": loads, "spreads": {}}
    for name, found in (("exudyn_real_time_factor", their_factors), ("exudyn_beside_real_time_factor", factors)):
        figures[name] = middle(found)[0] if found else None
        if found:
            figures["spreads"][name] = middle(found)[1:]
    figures["ball_speedup_over_exudyn"] = (figures["exudyn_beside_real_time_factor"] / figures["exudyn_real_time_factor"]
                                           if their_factors else None)
    print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
