from planet_motion import PlanetMotion
from pythonfmu3 import CoSimulation, Fmi3Causality, Fmi3Slave, Fmi3Variability, Float64


class PlanetModel(PlanetMotion, Fmi3Slave, CoSimulation):
    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.register(Float64, Fmi3Causality, Fmi3Variability)
