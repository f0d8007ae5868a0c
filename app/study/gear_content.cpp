#include <numeric>

#include "app/study/gear_output.hpp"

namespace orbearing::app {

namespace {

using study::GearRunResult;
using study::PlanetStatistics;
using study::SignalStatistics;

struct NamedSignal {
  const char* name;
  const char* units;
  const char* meaning;
  SignalStatistics PlanetStatistics::*statistics;
  Eigen::ArrayXXd study::GearSeries::*series;
};

constexpr NamedSignal kSignals[] = {
    {"sun_mesh_force", "N", "force of the sun mesh along the line of action",
     &PlanetStatistics::sun_mesh_force, &study::GearSeries::sun_mesh_force},
    {"ring_mesh_force", "N", "force of the ring mesh along the line of action",
     &PlanetStatistics::ring_mesh_force, &study::GearSeries::ring_mesh_force},
    {"bearing_force_x", "N", "force of its bearings on the planet, outward", &PlanetStatistics::radial_force,
     &study::GearSeries::radial_force},
    {"bearing_force_y", "N", "force of its bearings on the planet, in the sense of carrier rotation",
     &PlanetStatistics::tangential_force, &study::GearSeries::tangential_force},
    {"planet_acceleration_x", "m s-2", "acceleration of the planet in the carrier's frame, outward",
     &PlanetStatistics::radial_acceleration, &study::GearSeries::radial_acceleration},
    {"planet_acceleration_y", "m s-2",
     "acceleration of the planet in the carrier's frame, in the sense of carrier rotation",
     &PlanetStatistics::tangential_acceleration, &study::GearSeries::tangential_acceleration}};

void add_statistics(const NamedSignal& signal, const GearRunResult& result, PointContent& content) {
  const auto add = [&](const std::string& ending, const std::string& what, double SignalStatistics::*value) {
    content.add_each(signal.name + ending, {"planet"}, signal.units, what + " of the " + signal.meaning,
                     result.planets,
                     [&](const PlanetStatistics& planet) { return planet.*signal.statistics.*value; });
  };
  add("_mean", "mean", &SignalStatistics::mean);
  add("_rms", "root mean square", &SignalStatistics::rms);
  add("_min", "least value", &SignalStatistics::least);
  add("_max", "largest value", &SignalStatistics::largest);
  content.add_each(std::string(signal.name) + "_harmonics", {"planet", "order"}, signal.units,
                   std::string("amplitude at orders of the mesh frequency of the ") + signal.meaning,
                   result.planets,
                   [&](const PlanetStatistics& planet) { return (planet.*signal.statistics).amplitudes; });
}

void add_scalars(const GearRunResult& result, PointContent& content) {
  content.add("mesh_frequency", "Hz", "teeth that come into contact per time", result.mesh_frequency);
  content.add("parted_share", "1", "share of time with parted teeth", result.separated);
  content.add_each("load_share", {"planet"}, "1", "mean tangential bearing force over that of all planets",
                   result.planets, &PlanetStatistics::load_share);
  std::vector<double> orders(content.dimensions[1].size);
  std::iota(orders.begin(), orders.end(), 1.0);
  content.add("order", {"order"}, "1", "order of the mesh frequency", orders);
}

}  // namespace

PointContent gear_run_content(const GearRunResult& result) {
  PointContent content;
  content.dimensions = {{"planet", result.planets.size()},
                        {"order", result.planets.front().sun_mesh_force.amplitudes.size()},
                        {"time", static_cast<std::size_t>(result.series.time.size())}};
  add_scalars(result, content);
  content.add("time", {"time"}, "s", "time since the start of the run", result.series.time);
  for (const NamedSignal& signal : kSignals) {
    add_statistics(signal, result, content);
    content.add(signal.name, {"planet", "time"}, signal.units, signal.meaning, result.series.*signal.series);
  }
  return content;
}

}  // namespace orbearing::app
