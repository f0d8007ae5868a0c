// How the life of a planet bearing at rest follows any number behind it: dL/dp = L_p - L_q F_q^-1 F_p at the
// balance F(q, p) = 0. What only prepares the balance is an explicit map from the drivetrain to numbers();
// what comes after, from these numbers through contacts, films and balance to the life, is differentiated
// forward.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bearing/equilibrium/planet_on_pin.hpp"
#include "coupling/study/drivetrain.hpp"

namespace orbearing::study {

class LifeSlopes {
 public:
  /// Throws std::runtime_error where there is no balance, std::invalid_argument where planets load unevenly.
  LifeSlopes(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

  /// ln of one bearing's life in hours, as PointResult::life_hours.
  double log_life() const { return log_life_; }

  /// All numbers behind the life with every ring where it stands in this balance: an explicit map, as smooth
  /// as its closed forms. Of drivetrains of one shape alone: the same counts of rollers, laminae, cage angles
  /// and bearings.
  Eigen::VectorXd numbers(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry) const;

  /// Slope of log_life() as the numbers change by `change` a unit.
  double slope(const Eigen::VectorXd& change) const;

 private:
  struct Position {             // one cage angle
    double first_roller = 0.0;  // [rad]
    Eigen::VectorXd place;      // [m]  of the rings
  };
  bearing::laminae::BalanceSetting setting_at(const PlanetaryDrivetrain& drivetrain,
                                              const DrivetrainGeometry& geometry, const BearingDuty& duty,
                                              const Position& position) const;
  void balance_rings(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                     const BearingDuty& duty);
  void balance_planet(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty);
  void rate(const PlanetaryDrivetrain& drivetrain);

  std::vector<Position> positions_;
  std::vector<bearing::laminae::BalanceSlopes> balances_;             // (cage angles)
  std::vector<std::vector<bearing::laminae::LaminaSlopes>> by_load_;  // [1/N]  (cage angles, bearings)
  double inner_share_ = 0.0, outer_share_ = 0.0;                      // [-]  of the damage
  double log_life_ = 0.0;                                             // [ln h]
};

}  // namespace orbearing::study
