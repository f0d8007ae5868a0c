// A planetary set whose planet bearings are computed elsewhere: their forces in, motion at the pins out. The
// core of the gear set as a participant and as an FMU.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "coupling/system/course.hpp"
#include "gearset/dynamics/parameters.hpp"

namespace orbearing::cosim {

/// All that is fixed before a run. With `set.planet.coupled_bearing` stiffness and damping of the planet's
/// bearing serve to find the state in which the run begins; without it they act beside the forces, so that
/// the set holds itself while others only listen.
struct DrivenGearsSetup {
  gearset::dynamics::SetParameters set;
  gearset::dynamics::Operation operation;
  double allowed_share = 1e-4;   // [-]  error of one step over the mean deflection of a mesh
  long most_steps = 10'000'000;  // [-]  in one call of advance() before it gives up
};

/// Forces of the bearings on one planet over a window; reversed on its pin.
struct PlanetForceCourse {
  Course x, y;    // [N]    outward, and in the sense of carrier rotation
  Course moment;  // [N m]  about the planet's axis, positive counterclockwise
};

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
  double planet_speed = 0.0;          // [rad/s]   nominal, relative to the carrier
  double carrier_speed = 0.0;         // [rad/s]   nominal: that of the frame
  double carrier_acceleration = 0.0;  // [rad/s^2]
};

/// Not for use by two threads at once; any number of objects side by side.
class DrivenGears {
 public:
  /// Throws std::invalid_argument, with what was found and what is required.
  explicit DrivenGears(const DrivenGearsSetup& setup);
  ~DrivenGears();
  DrivenGears(DrivenGears&&) noexcept;
  DrivenGears& operator=(DrivenGears&&) noexcept;

  /// To the static state under mean loads on bearings of the stated stiffness.
  void initialize(double time);
  /// Before the first window: to the static state on bearings that give `forces` at the present displacement
  /// and the stated stiffness about it. Called in turn with the bearings' own answers it leads to the state
  /// in which both are in balance. Moments are left to the motion.
  void balance(const std::vector<PlanetForceCourse>& forces);
  /// From `window.begin` to its end. On an error (std::runtime_error) the state is that at the beginning.
  void advance(const Window& window, const std::vector<PlanetForceCourse>& forces);
  DrivenGearsOutput output() const;
  /// In the order of SetLayout.
  const Eigen::VectorXd& state() const;

  int planets() const;
  void save(SavedState& state) const;
  /// Throws std::invalid_argument where `state` is not one of such a set.
  void restore(const SavedState& state);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace orbearing::cosim
