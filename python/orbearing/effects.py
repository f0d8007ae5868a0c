"""Single effects that a report switches one at a time, as changes of a case."""

from __future__ import annotations

from dataclasses import dataclass, field

Inputs = dict[str, dict]  # rows of `orbearing check --json` by their path


@dataclass(frozen=True)
class Change:
    """Settings as with --set; none: the case as it stands."""

    name: str
    group: str
    settings: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Effect:
    """An effect that the case has is left out, one that it lacks is added."""

    group: str
    path: str
    on: str  # value where the case has the effect
    added: str  # what the change is called where the case has it not; empty: there is none
    off: str  # value without it
    left_out: str  # what the change is called where the case has it; empty: there is none
    needs: str = ""  # flag without which the case has it not, whatever the path says


GEARS = "gears"
# No cage is lighter than its range allows; this one's mass vanishes in the round-off of any load.
AT_REST = (
    Change("all effects", "inertia"),
    Change("no carrier centrifugal", "inertia", ["inertia.carrier_centrifugal=false"]),
    Change("no Coriolis", "inertia", ["inertia.coriolis=false"]),
    Change("no own orbit", "inertia", ["inertia.own_orbit=false"]),
    Change("cage without mass", "inertia", ["bearing.cage.density=1e-30 kg/m3"]),
    Change("clearance 0 um", "clearance", ["bearing.radial_clearance=0 um"]),
    Change("clearance 10 um", "clearance", ["bearing.radial_clearance=10 um"]),
    Change("clearance 37 um", "clearance", ["bearing.radial_clearance=37 um"]),
    Change("film in the approach", "clearance", ["film.enabled=true"]),
)
CHIEF = (
    Effect("inertia", "inertia.coriolis", "true", "Coriolis", "false", "no Coriolis"),
    Effect("inertia", "inertia.carrier_centrifugal", "true", "carrier centrifugal", "false", "no carrier centrifugal"),
    Effect("inertia", "inertia.own_orbit", "true", "own orbit", "false", "no own orbit"),
    Effect(GEARS, "gearset.mesh_variation", "true", "", "false", "constant mesh stiffness"),
    Effect("oil", "film.enabled", "true", "film in the approach", "false", "no film in the approach"),
    Effect("oil", "traction.law", "limiting-shear", "limiting-shear traction", "regularised-coulomb", "Coulomb traction"),
)
OIL = (
    Effect("oil", "traction.rolling_resistance", "true", "rolling resistance", "false", "no rolling resistance"),
    Effect("oil", "traction.rolling_law", "reynolds", "rolling resistance computed", "goksem-hargreaves", "rolling resistance by regression",
           needs="traction.rolling_resistance"),
    Effect("oil", "drag.enabled", "true", "oil drag", "false", "no oil drag"),
    Effect("oil", "contact.squeeze", "true", "squeeze of the films", "false", "no squeeze of the films"),
    Effect("oil", "contact.lubrication", "mixed", "mixed lubrication", "full", "no mixed lubrication"),
    Effect("oil", "bearing.cage.pocket_film", "hydrodynamic", "film in the pockets", "none", "no film in the pockets"),
)
# Each beside the waves that the case has.
ONE_WAVE_MORE = (
    ("oval bore, 5 um", "bearing.outer_race.out_of_roundness", 2, "5e-6 m"),
    ("oval pin, 5 um", "bearing.inner_race.out_of_roundness", 2, "5e-6 m"),
    ("11 waves on the bore, 0.5 um", "bearing.outer_race.waviness", 11, "0.5e-6 m"),
)


def at_rest(inputs: Inputs, of_set: str = "") -> list[Change]:
    """The case as it stands, then inertial terms left out, other clearances and the film, for the bearing at rest.

    `of_set`: of several sets the one whose bearing is looked at. What does not fit the case, as a clearance beyond what its cage leaves, is found when
    it is computed.
    """
    case = _Case(inputs, of_set)
    return case.placed([change for change in AT_REST if not (change.settings and case.lacks_cage_of(change.settings[0]))])


def in_motion(inputs: Inputs, every: bool, of_set: str = "") -> list[Change]:
    """The case as it stands, then each effect in turn, off where the case has it and on where it has not.

    Those that matter most and cost little, or with `every` all: forms of races and rollers that the case lacks, what a source prints otherwise. A
    constant speed has no Euler terms.
    """
    case = _Case(inputs, of_set)
    changes = [Change("all effects", "reference"), *case.switched(CHIEF)]
    if every:
        changes += [*case.switched(OIL), *case.other_guidance(), *(case.with_wave(*wave) for wave in ONE_WAVE_MORE), case.with_larger_roller()]
    return case.placed(changes)


class _Case:
    """Inputs of one set by the paths of a case that has but this one."""

    def __init__(self, inputs: Inputs, of_set: str):
        self._inputs, self._set, self._prefix = inputs, of_set, f"sets.{of_set}." if of_set else ""

    def _path(self, path: str) -> str:
        """In each set: gears and bearings, also what it does not state."""
        of_each = self._prefix and path.startswith(("gearset.", "bearing."))
        return self._prefix + path if of_each else path

    def value(self, path: str):
        """In SI; None where the case has none."""
        return self._inputs.get(self._path(path), {}).get("value")

    @property
    def is_full_complement(self) -> bool:
        return self.value("bearing.complement") == "full"

    def lacks_cage_of(self, setting: str) -> bool:
        return setting.startswith("bearing.cage.") and self.is_full_complement

    def placed(self, changes: list[Change]) -> list[Change]:
        """As changes of the whole case; several sets give mean forces."""
        if not self._set:
            return changes
        return [Change(one.name, one.group, [self._path(setting) for setting in one.settings]) for one in changes if one.group != GEARS]

    def switched(self, effects) -> list[Change]:
        changes = []
        for effect in effects:
            if self.lacks_cage_of(effect.path):
                continue
            value = self.value(effect.path)
            has = (str(value).lower() if isinstance(value, bool) else value) == effect.on and (not effect.needs or self.value(effect.needs) is True)
            name = effect.left_out if has else effect.added
            if name:
                changes.append(Change(name, effect.group, [f"{effect.path}={effect.off if has else effect.on}",
                                                           *([f"{effect.needs}=true"] if effect.needs else [])]))
        return changes

    def other_guidance(self) -> list[Change]:
        """The cage on the land of the other ring, with the clearance it has."""
        if self.is_full_complement:
            return [Change("no friction between rollers", "cage", ["bearing.neighbour_friction=0"])]
        land = "bearing.cage.guide_land_diameter"
        if self.value(land) is None:
            return []
        inner, outer, now = (self.value(path) for path in ("bearing.cage.inner_diameter", "bearing.cage.outer_diameter", land))
        ring, diameter = ("inner", inner - (now - outer)) if self.value("bearing.cage.guidance") == "outer" else ("outer", outer + (inner - now))
        return [Change(f"cage on the {ring} ring", "cage", [f"bearing.cage.guidance={ring}", f"{land}={diameter!r} m"])]

    def with_wave(self, name: str, block: str, order: int, amplitude: str) -> Change:
        waves = {"order": str(order), "amplitude": amplitude}
        if self.value(f"{block}.phase") is not None:
            waves["phase"] = "0 deg"
        settings = []
        for key, text in waves.items():
            own = self._inputs.get(self._path(f"{block}.{key}"), {}).get("given") if self.value(f"{block}.{key}") is not None else None  # "[1 um, 2 um]"
            settings.append(f"{block}.{key}=" + (f"{own[:-1]}, {text}]" if own else f"[{text}]"))
        return Change(name, "form", settings)

    def with_larger_roller(self) -> Change:
        path = "bearing.roller_diameter_deviation"
        first, *others = self.value(path) or [0.0]
        texts = ", ".join(f"{deviation!r} m" for deviation in (first + 2e-6, *others))
        return Change("one roller 2 um larger", "form", [f"{path}=[{texts}]"])
