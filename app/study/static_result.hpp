// What comes out of one bearing under a static load.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/study/ball_films.hpp"
#include "app/study/static_steps.hpp"
#include "bearing/life/standard_life.hpp"

namespace orbearing::app {

/// Lubrication and cleanliness; none where the case does not state them.
struct FilmState {
  double viscosity_ratio = 0.0;       // [-]  kappa
  double contamination_factor = 0.0;  // [-]  e_C
  double life_modification = 1.0;     // [-]  a_ISO
};

/// Results; lives in revolutions, infinite where nothing is loaded.
struct StaticStudy {
  std::string model;
  double radial = 0.0;           // [m]    displacement across the axis, of both planes
  double axial = 0.0;            // [m]
  double tilt = 0.0;             // [rad]  of both planes
  double moment = 0.0;           // [N m]  on the inner ring, in the plane of the radial load
  Eigen::ArrayXd contact_load;   // [N]    (rolling elements)  on the inner race
  Eigen::ArrayXd contact_angle;  // [rad]  (balls)  there; empty for rollers
  Eigen::ArrayXd outer_load;     // [N]    (balls)  of rings that turn; else empty
  Eigen::ArrayXd outer_angle;    // [rad]  (balls)  the same
  double friction = 0.0;         // [-]    traction over load that holds the balls, at most
  /// Of the inner ring: x along the radial load, y, z, tilts about x and y; [N/m], [N/rad], [N m/rad].
  Eigen::Matrix<double, 5, 5> stiffness = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::ArrayXXd lamina_load;    // [N]    (laminae, rollers); empty for balls
  double largest_pressure = 0.0;  // [Pa]  after Hertz, without what edges add
  bearing::rating::Ratings ratings;
  std::optional<double> equivalent_load;  // [N]  P of ISO 281; none where the standard's factors are not held
  double basic_life = 0.0;                // [rev]  L10; not a number where P is missing
  bearing::BearingLife reference_life;    // [rev]  L10r of races and bearing
  double reliability_factor = 1.0;        // [-]  a_1
  std::optional<FilmState> film;
  double life = 0.0;                                      // [rev]  a_1 a_ISO L10r
  std::optional<bearing::BearingLife> lundberg_palmgren;  // [rev]  of rollers
  std::optional<std::vector<BallFilm>> films;             // of balls whose film takes part
  std::optional<SpeedTable> over_speed;
  std::optional<StaticSteps> steps;  // none where balls turn
  std::vector<std::string> warnings;
};

}  // namespace orbearing::app
