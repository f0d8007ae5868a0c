#include "bearing/pressure/pressure_measures.hpp"

#include <algorithm>
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

/// Integrals of `density` over equal parts.
Eigen::ArrayXd parts(const RollerContactPressure& solution, const Eigen::ArrayXd& density, int laminae) {
  mechanics::require(laminae >= 1, "laminae", laminae, "at least 1");
  const Eigen::ArrayXd edge = edges_of(solution);
  const Integral integral(edge, density);
  const Eigen::ArrayXd bound = Eigen::ArrayXd::LinSpaced(laminae + 1, edge(0), edge(edge.size() - 1));
  Eigen::ArrayXd part(laminae);
  for (int k = 0; k < laminae; ++k) {
    part(k) = integral.between(bound(k), bound(k + 1));
  }
  return part;
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
  return parts(solution, solution.line_load, laminae);
}

Eigen::ArrayXd lamina_pressures(const RollerContactPressure& solution, int laminae) {
  return parts(solution, solution.pressure, laminae) * (laminae / solution.element.sum());
}

}  // namespace orbearing::bearing::half_space
