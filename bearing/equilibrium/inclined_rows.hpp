// A planet on rows of rollers or balls whose contacts are inclined: tapered roller bearings in pairs,
// spherical roller bearings, deep groove balls (contact angle 0). Contacts are dry and keep their angle, and
// whole but of tapered rollers with laminae. Inertial loads are those of the carrier's frame. Eqs. (17) to
// (21) of README.md.
//
//        r ^       n = (cos a, s sin a): normal of the outer race, from the element outward
//          |     / n    a: contact angle, s = +1 or -1
//          |    o       element j at angle theta_j in the plane across the axis, on the pitch circle
//          |   /
//     -----+--*----------> z    pressure centre: where n meets the axis
//
// Coordinates of the outer races, which the planet moves together: displacement (x, y, z) and the tilt times
// a lever; the planet's axis runs along (tilt_x, tilt_y, 1).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "bearing/contact/point_contact.hpp"
#include "bearing/contact/race_contact.hpp"
#include "bearing/equilibrium/loads_by_position.hpp"
#include "bearing/equilibrium/quasi_static_state.hpp"
#include "bearing/equilibrium/race_equilibrium.hpp"
#include "bearing/equilibrium/roller_balance.hpp"
#include "bearing/equilibrium/tilted_roller.hpp"
#include "bearing/geometry.hpp"
#include "bearing/operating_point.hpp"
#include "bearing/parameters.hpp"
#include "bearing/planet_rows.hpp"
#include "mechanics/convex_search.hpp"

namespace orbearing::bearing {

/// Both contacts of a tapered roller cut into laminae, counted along the axis.
struct LaminatedContacts {
  laminae::LaminaContact inner, outer;
};

/// One row.
struct InclinedRow {
  WholeElement contacts;                   // whole
  std::optional<LaminatedContacts> cut{};  // what counts instead, where it is given
  int count = 0;
  double contact_angle = 0.0;    // [rad]  of the outer race
  double taper = 0.0;            // [rad]  between the normals of both races
  double side = 1.0;             // +1 or -1: s
  double pressure_centre = 0.0;  // [m]    from the middle of the face
  double approach = 0.0;         // [m]    along the normal without displacement: preload; clearance negative
  double element_mass = 0.0;     // [kg]
  double pitch_radius = 0.0;     // [m]
  double slenderness = 0.0;      // [-]    D cos(a)/d_m
  int bearing = 0;               // whose row it is, from 0
};

/// Angle between the normals of both races of a tapered roller [rad], whose races and axis meet in one point
/// of the bearing's axis: twice nu of sin(nu) = D/d_m sin(a - nu), D across the races.
double taper_of(double element_diameter, double pitch_diameter, double contact_angle);

/// Geometry of one bearing: races meet the rollers at the contact angle; each row has a cage like the stated
/// one.
BearingGeometry geometry_of(const Bearing& bearing, const PlanetRows& rows);

/// Rows of all bearings of a planet whose middles are at `positions` [m] along the axis; of a tapered pair in
/// the order of the axis. Throws std::invalid_argument where the elements do not fit the type, and for a
/// tapered bearing without its partner.
std::vector<InclinedRow> inclined_rows(const Bearing& bearing, const PlanetRows& rows,
                                       const std::vector<double>& positions);

/// Load on the planet in the middle of its face, with what reaches it through cages.
struct PlanetLoad {
  Eigen::Vector2d force = Eigen::Vector2d::Zero();   // [N]
  double axial = 0.0;                                // [N]
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // [N m]  conjugate to the tilt
};

/// The equilibrium at one position of the elements.
struct InclinedState {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]    of the planet, in the middle of its face
  double axial = 0.0;                                      // [m]
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();          // [rad]
  std::vector<Eigen::ArrayXd> inner_load, outer_load;      // [N]    (rows) (elements)
  std::vector<laminae::RollerState> rollers;               // row by row; of whole contacts loads only
  /// By displacement (x, y, z) and tilt: [N/m], [N/rad], [N m/rad].
  Eigen::Matrix<double, 5, 5> stiffness = Eigen::Matrix<double, 5, 5>::Zero();
  SolverReport report;
};

/// The problem of one planet. Freedoms that no row resists keep zero: the axial one of contact angles of 0,
/// the tilt of rows that share one pressure centre.
class InclinedPlanet {
 public:
  using Position = Eigen::Vector<double, 5>;  // [m]  tilts times lever()

  /// `point`: motion of carrier and races; its load has no effect here. Throws std::invalid_argument where
  /// there are no rows or the motion is not finite.
  InclinedPlanet(std::vector<InclinedRow> rows, const OperatingPoint& point, const InertiaSwitches& inertia);

  const std::vector<InclinedRow>& rows() const { return rows_; }
  double lever() const { return lever_; }  // [m]
  bool holds_axially() const { return axial_; }
  bool holds_tilt() const { return tilt_; }

  /// Balance with the first elements of all rows at `first_element` [rad].
  InclinedState balance(const PlanetLoad& load, double first_element,
                        const InclinedState* near = nullptr) const;

  /// Forces of the elements on the planet by its position, with their slopes.
  mechanics::Imbalance<5> forces(const Position& position, double first_element) const;

  /// Inertial load of an element at `angle`, along the radius [N].
  double inertial_load(const InclinedRow& row, double angle) const;

 private:
  Position moves(const InclinedRow& row, double angle) const;
  Position tilts(const InclinedRow& row, double angle) const;
  double along_inner_normal(const InclinedRow& row, double angle) const;
  std::vector<laminae::RollerState> elements() const;
  SettlingRow<5> row_at(const InclinedRow& row, double first_element,
                        std::span<laminae::RollerState> elements) const;
  /// All rows by the coordinates of the planet, without a load. `elements` are start and result of their
  /// searches.
  RingsOnRollers<5> rings(double first_element, std::span<laminae::RollerState> elements) const;

  std::vector<InclinedRow> rows_;
  OperatingPoint point_;
  InertiaSwitches inertia_;
  double lever_ = 0.0;
  bool axial_ = false;
  bool tilt_ = false;
};

/// Loads of one row over a pitch of cage angles, tilts outward at the end along +z, and the mean load of the
/// row on the planet.
struct InclinedRowLoads : LoadsByPosition {
  Eigen::ArrayXd rib_load;                           // [N]  of tapered rollers on the inner ring's rib
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();  // [N m]  of the laminae, conjugate to the planet's tilt
  Eigen::Vector2d radial = Eigen::Vector2d::Zero();  // [N]
  double axial = 0.0;                                // [N]  magnitude along the axis, induced by the angle
};

struct InclinedResult {
  Eigen::ArrayXd angle;  // [rad]
  std::vector<InclinedRowLoads> rows;
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();  // [rad]  mean
  SolverReport report;                             // the worst over the cage angles
};

/// Balances at `cage_positions` angles over one pitch; all rows have as many elements.
InclinedResult inclined_planet_over_a_pitch(const InclinedPlanet& planet, const PlanetLoad& load,
                                            int cage_positions);

}  // namespace orbearing::bearing
