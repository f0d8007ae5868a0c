#!/usr/bin/env python3
"""Recomputes the worked set for ISO/TS 16281 and compares: results.json, or a file of the same form by any other program.

    python3 recompute.py                     results.json beside this file
    python3 recompute.py other.json          another program's
    python3 recompute.py --values r22        all that this script computes of one case, as JSON

Needs Python alone. It shares no line with Orbearing and goes another way where there is one:

    elliptic integrals   arithmetic-geometric mean           (Orbearing: Carlson's forms, by Boost)
    axis ratio           bisection on its logarithm          (a bracketing method of higher order)
    balance of the ring  BFGS on forces, exact line search   (damped Newton with the stiffness matrix)

Equations, units and readings: README.md beside this file; numbers in brackets are its equations. N, mm, rad inside.
Ends with 1 where a value differs by more than 1e-8.
"""

import argparse
import json
import math
import pathlib
import sys

ALLOWED = 1e-8
SMALL = 1e-6  # entries of a list below this share of its largest are measured by this share
SMALL_ANGLE = 1e-2  # [deg]  the same of contact angles, which are zero where the ring stays centred
HERE = pathlib.Path(__file__).resolve().parent
MICROMETRE = 1e-3  # [mm]


# Geometry and Hertz's contact of balls


def elliptic_integrals(m):
    """Complete elliptic integrals K, E of the parameter m = k^2 < 1."""
    a, b, power = 1.0, math.sqrt(1.0 - m), 0.5
    rest = 1.0 - power * m
    while abs(a - b) > 1e-16 * a and power < 1e6:
        c = 0.5 * (a - b)
        a, b = 0.5 * (a + b), math.sqrt(a * b)
        power *= 2.0
        rest -= power * c * c
    first = 0.5 * math.pi / a
    return first, first * rest


def ellipse(difference):
    """(5): axis ratio chi of a contact, and its K and E."""

    def at(log_ratio):
        ratio = math.exp(log_ratio)
        first, second = elliptic_integrals(-math.expm1(-2.0 * log_ratio))
        return ratio, first, second, 1.0 - 2.0 / math.expm1(2.0 * log_ratio) * (first / second - 1.0)

    low, high = 1e-3, 20.0
    for _ in range(64):
        middle = 0.5 * (low + high)
        if at(middle)[3] < difference:
            low = middle
        else:
            high = middle
    return at(0.5 * (low + high))[:3]


def race_contact(inner, bearing, gamma):
    """(2) to (5) of one race."""
    diameter = bearing["ball_diameter_mm"]
    groove = bearing["inner_osculation" if inner else "outer_osculation"]
    along = gamma / (1.0 - gamma) if inner else -gamma / (1.0 + gamma)
    across = 1.0 / (2.0 * groove)
    total = 2.0 + along - across
    difference = (along + across) / total
    ratio, first, second = ellipse(difference)
    return {
        "curvature_sum_per_mm": 2.0 * total / diameter,
        "curvature_difference": difference,
        "axis_ratio": ratio,
        "elliptic_K": first,
        "elliptic_E": second,
    }


def ball_constant(inner, outer, material):
    """(6): c_P [N/mm^(3/2)]."""
    compliance = sum(
        race["elliptic_K"] * (race["axis_ratio"] ** 2 * race["elliptic_E"] / race["curvature_sum_per_mm"]) ** (-1.0 / 3.0)
        for race in (inner, outer)
    )
    modulus = material["youngs_modulus_MPa"] / (1.0 - material["poisson_ratio"] ** 2)
    return math.sqrt(2.0) * math.pi / 3.0 * modulus * compliance**-1.5


# Profiles of rollers


def circle(distance, station, drop):
    """Drop of the circle that leaves its tangent at 0 and lies `drop` lower at `station`."""
    radius = (station**2 + drop**2) / (2.0 * drop)
    return distance**2 / (radius + math.sqrt(radius**2 - distance**2))


def line_contact_of_design(bearing, material, load):
    """(12): amplitude [mm], and width 2b of the contact on the inner race over the length."""
    length, diameter = bearing["roller_length_mm"], bearing["roller_diameter_mm"]
    modulus = material["youngs_modulus_MPa"] / (1.0 - material["poisson_ratio"] ** 2)
    race = 0.5 * (bearing["pitch_diameter_mm"] - diameter - 0.5 * bearing["radial_clearance_um"] * MICROMETRE)
    radius = 1.0 / (2.0 / diameter + 1.0 / race)
    half_width = math.sqrt(8.0 * load * radius / (math.pi * modulus * length))
    return 2.0 * load / (math.pi * modulus * length), 2.0 * half_width / length


def roller_drop(bearing, material, place):
    """(9) to (14): drop [mm] of one roller at `place` [mm] from its middle."""
    profile = bearing.get("profile", {"kind": "straight"})
    kind = profile["kind"]
    length, diameter = bearing["roller_length_mm"], bearing["roller_diameter_mm"]
    half, distance = 0.5 * length, abs(place)
    station, drop = 0.975 * half, profile.get("drop_um", 0.0) * MICROMETRE
    share = distance / half
    if kind == "straight":
        return 0.0
    if kind == "iso16281":
        if length <= 2.5 * diameter:
            return -0.00035 * diameter * math.log(1.0 - share**2)
        beyond = distance - (half - 1.25 * diameter)
        return -0.0005 * diameter * math.log(1.0 - (beyond / (1.25 * diameter)) ** 2) if beyond > 0.0 else 0.0
    if kind == "circular":
        return circle(distance, station, drop)
    if kind == "straight-circular":
        start = 0.5 * profile["straight_length_mm"]
        return circle(distance - start, station - start, drop) if distance > start else 0.0
    if kind == "chamfer":
        start = half - profile["chamfer_length_mm"]
        return drop * (distance - start) / (station - start) if distance > start else 0.0
    if kind == "table":
        points = list(zip(profile["x_mm"], profile["drops_um"]))
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            if x0 <= place <= x1:
                return MICROMETRE * (y0 * (x1 - place) + y1 * (place - x0)) / (x1 - x0)
        return MICROMETRE * points[0 if place < points[0][0] else -1][1]
    amplitude, width = line_contact_of_design(bearing, material, profile["design_load_N"])
    if kind == "johns-gohar":
        return -amplitude * math.log(1.0 - (1.0 - 0.3033 * width) * share**2)
    if kind == "lundberg":
        end = 0.5 + math.log(2.0) + math.log(1.0 / width)
        return amplitude * min(end, -math.log(1.0 - share**2))
    if kind == "fujiwara-kawase":
        amplitude *= profile["k1"]
        crowned = profile["k2"] * half
        beyond = distance - (half - crowned)
        depth = 1.0 - math.exp(-profile["end_drop_um"] * MICROMETRE / amplitude)
        return -amplitude * math.log(1.0 - depth * (beyond / crowned) ** 2) if beyond > 0.0 else 0.0
    raise ValueError(f"profile {kind}: not known here")


# Balance of the inner ring


def root_along(slope, first, slope_at_zero):
    """Step at which the rising `slope` is zero, from below at 0: false position (Illinois) after a bracket."""
    low, below, step = 0.0, slope_at_zero, first
    while True:
        above = slope(step)
        if above >= 0.0:
            break
        low, below, step = step, above, 2.0 * step
    high = step
    for _ in range(100):
        if abs(above) < 1e-3 * abs(slope_at_zero):
            return high
        if abs(below) < 1e-3 * abs(slope_at_zero):
            return low
        step = (low * above - high * below) / (above - below)
        now = slope(step)
        if now >= 0.0:
            high, above, below = step, now, 0.5 * below if now > 0.3 * above else below
        else:
            low, below, above = step, now, 0.5 * above if now < 0.3 * below else above
        if high - low < 1e-15 * high:
            break
    return 0.5 * (low + high)


def dot(a, b):
    return math.fsum(x * y for x, y in zip(a, b))


def balance(pull, load, start_step):
    """Where `pull(place)`, the force of all elements against the ring, is `load`: the least energy, by BFGS.

    Only forces are evaluated. The inverse of the stiffness is built up from them; each line search ends where the force
    along the line is a thousandth.
    """
    size = len(load)
    place = [0.0] * size
    identity = [[float(i == k) for k in range(size)] for i in range(size)]
    inverse, fresh = identity, True
    gradient = [p - f for p, f in zip(pull(place), load)]
    best, rest = place, math.inf
    idle = 0
    for _ in range(400):
        size_now = max(map(abs, gradient))
        idle = 0 if size_now < 0.5 * rest else idle + 1
        if size_now < rest:
            best, rest = place, size_now
        if rest <= 1e-15 * max(map(abs, load)) or (idle > 6 and rest < 1e-12 * max(map(abs, load))):
            break
        way = [-dot(row, gradient) for row in inverse]
        down = dot(way, gradient)
        if not down < 0.0:
            if fresh:
                break
            inverse, fresh = identity, True
            continue
        first = start_step / max(map(abs, way)) if fresh else 1.0
        evaluated = {}

        def slope(step):
            at = [x + step * w for x, w in zip(place, way)]
            evaluated[step] = at, [p - f for p, f in zip(pull(at), load)]
            return dot(way, evaluated[step][1])

        step = root_along(slope, first, down)
        if step not in evaluated:
            slope(step)
        to, after = evaluated[step]
        moved = [a - b for a, b in zip(to, place)]
        change = [a - b for a, b in zip(after, gradient)]
        place, gradient = to, after
        along = dot(moved, change)
        if along <= 0.0:
            inverse, fresh = identity, True
            continue
        if fresh:
            scale = along / dot(change, change)
            inverse = [[scale * x for x in row] for row in identity]
        fresh = False
        felt = [dot(row, change) for row in inverse]
        more = (along + dot(change, felt)) / along**2
        inverse = [
            [inverse[i][k] + more * moved[i] * moved[k] - (felt[i] * moved[k] + moved[i] * felt[k]) / along for k in range(size)]
            for i in range(size)
        ]
    if rest > 1e-11 * max(map(abs, load)):
        raise ArithmeticError(f"no balance: {rest:.3g} N left")
    return best


def element_angles(bearing, count):
    first = math.radians(bearing.get("first_element_angle_deg", 0.0))
    return [first + 2.0 * math.pi * j / count for j in range(count)]


def place_of_ring(row_forces, load, lever, axes, start_step):
    """Place (u, v, w, R tan(psi), R tan(psi')) [mm] of the ring, and the moments on it [N mm]. `axes`: which of the five can move."""
    outer = [
        load["radial_N"],
        0.0,
        load.get("axial_N", 0.0),
        1e3 * load.get("moment_N_m", 0.0) / lever,
        1e3 * load.get("moment_across_N_m", 0.0) / lever,
    ]
    held = "tilt_mrad" in load
    free = [i for i in axes if i < 3 or not held]
    whole = [0.0] * 5
    if held:
        whole[3] = lever * math.tan(1e-3 * load["tilt_mrad"])

    def put(values):
        all_five = list(whole)
        for i, value in zip(free, values):
            all_five[i] = value
        return all_five

    def pull(values):
        forces = row_forces(put(values))
        return [forces[i] for i in free]

    place = put(balance(pull, [outer[i] for i in free], start_step))
    borne = row_forces(place)
    return place, lever * borne[3], lever * borne[4]


def balance_of_balls(bearing, load, constant):
    """(15) to (17)."""
    count, diameter = bearing["balls"], bearing["ball_diameter_mm"]
    nominal = math.radians(bearing["contact_angle_deg"])
    distance = diameter * (bearing["inner_osculation"] + bearing["outer_osculation"] - 1.0)
    lever = 0.5 * bearing["pitch_diameter_mm"] + (bearing["inner_osculation"] - 0.5) * diameter * math.cos(nominal)
    across = distance * math.cos(nominal) - 0.5 * bearing["radial_clearance_um"] * MICROMETRE
    along = distance * math.sin(nominal)
    angles = element_angles(bearing, count)
    directions = [(math.cos(a), math.sin(a)) for a in angles]

    def centres(place):
        for c, s in directions:
            yield across + place[0] * c + place[1] * s, along + place[2] + place[3] * c + place[4] * s

    def forces(place):
        pulls = []
        for (c, s), (x, y) in zip(directions, centres(place)):
            far = math.sqrt(x * x + y * y)
            if far > distance:
                load_over_length = constant * (far - distance) ** 1.5 / far
                radial, axial = load_over_length * x, load_over_length * y
                pulls.append((radial * c, radial * s, axial, axial * c, axial * s))
        return [math.fsum(column) for column in zip(*pulls)] if pulls else [0.0] * 5

    place, moment, moment_across = place_of_ring(forces, load, lever, range(5), 0.01)
    ends = list(centres(place))
    approaches = [math.hypot(x, y) - distance for x, y in ends]
    return {
        "groove_distance_mm": distance,
        "tilt_radius_mm": lever,
        "free_angle_deg": math.degrees(math.acos(min(1.0, across / distance))),
        "ring": ring(place, lever, moment, moment_across),
        "element_angles_deg": [math.degrees(a) for a in angles],
        "approaches_um": [a / MICROMETRE for a in approaches],
        "contact_loads_N": [constant * max(0.0, a) ** 1.5 for a in approaches],
        "contact_angles_deg": [math.degrees(math.atan2(y, x)) for x, y in ends],
    }


def ring(place, lever, moment, moment_across):
    return {
        "radial_um": place[0] / MICROMETRE,
        "lateral_um": place[1] / MICROMETRE,
        "axial_um": place[2] / MICROMETRE,
        "tilt_mrad": 1e3 * math.atan(place[3] / lever),
        "lateral_tilt_mrad": 1e3 * math.atan(place[4] / lever),
        "moment_N_m": 1e-3 * moment,
        "moment_across_N_m": 1e-3 * moment_across,
    }


def balance_of_rollers(bearing, load, constant, material):
    """(8), (18), (19)."""
    count, n, length = bearing["rollers"], bearing["laminae"], bearing["roller_length_mm"]
    places = [((k - 0.5) / n - 0.5) * length for k in range(1, n + 1)]
    drops = [2.0 * roller_drop(bearing, material, x) for x in places]
    lever = 0.5 * length
    shares = [x / lever for x in places]
    angles = element_angles(bearing, count)
    directions = [(math.cos(a), math.sin(a)) for a in angles]
    play = 0.5 * bearing["radial_clearance_um"] * MICROMETRE
    least, scale, power = min(drops), constant / n, 10.0 / 9.0
    laminae = list(zip(shares, drops))

    def lines(place):
        for c, s in directions:
            yield place[0] * c + place[1] * s - play, place[3] * c + place[4] * s

    def lamina_loads(middle, tip):
        return [scale * a**power if (a := middle - tip * x - d) > 0.0 else 0.0 for x, d in laminae]

    def forces(place):
        pulls = []
        for (c, s), (middle, tip) in zip(directions, lines(place)):
            if middle + abs(tip) <= least:
                continue
            q = lamina_loads(middle, tip)
            total = math.fsum(q)
            turning = -math.fsum(map(float.__mul__, q, shares))
            pulls.append((total * c, total * s, 0.0, turning * c, turning * s))
        return [math.fsum(column) for column in zip(*pulls)] if pulls else [0.0] * 5

    place, moment, moment_across = place_of_ring(forces, load, lever, (0, 1, 3, 4), 0.01)
    ends = list(lines(place))
    q = [lamina_loads(middle, tip) for middle, tip in ends]
    return {
        "lamina_places_mm": places,
        "drops_um": [d / MICROMETRE for d in drops],
        "ring": ring(place, lever, moment, moment_across),
        "element_angles_deg": [math.degrees(a) for a in angles],
        "approaches_um": [middle / MICROMETRE for middle, _ in ends],
        "element_tilts_mrad": [1e3 * math.atan(tip / lever) for _, tip in ends],
        "lamina_loads_N": q,
        "contact_loads_N": [math.fsum(one) for one in q],
    }


# Ratings and life


def power_mean(loads, exponent):
    return (math.fsum(q**exponent for q in loads) / len(loads)) ** (1.0 / exponent)


def exponents(turning, moving, standing):
    """Of the inner and the outer race."""
    return (moving, standing) if turning == "inner" else (standing, moving)


def life(damages, slope):
    """Lives [Mrev] of inner race, outer race and bearing."""
    inner, outer = damages
    return {
        "inner_Mrev": inner ** (-1.0 / slope),
        "outer_Mrev": outer ** (-1.0 / slope),
        "bearing_Mrev": (inner + outer) ** (-1.0 / slope),
    }


def worked_balls(case):
    bearing, material = case["bearing"], case["material"]
    count, diameter = bearing["balls"], bearing["ball_diameter_mm"]
    cosine = math.cos(math.radians(bearing["contact_angle_deg"]))
    gamma = diameter * cosine / bearing["pitch_diameter_mm"]  # (1)
    inner, outer = (race_contact(is_inner, bearing, gamma) for is_inner in (True, False))
    constant = ball_constant(inner, outer, material)
    values = {"gamma": gamma, "inner_contact": inner, "outer_contact": outer, "c_P_N_per_mm_3_2": constant}
    values.update(balance_of_balls(bearing, case["load"], constant))

    def race_ratio(f_i, f_e):  # (20)
        return ((1.0 - gamma) / (1.0 + gamma)) ** 1.72 * (f_i / f_e * (2.0 * f_e - 1.0) / (2.0 * f_i - 1.0)) ** 0.41

    grooves = bearing["inner_osculation"], bearing["outer_osculation"]
    f_i, f_e = (0.52, 0.52) if grooves[0] <= 0.52 and grooves[1] <= 0.53 else grooves
    f_c = (
        0.41 * 98.0665 * 0.95 * (1.0 + (1.04 * race_ratio(f_i, f_e)) ** (10.0 / 3.0)) ** -0.3
        * gamma**0.3 * (1.0 - gamma) ** 1.39 / (1.0 + gamma) ** (1.0 / 3.0) * (2.0 * f_i / (2.0 * f_i - 1.0)) ** 0.41
    )  # (21)
    size = diameter**1.8 if diameter <= 25.4 else 3.647 * diameter**1.4
    capacity = bearing.get("dynamic_capacity_N", 1.3 * f_c * cosine**0.7 * count ** (2.0 / 3.0) * size)  # (22)
    ratio = (1.044 * race_ratio(*grooves)) ** (10.0 / 3.0)
    q_ci = capacity / (0.407 * count * cosine) * (1.0 + ratio) ** 0.3  # (23)
    q_ce = capacity / (0.389 * count * cosine) * (1.0 + 1.0 / ratio) ** 0.3
    p_i, p_e = exponents(case["turning_race"], 3.0, 10.0 / 3.0)
    q_ei, q_ee = (power_mean(values["contact_loads_N"], p) for p in (p_i, p_e))  # (24)
    values["ratings"] = {"f_c": f_c, "C_r_N": capacity, "inner_contact_N": q_ci, "outer_contact_N": q_ce}
    values["equivalent_loads_N"] = {"inner": [q_ei], "outer": [q_ee]}
    values["reference_life"] = life([(q_ei / q_ci) ** (10.0 / 3.0), (q_ee / q_ce) ** (10.0 / 3.0)], 10.0 / 9.0)  # (25)
    return values


def worked_rollers(case):
    bearing, material = case["bearing"], case["material"]
    count, n = bearing["rollers"], bearing["laminae"]
    diameter, length = bearing["roller_diameter_mm"], bearing["roller_length_mm"]
    gamma = diameter / bearing["pitch_diameter_mm"]  # (1)
    constant = 35948.0 * length ** (8.0 / 9.0)  # (7)
    values = {"gamma": gamma, "c_L_N_per_mm_10_9": constant}
    values.update(balance_of_rollers(bearing, case["load"], constant, material))
    riser = [
        1.0 if 2 * k == n + 1 else 1.0 - 0.01 / math.log(1.985 * abs((2 * k - n - 1) / (2 * n - 2))) for k in range(1, n + 1)
    ]  # (26)
    ratio = ((1.0 - gamma) / (1.0 + gamma)) ** (143.0 / 108.0)
    f_c = (
        0.377 * 551.13373 * 0.83 * gamma ** (2.0 / 9.0) * (1.0 - gamma) ** (29.0 / 27.0) / (1.0 + gamma) ** 0.25
        * (1.0 + (1.04 * ratio) ** 4.5) ** (-2.0 / 9.0)
    )  # (27)
    capacity = 1.1 * f_c * length ** (7.0 / 9.0) * count**0.75 * diameter ** (29.0 / 27.0)  # (28)
    q_ci = capacity / (0.83 * 0.378 * count) * (1.0 + (1.038 * ratio) ** 4.5) ** (2.0 / 9.0)  # (29)
    q_ce = capacity / (0.83 * 0.364 * count) * (1.0 + (1.038 * ratio) ** -4.5) ** (2.0 / 9.0)
    lamina = [q * n ** (-7.0 / 9.0) for q in (q_ci, q_ce)]  # (30)
    by_lamina = [[f * q for q in loads] for f, loads in zip(riser, zip(*values["lamina_loads_N"]))]
    equivalent = [
        [power_mean(loads, p) for loads in by_lamina] for p in exponents(case["turning_race"], 4.0, 4.5)
    ]  # (31)
    damages = [math.fsum((q / q_c) ** 4.5 for q in loads) for loads, q_c in zip(equivalent, lamina)]
    values["stress_riser"] = riser
    values["ratings"] = {"f_c": f_c, "C_r_N": capacity, "inner_contact_N": q_ci, "outer_contact_N": q_ce}
    values["lamina_capacities_N"] = {"inner": lamina[0], "outer": lamina[1]}
    values["equivalent_loads_N"] = {"inner": equivalent[0], "outer": equivalent[1]}
    values["reference_life"] = life(damages, 9.0 / 8.0)  # (32)
    return values


def worked(case):
    """All values of one case of results.json, by its entries bearing, material, load and turning_race."""
    return worked_balls(case) if "balls" in case["bearing"] else worked_rollers(case)


# Comparison


def numbers(value):
    if isinstance(value, dict):
        value = value.values()
    if isinstance(value, (int, float)):
        return [value]
    return [number for part in value for number in numbers(part)]


def pairs(one, other, path=""):
    """(path, number of the one, of the other, the largest of those that it is measured by)."""
    if isinstance(one, (int, float)):
        return [(path, one, other, 0.0)]
    if isinstance(one, dict):
        if set(one) != set(other):
            raise KeyError(f"{path}: {sorted(set(one) ^ set(other))} only in one of both")
        return [row for key in one for row in pairs(one[key], other[key], f"{path}.{key}" if path else key)]
    if len(one) != len(other):
        raise ValueError(f"{path}: {len(one)} and {len(other)} numbers")
    largest = max(map(abs, numbers(one)), default=0.0)
    rows = [row for i, (a, b) in enumerate(zip(one, other)) for row in pairs(a, b, f"{path}[{i}]")]
    return [(name, a, b, largest) for name, a, b, _ in rows]


def floors(case, values):
    """What a number is measured by where it is smaller, README "How to compare": displacements, tilts, moments, by their path."""
    ring_values = values["ring"]
    shift = max(abs(ring_values[key]) for key in ("radial_um", "lateral_um", "axial_um"))
    pitch = case["bearing"]["pitch_diameter_mm"]
    tilt = shift / pitch  # [um/mm], mrad
    force = max(case["load"]["radial_N"], case["load"].get("axial_N", 0.0))
    return {"_um": shift, "_mrad": tilt, "_N_m": 1e-3 * force * pitch}


def deviations(case, found, reference):
    """{path: deviation} of all numbers of `found` from those of `reference`, entries of lists under the list's name."""
    by_unit = floors(case, reference)
    result = {}
    for path, one, other, largest in pairs(found, reference):
        measure = max(abs(other), SMALL * largest)
        if path.startswith("ring."):
            measure = max([measure, *(floor for unit, floor in by_unit.items() if path.endswith(unit))])
        if path.startswith("element_tilts_mrad"):
            measure = max(measure, by_unit["_mrad"])
        if path.startswith("contact_angles_deg"):
            measure = max(measure, SMALL_ANGLE)
        name = path.split("[")[0]
        difference = abs(one - other)
        result[name] = max(result.get(name, 0.0), difference / measure if difference else 0.0)
    return result




def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", nargs="?", type=pathlib.Path, default=HERE / "results.json")
    parser.add_argument("--values", metavar="CASE", help="print what is computed of one case")
    options = parser.parse_args()
    cases = json.loads(options.file.read_text(encoding="utf-8"))["cases"]
    if options.values:
        json.dump(worked(cases[options.values]), sys.stdout, indent=1)
        return 0
    wrong = 0
    for name, case in cases.items():
        found = deviations(case, case["values"], worked(case))
        worst = max(found, key=found.get)
        print(f"{name}  {len(numbers(case['values'])):5d} values, largest deviation {found[worst]:.1e} ({worst})")
        for quantity, deviation in found.items():
            if not deviation <= ALLOWED:
                wrong += 1
                print(f"     {quantity}: {deviation:.3g}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
