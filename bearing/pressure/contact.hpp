// Normal contact of a finite roller with a race as elastic half-spaces: what is stated and what comes out.
//
//            pressure p(x, y)              x: along the roller from its middle, -l/2 to l/2
//        .-''''''''''''''''''''-.          y: across, the way of rolling
//   -----+----------|-----------+-----> x  approach(x) = approach + tilt x - relief(x) - y^2/(2 R)
//      -l/2         0          l/2         tilt > 0 closes the contact at x > 0
#pragma once

#include <Eigen/Dense>
#include <functional>

#include "bearing/parameters.hpp"

namespace orbearing::bearing::half_space {

/// Ends of a body at x = +-l/2.
enum class EndSurface {
  continuing,  // the body goes on: a half-space, as a race longer than the roller
  mirrored,    // free of shear: the pressure mirrored at the end acts as well [Mul1986]
  corrected,   // the mirrored pressure times a factor for the normal stress it leaves there [Guilbault2011]
};

/// A roller on a race.
struct HalfSpaceContact {
  double length = 0.0;             // [m]  l, of the contact at most
  double equivalent_radius = 0.0;  // [m]  R across: convex on the inner race, concave on the outer
  Material roller;
  Material race;
  EndSurface roller_ends = EndSurface::corrected;
  EndSurface race_ends = EndSurface::continuing;
};

/// Sum of the drops of both bodies [m] at x [m] from the middle.
using Relief = std::function<double(double)>;

/// Solution along the roller; arrays over the elements of the length.
struct RollerContactPressure {
  Eigen::ArrayXd x;            // [m]    middles of the elements
  Eigen::ArrayXd element;      // [m]    their lengths
  Eigen::ArrayXd line_load;    // [N/m]  q
  Eigen::ArrayXd half_width;   // [m]    b of the semi-ellipse across with the same load and second moment
  Eigen::ArrayXd pressure;     // [Pa]   along the middle, y = 0
  double load = 0.0;           // [N]
  double approach = 0.0;       // [m]    of the bodies at x = 0; holds the far field of the half-spaces
  double tilt = 0.0;           // [rad]
  double moment = 0.0;         // [N m]  integral of q x: positive where x > 0 carries more
  double energy = 0.0;         // [J]    strain energy: d(energy)/d(approach) = load, /d(tilt) = moment
  double peak_pressure = 0.0;  // [Pa]  greatest mean of `pressure` over l/100, anywhere
  double edge_pressure = 0.0;  // [Pa]  the same, within l/10 of an end
  double edge_ratio = 0.0;     // [-]   edge_pressure over the pressure at x = 0
  double element_peak = 0.0;   // [Pa]  greatest in one element: grows without bound at a sharp corner
  int iterations = 0;          // [-]
  double residual = 0.0;       // [-]   what the solver's criterion came to; see there
};

/// Pressure on all rectangles of the plane grid.
struct RollerContactMap {
  RollerContactPressure along;
  Eigen::ArrayXd y;          // [m]   middles of the rows, from 0 outwards; the contact is symmetric in y
  Eigen::ArrayXXd pressure;  // [Pa]  (elements of the length, rows)
};

// Elements along the roller, finer towards the ends.

/// Elements of the length, from -l/2 to l/2, symmetric to the middle.
struct LengthGrid {
  Eigen::ArrayXd edge;    // [m]  (elements + 1)
  Eigen::ArrayXd middle;  // [m]
  Eigen::ArrayXd size;    // [m]
};

/// `elements` of them at x = l/2 [(1 - g) s + g sin(pi s/2)], s even from -1 to 1. With `grading` g = 0 all
/// are equal; the default makes those at the ends about a twelfth of those in the middle.
LengthGrid graded_grid(double length, int elements, double grading = 0.92);

/// Means of `relief` over the elements [m], by Gauss' rule with five points.
Eigen::ArrayXd mean_relief(const LengthGrid& grid, const Relief& relief);

// Constants of two elastic half-spaces in contact, one or both of which may end.

/// E* [Pa]: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2. [Johnson1985]
double contact_modulus(const HalfSpaceContact& contact);

/// Factor psi [-] of the mirrored pressure of one body: 0 continuing, 1 mirrored, and for a corrected end
/// 1.29 - (0.08 - 0.5 nu)/(1 - nu), which makes up for the normal stress that the mirrored pressure leaves
/// on the end. [Guilbault2011]
double mirror_factor(EndSurface ends, double poisson_ratio);

/// Factor [-] of the mirrored pressure in the sum of both bodies' displacements: their factors weighted by
/// their compliances.
double mirror_factor(const HalfSpaceContact& contact);

/// Throws std::invalid_argument where `contact` has no meaning.
void require_sound(const HalfSpaceContact& contact);

}  // namespace orbearing::bearing::half_space
