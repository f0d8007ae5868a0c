// The planet of planet_motion.py written anew: what the foreign one is compared with.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "coupling/cosim/participant.hpp"

namespace orbearing::tests {

struct PlanetBodyParameters {
  double mass = 1.5;               // [kg]
  double inertia = 1e-3;           // [kg m^2]  about the planet's axis
  double orbit_radius = 0.0;       // [m]
  double carrier_speed = 0.0;      // [rad/s]
  double load_y = 0.0;             // [N]  of the gears
  double mesh_stiffness = 0.0;     // [N/m]  along y
  double mesh_damping = 0.0;       // [N s/m]
  double turning_stiffness = 0.0;  // [N m/rad]
  double turning_damping = 0.0;    // [N m s/rad]
  double start_x = 0.0;            // [m]
  double start_y = 0.0;            // [m]
};

class PlanetBody final : public cosim::Participant {
 public:
  /// `held`: forces at their mean over a window, as in an FMU that holds its inputs.
  PlanetBody(const PlanetBodyParameters& parameters, bool held) : p_{parameters}, held_{held} {}

  std::string name() const override { return "planet"; }
  const std::vector<cosim::Port>& ports() const override { return ports_; }

  void initialize(double, const std::vector<cosim::PortInput>& inputs) override {
    state_ = {p_.start_x, p_.start_y, 0.0, 0.0, 0.0, 0.0};
    set_input(inputs);
  }
  void set_input(const std::vector<cosim::PortInput>& inputs) override {
    for (std::size_t i = 0; i < 3; ++i) force_[i] = inputs[i].force;
  }
  void advance(const cosim::Window& window) override {
    if (held_) {
      for (cosim::Course& force : force_) force = mean(force, window.length());
    }
    const int count = static_cast<int>(std::max(1.0, std::round(window.length() / 1e-6)));
    const double h = window.length() / count;
    for (int k = 0; k < count; ++k) step(k * h, h);
  }
  void output(std::vector<cosim::PortOutput>& outputs) const override {
    outputs.assign(3, {});
    for (std::size_t i = 0; i < 3; ++i) {
      outputs[i].displacement = state_[i];
      outputs[i].velocity = state_[i + 3];
    }
  }
  void save(cosim::SavedState& state) const override { state.assign(state_.begin(), state_.end()); }
  void restore(const cosim::SavedState& state) override {
    for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = state.at(i);
  }

 private:
  using State = std::array<double, 6>;  // x, y, angle and their rates

  static cosim::Course mean(const cosim::Course& course, double h) {
    const auto& c = course.coefficient;
    return cosim::Course::constant(c[0] + h * (c[1] / 2.0 + h * (c[2] / 3.0 + h * c[3] / 4.0)));
  }
  State rates(double since, const State& s) const {
    const double turning = p_.carrier_speed;
    const double f_x = force_[0].at(since), f_y = force_[1].at(since), moment = force_[2].at(since);
    const double mesh = p_.load_y - p_.mesh_stiffness * s[1] - p_.mesh_damping * s[4];
    return {s[3],
            s[4],
            s[5],
            f_x / p_.mass + turning * turning * (p_.orbit_radius + s[0]) + 2.0 * turning * s[4],
            (f_y + mesh) / p_.mass + turning * turning * s[1] - 2.0 * turning * s[3],
            (moment - p_.turning_stiffness * s[2] - p_.turning_damping * s[5]) / p_.inertia};
  }
  static State moved(const State& s, double h, const State& k) {
    State sum;
    for (std::size_t i = 0; i < s.size(); ++i) sum[i] = s[i] + h * k[i];
    return sum;
  }
  // The classical Runge-Kutta scheme.
  void step(double since, double h) {
    const State k1 = rates(since, state_), k2 = rates(since + h / 2, moved(state_, h / 2, k1));
    const State k3 = rates(since + h / 2, moved(state_, h / 2, k2)),
                k4 = rates(since + h, moved(state_, h, k3));
    for (std::size_t i = 0; i < state_.size(); ++i) {
      state_[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
  }

  PlanetBodyParameters p_;
  bool held_;
  std::vector<cosim::Port> ports_ = {{"planet_1.x", cosim::PortKind::translation, cosim::Gives::motion},
                                     {"planet_1.y", cosim::PortKind::translation, cosim::Gives::motion},
                                     {"planet_1.rotation", cosim::PortKind::rotation, cosim::Gives::motion}};
  std::array<cosim::Course, 3> force_;
  State state_{};
};

}  // namespace orbearing::tests
