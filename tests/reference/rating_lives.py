"""Ratings and lives of one bearing by ISO 76, ISO 281 and ISO/TS 16281, in plain Python: a second program.

It shares no line with Orbearing. Loads of rolling elements come from the balances of cases/iso16281_worked_set/recompute.py, or from
`planet_contacts` below for a planet bearing whose rollers are subject to inertial forces. N, mm, MPa inside; lives in millions of
revolutions.

    C, f_c, contact capacities        [ISO281] [ISO16281], recompute.py
    C0     rollers 44 (1 - gamma) i Z l D cos(alpha), balls f_0 i Z D^2 cos(alpha) with the printed table of f_0 [ISO76]
    C_u    C0/8.2 (rollers), C0/22 (balls); above d_m = 100 mm times (100/d_m)^0.3 and (100/d_m)^0.5
    P, P0  X, Y of the printed table for deep-groove bearings; P0 = max(F_r, 0.6 F_r + 0.5 F_a); rollers F_r
    nu_1   45000 n^-0.83 d_m^-0.5 below 1000 rpm, 4500 (n d_m)^-0.5 above
    kappa  nu/nu_1; 4 wherever it is larger
    e_C    annex A of ISO 281
    a_ISO  equations of ISO 281, 0.1 to 50
    L10m   a_1 a_ISO(e_C C_u/P) L10
    L10mr  rollers: each lamina by its own a_ISO(e_C C_u/P_ks); balls: a_ISO at P = C L10r^(-1/3)
    P_ks   0.323 Z n cos(alpha) {[q_i^4.5 + (1.038 q_ci/q_ce q_e)^4.5]/[1 + (1.038 q_ci/q_ce)^4.5]}^(2/9), q equivalent loads of lamina k

The factor 0.323 and the form of P_ks are those of formula (31) of ISO 16281:2025 as a public program cites it.
"""

import importlib.util
import math
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def _second_program():
    path = ROOT / "cases" / "iso16281_worked_set" / "recompute.py"
    spec = importlib.util.spec_from_file_location("recompute", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


BALANCE = _second_program()

# f_0 of [ISO76] for deep-groove and angular contact ball bearings over gamma = 0, 0.01, ...
F_0 = (14.7, 14.9, 15.1, 15.3, 15.5, 15.7, 15.9, 16.1, 16.3, 16.5, 16.4, 16.1, 15.9, 15.6, 15.4, 15.2, 14.9, 14.7, 14.4, 14.2, 14.0,
       13.7, 13.5, 13.2, 13.0, 12.8, 12.5, 12.3, 12.1, 11.8, 11.6)

# F_a/(Z D^2) [MPa], e, Y of [ISO281] for deep grooves; X = 0.56.
X_Y = ((0.172, 0.19, 2.30), (0.345, 0.22, 1.99), (0.689, 0.26, 1.71), (1.03, 0.28, 1.55), (1.38, 0.30, 1.45), (2.07, 0.34, 1.31),
       (3.45, 0.38, 1.15), (5.17, 0.42, 1.04), (6.89, 0.44, 1.00))

# b and c of annex A of [ISO281]: e_C = min(1, b kappa^0.68 d_m^0.55) (1 - c d_m^(-1/3)).
CLEANLINESS = {
    "circulating-oil": {"-/13/10": (0.0864, 0.5663), "-/15/12": (0.0432, 0.9987), "-/17/14": (0.0288, 1.6329), "-/19/16": (0.0216, 2.3362)},
    "oil-bath": {"-/13/10": (0.0864, 0.6796), "-/15/12": (0.0288, 1.141), "-/17/14": (0.0133, 1.67), "-/19/16": (0.00864, 2.5164),
                 "-/21/18": (0.00411, 3.8974)},
}


def has_balls(bearing):
    return "balls" in bearing


def _interpolated(table, x):
    for (x0, *low), (x1, *high) in zip(table, table[1:]):
        if x <= x1:
            t = (max(x, x0) - x0) / (x1 - x0)
            return [a + t * (b - a) for a, b in zip(low, high)]
    return list(table[-1][1:])


def static_capacity(bearing):
    """C0 [N]."""
    d_m = bearing["pitch_diameter_mm"]
    if has_balls(bearing):
        cosine, size = math.cos(math.radians(bearing.get("contact_angle_deg", 0.0))), bearing["ball_diameter_mm"]
        (f_0,) = _interpolated([(0.01 * i, f) for i, f in enumerate(F_0)], size * cosine / d_m)
        return f_0 * bearing["balls"] * size**2 * cosine
    size = bearing["roller_diameter_mm"]
    return 44.0 * (1.0 - size / d_m) * bearing["rollers"] * bearing["roller_length_mm"] * size


def fatigue_load_limit(bearing, static):
    """C_u [N]."""
    small = min(1.0, 100.0 / bearing["pitch_diameter_mm"])
    return static / 22.0 * small**0.5 if has_balls(bearing) else static / 8.2 * small**0.3


def equivalent_load(bearing, radial, axial=0.0):
    """P [N]."""
    if not has_balls(bearing) or axial == 0.0:
        return radial
    limit, y = _interpolated(X_Y, axial / (bearing["balls"] * bearing["ball_diameter_mm"] ** 2))
    return 0.56 * radial + y * axial if axial > limit * radial else radial


def static_equivalent_load(bearing, radial, axial=0.0):
    """P0 [N]."""
    return max(radial, 0.6 * radial + 0.5 * axial) if has_balls(bearing) else radial


def required_viscosity(rpm, d_m):
    """nu_1 [mm2/s]."""
    return 45000.0 * rpm**-0.83 * d_m**-0.5 if rpm < 1000.0 else 4500.0 * (rpm * d_m) ** -0.5


def contamination_factor(kappa, d_m, cleanliness, lubrication="circulating-oil"):
    b, c = CLEANLINESS[lubrication][cleanliness]
    return min(1.0, b * min(kappa, 4.0) ** 0.68 * d_m**0.55) * (1.0 - c / d_m ** (1.0 / 3.0))


def a_iso(balls, kappa, ratio):
    """`ratio`: e_C C_u/P."""
    kappa = min(kappa, 4.0)
    if balls:
        film = 2.2649 / kappa**0.054381 if kappa < 0.4 else 1.9987 / kappa ** (0.19087 if kappa < 1.0 else 0.071739)
        stress = (2.5671 - film) ** 0.83 * ratio ** (1.0 / 3.0)
        power = -9.3
    else:
        film = 1.3993 / kappa**0.054381 if kappa < 0.4 else 1.2348 / kappa ** (0.19087 if kappa < 1.0 else 0.071739)
        stress = (1.5859 - film) * ratio**0.4
        power = -9.185
    return 50.0 if stress >= 1.0 else min(50.0, 0.1 * (1.0 - stress) ** power)


def lines_of_lundberg_palmgren(bearing, reduction):
    """Capacities [N] of a roller on both races, Eq. (15) of bearing/README.md."""
    gamma = bearing["roller_diameter_mm"] / bearing["pitch_diameter_mm"]
    common = (
        552.0 * reduction * gamma ** (2.0 / 9.0) * bearing["roller_diameter_mm"] ** (29.0 / 27.0)
        * bearing["roller_length_mm"] ** (7.0 / 9.0) * bearing["rollers"] ** -0.25
    )
    return common * (1.0 - gamma) ** (29.0 / 27.0) / (1.0 + gamma) ** 0.25, common * (1.0 + gamma) ** (29.0 / 27.0) / (1.0 - gamma) ** 0.25


def line_pressure(load, length, diameter, d_m, inner, modulus, poisson):
    """Largest pressure [MPa] of a line contact that bears `load` over `length`, by the radii of both bodies."""
    race = 0.5 * (d_m - diameter) if inner else -0.5 * (d_m + diameter)
    curvature = 2.0 / diameter + 1.0 / race
    return math.sqrt(load / length * curvature * modulus / (2.0 * math.pi * (1.0 - poisson**2)))


def point_pressure(load, contact, modulus, poisson):
    """Of an ellipse of recompute.py's form: area pi a b with a = chi b."""
    chi, second, total = contact["axis_ratio"], contact["elliptic_E"], contact["curvature_sum_per_mm"]
    # Two bodies of one material: b^3 = 6 E(chi) Q (1 - nu^2)/(pi chi Sigma rho E).
    minor = (6.0 * second * load * (1.0 - poisson**2) / (math.pi * chi * total * modulus)) ** (1.0 / 3.0)
    return 1.5 * load / (math.pi * chi * minor**2)


def power_mean(loads, exponent):
    return BALANCE.power_mean(loads, exponent)


def reference_loads(bearing, inner, outer, turning, with_riser):
    """Equivalent loads of each lamina on both races, from loads [lamina][place]."""
    n = len(inner)
    riser = [1.0 if n == 1 or 2 * k == n + 1 or not with_riser else 1.0 - 0.01 / math.log(1.985 * abs(2 * k - n - 1) / (2 * n - 2))
             for k in range(1, n + 1)]
    p_i, p_e = BALANCE.exponents(turning, 4.0, 4.5)
    return ([f * power_mean(loads, p_i) for f, loads in zip(riser, inner)], [f * power_mean(loads, p_e) for f, loads in zip(riser, outer)])


def roller_capacities(bearing):
    """C and the capacities of a roller on both races [N], from recompute.py's equations (27) to (29)."""
    gamma = bearing["roller_diameter_mm"] / bearing["pitch_diameter_mm"]
    ratio = ((1.0 - gamma) / (1.0 + gamma)) ** (143.0 / 108.0)
    f_c = (0.377 * 551.13373 * 0.83 * gamma ** (2.0 / 9.0) * (1.0 - gamma) ** (29.0 / 27.0) / (1.0 + gamma) ** 0.25
           * (1.0 + (1.04 * ratio) ** 4.5) ** (-2.0 / 9.0))
    z = bearing["rollers"]
    capacity = bearing.get("dynamic_capacity_N", 1.1 * f_c * bearing["roller_length_mm"] ** (7.0 / 9.0) * z**0.75
                           * bearing["roller_diameter_mm"] ** (29.0 / 27.0))
    inner = capacity / (0.83 * 0.378 * z) * (1.0 + (1.038 * ratio) ** 4.5) ** (2.0 / 9.0)
    outer = capacity / (0.83 * 0.364 * z) * (1.0 + (1.038 * ratio) ** -4.5) ** (2.0 / 9.0)
    return capacity, inner, outer


def roller_lives(bearing, inner, outer, turning, oil=None, reduction=0.83, reliability=1.0, radial=None):
    """All of a roller bearing from its lamina loads [lamina][place] on both races; `oil`: (kappa, e_C)."""
    n, z = len(inner), bearing["rollers"]
    capacity, q_ci, q_ce = roller_capacities(bearing)
    static = static_capacity(bearing)
    limit = bearing.get("fatigue_load_limit_N", fatigue_load_limit(bearing, static))
    values = {"C_N": capacity, "C0_N": static, "Cu_N": limit, "P_N": radial, "P0_N": radial, "C_over_P": capacity / radial, "S0": static / radial}
    values["L10_Mrev"] = (capacity / radial) ** (10.0 / 3.0)
    felt_i, felt_e = reference_loads(bearing, inner, outer, turning, True)
    lamina_i, lamina_e = q_ci * n ** (-7.0 / 9.0), q_ce * n ** (-7.0 / 9.0)
    damages = [(i / lamina_i) ** 4.5 + (e / lamina_e) ** 4.5 for i, e in zip(felt_i, felt_e)]
    values["L10r_Mrev"] = sum(damages) ** (-8.0 / 9.0)
    own_i, own_e = (q * n ** (-7.0 / 9.0) for q in lines_of_lundberg_palmgren(bearing, reduction))
    plain_i, plain_e = reference_loads(bearing, inner, outer, turning, False)
    values["life_Mrev"] = sum((i / own_i) ** 4.5 + (e / own_e) ** 4.5 for i, e in zip(plain_i, plain_e)) ** (-8.0 / 9.0)
    if oil is None:
        return values
    kappa, e_c = oil
    values["kappa"], values["e_C"] = kappa, e_c
    values["a_ISO"] = a_iso(False, kappa, e_c * limit / radial)
    values["L10m_Mrev"] = reliability * values["a_ISO"] * values["L10_Mrev"]
    ratio = 1.038 * q_ci / q_ce
    modified = 0.0
    for i, e, damage in zip(felt_i, felt_e, damages):
        if damage == 0.0:
            continue
        load = 0.323 * z * n * ((i**4.5 + (ratio * e) ** 4.5) / (1.0 + ratio**4.5)) ** (2.0 / 9.0)
        modified += a_iso(False, kappa, e_c * limit / load) ** (-9.0 / 8.0) * damage
    values["L10mr_Mrev"] = reliability * modified ** (-8.0 / 9.0)
    values["a_ISO_r"] = values["L10mr_Mrev"] / (reliability * values["L10r_Mrev"])
    return values


def ball_lives(bearing, worked, load, oil=None, reliability=1.0):
    """All of a ball bearing from what recompute.py worked out."""
    radial, axial = load["radial_N"], load.get("axial_N", 0.0)
    capacity = worked["ratings"]["C_r_N"]
    static = static_capacity(bearing)
    limit = bearing.get("fatigue_load_limit_N", fatigue_load_limit(bearing, static))
    equivalent, at_rest = equivalent_load(bearing, radial, axial), static_equivalent_load(bearing, radial, axial)
    values = {"C_N": capacity, "C0_N": static, "Cu_N": limit, "P_N": equivalent, "P0_N": at_rest, "C_over_P": capacity / equivalent,
              "S0": static / at_rest, "L10_Mrev": (capacity / equivalent) ** 3, "L10r_Mrev": worked["reference_life"]["bearing_Mrev"]}
    if oil is None:
        return values
    kappa, e_c = oil
    values["kappa"], values["e_C"] = kappa, e_c
    values["a_ISO"] = a_iso(True, kappa, e_c * limit / equivalent)
    values["L10m_Mrev"] = reliability * values["a_ISO"] * values["L10_Mrev"]
    reference = capacity * values["L10r_Mrev"] ** (-1.0 / 3.0)
    values["a_ISO_r"] = a_iso(True, kappa, e_c * limit / reference)
    values["L10mr_Mrev"] = reliability * values["a_ISO_r"] * values["L10r_Mrev"]
    return values


def series_constant(law, length):
    """c_L [N/mm^(10/9)] of both contacts of a roller in series: Palmgren's two, or that of [ISO16281]."""
    return 35948.0 * length ** (8.0 / 9.0) if law == "iso16281" else contact_constant(length) / 2.0 ** (10.0 / 9.0)


def contact_constant(length):
    """Of one contact [Palmgren1959]."""
    return 8.06e4 * length ** (8.0 / 9.0)


def bearing_lives(case, oil=None, law="palmgren", **options):
    """Of a single bearing: `case` in the form of the worked set (bearing, material, load, turning_race)."""
    bearing, modulus, poisson = case["bearing"], case["material"]["youngs_modulus_MPa"], case["material"]["poisson_ratio"]
    if has_balls(bearing):
        worked = BALANCE.worked(case)
        values = ball_lives(bearing, worked, case["load"], oil, **options)
        largest = max(worked["contact_loads_N"])
        values["contact_pressure_max_MPa"] = max(
            point_pressure(largest, worked[race], modulus, poisson) for race in ("inner_contact", "outer_contact"))
        return values
    length = bearing["roller_length_mm"]
    found = BALANCE.balance_of_rollers(bearing, case["load"], series_constant(law, length), case["material"])
    loads = [list(of_lamina) for of_lamina in zip(*found["lamina_loads_N"])]
    values = roller_lives(bearing, loads, loads, case["turning_race"], oil, radial=case["load"]["radial_N"], **options)
    values["contact_pressure_max_MPa"] = line_pressure(
        max(max(row) for row in loads), length / len(loads), bearing["roller_diameter_mm"], bearing["pitch_diameter_mm"], True, modulus,
        poisson)
    return values


def planet_contacts(bearing, constant, force, speeds, mass, orbit, angles=16):
    """Loads [place] of whole contacts on both races of a planet bearing with level straight rollers, dry, Eqs. (12) to (14) of
    bearing/README.md: `constant` [N/mm^(10/9)] of one contact, `force` (outward, tangential) [N] on the planet's bore, with cage
    and the tangential halves of the rollers; `speeds` (carrier, planet relative to it) [rad/s], `mass` [kg] of a roller, `orbit` [mm] radius of the pin's orbit. All over one
    pitch of cage angles."""
    z, d_m, gap = bearing["rollers"], bearing["pitch_diameter_mm"], 0.5 * bearing["radial_clearance_um"] * 1e-3
    gamma = bearing["roller_diameter_mm"] / d_m
    carrier, planet = speeds
    cage = 0.5 * planet * (1.0 + gamma)
    whole = list(force)
    inner, outer = [], []
    for step in range(angles):
        places = [2.0 * math.pi * (j + step / angles) / z for j in range(z)]
        inertia = [mass * 1e-3 * (0.5 * d_m * (cage**2 + 2.0 * carrier * cage + carrier**2) + carrier**2 * orbit * math.cos(a)) for a in places]

        def contact(approach, pull):
            """(Q_i, Q_o) of a roller squeezed by `approach`, by bisection on Q_i."""
            least = max(0.0, -pull)

            def excess(q_i):
                return (q_i / constant) ** 0.9 + (max(0.0, q_i + pull) / constant) ** 0.9 - approach

            if excess(least) >= 0.0:  # it rests on one race
                return max(0.0, -pull), max(0.0, pull)
            low, high = least, least + constant * approach ** (10.0 / 9.0)
            for _ in range(60):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if excess(middle) < 0.0 else (low, middle)
            return 0.5 * (low + high), 0.5 * (low + high) + pull

        def unbalanced(x, y):
            total = list(whole)
            for a, pull in zip(places, inertia):
                q_o = contact(-x * math.cos(a) - y * math.sin(a) - gap, pull)[1]
                total[0] += q_o * math.cos(a)
                total[1] += q_o * math.sin(a)
            return total

        size = math.hypot(*whole)
        scale = (size / z / constant) ** 0.9 * 5.0 + gap
        x, y = scale * whole[0] / size, scale * whole[1] / size
        for _ in range(60):
            f = unbalanced(x, y)
            if math.hypot(*f) < 1e-9 * size:
                break
            h = 1e-6 * scale
            fx, fy = unbalanced(x + h, y), unbalanced(x, y + h)
            a, b, c, d = (fx[0] - f[0]) / h, (fy[0] - f[0]) / h, (fx[1] - f[1]) / h, (fy[1] - f[1]) / h
            det = a * d - b * c
            dx, dy = (-f[0] * d + f[1] * b) / det, (-f[1] * a + f[0] * c) / det
            share = 1.0
            while math.hypot(*unbalanced(x + share * dx, y + share * dy)) > math.hypot(*f) and share > 1e-3:
                share *= 0.5
            x, y = x + share * dx, y + share * dy
        else:
            raise ArithmeticError("no balance found")
        for a, pull in zip(places, inertia):
            q_i, q_o = contact(-x * math.cos(a) - y * math.sin(a) - gap, pull)
            inner.append(q_i)
            outer.append(q_o)
    return inner, outer
