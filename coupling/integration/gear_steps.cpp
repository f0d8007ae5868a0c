#include "coupling/integration/gear_steps.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::integration {

using gearset::dynamics::SetModel;

namespace {

constexpr double kMargin = 1e-9;  // [mesh period]  kept off a jump: far above round-off, far below a step

}  // namespace

Jumps jumps_of(const SetModel& model, double from) {
  const std::vector<double> phases = jump_phases(model);
  const gearset::dynamics::Operation& operation = model.operation;
  if (phases.empty() || operation.mesh_frequency <= 0.0) return {};
  const double passed =
      from > 0.0 ? std::floor(gearset::dynamics::mesh_periods(operation, from)) : 0.0;  // [mesh period]
  const auto time = [phases, operation, passed](long index) {
    const long count = static_cast<long>(phases.size());
    const double periods =
        passed + static_cast<double>(index / count) + phases[static_cast<std::size_t>(index % count)];
    return gearset::dynamics::time_of_periods(operation, periods);
  };
  return {time, kMargin / operation.mesh_frequency};
}

Eigen::VectorXd gear_allowed_errors(const SetModel& model, double share) {
  constexpr double least_deflection = 1e-9;  // [m]  of a set that carries nothing
  const gearset::dynamics::SetParameters& set = model.parameters;
  const double force = std::abs(model.operation.torques.sun) / (set.planets * set.sun.radius);
  const double sun = set.sun_mesh.stiffness.mean(), ring = set.ring_mesh.stiffness.mean();
  const double length = share * std::max(least_deflection, force / std::min(sun, ring));
  const double frequency = std::sqrt((sun + ring) / set.planet.mass);
  Eigen::VectorXd allowed(model.layout.size());
  allowed.head(model.layout.freedoms()).setConstant(length);
  allowed.tail(model.layout.freedoms()).setConstant(length * frequency);
  return allowed;
}

}  // namespace orbearing::integration
