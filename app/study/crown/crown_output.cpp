#include "app/study/crown/crown_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "bearing/life/rating_record.hpp"

namespace orbearing::app {

namespace {

using namespace analysis::crowning;

using described::Record;
namespace dimension = described::dimension;

void describe_pressure(Record& record, double peak, double edge_ratio) {
  record.value("peak_pressure_MPa", dimension::pressure,
               "of the most loaded roller, mean over a hundredth of its length", peak);
  record.value("edge_ratio", dimension::ratio, "pressure near the ends over that in the middle", edge_ratio);
}

void describe_point(Record& row, const CrownPoint& point, const std::string& profile, bool computed) {
  const bool ok = point.status == "ok";
  row.value("drop_um", dimension::small_length, "relief of one roller", point.drop);
  row.value("tilt_mrad", dimension::small_angle, "of the bore on its pin",
            computed ? point.largest_tilt : point.tilt);
  row.value("life_h", dimension::hours, "of one bearing, Lundberg and Palmgren",
            point.lundberg_palmgren_hours);
  row.value("governing_life_h", dimension::hours, "of one bearing, the life that life_key names",
            point.life_hours);
  describe_pressure(row, ok ? point.pressure.peak : described::kAbsent,
                    ok ? point.pressure.edge_ratio : described::kAbsent);
  row.value("profile", "kind", profile);
  describe(row, point.rated_hours);
  row.value("status", "ok, or the reason why there is no static equilibrium", point.status);
}

void describe_design(Record& record, const CrownDesign& design) {
  record.value("profile", "kind", design.profile);
  record.value("drop_um", dimension::small_length, "relief of one roller", design.crown.drop);
  record.value("life_h", dimension::hours, "worst over the tilts, Lundberg and Palmgren",
               design.lundberg_palmgren_hours);
  record.value("governing_life_h", dimension::hours, "worst over the tilts, the life that life_key names",
               design.life_hours);
  describe_pressure(record, design.peak_pressure, design.edge_ratio);
  describe(record, design.rated_hours);
  record.value("half_space_life_h", dimension::hours,
               "from half-space pressures: the governing life, or L10rh where that is life_h",
               design.pressure_life_hours);
  if (std::isfinite(design.untilted_life_hours)) {
    record.value("untilted_governing_life_h", dimension::hours, "without tilt", design.untilted_life_hours);
    record.value("untilted_half_space_life_h", dimension::hours, "without tilt",
                 design.untilted_pressure_life_hours);
  }
  if (design.has_share)
    record.value("crowned_share", dimension::ratio, "of each half of the roller", design.crown.share);
  if (std::isfinite(design.life_in_band))
    record.value("governing_life_in_band_h", dimension::hours, "worst within the tolerances",
                 design.life_in_band);
}

void describe_search(Record& record, const CrownSearch& search) {
  describe_design(record, search.best);
  record
      .child("starts", "of the search", search,
             [](Record& starts, const CrownSearch& of) {
               starts.value("count", "of starts", of.ends.size());
               starts.value("in_optimum", "starts that ended in the best", of.in_best);
               starts.table("ends", "start", "result of each start", of.ends,
                            [&](Record& row, const SearchEnd& end) {
                              row.value("start_um", dimension::small_length, "", end.start.drop);
                              row.value("drop_um", dimension::small_length, "", end.crown.drop);
                              row.value("crowned_share", dimension::ratio, "",
                                        of.best.has_share ? end.crown.share : described::kAbsent);
                              row.value("governing_life_h", dimension::hours, "", end.life_hours);
                              row.value("evaluations", "", end.evaluations);
                            });
             })
      .detail = true;
}

void describe_front(Record& record, const CrownStudy& study) {
  std::vector<std::pair<std::string, WorstOfTilts>> front;
  for (std::size_t profile = 0; profile < study.worst.size(); ++profile)
    for (const WorstOfTilts& one : study.worst[profile])
      if (one.efficient) front.emplace_back(study.request.profiles[profile], one);
  record
      .table("front", "front", "drops for which no other drop has a longer life at a lower pressure", front,
             [](Record& row, const auto& one) {
               row.value("profile", "kind", one.first);
               row.value("drop_um", dimension::small_length, "", one.second.drop);
               row.value("governing_life_h", dimension::hours, "", one.second.life_hours);
               row.value("peak_pressure_MPa", dimension::pressure, "", one.second.peak_pressure);
             })
      .detail = true;
}

double power_at(const CrownStudy& study, const SpectrumPoint& point) {
  return point.power.value_or(study.request.drivetrain.drive.power);
}

void describe_spectrum_point(Record& row, const CrownStudy& study, const SpectrumPoint& point) {
  row.value("input_speed_rpm", dimension::angular_speed, "", point.speed);
  row.value("power_kW", dimension::power, "", power_at(study, point));
  row.value("share", dimension::ratio, "of the time", point.share);
}

// Results of the points of the spectrum that have a speed and a share of time, in their order, as in the
// problem.
void describe_duties(Record& record, const CrownStudy& study) {
  std::vector<SpectrumPoint> points;
  for (const SpectrumPoint& point : study.request.spectrum)
    if (point.speed > 0.0 && point.share > 0.0) points.push_back(point);
  std::size_t next = 0;
  record.table("points", "duty", "results of each point of the spectrum", points,
               [&](Record& row, const SpectrumPoint& point) {
                 const DutyRecord& duty = study.recommended.duties[next++];
                 describe_spectrum_point(row, study, point);
                 row.value("tilt_mrad", dimension::small_angle, "", duty.tilt);
                 row.value("load_share", dimension::ratio, "", duty.load_share);
                 row.value("half_space_life_h", dimension::hours, "", duty.pressure_life_hours);
                 row.value("governing_life_h", dimension::hours, "", duty.life_hours);
                 row.value("damage_share", dimension::ratio, "", duty.damage_share);
                 describe_pressure(row, duty.pressure.peak, duty.pressure.edge_ratio);
               });
}

void describe_drop_life(Record& record, const DropLife& at) {
  record.value("drop_um", dimension::small_length, "relief of one roller", at.drop);
  record.value("life_share", dimension::ratio, "of the longest life", at.life_share);
}

bool has_tolerance(const CrownStudy& study) {
  return study.request.tolerance.drop > 0.0 || study.request.tolerance.tilt > 0.0;
}

// Straight rollers are not sharp ones where their corners press harder than the middle.
std::string rollers_to_take(const CrownStudy& study) {
  if (!study.recommended.advice.no_crown_needed()) return "crowned";
  return study.straight.edge_ratio > 1.0 ? "straight with relieved ends" : "straight";
}

// Tolerances and the results under them; for studies with tolerances.
void describe_tolerance(Record& record, const CrownStudy& study) {
  const CrownRequest& request = study.request;
  const HalfSpaceAdvice& advice = study.recommended.advice;
  record.value("drop_um", dimension::small_length, "of drops", request.tolerance.drop);
  record.value(request.computes_tilt() ? "pin_inclination_mrad" : "tilt_mrad", dimension::small_angle,
               "of tilts", request.tolerance.tilt);
  record.value("distribution", "", name_of(request.distribution));
  record.value("half_space_life_h", dimension::hours, "worst case, or of nine tenths", advice.life_hours);
  record.value("quadrature_error", dimension::ratio, "", advice.quadrature_error);
}

void describe_recommended(Record& record, const CrownStudy& study) {
  const auto& [design, advice, duties] = study.recommended;
  record.value("status", "ok, or how it shortens the governing life", status_of_recommended(study));
  record.value("shortens_governing_life",
               "whether the life in run, or at the tilts of this study, is shorter",
               study.in_run && study.in_run->is_shorter());
  record.value("profile", "kind", design.profile);
  record.value(
      "drop_um", dimension::small_length,
      "the one to take: pressures at the ends of the rollers count, unlike in the optimum by laminae",
      design.crown.drop);
  record.value("least_drop_um", dimension::small_length, "of the band that keeps the life",
               advice.band.least);
  record.value("most_drop_um", dimension::small_length, "of that band", advice.band.most);
  record.value("most_is_greatest_studied", "whether the band ends beyond", advice.band.open);
  record.value("half_space_life_h", dimension::hours, "from half-space pressures",
               design.pressure_life_hours);
  record.value("life_h", dimension::hours, "by laminae, Lundberg and Palmgren",
               design.lundberg_palmgren_hours);
  record.value("governing_life_h", dimension::hours, "by laminae, the life that life_key names",
               design.life_hours);
  describe_pressure(record, design.peak_pressure, design.edge_ratio);
  record.value("life_kept_in_band", dimension::ratio, "of the longest life", kKeptLife);
  record.value("straight_life_share", dimension::ratio, "of the longest life, by straight rollers",
               advice.straight_life_hours / advice.life_hours);
  record.value("no_crown_needed", "whether straight rollers are sufficient", advice.no_crown_needed());
  record.value("rollers", "recommended rollers", rollers_to_take(study));
  record.table("missed", "missed", "drops below and above", std::array{advice.low, advice.high},
               describe_drop_life);
  record.child("by_laminae", "the best drop by laminae", advice.other, describe_drop_life);
  record.value("interpolation_error", dimension::ratio, "of the longest life", advice.interpolation_error);
  if (design.has_share)
    record.value("crowned_share", dimension::ratio, "of each half of the roller", design.crown.share);
  if (has_tolerance(study)) record.child("within_tolerances", "", study, describe_tolerance);
  describe_duties(record, study);
  record.table("curve", "curve", "life over drop", advice.curve, describe_drop_life).detail = true;
}

void describe_lives(Record& record, const LivesOfCrowns& lives) {
  record.value("case_h", dimension::hours, "of the case as it is", lives.of_case);
  record.value("recommended_h", dimension::hours, "with the recommended profile", lives.recommended);
  record.value("longest_h", dimension::hours, "with the drop that has the longest life", lives.longest);
  record.value("longest_drop_um", dimension::small_length, "that drop", lives.longest_drop);
  record.value("longest_profile", "kind of that profile", lives.longest_profile);
}

void describe_in_run(Record& record, const CrownStudy& study) {
  record.value("life_key", "governing life of the worst bearing", study.in_run->key);
  describe_lives(record, study.in_run->run);
  record.child("at_study_tilt", "the life that the optimum makes longest, at the tilts of this study",
               study.in_run->at_study_tilt, describe_lives);
}

// Over profile, drop and tilt.
void describe_grid(Record& record, const CrownStudy& study) {
  const CrownRequest& request = study.request;
  record.series("drop", dimension::length, "relief of one roller at the outermost of 40 laminae", {"drop"},
                request.drops);
  record.series("tilt", dimension::angle,
                request.computes_tilt() ? "beyond the tilt that is computed"
                                        : "tilt of the planet's bore on its pin in the plane of the load",
                {"tilt"}, request.tilts);
  const auto add = [&](const char* name, const described::Dimension& of, const char* meaning,
                       const auto& value) {
    std::vector<std::vector<std::vector<double>>> values;
    for (const auto& points : study.points) {
      values.emplace_back();
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % request.tilts.size() == 0) values.back().emplace_back();
        values.back().back().push_back(points[i].status == "ok" ? value(points[i]) : described::kAbsent);
      }
    }
    record.series(name, of, meaning, {"profile", "drop", "tilt"}, values);
  };
  add("largest_tilt", dimension::angle, "largest tilt of a bore on its pin, computed or stated",
      [](const CrownPoint& p) { return p.largest_tilt; });
  add("life", dimension::hours, "life of one bearing, Lundberg and Palmgren",
      [](const CrownPoint& p) { return p.lundberg_palmgren_hours; });
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    add(life.name, dimension::hours, life.meaning,
        [&](const CrownPoint& p) { return p.rated_hours.*life.hours; });
  add("peak_pressure", dimension::stress,
      "greatest pressure of the most loaded roller, mean over a hundredth of its length",
      [](const CrownPoint& p) { return p.pressure.peak; });
  add("edge_ratio", dimension::ratio, "pressure near the ends over that in the middle",
      [](const CrownPoint& p) { return p.pressure.edge_ratio; });
}

}  // namespace

void describe(Record& record, const CrownStudy& study) {
  const CrownRequest& request = study.request;
  record.value("tilt", "computed or stated", request.computes_tilt() ? "computed" : "stated");
  record.value("life_key", "governing life, which the optimum makes longest",
               bearing::rating::hours_key(study.life));
  record.value("laminae", "of a roller", request.laminae);
  record.table("spectrum", "spectrum", "duties", request.spectrum,
               [&](Record& row, const SpectrumPoint& point) { describe_spectrum_point(row, study, point); });
  std::vector<std::pair<std::string, CrownPoint>> points;
  for (std::size_t profile = 0; profile < study.points.size(); ++profile)
    for (const CrownPoint& point : study.points[profile])
      points.emplace_back(request.profiles[profile], point);
  record.table("points", "point", "life, pressure and edge ratio over profile, drop and tilt", points,
               [&](Record& row, const auto& one) {
                 describe_point(row, one.second, one.first, request.computes_tilt());
               });
  record.child("optimum", "longest life by laminae", study.searches[study.best], describe_search);
  record.child("recommended", "by half-space pressures", study, describe_recommended);
  record.child("straight", "straight rollers", study.straight, describe_design);
  record.child("reference", "profile of ISO/TS 16281", study.reference, describe_design);
  if (!study.robust.empty())
    record.child("robust", "best within the tolerances", study.robust[study.best_robust], describe_search);
  record.table("optima", "optimum", "of each profile", study.searches, describe_search);
  describe_front(record, study);
  if (study.in_run)
    record.child("in_run", "governing life that run gives, under the spectrum of the case", study,
                 describe_in_run);
  else
    record.nothing("in_run", "governing life that run gives: not computed");
  record.value("profiles", "in the order of the grid", fmt::format("{}", fmt::join(request.profiles, " ")))
      .in_files_alone = true;
  describe_grid(record, study);
}

}  // namespace orbearing::app
