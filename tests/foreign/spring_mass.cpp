#include "tests/foreign/spring_mass.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

namespace spring_mass {
namespace {

double force_at(const State& state, double since) {
  const auto& d = state.slopes;
  return state.real[force] + since * (d[0] + since * (d[1] / 2.0 + since * d[2] / 6.0));
}

// The classical Runge-Kutta scheme: exact for cubics.
void move(State& state, double length) {
  const auto& r = state.real;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / 1e-5)));
  const double h = length / steps;
  const auto acceleration = [&](double t, double x, double v) {
    return (force_at(state, t) - r[stiffness] * x - r[damping] * v) / r[mass];
  };
  double x = r[displacement] * 1e-3, v = r[velocity];  // mm outside
  for (int k = 0; k < steps; ++k) {
    const double t = k * h;
    const double a1 = acceleration(t, x, v), v2 = v + h / 2 * a1;
    const double a2 = acceleration(t + h / 2, x + h / 2 * v, v2), v3 = v + h / 2 * a2;
    const double a3 = acceleration(t + h / 2, x + h / 2 * v2, v3), v4 = v + h * a3;
    const double a4 = acceleration(t + h, x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  state.real[displacement] = x * 1e3;
  state.real[velocity] = v;
}

}  // namespace

Instance& alive(void* component) {
  auto& instance = *static_cast<Instance*>(component);
  if (instance.dead) std::abort();
  return instance;
}

int step(Instance& instance, double length) {
  State& state = instance.state;
  if (instance.fault == discards_long_steps && length > state.real[longest_step] * (1.0 + 1e-9)) {
    instance.log(2, "the step is too long");
    move(state, length / 2.0);  // and is left halfway
    state.time += length / 2.0;
    return 2;
  }
  if (instance.fault == fails || instance.fault == breaks_down) {
    instance.log(instance.fault == fails ? 3 : 4, "the spring broke");
    if (instance.fault == breaks_down) {
      static std::vector<std::unique_ptr<Instance>>
          left_alone;  // nobody may free it but the library that goes
      left_alone.emplace_back(&instance);
      instance.dead = true;
    }
    return instance.fault == fails ? 3 : 4;
  }
  move(state, length);
  state.slopes = {};
  state.time += length;
  return 0;
}

int set_reals(void* component, const unsigned* references, std::size_t number, const double* values) {
  Instance& instance = alive(component);
  for (std::size_t i = 0; i < number; ++i) {
    if (references[i] >= reals) return 3;
    instance.state.real[references[i]] = values[i];
  }
  return 0;
}

int get_reals(void* component, const unsigned* references, std::size_t number, double* values) {
  Instance& instance = alive(component);
  auto& r = instance.state.real;
  r[spring_force] = -r[spring_stiffness] * r[moved] - r[spring_damping] * r[moved_velocity];
  for (std::size_t i = 0; i < number; ++i) {
    if (references[i] >= reals) return 3;
    values[i] = instance.fault == gives_nan ? std::numeric_limits<double>::quiet_NaN() : r[references[i]];
  }
  return 0;
}

void start(Instance& instance) {
  auto& r = instance.state.real;
  r[mass] = 1.0;
  r[longest_step] = 1.0;
}

int end_initialization(void* component) {
  const Instance& instance = alive(component);
  if (instance.strict) instance.log(3, instance.label.c_str());
  return instance.strict ? 3 : 0;
}

int terminate(void* component) {
  if (alive(component).fault == fails) std::abort();  // it has failed: the standard forbids this call
  return 0;
}

}  // namespace spring_mass
