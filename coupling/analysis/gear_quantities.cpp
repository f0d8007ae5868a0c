#include "coupling/analysis/gear_quantities.hpp"

#include <exception>
#include <stdexcept>

namespace orbearing::analysis {

namespace {

using described::Record;
namespace dimension = described::dimension;

constexpr double kAnySpring = 1e9;  // [N/m]
const std::string kBlock = "gearset.dynamics.";
const std::string kBearingStiffness = kBlock + "planet.bearing_stiffness";

// The model, or why there is none. A gear without a body is a mistake of the inputs.
std::optional<gearset::dynamics::SetModel> model_or_reason(const PlanetaryDrivetrain& drivetrain,
                                                           const SetGears& gears, std::string& reason) {
  try {
    return gear_model(drivetrain, geometry_of(drivetrain), gears);
  } catch (const std::domain_error&) {
    throw;
  } catch (const std::exception& error) {
    reason = error.what();
    return std::nullopt;
  }
}

void describe_missing(Record& record, const std::string& key, const std::string& reason) {
  record.value(key, dimension::ratio, "not computed: " + reason, described::kAbsent);
}

}  // namespace

GearQuantities gear_quantities(const PlanetaryDrivetrain& drivetrain, const SetGears& gears) {
  GearQuantities found;
  found.model = model_or_reason(drivetrain, gears, found.failure);
  if (found.model || gears.choice.bearing_stiffness) return found;
  PlanetaryDrivetrain rigid = drivetrain;
  rigid.rim = PlanetRim::rigid;
  SetGears on_springs = gears;
  on_springs.choice.bearing_stiffness = kAnySpring;
  found.model = model_or_reason(rigid, on_springs, found.failure_without_bearings);
  return found;
}

void describe(Record& record, const GearQuantities& of) {
  if (!of.model) {
    if (!of.failure_without_bearings.empty())
      describe_missing(record, kBlock + "mesh_stiffness", of.failure_without_bearings);
    return describe_missing(record, kBearingStiffness, of.failure);
  }
  const gearset::dynamics::SetParameters& set = of.model->parameters;
  const auto add_body = [&](const std::string& member, double mass, double inertia) {
    record.value(kBlock + member + ".mass_kg", dimension::mass, "as used by the dynamics", mass);
    record.value(kBlock + member + ".equivalent_mass_kg", dimension::mass, "moment of inertia / radius^2",
                 inertia);
  };
  add_body("sun", set.sun.mass, set.sun.inertia);
  add_body("ring", set.ring.mass, set.ring.inertia);
  add_body("carrier", set.carrier.mass, set.carrier.inertia);
  add_body("planet", set.planet.mass, set.planet.inertia);
  const std::string over_period = "mean over a mesh period";
  if (of.failure.empty())
    record.value(kBearingStiffness + "_N_per_m", dimension::stiffness,
                 "all bearings of a planet with their pins", set.planet.bearing_stiffness);
  record.value(kBlock + "mesh_stiffness.sun_N_per_m", dimension::stiffness, over_period,
               set.sun_mesh.stiffness.mean());
  record.value(kBlock + "mesh_stiffness.ring_N_per_m", dimension::stiffness, over_period,
               set.ring_mesh.stiffness.mean());
  if (of.model->operation.mesh_frequency > 0.0)
    record.value(kBlock + "mesh_frequency_Hz", dimension::cycles, "at input.speed",
                 of.model->operation.mesh_frequency);
  if (!of.failure.empty()) describe_missing(record, kBearingStiffness, of.failure);
}

}  // namespace orbearing::analysis
