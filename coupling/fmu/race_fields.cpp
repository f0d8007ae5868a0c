// Fields of the roller dynamics: races, cage, drag, support.
#include "coupling/fmu/bearing_fields.hpp"

namespace orbearing::fmu {

namespace {

using Fields = FieldList<BearingModel>;
using enum Use;
using enum Allowed;

void add_traction(Fields& f) {
  f.number(
       {"contact.damping", "s/m", "growth of a race contact's load by approach speed", parameter,
        not_negative},
       [](auto& m) -> auto& { return m.setup.dynamics.race.damping; })
      .number(
          {"traction.law"}, [](auto& m) -> auto& { return m.setup.dynamics.race.traction; })
      .number(
          {"traction.friction", "1", "largest friction of a race contact", parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.race.friction; })
      .number(
          {"traction.sliding_scale", "m/s", "sliding at which friction saturates", parameter, positive},
          [](auto& m) -> auto& { return m.setup.dynamics.race.sliding_scale; })
      .number(
          {"traction.limiting_friction", "1", "limiting shear stress over pressure", parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.race.limiting_friction; })
      .number(
          {"traction.least_sliding_scale"},
          [](auto& m) -> auto& { return m.setup.dynamics.race.least_sliding_scale; })
      .number(
          {"traction.largest_barus_exponent"},
          [](auto& m) -> auto& { return m.setup.dynamics.race.largest_barus_exponent; })
      .number(
          {"traction.entrainment_scale"},
          [](auto& m) -> auto& { return m.setup.dynamics.race.entrainment_scale; })
      .number(
          {"traction.rolling_resistance"},
          [](auto& m) -> auto& { return m.setup.dynamics.race.rolling_resistance; })
      .number(
          {"film.enabled"}, [](auto& m) -> auto& { return m.setup.dynamics.race.film_in_approach; })
      .number(
          {"film.approach"}, [](auto& m) -> auto& { return m.setup.dynamics.race.film_approach; })
      .number(
          {"contact.damping_law"}, [](auto& m) -> auto& { return m.setup.dynamics.race.damping_law; });
}

void add_mixed(Fields& f) {
  f.number(
       {"contact.lubrication"}, [](auto& m) -> auto& { return m.setup.dynamics.race.lubrication; })
      .number(
          {"contact.roughness", "m", "composite roughness of roller and race, rms", parameter, positive},
          [](auto& m) -> auto& { return m.setup.dynamics.race.roughness; })
      .number(
          {"contact.boundary_friction", "1", "friction of asperities", parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.race.boundary_friction; });
}

void add_pocket(Fields& f) {
  f.number(
       {"bearing.cage.pocket_clearance", "m", "play of a roller in its pocket along the pitch circle",
        parameter, positive},
       [](auto& m) -> auto& { return m.setup.dynamics.cage.pocket_clearance; })
      .number(
          {"bearing.cage.pocket_stiffness", "N/m", "stiffness of a pocket bar", parameter, positive},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.pocket_stiffness; })
      .number(
          {"bearing.cage.pocket_damping", "s/m", "as contact.damping, of a pocket bar", parameter,
           not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.pocket_damping; })
      .number(
          {"bearing.cage.pocket_friction", "1", "friction in the pockets", parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.pocket_friction; })
      .number(
          {"bearing.cage.pocket_film"}, [](auto& m) -> auto& { return m.setup.dynamics.cage.pocket_film; })
      .number(
          {"bearing.cage.pocket_roughness"},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.pocket_roughness; })
      .number(
          {"bearing.cage.reference_speed"},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.reference_speed; });
}

void add_guidance(Fields& f) {
  f.number(
       {"bearing.cage.guide_land_diameter", "m", "diameter of the land that guides the cage; 0: none",
        parameter, not_negative},
       [](auto& m) -> auto& { return m.setup.dynamics.cage.guide_diameter; })
      .number(
          {"bearing.cage.land_width"}, [](auto& m) -> auto& { return m.setup.dynamics.cage.land_width; })
      .number(
          {"bearing.cage.lands"}, [](auto& m) -> auto& { return m.setup.dynamics.cage.lands; })
      .number(
          {"bearing.cage.guidance_film"},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.guidance_film; })
      .number(
          {"bearing.cage.largest_eccentricity", "1", "of the land's clearance, where roughness takes over",
           parameter, share},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.largest_eccentricity; })
      .number(
          {"bearing.cage.touch_down_stiffness", "N/m", "stiffness where the cage touches its land", parameter,
           positive},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.touch_down_stiffness; })
      .number(
          {"bearing.cage.touch_down_damping"},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.touch_down_damping; })
      .number(
          {"bearing.cage.touch_down_friction"},
          [](auto& m) -> auto& { return m.setup.dynamics.cage.touch_down_friction; });
}

void add_drag(Fields& f) {
  f.number(
       {"drag.enabled"}, [](auto& m) -> auto& { return m.setup.dynamics.drag.on; })
      .number(
          {"lubricant.density", "kg/m3", "density of the oil", parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.drag.oil_density; })
      .number(
          {"lubricant.share", "1", "oil in the free volume", parameter, share},
          [](auto& m) -> auto& { return m.setup.dynamics.drag.oil_share; })
      .number(
          {"drag.coefficient"}, [](auto& m) -> auto& { return m.setup.dynamics.drag.drag_coefficient; })
      .number(
          {"drag.churning_coefficient"},
          [](auto& m) -> auto& { return m.setup.dynamics.drag.churning_coefficient; })
      .number(
          {"support.stiffness", "N/m", "stiffness of the pin in the carrier", parameter, positive},
          [](auto& m) -> auto& { return m.setup.dynamics.support.stiffness; })
      .number(
          {"support.damping_ratio", "1", "damping of the pin in the carrier over critical", parameter,
           not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.support.damping_ratio; })
      .number(
          {"planet.mass_per_bearing", "kg",
           "planet mass per bearing, by which support.damping_ratio counts; its inertia is not in the FMU",
           parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.bore_mass; });
}

void add_inertia(Fields& f) {
  f.number(
       {"inertia.own_orbit"}, [](auto& m) -> auto& { return m.setup.dynamics.inertia.own_orbit; })
      .number(
          {"inertia.coriolis"}, [](auto& m) -> auto& { return m.setup.dynamics.inertia.coriolis; })
      .number(
          {"inertia.carrier_centrifugal"},
          [](auto& m) -> auto& { return m.setup.dynamics.inertia.carrier_centrifugal; })
      .number(
          {"inertia.euler"}, [](auto& m) -> auto& { return m.setup.dynamics.inertia.euler; });
}

}  // namespace

void add_race_fields(FieldList<BearingModel>& fields) {
  add_traction(fields);
  add_mixed(fields);
  add_drag(fields);
  add_inertia(fields);
}

void add_cage_motion_fields(FieldList<BearingModel>& fields) {
  add_pocket(fields);
  add_guidance(fields);
}

}  // namespace orbearing::fmu
