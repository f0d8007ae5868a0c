// Loads of the elements of one row over a pitch of cage angles, gathered by position on the races.
#pragma once

#include <Eigen/Core>

#include "bearing/equilibrium/tilted_roller.hpp"

namespace orbearing::bearing {

struct LoadsByPosition {
  Eigen::ArrayXd inner_load;          // [N]    (positions)
  Eigen::ArrayXd outer_load;          // [N]    (positions)
  Eigen::ArrayXd roller_tilt;         // [rad]  (positions)  outward at positive x
  Eigen::ArrayXXd inner_lamina_load;  // [N]    (laminae, positions); whole: no laminae
  Eigen::ArrayXXd outer_lamina_load;  // [N]    (laminae, positions)

  /// All zero.
  void resize(Eigen::Index laminae, Eigen::Index positions) {
    inner_load = outer_load = roller_tilt = Eigen::ArrayXd::Zero(positions);
    inner_lamina_load = outer_lamina_load = Eigen::ArrayXXd::Zero(laminae, positions);
  }
  /// Loads of the laminae of a roller at `position`, and its tilt.
  void put_laminae(const laminae::LaminaContact& inner, const laminae::LaminaContact& outer,
                   const laminae::RollerState& roller, Eigen::Index position) {
    roller_tilt[position] = roller.end_displacement / outer.half_length();
    inner.put_loads(roller.inner_approach(), roller.inner_end_displacement,
                    inner_lamina_load.col(position).data());
    outer.put_loads(roller.outer_approach, roller.outer_end_displacement,
                    outer_lamina_load.col(position).data());
  }
};

}  // namespace orbearing::bearing
