// Film of a line contact that rolls: Reynolds' equation with elastic bodies, isothermal, by Newton's method
// on the whole of it.
#pragma once

#include <Eigen/Core>

#include "bearing/film/reynolds/oil.hpp"

namespace orbearing::bearing::film {

/// One unit of length of two cylinders.
struct LineFilmCase {
  double radius = 0.0;   // [m]   equivalent
  double modulus = 0.0;  // [Pa]  E/(1 - nu^2) for like bodies
  ReynoldsOil oil;
  double load = 0.0;     // [N/m]
  double rolling = 0.0;  // [m/s]  mean speed of both surfaces, > 0
  double sliding = 0.0;  // [m/s]  affects Eyring's oil only
};

struct LineFilmGrid {
  int cells = 384;  // [-]
  double inlet =
      0.0;  // [-]  half-widths of Hertz from the centre upstream; 0: 4, or as far as a light load needs
  double outlet = 0.0;  // [-]  0: 1.5, or more
  double shift = 0.0;   // [-]  of the contact against the grid, in cells
};

struct LineFilm {
  bool converged = false;
  int iterations = 0;
  double change = 0.0;      // [-]  of pressure in the last iteration, largest over Hertz's
  double load_error = 0.0;  // [-]
  double film_in_steps =
      0.0;  // [-]  central film over what a step of the grid takes off a parabola, b^2/R step^2
  double mass_error = 0.0;        // [-]  largest difference of the flow from its mean where there is pressure
  double central = 0.0;           // [m]
  double least = 0.0;             // [m]
  double flow = 0.0;              // [m]  oil that passes: a film without pressure at the rolling speed
  double rolling_traction = 0.0;  // [N/m]  by which the flow that pressure drives holds each surface back
  double inlet_beyond = 0.0;      // [N/m]  what a parabolic inlet beyond the domain would add to it
  double largest_pressure = 0.0;  // [Pa]
  double rupture = 0.0;           // [m]  where the oil begins to cavitate
  Eigen::ArrayXd x;               // [m]
  Eigen::ArrayXd pressure;        // [Pa]
  Eigen::ArrayXd film;            // [m]
  Eigen::ArrayXd fraction;        // [-]  of oil in the gap
};

/// Throws std::invalid_argument where the case has no meaning.
LineFilm solve_line_film(const LineFilmCase& contact, const LineFilmGrid& grid = {});

}  // namespace orbearing::bearing::film
