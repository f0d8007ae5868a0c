#include "app/study/gear_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <map>

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
using gearset::dynamics::Mode;
using gearset::dynamics::ModeKind;
using study::GearRunResult;
using study::PlanetStatistics;
using study::SignalStatistics;

using Signal = SignalStatistics PlanetStatistics::*;

// rms over all planets, and the largest of all.
Json of_all_planets(const GearRunResult& result, Signal signal) {
  double square = 0.0, largest = 0.0;
  for (const PlanetStatistics& planet : result.planets) {
    square += (planet.*signal).rms * (planet.*signal).rms / static_cast<double>(result.planets.size());
    largest = std::max(largest, (planet.*signal).maximum);
  }
  return {{"rms", std::sqrt(square)}, {"max", largest}};
}

// rms over all planets, along any one direction of the housing.
double housing_acceleration(const GearRunResult& result) {
  double square = 0.0;
  for (const PlanetStatistics& planet : result.planets)
    square += planet.housing_acceleration * planet.housing_acceleration /
              static_cast<double>(result.planets.size());
  return std::sqrt(square);
}

Json of_each_planet(const GearRunResult& result, Signal signal, bool harmonics) {
  Json list = Json::array();
  for (const PlanetStatistics& planet : result.planets) {
    const SignalStatistics& s = planet.*signal;
    Json one = {{"mean", s.mean}, {"rms", s.rms}, {"min", s.least}, {"max", s.largest}};
    if (harmonics) one["mesh_harmonics"] = s.amplitudes;
    list.push_back(std::move(one));
  }
  return list;
}

Json load_sharing(const GearRunResult& result) {
  Json share = Json::array(), most = Json::array();
  for (const PlanetStatistics& planet : result.planets) {
    share.push_back(planet.load_share);
    most.push_back(planet.most_load_share);
  }
  return {{"mean", share}, {"largest", most}};
}

}  // namespace

const char* kind_name(ModeKind kind) {
  switch (kind) {
    case ModeKind::rotational:
      return "rotational";
    case ModeKind::translational:
      return "translational";
    case ModeKind::planet:
      break;
  }
  return "planet";
}

Json modes_json(const std::vector<Mode>& modes) {
  Json list = Json::array();
  for (const Mode& mode : modes)
    list.push_back({{"frequency_Hz", mode.frequency},
                    {"kind", kind_name(mode.kind)},
                    {"multiplicity", mode.multiplicity},
                    {"growth_per_s", mode.growth}});
  return list;
}

std::string modes_text(const std::vector<Mode>& modes) {
  std::string text = fmt::format("{:>12}  {:14}{:>12}\n", "frequency_Hz", "kind", "multiplicity");
  for (const Mode& mode : modes)
    text += fmt::format("{:12.1f}  {:14}{:12}{}\n", mode.frequency, kind_name(mode.kind), mode.multiplicity,
                        mode.growth > 0.0 ? fmt::format("  grows at {:.3g} /s", mode.growth) : "");
  return text;
}

ModeStudy mode_study(const gearset::dynamics::SetModel& model) {
  const auto& planet = model.parameters.planet;
  return {modes_at_rest(model),
          std::sqrt(planet.bearing_stiffness / planet.mass) / boost::math::double_constants::two_pi};
}

double mode_property(const ModeStudy& study, const std::string& quantity) {
  std::map<std::string, int> count;
  for (const Mode& mode : study.modes) {
    if (!(mode.frequency > 0.0)) continue;
    const std::string kind = kind_name(mode.kind);
    const std::string name = fmt::format("{}_{}", kind, ++count[kind]);
    if (name + "_Hz" == quantity) return mode.frequency;
    if (name + "_1" == quantity) return mode.frequency / study.planet_frequency;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Json campbell_json(const gearset::dynamics::SetModel& model, double nominal_speed) {
  constexpr int steps = 20;
  constexpr int harmonics = 4;
  std::vector<double> factors;
  for (int i = 0; i <= steps; ++i) factors.push_back(static_cast<double>(i) / steps);
  const Eigen::MatrixXd frequencies = campbell_frequencies(model, factors);
  Json speeds = Json::array(), natural = Json::array(), mesh = Json::array();
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const auto column = frequencies.col(static_cast<Eigen::Index>(i));
    speeds.push_back(factors[i] * nominal_speed * 30.0 / boost::math::double_constants::pi);
    natural.push_back(std::vector<double>(column.begin(), column.end()));
    Json orders = Json::array();
    for (int order = 1; order <= harmonics; ++order)
      orders.push_back(order * factors[i] * model.operation.mesh_frequency);
    mesh.push_back(std::move(orders));
  }
  return {{"speed_rpm", speeds}, {"frequencies_Hz", natural}, {"mesh_harmonics_Hz", mesh}};
}

Json gear_run_json(const GearRunResult& result) {
  return {{"mesh_frequency_Hz", result.mesh_frequency},
          {"steady", result.steady},
          {"planet_acceleration_m_per_s2",
           {{"x", of_all_planets(result, &PlanetStatistics::radial_acceleration)},
            {"y", of_all_planets(result, &PlanetStatistics::tangential_acceleration)},
            {"housing_rms", housing_acceleration(result)},
            {"x_of_planets", of_each_planet(result, &PlanetStatistics::radial_acceleration, true)},
            {"y_of_planets", of_each_planet(result, &PlanetStatistics::tangential_acceleration, true)}}},
          {"mesh_force_N",
           {{"sun", of_each_planet(result, &PlanetStatistics::sun_mesh_force, true)},
            {"ring", of_each_planet(result, &PlanetStatistics::ring_mesh_force, true)}}},
          {"bearing_force_N",
           {{"x", of_each_planet(result, &PlanetStatistics::radial_force, true)},
            {"y", of_each_planet(result, &PlanetStatistics::tangential_force, true)}}},
          {"load_sharing", load_sharing(result)},
          {"share_of_time_with_parted_teeth", result.separated},
          {"run",
           {{"windows", result.windows},
            {"simulated_s", result.report.reached},
            {"steps", result.report.steps},
            {"rhs_calls", result.report.rhs_calls}}}};
}

std::string gear_run_text(const GearRunResult& result) {
  std::string text = fmt::format("mesh frequency {:.1f} Hz; {} after {} windows\n", result.mesh_frequency,
                                 result.steady ? "steady" : "NOT steady", result.windows);
  text += fmt::format("{:>6} {:>12} {:>12} {:>12} {:>12} {:>11} {:>11} {:>10}\n", "planet", "a_x rms",
                      "a_x max", "a_y rms", "a_y max", "sun max", "ring max", "share");
  text += fmt::format("{:>6} {:>12} {:>12} {:>12} {:>12} {:>11} {:>11} {:>10}\n", "", "m/s2", "m/s2", "m/s2",
                      "m/s2", "N", "N", "mean");
  for (std::size_t i = 0; i < result.planets.size(); ++i) {
    const PlanetStatistics& p = result.planets[i];
    text += fmt::format("{:>6} {:12.5g} {:12.5g} {:12.5g} {:12.5g} {:11.5g} {:11.5g} {:10.4f}\n", i + 1,
                        p.radial_acceleration.rms, p.radial_acceleration.maximum,
                        p.tangential_acceleration.rms, p.tangential_acceleration.maximum,
                        p.sun_mesh_force.largest, p.ring_mesh_force.largest, p.load_share);
  }
  if (result.separated > 0.0)
    text += fmt::format("some teeth are parted for {:.2g} % of the time\n", 100.0 * result.separated);
  return text;
}

}  // namespace orbearing::app
