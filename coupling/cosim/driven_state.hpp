// The state of a driven bearing, and the numbers in which it is saved.
#pragma once

#include <array>

#include "bearing/life/damage.hpp"
#include "coupling/cosim/participant.hpp"

namespace orbearing::cosim {

/// All that the future of a driven bearing depends on.
struct DrivenState {
  Eigen::VectorXd flat;      // of the readable equations
  std::vector<double> x;     // padded, of the vectorised ones; one of both is in use
  double step = 1e-6;        // [s]    to try next
  double angle = 0.0;        // [rad]  of the bore
  double turned = 0.0;       // [rad]  there and back
  double step_before = 0.0;  // [s]    half of it is not counted yet
  bearing::dynamics::DamageSums sums{0};

  /// Every number in turn, for `visit(double* first, size)`.
  template <class Visit>
  void each(Visit visit) {
    for (double* one : {&step, &angle, &turned, &step_before}) visit(one, 1);
    visit(x.data(), static_cast<long>(x.size()));
    visit(flat.data(), static_cast<long>(flat.size()));
    sums.each(visit);
  }
};

/// What a saved state must agree in: rollers, places, which equations.
using StateKind = std::array<double, 3>;

void write(const StateKind& kind, DrivenState& state, SavedState& into);
/// Throws std::invalid_argument, with what was found and what is required, where `from` is of another kind,
/// version or length than `state`, which then is as before.
void read(const SavedState& from, const StateKind& kind, DrivenState& state);

}  // namespace orbearing::cosim
