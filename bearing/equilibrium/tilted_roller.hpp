// One roller between two races that are tilted against each other: its equilibrium and its tilt.
//
//   outer race  ------------------____    ^ outward   end displacement: how much further outward
//                _________________        |           a body is at x = l/2 than in the middle
//   roller      |_________________|-->x   |           approach: by how much the races have come closer
//   inner race  -------------------       |           in the middle than unloaded dry contacts allow
#pragma once

#include <Eigen/Core>
#include <variant>

#include "bearing/contact/lamina_contact.hpp"
#include "bearing/contact/race_contact.hpp"
#include "bearing/equilibrium/roller_balance.hpp"

namespace orbearing::bearing::laminae {

/// Both contacts of a roller. Its film depends on the load of the whole contact and is as thick all along it.
struct TiltedRoller {
  const LaminaContact& inner;
  const LaminaContact& outer;
  const Film& inner_film;
  const Film& outer_film;
  /// [-]  of the angle between the normals of both races: 1, but of tapered rollers, whose rib holds them
  /// along the inner race through the point where the normals of both middles meet
  double taper_cosine = 1.0;
};

/// Approach of the races and inertial load of one roller.
struct RollerSetting {
  double approach = 0.0;                // [m]  of the races in the middle
  double inner_end_displacement = 0.0;  // [m]  of the inner race
  double outer_end_displacement = 0.0;  // [m]  of the outer race
  double inertial_load = 0.0;           // [N]  outward, in the middle: outer load - inner load
};

/// Equilibrium of a roller. Start of the next search as well as its result.
struct RollerState {
  bool known = false;             // false: no earlier state to start from
  double taper_cosine = 1.0;      // [-]  as of the roller
  double elastic = 0.0;           // [m]  sum of both elastic approaches in the middle: approach and films
  double outer_approach = 0.0;    // [m]  elastic, in the middle
  double end_displacement = 0.0;  // [m]  of the roller
  double approach = 0.0;          // [m]  of the races, for which it settled
  double inner_end_displacement = 0.0;  // [m]  how much more the inner contact is approached at x = l/2
  double outer_end_displacement = 0.0;  // [m]  the same of the outer contact
  LaminaForce inner;
  LaminaForce outer;
  double stiffness = 0.0;     // [N/m]  d(outer load)/d(approach of the races)
  double per_approach = 1.0;  // [-]    d(elastic)/d(approach)
  Eigen::Vector2d per_elastic =
      Eigen::Vector2d::Zero();  // [-]    d(outer approach, end displacement)/d(elastic)
  bool settled = false;

  /// Elastic approach of the inner contact in the middle [m].
  double inner_approach() const { return (elastic - outer_approach) / taper_cosine; }
};

/// Stiffness [N/m] that holds the roller in its position and end displacement between races at rest.
inline Eigen::Matrix2d settling_stiffness(const RollerState& state) {
  const double cosine = state.taper_cosine, mixed = state.inner.mixed / cosine + state.outer.mixed;
  Eigen::Matrix2d stiffness;
  stiffness << state.inner.by_approach / (cosine * cosine) + state.outer.by_approach, mixed, mixed,
      state.inner.by_end_displacement + state.outer.by_end_displacement;
  return stiffness;
}

/// Balance of forces and of moments about the middle: Q_o - Q_i = I, M_o = M_i; of a tapered roller Q_o times
/// the cosine of its taper. Slopes follow from the
/// implicit function theorem. A roller that is not squeezed rests on the race towards which its inertial load
/// points. A known `state` is where the search starts.
void converge_roller(const TiltedRoller& roller, const RollerSetting& setting, RollerState& state);

/// The law of an element in a row: whole contacts, or laminae.
using Element = std::variant<WholeElement, TiltedRoller>;

/// The same of any element; of whole contacts `state` has loads and stiffness only.
void converge_element(const Element& element, const RollerSetting& setting, RollerState& state);

/// Stiffness [N/m] of one settled roller between races that approach each other in the middle and at
/// x = l/2: README.md (13).
Eigen::Matrix2d roller_stiffness(const RollerState& roller);

}  // namespace orbearing::bearing::laminae
