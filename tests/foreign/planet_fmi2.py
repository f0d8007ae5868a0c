from planet_motion import PlanetMotion
from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real


class PlanetModel(PlanetMotion, Fmi2Slave):
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.register(Real, Fmi2Causality, Fmi2Variability)
