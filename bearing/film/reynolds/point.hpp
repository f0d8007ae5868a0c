// Film of an elliptical contact that rolls in any direction and spins: Reynolds' equation with elastic
// bodies, isothermal, by full multigrid.
#pragma once

#include <string>

#include "bearing/film/reynolds/half_space.hpp"
#include "bearing/film/reynolds/oil.hpp"

namespace orbearing::bearing::film {

/// Bodies, load and motion of one contact. x and y are the axes of its ellipse.
struct PointFilmCase {
  double curvature_x = 0.0;  // [1/m]  sum of both bodies' in the plane of x
  double curvature_y = 0.0;  // [1/m]
  double modulus = 0.0;      // [Pa]   E/(1 - nu^2) for like bodies
  ReynoldsOil oil;
  double load = 0.0;     // [N]
  double rolling = 0.0;  // [m/s]    mean speed of both surfaces, > 0
  double angle = 0.0;    // [rad]    of that speed from x towards y
  double spin = 0.0;     // [rad/s]  of one surface against the other: v = rolling + spin/2 (y, -x), Eq. (3)
  double sliding = 0.0;  // [m/s]    along the rolling; affects Eyring's oil only
};

/// Curvatures of an ellipse of `ellipticity` (axis along y over that along x, any > 0) whose radius in the
/// plane of x is `rolling_radius` [m]: Hertz's relation, without an approximation.
void set_ellipse(PointFilmCase& contact, double rolling_radius, double ellipticity);

/// Grid and domain; lengths in units of the semi-axes along and across the rolling.
struct PointFilmGrid {
  int along = 128;       // [-]  cells along the rolling: a power of two of at least 32
  int across = 128;      // [-]
  double inlet = 0.0;    // [-]  from the centre upstream; 0: 4.5, or as far as the film of a light load needs
  double outlet = 0.0;   // [-]  0: 1.5, or more
  double side = 0.0;     // [-]  0: 1.5 half-widths beyond the contact, or more
  double shift_x = 0.0;  // [-]  of the contact against the grid, in cells
  double shift_y = 0.0;  // [-]
  int cycles = 60;       // [-]  at most, on the finest grid, all attempts together
  double tolerance = 1e-5;  // [-]  of load, of the change of pressure in a cycle and of the residual
};

struct PointFilm {
  bool converged = false;
  int cycles = 0;           // on the finest grid, all attempts together
  double load_error = 0.0;  // [-]
  double change = 0.0;      // [-]  of pressure in the last cycle, mean over mean
  double residual = 0.0;    // [-]  what Reynolds' equation leaves, over the oil through the contact
  double central = 0.0;     // [m]
  double least = 0.0;       // [m]
  double least_x = 0.0;     // [m]  where that is, in the contact's axes
  double least_y = 0.0;     // [m]
  double approach = 0.0;    // [m]  of the rigid bodies: elastic deformation at the centre less film, Eq. (1)
  double largest_pressure = 0.0;  // [Pa]
  double mass_error = 0.0;  // [-]  of the oil through the contact: what is not kept, cavitated parts with it
  // Nodes: x along the rolling, y across it, both from the contact's centre.
  Eigen::ArrayXd x, y;  // [m]
  Field pressure;       // [Pa]
  Field film;           // [m]
  Field fraction;       // [-]  of oil in the gap: below 1 where it is cavitated
};

/// Throws std::invalid_argument where the case or the grid has no meaning.
PointFilm solve_point_film(const PointFilmCase& contact, const PointFilmGrid& grid = {});

}  // namespace orbearing::bearing::film
