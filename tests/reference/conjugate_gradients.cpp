#include "tests/reference/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace orbearing::bearing::half_space {

namespace {

using Eigen::ArrayXXd;

/// The parts of one iteration, on one problem.
class Descent {
 public:
  explicit Descent(ConjugateGradients& problem)
      : problem_(problem),
        weight_(problem.area.rowwise() * problem.count.transpose()),
        stiffness_((problem.compliance * problem.influence.own() / problem.area.col(0))
                       .inverse()
                       .replicate(1, problem.count.size())),
        direction_(ArrayXXd::Zero(problem.area.rows(), problem.area.cols())) {}

  /// Distance of the surfaces at the present pressure; the approach from the load, where that is given.
  void find_distance() {
    displacement_ = displacement(problem_.pressure);
    loaded_ = (problem_.pressure > 0.0).cast<double>();
    distance_ = displacement_ + problem_.gap;
    if (problem_.load > 0.0) {
      const ArrayXXd share = loaded_ * weight_ * stiffness_;
      problem_.approach = (share * distance_).sum() / share.sum();
    }
    distance_ -= problem_.approach;
  }

  double residual() const {
    const ArrayXXd share = loaded_ * weight_;
    const double rms = std::sqrt((share * distance_.square()).sum() / std::max(share.sum(), 1e-300));
    const double overlap = std::max(0.0, -((1.0 - loaded_) * distance_).minCoeff());
    return std::max(rms, overlap) / displacement_.maxCoeff();
  }

  void step() {
    const ArrayXXd gradient = loaded_ * stiffness_ * distance_;
    const double norm = (weight_ * gradient * distance_).sum();
    direction_ = gradient + (last_norm_ > 0.0 ? norm / last_norm_ : 0.0) * loaded_ * direction_;
    last_norm_ = norm;
    const double slope = (weight_ * distance_ * direction_).sum();
    const double bend = (weight_ * displacement(direction_) * direction_).sum();
    const double length = bend > 0.0 ? slope / bend : 0.0;
    problem_.pressure = (problem_.pressure - length * direction_).max(0.0);
    enter(length);
    if (problem_.load > 0.0) {
      problem_.pressure *= problem_.load / (weight_ * problem_.pressure).sum();
    }
  }

  double energy() const { return 0.5 * (weight_ * displacement_ * problem_.pressure).sum(); }

 private:
  ArrayXXd displacement(const ArrayXXd& pressure) const {
    return problem_.compliance * problem_.influence.apply(pressure) / problem_.area;
  }

  /// Unloaded elements that overlap take pressure; the directions start anew, since the set has grown.
  void enter(double length) {
    const auto overlaps = problem_.pressure <= 0.0 && distance_ < 0.0;
    if (overlaps.any()) {
      const double share = length > 0.0 ? length : 1.0;
      problem_.pressure =
          overlaps.select(problem_.pressure - share * stiffness_ * distance_, problem_.pressure).eval();
      last_norm_ = 0.0;
    }
  }

  ConjugateGradients& problem_;
  ArrayXXd weight_;     // [m^2]  area times count
  ArrayXXd stiffness_;  // [Pa/m]  of an element against its own pressure
  ArrayXXd direction_, displacement_, distance_, loaded_;
  double last_norm_ = 0.0;
};

}  // namespace

void ConjugateGradients::solve(double tolerance, int most_iterations) {
  Descent descent(*this);
  for (iterations = 0; iterations < most_iterations; ++iterations) {
    descent.find_distance();
    residual = descent.residual();
    if (residual < tolerance) {
      energy = descent.energy();
      return;
    }
    descent.step();
  }
  std::ostringstream message;
  message << "half-space contact: after " << most_iterations << " iterations the surfaces are still "
          << residual << " of the greatest displacement from touching; " << tolerance << " is required";
  throw std::runtime_error(message.str());
}

}  // namespace orbearing::bearing::half_space
