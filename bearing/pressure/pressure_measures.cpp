#include "bearing/pressure/pressure_measures.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "mechanics/checks.hpp"

namespace orbearing::bearing::half_space {

namespace {

using Eigen::Index;

/// Integral of a density that is even within each element, from the left end on.
class Integral {
 public:
  Integral(const Eigen::ArrayXd& edge, const Eigen::ArrayXd& density) : edge_(edge), sum_(edge.size()) {
    sum_(0) = 0.0;
    for (Index i = 0; i < density.size(); ++i) {
      sum_(i + 1) = sum_(i) + density(i) * (edge(i + 1) - edge(i));
    }
  }

  double to(double x) const {
    const double* const begin = edge_.data();
    const Index upper = std::upper_bound(begin, begin + edge_.size(), x) - begin;
    const Index i = std::clamp<Index>(upper - 1, 0, edge_.size() - 2);
    const double share = std::clamp((x - edge_(i)) / (edge_(i + 1) - edge_(i)), 0.0, 1.0);
    return sum_(i) + share * (sum_(i + 1) - sum_(i));
  }

  double between(double begin, double end) const { return to(end) - to(begin); }

 private:
  Eigen::ArrayXd edge_, sum_;
};

Eigen::ArrayXd edges_of(const RollerContactPressure& solution) {
  Eigen::ArrayXd edge(solution.x.size() + 1);
  edge(0) = solution.x(0) - 0.5 * solution.element(0);
  edge.tail(solution.x.size()) = solution.x + 0.5 * solution.element;
  return edge;
}

/// Ends of equal parts of the length.
Eigen::ArrayXd bounds_of(const Eigen::ArrayXd& edge, int laminae) {
  mechanics::require(laminae >= 1, "laminae", laminae, "at least 1");
  return Eigen::ArrayXd::LinSpaced(laminae + 1, edge(0), edge(edge.size() - 1));
}

/// Eq. (5): the mean of a pressure over a window of `width`, which is moved to lie within the contact.
class MovingMean {
 public:
  MovingMean(const Eigen::ArrayXd& edge, const Eigen::ArrayXd& pressure, double width)
      : edge_(edge), integral_(edge, pressure), width_(width) {}

  double at(double x) const {
    const double last = edge_(edge_.size() - 1) - width_;
    const double from = std::clamp(x - 0.5 * width_, edge_(0), last);
    return integral_.between(from, from + width_) / width_;
  }
  /// Between these it is linear: where an end of the window meets an edge of an element.
  std::vector<double> kinks() const {
    std::vector<double> found;
    for (const double edge : edge_) {
      for (const double x : {edge - 0.5 * width_, edge + 0.5 * width_})
        if (x > edge_(0) && x < edge_(edge_.size() - 1)) found.push_back(x);
    }
    return found;
  }

 private:
  const Eigen::ArrayXd& edge_;
  Integral integral_;
  double width_;  // [m]
};

constexpr int kFatigue = 9;  // power of the pressure with which a line contact fatigues [LundbergPalmgren1947]

/// Mean of the ninth power of what goes linearly from `u` to `v`, exactly.
double mean_power(double u, double v) {
  double sum = 0.0, power = 1.0;
  for (int i = 0; i <= kFatigue; ++i) {
    sum = sum * u + power;
    power *= v;
  }
  return sum / (kFatigue + 1);
}

}  // namespace

double greatest_mean(const LengthGrid& grid, const Eigen::ArrayXd& pressure, double begin, double end) {
  const double gauge = kGauge * (grid.edge(grid.edge.size() - 1) - grid.edge(0));
  const Integral integral(grid.edge, pressure);
  // The mean over a moving gauge is greatest where one of its ends meets an edge of an element.
  double greatest = 0.0;
  const auto look = [&](double from) {
    from = std::clamp(from, begin, end - gauge);
    greatest = std::max(greatest, integral.between(from, from + gauge) / gauge);
  };
  for (const double edge : grid.edge) {
    look(edge);
    look(edge - gauge);
  }
  return greatest;
}

void measure(const LengthGrid& grid, RollerContactPressure& solution) {
  const double left = grid.edge(0), right = grid.edge(grid.edge.size() - 1), end = kEnd * (right - left);
  const Eigen::ArrayXd& pressure = solution.pressure;
  solution.load = (grid.size * solution.line_load).sum();
  solution.moment = (grid.size * solution.line_load * grid.middle).sum();
  solution.element_peak = pressure.maxCoeff();
  solution.peak_pressure = greatest_mean(grid, pressure, left, right);
  solution.edge_pressure = std::max(greatest_mean(grid, pressure, left, left + end),
                                    greatest_mean(grid, pressure, right - end, right));
  const Index half = pressure.size() / 2;
  const double middle = pressure.size() % 2 ? pressure(half) : 0.5 * (pressure(half - 1) + pressure(half));
  solution.edge_ratio = middle > 0.0 ? solution.edge_pressure / middle : 0.0;
}

Eigen::ArrayXd lamina_loads(const RollerContactPressure& solution, int laminae) {
  const Eigen::ArrayXd edge = edges_of(solution), bound = bounds_of(edge, laminae);
  const Integral integral(edge, solution.line_load);
  Eigen::ArrayXd load(laminae);
  for (int k = 0; k < laminae; ++k) load(k) = integral.between(bound(k), bound(k + 1));
  return load;
}

double mean_half_width(const RollerContactPressure& solution) {
  const double load = (solution.element * solution.line_load).sum();
  return load > 0.0 ? (solution.element * solution.line_load * solution.half_width).sum() / load : 0.0;
}

Eigen::ArrayXd fatigue_pressures(const RollerContactPressure& solution, int laminae) {
  const Eigen::ArrayXd edge = edges_of(solution), bound = bounds_of(edge, laminae);
  const double width = std::min(mean_half_width(solution), solution.element.sum());
  if (!(width > 0.0)) return Eigen::ArrayXd::Zero(laminae);
  const MovingMean mean(edge, solution.pressure, width);
  std::vector<double> ends = mean.kinks();
  ends.insert(ends.end(), bound.begin(), bound.end());
  std::sort(ends.begin(), ends.end());
  Eigen::ArrayXd damage = Eigen::ArrayXd::Zero(laminae);
  Index lamina = 0;
  double before = mean.at(ends.front());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double here = mean.at(ends[i]);
    damage(lamina) += (ends[i] - ends[i - 1]) * mean_power(before, here);
    if (lamina + 1 < laminae && ends[i] >= bound(lamina + 1)) ++lamina;
    before = here;
  }
  return (damage * (laminae / solution.element.sum())).pow(1.0 / kFatigue);
}

}  // namespace orbearing::bearing::half_space
