// One grid of the film of a point contact: its equations without dimensions, their relaxation and, on the
// coarsest grid, their solution.
//
// Lengths along the surface are in units of a, the contact's half-width along the rolling, films in a^2/R, R
// the radius of curvature along the rolling, pressures in Hertz's largest one, speeds in the rolling speed:
//
//     d/dX(e dP/dX) + d/dY(e dP/dY) - d/dX(U r H) - d/dY(V r H) = 0,   e = r H^3/(n L),   L = 12 eta_0 u
//     R^2/(a^3 p) H = H_0 + S(X, Y) + C * integral of P/distance,   C = 2 R p/(pi E' a),   integral of P = W
#pragma once

#include <array>
#include <vector>

#include "bearing/film/reynolds/half_space.hpp"
#include "bearing/film/reynolds/oil.hpp"

namespace orbearing::bearing::film {

/// The contact without dimensions.
struct PointFilmNumbers {
  double pressure = 0.0;                                              // [Pa]  unit of pressure
  double diffusion = 0.0;                                             // [-]   1/L
  double compliance = 0.0;                                            // [-]   C
  double load = 0.0;                                                  // [-]   W
  double curvature_xx = 1.0, curvature_xy = 0.0, curvature_yy = 0.0;  // [-]
  double spin = 0.0;     // [-]  half the spin times a over the rolling speed
  double sliding = 0.0;  // [-]  along the rolling, over the rolling speed
  double shear =
      0.0;  // [-]  viscosity x rolling speed over the unit of film and Eyring's stress; 0: Newtonian
  ReynoldsOil oil;

  double gap(double x, double y) const {
    return 0.5 * curvature_xx * x * x + curvature_xy * x * y + 0.5 * curvature_yy * y * y;
  }
};

/// Applied share of a computed change, and the range in which changes are those of single nodes. Lines change
/// one after the other with films that do not yet include each other's changes: those of many lines add up,
/// above all where contacts are long across, and more than about 0.7 of single changes overshoots then.
struct Relaxation {
  double single = 0.5;
  double dipole = 0.6;
  double diffusive = 2.0;  // diffusion over wedge from which changes are single
};

/// Rectangle of nodes.
struct PointFilmDomain {
  Eigen::Index nx = 0, ny = 0;  // cells
  double x = 0.0, y = 0.0;      // [-]  first node
  double hx = 0.0, hy = 0.0;    // [-]

  double x_at(Eigen::Index i) const { return x + static_cast<double>(i) * hx; }
  double y_at(Eigen::Index j) const { return y + static_cast<double>(j) * hy; }
};

class PointFilmLevel {
 public:
  PointFilmLevel(const PointFilmNumbers& numbers, const PointFilmDomain& domain);

  const PointFilmDomain& domain() const { return domain_; }
  double cell() const { return domain_.hx * domain_.hy; }

  Field pressure;     // P
  Field film;         // H
  Field source;       // right-hand side of Reynolds' equation
  Field film_source;  // what H has besides its own sum
  double load = 0.0;  // W, with what finer grids add
  Relaxation relaxation;
  double ease = 1.0;     // on the diffusion of pressure: below 1 the film is that of a higher speed
  Field fraction;        // of oil in the gap: 1 where it is full
  bool starved = false;  // whether that share has an effect

  /// C times the sum of the pressures.
  void deform(const Field& pressures, Field& deformation) const;
  /// H of the pressures at H_0 `rigid`.
  void update_film(double rigid);
  double load_of(const Field& pressures) const { return pressures.sum() * cell(); }

  /// Right-hand side less left-hand side. Where there is no pressure it is positive: the gap opens.
  void residual(Field& into);
  /// One sweep over all lines; films are those of the new pressures.
  void relax(double rigid);
  /// Newton's method on the whole grid, with H_0. Returns the last change of pressure, mean over mean.
  double solve(double& rigid, int most, double enough);
  /// Share of oil where there is no pressure, carried along by the surfaces; it is included from then on.
  /// After [ElrodAdams1975]: oil has a pressure or a share below 1, and its mass is conserved in both.
  void carry_oil();
  /// Mass errors of the oil that passes the middle of the contact: by Reynolds' equation where it holds, and
  /// everywhere once the shares of oil are known.
  struct Balance {
    double residual = 0.0;
    double lost = 0.0;
  };
  Balance balance();

 private:
  // Nodes that the film acts on: the node itself, two on each side along x, two on each side along y.
  static constexpr int kNodes = 9;
  static constexpr std::array<int, kNodes> kAlong{0, -2, -1, 1, 2, 0, 0, 0, 0};
  static constexpr std::array<int, kNodes> kAcross{0, 0, 0, 0, 0, -2, -1, 1, 2};
  static constexpr Eigen::Index kBand = 6;  // half-width of the lines' matrices

  struct Row {
    double value = 0.0;                    // source less the equation's left-hand side
    double diffusion = 0.0;                // sum of the faces' coefficients along x
    std::array<double, kNodes> by_film{};  // of the left-hand side
    std::array<double, kNodes> by_pressure{};
  };

  void properties();
  double own_share(Eigen::Index i, Eigen::Index j) const;
  Row row(Eigen::Index i, Eigen::Index j) const;
  double velocity_x(double y) const { return 1.0 + numbers_.spin * y; }
  double velocity_y(double x) const { return -numbers_.spin * x; }
  void relax_line(Eigen::Index j, Field& dipoles);

  const PointFilmNumbers numbers_;
  PointFilmDomain domain_;
  OilUnderPressure oil_;
  HalfSpacePotential potential_;
  Field gap_;
  Field along_, across_;              // e in both directions
  Field along_slope_, across_slope_;  // d ln e / dP
  Field along_power_, across_power_;  // d ln e / d ln H
  Field density_, density_slope_;
  std::vector<double> stream_x_, stream_y_;  // U of each line, V of each column
  double dipole_x_ = 0.0, dipole_y_ = 0.0;   // shares of a dipole's neighbours
  Field single_, dipole_;                    // influence of a change, as one node's and as a dipole's
  // Work.
  std::vector<Row> rows_;
  std::vector<char> as_dipole_;
  std::vector<double> matrix_, right_;
};

}  // namespace orbearing::bearing::film
