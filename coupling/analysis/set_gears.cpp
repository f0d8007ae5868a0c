#include "coupling/analysis/set_gears.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>

#include "coupling/analysis/planet_stiffness.hpp"
#include "gearset/mesh/loaded/tooth_pairs.hpp"

namespace orbearing::analysis {

namespace {

// A visitor of rows that collects the numbers of all members.
class NumbersOfRows {
 public:
  template <class Member>
  void operator()(const Member& member, const described::Facts&) {
    add(member);
  }

  std::vector<double> numbers;

 private:
  template <class Plain>
  requires(std::is_arithmetic_v<Plain> || std::is_enum_v<Plain>) void add(Plain value) {
    numbers.push_back(static_cast<double>(value));
  }
  void add(const std::optional<double>& value) {
    numbers.push_back(value ? 1.0 : 0.0);
    numbers.push_back(value.value_or(0.0));
  }
  void add(const std::vector<double>& list) {
    numbers.push_back(static_cast<double>(list.size()));
    numbers.insert(numbers.end(), list.begin(), list.end());
  }
};

// All that meshes follow from.
using MeshKey = std::vector<double>;

MeshKey mesh_key(gearset::PlanetarySet set, const SetGears& gears, const gearset::MeshMotion& motion,
                 const std::optional<double>& held_race) {
  NumbersOfRows rows;
  describe(rows, set);
  const gearset::BodyRatios& bodies = gears.choice.bodies;
  MeshKey key = std::move(rows.numbers);
  key.insert(key.end(), {set.planet_bore, bodies.sun_bore, bodies.ring_outside, gears.material.youngs_modulus,
                         gears.material.poisson_ratio, motion.sun_drives ? 1.0 : 0.0,
                         motion.sun_anticlockwise ? 1.0 : 0.0, held_race.value_or(-1.0)});
  return key;
}

class KnownMeshes {
 public:
  using Meshes = std::shared_ptr<const gearset::PlanetaryMeshes>;

  template <class Build>
  Meshes find_or(MeshKey key, const Build& build) {
    if (Meshes found = find(key)) return found;
    Meshes built = std::make_shared<const gearset::PlanetaryMeshes>(build());
    const std::scoped_lock lock(one_at_a_time_);
    if (known_.size() >= most) known_.clear();
    return known_.emplace(std::move(key), std::move(built)).first->second;
  }

 private:
  static constexpr std::size_t most = 64;

  Meshes find(const MeshKey& key) {
    const std::scoped_lock lock(one_at_a_time_);
    const auto found = known_.find(key);
    return found == known_.end() ? nullptr : found->second;
  }

  std::map<MeshKey, Meshes> known_;
  std::mutex one_at_a_time_;
};

std::optional<double> held_race_of(const PlanetaryDrivetrain& drivetrain) {
  if (drivetrain.rim == PlanetRim::rigid) return std::nullopt;
  return bearing::geometry_of(drivetrain.bearing).outer_radius;
}

}  // namespace

GearRunOptions gear_run_options(const GearRunPeriods& periods) {
  GearRunOptions options;
  options.observed_periods = periods.observed;
  options.most_windows = static_cast<int>(periods.settling / options.window_periods);
  options.series_periods = std::min(options.series_periods, options.observed_periods);
  return options;
}

DrivetrainGeometry geometry_of(const PlanetaryDrivetrain& drivetrain) {
  if (drivetrain.has_bearing()) return derive(drivetrain);
  DrivetrainGeometry geometry;
  geometry.gears = gearset::working_geometry(drivetrain.set);
  return geometry;
}

gearset::PlanetaryMeshes set_meshes(const PlanetaryDrivetrain& drivetrain,
                                    const gearset::WorkingGeometry& geometry, const SetGears& gears) {
  static KnownMeshes known;
  const gearset::dynamics::Operation operation = set_operation(drivetrain, geometry);
  const gearset::MeshMotion motion =
      gearset::mesh_motion(operation.torques.sun, operation.speeds.sun - operation.speeds.carrier);
  const std::optional<double> held_race = held_race_of(drivetrain);
  return *known.find_or(mesh_key(drivetrain.set, gears, motion, held_race), [&] {
    return gearset::planetary_meshes(drivetrain.set, geometry, gears.choice.bodies, gears.material.material(),
                                     motion, held_race);
  });
}

gearset::dynamics::SetModel gear_model(const PlanetaryDrivetrain& drivetrain,
                                       const DrivetrainGeometry& geometry, const SetGears& gears) {
  double rings = 0.0, stiffness = 0.0;  // [kg], [N/m]
  if (drivetrain.has_bearing()) {
    rings = drivetrain.bearings_per_planet * geometry.bearing.outer_ring_mass;
    if (!gears.choice.bearing_stiffness) stiffness = planet_bearing_stiffness(drivetrain, geometry);
  }
  gearset::dynamics::Operation operation = set_operation(drivetrain, geometry.gears);
  operation.run_up = gears.choice.run_up;
  gearset::dynamics::SetParameters set =
      geometric_set(gears.choice, drivetrain.set, geometry.gears,
                    set_meshes(drivetrain, geometry.gears, gears), rings, stiffness);
  linearise_meshes(set, operation);
  if (geometry.rim)
    set.planet.linked = {planet_stiffness(drivetrain, geometry, set.sun_mesh.stiffness.mean(),
                                          set.ring_mesh.stiffness.mean())};
  return set_model(std::move(set), operation);
}

gearset::dynamics::SetModel toothless_model(const gearset::PlanetarySet& set,
                                            const GearDynamicsChoice& choice, double carrier_speed) {
  gearset::dynamics::Operation operation;
  operation.speeds.carrier = carrier_speed;
  return set_model(lumped_set(choice, set.planets, set.rack.pressure_angle, set.planet_angles), operation);
}

std::function<gearset::dynamics::SetParameters()> gears_built_once(
    const PlanetaryDrivetrain& drivetrain, const SetGears& gears,
    const std::optional<DrivetrainGeometry>& known) {
  struct Built {
    std::once_flag once;
    gearset::dynamics::SetParameters set;
  };
  return [drivetrain, gears, known, built = std::make_shared<Built>()] {
    std::call_once(built->once, [&] {
      built->set = gear_model(drivetrain, known ? *known : geometry_of(drivetrain), gears).parameters;
    });
    return built->set;
  };
}

gearset::Warnings with_key_of_bore(gearset::Warnings warnings, const PlanetaryDrivetrain& drivetrain) {
  if (drivetrain.has_bearing()) return warnings;
  for (gearset::Warning& warning : warnings)
    if (warning.key == "bearing.outside_diameter") warning.key = "gearset.planet_bore_ratio";
  return warnings;
}

gearset::Warnings mesh_warnings(const PlanetaryDrivetrain& drivetrain, const SetGears& gears) {
  const gearset::WorkingGeometry geometry = gearset::working_geometry(drivetrain.set);
  const gearset::PlanetaryMeshes meshes = set_meshes(drivetrain, geometry, gears);
  gearset::Warnings warnings = gearset::foundation_warnings(meshes);
  if (drivetrain.set.flanks.contact != gearset::ToothContact::loaded)
    return with_key_of_bore(std::move(warnings), drivetrain);
  const double force = gearset::mean_loads(drivetrain.set, geometry, drivetrain.drive).normal_force;
  for (gearset::Warning& warning : gearset::edge_warnings(gearset::set_teeth(drivetrain.set, meshes), force))
    warnings.push_back(std::move(warning));
  return with_key_of_bore(std::move(warnings), drivetrain);
}

}  // namespace orbearing::analysis
