// After [VennerLubrecht2000]: multigrid for the nonlinear equation (full approximation), relaxed line by line
// along the rolling; where pressure diffuses hardly, changes are applied as dipoles that leave the far bodies
// alone. The coarsest grid is solved by Newton's method with the load among its unknowns.
#include "bearing/film/reynolds/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "bearing/contact/point_contact.hpp"
#include "bearing/film/reynolds/point_level.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::film {

namespace {

using Eigen::Index;

constexpr int kBefore = 2, kAfter = 1;    // relaxations of a cycle
constexpr Index kCoarsest = 16;           // cells each way of the grid that Newton's method solves
constexpr double kMostCorrection = 0.05;  // of pressure by a coarser grid, in Hertz's largest one
// Another attempt is made where pressure changes by more than this share after so many cycles.
struct Hopeless {
  int cycles;
  double change;
};
constexpr std::array<Hopeless, 2> hopeless{{{5, 0.3}, {25, 5e-3}}};
constexpr int kClimbing = 3;  // cycles on each grid on the way up

double difference(double axis_ratio) {
  const double excess = axis_ratio * axis_ratio - 1.0;
  if (excess < 1e-6) return 0.25 * excess;
  const double k = std::sqrt(1.0 - 1.0 / (axis_ratio * axis_ratio));
  return 1.0 - 2.0 / excess * (std::comp_ellint_1(k) / std::comp_ellint_2(k) - 1.0);
}

// Injection of the nodes that both grids have.
void inject(const Field& fine, Field& coarse) {
  coarse.resize((fine.rows() - 1) / 2 + 1, (fine.cols() - 1) / 2 + 1);
  for (Index j = 0; j < coarse.cols(); ++j)
    for (Index i = 0; i < coarse.rows(); ++i) coarse(i, j) = fine(2 * i, 2 * j);
}

// Weighted means of nine nodes; plain values next to where the oil cavitates.
void restrict_residual(const Field& fine, const Field& pressure, Field& coarse) {
  coarse.setZero((fine.rows() - 1) / 2 + 1, (fine.cols() - 1) / 2 + 1);
  for (Index j = 1; j + 1 < coarse.cols(); ++j)
    for (Index i = 1; i + 1 < coarse.rows(); ++i) {
      const auto p = pressure.block<3, 3>(2 * i - 1, 2 * j - 1);
      const auto r = fine.block<3, 3>(2 * i - 1, 2 * j - 1);
      if (p.minCoeff() <= 0.0) {
        coarse(i, j) = r(1, 1);
        continue;
      }
      coarse(i, j) = 0.25 * r(1, 1) + 0.125 * (r(0, 1) + r(2, 1) + r(1, 0) + r(1, 2)) +
                     0.0625 * (r(0, 0) + r(0, 2) + r(2, 0) + r(2, 2));
    }
}

// Between coarse nodes: linear.
double between(const Field& coarse, Index i, Index j) {
  const Index x = i / 2, y = j / 2, right = x + i % 2, above = y + j % 2;
  return 0.25 * (coarse(x, y) + coarse(right, y) + coarse(x, above) + coarse(right, above));
}

// From the fastest to the surest; all of them together have the cycles that the grid allows.
struct Attempt {
  Relaxation relaxation;
  bool eased = false;  // whether coarse grids begin with the film of a higher speed, which they can resolve
};
constexpr std::array<Attempt, 3> attempts{
    {{{0.5, 0.6, 2.0}, false}, {{0.7, 0.6, 2.0}, true}, {{0.4, 0.4, 2.0}, true}}};

class PointFilmSolver {
 public:
  PointFilmSolver(const PointFilmNumbers& numbers, const PointFilmDomain& finest, const Attempt& attempt)
      : eased_(attempt.eased) {
    PointFilmDomain domain = finest;
    std::vector<PointFilmDomain> domains{domain};
    while (domain.nx % 2 == 0 && domain.ny % 2 == 0 && domain.nx > kCoarsest && domain.ny > kCoarsest) {
      domain.nx /= 2;
      domain.ny /= 2;
      domain.hx *= 2.0;
      domain.hy *= 2.0;
      domains.push_back(domain);
    }
    for (auto one = domains.rbegin(); one != domains.rend(); ++one)
      levels_.push_back(std::make_unique<PointFilmLevel>(numbers, *one));
    for (const auto& level : levels_) level->relaxation = attempt.relaxation;
  }

  PointFilmLevel& finest() { return *levels_.back(); }
  double rigid() const { return rigid_; }

  /// Pressure of Hertz on the coarsest grid, with a film of `central`.
  void start(const std::array<double, 3>& hertz, double central) {
    PointFilmLevel& level = *levels_.front();
    const PointFilmDomain& d = level.domain();
    for (Index j = 1; j < d.ny; ++j)
      for (Index i = 1; i < d.nx; ++i) {
        const double x = d.x_at(i), y = d.y_at(j);
        const double inside = 1.0 - hertz[0] * x * x - hertz[1] * x * y - hertz[2] * y * y;
        level.pressure(i, j) = inside > 0.0 ? std::sqrt(inside) : 0.0;
      }
    level.pressure *= level.load / level.load_of(level.pressure);
    Field deformation;
    level.deform(level.pressure, deformation);
    const Index i = std::clamp<Index>(std::lround(-d.x / d.hx), 0, d.nx);
    const Index j = std::clamp<Index>(std::lround(-d.y / d.hy), 0, d.ny);
    rigid_ = central * std::pow(ease(level, central), -0.67) - deformation(i, j);
    level.ease = ease(level, central);
    level.update_film(rigid_);
    level.solve(rigid_, 40, 1e-6);
  }

  // Share of the diffusion with which the film is as thick as a grid can resolve: its error is about 1.2
  // steps squared.
  double ease(const PointFilmLevel& level, double central) const {
    if (!eased_) return 1.0;
    const double resolved = central / (4.0 * level.domain().hx * level.domain().hx);
    return std::min(1.0, resolved * std::sqrt(resolved));
  }

  /// Full multigrid up to the finest grid.
  void climb(double central) {
    for (std::size_t l = 1; l < levels_.size(); ++l) {
      PointFilmLevel& fine = *levels_[l];
      const PointFilmLevel& coarse = *levels_[l - 1];
      for (Index j = 1; j < fine.domain().ny; ++j)
        for (Index i = 1; i < fine.domain().nx; ++i) fine.pressure(i, j) = between(coarse.pressure, i, j);
      fine.source.setZero();
      fine.film_source.setZero();
      for (std::size_t k = 0; k <= l; ++k) levels_[k]->ease = ease(fine, central);
      fine.update_film(rigid_);
      if (l + 1 < levels_.size())
        for (int c = 0; c < kClimbing; ++c) cycle(l);
    }
    for (const auto& level : levels_) level->ease = 1.0;
  }

  /// Cycles on the finest grid; where oil that left a gap comes back to one, with its share.
  PointFilm finish(const PointFilmGrid& grid, int most_cycles) {
    PointFilmLevel& fine = finest();
    PointFilm report;
    Field before = fine.pressure;
    const auto settle = [&] {
      report.converged = false;
      while (report.cycles < most_cycles && !report.converged) {
        cycle(levels_.size() - 1);
        if (fine.starved) fine.carry_oil();
        ++report.cycles;
        report.change = (fine.pressure - before).abs().sum() / fine.pressure.sum();
        before = fine.pressure;
        report.load_error = std::abs(fine.load_of(fine.pressure) / fine.load - 1.0);
        report.residual = fine.balance().residual;
        const bool stuck = std::any_of(hopeless.begin(), hopeless.end(), [&](const Hopeless& one) {
          return report.cycles > one.cycles && report.change > one.change;
        });
        if (!std::isfinite(report.change) || !std::isfinite(report.residual) || stuck) break;
        // Bodies that run through each other balance the load too.
        report.converged = report.change < grid.tolerance && report.load_error < grid.tolerance &&
                           report.residual < grid.tolerance && fine.film.minCoeff() > 0.0;
      }
    };
    settle();
    if (!report.converged) return report;
    fine.carry_oil();
    if (fine.balance().lost > grid.tolerance) settle();
    report.mass_error = fine.balance().lost;
    return report;
  }

 private:
  void cycle(std::size_t l) {
    PointFilmLevel& fine = *levels_[l];
    if (l == 0) {
      fine.solve(rigid_, 2, 1e-9);
      return;
    }
    for (int i = 0; i < kBefore; ++i) fine.relax(rigid_);
    correct(l);
    for (int i = 0; i < kAfter; ++i) fine.relax(rigid_);
  }

  void correct(std::size_t l) {
    PointFilmLevel& fine = *levels_[l];
    PointFilmLevel& coarse = *levels_[l - 1];
    Field residual, start, deformation;
    fine.residual(residual);
    inject(fine.pressure, start);
    coarse.pressure = start;
    Field film;
    inject(fine.film, film);
    coarse.film_source.setZero();
    coarse.update_film(rigid_);
    coarse.film_source = film - coarse.film;
    coarse.film = film;
    coarse.starved = fine.starved;
    if (fine.starved) inject(fine.fraction, coarse.fraction);
    coarse.load = coarse.load_of(start) + fine.load - fine.load_of(fine.pressure);
    coarse.source.setZero();
    Field left;
    coarse.residual(left);
    Field moved;
    restrict_residual(residual, fine.pressure, moved);
    coarse.source = moved - left;
    cycle(l - 1);
    Field change = coarse.pressure - start;
    change *= std::min(1.0, kMostCorrection / std::max(change.abs().maxCoeff(), 1e-300));
    for (Index j = 1; j < fine.domain().ny; ++j)
      for (Index i = 1; i < fine.domain().nx; ++i) {
        double& p = fine.pressure(i, j);
        if (p > 0.0) p = std::max(0.0, p + between(change, i, j));
      }
    fine.update_film(rigid_);
  }

  bool eased_;
  std::vector<std::unique_ptr<PointFilmLevel>> levels_;
  double rigid_ = 0.0;
};

}  // namespace

void set_ellipse(PointFilmCase& contact, double rolling_radius, double ellipticity) {
  const bool along_y = ellipticity >= 1.0;
  const double f = difference(along_y ? ellipticity : 1.0 / ellipticity);
  contact.curvature_x = 1.0 / rolling_radius;
  contact.curvature_y = contact.curvature_x * (along_y ? (1.0 - f) / (1.0 + f) : (1.0 + f) / (1.0 - f));
}

namespace {

// Semi-axes along x and y of Hertz's ellipse, its largest pressure.
struct HertzEllipse {
  double a = 0.0, b = 0.0;  // [m]
  double pressure = 0.0;    // [Pa]
};

HertzEllipse hertz_ellipse(const PointFilmCase& c) {
  const double sum = c.curvature_x + c.curvature_y;
  const ContactEllipse ellipse = contact_ellipse(std::abs(c.curvature_x - c.curvature_y) / sum);
  const PointPressure one = point_pressure(
      {.curvature = {.sum = sum, .difference = 0.0}, .ellipse = ellipse, .modulus = c.modulus}, c.load);
  const bool long_y = c.curvature_y <= c.curvature_x;
  return {long_y ? one.minor : one.major, long_y ? one.major : one.minor, one.pressure};
}

}  // namespace

namespace {

// Quadratic through nine nodes about (i, j): value and slopes in steps.
struct Patch {
  double value, x, y, xx, xy, yy;

  Patch(const Field& f, Index i, Index j)
      : value(f(i, j)),
        x(0.5 * (f(i + 1, j) - f(i - 1, j))),
        y(0.5 * (f(i, j + 1) - f(i, j - 1))),
        xx(f(i + 1, j) - 2.0 * f(i, j) + f(i - 1, j)),
        xy(0.25 * (f(i + 1, j + 1) - f(i - 1, j + 1) - f(i + 1, j - 1) + f(i - 1, j - 1))),
        yy(f(i, j + 1) - 2.0 * f(i, j) + f(i, j - 1)) {}

  double at(double s, double t) const {
    return value + x * s + y * t + 0.5 * xx * s * s + xy * s * t + 0.5 * yy * t * t;
  }
};

void measure(const PointFilmLevel& level, const PointFilmCase& contact, PointFilm& film) {
  const PointFilmDomain& d = level.domain();
  const double step_x = film.x[1] - film.x[0], step_y = film.y[1] - film.y[0];
  const Index i = std::clamp<Index>(std::lround(-d.x / d.hx), 1, d.nx - 1);
  const Index j = std::clamp<Index>(std::lround(-d.y / d.hy), 1, d.ny - 1);
  film.central = Patch(film.film, i, j).at(-film.x[i] / step_x, -film.y[j] / step_y);
  film.largest_pressure = film.pressure.maxCoeff();
  Index x = 0, y = 0;
  film.film.block(1, 1, d.nx - 1, d.ny - 1).minCoeff(&x, &y);
  const Patch least(film.film, ++x, ++y);
  const double det = least.xx * least.yy - least.xy * least.xy;
  double s = 0.0, t = 0.0;
  if (det > 0.0) {
    s = std::clamp((least.xy * least.y - least.yy * least.x) / det, -1.0, 1.0);
    t = std::clamp((least.xy * least.x - least.xx * least.y) / det, -1.0, 1.0);
  }
  film.least = least.at(s, t);
  const double along = film.x[x] + s * step_x, across = film.y[y] + t * step_y;
  const double c = std::cos(contact.angle), n = std::sin(contact.angle);
  film.least_x = c * along - n * across;
  film.least_y = n * along + c * across;
}

}  // namespace

PointFilm solve_point_film(const PointFilmCase& contact, const PointFilmGrid& grid) {
  const auto power_of_two = [](int cells) { return cells >= 32 && (cells & (cells - 1)) == 0; };
  mechanics::require(contact.load > 0.0, "load of a film [N]", contact.load, "positive");
  mechanics::require(contact.rolling > 0.0, "rolling speed of a film [m/s]", contact.rolling, "positive");
  mechanics::require(power_of_two(grid.along) && power_of_two(grid.across), "cells of a film's grid [-]",
                     power_of_two(grid.along) ? grid.across : grid.along, "a power of two of at least 32");
  const HertzEllipse hertz = hertz_ellipse(contact);
  const double c = std::cos(contact.angle), s = std::sin(contact.angle);
  const double a = std::hypot(hertz.a * c, hertz.b * s), b = std::hypot(hertz.a * s, hertz.b * c);
  // Curvatures in the axes of the rolling.
  const double kxx = contact.curvature_x * c * c + contact.curvature_y * s * s;
  const double kyy = contact.curvature_x * s * s + contact.curvature_y * c * c;
  const double kxy = (contact.curvature_y - contact.curvature_x) * s * c;
  const double radius = 1.0 / kxx;
  PointFilmNumbers numbers;
  numbers.oil = contact.oil;
  numbers.pressure = hertz.pressure;
  numbers.diffusion =
      a * a * a * hertz.pressure / (12.0 * contact.oil.viscosity * contact.rolling * radius * radius);
  numbers.compliance = 2.0 * radius * hertz.pressure / (std::numbers::pi * contact.modulus * a);
  numbers.load = contact.load / (hertz.pressure * a * a);
  numbers.curvature_xx = 1.0;
  numbers.curvature_xy = kxy * radius;
  numbers.curvature_yy = kyy * radius;
  numbers.spin = 0.5 * contact.spin * a / contact.rolling;
  numbers.sliding = contact.sliding / contact.rolling;
  const double unit_film = a * a / radius;
  if (contact.oil.eyring_stress > 0.0)
    numbers.shear = contact.oil.viscosity * contact.rolling / (unit_film * contact.oil.eyring_stress);

  // Film to expect, Eq. (13) of [Guo2013], for first guess and domain;
  const double u = contact.oil.viscosity * contact.rolling / (contact.modulus * radius);
  const double g = std::max(contact.oil.pressure_viscosity * contact.modulus, 100.0);
  const double w = contact.load / (contact.modulus * radius * radius);
  // or that of bodies that do not sink, [BreweHamrockTaylor1979].
  const double round = kxx / kyy;
  const double wedge = u / w * (0.131 * std::atan(0.5 * round) + 1.683) / (1.0 + 2.0 / (3.0 * round));
  const double elastic = radius * 2.69 * std::pow(u, 0.67) * std::pow(g, 0.53) * std::pow(w, -0.067) *
                         (1.0 - 0.61 * std::exp(-0.73 * b / a));
  const double central = std::max(elastic, radius * 128.0 * round * wedge * wedge) / unit_film;
  const double far = std::sqrt(20.0 * central);
  const double inlet = grid.inlet > 0.0 ? grid.inlet : std::max(4.5, 1.0 + far);
  const double outlet = grid.outlet > 0.0 ? grid.outlet : std::max(1.5, 0.5 * far);
  const double side = grid.side > 0.0 ? grid.side : 1.0 + std::max(1.5, far) * a / b;
  PointFilmDomain domain{.nx = grid.along, .ny = grid.across};
  domain.hx = (inlet + outlet) / grid.along;
  domain.hy = 2.0 * side * b / a / grid.across;
  domain.x = -inlet + grid.shift_x * domain.hx;
  domain.y = -side * b / a + grid.shift_y * domain.hy;

  const double ea = a * a / (hertz.a * hertz.a), eb = a * a / (hertz.b * hertz.b);
  std::array<double, 3> ellipse{ea * c * c + eb * s * s, 2.0 * (eb - ea) * s * c, ea * s * s + eb * c * c};
  // If the film is much thicker than the elastic deflection, the pressure is as wide as the film's wedge.
  const double wide = std::max(1.0, 0.2 * far);
  for (double& one : ellipse) one /= wide * wide;
  PointFilm result;
  int cycles = 0;
  for (const Attempt& attempt : attempts) {
    PointFilmSolver solver(numbers, domain, attempt);
    solver.start(ellipse, central);
    solver.climb(central);
    result = solver.finish(grid, grid.cycles - cycles);
    cycles += result.cycles;
    const PointFilmLevel& fine = solver.finest();
    result.x = a * Eigen::ArrayXd::LinSpaced(domain.nx + 1, domain.x, domain.x_at(domain.nx));
    result.y = a * Eigen::ArrayXd::LinSpaced(domain.ny + 1, domain.y, domain.y_at(domain.ny));
    result.pressure = hertz.pressure * fine.pressure;
    result.film = unit_film * fine.film;
    result.fraction = fine.fraction;
    result.approach = -unit_film * solver.rigid();
    measure(fine, contact, result);
    if (result.converged || cycles >= grid.cycles) break;
  }
  result.cycles = cycles;
  return result;
}

}  // namespace orbearing::bearing::film
