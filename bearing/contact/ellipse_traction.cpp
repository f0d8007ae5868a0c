#include "bearing/contact/ellipse_traction.hpp"

#include <boost/math/special_functions/legendre.hpp>
#include <cmath>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing {

// Load density over the unit disc: 3/(2 pi) sqrt(1 - x^2 - y^2). Along a slice it is (1 - x^2) times the
// weight of Chebyshev's polynomials of the second kind.
EllipsePoints ellipse_points(int slices, int rows) {
  using constants::pi;
  mechanics::require(slices >= 1, "slices of an ellipse of contact [-]", slices, "at least 1");
  mechanics::require(rows >= 1, "points of a slice of an ellipse of contact [-]", rows, "at least 1");
  mechanics::require(slices * rows <= EllipsePoints::kMost, "points of an ellipse of contact [-]", slices * rows,
                     "at most 256");
  EllipsePoints points;
  double sum = 0.0;
  const auto add_slice = [&](double x) {
    const double slope = boost::math::legendre_p_prime(slices, x);
    const double weight = 2.0 / ((1.0 - x * x) * slope * slope);
    for (int k = 1; k <= rows; ++k) {
      const double angle = pi * k / (rows + 1.0), sine = std::sin(angle);
      const double half = std::sqrt(1.0 - x * x);
      const int i = points.count++;
      points.across[i] = x;
      points.along[i] = half * std::cos(angle);
      points.share[i] = weight * (1.0 - x * x) * sine * sine;
      points.pressure[i] = half * sine;
      sum += points.share[i];
    }
  };
  for (const double zero : boost::math::legendre_p_zeros<double>(slices)) {
    add_slice(zero);
    if (zero != 0.0) add_slice(-zero);
  }
  for (int i = 0; i < points.count; ++i) points.share[i] /= sum;
  return points;
}

}  // namespace orbearing::bearing
