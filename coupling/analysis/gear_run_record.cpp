// Statistics of a run of gears in time as a result.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "coupling/analysis/gear_dynamics.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

namespace {

using described::each;
using described::Record;
namespace dimension = described::dimension;

struct NamedSignal {
  const char* key;   // of its table in JSON
  const char* name;  // of its series
  const described::Dimension& of;
  const char* meaning;
  SignalStatistics PlanetStatistics::*statistics;
  Eigen::ArrayXXd GearSeries::*series;
};

constexpr NamedSignal kMeshForces[] = {
    {"sun", "sun_mesh_force", dimension::force, "force of the sun mesh along the line of action",
     &PlanetStatistics::sun_mesh_force, &GearSeries::sun_mesh_force},
    {"ring", "ring_mesh_force", dimension::force, "force of the ring mesh along the line of action",
     &PlanetStatistics::ring_mesh_force, &GearSeries::ring_mesh_force}};
constexpr NamedSignal kBearingForces[] = {
    {"x", "bearing_force_x", dimension::force, "force of its bearings on the planet, outward",
     &PlanetStatistics::radial_force, &GearSeries::radial_force},
    {"y", "bearing_force_y", dimension::force,
     "force of its bearings on the planet, in the sense of carrier rotation",
     &PlanetStatistics::tangential_force, &GearSeries::tangential_force}};
constexpr NamedSignal kAccelerations[] = {
    {"x_of_planets", "planet_acceleration_x", dimension::acceleration,
     "acceleration of the planet in the carrier's frame, outward", &PlanetStatistics::radial_acceleration,
     &GearSeries::radial_acceleration},
    {"y_of_planets", "planet_acceleration_y", dimension::acceleration,
     "acceleration of the planet in the carrier's frame, in the sense of carrier rotation",
     &PlanetStatistics::tangential_acceleration, &GearSeries::tangential_acceleration}};

// A row for each planet, and the series of all.
template <class Signals>
void describe_signals(Record& record, const Signals& signals, const GearRunResult& result) {
  for (const NamedSignal& signal : signals) {
    record
        .table(signal.key, "planet", signal.meaning, result.planets,
               [&](Record& row, const PlanetStatistics& planet) {
                 const SignalStatistics& s = planet.*signal.statistics;
                 row.value("mean", signal.of, "mean", s.mean);
                 row.value("rms", signal.of, "root mean square", s.rms);
                 row.value("min", signal.of, "least value", s.least);
                 row.value("max", signal.of, "largest value", s.largest);
                 row.array("mesh_harmonics", signal.of, "amplitude at orders of the mesh frequency",
                           {"order"}, s.amplitudes)
                     .variable = "harmonics";
               })
        .variable = signal.name;
    record.series(signal.name, signal.of, signal.meaning, {"planet", "time"}, result.series.*signal.series);
  }
}

// rms over all planets, and the largest of all.
void describe_all_planets(Record& record, const char* name, const GearRunResult& result,
                          SignalStatistics PlanetStatistics::*signal) {
  double square = 0.0, largest = 0.0;
  for (const PlanetStatistics& planet : result.planets) {
    square += (planet.*signal).rms * (planet.*signal).rms / static_cast<double>(result.planets.size());
    largest = std::max(largest, (planet.*signal).maximum);
  }
  record.array(name, dimension::acceleration, "of all planets", {{"statistic", {"rms", "max"}}},
               std::array{std::sqrt(square), largest});
}

// rms over all planets, along any one direction of the housing.
double housing_acceleration(const GearRunResult& result) {
  double square = 0.0;
  for (const PlanetStatistics& planet : result.planets)
    square += planet.housing_acceleration * planet.housing_acceleration /
              static_cast<double>(result.planets.size());
  return std::sqrt(square);
}

void describe_accelerations(Record& record, const GearRunResult& result) {
  describe_all_planets(record, "x", result, &PlanetStatistics::radial_acceleration);
  describe_all_planets(record, "y", result, &PlanetStatistics::tangential_acceleration);
  for (const char* axis : {"x", "y"})
    record.entry(axis).variable = std::string("planet_acceleration_all_") + axis;
  record
      .value("housing_rms", dimension::acceleration, "along any direction fixed in the housing",
             housing_acceleration(result))
      .variable = "planet_acceleration_housing_rms";
  describe_signals(record, kAccelerations, result);
}

}  // namespace

void describe(Record& record, const GearRunResult& result) {
  record.value("mesh_frequency_Hz", dimension::cycles, "teeth that come into contact per time",
               result.mesh_frequency);
  record.value("steady", "whether the motion repeats", result.steady);
  const auto add = [&](const char* name, const char* meaning, const auto& fill) {
    record.child(name, meaning, result, fill).variable = "";
  };
  add("planet_acceleration_m_per_s2", "of the planets", describe_accelerations);
  add("mesh_force_N", "of the teeth",
      [](Record& forces, const GearRunResult& of) { describe_signals(forces, kMeshForces, of); });
  add("bearing_force_N", "on the planets",
      [](Record& forces, const GearRunResult& of) { describe_signals(forces, kBearingForces, of); });
  add("load_sharing", "tangential bearing force over the mean of all planets",
      [](Record& shares, const GearRunResult& of) {
        shares
            .array("mean", dimension::ratio, "over time", {"planet"},
                   each(of.planets, &PlanetStatistics::load_share))
            .variable = "load_share";
        shares
            .array("largest", dimension::ratio, "at an instant", {"planet"},
                   each(of.planets, &PlanetStatistics::most_load_share))
            .variable = "largest_load_share";
      });
  record
      .value("separated_fraction", dimension::ratio, "fraction of time with separated teeth",
             result.separated)
      .former = "share_of_time_with_parted_teeth";
  record.child("run", "of the integration", result, [](Record& run, const GearRunResult& of) {
    run.value("windows", "until steady", of.windows);
    run.value("simulated_s", dimension::time, "", of.report.reached);
    run.value("steps", "", of.report.steps);
    run.value("rhs_calls", "", of.report.rhs_calls);
  });
  std::vector<double> orders(result.planets.front().sun_mesh_force.amplitudes.size());
  std::iota(orders.begin(), orders.end(), 1.0);
  record.series("order", dimension::ratio, "order of the mesh frequency", {"order"}, orders);
  record.series("time", dimension::time, "since the start of the run", {"time"}, result.series.time);
}

}  // namespace orbearing::analysis
