// Without dimensions, X = x/b, P = p/p_h, H = h R/b^2:
//
//     d/dX(e dP/dX) = d(r H)/dX,   e = r H^3/(n L),   L = 12 eta_0 u R^2/(b^3 p_h)
//     H = H_0 + X^2/2 - 1/pi * integral of P ln|X - S| dS,   integral of P = pi/2
#include "bearing/film/reynolds/line.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mechanics/cancellation.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::bearing::film {

namespace {

using Eigen::Index;
using std::numbers::pi;

constexpr double kLeastLineFilm = 1e-7;  // below it a film of an unfinished solution counts as this

// Integral of ln|x - s| over a cell of width h about s, x away.
double line_potential(double x, double h) {
  const auto part = [](double t) { return t == 0.0 ? 0.0 : t * std::log(std::abs(t)) - t; };
  return part(x + 0.5 * h) - part(x - 0.5 * h);
}

class LineFilmEquations {
 public:
  LineFilmEquations(const LineFilmCase& contact, double half_width, double pressure, double x, double step,
                    Index cells, double wide)
      : contact_(contact), oil_(contact.oil), pressure_(pressure), step_(step), n_(cells) {
    const double r = contact.radius;
    unit_film_ = half_width * half_width / r;
    diffusion_ = half_width * half_width * half_width * pressure /
                 (12.0 * contact.oil.viscosity * contact.rolling * r * r);
    X = Eigen::ArrayXd::LinSpaced(n_ + 1, x, x + step * static_cast<double>(cells));
    kernel_.resize(n_ + 1);
    for (Index k = 0; k <= n_; ++k) kernel_[k] = -line_potential(static_cast<double>(k) * step, step) / pi;
    P = (1.0 - (X / wide).square()).max(0.0).sqrt();
    P[0] = P[n_] = 0.0;
    P *= 0.5 * pi / (P.sum() * step_);
    for (Eigen::ArrayXd* one : {&e_, &e_slope_, &e_power_, &density_, &density_slope_}) one->resize(n_ + 1);
  }

  double influence(Index i, Index k) const { return kernel_[std::abs(i - k)]; }

  void update_film() {
    H = rigid + 0.5 * X.square();
    for (Index k = 1; k < n_; ++k)
      if (P[k] != 0.0)
        for (Index i = 0; i <= n_; ++i) H[i] += influence(i, k) * P[k];
  }

  void properties() {
    for (Index i = 0; i <= n_; ++i) {
      const OilState oil = oil_.at(pressure_ * P[i]);
      const double h = std::max(H[i], kLeastLineFilm);
      EyringFlow flow;
      if (contact_.oil.eyring_stress > 0.0)
        flow = eyring_flow(contact_.oil.viscosity * oil.viscosity * std::abs(contact_.sliding) /
                           (unit_film_ * h * contact_.oil.eyring_stress));
      density_[i] = oil.density;
      density_slope_[i] = oil.density_slope * pressure_;
      e_[i] = oil.density * h * h * h / oil.viscosity * diffusion_ * flow.along;
      e_power_[i] = 3.0 - flow.along_power;
      e_slope_[i] =
          (oil.density_slope / oil.density - (1.0 - flow.along_power) * oil.viscosity_log_slope) * pressure_;
    }
  }

  // Flow through the face between i and i + 1: pressure's less the surfaces'.
  double flow(Index i) const {
    const auto oil = [&](Index k) { return density_[k] * H[k]; };
    const double carried = i > 0 ? 1.5 * oil(i) - 0.5 * oil(i - 1) : 0.5 * (oil(0) + oil(1));
    return 0.5 * (e_[i] + e_[i + 1]) * (P[i + 1] - P[i]) / step_ - carried;
  }

  // Newton's method; the last change of pressure.
  double solve(int most, double enough, int& iterations) {
    double change = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < most && change > enough; ++iteration, ++iterations) {
      throw_if_stopped();
      update_film();
      properties();
      std::vector<Index> open;
      for (Index i = 1; i < n_; ++i)
        if (P[i] > 0.0 || flow(i) - flow(i - 1) > 0.0) open.push_back(i);
      const Index n = static_cast<Index>(open.size());
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
      Eigen::VectorXd right(n + 1);
      for (Index k = 0; k < n; ++k) {
        const Index i = open[static_cast<std::size_t>(k)];
        right[k] = flow(i - 1) - flow(i);
        // By films and pressures of the nodes i - 2 to i + 1.
        std::array<double, 4> by_film{}, by_pressure{};
        const auto face = [&](Index left, double sign) {
          const Index at = left - i + 2;
          const double drop = (P[left + 1] - P[left]) / step_, mean = 0.5 * (e_[left] + e_[left + 1]) / step_;
          const auto put = [&](Index m, double film, double pressure) {
            by_film[static_cast<std::size_t>(m)] += sign * film;
            by_pressure[static_cast<std::size_t>(m)] += sign * pressure;
          };
          for (const Index one : {left, left + 1}) {
            const double by_h = H[one] > kLeastLineFilm ? e_power_[one] / H[one] : 0.0;
            put(one - i + 2, 0.5 * e_[one] * by_h * drop, 0.5 * e_[one] * e_slope_[one] * drop);
          }
          put(at, 0.0, -mean);
          put(at + 1, 0.0, mean);
          const auto carry = [&](Index node, double share) {
            put(node - i + 2, -share * density_[node], -share * density_slope_[node] * H[node]);
          };
          carry(left, left > 0 ? 1.5 : 0.5);
          if (left > 0)
            carry(left - 1, -0.5);
          else
            carry(1, 0.5);
        };
        face(i, 1.0);
        face(i - 1, -1.0);
        for (Index m = 0; m < 4; ++m) {
          const Index node = i - 2 + m;
          const double film = by_film[static_cast<std::size_t>(m)];
          if (node < 0) continue;
          for (Index c = 0; c < n; ++c) {
            const Index other = open[static_cast<std::size_t>(c)];
            matrix(k, c) += film * influence(node, other);
            if (other == node) matrix(k, c) += by_pressure[static_cast<std::size_t>(m)];
          }
          matrix(k, n) += film;
        }
        matrix(n, k) = step_;
      }
      right[n] = 0.5 * pi - P.sum() * step_;
      const Eigen::VectorXd move = mechanics::solution(matrix, right);
      if (n == 0 || !move.allFinite()) return std::numeric_limits<double>::infinity();
      const double share = std::min(1.0, 0.3 / std::max(move.head(n).cwiseAbs().maxCoeff(), 1e-300));
      change = 0.0;
      for (Index k = 0; k < n; ++k) {
        double& p = P[open[static_cast<std::size_t>(k)]];
        const double next = std::max(0.0, p + share * move[k]);
        change = std::max(change, std::abs(next - p));
        p = next;
      }
      rigid += share * move[n];
    }
    update_film();
    properties();
    return change;
  }

  // Share of oil in the gap without pressure: the flow that left the film, over the gap.
  Eigen::ArrayXd fraction() const {
    Eigen::ArrayXd share = Eigen::ArrayXd::Ones(n_ + 1);
    Index last = n_;
    while (last > 0 && P[last] <= 0.0) --last;
    const double through = -flow(last);
    for (Index i = last + 1; i <= n_; ++i) share[i] = std::min(1.0, through / (density_[i] * H[i]));
    return share;
  }

  Eigen::ArrayXd X, P, H;
  double rigid = 0.0;

  double unit_film() const { return unit_film_; }
  Index cells() const { return n_; }

 private:
  const LineFilmCase contact_;
  OilUnderPressure oil_;
  double pressure_, step_, unit_film_ = 0.0, diffusion_ = 0.0;
  Index n_;
  Eigen::ArrayXd kernel_, e_, e_slope_, e_power_, density_, density_slope_;
};

}  // namespace

LineFilm solve_line_film(const LineFilmCase& contact, const LineFilmGrid& grid) {
  mechanics::require(contact.load > 0.0, "load of a film [N/m]", contact.load, "positive");
  mechanics::require(contact.rolling > 0.0, "rolling speed of a film [m/s]", contact.rolling, "positive");
  mechanics::require(grid.cells >= 32, "cells of a film's grid [-]", grid.cells, "at least 32");
  const double r = contact.radius;
  const double half_width = std::sqrt(8.0 * contact.load * r / (pi * contact.modulus));
  const double pressure = contact.modulus * half_width / (4.0 * r);
  // Film to expect: that of [DowsonHigginson1966] or of rigid cylinders, whichever is larger.
  const double u = contact.oil.viscosity * contact.rolling / (contact.modulus * r);
  const double g = std::max(contact.oil.pressure_viscosity * contact.modulus, 100.0);
  const double w = contact.load / (contact.modulus * r);
  const double unit = half_width * half_width / (r * r);
  const double expected =
      std::max(3.53 * std::pow(u, 0.7) * std::pow(g, 0.54) * std::pow(w, -0.13), 4.9 * u / w) / unit;
  const double far = std::sqrt(200.0 * expected);
  const double inlet = grid.inlet > 0.0 ? grid.inlet : std::max(4.0, 1.0 + far);
  const double outlet = grid.outlet > 0.0 ? grid.outlet : std::max(1.5, 1.0 + 0.15 * far);
  const double step = (inlet + outlet) / grid.cells;
  LineFilmEquations equations(contact, half_width, pressure, -inlet + grid.shift * step, step, grid.cells,
                              std::max(1.0, 0.1 * far));
  LineFilm result;
  const Index middle = std::clamp<Index>(std::lround(-equations.X[0] / step), 1, equations.cells() - 1);
  equations.rigid = 0.0;
  equations.update_film();
  equations.rigid = expected - equations.H[middle];
  constexpr double kEnough = 1e-9;
  result.change = equations.solve(60, kEnough, result.iterations);
  result.converged = result.change <= kEnough && equations.H.minCoeff() > 0.0;

  const double film = equations.unit_film();
  const Eigen::ArrayXd& P = equations.P;
  const Index n = equations.cells();
  result.x = half_width * equations.X;
  result.pressure = pressure * P;
  result.film = film * equations.H;
  result.fraction = equations.fraction();
  result.load_error = std::abs(P.sum() * step / (0.5 * pi) - 1.0);
  result.largest_pressure = result.pressure.maxCoeff();
  const auto parabola = [&](Index i, double s) {
    const double a = result.film[i - 1], b = result.film[i], c = result.film[i + 1];
    return b + 0.5 * s * (c - a) + 0.5 * s * s * (a - 2.0 * b + c);
  };
  result.central = parabola(middle, -equations.X[middle] / step);
  result.film_in_steps = result.central / (film * step * step);
  Index least = 0;
  result.film.segment(1, n - 1).minCoeff(&least);
  ++least;
  const double bend = result.film[least - 1] - 2.0 * result.film[least] + result.film[least + 1];
  const double off = bend > 0.0 ? 0.5 * (result.film[least - 1] - result.film[least + 1]) / bend : 0.0;
  result.least = parabola(least, std::clamp(off, -1.0, 1.0));
  double mean = 0.0, count = 0.0, worst = 0.0;
  Index last = 0;
  for (Index i = 0; i < n; ++i)
    if (P[i] > 0.0 || P[i + 1] > 0.0) mean += equations.flow(i), ++count, last = i;
  mean /= std::max(count, 1.0);
  for (Index i = 0; i < n; ++i)
    if (P[i] > 0.0 || P[i + 1] > 0.0) worst = std::max(worst, std::abs(equations.flow(i) - mean));
  result.mass_error = worst / std::abs(mean);
  result.rupture = result.x[last];
  double traction = 0.0;
  for (Index i = 0; i < n; ++i) traction += 0.25 * (equations.H[i] + equations.H[i + 1]) * (P[i + 1] - P[i]);
  result.rolling_traction = traction * pressure * film;
  result.flow = -mean * film;
  result.inlet_beyond = 12.0 * contact.oil.viscosity * contact.rolling * r / -result.x[0];
  return result;
}

}  // namespace orbearing::bearing::film
