// How the lamina loads of a balance follow any number that goes into it: forward differentiation through the
// laws of contacts and films, and the implicit function theorem for what settles. Eqs. (17) to (20) of
// README.md.
//
// A balance is one of rollers between two races, each race at a place that is linear in the coordinates z of
// the rings:
//
//     approach and end displacement of the races at roller j = c_j - G_j^T z
//     0 = r(z) + sum over rollers G_j (Q_o, M_o)
//
// A contact that is not cut is one lamina without drop.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

#include "bearing/contact/film.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"

namespace orbearing::bearing::laminae {

/// A film's law at one speed; meaningless where there is none.
struct FilmNumbers {
  double log_factor = 0.0;    // [ln(m N^0.13)]
  double log_cap_load = 0.0;  // [ln N]  at 1 m/s
  double log_speed = 0.0;     // [ln(m/s)]
};

/// The numbers of one bearing at one cage angle from which its balance follows, with the rings where they
/// stand: also a change of them, by whatever unit.
struct RowNumbers {
  double log_stiffness = 0.0;  // [ln(N/m^(10/9))]  of each whole contact
  FilmNumbers inner_film, outer_film;
  Eigen::ArrayXd inner_drop, outer_drop;  // [m]  (laminae)
  Eigen::ArrayXd approach;                // [m]  (rollers)  of the races in the middle
  Eigen::ArrayXd end_displacement;        // [m]  (rollers)  how much more they have come closer at x = l/2
  Eigen::ArrayXd inertial_load;           // [N]  (rollers)  outward
  Eigen::MatrixXd
      moves;  // [-]  (coordinates, 2 rollers)  G_j: by approach and by end displacement, outward positive
};

/// All of them, of the bearings that balance together at one cage angle.
struct BalanceNumbers {
  std::vector<RowNumbers> rows;
  Eigen::VectorXd rest;  // [N]  (coordinates)  r: forces on the rings but for those of rollers
};

/// Calls `visit(double* first, Eigen::Index size)` for each part, in the same order for all balances of a
/// shape.
template <class Visit>
void each_number(BalanceNumbers& numbers, Visit&& visit) {
  for (RowNumbers& row : numbers.rows) {
    visit(&row.log_stiffness, Eigen::Index{1});
    for (FilmNumbers* film : {&row.inner_film, &row.outer_film})
      for (double* one : {&film->log_factor, &film->log_cap_load, &film->log_speed})
        visit(one, Eigen::Index{1});
    for (Eigen::ArrayXd* all :
         {&row.inner_drop, &row.outer_drop, &row.approach, &row.end_displacement, &row.inertial_load})
      visit(all->data(), all->size());
    visit(row.moves.data(), row.moves.size());
  }
  visit(numbers.rest.data(), numbers.rest.size());
}

/// What a balance is computed from, with the rings where they stand.
struct BalanceSetting {
  BalanceNumbers numbers;
  std::vector<RollerContacts> contacts;  // (bearings)
  Eigen::MatrixXd rest_stiffness;        // [N/m]  -dr/dz
};

/// Of one bearing whose ring stands at `place` of its coordinates: displacement, then waves of an elastic
/// race. Whole contacts where the bearing has no laminae.
BalanceSetting ring_setting(const Bearing& bearing, const RaceEquilibrium& problem,
                            const OperatingPoint& point, const Eigen::VectorXd& place);

/// What drops and laws of one bearing are: all of RowNumbers but what the place of its rings decides.
RowNumbers row_numbers(const Bearing& bearing, const RollerContacts& contacts);

/// Where one contact stands in a balance.
struct ContactPlace {
  double approach = 0.0;  // [m]  elastic, in the middle
  double end_displacement = 0.0;  // [m]  by how much more at x = l/2
};
struct RollerPlace {
  ContactPlace inner, outer;
};
/// Of rollers that settled: on laminae, and on whole contacts under their loads.
std::vector<RollerPlace> roller_places(const LaminaState& state);
std::vector<RollerPlace> roller_places(const RaceEquilibrium& problem, const QuasiStaticState& state);

/// Loads of the laminae of one bearing, or their slopes.
struct LaminaSlopes {
  Eigen::ArrayXXd inner;  // [N] or [N per unit]  (laminae, rollers)
  Eigen::ArrayXXd outer;
};

/// A balance at one cage angle with all that does not depend on what is changed.
class BalanceSlopes {
 public:
  /// @param setting at the balance
  /// @param places of the rollers of each bearing
  BalanceSlopes(BalanceSetting setting, const std::vector<std::vector<RollerPlace>>& places);

  const BalanceNumbers& numbers() const { return numbers_; }
  /// Loads of each bearing.
  std::vector<LaminaSlopes> loads() const;
  /// Slopes of the loads of each bearing as the numbers change by `change` a unit.
  std::vector<LaminaSlopes> along(const BalanceNumbers& change) const;
  /// The same of the coordinates of the rings [m per unit].
  Eigen::VectorXd rings_along(const BalanceNumbers& change) const;

  /// One contact at its balance.
  struct Contact {
    Eigen::ArrayXd approach;                              // [m]    (laminae)  positive where it carries
    Eigen::ArrayXd load;                                  // [N]    (laminae)
    Eigen::ArrayXd slope;                                 // [N/m]  (laminae)
    Eigen::ArrayXd station;                               // [-]    (laminae)  fractions of half the length
    Eigen::Vector2d force = Eigen::Vector2d::Zero();      // [N]    load and end load
    Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  // [N/m]
    double film_slope = 0.0;                              // [m/N]  of the central film by the load
    bool oiled = false;
  };

 private:
  struct Roller {
    Contact inner, outer;
    double scale = 0.0;  // [N/m]  0: nothing touches
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix4d> system;
    // Both places by approach and end displacement of the races, and the outer force [N/m] by them.
    Eigen::Matrix<double, 4, 2> by_races = Eigen::Matrix<double, 4, 2>::Zero();
    Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
  };
  static Roller roller_at(Contact inner, Contact outer);

  struct Settling;  // how one roller follows a change between races that stand

  Eigen::VectorXd rings_along(const BalanceNumbers& change,
                              std::vector<std::vector<Settling>>& settled) const;
  Settling settling(const Roller& roller, const RowNumbers& row, const RowNumbers& change,
                    Eigen::Index j) const;

  BalanceNumbers numbers_;
  std::vector<std::vector<Roller>> rollers_;  // (bearings, rollers)
  Eigen::LDLT<Eigen::MatrixXd> stiffness_;    // of the rings
};

}  // namespace orbearing::bearing::laminae
