// Rings in equilibrium on the rollers between them: the outer ring of one bearing, or a planet on several;
// races rigid or elastic, contacts whole or cut into laminae, tilts stated or free. Eqs. (3), (4) and (14) to
// (16) of README.md.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "bearing/contact/race_contact.hpp"
#include "bearing/equilibrium/quasi_static_state.hpp"
#include "bearing/geometry.hpp"
#include "bearing/operating_point.hpp"
#include "mechanics/convex_search.hpp"

namespace orbearing::bearing {

namespace laminae {
class LaminaBearing;
}

/// Equilibrium problem of the races of one bearing at one cage angle. Arrays are over rollers.
struct RaceEquilibrium {
  RollerContacts contacts;
  double clearance = 0.0;                          // [m]    diametral
  Eigen::Vector2d load = Eigen::Vector2d::Zero();  // [N]  on the outer ring
  Eigen::ArrayXd angle = {};                       // [rad]
  Eigen::ArrayXd inertial_load = {};               // [N]    of each roller, outward positive
  Eigen::ArrayXd extra_approach = {};  // [m]    by unequal rollers and races that are not round; empty: none
  ElasticRace outer_race = {};         // how the outer race bends
  const laminae::LaminaBearing* cut = nullptr;  // laminae of the contacts, which outlive this; null: whole
  Eigen::ArrayXd end_displacement = {};         // [m]    of the outer race of laminae, by its stated tilt

  /// Approach of the races at roller `j` [m] when a rigid outer ring is displaced by `displacement` [m].
  double approach(Eigen::Index j, const Eigen::Vector2d& displacement) const;
  /// [N]  the largest of the forces in equilibrium
  double force_scale() const;
};

/// One row of rolling elements, by the coordinates of the rings. N may be Eigen::Dynamic.
template <int N>
struct SettlingRow {
  using Moves = Eigen::Matrix<double, N, Eigen::Dynamic>;

  /// Converges element `j` with the rings at `position` and adds its forces on them.
  void add(Eigen::Index j, const Eigen::Vector<double, N>& position, mechanics::Imbalance<N>& sum) const;

  laminae::Element element;         // what it refers to outlives the row
  Eigen::ArrayXd concentric;        // [m]  (elements)  approach where all coordinates are zero
  Eigen::ArrayXd inertial_load;     // [N]  (elements)  outward positive
  Eigen::ArrayXd end_displacement;  // [m]  (elements)  stated, of the outer race; empty: none
  Moves outward;                    // [-]  (coordinates, elements)  how far each moves the outer race outward
  Moves tilting;  // [-]  the same of its end beyond its middle; empty: no coordinate tilts it
  std::span<laminae::RollerState> rollers;  // start and result of their searches
};

/// The row of one cylindrical roller bearing. `races` and `rollers` outlive it.
template <int N>
SettlingRow<N> row_of(const RaceEquilibrium& races, typename SettlingRow<N>::Moves outward,
                      std::vector<laminae::RollerState>& rollers);

/// Forces on the coordinates of the rings: those of the rollers, and load - stiffness (position - rest). A
/// single rigid ring (N = 2) has no stiffness but its rollers'.
template <int N>
struct RingsOnRollers {
  using Position = Eigen::Vector<double, N>;

  mechanics::Imbalance<N> operator()(const Position& position) const;

  Position load;                          // [N]
  Eigen::Matrix<double, N, N> stiffness;  // [N/m]  without rollers
  Position rest;                          // [m]
  double scale = 0.0;                     // [N]  the largest of the forces in equilibrium
  std::vector<SettlingRow<N>> rows;
};

/// The outer ring of one bearing whose tilt is stated. Coordinates: displacement along x and y, then the
/// waves of an elastic race (elastic_waves.hpp). N = 2 where it is rigid, else Eigen::Dynamic.
template <int N>
RingsOnRollers<N> ring_on_rollers(const RaceEquilibrium& races, std::vector<laminae::RollerState>& rollers);

extern template struct SettlingRow<2>;
extern template struct SettlingRow<5>;
extern template struct SettlingRow<Eigen::Dynamic>;
extern template struct RingsOnRollers<2>;
extern template struct RingsOnRollers<5>;
extern template struct RingsOnRollers<Eigen::Dynamic>;

/// Start of a search for the displacement of the races, with the rollers under the load in contact, and
/// limits of the search.
Eigen::Vector2d first_displacement(const RaceEquilibrium& problem);
mechanics::SearchLimits search_limits(const RaceEquilibrium& problem);

/// Stores angles, loads and moment of the rollers of an equilibrium.
void put_rollers(const RaceEquilibrium& problem, std::vector<laminae::RollerState> rollers,
                 QuasiStaticState& state);

/// Displacement, and waves of the outer race, at static equilibrium of the outer ring. The search starts from
/// the position of the ring in `near`, if one is given: the equilibrium of the same bearing under another
/// load or at another cage angle.
QuasiStaticState solve(const RaceEquilibrium& problem, const QuasiStaticState* near = nullptr);

}  // namespace orbearing::bearing
