"""A planet on the spring of its mesh, without any part of Orbearing: what planet_fmi2.py and planet_fmi3.py export.

It moves in the frame of the carrier, x outward and y in the sense of rotation, under the force of the gears, the
spring of a mesh along y, the inertial forces of that frame and what its bearing does to it. Inputs are held over a
step.
"""

PARAMETERS = {
    "mass": 1.0,  # [kg]
    "inertia": 1.0e-3,  # [kg m^2]  about the planet's axis
    "orbit_radius": 0.1,  # [m]
    "carrier_speed": 0.0,  # [rad/s]
    "load_y": 0.0,  # [N]  of the gears
    "mesh_stiffness": 0.0,  # [N/m]  along y
    "mesh_damping": 0.0,  # [N s/m]
    "turning_stiffness": 0.0,  # [N m/rad]
    "turning_damping": 0.0,  # [N m s/rad]
    "start_x": 0.0,  # [m]
    "start_y": 0.0,  # [m]
    "step": 1e-6,  # [s]  at most, inside
}
INPUTS = ("force_x", "force_y", "moment")
OUTPUTS = ("x", "y", "angle", "v_x", "v_y", "spin")


class PlanetMotion:
    def register(self, real, causality, variability):
        """All variables, by the words of the exporter."""
        for name, start in PARAMETERS.items():
            setattr(self, name, start)
            self.register_variable(real(name, causality=causality.parameter, variability=variability.tunable))
        for names, role in ((INPUTS, causality.input), (OUTPUTS, causality.output)):
            for name in names:
                setattr(self, name, 0.0)
                self.register_variable(real(name, causality=role))

    def exit_initialization_mode(self):
        self.x, self.y = self.start_x, self.start_y

    def accelerations(self, state):
        x, y, angle, v_x, v_y, spin = state
        turning = self.carrier_speed
        return (
            self.force_x / self.mass + turning**2 * (self.orbit_radius + x) + 2.0 * turning * v_y,
            (self.force_y + self.load_y - self.mesh_stiffness * y - self.mesh_damping * v_y) / self.mass
            + turning**2 * y
            - 2.0 * turning * v_x,
            (self.moment - self.turning_stiffness * angle - self.turning_damping * spin) / self.inertia,
        )

    def rates(self, state):
        return (*state[3:], *self.accelerations(state))

    def do_step(self, current_time, step_size):
        state = tuple(getattr(self, name) for name in OUTPUTS)
        count = max(1, round(step_size / self.step))
        h = step_size / count
        for _ in range(count):
            k1 = self.rates(state)
            k2 = self.rates([s + h / 2 * k for s, k in zip(state, k1)])
            k3 = self.rates([s + h / 2 * k for s, k in zip(state, k2)])
            k4 = self.rates([s + h * k for s, k in zip(state, k3)])
            state = [s + h / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
        for name, value in zip(OUTPUTS, state):
            setattr(self, name, value)
        return True
