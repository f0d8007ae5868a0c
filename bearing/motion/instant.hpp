// The bearing at one instant: where its bodies are, and what acts on one roller. Shared by the equations and
// by what is reported from them.
#pragma once

#include <cmath>

#include "bearing/motion/driving.hpp"
#include "bearing/motion/model.hpp"

namespace orbearing::bearing::motion {

/// Rings and cage at one instant.
struct RingBodies {
  BodyMotion cage;
  BodyMotion bore;
  BodyMotion pin;
  Vector2 cage_direction;  // [-]  of the cage angle
  RaceWaves waves;         // of an elastic bore
};

/// Valid as long as what `state` views.
inline RaceWaves waves_of(const ConstStateViews& state) {
  return {state.wave.data(), state.wave_speed.data(), state.wave.size()};
}

/// The cage; at rest where there is none.
inline BodyMotion cage_body(const BearingModel& model, const ConstStateViews& state) {
  if (!model.layout.caged) return {Vector2::Zero(), Vector2::Zero()};
  return {state.cage_position, state.cage_velocity, state.cage_speed};
}
inline Vector2 cage_direction(const BearingModel& model, const ConstStateViews& state) {
  return model.layout.caged ? direction(state.cage_angle) : Vector2::UnitX();
}

/// Bodies at `time` [s], which matters in a run-up and where waves turn with a race.
inline RingBodies ring_bodies(const BearingModel& model, const ConstStateViews& state, double time = 0.0) {
  const double ratio = speed_ratio(model.driving, time);
  const double turned = equivalent_time(model.driving, time);
  return {.cage = cage_body(model, state),
          .bore = {state.bore_position, state.bore_velocity, model.point.outer_speed * ratio,
                   model.point.outer_speed * turned},
          .pin = {state.pin_position, state.pin_velocity, model.point.inner_speed * ratio,
                  model.point.inner_speed * turned},
          .cage_direction = cage_direction(model, state),
          .waves = waves_of(state)};
}

/// One roller at one instant.
struct RollerBody {
  BodyMotion motion;
  Vector2 outward;             // [-]      e_r
  double radius = 0.0;         // [m]
  double angle = 0.0;          // [rad]
  double radial_speed = 0.0;   // [m/s]
  double orbital_speed = 0.0;  // [rad/s]
  double end_displacement = 0.0;  // [m]      LaminaStand::end_displacement
};

inline RollerBody roller_body(const BearingModel& model, const ConstStateViews& state, Eigen::Index j) {
  RollerBody roller;
  roller.radius = state.radius[j];
  roller.angle = state.angle[j];
  roller.radial_speed = state.radial_speed[j];
  roller.orbital_speed = state.orbital_speed[j];
  roller.outward = direction(roller.angle);
  roller.motion.position = roller.radius * roller.outward;
  roller.motion.velocity =
      roller.radial_speed * roller.outward + roller.radius * roller.orbital_speed * across(roller.outward);
  roller.motion.speed = state.spin[j];
  if (model.layout.tilting) roller.end_displacement = state.end_displacement[j];
  for (const RollerScratch& scratch : model.roller_scratches)
    if (scratch.roller == j) roller.motion.angle = state.turned[scratch.followed];
  return roller;
}

/// What the neighbours of one roller do to it where no cage keeps them apart.
struct NeighbourForces {
  NeighbourTouch ahead;   // in the sense of rising angles
  NeighbourTouch behind;  // the ahead of the roller before

  Wrench on_roller() const {
    Wrench both = ahead.on_roller;
    return both += behind.on_roller;
  }
};

/// None with a cage.
inline NeighbourForces neighbour_forces(const BearingModel& model, const ConstStateViews& state,
                                        const RollerBody& roller, Eigen::Index j) {
  if (model.layout.caged) return {};
  const Eigen::Index z = model.layout.rollers;
  const auto radius = [&](Eigen::Index i) {
    return model.geometry.element_radius + model.radius_deviation[static_cast<std::size_t>(i)];
  };
  const auto touch = [&](Eigen::Index other) {
    return neighbour_touch(model.neighbours, roller.motion, radius(j),
                           roller_body(model, state, other).motion, radius(other));
  };
  return {touch((j + 1) % z), touch((j + z - 1) % z)};
}

/// What acts on one roller.
struct RollerForces {
  RaceForces inner;
  RaceForces outer;
  PocketForces pocket;      // of a cage
  double orbit_drag = 0.0;  // [N]    along e_theta
  double spin_drag = 0.0;   // [N m]
  LaminaStand stand;        // of contacts cut into laminae
  Vector2 outer_normal;     // [-]    where elastic races are loaded
  double tip_rate = 0.0;    // [m/s]
  double tilt_power = 0.0;  // [W]  lost to the resistance against tilting
  double held_tilt = 0.0;   // [W]  of what holds the bore's tilt while the roller passes through it
};

/// Direction of the pocket of roller `j` [-].
inline Vector2 pocket_direction(const BearingModel& model, const RingBodies& rings, Eigen::Index j) {
  const Vector2& own = model.pocket_direction[static_cast<std::size_t>(j)];
  return own.x() * rings.cage_direction + own.y() * across(rings.cage_direction);
}

/// Motions of a roller in both its contacts, and how they yield.
struct RollerContacts {
  FormedContact inner;
  FormedContact outer;
  ElasticContact inner_elastic;
  ElasticContact outer_elastic;
  LaminaStand stand;        // of contacts cut into laminae
  LaminaRaceLoads tilting;  // of such contacts
};

inline RollerContacts roller_contacts(const BearingModel& model, const RingBodies& rings,
                                      const RollerBody& roller, Eigen::Index j) {
  const RollerSurface surface = surface_of(model, j);
  RollerContacts contacts{race_motion(model.inner, roller.motion, surface, rings.pin),
                          race_motion(model.outer, roller.motion, surface, rings.bore, rings.waves)};
  contacts.inner_elastic = straight_contact(model.inner, contacts.inner.contact);
  contacts.outer_elastic = straight_contact(model.outer, contacts.outer.contact);
  if (model.laminae) {
    contacts.stand = {contacts.inner_elastic.approach, contacts.outer_elastic.approach,
                      roller.end_displacement};
    contacts.tilting = model.laminae->loads(contacts.stand, roller.outward);
    contacts.inner_elastic.load = contacts.tilting.inner;
    contacts.outer_elastic.load = contacts.tilting.outer;
  }
  return contacts;
}

inline RollerForces roller_forces(const BearingModel& model, const RingBodies& rings,
                                  const RollerBody& roller, Eigen::Index j) {
  const double larger = model.radius_deviation[static_cast<std::size_t>(j)];
  const RollerContacts contacts = roller_contacts(model, rings, roller, j);
  const LaminaRaceLoads& tilting = contacts.tilting;
  const bool tilts = model.layout.tilting;
  const double tip_rate = tilts ? tilting.excess / model.laminae->resistance() : 0.0;
  const double passing =
      tilts ? model.laminae->bore_end_displacement().dot(across(roller.outward)) * roller.orbital_speed : 0.0;
  return {.inner = race_forces(model.inner, contacts.inner, rings.pin, contacts.inner_elastic),
          .outer = race_forces(model.outer, contacts.outer, rings.bore, contacts.outer_elastic),
          .pocket = model.layout.caged ? pocket_forces(model.pocket, roller.motion, rings.cage,
                                                       pocket_direction(model, rings, j), larger)
                                       : PocketForces{},
          .orbit_drag = model.orbit_drag.force(roller.radius * roller.orbital_speed),
          .spin_drag = model.spin_drag.force(roller.motion.speed),
          .stand = contacts.stand,
          .outer_normal = contacts.outer.contact.normal,
          .tip_rate = tip_rate,
          .tilt_power = tilting.excess * tip_rate,
          .held_tilt = -tilting.outer_end_load * passing};
}

/// The same for a model that is plain, at less cost.
inline RollerForces plain_roller_forces(const BearingModel& model, const RingBodies& rings,
                                        const RollerBody& roller, Eigen::Index j) {
  return {.inner = plain_race_forces(model.inner, roller.motion, rings.pin),
          .outer = plain_race_forces(model.outer, roller.motion, rings.bore),
          .pocket = touch_forces(model.pocket, roller.motion, rings.cage, pocket_direction(model, rings, j)),
          .orbit_drag = model.orbit_drag.force(roller.radius * roller.orbital_speed),
          .spin_drag = model.spin_drag.force(roller.motion.speed),
          .outer_normal = {}};
}

/// The ring whose land guides the cage.
inline const BodyMotion& land_body(const BearingModel& model, const RingBodies& rings) {
  return model.guiding_race == Race::outer ? rings.bore : rings.pin;
}

/// Wrenches that rollers, cage and land exert on the rings and on the cage.
struct RingWrenches {
  Wrench cage;
  Wrench bore;
  Wrench pin;

  void add(const RollerForces& forces) {
    pin += forces.inner.on_race;
    bore += forces.outer.on_race;
    cage += forces.pocket.on_cage;
  }
  void add(const GuidanceForces& forces, Race guiding_race) {
    cage += forces.on_cage;
    (guiding_race == Race::outer ? bore : pin) += forces.on_land;
  }
};

}  // namespace orbearing::bearing::motion
