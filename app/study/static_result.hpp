// What comes out of one bearing under a static load.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "bearing/life/basic_life.hpp"
#include "bearing/life/capacities.hpp"

namespace orbearing::app {

/// What the standard knows of the bearing without its load.
struct Ratings {
  double gamma = 0.0;               // [-]
  double capacity_factor = 0.0;     // [-]  f_c [N, mm]
  double dynamic_capacity = 0.0;    // [N]  C_r: given, or by the standard
  double static_capacity = 0.0;     // [N]  C_0r
  double fatigue_load_limit = 0.0;  // [N]  C_u
  bearing::rating::ContactCapacities contacts;
  double slenderness_limit = 0.0;  // [-]  largest gamma of the standard's table of f_c
};

/// Lubrication and cleanliness; none where the case does not state them.
struct FilmState {
  double viscosity_ratio = 0.0;       // [-]  kappa
  double contamination_factor = 0.0;  // [-]  e_C
  double life_modification = 1.0;     // [-]  a_ISO
};

/// Results; lives in revolutions, infinite where nothing is loaded.
struct StaticStudy {
  std::string model;
  double radial = 0.0;            // [m]    displacement along the radial load
  double axial = 0.0;             // [m]
  double tilt = 0.0;              // [rad]
  double moment = 0.0;            // [N m]  on the inner ring
  Eigen::ArrayXd contact_load;    // [N]    (rolling elements)
  Eigen::ArrayXd contact_angle;   // [rad]  (balls); empty for rollers
  Eigen::ArrayXXd lamina_load;    // [N]    (laminae, rollers); empty for balls
  double largest_pressure = 0.0;  // [Pa]  after Hertz, without what edges add
  Ratings ratings;
  std::optional<double> equivalent_load;  // [N]  P of ISO 281; none where the standard's factors are not held
  double basic_life = 0.0;                // [rev]  L10; not a number where P is missing
  bearing::BearingLife reference_life;    // [rev]  L10r of races and bearing
  double reliability_factor = 1.0;        // [-]  a_1
  std::optional<FilmState> film;
  double life = 0.0;                                      // [rev]  a_1 a_ISO L10r
  std::optional<bearing::BearingLife> lundberg_palmgren;  // [rev]  of rollers
  std::vector<std::string> warnings;
};

}  // namespace orbearing::app
