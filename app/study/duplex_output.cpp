#include "app/study/duplex_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "app/results/json_number.hpp"
#include "app/results/result_row.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

namespace duplex = bearing::duplex;
using Json = nlohmann::ordered_json;

Json matrix_json(const duplex::Stiffness& matrix) {
  Json rows = Json::array();
  for (const auto& row : matrix.rowwise()) rows.push_back(std::vector<double>(row.begin(), row.end()));
  return rows;
}

template <class Vector>
Json freedoms_json(const Vector& v) {
  return {{"x", v[0]}, {"y", v[1]}, {"z", v[2]}, {"tilt_in_xz", v[3]}, {"tilt_in_yz", v[4]}};
}

Json modes_list(const duplex::PairModes& modes) {
  Json list = Json::array();
  for (const duplex::PairMode& mode : modes)
    list.push_back({{"frequency_Hz", mode.frequency},
                    {"kind", duplex::name_of(mode.kind)},
                    {"multiplicity", 1},
                    {"shape", freedoms_json(mode.shape)},
                    {"energy_share", freedoms_json(mode.energy_share)}});
  return list;
}

Json shaft_json(const duplex::Shaft& shaft) {
  return {{"mass_kg", shaft.mass},
          {"first_lever_mm", kMilli * shaft.levers.first},
          {"second_lever_mm", kMilli * shaft.levers.second},
          {"inertia_x_kg_m2", shaft.inertia_x},
          {"inertia_y_kg_m2", shaft.inertia_y}};
}

const char* stiffness_name(bool linear) {
  return linear ? "linear" : "nonlinear";
}

Json identified_json(const duplex::Identified& identified, const FrequencyErrors& fit,
                     const FrequencyErrors& prediction) {
  Json object = shaft_json(identified.shaft);
  object["converged"] = identified.converged;
  object["iterations"] = identified.iterations;
  const auto percent = [](const FrequencyErrors& errors) -> Json {
    return {{"mean_percent", number_or_null(100.0 * errors.mean)},
            {"worst_percent", number_or_null(100.0 * errors.worst)}};
  };
  object["fit"] = percent(fit);
  object["prediction"] = percent(prediction);
  return object;
}

Json identification_json(const Identification& found) {
  Json object{
      {"nonlinear", identified_json(found.nonlinear, found.nonlinear_fit, found.nonlinear_prediction)}};
  object["linear"] = found.linear ? identified_json(*found.linear, found.linear_fit, found.linear_prediction)
                                  : Json(nullptr);
  return object;
}

Json predictions_json(const Identification& found) {
  Json rows = Json::array();
  for (const PredictedPair& pair : found.pairs)
    for (std::size_t i = 0; i < 5; ++i)
      rows.push_back({{"contact_angle_deg", kDegree * pair.measured.contact_angle},
                      {"preload_N", pair.measured.preload},
                      {"kind", duplex::name_of(duplex::mode_kinds[i])},
                      {"measured_Hz", pair.measured.frequency[i]},
                      {"nonlinear_Hz", pair.nonlinear[i]},
                      {"linear_Hz", number_or_null(pair.linear[i])},
                      {"identified_from", pair.identified_from}});
  return rows;
}

std::string errors_text(const char* name, const duplex::Identified& identified, const FrequencyErrors& fit,
                        const FrequencyErrors& prediction) {
  const duplex::Shaft& shaft = identified.shaft;
  return fmt::format(
      "{:<10} {:>9.4f} {:>10.4f} {:>10.4f} {:>11.6f} {:>11.6f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}\n", name,
      shaft.mass, kMilli * shaft.levers.first, kMilli * shaft.levers.second, shaft.inertia_x, shaft.inertia_y,
      100.0 * fit.mean, 100.0 * fit.worst, 100.0 * prediction.mean, 100.0 * prediction.worst);
}

std::string identification_text(const Identification& found) {
  std::string text = fmt::format(
      "\nidentified from the pairs marked *, predicting all others\n{:<10} {:>9} {:>10} "
      "{:>10} {:>11} {:>11} {:>9} {:>9} {:>9} {:>9}\n",
      "stiffness", "m [kg]", "L1 [mm]", "L2 [mm]", "Jx [kg m2]", "Jy [kg m2]", "fit [%]", "worst",
      "pred. [%]", "worst");
  text += errors_text("nonlinear", found.nonlinear, found.nonlinear_fit, found.nonlinear_prediction);
  if (found.linear) text += errors_text("linear", *found.linear, found.linear_fit, found.linear_prediction);
  text += fmt::format("\n{:>9} {:>11} {:<9} {:>14} {:>15} {:>8} {:>12} {:>8}\n", "[deg]", "preload [N]",
                      "mode", "measured [Hz]", "nonlinear [Hz]", "[%]", "linear [Hz]", "[%]");
  for (const PredictedPair& pair : found.pairs)
    for (std::size_t i = 0; i < 5; ++i) {
      const double measured = pair.measured.frequency[i];
      text += fmt::format("{:>8.4g}{} {:>11.6g} {:<9} {:>14.2f} {:>15.2f} {:>+8.1f} {:>12.2f} {:>+8.1f}\n",
                          kDegree * pair.measured.contact_angle, pair.identified_from ? "*" : " ",
                          pair.measured.preload, duplex::name_of(duplex::mode_kinds[i]), measured,
                          pair.nonlinear[i], 100.0 * (pair.nonlinear[i] / measured - 1.0), pair.linear[i],
                          100.0 * (pair.linear[i] / measured - 1.0));
    }
  return text;
}

void add_modes(const PairColumn& column, PointContent& content) {
  content.add_each("natural_frequency", {"mode"}, "s-1", "tilt_x, tilt_y, axial_z, radial_x, radial_y",
                   column.modes, &duplex::PairMode::frequency);
  content.add_each("mode_shape", {"mode", "freedom"}, "1",
                   "x, y, z [m], tilts in the planes of x and z, y and z [rad], of modal mass 1 kg",
                   column.modes, &duplex::PairMode::shape);
  content.add("stiffness", {"freedom", "freedom_beside"}, "1",
              "of the shaft about its mass centre [N/m], [N/rad], [N m/m], [N m/rad]", column.stiffness);
}

std::string status_of(const PairAtSpeed& point) {
  return point.modes ? "ok" : point.state.report.message;
}

// Frequencies [Hz], angles [deg] and loads [N] of the ball with the largest load on the inner race: by name.
std::vector<std::pair<std::string, double>> values_at(const PairAtSpeed& point) {
  std::vector<std::pair<std::string, double>> values;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < duplex::mode_kinds.size(); ++i)
    values.emplace_back(std::string(duplex::name_of(duplex::mode_kinds[i])) + "_Hz",
                        point.modes ? (*point.modes)[i].frequency : none);
  const bearing::equilibrium::RingState& state = point.state;
  Eigen::Index ball = 0;
  if (point.modes) state.contact_load.maxCoeff(&ball);
  const auto of_ball = [&](const Eigen::ArrayXd& inner, const Eigen::ArrayXd& outer) {
    return !point.modes ? none : outer.size() > 0 ? outer[ball] : inner[ball];
  };
  const auto& [load, angle] = std::pair(state.contact_load, state.contact_angle);
  values.emplace_back("inner_angle_deg", kDegree * of_ball(angle, {}));
  values.emplace_back("outer_angle_deg", kDegree * of_ball(angle, state.outer_angle));
  values.emplace_back("inner_load_max_N", of_ball(load, {}));
  values.emplace_back("outer_load_max_N", of_ball(load, state.outer_load));
  return values;
}

void add_speeds_of_pair(const std::vector<PairAtSpeed>& points, PointContent& content) {
  content.add_dimension("speed", points.size());
  content.add_each("over_speed_speed", {"speed"}, "rad s-1", "of the shaft", points, &PairAtSpeed::speed);
  content.add_each("over_speed_natural_frequency", {"speed", "mode"}, "s-1",
                   "order of natural_frequency; none: no balance", points, [](const PairAtSpeed& point) {
                     std::array<double, duplex::mode_kinds.size()> frequency;
                     for (std::size_t i = 0; i < frequency.size(); ++i)
                       frequency[i] = point.modes ? (*point.modes)[i].frequency
                                                  : std::numeric_limits<double>::quiet_NaN();
                     return frequency;
                   });
}

void add_response(const Response& response, PointContent& content) {
  const std::size_t lines = response.accelerance[0].size();
  content.add_dimension("line", lines);
  std::vector<double> frequency;
  for (std::size_t k = 1; k <= lines; ++k) frequency.push_back(static_cast<double>(k) * response.step);
  content.add("frequency", {"line"}, "s-1", "of the frequency response", frequency);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    const auto add = [&](const char* part, double (*value)(const std::complex<double>&)) {
      content.add_each("accelerance_" + axis + part, {"line"}, "kg-1",
                       "acceleration over force along " + axis, response.accelerance[i], value);
    };
    add("_real", [](const std::complex<double>& value) { return value.real(); });
    add("_imaginary", [](const std::complex<double>& value) { return value.imag(); });
  }
}

void add_predictions(const Identification& found, PointContent& content) {
  content.add_dimension("pair", found.pairs.size());
  const auto add = [&](const char* name, std::vector<std::string> along, const char* units,
                       const char* meaning, const auto& value) {
    content.add_each(name, std::move(along), units, meaning, found.pairs, value);
  };
  add("measured_contact_angle", {"pair"}, "rad", "nominal",
      [](const PredictedPair& pair) { return pair.measured.contact_angle; });
  add("measured_preload", {"pair"}, "N", "of each row",
      [](const PredictedPair& pair) { return pair.measured.preload; });
  add("identified_from", {"pair"}, "1", "1 where the shaft was identified from the pair",
      &PredictedPair::identified_from);
  add("measured_frequency", {"pair", "mode"}, "s-1", "natural frequencies",
      [](const PredictedPair& pair) { return pair.measured.frequency; });
  add("nonlinear_frequency", {"pair", "mode"}, "s-1", "with the identified shaft", &PredictedPair::nonlinear);
  add("linear_frequency", {"pair", "mode"}, "s-1", "with the shaft identified for it",
      &PredictedPair::linear);
}

}  // namespace

Json pair_modes_json(const PairPoint& point) {
  Json object{{"stiffness", stiffness_name(point.linear)}, {"modes", modes_list(point.asked().modes)}};
  if (!point.printed) return object;
  const PairColumn& other = point.linear ? point.nonlinear : *point.printed;
  object["other"] = {{"stiffness", stiffness_name(!point.linear)}, {"modes", modes_list(other.modes)}};
  return object;
}

std::string pair_modes_text(const PairPoint& point) {
  std::string text = fmt::format("{:<10} {:>16} {:>18}\n", "kind", "frequency [Hz]",
                                 point.printed ? (point.linear ? "(nonlinear [Hz])" : "(linear [Hz])") : "");
  for (std::size_t i = 0; i < 5; ++i) {
    const duplex::PairMode& mode = point.asked().modes[i];
    text += fmt::format("{:<10} {:>16.2f}", duplex::name_of(mode.kind), mode.frequency);
    if (point.printed)
      text += fmt::format(" {:>18.2f}", (point.linear ? point.nonlinear : *point.printed).modes[i].frequency);
    text += "\n";
  }
  return text;
}

Json pair_speeds_json(const std::vector<PairAtSpeed>& points) {
  Json rows = Json::array();
  for (const PairAtSpeed& point : points) {
    Json row{{"speed_rpm", speed_in_rpm(point.speed)}, {"status", status_of(point)}};
    for (const auto& [name, value] : values_at(point)) row[name] = number_or_null(value);
    rows.push_back(std::move(row));
  }
  return rows.empty() ? Json::object() : Json{{"over_speed", rows}};
}

std::string pair_speeds_text(const std::vector<PairAtSpeed>& points) {
  if (points.empty()) return "";
  std::string text = fmt::format("\n{:>12}", "speed [rpm]");
  for (const auto& [name, value] : values_at(points.front())) text += fmt::format(" {:>17}", name);
  for (const PairAtSpeed& point : points) {
    text += fmt::format("\n{:>12.6g}", speed_in_rpm(point.speed));
    for (const auto& [name, value] : values_at(point))
      text += std::isfinite(value) ? fmt::format(" {:>17.2f}", value) : fmt::format(" {:>17}", "-");
    if (!point.modes) text += "  " + status_of(point);
  }
  return text + "\n";
}

std::string pair_speeds_csv(const std::vector<PairAtSpeed>& points) {
  std::string text = "speed_rpm";
  for (const auto& [name, value] : values_at({})) text += "," + name;
  text += ",status\n";
  for (const PairAtSpeed& point : points) {
    text += fmt::format("{:.9g}", speed_in_rpm(point.speed));
    for (const auto& [name, value] : values_at(point))
      text += std::isfinite(value) ? fmt::format(",{:.9g}", value) : ",";
    text += ",\"" + status_of(point) + "\"\n";
  }
  return text;
}

Json duplex_json(const DuplexStudy& study) {
  const PairPoint& point = study.point;
  Json object = pair_modes_json(point);
  object.update(pair_speeds_json(study.over_speed));
  const auto& [loads, angles] = std::pair(point.state.contact_load, point.state.contact_angle);
  object["approach_um"] = kMicro * point.approach;
  object["contact_angle_deg"] = kDegree * angles[0];
  object["contact_load_max_N"] = loads.maxCoeff();
  if (point.state.outer_load.size() > 0) {
    object["outer_contact_angle_deg"] = kDegree * point.state.outer_angle[0];
    object["outer_contact_load_max_N"] = point.state.outer_load.maxCoeff();
  }
  object["pressure_max_MPa"] = 1e-6 * point.state.largest_pressure;
  object["shaft"] = shaft_json(point.asked().shaft);
  object["stiffness_matrix"] = matrix_json(point.asked().stiffness);
  if (study.identification) {
    object["identified"] = identification_json(*study.identification);
    object["predictions"] = predictions_json(*study.identification);
  }
  Json peaks = Json::array();
  for (const auto& line : study.response.accelerance) {
    double most = 0.0;
    for (const std::complex<double>& value : line) most = std::max(most, std::abs(value));
    peaks.push_back(most);
  }
  object["response"] = {{"step_Hz", study.response.step}, {"accelerance_max_per_kg", peaks}};
  return object;
}

std::string duplex_text(const DuplexStudy& study) {
  const PairPoint& point = study.point;
  std::string text = fmt::format(
      "each row pressed by {:.5g} um: contact angle {:.4f} deg, largest contact load {:.6g} N, {:.5g} "
      "MPa\n\n",
      kMicro * point.approach, kDegree * point.state.contact_angle[0], point.state.contact_load.maxCoeff(),
      1e-6 * point.state.largest_pressure);
  text += pair_modes_text(point) + pair_speeds_text(study.over_speed);
  return study.identification ? text + identification_text(*study.identification) : text;
}

PointContent duplex_content(const DuplexStudy& study) {
  const bearing::equilibrium::RingState& state = study.point.state;
  PointContent content;
  for (const char* name : {"mode", "freedom", "freedom_beside"}) content.add_dimension(name, 5);
  content.add_dimension("ball", state.contact_load.size());
  content.add("approach", "m", "of each row under preload", study.point.approach);
  content.add("contact_load", {"ball"}, "N", "of the first row's balls, then of the second's",
              state.contact_load);
  content.add("contact_angle", {"ball"}, "rad", "the same", state.contact_angle);
  if (state.outer_load.size() > 0) {
    content.add("outer_contact_load", {"ball"}, "N",
                "on the outer races; contact_load is that on the inner ones", state.outer_load);
    content.add("outer_contact_angle", {"ball"}, "rad", "the same", state.outer_angle);
  }
  add_modes(study.point.asked(), content);
  if (!study.over_speed.empty()) add_speeds_of_pair(study.over_speed, content);
  add_response(study.response, content);
  if (study.identification) add_predictions(*study.identification, content);
  return content;
}

std::string predictions_csv(const DuplexStudy& study) {
  std::string text = "contact_angle_deg,preload_N,kind,measured_Hz,nonlinear_Hz,linear_Hz,identified_from\n";
  if (!study.identification) return text;
  for (const PredictedPair& pair : study.identification->pairs)
    for (std::size_t i = 0; i < 5; ++i)
      text += fmt::format("{:.9g},{:.9g},{},{:.9g},{:.9g},{},{}\n", kDegree * pair.measured.contact_angle,
                          pair.measured.preload, duplex::name_of(duplex::mode_kinds[i]),
                          pair.measured.frequency[i], pair.nonlinear[i],
                          std::isfinite(pair.linear[i]) ? fmt::format("{:.9g}", pair.linear[i]) : "",
                          pair.identified_from ? 1 : 0);
  return text;
}

}  // namespace orbearing::app
