// A planetary set whose planet bearings are computed elsewhere: their forces in, motion at the pins out.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "coupling/system/participant.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::system {

/// All that is fixed before a run. With `set.planet.coupled_bearing` stiffness and damping of the planet's
/// bearing serve to find the state in which the run begins; without it they act besides the forces, so that
/// the set holds itself while others only listen.
struct DrivenGearsSetup {
  gearset::dynamics::SetParameters set;
  gearset::dynamics::Operation operation;
  double allowed_share = 1e-4;      // [-]  error of one step over the mean deflection of a mesh
  long most_steps = 10'000'000;     // [-]  in one call of advance() before it gives up
  std::vector<double> start_force;  // [N], [N], [N m]  (planets)  inputs at the start; none: zero
};

/// All data besides its inputs on which a gear set's future depends, in the order of an FMU's model.
template <class Visitor>
void describe(Visitor& visit, DrivenGearsSetup& m) {
  using namespace described;
  members(visit, m, part(m.set), part(m.operation),
          internal(m.allowed_share, "simulation.error_share",
                   "allowed error of one internal step over the mean mesh deflection", {.range = positive()}),
          internal(m.most_steps, "simulation.most_steps"), internal(m.start_force, "operation.planet_force"));
}

/// Motion of one planet at the present time.
struct PlanetMotion {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  // [m]    of its axis from that of its pin, (x, y)
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();      // [m/s]
  double angle = 0.0;            // [rad]  beyond the nominal rotation, relative to the carrier
  double speed = 0.0;            // [rad/s]  of the planet relative to the carrier, nominal speed included
  double sun_mesh_force = 0.0;   // [N]
  double ring_mesh_force = 0.0;  // [N]
};

struct DrivenGearsOutput {
  std::vector<PlanetMotion> planets;
  double carrier_speed = 0.0;         // [rad/s]   nominal: that of the frame
  double carrier_acceleration = 0.0;  // [rad/s^2]
};

/// Inputs: of each planet the forces of its bearings [N], outward and in the sense of carrier rotation, and
/// their moment [N m], positive counterclockwise; reversed on its pin. Not for use by two threads at once;
/// any number of objects side by side.
class DrivenGears final : public Participant {
 public:
  /// Throws std::invalid_argument, with what was found and what is required.
  explicit DrivenGears(const DrivenGearsSetup& setup);
  ~DrivenGears() override;
  DrivenGears(DrivenGears&&) noexcept;
  DrivenGears& operator=(DrivenGears&&) noexcept;

  /// To the static state under mean loads on bearings of the stated stiffness, whatever the forces.
  void initialize(double time, const std::vector<double>& forces = {}) override;
  /// To the static state on bearings that give `forces` at the present displacement and the stated stiffness
  /// about it. Called in turn with the bearings' own output it leads to the state in which both are in
  /// balance. Moments are left to the motion.
  void balance(double time, const std::vector<double>& forces) override;
  void advance(const Window& window, const std::vector<InputPolynomial>& forces) override;
  std::vector<double> values(const std::vector<double>& forces, std::size_t number) const override;
  /// Zero: motion follows forces only in time.
  std::vector<double> slopes(const std::vector<double>& forces, std::size_t input) const override;
  DrivenGearsOutput output() const;
  /// In the order of SetLayout.
  const Eigen::VectorXd& state() const;

  int planets() const;
  void save(SavedState& state) const override;
  /// Throws std::invalid_argument where `state` is not one of such a set.
  void restore(const SavedState& state) override;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace orbearing::system
