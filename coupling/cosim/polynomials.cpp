#include "coupling/cosim/polynomials.hpp"

#include <stdexcept>

#include "mechanics/checks.hpp"

namespace orbearing::cosim {

namespace {

void require_points(const std::vector<TimedValue>& points) {
  mechanics::require(!points.empty() && points.size() <= 4, "points of a polynomial", points.size(),
                     "1 to 4");
}

// Newton's divided differences, in place.
void divide(const std::vector<TimedValue>& points, std::vector<double>& difference) {
  for (std::size_t order = 1; order < points.size(); ++order)
    for (std::size_t i = points.size() - 1; i >= order; --i) {
      const double span = points[i].time - points[i - order].time;
      if (span == 0.0)
        throw std::invalid_argument(
            "points of a polynomial: found two at one time; required: different times");
      difference[i] = (difference[i] - difference[i - 1]) / span;
    }
}

}  // namespace

InputPolynomial through(const std::vector<TimedValue>& points, double begin) {
  require_points(points);
  std::vector<double> difference;
  for (const TimedValue& point : points) difference.push_back(point.value);
  divide(points, difference);
  InputPolynomial out;  // Horner: out = out * (t - t_i) + difference_i
  auto& c = out.coefficient;
  for (std::size_t i = points.size(); i-- > 0;) {
    const double position = points[i].time - begin;
    for (std::size_t k = c.size() - 1; k > 0; --k) c[k] = c[k - 1] - position * c[k];
    c[0] = difference[i] - position * c[0];
  }
  return out;
}

InputPolynomial hermite(double value, double slope, double end_value, double end_slope, double length) {
  const double mean = (end_value - value) / length;
  return {{value, slope, (3.0 * mean - 2.0 * slope - end_slope) / length,
           (slope + end_slope - 2.0 * mean) / (length * length)}};
}

}  // namespace orbearing::cosim
