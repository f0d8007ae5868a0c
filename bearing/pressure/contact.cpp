#include "bearing/pressure/contact.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::half_space {

namespace {

double compliance(const Material& material) {
  return 1.0 / material.plane_strain_modulus();
}

void require_sound(const Material& material, const char* modulus) {
  mechanics::require_positive(material.youngs_modulus, modulus);
  mechanics::require(material.poisson_ratio >= 0.0 && material.poisson_ratio <= 0.5,
                     "Poisson's ratio of a half-space [-]", material.poisson_ratio, "0 to 0.5");
}

}  // namespace

double contact_modulus(const HalfSpaceContact& contact) {
  return 1.0 / (compliance(contact.roller) + compliance(contact.race));
}

double mirror_factor(EndSurface ends, double poisson_ratio) {
  switch (ends) {
    case EndSurface::continuing:
      return 0.0;
    case EndSurface::mirrored:
      return 1.0;
    case EndSurface::corrected:
      return 1.29 - (0.08 - 0.5 * poisson_ratio) / (1.0 - poisson_ratio);
  }
  throw std::logic_error("half-space contact: unknown kind of end");
}

double mirror_factor(const HalfSpaceContact& contact) {
  const double roller = compliance(contact.roller), race = compliance(contact.race);
  return (roller * mirror_factor(contact.roller_ends, contact.roller.poisson_ratio) +
          race * mirror_factor(contact.race_ends, contact.race.poisson_ratio)) /
         (roller + race);
}

void require_sound(const HalfSpaceContact& contact) {
  mechanics::require_positive(contact.length, "length of a half-space contact [m]");
  mechanics::require_positive(contact.equivalent_radius, "equivalent radius of a half-space contact [m]");
  require_sound(contact.roller, "Young's modulus of the roller [Pa]");
  require_sound(contact.race, "Young's modulus of the race [Pa]");
}

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
