#include "bearing/film/reynolds/point_level.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/cancellation.hpp"
#include "mechanics/linear_algebra.hpp"

namespace orbearing::bearing::film {

namespace {

using Eigen::Index;

constexpr double kLeastPointFilm =
    1e-7;                            // of a^2/R: below it a film of an unfinished solution counts as this
constexpr double kMostChange = 0.2;  // of pressure in one sweep, in Hertz's largest one

// Diffusion over wedge from which no changes of films add up; the edge of cavitation requires whole changes
// there.
constexpr double kFilmsHardlyMatter = 100.0;

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

// Coefficients on five nodes in line of what leaves the middle one less what enters it, per oil at each
// node, from face velocities `before` and `after`: upstream and linear, the mean where the domain begins.
std::array<double, 5> wedge(double before, double after, Index node, Index last, double step) {
  std::array<double, 5> c{};
  const auto face = [&](double velocity, int left, double sign) {  // between left and left + 1, from the node
    const double flow = sign * velocity / step;
    const int up = velocity > 0.0 ? left : left + 1, further = velocity > 0.0 ? left - 1 : left + 2;
    const Index beyond = node + further;
    if (beyond < 0 || beyond > last) {
      c[static_cast<std::size_t>(left + 2)] += 0.5 * flow;
      c[static_cast<std::size_t>(left + 3)] += 0.5 * flow;
      return;
    }
    c[static_cast<std::size_t>(up + 2)] += 1.5 * flow;
    c[static_cast<std::size_t>(further + 2)] -= 0.5 * flow;
  };
  face(after, 0, 1.0);
  face(before, -1, -1.0);
  return c;
}

}  // namespace

PointFilmLevel::PointFilmLevel(const PointFilmNumbers& numbers, const PointFilmDomain& domain)
    : numbers_(numbers),
      domain_(domain),
      oil_(numbers.oil),
      potential_(domain.nx, domain.ny, domain.hx, domain.hy) {
  const Index nx = domain.nx, ny = domain.ny;
  gap_.resize(nx + 1, ny + 1);
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i) gap_(i, j) = numbers.gap(domain.x_at(i), domain.y_at(j));
  for (Field* field : {&pressure, &film, &source, &film_source, &along_, &across_, &across_slope_,
                       &along_power_, &across_power_, &along_slope_, &density_, &density_slope_})
    field->setZero(nx + 1, ny + 1);
  fraction.setOnes(nx + 1, ny + 1);
  load = numbers.load;
  for (Index j = 0; j <= ny; ++j) stream_x_.push_back(velocity_x(domain.y_at(j)));
  for (Index i = 0; i <= nx; ++i) stream_y_.push_back(velocity_y(domain.x_at(i)));
  const double xx = domain.hx * domain.hx, yy = domain.hy * domain.hy;
  dipole_x_ = 0.5 * yy / (xx + yy);
  dipole_y_ = 0.5 * xx / (xx + yy);
  const Index reach = kBand + 2;
  single_.resize(reach + 1, 3);
  dipole_.resize(reach + 1, 3);
  const auto influence = [&](Index x, Index y) { return numbers_.compliance * potential_.influence(x, y); };
  for (Index y = 0; y <= 2; ++y)
    for (Index x = 0; x <= reach; ++x) {
      single_(x, y) = influence(x, y);
      dipole_(x, y) = influence(x, y) - dipole_x_ * (influence(x - 1, y) + influence(x + 1, y)) -
                      dipole_y_ * (influence(x, y - 1) + influence(x, y + 1));
    }
  rows_.resize(at(nx + 1));
  as_dipole_.resize(at(nx + 1));
}

void PointFilmLevel::deform(const Field& pressures, Field& deformation) const {
  potential_(pressures, deformation);
  deformation *= numbers_.compliance;
}

void PointFilmLevel::update_film(double rigid) {
  deform(pressure, film);
  film += gap_ + film_source + rigid;
}

void PointFilmLevel::properties() {
  const bool shear = numbers_.shear > 0.0;
  for (Index j = 0; j <= domain_.ny; ++j)
    for (Index i = 0; i <= domain_.nx; ++i) {
      const OilState oil = oil_.at(numbers_.pressure * pressure(i, j));
      const double h = std::max(film(i, j), kLeastPointFilm);
      density_(i, j) = oil.density;
      density_slope_(i, j) = oil.density_slope * numbers_.pressure;
      const double e = oil.density * h * h * h / oil.viscosity * numbers_.diffusion * ease;
      along_(i, j) = across_(i, j) = e;
      along_power_(i, j) = across_power_(i, j) = 3.0;
      along_slope_(i, j) = across_slope_(i, j) =
          (oil.density_slope / oil.density - oil.viscosity_log_slope) * numbers_.pressure;
      if (!shear) continue;
      const double slip_x = numbers_.sliding + 2.0 * numbers_.spin * domain_.y_at(j);
      const double slip_y = -2.0 * numbers_.spin * domain_.x_at(i);
      const double slip = std::hypot(slip_x, slip_y);
      if (!(slip > 0.0)) continue;
      const EyringFlow flow = eyring_flow(numbers_.shear * oil.viscosity * slip / h);
      const double xx = slip_x * slip_x / (slip * slip);
      const auto apply = [&](double share, double& coefficient, double& slope, double& power) {
        const double lengthwise = share * flow.along, crosswise = (1.0 - share) * flow.across;
        const double by_shear =
            (lengthwise * flow.along_power + crosswise * flow.across_power) / (lengthwise + crosswise);
        coefficient *= lengthwise + crosswise;
        slope += by_shear * oil.viscosity_log_slope * numbers_.pressure;
        power -= by_shear;
      };
      apply(xx, along_(i, j), along_slope_(i, j), along_power_(i, j));
      apply(1.0 - xx, across_(i, j), across_slope_(i, j), across_power_(i, j));
    }
}

PointFilmLevel::Row PointFilmLevel::row(Index i, Index j) const {
  const double xx = 0.5 / (domain_.hx * domain_.hx), yy = 0.5 / (domain_.hy * domain_.hy);
  const double west = xx * (along_(i - 1, j) + along_(i, j)), east = xx * (along_(i, j) + along_(i + 1, j));
  const double south = yy * (across_(i, j - 1) + across_(i, j));
  const double north = yy * (across_(i, j) + across_(i, j + 1));
  const double to_west = pressure(i - 1, j) - pressure(i, j), to_east = pressure(i + 1, j) - pressure(i, j);
  const double to_south = pressure(i, j - 1) - pressure(i, j);
  const double to_north = pressure(i, j + 1) - pressure(i, j);
  Row row;
  row.diffusion = west + east;
  double left = west * to_west + east * to_east + south * to_south + north * to_north;
  // By the pressures themselves.
  row.by_pressure[0] = -(west + east + south + north);
  row.by_pressure[2] = west;
  row.by_pressure[3] = east;
  row.by_pressure[6] = south;
  row.by_pressure[7] = north;
  // By the coefficients: e grows as H^3 and with its own pressure.
  const auto by_coefficient = [&](std::size_t node, double change, Index x, Index y, const Field& e,
                                  const Field& slope, const Field& power) {
    row.by_pressure[node] += change * e(x, y) * slope(x, y);
    row.by_film[node] += power(x, y) * change * e(x, y) / std::max(film(x, y), kLeastPointFilm);
  };
  const auto by_along = [&](std::size_t node, double change, Index x) {
    by_coefficient(node, xx * change, x, j, along_, along_slope_, along_power_);
  };
  const auto by_across = [&](std::size_t node, double change, Index y) {
    by_coefficient(node, yy * change, i, y, across_, across_slope_, across_power_);
  };
  by_along(0, to_west + to_east, i);
  by_along(2, to_west, i - 1);
  by_along(3, to_east, i + 1);
  by_across(0, to_south + to_north, j);
  by_across(6, to_south, j - 1);
  by_across(7, to_north, j + 1);
  // The wedge.
  const auto carried = [&](std::size_t node, double c) {
    if (c == 0.0) return;
    const Index x = i + kAlong[node], y = j + kAcross[node];
    const double part = starved && node != 0 ? c * fraction(x, y) : c;
    left -= part * density_(x, y) * film(x, y);
    row.by_film[node] -= part * density_(x, y);
    row.by_pressure[node] -= part * density_slope_(x, y) * film(x, y);
  };
  const double u = stream_x_[at(j)], v = stream_y_[at(i)];
  const std::array<double, 5> cx = wedge(u, u, i, domain_.nx, domain_.hx);
  carried(1, cx[0]);
  carried(2, cx[1]);
  carried(0, cx[2]);
  carried(3, cx[3]);
  carried(4, cx[4]);
  if (v != 0.0) {
    const std::array<double, 5> cy = wedge(v, v, j, domain_.ny, domain_.hy);
    carried(5, cy[0]);
    carried(6, cy[1]);
    carried(0, cy[2]);
    carried(7, cy[3]);
    carried(8, cy[4]);
  }
  row.value = source(i, j) - left;
  return row;
}

void PointFilmLevel::residual(Field& into) {
  properties();
  into.setZero(domain_.nx + 1, domain_.ny + 1);
  for (Index j = 1; j < domain_.ny; ++j)
    for (Index i = 1; i < domain_.nx; ++i) into(i, j) = row(i, j).value;
}

void PointFilmLevel::relax(double rigid) {
  properties();
  Field dipoles = Field::Zero(domain_.nx + 1, domain_.ny + 1);
  for (Index j = 1; j < domain_.ny; ++j) {
    throw_if_stopped();
    relax_line(j, dipoles);
  }
  pressure += dipoles;
  pressure = pressure.max(0.0);
  pressure.row(0) = 0.0;
  pressure.row(domain_.nx) = 0.0;
  pressure.col(0) = 0.0;
  pressure.col(domain_.ny) = 0.0;
  update_film(rigid);
}

void PointFilmLevel::relax_line(Index j, Field& dipoles) {
  const Index n = domain_.nx - 1, width = 2 * kBand + 1;
  matrix_.assign(at(n * width), 0.0);
  right_.assign(at(n), 0.0);
  const double wedge_size = 1.5 * std::abs(stream_x_[at(j)]) * single_(0, 0) / domain_.hx;
  for (Index i = 1; i <= n; ++i) {
    rows_[at(i)] = row(i, j);
    // A dipole must not push its neighbours below zero.
    as_dipole_[at(i)] = rows_[at(i)].diffusion < 2.0 * relaxation.diffusive * wedge_size &&
                        pressure(i - 1, j) > 0.0 && pressure(i + 1, j) > 0.0 && pressure(i, j - 1) > 0.0 &&
                        pressure(i, j + 1) > 0.0;
  }
  for (Index i = 1; i <= n; ++i) {
    const Row& r = rows_[at(i)];
    double* line = matrix_.data() + (i - 1) * width + kBand;
    if (pressure(i, j) <= 0.0 && r.value >= 0.0) {  // cavitated: stays so
      line[0] = 1.0;
      continue;
    }
    right_[at(i - 1)] = r.value;
    const std::array<double, 2 * 3 + 1> on_line{
        0.0, r.by_pressure[1], r.by_pressure[2], r.by_pressure[0], r.by_pressure[3], r.by_pressure[4], 0.0};
    const auto local = [&](Index t) { return std::abs(t) > 2 ? 0.0 : on_line[at(t + 3)]; };
    for (Index t = -kBand; t <= kBand; ++t) {
      const Index k = i + t;
      if (k < 1 || k > n) continue;
      const bool dipole = as_dipole_[at(k)];
      const Field& influence = dipole ? dipole_ : single_;
      double sum = 0.0;
      for (std::size_t m = 0; m < kNodes; ++m)
        sum += r.by_film[m] * influence(std::abs(kAlong[m] - t), std::abs(kAcross[m]));
      sum += local(t);
      if (dipole) {
        sum -= dipole_x_ * (local(t - 1) + local(t + 1));
        if (t == 0) sum -= dipole_y_ * (r.by_pressure[6] + r.by_pressure[7]);
      }
      line[t] = sum;
    }
  }
  // Gauss's elimination within the band.
  for (Index k = 0; k < n; ++k) {
    const double* pivot = matrix_.data() + k * width + kBand;
    for (Index i = k + 1; i <= std::min(n - 1, k + kBand); ++i) {
      double* line = matrix_.data() + i * width + kBand;
      const double factor = line[k - i] / pivot[0];
      if (factor == 0.0) continue;
      for (Index c = 1; c <= std::min(kBand, n - 1 - k); ++c) line[k - i + c] -= factor * pivot[c];
      right_[at(i)] -= factor * right_[at(k)];
    }
  }
  for (Index k = n - 1; k >= 0; --k) {
    const double* line = matrix_.data() + k * width + kBand;
    double sum = right_[at(k)];
    for (Index c = 1; c <= std::min(kBand, n - 1 - k); ++c) sum -= line[c] * right_[at(k + c)];
    right_[at(k)] = sum / line[0];
  }
  for (Index i = 1; i <= n; ++i) {
    const double change = std::clamp(right_[at(i - 1)], -kMostChange, kMostChange);
    if (!as_dipole_[at(i)]) {
      const bool whole = rows_[at(i)].diffusion > kFilmsHardlyMatter * wedge_size;
      pressure(i, j) = std::max(0.0, pressure(i, j) + (whole ? 1.0 : relaxation.single) * change);
      continue;
    }
    const double moved = relaxation.dipole * change;
    dipoles(i, j) += moved;
    dipoles(i - 1, j) -= dipole_x_ * moved;
    dipoles(i + 1, j) -= dipole_x_ * moved;
    dipoles(i, j - 1) -= dipole_y_ * moved;
    dipoles(i, j + 1) -= dipole_y_ * moved;
  }
}

double PointFilmLevel::solve(double& rigid, int most, double enough) {
  const Index nx = domain_.nx, ny = domain_.ny;
  double change = 0.0;
  for (int iteration = 0; iteration < most; ++iteration) {
    throw_if_stopped();
    properties();
    std::vector<std::array<Index, 2>> open;
    std::vector<Row> rows;
    for (Index j = 1; j < ny; ++j)
      for (Index i = 1; i < nx; ++i) {
        const Row r = row(i, j);
        if (pressure(i, j) <= 0.0 && r.value >= 0.0) continue;
        open.push_back({i, j});
        rows.push_back(r);
      }
    const Index n = static_cast<Index>(open.size());
    if (n == 0) return std::numeric_limits<double>::infinity();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::VectorXd right(n + 1);
    for (Index k = 0; k < n; ++k) {
      const Row& r = rows[at(k)];
      const auto [x, y] = open[at(k)];
      right[k] = r.value;
      for (std::size_t m = 0; m < kNodes; ++m) {
        if (r.by_film[m] == 0.0 && r.by_pressure[m] == 0.0) continue;
        const Index mx = x + kAlong[m], my = y + kAcross[m];
        const double factor = numbers_.compliance * r.by_film[m];
        for (Index c = 0; c < n; ++c) {
          const auto [cx, cy] = open[at(c)];
          matrix(k, c) += factor * potential_.influence(mx - cx, my - cy);
          if (cx == mx && cy == my) matrix(k, c) += r.by_pressure[m];
        }
        matrix(k, n) += r.by_film[m];
      }
      matrix(n, k) = cell();
    }
    right[n] = load - load_of(pressure);
    const Eigen::VectorXd step = mechanics::solution(matrix, right);
    if (!step.allFinite()) return std::numeric_limits<double>::infinity();
    // Pressures may change by a third of the largest one, else all change by less.
    const double largest = std::max(pressure.maxCoeff(), 0.1),
                 most_change = step.head(n).cwiseAbs().maxCoeff();
    const double share = std::min(1.0, 0.35 * largest / std::max(most_change, 1e-300));
    double moved = 0.0;
    for (Index k = 0; k < n; ++k) {
      double& p = pressure(open[at(k)][0], open[at(k)][1]);
      const double next = std::max(0.0, p + share * step[k]);
      moved += std::abs(next - p);
      p = next;
    }
    rigid += share * step[n];
    update_film(rigid);
    change = moved / std::max(pressure.sum(), 1e-300);
    if (change < enough) break;
  }
  return change;
}

double PointFilmLevel::own_share(Index i, Index j) const {
  const double u = stream_x_[at(j)], v = stream_y_[at(i)];
  return wedge(u, u, i, domain_.nx, domain_.hx)[2] + wedge(v, v, j, domain_.ny, domain_.hy)[2];
}

// Row by row along the rolling, and back for what flows back, until nothing changes.
void PointFilmLevel::carry_oil() {
  constexpr int kMostSweeps = 40;
  constexpr double kSettled = 1e-12;
  properties();
  starved = true;
  const Index nx = domain_.nx, ny = domain_.ny;
  fraction = (pressure > 0.0).select(1.0, fraction);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change = 0.0;
    for (Index a = 1; a < nx; ++a)
      for (Index b = 1; b < ny; ++b) {
        const Index i = sweep % 4 < 2 ? a : nx - a, j = sweep % 2 == 0 ? b : ny - b;
        if (pressure(i, j) > 0.0) continue;
        const double full = own_share(i, j) * density_(i, j) * film(i, j);
        if (!(full > 0.0)) continue;
        const double share = std::clamp(1.0 - row(i, j).value / full, 0.0, 1.0);
        change = std::max(change, std::abs(share - fraction(i, j)));
        fraction(i, j) = share;
      }
    if (change < kSettled) break;
  }
}

PointFilmLevel::Balance PointFilmLevel::balance() {
  properties();
  Balance sum;
  for (Index j = 1; j < domain_.ny; ++j)
    for (Index i = 1; i < domain_.nx; ++i) {
      const double value = row(i, j).value;
      const double full = own_share(i, j) * density_(i, j) * film(i, j);
      if (pressure(i, j) > 0.0) {
        sum.residual += std::abs(value);
        sum.lost += std::abs(value);
      } else {
        sum.residual += std::max(0.0, -value);
        if (starved) sum.lost += std::abs(value - full * (1.0 - fraction(i, j)));
      }
    }
  const Index middle = std::clamp<Index>(std::lround(-domain_.x / domain_.hx), 0, domain_.nx);
  double through = 0.0;
  for (Index j = 0; j <= domain_.ny; ++j)
    if (pressure(middle, j) > 0.0)
      through += std::abs(stream_x_[at(j)]) * density_(middle, j) * film(middle, j) * domain_.hy;
  sum.residual *= cell() / through;
  sum.lost *= cell() / through;
  return sum;
}

}  // namespace orbearing::bearing::film
