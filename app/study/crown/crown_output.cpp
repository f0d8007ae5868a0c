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

ordered_json point_json(const CrownPoint& point, const std::string& profile, bool computed) {
  const bool ok = point.status == "ok";
  return {{"drop_um", in_table_unit(point.drop, kMicro)},
          {"tilt_mrad", in_table_unit(computed ? point.largest_tilt : point.tilt, kMilli)},
          {"life_h", number_or_null(point.life_hours)},
          {"peak_pressure_MPa", ok ? number_or_null(kMega * point.pressure.peak) : nullptr},
          {"edge_ratio", ok ? number_or_null(point.pressure.edge_ratio) : nullptr},
          {"profile", profile},
          {"L10h", number_or_null(point.rated_hours.basic)},
          {"L10rh", number_or_null(point.rated_hours.reference)},
          {"L10mh", number_or_null(point.rated_hours.modified)},
          {"L10mrh", number_or_null(point.rated_hours.modified_reference)},
          {"status", point.status}};
}

ordered_json design_json(const CrownDesign& design, LifeMeasure measure) {
  const char* other = measure == LifeMeasure::iso16281 ? "lundberg_palmgren_life_h" : "iso16281_life_h";
  ordered_json object{{"profile", design.profile},
                      {"drop_um", kMicro * design.crown.drop},
                      {"life_h", number_or_null(design.life_hours)},
                      {"peak_pressure_MPa", number_or_null(kMega * design.peak_pressure)},
                      {"edge_ratio", number_or_null(design.edge_ratio)},
                      {other, number_or_null(design.other_life_hours)},
                      {"L10h", number_or_null(design.rated_hours.basic)},
                      {"L10rh", number_or_null(design.rated_hours.reference)},
                      {"L10mh", number_or_null(design.rated_hours.modified)},
                      {"L10mrh", number_or_null(design.rated_hours.modified_reference)},
                      {"half_space_life_h", number_or_null(design.pressure_life_hours)}};
  if (std::isfinite(design.untilted_life_hours)) {
    object["untilted_life_h"] = design.untilted_life_hours;
    object["untilted_half_space_life_h"] = number_or_null(design.untilted_pressure_life_hours);
  }
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
                      {"load_share", record.load_share},
                      {"half_space_life_h", number_or_null(record.pressure_life_hours)},
                      {"life_h", number_or_null(record.life_hours)},
                      {"damage_share", number_or_null(record.damage_share)},
                      {"peak_pressure_MPa", number_or_null(kMega * record.pressure.peak)},
                      {"edge_ratio", number_or_null(record.pressure.edge_ratio)}});
  }
  return duties;
}

ordered_json drop_life_json(const DropLife& at) {
  return {{"drop_um", kMicro * at.drop}, {"life_share", number_or_null(at.life_share)}};
}

// Where there are tolerances.
ordered_json tolerance_json(const CrownStudy& study) {
  const CrownRequest& request = study.request;
  const HalfSpaceAdvice& advice = study.recommended.advice;
  const char* tilt = request.computes_tilt() ? "pin_inclination_mrad" : "tilt_mrad";
  return {{"drop_um", kMicro * request.tolerance.drop},
          {tilt, kMilli * request.tolerance.tilt},
          {"distribution", name_of(request.distribution)},
          {"half_space_life_h", number_or_null(advice.life_hours)},
          {"quadrature_error", number_or_null(advice.quadrature_error)}};
}

bool has_tolerance(const CrownStudy& study) {
  return study.request.tolerance.drop > 0.0 || study.request.tolerance.tilt > 0.0;
}

// Straight rollers are not sharp ones where their corners press harder than the middle.
std::string rollers_to_take(const CrownStudy& study) {
  if (!study.recommended.advice.no_crown_needed()) return "crowned";
  return study.straight.edge_ratio > 1.0 ? "straight with relieved ends" : "straight";
}

ordered_json recommended_json(const CrownStudy& study) {
  const auto& [design, advice, duties] = study.recommended;
  ordered_json object{{"profile", design.profile},
                      {"drop_um", kMicro * design.crown.drop},
                      {"least_drop_um", kMicro * advice.band.least},
                      {"most_drop_um", kMicro * advice.band.most},
                      {"most_is_greatest_studied", advice.band.open},
                      {"half_space_life_h", number_or_null(design.pressure_life_hours)},
                      {"life_h", number_or_null(design.life_hours)},
                      {"peak_pressure_MPa", number_or_null(kMega * design.peak_pressure)},
                      {"edge_ratio", number_or_null(design.edge_ratio)},
                      {"life_kept_in_band", kKeptLife},
                      {"straight_life_share", number_or_null(advice.straight_life_hours / advice.life_hours)},
                      {"no_crown_needed", advice.no_crown_needed()},
                      {"rollers", rollers_to_take(study)},
                      {"missed", {drop_life_json(advice.low), drop_life_json(advice.high)}},
                      {"by_laminae", drop_life_json(advice.other)},
                      {"interpolation_error", number_or_null(advice.interpolation_error)}};
  if (design.has_share) object["crowned_share"] = design.crown.share;
  if (has_tolerance(study)) object["within_tolerances"] = tolerance_json(study);
  object["points"] = duties_json(study);
  object["curve"] = ordered_json::array();
  for (const DropLife& one : advice.curve) object["curve"].push_back(drop_life_json(one));
  return object;
}

std::string tolerance_text(const CrownStudy& study) {
  if (!has_tolerance(study)) return "";
  const CrownRequest& request = study.request;
  return fmt::format(" for drops within {:.3g} um and {} within {:.3g} mrad, {}",
                     kMicro * request.tolerance.drop, request.computes_tilt() ? "pins inclined" : "tilts",
                     kMilli * request.tolerance.tilt,
                     request.distribution == Distribution::worst
                         ? "at their worst"
                         : fmt::format("{} distribution, of which nine tenths live {:.0f} h",
                                       name_of(request.distribution), study.recommended.advice.life_hours));
}

std::string recommended_text(const CrownStudy& study) {
  const auto& [design, advice, duties] = study.recommended;
  std::string text = fmt::format(
      "recommended by half-space pressures{}: rollers {}\n  {}, drop {:.3g} um{}; from {:.3g} to {}{:.3g} um{} at least "
      "{:.0f} % of its life is left\n  straight rollers leave {:.1f} %, {:.3g} um {:.1f} %, {:.3g} um {:.1f} "
      "%, "
      "the drop by laminae ({:.3g} um) {:.1f} %\n",
      tolerance_text(study), rollers_to_take(study), design.profile, kMicro * design.crown.drop,
      advice.no_crown_needed() ? " (no crown is needed)" : "", kMicro * advice.band.least,
      advice.band.open ? "beyond " : "", kMicro * advice.band.most,
      advice.band.open ? " (the greatest studied)" : "", 100.0 * kKeptLife,
      100.0 * advice.straight_life_hours / advice.life_hours, kMicro * advice.low.drop,
      100.0 * advice.low.life_share, kMicro * advice.high.drop, 100.0 * advice.high.life_share,
      kMicro * advice.other.drop, 100.0 * advice.other.life_share);
  text += fmt::format("  {:>10} {:>9} {:>9} {:>10} {:>12} {:>10} {:>6}\n", "rpm", "kW", "mrad", "life [h]",
                      "half-space", "peak [MPa]", "edge");
  std::size_t next = 0;
  for (const SpectrumPoint& point : study.request.spectrum) {
    if (point.speed <= 0.0 || point.share <= 0.0) continue;
    const DutyRecord& duty = duties[next++];
    text +=
        fmt::format("  {:>10.6g} {:>9.4g} {:>9.3g} {:>10.0f} {:>12.0f} {:>10.0f} {:>6.2f}\n",
                    kRpm * point.speed, kKilo * power_at(study, point), kMilli * duty.tilt, duty.life_hours,
                    duty.pressure_life_hours, kMega * duty.pressure.peak, duty.pressure.edge_ratio);
  }
  return text;
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
  std::string line = fmt::format(
      "{:<12} {:<18} {:>8.3g} {:>10.0f} {:>8.3g} {:>10} {:>10.0f} {:>6.2f} {:>11.0f}", name, design.profile,
      kMicro * design.crown.drop, design.life_hours, design.life_hours / straight,
      std::isfinite(design.untilted_life_hours) ? fmt::format("{:.0f}", design.untilted_life_hours) : "-",
      kMega * design.peak_pressure, design.edge_ratio, design.pressure_life_hours);
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
    text += fmt::format(
        "  | {:>24}", study.request.computes_tilt() ? "computed" : fmt::format("{:.4g} mrad", kMilli * tilt));
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
  const std::string tilts =
      study.request.computes_tilt()
          ? "tilts computed from planet, pin and bearings"
          : fmt::format("worst of tilts {:.4g} to {:.4g} mrad", kMilli * study.request.tilts.front(),
                        kMilli * study.request.tilts.back());
  return fmt::format("{}; life by laminae after {}; {}\n", where, name_of(study.request.measure), tilts);
}

}  // namespace

ordered_json crown_json(const CrownStudy& study) {
  const LifeMeasure measure = study.request.measure;
  const bool computed = study.request.computes_tilt();
  ordered_json points = ordered_json::array();
  for (std::size_t profile = 0; profile < study.points.size(); ++profile)
    for (const CrownPoint& point : study.points[profile])
      points.push_back(point_json(point, study.request.profiles[profile], computed));
  ordered_json object{{"tilt", computed ? "computed" : "stated"},
                      {"life_measure", name_of(measure)},
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
  text += fmt::format("{:<12} {:<18} {:>8} {:>10} {:>8} {:>10} {:>10} {:>6} {:>11}\n",
                      study.request.computes_tilt() ? "" : "worst tilt", "profile", "drop", "life", "times",
                      "untilted", "peak", "edge", "life [h] of");
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
  content.add("drop", {"drop"}, "m", "relief of one roller at the outermost of 40 laminae", request.drops);
  content.add("tilt", {"tilt"}, "rad",
              request.computes_tilt() ? "beyond the tilt that is computed"
                                      : "tilt of the planet's bore on its pin in the plane of the load",
              request.tilts);
  const auto add = [&](const char* name, const char* units, const char* meaning,
                       double (*value)(const CrownPoint&)) {
    std::vector<double> values;
    for (const auto& points : study.points)
      for (const CrownPoint& point : points)
        values.push_back(point.status == "ok" ? value(point) : std::nan(""));
    content.add(name, {"profile", "drop", "tilt"}, units, meaning, values);
  };
  add("largest_tilt", "rad", "largest tilt of a bore on its pin, computed or stated",
      [](const CrownPoint& p) { return p.largest_tilt; });
  add("life", "h", "life of one bearing", [](const CrownPoint& p) { return p.life_hours; });
  add("L10h", "h", "life of one bearing by ISO 281",
      [](const CrownPoint& p) { return p.rated_hours.basic; });
  add("L10rh", "h", "life of one bearing by ISO/TS 16281",
      [](const CrownPoint& p) { return p.rated_hours.reference; });
  add("L10mh", "h", "life of one bearing by ISO 281, with a_ISO",
      [](const CrownPoint& p) { return p.rated_hours.modified; });
  add("L10mrh", "h", "life of one bearing by ISO/TS 16281, with a_ISO of each lamina",
      [](const CrownPoint& p) { return p.rated_hours.modified_reference; });
  add("peak_pressure", "Pa",
      "greatest pressure of the most loaded roller, mean over a hundredth of its length",
      [](const CrownPoint& p) { return p.pressure.peak; });
  add("edge_ratio", "1", "pressure near the ends over that in the middle",
      [](const CrownPoint& p) { return p.pressure.edge_ratio; });
  content.attributes = {{"profiles", fmt::format("{}", fmt::join(request.profiles, " "))},
                        {"life_measure", name_of(request.measure)}};
  return content;
}

}  // namespace orbearing::app
