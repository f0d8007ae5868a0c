#include "tests/reference/surface_contact.hpp"

#include <numbers>
#include <cmath>
#include <stdexcept>

#include "bearing/pressure/contact.hpp"
#include "bearing/pressure/pressure_measures.hpp"
#include "bearing/pressure/strip_contact.hpp"
#include "tests/reference/conjugate_gradients.hpp"

namespace orbearing::bearing::half_space {

namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;

constexpr double kMargin = 1.15;  // of the grid across over the strips' greatest half width
constexpr double kWiden = 1.3;    // where the contact reaches the outermost row
constexpr int kMostWidenings = 6;

/// Data that do not depend on the grid across.
struct Plane {
  const HalfSpaceContact& contact;
  const StripContact& strips;
  const RollerContactPressure& start;
  ArrayXd relief;  // [m]  (elements)
};

/// A semi-ellipse across with the strips' load and width.
ArrayXXd elliptic_pressure(const RollerContactPressure& strips, const ArrayXd& y) {
  ArrayXXd pressure(strips.x.size(), y.size());
  for (Index row = 0; row < y.size(); ++row) {
    const ArrayXd position = y(row) / strips.half_width.max(1e-300);
    pressure.col(row) = strips.pressure * (1.0 - position.square()).max(0.0).sqrt();
  }
  return pressure;
}

ConjugateGradients problem_on(const Plane& plane, const RowGrid& rows, const ArrayXd& y) {
  const LengthGrid& grid = plane.strips.grid();
  ConjugateGradients problem{
      .influence = RectangleInfluence(grid, rows, mirror_factor(plane.contact)),
      .compliance = std::numbers::inv_pi / contact_modulus(plane.contact),
      .area = ArrayXXd(grid.size.size(), y.size()),
      .count = ArrayXd(y.size()),
      .gap = ArrayXXd(grid.size.size(), y.size()),
      .pressure = elliptic_pressure(plane.start, y)};
  for (Index row = 0; row < y.size(); ++row) {
    const double mean_square = y(row) * y(row) + rows.spacing * rows.spacing / 12.0;
    problem.area.col(row) = rows.spacing * grid.size;
    problem.count(row) = rows.count(row);
    problem.gap.col(row) =
        plane.relief - plane.start.tilt * grid.middle + 0.5 * mean_square / plane.contact.equivalent_radius;
  }
  return problem;
}

RollerContactMap map_of(const Plane& plane, const ConjugateGradients& problem, const ArrayXd& y) {
  RollerContactMap map;
  map.y = y;
  map.pressure = problem.pressure;
  RollerContactPressure& along = map.along;
  along.x = plane.start.x;
  along.element = plane.start.element;
  const double spacing = y(1) - y(0);
  along.line_load = spacing * (problem.pressure.matrix() * problem.count.matrix()).array();
  const ArrayXd weight = problem.count * (y.square() + spacing * spacing / 12.0);
  const ArrayXd second = spacing * (problem.pressure.matrix() * weight.matrix()).array();
  along.half_width = (along.line_load > 0.0).select(2.0 * (second / along.line_load.max(1e-300)).sqrt(), 0.0);
  along.pressure = problem.pressure.col(0);
  along.approach = problem.approach;
  along.tilt = plane.start.tilt;
  along.energy = problem.energy;
  along.iterations = problem.iterations;
  along.residual = problem.residual;
  measure(plane.strips.grid(), along);
  return map;
}

RollerContactMap solve(const HalfSpaceContact& contact, const Relief& relief, const SurfaceSettings& settings,
                       const StripContact& strips, const RollerContactPressure& start, bool load_given) {
  const Plane plane{contact, strips, start, strips.relief(relief)};
  double reach = settings.reach > 0.0 ? settings.reach : kMargin * start.half_width.maxCoeff();
  for (int k = 0; k < kMostWidenings; ++k, reach *= kWiden) {
    const RowGrid rows{settings.rows, reach / (settings.rows - 0.5)};
    const ArrayXd y = ArrayXd::LinSpaced(rows.rows, 0.0, (rows.rows - 1) * rows.spacing);
    ConjugateGradients problem = problem_on(plane, rows, y);
    problem.load = load_given ? start.load : 0.0;
    problem.approach = start.approach;
    problem.solve(settings.tolerance, settings.most_iterations);
    if (problem.pressure.rightCols(1).maxCoeff() == 0.0) {
      return map_of(plane, problem, y);
    }
  }
  throw std::runtime_error("half-space contact: the contact does not end within the grid across the roller");
}

StripContact strips_for(const HalfSpaceContact& contact, const SurfaceSettings& settings) {
  if (settings.rows < 3) {
    throw std::invalid_argument("half-space contact: at least 3 rows across are required");
  }
  return StripContact(contact, {.elements = settings.elements, .grading = settings.grading});
}

}  // namespace

RollerContactMap contact_map(const HalfSpaceContact& contact, const Relief& relief, double load, double tilt,
                             const SurfaceSettings& settings) {
  const StripContact strips = strips_for(contact, settings);
  RollerContactPressure start = strips.under_load(strips.relief(relief), load, tilt);
  start.load = load;
  return solve(contact, relief, settings, strips, start, true);
}

RollerContactMap contact_map_at(const HalfSpaceContact& contact, const Relief& relief, double approach,
                                double tilt, const SurfaceSettings& settings) {
  const StripContact strips = strips_for(contact, settings);
  const RollerContactPressure start = strips.at_approach(strips.relief(relief), approach, tilt);
  if (!(start.load > 0.0)) {
    throw std::runtime_error("half-space contact: the bodies do not meet at this approach");
  }
  return solve(contact, relief, settings, strips, start, false);
}

}  // namespace orbearing::bearing::half_space
