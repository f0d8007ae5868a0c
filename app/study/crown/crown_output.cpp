#include "app/study/crown/crown_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "app/results/json_number.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

using nlohmann::ordered_json;
using namespace study::crowning;

ordered_json point_json(const CrownPoint& point, const std::string& profile) {
  const bool ok = point.status == "ok";
  return {{"drop_um", in_table_unit(point.drop, kMicro)},
          {"tilt_mrad", in_table_unit(point.tilt, kMilli)},
          {"life_h", number_or_null(point.life_hours)},
          {"peak_pressure_MPa", ok ? number_or_null(kMega * point.pressure.peak) : nullptr},
          {"edge_ratio", ok ? number_or_null(point.pressure.edge_ratio) : nullptr},
          {"profile", profile},
          {"L10mh", number_or_null(point.modified_life_hours)},
          {"status", point.status}};
}

ordered_json design_json(const CrownDesign& design, LifeMeasure measure) {
  const char* other = measure == LifeMeasure::iso16281 ? "lundberg_palmgren_life_h" : "iso16281_life_h";
  ordered_json object{{"profile", design.profile},
                      {"drop_um", kMicro * design.crown.drop},
                      {"life_h", number_or_null(design.life_hours)},
                      {"peak_pressure_MPa", number_or_null(kMega * design.peak_pressure)},
                      {"edge_ratio", number_or_null(design.edge_ratio)},
                      {"untilted_life_h", number_or_null(design.untilted_life_hours)},
                      {other, number_or_null(design.other_life_hours)},
                      {"L10mh", number_or_null(design.modified_life_hours)},
                      {"half_space_life_h", number_or_null(design.pressure_life_hours)},
                      {"untilted_half_space_life_h", number_or_null(design.untilted_pressure_life_hours)}};
  if (design.has_share) object["crowned_share"] = design.crown.share;
  if (std::isfinite(design.life_in_band)) object["life_in_band_h"] = design.life_in_band;
  return object;
}

ordered_json search_json(const CrownSearch& search, LifeMeasure measure) {
  ordered_json object = design_json(search.best, measure);
  ordered_json ends = ordered_json::array();
  for (const SearchEnd& end : search.ends)
    ends.push_back({{"start_um", kMicro * end.start.drop},
                    {"drop_um", kMicro * end.crown.drop},
                    {"crowned_share", search.best.has_share ? ordered_json(end.crown.share) : nullptr},
                    {"life_h", number_or_null(end.life_hours)},
                    {"evaluations", end.evaluations}});
  object["starts"] = {{"count", search.ends.size()}, {"in_optimum", search.in_best}, {"ends", ends}};
  return object;
}

ordered_json front_json(const CrownStudy& study) {
  ordered_json front = ordered_json::array();
  for (std::size_t profile = 0; profile < study.worst.size(); ++profile)
    for (const WorstOfTilts& one : study.worst[profile])
      if (one.efficient)
        front.push_back({{"profile", study.request.profiles[profile]},
                         {"drop_um", in_table_unit(one.drop, kMicro)},
                         {"life_h", one.life_hours},
                         {"peak_pressure_MPa", kMega * one.peak_pressure}});
  return front;
}

double power_at(const CrownStudy& study, const SpectrumPoint& point) {
  return point.power.value_or(study.request.drivetrain.drive.power);
}

// Of the points of the spectrum those that turn for some time, in their order, as the problem takes them.
ordered_json duties_json(const CrownStudy& study) {
  ordered_json duties = ordered_json::array();
  for (const SpectrumPoint& point : study.request.spectrum) {
    if (point.speed <= 0.0 || point.share <= 0.0) continue;
    const DutyRecord& record = study.recommended.duties[duties.size()];
    duties.push_back({{"input_speed_rpm", in_table_unit(point.speed, kRpm)},
                      {"power_kW", in_table_unit(power_at(study, point), kKilo)},
                      {"share", point.share},
                      {"tilt_mrad", in_table_unit(record.tilt, kMilli)},
                      {"life_h", number_or_null(record.life_hours)},
                      {"damage_share", number_or_null(record.damage_share)},
                      {"peak_pressure_MPa", number_or_null(kMega * record.pressure.peak)},
                      {"edge_ratio", number_or_null(record.pressure.edge_ratio)}});
  }
  return duties;
}

ordered_json recommended_json(const CrownStudy& study) {
  const auto& [design, band, duties] = study.recommended;
  return {{"profile", design.profile},
          {"drop_um", kMicro * design.crown.drop},
          {"least_drop_um", kMicro * band.least},
          {"most_drop_um", kMicro * band.most},
          {"most_is_greatest_studied", band.open},
          {"life_h", number_or_null(design.life_hours)},
          {"life_kept_in_band", kKeptLife},
          {"straight_life_share", number_or_null(study.straight.life_hours / design.life_hours)},
          {"no_crown_needed", band.least == 0.0},
          {"points", duties_json(study)}};
}

std::string recommended_text(const CrownStudy& study) {
  const auto& [design, band, duties] = study.recommended;
  return fmt::format(
      "recommended: {}, drop {:.3g} um; from {:.3g} to {:.3g} um{} at least {:.0f} % of its life is "
      "left, straight rollers leave {:.0f} %{}\n",
      design.profile, kMicro * design.crown.drop, kMicro * band.least, kMicro * band.most,
      band.open ? " (the greatest studied)" : "", 100.0 * kKeptLife,
      100.0 * study.straight.life_hours / design.life_hours, band.least == 0.0 ? ": no crown is needed" : "");
}

ordered_json spectrum_json(const CrownStudy& study) {
  ordered_json spectrum = ordered_json::array();
  for (const SpectrumPoint& point : study.request.spectrum)
    spectrum.push_back({{"input_speed_rpm", in_table_unit(point.speed, kRpm)},
                        {"power_kW", in_table_unit(power_at(study, point), kKilo)},
                        {"share", point.share}});
  return spectrum;
}

std::string design_line(const char* name, const CrownDesign& design, double straight) {
  std::string line =
      fmt::format("{:<12} {:<18} {:>8.3g} {:>10.0f} {:>8.3g} {:>10.0f} {:>10.0f} {:>6.2f} {:>11.0f}", name,
                  design.profile, kMicro * design.crown.drop, design.life_hours, design.life_hours / straight,
                  design.untilted_life_hours, kMega * design.peak_pressure, design.edge_ratio,
                  design.pressure_life_hours);
  if (design.has_share) line += fmt::format("  crowned over {:.3g} of each half", design.crown.share);
  if (std::isfinite(design.life_in_band))
    line += fmt::format("  {:.0f} h within the tolerances", design.life_in_band);
  return line + "\n";
}

std::string grid_text(const CrownStudy& study, std::size_t profile) {
  const std::vector<double>& tilts = study.request.tilts;
  std::string text =
      fmt::format("profile {}: life [h], peak pressure [MPa], edge ratio at tilts of the bore\n{:>10}",
                  study.request.profiles[profile], "drop [um]");
  for (const double tilt : tilts)
    text += fmt::format("  | {:>24}", fmt::format("{:.4g} mrad", kMilli * tilt));
  text += '\n';
  for (std::size_t i = 0; i < study.points[profile].size(); ++i) {
    const CrownPoint& point = study.points[profile][i];
    if (i % tilts.size() == 0) text += fmt::format("{:>10.4g}", kMicro * point.drop);
    text += point.status == "ok" ? fmt::format("  | {:>10.0f} {:>7.0f} {:>5.2f}", point.life_hours,
                                               kMega * point.pressure.peak, point.pressure.edge_ratio)
                                 : fmt::format("  | {:>24}", "no balance");
    if ((i + 1) % tilts.size() == 0) text += '\n';
  }
  return text + '\n';
}

std::string where_text(const CrownStudy& study) {
  const auto& spectrum = study.request.spectrum;
  const auto [low, high] =
      std::minmax_element(spectrum.begin(), spectrum.end(),
                          [](const SpectrumPoint& a, const SpectrumPoint& b) { return a.speed < b.speed; });
  const std::string where = spectrum.size() == 1
                                ? fmt::format("input speed {:.6g} rpm", kRpm * spectrum.front().speed)
                                : fmt::format("spectrum of {} points, {:.6g} to {:.6g} rpm", spectrum.size(),
                                              kRpm * low->speed, kRpm * high->speed);
  return fmt::format("{}; life by laminae after {}; worst of tilts {:.4g} to {:.4g} mrad\n", where,
                     name_of(study.request.measure), kMilli * study.request.tilts.front(),
                     kMilli * study.request.tilts.back());
}

NamedArray grid_array(const CrownStudy& study, const char* name, const char* units, const char* meaning,
                      double (*value)(const CrownPoint&)) {
  NamedArray array{name, {"profile", "drop", "tilt"}, units, meaning, {}};
  for (const auto& points : study.points)
    for (const CrownPoint& point : points)
      array.values.push_back(point.status == "ok" ? value(point) : std::nan(""));
  return array;
}

}  // namespace

ordered_json crown_json(const CrownStudy& study) {
  const LifeMeasure measure = study.request.measure;
  ordered_json points = ordered_json::array();
  for (std::size_t profile = 0; profile < study.points.size(); ++profile)
    for (const CrownPoint& point : study.points[profile])
      points.push_back(point_json(point, study.request.profiles[profile]));
  ordered_json object{{"life_measure", name_of(measure)},
                      {"laminae", study.request.laminae},
                      {"spectrum", spectrum_json(study)},
                      {"points", points},
                      {"optimum", search_json(study.searches[study.best], measure)},
                      {"recommended", recommended_json(study)},
                      {"straight", design_json(study.straight, measure)},
                      {"reference", design_json(study.reference, measure)}};
  if (!study.robust.empty()) object["robust"] = search_json(study.robust[study.best_robust], measure);
  object["optima"] = ordered_json::array();
  for (const CrownSearch& search : study.searches) object["optima"].push_back(search_json(search, measure));
  object["front"] = front_json(study);
  return object;
}

std::string crown_text(const CrownStudy& study) {
  std::string text = where_text(study) + '\n';
  for (std::size_t profile = 0; profile < study.points.size(); ++profile) text += grid_text(study, profile);
  const double straight = study.straight.life_hours;
  text += fmt::format("{:<12} {:<18} {:>8} {:>10} {:>8} {:>10} {:>10} {:>6} {:>11}\n", "worst tilt",
                      "profile", "drop", "life", "times", "untilted", "peak", "edge", "life [h] of");
  text += fmt::format("{:<12} {:<18} {:>8} {:>10} {:>8} {:>10} {:>10} {:>6} {:>11}\n", "", "", "[um]", "[h]",
                      "straight", "[h]", "[MPa]", "ratio", "half-space");
  text += design_line("straight", study.straight, straight);
  text += design_line("ISO/TS 16281", study.reference, straight);
  for (const CrownSearch& search : study.searches) text += design_line("optimum", search.best, straight);
  for (const CrownSearch& search : study.robust) text += design_line("tolerant", search.best, straight);
  return text + recommended_text(study);
}

PointContent crown_content(const CrownStudy& study) {
  const CrownRequest& request = study.request;
  PointContent content;
  content.dimensions = {
      {"profile", request.profiles.size()}, {"drop", request.drops.size()}, {"tilt", request.tilts.size()}};
  content.arrays = {
      {"drop", {"drop"}, "m", "relief of one roller at the outermost of 40 laminae", request.drops},
      {"tilt",
       {"tilt"},
       "rad",
       "tilt of the planet's bore on its pin in the plane of the load",
       request.tilts},
      grid_array(study, "life", "h", "life of one bearing", [](const CrownPoint& p) { return p.life_hours; }),
      grid_array(study, "L10mh", "h", "life of one bearing by film and cleanliness",
                 [](const CrownPoint& p) { return p.modified_life_hours; }),
      grid_array(study, "peak_pressure", "Pa",
                 "greatest pressure of the most loaded roller, mean over a hundredth of its length",
                 [](const CrownPoint& p) { return p.pressure.peak; }),
      grid_array(study, "edge_ratio", "1", "pressure near the ends over that in the middle",
                 [](const CrownPoint& p) { return p.pressure.edge_ratio; })};
  content.attributes = {{"profiles", fmt::format("{}", fmt::join(request.profiles, " "))},
                        {"life_measure", name_of(request.measure)}};
  return content;
}

}  // namespace orbearing::app
