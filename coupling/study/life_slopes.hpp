// How the life of a planet bearing at rest follows any number behind it: dL/dp = L_p - L_q F_q^-1 F_p at the
// balance F(q, p) = 0. What only prepares the balance is an explicit map from the drivetrain to numbers();
// what comes after, from these numbers through contacts, films and balance to the life, is differentiated
// forward.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bearing/equilibrium/planet_on_pin.hpp"
#include "coupling/study/drivetrain.hpp"
#include "coupling/study/load_sharing.hpp"

namespace orbearing::study {

class LifeSlopes {
 public:
  /// Throws std::runtime_error where there is no balance, std::invalid_argument where planets that load
  /// unevenly have no gears to share it.
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
  static bearing::laminae::BalanceSetting setting_at(const PlanetaryDrivetrain& drivetrain,
                                                     const DrivetrainGeometry& geometry,
                                                     const bearing::Bearing& bearing,
                                                     const bearing::OperatingPoint& point,
                                                     const Position& position);
  struct Balances {  // of rings over the cage angles
    std::vector<Position> positions;
    std::vector<bearing::laminae::BalanceSlopes> balances;
  };
  // How the planets share the set's load, and the life by it. Eqs. (23) and (24) of
  // bearing/equilibrium/README.md.
  struct Sharing {
    PlanetBalance here;
    std::vector<Balances> supports;         // (planets)  of the bearings as springs of the set
    Eigen::MatrixXd displacement_by_force;  // [m/N]  (2 planets, 2 planets)  of bearings, pins and springs
    Eigen::MatrixXd forces_by_offset;       // [N/m]  of the set
    Eigen::MatrixXd shares_by_offset;       // [1/m]  (planets, 2 planets)
    Eigen::VectorXd life_by_share;          // [-]  (planets)  slope of log_life()
  };
  static Balances balance_rings(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                const bearing::Bearing& bearing, const bearing::OperatingPoint& point);
  static Balances balance_planet(const PlanetaryDrivetrain& drivetrain, const BearingDuty& duty);
  void rate(const PlanetaryDrivetrain& drivetrain);
  void put_sharing(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);
  Eigen::VectorXd numbers_with(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                               const std::vector<double>& shares) const;
  Eigen::VectorXd sharing_numbers(const PlanetaryDrivetrain& drivetrain,
                                  const DrivetrainGeometry& geometry) const;
  // Both read `change` from `at` on, which goes on.
  double slope_with_shares(Eigen::Ref<const Eigen::VectorXd> change, Eigen::Index& at) const;
  Eigen::VectorXd shares_along(Eigen::Ref<const Eigen::VectorXd> change, Eigen::Index& at) const;

  std::vector<Balances> lives_;                                       // (planets), one where all are alike
  std::optional<Sharing> sharing_;                                    // of planets that load unevenly
  std::vector<std::vector<bearing::laminae::LaminaSlopes>> by_load_;  // [1/N]  (cage angles, bearings)
  double inner_share_ = 0.0, outer_share_ = 0.0;                      // [-]  of the damage
  double log_life_ = 0.0;                                             // [ln h]
};

}  // namespace orbearing::study
