#include "bearing/pressure/length_grid.hpp"
#include "mechanics/constants.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace orbearing::bearing::half_space {

LengthGrid graded_grid(double length, int elements, double grading) {
  if (!(length > 0.0) || elements < 2 || !(grading >= 0.0 && grading < 1.0)) {
    std::ostringstream message;
    message << "grid along the roller: length " << length << " m, " << elements << " elements, grading "
            << grading
            << "; a positive length, at least 2 elements and a grading from 0 to below 1 are required";
    throw std::invalid_argument(message.str());
  }
  LengthGrid grid{Eigen::ArrayXd(elements + 1), {}, {}};
  // Each half from its own end, so that the grid is symmetric to the last bit.
  for (int k = 0; 2 * k <= elements; ++k) {
    const double s = 1.0 - 2.0 * k / elements;
    const double position = (1.0 - grading) * s + grading * std::sin(constants::half_pi * s);
    grid.edge(elements - k) = 0.5 * length * position;
    grid.edge(k) = -grid.edge(elements - k);
  }
  grid.middle = 0.5 * (grid.edge.head(elements) + grid.edge.tail(elements));
  grid.size = grid.edge.tail(elements) - grid.edge.head(elements);
  return grid;
}

Eigen::ArrayXd mean_relief(const LengthGrid& grid, const Relief& relief) {
  using Rule = boost::math::quadrature::gauss<double, 5>;
  Eigen::ArrayXd mean(grid.middle.size());
  for (Eigen::Index i = 0; i < mean.size(); ++i) {
    mean(i) = 0.5 * Rule::integrate([&](double s) { return relief(grid.middle(i) + 0.5 * s * grid.size(i)); },
                                    -1.0, 1.0);
  }
  if (!mean.allFinite()) {
    throw std::invalid_argument("half-space contact: the relief is not a number everywhere on the length");
  }
  return mean;
}

}  // namespace orbearing::bearing::half_space
