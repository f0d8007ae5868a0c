// One bearing of a planet under a load at rest, and the lives of one from means of its loads.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bearing/equilibrium/aligned_pitch.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/life/basic_life.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/motion/statistics.hpp"
#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/tilting_planet.hpp"

namespace orbearing::analysis {

/// One bearing of one planet, at rest in the carrier's frame.
struct QuasiStaticBearing {
  bearing::QuasiStaticResult loads;
  bearing::motion::WindowStatistics means;
  Eigen::Vector2d tilt;  // [rad]  of the bore, of laminae
};

/// The bearings of planets at rest, planet by planet. Keeps references to both arguments.
class BearingsAtRest {
 public:
  // One instruction set everywhere, so that points are equal to the last bit on all machines of a sweep.
  BearingsAtRest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

  /// All bearings of a planet: one where they are alike.
  std::vector<QuasiStaticBearing> of(const BearingDuty& duty);
  /// One bearing, with the tilt of the duty. Throws std::runtime_error if there is no equilibrium.
  QuasiStaticBearing one(const BearingDuty& duty);

  const bearing::laminae::LaminaBearing& bearing() const { return bearing_; }

 private:
  bearing::QuasiStaticResult loads_under(const BearingDuty& duty);

  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  bearing::QuasiStaticOptions options_;
  bearing::laminae::LaminaBearing bearing_;
  std::optional<PlanetSeat> seat_;  // where the tilt is computed
  std::optional<bearing::vectorised::AlignedPitch> level_;
};

/// Whether the lives by the standards are of laminae that the loads do not have: of whole contacts with a
/// profile.
bool is_rated_on_laminae(const PlanetaryDrivetrain& drivetrain);
/// The same drivetrain with contacts cut into the least number of laminae that the standard allows.
PlanetaryDrivetrain cut_for_rating(PlanetaryDrivetrain drivetrain);

/// Least film [m] under a roller that rolls on `race` with `load` [N], heated if the case has it; NaN
/// without oil.
double least_film_at_rest(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          bearing::Race race, const bearing::Film& film, double load);

/// Largest pressure [Pa] of both races after Hertz, under the largest load [N] of a roller on each. Of
/// laminae the load of a roller all of which carries as its most loaded one.
double largest_hertz_pressure(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                              double inner_load, double outer_load);

/// The same in motion, of whole contacts with a profile (is_rated_on_laminae()): the largest load [N] on each
/// race is distributed along the roller as its profile has it in static equilibrium of one contact.
double pressure_along_the_roller(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                 double inner_load, double outer_load);

/// Load [N] on the bore of one bearing with what reaches it through its cages, whatever its type.
Eigen::Vector2d bore_load_with_cage(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                    const bearing::OperatingPoint& point);

/// Conditions of the standards for a bearing besides the loads on its elements: P and P_0 [N], and the oil at
/// `speed` [rad/s], if stated. Rings at rest against each other have no kappa.
bearing::rating::RatingCondition rating_condition(const RatedBearing& rated, double load, double largest_load,
                                                  double speed, double pitch_diameter);

/// As bearing::rating::rated_hours(); all infinite if the rings are at rest against each other, with or
/// without oil: then only the static safety counts.
bearing::rating::RatedHours hours_at(const bearing::rating::RatingLives& lives, double speed);

/// Loads and lives of the bearings of one point, which share speeds, oil and ratings. Keeps references to
/// both drivetrain and geometry.
class PlanetBearingRating {
 public:
  /// `duty`: gives the speeds.
  PlanetBearingRating(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                      const BearingDuty& duty)
      : drivetrain_(drivetrain), geometry_(geometry), speed_(rotating_speed(drivetrain.bearing, duty.point)) {
    if (is_rated_on_laminae(drivetrain)) laminae_.emplace(cut_for_rating(drivetrain).bearing);
  }

  /// Lives of one bearing under a radial load [N].
  struct Lives {
    bearing::BearingLife life;  // [rev]  of Lundberg and Palmgren
    double hours = 0.0;         // [h]
    bearing::rating::RatingLives rating;
    bearing::rating::RatedHours rated_hours;
  };

  Lives of(const bearing::motion::WindowStatistics& means, double load) const {
    return of(means, load, load);
  }
  Lives of(const bearing::motion::WindowStatistics& means, double load, double largest_load) const;

  /// Radial load of the whole on one bore [N], as PointResult::planet_load.
  double load_of(const BearingDuty& duty) const { return load_vector_of(duty).norm(); }
  Eigen::Vector2d load_vector_of(const BearingDuty& duty) const {
    return bore_load_with_cage(drivetrain_, geometry_, duty.point);
  }

  const PlanetaryDrivetrain& drivetrain() const { return drivetrain_; }
  const DrivetrainGeometry& geometry() const { return geometry_; }

 private:
  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  double speed_ = 0.0;  // [rad/s]  of the race that turns relative to the load
  std::optional<bearing::laminae::LaminaBearing> laminae_;  // of whole contacts that are rated on laminae
};

/// P [N] of loads that take turns: [ISO281] by the exponent of its life.
double mean_by_basic_life(const std::vector<double>& loads);

}  // namespace orbearing::analysis
