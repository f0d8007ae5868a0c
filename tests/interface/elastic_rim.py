#!/usr/bin/env python3
"""The reducer's planet by finite elements of another program (GetFEM).

All teeth, tooth form generated anew from the rack, triangles of second order, no symmetry used: influence functions,
displacement of the race at the rollers, load of each roller and life over speed beside those of orbearing.
Exit code 77 (skipped) where GetFEM is missing.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

try:
    import getfem
    import netCDF4
    import scipy.sparse as sparse
    from scipy.sparse.linalg import splu
    from scipy.spatial import Delaunay, cKDTree
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)
from matplotlib.path import Path

PROGRAM = os.environ.get("ORBEARING", "orbearing")
SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
CASE = SOURCE / "cases" / "reducer_150kW" / "case.yaml"

# The case, as printed.
TEETH, MODULE, ANGLE = 22, 3e-3, math.radians(20.0)
YOUNG, POISSON = 206e9, 0.3
RACE, SEAT = 0.5 * 35.64e-3 + 2.62e-3, 23.5e-3  # [m]  radii
RINGS, FACE = 2 * 11.9e-3, 28e-3  # [m]  widths
ROLLERS, PER_PLANET = 15, 2
SIZE = 0.8e-3  # [m]  of the triangles
ORDERS = [0] + list(range(2, 9))


def orbearing(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=True).stdout


def involute(angle):
    return math.tan(angle) - angle


def half_outline(shift, points=25):
    """(angle from the middle of the tooth, radius) from the middle of the gap to the middle of the tip; rack of ISO 53."""
    depth, fillet = 1.25, 0.38
    pitch, base = 0.5 * TEETH * MODULE, 0.5 * TEETH * MODULE * math.cos(ANGLE)
    centre = (depth - shift - fillet) * MODULE  # of the fillet below the rolling line
    half = 0.25 * math.pi * MODULE - (depth - fillet) * MODULE * math.tan(ANGLE)  # of the rack's tooth there
    offset = half - fillet * MODULE / math.cos(ANGLE)
    outline = []
    for normal in np.linspace(0.5 * math.pi, ANGLE, points):
        reach = centre / math.sin(normal) + fillet * MODULE
        x, y = reach * math.cos(normal), pitch - reach * math.sin(normal)
        turned = (centre / math.tan(normal) - offset) / pitch
        outline.append((math.pi / TEETH - math.atan2(x, y) + turned, math.hypot(x, y)))
    tip = pitch + (1.0 + shift) * MODULE
    thickness = (0.5 * math.pi + 2.0 * shift * math.tan(ANGLE)) / TEETH + involute(ANGLE)
    for radius in np.linspace(outline[-1][1], tip, points)[1:]:
        outline.append((thickness - involute(math.acos(base / radius)), radius))
    outline += [(angle, tip) for angle in np.linspace(outline[-1][0], 0.0, 6)[1:]]
    return np.array(outline)


def triangles(shift):
    half = half_outline(shift)
    flank = half[:, 1:] * np.column_stack([np.cos(half[:, 0]), np.sin(half[:, 0])])
    tooth = np.vstack([flank * [1, -1], flank[::-1][1:]])
    turns = [2.0 * math.pi * k / TEETH for k in range(TEETH)]
    corner = np.vstack([tooth[:-1] @ np.array([[math.cos(a), math.sin(a)], [-math.sin(a), math.cos(a)]]) for a in turns])
    outside = []
    for here, there in zip(corner, np.roll(corner, -1, axis=0)):
        length = np.linalg.norm(there - here)
        if outside and np.linalg.norm(here - outside[-1]) < 0.45 * SIZE:
            continue
        pieces = max(1, round(length / SIZE))
        outside += [here + (there - here) * i / pieces for i in range(pieces)]
    outside = np.array(outside)
    places = 2.0 * math.pi * np.arange(int(2.0 * math.pi * RACE / SIZE))
    places /= len(places)
    race = RACE * np.column_stack([np.cos(places), np.sin(places)])
    row = np.arange(-0.037, 0.037, SIZE)
    x, y = np.meshgrid(row, np.arange(-0.037, 0.037, 0.5 * math.sqrt(3.0) * SIZE))
    x = x + 0.5 * SIZE * (np.arange(x.shape[0]) % 2)[:, None]
    inner = np.column_stack([x.ravel(), y.ravel()])
    body = Path(outside)
    inner = inner[body.contains_points(inner) & (np.hypot(*inner.T) > RACE + 0.6 * SIZE)]
    inner = inner[cKDTree(outside).query(inner)[0] > 0.6 * SIZE]
    point = np.vstack([outside, race, inner])
    corners = Delaunay(point).simplices
    middle = point[corners].mean(axis=1)
    on_race = (corners >= len(outside)) & (corners < len(outside) + len(race))
    corners = corners[body.contains_points(middle) & (np.hypot(*middle.T) > 0.9995 * RACE) & ~on_race.all(axis=1)]
    return point, corners


class Planet:
    """The planet free in the plane but for the mean displacement and turn of its race."""

    def __init__(self, shift):
        point, corners = triangles(shift)
        getfem.util("trace level", 0)
        mesh = getfem.Mesh("empty", 2)
        mesh.add_convex(getfem.GeoTrans("GT_PK(2,1)"), point[corners].transpose(2, 1, 0))
        self.field = getfem.MeshFem(mesh, 2)
        self.field.set_fem(getfem.Fem("FEM_PK(2,2)"))
        self.integral = getfem.MeshIm(mesh, getfem.Integ("IM_TRIANGLE(6)"))
        self.place = self.field.basic_dof_nodes()
        self.size = self.field.nbdof()
        faces = mesh.outer_faces()
        points = mesh.pts()
        on_race = [k for k in range(faces.shape[1])
                   if np.all(np.hypot(*points[:, mesh.pid_in_faces(faces[:, k:k + 1])]) < 1.001 * RACE)]
        mesh.set_region(1, faces[:, on_race])
        self.radial = {(n, part): self.race_load(f"{part}({n}*atan2(X(2),X(1)))", "X/Norm(X)")
                       for n in [*ORDERS, 1] for part in ("cos", "sin")}
        held = np.column_stack([self.radial[1, "cos"], self.radial[1, "sin"], self.race_load("1", "[-X(2);X(1)]/Norm(X)")])
        stiffness = self.stiffness()
        scale = abs(stiffness.diagonal()).mean()
        held = sparse.csc_matrix(scale * held)
        self.factors = splu(sparse.bmat([[stiffness, held], [held.T, None]]).tocsc())

    def race_load(self, size, direction):
        return getfem.asm("generic", self.integral, 1, f"(1/{RACE})*{size}*({direction}).Test_u", 1, "u", 1, self.field,
                          np.zeros(self.size))

    def stiffness(self):
        model = getfem.Model("real")
        model.add_fem_variable("u", self.field)
        lame = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
        shear = 0.5 * YOUNG / (1 + POISSON)
        width = f"({RINGS}+{FACE - RINGS}*Heaviside(Norm_sqr(X)-{SEAT ** 2}))"
        model.add_linear_term(self.integral, f"{width}*({lame}*Trace(Grad_u)*Trace(Grad_Test_u)"
                              f"+{shear}*(Grad_u+Grad_u'):Grad_Test_u)")
        model.assembly("build_matrix")
        matrix = model.tangent_matrix()
        pointers, rows = matrix.csc_ind()
        return sparse.csc_matrix((matrix.csc_val(), rows, pointers), shape=(self.size, self.size))

    def displaced(self, load):
        return self.factors.solve(np.concatenate([load, np.zeros(3)]))[:self.size]

    def wave(self, displacement, order):
        """Amplitude cosine - i sine of the race's radial displacement."""
        share = 2.0 * math.pi if order == 0 else math.pi
        cosine, sine = (self.radial[order, part] @ displacement / share for part in ("cos", "sin"))
        return cosine - 1j * sine

    def race_compliance(self):
        """c_n without what a half-space gives way."""
        found = []
        for n in ORDERS:
            share = 2.0 * math.pi if n == 0 else math.pi
            own = self.wave(self.displaced(self.radial[n, "cos"]), n).real / share
            found.append(own - (2.0 * (1 - POISSON ** 2) / (math.pi * YOUNG * RINGS * n) if n else 0.0))
        return np.array(found)

    def by_tooth(self, pressure_angle, shift, sun):
        """Waves by 1 N at the pitch point of the sun mesh (at 180 degrees) or of the ring mesh (at 0)."""
        base = 0.5 * TEETH * MODULE * math.cos(ANGLE)
        radius = base / math.cos(pressure_angle)
        half = (0.5 * math.pi + 2 * shift * math.tan(ANGLE)) / TEETH + involute(ANGLE) - involute(pressure_angle)
        at = half if sun else -half  # on the tooth along x
        outward = np.array([math.cos(at), math.sin(at)])
        around = np.array([-math.sin(at), math.cos(at)])
        force = -math.sin(pressure_angle) * outward + (-1 if sun else 1) * math.cos(pressure_angle) * around
        node = np.argmin(np.hypot(self.place[0, ::2] - radius * outward[0], self.place[1, ::2] - radius * outward[1]))
        load = np.zeros(self.size)
        load[2 * node:2 * node + 2] = force
        moved = self.displaced(load)
        turn = math.pi - half if sun else half
        return np.array([self.wave(moved, n) * np.exp(-1j * n * turn) for n in ORDERS])


def form_at(waves, angle):
    return sum((wave * np.exp(1j * n * angle)).real for n, wave in zip(ORDERS, waves))


class Bearing:
    """Rollers between a rigid pin and a race that bends: Palmgren's contacts, loads of the turning frame."""

    def __init__(self, row, facts):
        self.constant = 8.06e4 * 5.7 ** (8.0 / 9.0)  # [N, mm]
        self.load = np.array([row["radial_mesh_load_N"] + row["centrifugal_load_N"], row["tangential_load_N"]])
        self.load *= row["planet_load_N"] / np.linalg.norm(self.load)
        carrier = row["carrier_speed_rpm"] * math.pi / 30.0
        cage = 0.5 * facts["operation.planet_speed"] * math.pi / 30.0 * (1 + 5.24 / 35.64)
        mass, radius = 1e-3 * facts["bearing.roller_mass"], 17.82e-3
        orbit = 1e-3 * facts["gearset.centre_distance"]
        self.inertia = lambda angle: mass * (radius * (cage + carrier) ** 2 + carrier ** 2 * orbit * np.cos(angle))

    def shared(self, approach, inertia):
        """Load on the outer race of rollers squeezed by `approach` [m], by bisection."""
        low, high = np.zeros_like(approach), self.constant * (1e3 * np.maximum(approach, 0.0)) ** (10.0 / 9.0) + inertia
        for _ in range(60):
            load = 0.5 * (low + high)
            gone = 1e-3 * ((np.maximum(load, 0.0) / self.constant) ** 0.9 + (np.maximum(load - inertia, 0.0) / self.constant) ** 0.9)
            low, high = np.where(gone < approach, load, low), np.where(gone < approach, high, load)
        return np.maximum(0.5 * (low + high), inertia)

    def balanced(self, angle, compliance, teeth):
        """Loads on both races at the rollers, and the displacement of the race there, by Newton's method."""
        orders = np.array(ORDERS)
        bends = PER_PLANET * np.cos(orders[:, None, None] * (angle[:, None] - angle[None, :]))
        bends = np.tensordot(compliance, bends, axes=1)
        rest, inertia = form_at(teeth, angle), self.inertia(angle)
        outward = np.array([np.cos(angle), np.sin(angle)])

        def missing(unknown):
            loads = self.shared(-unknown[:2] @ outward - unknown[2:], inertia)
            return np.concatenate([(self.load + outward @ loads) * 1e-8, unknown[2:] - rest - bends @ loads])

        unknown = np.concatenate([self.load / np.linalg.norm(self.load) * 1e-5, rest])
        for _ in range(60):
            now = missing(unknown)
            slopes = np.column_stack([(missing(unknown + 1e-10 * e) - now) / 1e-10 for e in np.eye(len(unknown))])
            step = np.linalg.solve(slopes, -now)
            share = 1.0
            while share > 1e-3 and np.linalg.norm(missing(unknown + share * step)) > np.linalg.norm(now):
                share *= 0.5
            unknown = unknown + share * step
            if np.linalg.norm(share * step) < 1e-13:
                break
        outer = self.shared(-unknown[:2] @ outward - unknown[2:], inertia)
        return outer - inertia, outer, unknown[2:]


class ElasticRim(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        rim = ["--set", "gearset.planet_rim=elastic"]
        cls.facts = {row["path"]: row["value"] for row in json.loads(orbearing("check", CASE, "--json"))["derived"]}
        cls.influence = json.loads(orbearing("mesh", CASE, "--json", *rim))["planet_rim"]
        shift = cls.facts["gearset.profile_shift.planet"]
        cls.planet = Planet(shift)
        cls.compliance = cls.planet.race_compliance()
        angles = {name: math.radians(cls.facts[f"gearset.{name}_mesh.pressure_angle"]) for name in ("sun", "ring")}
        cls.teeth = {name: cls.planet.by_tooth(angle, shift, name == "sun") for name, angle in angles.items()}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_influence_functions(self):
        ours = np.array(self.influence["race_by_rollers_m_per_N"])[ORDERS]
        self.assertLess(np.abs(ours / self.compliance - 1.0).max(), 0.02)
        for name, waves in self.teeth.items():
            form = self.influence[f"race_by_{name}"]
            found = (np.array(form["cosine_m_per_N"]) - 1j * np.array(form["sine_m_per_N"]))[ORDERS]
            worst = np.abs(found - waves).max() / np.abs(waves).max()
            print(f"waves by the {name} mesh: {100 * worst:.2f} % of the largest apart")
            self.assertLess(worst, 0.03)

    def test_rollers_and_life_over_speed(self):
        for speed in (1000, 3000, 6000, 12000):
            rows, loads = {}, {}
            for rim in ("rigid", "elastic"):
                folder = pathlib.Path(self.folder.name) / f"{rim}{speed}"
                text = orbearing("run", CASE, "--json", "-o", folder, "--set", f"gearset.planet_rim={rim}", "--set",
                                 f"input.speed={speed} rpm", "--set", "numerics.cage_positions=4")
                rows[rim] = json.loads(text)["points"][0]
                with netCDF4.Dataset(next((folder / "points").glob("*.nc"))) as file:
                    loads[rim] = {name: np.array(file[name]) for name in file.variables
                                  if name in ("angle", "inner_load", "outer_load", "race_form")}
            row = rows["elastic"]
            facts = {r["path"]: r["value"] for r in json.loads(
                orbearing("check", CASE, "--json", "--set", f"input.speed={speed} rpm"))["derived"]}
            force = facts["operation.mesh_normal_force"]
            teeth = force * (self.teeth["sun"] + self.teeth["ring"])
            bearing = Bearing(row, facts)
            places = loads["elastic"]["angle"]
            inner, outer, form = (np.zeros_like(places) for _ in range(3))
            for first in range(len(places) // ROLLERS):
                pick = slice(first, None, len(places) // ROLLERS)
                inner[pick], outer[pick], form[pick] = bearing.balanced(places[pick], self.compliance, teeth)
            largest = outer.max()
            apart = np.abs(loads["elastic"]["outer_load"] - outer).max() / largest
            moved = np.abs(loads["elastic"]["race_form"] - form).max() / np.abs(form).max()
            ratio = {}
            for race, exponent, values in (("inner", 4.5, inner), ("outer", 4.0, outer)):
                mean = lambda q: (np.maximum(q, 0.0) ** exponent).mean() ** (1.0 / exponent)
                ratio[race] = rows["rigid"][f"{race}_life_Mrev"] * (mean(loads["rigid"][f"{race}_load"]) / mean(values)) ** 4
            life = sum(value ** -1.125 for value in ratio.values()) ** (-1.0 / 1.125)
            gain = life / sum(rows["rigid"][f"{race}_life_Mrev"] ** -1.125 for race in ratio) ** (-1.0 / 1.125)
            ours = row["life_h"] / rows["rigid"]["life_h"]
            print(f"{speed} rpm: loads {100 * apart:.2f} %, displacement {100 * moved:.2f} % apart; life rigid to elastic "
                  f"{gain:.4f} by finite elements, {ours:.4f} here; largest load {rows['rigid']['outer_load_max_N']:.1f} to "
                  f"{row['outer_load_max_N']:.1f} N")
            self.assertLess(apart, 0.03)
            self.assertLess(moved, 0.05)
            self.assertLess(abs(gain / ours - 1.0), 0.02)


if __name__ == "__main__":
    unittest.main()
