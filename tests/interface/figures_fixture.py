"""Results for every figure, of which no two keys have the same numbers: what is drawn from the wrong one is seen."""

import types

import numpy as np
import report_dynamic_fixture as dynamic
import report_fixture as fixture

RANDOM = np.random.default_rng(44)
PINS = ("refined", "steady")


def some(count, low=1.0, high=2.0, digits=6):
    return [round(float(x), digits) for x in RANDOM.uniform(low, high, count)]


def rising(count, low, high):
    return sorted(some(count, low, high))


def scattered(row, keep=("input_speed_rpm", "speed_rpm", "input.power_kW")):
    """Each number of a record times one of its own."""
    return {key: value * RANDOM.uniform(0.8, 1.2) if isinstance(value, float) and key not in keep else value for key, value in row.items()}


def change(name, values):
    """Variables of the point files, each times a number of its own; places and times stay."""
    if name in ("time", "angle", "roller_angle", "cage_angle"):
        return values
    return values * (1.0 + 0.01 * (sum(map(ord, name)) % 37)) * (1.0 + 0.02 * np.sin(np.linspace(0.0, 5.0, values.shape[-1]) + len(name)))


def variable(speed, name):
    """As the point file has it."""
    return change(name, dynamic.variables(speed)[name][2])


def moving(fidelity="dynamic"):
    """A sweep in motion with gears and branches, whose grid the sweep refined; one of its points failed."""
    content = dynamic.make_report()
    content["fidelity"] = fidelity
    content["points"] = [scattered({**point, "power_loss_neighbours_W": 0.7 * point["input_speed_rpm"] / 1000, "refined": False,
                                    "resonance_harmonic": 2, "resonance_mode": "P1", "resonance_speed_rpm": 6063.0}) for point in content["points"]]
    content["points"] += [{**scattered(content["points"][5]), "input_speed_rpm": speed, "refined": True} for speed in (5500, 6500)]
    content["points"][-1]["life_h"] = 61234.0
    content["points"][2].update(life_h=None, status="the rollers jam")
    content["peak"] = {"speed_rpm": 6000, "life_h": content["points"][5]["life_h"], "refined_speed_rpm": 6500, "refined_life_h": 61234.0}
    content["polar"] = [{**entry, "inner_load_N": [0.9 * x for x in entry["inner_load_N"]]} for entry in content["polar"]]
    content["dynamic"]["ablation"] = [{**entry, "points": [scattered(p) for p in entry["points"]]} for entry in content["dynamic"]["ablation"]]
    content["gears"] = gears()
    content["branches"] = {"load_drift": 0.002, "runs": [
        {"name": name, "points": [scattered({**p, "steady": 1}) for p in dynamic.make_report()["points"]]} for name in ("up", "down")]}
    return content


def coupled():
    """Two ways, by exchange in windows."""
    content = moving("co-simulated")
    for point in content["points"]:
        point["interface_energy_residual"] = 1e-3 * RANDOM.uniform(1.0, 2.0)
    speeds = [point["input_speed_rpm"] for point in content["points"][:6]]
    content["coupled"] = {"how": "degree 1", "one_way": {"speed_rpm": speeds, "life_h": some(6, 1e4, 5e4)}}
    return content


def gears():
    speeds = [1000.0, 4000.0, 7000.0, 12000.0]
    gear = {"centre_y_mm": -40.0, "sense": 1.0, "axis_deg": 2.0, "module_mm": 2.5, "base_radius_mm": 37.1, "teeth": 31,
            "radius_mm": rising(6, 37.5, 42.0), "half_angle_deg": sorted(some(6, 0.5, 2.5), reverse=True)}
    other = {**gear, "centre_y_mm": 51.0, "sense": -1.0, "teeth": 39, "axis_deg": 1.0, "module_mm": 2.6, "base_radius_mm": 46.3,
             "radius_mm": rising(6, 46.5, 52.0), "half_angle_deg": sorted(some(6, 0.5, 2.2), reverse=True)}
    modes = [(name, kind, frequency, count) for name, kind, frequency, count in
             (("R1", "rotational", 812.5, 1), ("T1", "translational", 934.25, 2), ("P1", "planet", 1287.0, 1))]
    shares = [[some(3, 0.9, 1.1), some(3, 1.2, 1.6)] for _ in speeds]
    return {
        "tooth_pairs": [{"mesh": "sun and planet", "contact_x_mm": 0.31, "contact_y_mm": 0.17, "working_pressure_angle_deg": 22.73,
                         "gears": [{**gear, "name": "sun"}, {**other, "name": "planet"}]}],
        "meshes": [{"name": f"{name} 1", "mean_N_per_m": mean, "curve": [list(pair) for pair in zip(np.linspace(0, 0.95, 20).tolist(), some(20, 2e8, 4e8))],
                    "at_pitch_point": {"hertz_N_per_m": hertz, "pair_N_per_m": 1.7e8, "gears": [
                        {"gear": one, "bending_N_per_m": a, "shear_N_per_m": b, "axial_N_per_m": c, "foundation_N_per_m": d}
                        for one, a, b, c, d in zip(names, *(some(2, 5e8, 5e9) for _ in range(4)))]}}
                   for name, mean, hertz, names in (("sun mesh", 3.1e8, 2.2e9, ("sun", "planet")), ("ring mesh", 3.4e8, 2.9e9, ("planet", "ring")))],
        "mode_shapes": {"places_rad": [0.0, 2.1, 4.2], "centre_distance_mm": 91.0, "sun_radius_mm": 40.0, "ring_radius_mm": 142.0, "planet_radius_mm": 51.0,
                        "modes": [{"name": name, "kind": kind, "frequency_Hz": frequency, "multiplicity": count, "shape": some(18, -1.0, 1.0)}
                                  for name, kind, frequency, count in modes]},
        "campbell": {"speed_rpm": speeds, "mesh_frequency_Hz": [0.31 * s for s in speeds],
                     "modes": [{"name": name, "frequency_Hz": some(4, 0.9 * frequency, 1.1 * frequency)} for name, _, frequency, _ in modes]},
        "meetings": [{"order": 2, "mode": "T1", "speed_rpm": 5310.0, "frequency_Hz": 933.0, "excited": True},
                     {"order": 2, "mode": "T1", "speed_rpm": 5390.0, "frequency_Hz": 947.0, "excited": True},
                     {"order": 1, "mode": "P1", "speed_rpm": 6730.0, "frequency_Hz": 1283.0, "excited": True},
                     {"order": 3, "mode": "R1", "speed_rpm": 2030.0, "frequency_Hz": 811.0, "excited": False}],
        "runs": [{"speed_rpm": speed, "status": "ok", "swept": speed != 4000.0, "load_sharing": {"mean": mean, "largest": largest},
                  "acceleration_m_per_s2": {way: dict(zip(("rms", "max"), some(2, 10.0, 90.0))) for way in "xy"}}
                 for speed, (mean, largest) in zip(speeds, shares)],
        "spectrum": {"speed_rpm": 4000.0, "mesh_frequency_Hz": 1240.0, "mean_N": 1571.0, "status": "ok",
                     "order": [0.5, 1.0, 1.5, 2.0, 3.0], "amplitude_N": some(5, 0.5, 90.0)},
    }


def powers():
    """Slip over speed and power."""
    content = dynamic.make_report()
    content["points"] = [scattered({**fixture.point(speed), "input.power_kW": power, "roller_slip": 0.01 + 1e-6 * speed,
                                    "cage_slip": 1e-3 * (200.0 - power) / 100.0, "life_h": 1e6 / power})
                         for speed in (1000, 4000, 7000) for power in (50.0, 150.0)]
    return {**content, "axes": [{"column": "input.power_kW", "units": "kW", "meaning": "power"}], "slice": {"input.power_kW": 150.0}}


def fine_powers():
    """The same with more cells than can have numbers."""
    content = powers()
    content["points"] = [scattered({**fixture.point(speed), "input.power_kW": power, "roller_slip": 0.02, "cage_slip": 0.01})
                         for speed in range(1000, 11000, 1000) for power in np.linspace(50.0, 150.0, 10).tolist()]
    return content


def spectrum():
    content = fixture.make_report()
    bins = [dict(zip(("speed_rpm", "torque_N_m", "share", "damage_share", "life_h"), row))
            for row in zip(some(4, 800.0, 9000.0), some(4, 90.0, 900.0), some(4, 0.1, 0.4), some(4, 0.1, 0.4), some(4, 1e4, 9e4))]
    content["spectrum"] = {"bins": [*bins, {"speed_rpm": 0.0, "torque_N_m": 3.0, "share": 0.1, "damage_share": None, "life_h": None}],
                           "life_h": 23456.0, "system_life_h": 3456.0, "L10mh": 34567.0}
    return content


def crown():
    profiles = ("straight", "ISO/TS 16281", "logarithmic", "arc")
    ends = ("straight", "reference", "optimum", "robust", "recommended")
    one = {"profile": "logarithmic", "drop_um": 7.5, "life_h": 7.0, "governing_life_h": 1.0, "untilted_governing_life_h": 2.0, "peak_pressure_MPa": 3.0,
           "edge_ratio": 4.0, "half_space_life_h": 5.0, "governing_life_in_band_h": 6.0}
    study = {"case": "x", "tilt": "stated", "life_key": "L10mrh", "points": [{"tilt_mrad": tilt, "drop_um": drop, "governing_life_h": life} for (tilt, drop), life in
                                                       zip(((0.0, 2.0), (0.0, 6.0), (0.4, 2.0), (0.4, 6.0)), some(4, 1e4, 4e4))],
             **{name: scattered({**one, "profile": name}) for name in ends}}
    study["recommended"].update(curve=[{"drop_um": d, "life_share": s} for d, s in zip((0.0, 5.0, 9.0, 14.0), some(4, 0.5, 0.99))],
                                least_drop_um=4.25, most_drop_um=10.5, life_kept_in_band=0.95, straight_life_share=0.43,
                                missed=[{"drop_um": 3.5, "life_share": 0.91}, {"drop_um": 12.5, "life_share": 0.87}],
                                by_laminae={"drop_um": 8.25, "life_share": 0.98})
    x = [-6.0, -3.0, 0.5, 3.0, 6.0, 6.5, 7.0, 8.0]
    figures = {"roller_diameter_mm": 12.0, "map": {"profile": "logarithmic", "drop_um": [1.0, 4.0, 8.0], "tilt_mrad": [0.0, 0.5], "drop_tolerance_um": 1.5,
                                                   "tilt_tolerance_mrad": 0.1, "governing_life_h": [some(2, 1e4, 3e4) for _ in range(3)]},
               "fronts": [{"profile": name, "points": [{"drop_um": d, "governing_life_h": h, "peak_pressure_MPa": p, "efficient": d != 4.0} for d, h, p in
                                                       zip((0.0, 4.0, 8.0), some(3, 1e4, 3e4), some(3, 1e3, 2e3))]} for name in profiles[:2]],
               "profiles": [{"profile": name, "x_mm": x, "drop_um": some(8, 1.0, 9.0)} for name in profiles],
               "pressure": [{"profile": name, "tilt_mrad": tilt, "x_mm": x, "pressure_MPa": some(8, 500.0, 2000.0), "peak_pressure_MPa": peak, "edge_ratio": ratio}
                            for name, tilt, peak, ratio in zip(profiles[:2] * 2, (0.0, 0.0, 0.5, 0.5), some(4, 2e3, 3e3), some(4, 1.0, 3.0))],
               "zone": [{"profile": name, "tilt_mrad": tilt, "x_mm": x, "places": [{"angle_deg": angle, "pressure_MPa": some(8, 100.0, 1900.0)}
                                                                                  for angle in (40.0, 55.0, 70.0, 85.0)]}
                        for name, tilt in (("straight", 0.0), ("logarithmic", 0.0), ("straight", 0.5), ("logarithmic", 0.5))],
               "speeds": [{"profile": name, "tilt_mrad": 0.0, "speed_rpm": [1000.0, 5000.0, 9000.0], "governing_life_h": some(3, 1e4, 4e4)} for name in profiles[:2]]}
    return {"crown": study, "figures": figures}


def computed_crown():
    """Tilts that follow from planet and pin."""
    content = crown()
    content["crown"]["tilt"] = "computed"
    del content["crown"]["robust"]
    return content


SCRATCH_NAMES = ("time", "acceleration", "envelope", "ball_deflection", "ball_load", "frequency", "envelope_spectrum", "acceleration_spectrum")


def scratch():
    """Record and variables of a bearing with a scratch."""
    time = np.linspace(0.0, 0.4, 300)
    values = {name: np.array(some(300, 0.5, 9.0)) for name in SCRATCH_NAMES}
    values |= {"time": time, "frequency": np.linspace(0.0, 3000.0, 300), "acceleration": np.array([some(300, -9.0, 9.0), some(300, -8.0, 8.0)]),
               "ball_deflection": np.array(some(300, -2e-6, 9e-6))}
    peaks = lambda: [{"frequency_Hz": f, "amplitude": a, "is": f"line {n}"} for n, (f, a) in enumerate(zip(some(3, 100.0, 700.0), some(3, 1.0, 9.0)))]  # noqa: E731
    study = {"case": "x", "shaft_Hz": 25.0, "outer_pass_Hz": 89.0, "inner_pass_Hz": 136.0, "ball_pass_Hz": 116.0, "cage_Hz": 9.9, "defect_Hz": 89.0,
             "natural_frequency_Hz": 1100.0, "band_Hz": [900.0, 1300.0], "band_kurtosis": 3.21, "envelope_peaks": peaks(), "spectrum_peaks": peaks(),
             "at_rest": {"displacement_um": 4.56, "contact_load_max_N": 812.0}, "acceleration": {"rms_m_s2": 12.3, "max_m_s2": 45.6}, "contact_load_max_N": 1234.0}
    return {"defect": study}, values


def run_up():
    """The same over orders of the shaft."""
    content, values = scratch()
    content["defect"] |= {name: [{"order": f, "amplitude": a, "is": "line"} for f, a in zip(some(2, 1.0, 9.0), some(2, 1.0, 9.0))]
                          for name in ("orders", "spectrum_orders")}
    return content, values | {"order": np.linspace(0.0, 60.0, 300)}


def balls():
    """Record and variables of a ball bearing in time."""
    time = np.linspace(0.0, 0.5, 200)
    values = {name: np.array(some(200, low, high, 9)) for name, low, high in (("cage_slip", -0.1, 0.4), ("pocket_load", 0.0, 9.0),
                                                                             ("first_ball_inner_load", 0.0, 900.0), ("cage_x", -2e-4, 2e-4), ("cage_y", -3e-4, 3e-4))}
    heat = dict(zip(("sliding", "differential_slip", "spin", "rolling", "contact_damping", "cage", "churning", "total"), some(8, 0.1, 9.0)))
    race = lambda: dict(zip(("load_rms_N", "load_max_N", "contact_angle_deg", "central_film_um", "life_Mrev"), some(5, 1.0, 900.0)))  # noqa: E731
    study = {"case": "x", "heat_W": heat, "life_h": 12345.0, "cage_slip": 0.0234, "inner": race(), "outer": race(), "slip_settling_s": 0.0456, "cage_speed_rpm": 1234.5,
             "cage_impact_max_N": 67.8, "friction_torque_N_mm": 91.2}
    return {"balls": study}, values | {"time": time}


def uncertainty():
    speeds = [1000.0, 3000.0, 6000.0]

    def band(low):
        return {"percentiles": dict(zip(("5", "25", "50", "75", "95"), rising(5, low, 3 * low))), "L10": low}

    bands = ("of_uncertain_inputs", "of_single_bearings_at_the_case", "of_both")
    inputs = ("bearing.radial_clearance", "input.power + oil.temperature")

    def indices():
        return [{"inputs": name, "first": first, "first_95": [0.9 * first, 1.2 * first], "total": total, "total_95": [0.8 * total, 1.1 * total],
                 "expected_standard_deviation_after": after}
                for name, first, total, after in zip(inputs, some(2, 0.1, 0.4), some(2, 0.5, 0.9), some(2, 100.0, 900.0))]

    data = {"case": "x", "life": "system_life_h", "warnings": [], "inputs": [], "measure_first": [{"measure": inputs[0]}],
            "speeds": [{"speed_rpm": s, "life_at_the_case_h": life, **{name: band(low) for name, low in zip(bands, some(3, 1e4, 3e4))}}
                       for s, life in zip(speeds, some(3, 1e4, 3e4))],
            "operating_point": {"speed_rpm": 3000.0, "indices": indices(), **{name: band(low) for name, low in zip(bands, some(3, 1e4, 3e4))}},
            "motion": [{"percentile": 5.0, "quasi_static_h": 11000.0, "dynamic_h": 12000.0, "ratio": 1.09, "status": "ok"},
                       {"percentile": 95.0, "quasi_static_h": 31000.0, "dynamic_h": 30500.0, "ratio": 0.98, "status": "ok"}],
            "peak": {"speed_at_the_case_rpm": 3111.0, "life_at_the_case_h": 22222.0,
                     "speed_rpm": {"mean": 3100.0, "standard_deviation": 210.0, "indices": indices(), **band(2900.0)},
                     "life_h": {"mean": 23000.0, "standard_deviation": 2100.0, "indices": indices(), **band(21000.0)}}}
    return types.SimpleNamespace(data=data, case_lives=np.array([row["life_at_the_case_h"] for row in data["speeds"]]),
                                 peak_speeds=np.array(some(80, 2500.0, 3500.0)), peak_lives=np.array(some(80, 2e4, 3e4)))
