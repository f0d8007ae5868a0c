#include "bearing/pressure/strip_contact.hpp"

#include <numbers>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "bearing/pressure/contact.hpp"
#include "bearing/pressure/pressure_measures.hpp"
#include "mechanics/cancellation.hpp"
#include "mechanics/checks.hpp"

namespace orbearing::bearing::half_space {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

// A wider strip is less stiff and takes more load, so widths come from one side: a longer step saves a fifth.
constexpr double kOverRelaxation = 1.15;
constexpr double kLeastGrowth = 1e-4;  // of a width squared in one step, where nothing is loaded near by

const HalfSpaceContact& sound(const HalfSpaceContact& contact) {
  require_sound(contact);
  return contact;
}

}  // namespace

struct StripContact::Iteration {
  bool load_given = false;
  double load = 0.0;            // [N]
  double approach = 0.0;        // [m]
  ArrayXd closing;              // [m]  tilt x - relief
  ArrayXd line_load;            // [N/m]
  ArrayXd square;               // [m^2]  b^2
  std::vector<Index> touching;  // elements that carry
  StripMatrices matrices;
};

StripContact::StripContact(const HalfSpaceContact& contact, const StripSettings& settings)
    : radius_(sound(contact).equivalent_radius),
      compliance_(std::numbers::inv_pi / contact_modulus(contact)),
      settings_(settings),
      grid_(graded_grid(contact.length, settings.elements, settings.grading)),
      influence_(grid_, mirror_factor(contact)) {}

RollerContactPressure StripContact::under_load(const ArrayXd& relief, double load, double tilt) const {
  mechanics::require_positive(load, "load of a half-space contact [N]");
  Iteration iteration;
  iteration.load_given = true;
  iteration.load = load;
  return solve(relief, tilt, iteration);
}

RollerContactPressure StripContact::at_approach(const ArrayXd& relief, double approach, double tilt) const {
  mechanics::require(std::isfinite(approach), "approach of a half-space contact [m]", approach,
                     "a finite number");
  Iteration iteration;
  iteration.approach = approach;
  return solve(relief, tilt, iteration);
}

RollerContactPressure StripContact::solve(const ArrayXd& relief, double tilt, Iteration& iteration) const {
  mechanics::require(std::isfinite(tilt), "tilt of a half-space contact [rad]", tilt, "a finite number");
  if (relief.size() != grid_.middle.size() || !relief.allFinite()) {
    throw std::invalid_argument("half-space contact: one finite relief for each element is required");
  }
  iteration.closing = tilt * grid_.middle - relief;
  iteration.line_load = ArrayXd::Zero(relief.size());
  const double greatest = iteration.approach + iteration.closing.maxCoeff();
  if (!iteration.load_given && greatest <= 0.0) {
    iteration.square = ArrayXd::Zero(relief.size());
    influence_.evaluate(ArrayXd::Constant(relief.size(), grid_.size.minCoeff()), iteration.matrices);
    return result(iteration, tilt, 0.0);
  }
  // First widths: an even line load; a long contact's approach is some twelve times c q.
  const double first =
      iteration.load_given ? iteration.load / grid_.size.sum() : greatest / (12.0 * compliance_);
  iteration.square = ArrayXd::Constant(relief.size(), 4.0 * radius_ * compliance_ * first);
  for (Index i = 0; i < relief.size(); ++i) {
    if (iteration.load_given || iteration.approach + iteration.closing(i) > 0.0) {
      iteration.touching.push_back(i);
    }
  }
  double change = 0.0;
  for (int k = 0; k < settings_.most_iterations; ++k) {
    throw_if_stopped();
    influence_.evaluate(iteration.square.sqrt(), iteration.matrices);
    balance(iteration);
    const bool same_contact = update_contact(iteration);
    change = update_widths(iteration);
    if (same_contact && change < settings_.tolerance) {
      RollerContactPressure solution = result(iteration, tilt, change);
      solution.iterations = k + 1;
      return solution;
    }
  }
  std::ostringstream message;
  message << "half-space contact: widths still change by " << change << " of the greatest after "
          << settings_.most_iterations << " iterations; " << settings_.tolerance << " is required";
  throw std::runtime_error(message.str());
}

void StripContact::balance(Iteration& iteration) const {
  const auto& touching = iteration.touching;
  const ArrayXd closing = iteration.closing - iteration.square / (8.0 * radius_);
  const Eigen::MatrixXd matrix = compliance_ * iteration.matrices.influence(touching, touching);
  const Eigen::LLT<Eigen::MatrixXd> factors(matrix);
  if (touching.empty() || factors.info() != Eigen::Success) {
    throw std::runtime_error(touching.empty() ? "half-space contact: no element is left in contact"
                                              : "half-space contact: the influence matrix is not positive");
  }
  const Eigen::VectorXd size = grid_.size(touching).matrix();
  Eigen::MatrixXd right(size.size(), 2);
  right.col(0) = (grid_.size(touching) * closing(touching)).matrix();
  right.col(1) = size;
  factors.solveInPlace(right);
  if (iteration.load_given) {
    iteration.approach = (iteration.load - size.dot(right.col(0))) / size.dot(right.col(1));
  }
  iteration.line_load.setZero();
  iteration.line_load(touching) = (right.col(0) + iteration.approach * right.col(1)).array();
}

/// Elements that pull leave the contact, those that overlap enter it; true where none did.
bool StripContact::update_contact(Iteration& iteration) const {
  const ArrayXd room = iteration.approach + iteration.closing - iteration.square / (8.0 * radius_);
  const ArrayXd displacement =
      compliance_ * (iteration.matrices.influence * iteration.line_load.matrix()).array() / grid_.size;
  const double round_off = 1e-12 * (std::abs(iteration.approach) + displacement.maxCoeff());
  std::vector<Index> next;
  auto was = iteration.touching.begin();
  for (Index i = 0; i < room.size(); ++i) {
    const bool touched = was != iteration.touching.end() && *was == i;
    was += touched ? 1 : 0;
    if (touched ? iteration.line_load(i) > 0.0 : displacement(i) < room(i) - round_off) {
      next.push_back(i);
    }
  }
  const bool same = next == iteration.touching;
  iteration.touching = std::move(next);
  return same;
}

/// Eq. (3); returns the greatest change of a width over the greatest width, where there is load.
double StripContact::update_widths(Iteration& iteration) const {
  const ArrayXd load = iteration.line_load.max(0.0);
  const ArrayXd growth =
      4.0 * radius_ * compliance_ * (iteration.matrices.widening * load.matrix()).array() / grid_.size;
  const ArrayXd next = growth.max(kLeastGrowth).pow(kOverRelaxation) * iteration.square;
  const double greatest = (load > 0.0).select(next, 0.0).maxCoeff();
  const ArrayXd kept = next.max(1e-8 * greatest).min(100.0 * greatest);
  const ArrayXd change = (kept.sqrt() - iteration.square.sqrt()).abs() / std::sqrt(greatest);
  iteration.square = kept;
  return (load > 0.0).select(change, 0.0).maxCoeff();
}

RollerContactPressure StripContact::result(const Iteration& iteration, double tilt, double change) const {
  RollerContactPressure solution;
  solution.x = grid_.middle;
  solution.element = grid_.size;
  solution.line_load = iteration.line_load.max(0.0);
  const auto loaded = solution.line_load > 0.0;
  solution.half_width = loaded.select(iteration.square.sqrt(), 0.0);
  solution.pressure = loaded.select(
      2.0 * std::numbers::inv_pi * solution.line_load / iteration.square.max(1e-300).sqrt(),
      0.0);
  solution.approach = iteration.approach;
  solution.tilt = tilt;
  solution.energy =
      0.5 * compliance_ *
      solution.line_load.matrix().dot(iteration.matrices.influence * solution.line_load.matrix());
  solution.residual = change;
  measure(grid_, solution);
  return solution;
}

RollerContactPressure contact_pressure(const HalfSpaceContact& contact, const Relief& relief, double load,
                                       double tilt, const StripSettings& settings) {
  const StripContact strips(contact, settings);
  return strips.under_load(strips.relief(relief), load, tilt);
}

}  // namespace orbearing::bearing::half_space
