#include "app/study/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/case/input_keys.hpp"
#include "app/study/planetary_case.hpp"
#include "bearing/life/rating_record.hpp"

namespace orbearing::app {

namespace {

// Observation for a single bearing: the relative speed of its rings.
void add_single_speed(const ResolvedCase& in, std::vector<Observation>& found) {
  if (!in.has(keys().shaft_speed) || !in.has(keys().pitch_diameter)) return;
  const double outer = in.has(keys().outer_speed) ? in.quantity(keys().outer_speed) : 0.0;
  found.push_back(
      analysis::observed_speed(in.quantity(keys().shaft_speed) - outer, in.quantity(keys().pitch_diameter)));
}

// All that is judged.
void collect(const nlohmann::ordered_json& value, const std::string& key, std::vector<Observation>& found) {
  if (value.is_number() && analysis::range_of(key) != nullptr) found.push_back({key, value.get<double>()});
  if (!value.is_structured()) return;
  for (const auto& [inner, one] : value.items()) collect(one, value.is_object() ? inner : key, found);
}

}  // namespace

std::vector<Observation> observations(const nlohmann::ordered_json& object) {
  std::vector<Observation> found;
  collect(object, "", found);
  return found;
}

std::vector<Observation> observations(const analysis::PointNumbers& point) {
  namespace dimension = described::dimension;
  namespace rating = bearing::rating;
  const rating::RatingLives& lives = point.rating.lives;
  std::vector<Observation> found{
      {"contact_pressure_max_MPa", in_customary_unit(dimension::pressure, point.contact_pressure)},
      {"kappa", lives.oil ? lives.oil->viscosity_ratio : not_given},
      {"C_over_P", in_customary_unit(dimension::ratio, lives.load_ratio())},
      {"life_h", in_customary_unit(dimension::hours, point.life_hours)}};
  for (const rating::RatedLife& life : rating::kRatedLives)
    found.push_back({life.name, in_customary_unit(dimension::hours, point.rating.hours.*life.hours)});
  found.push_back({"film_inner_um", in_customary_unit(dimension::small_length, point.inner.least_film)});
  found.push_back({"film_outer_um", in_customary_unit(dimension::small_length, point.outer.least_film)});
  return found;
}

std::vector<Observation> observations(const ResolvedCase& at_point) {
  std::vector<Observation> found;
  if (at_point.model() != planetary_drivetrain)
    add_single_speed(at_point, found);
  else if (at_point.shape().several || at_point.shape().bearing)
    found = analysis::observations(bearing_sets(at_point));
  else if (at_point.shape().teeth)
    found = analysis::observations_of_gears(stated_sets(at_point).front().drivetrain);
  return found;
}

std::vector<std::string> rim_warnings(const ResolvedCase& at_point) {
  if (at_point.model() != planetary_drivetrain || !(at_point.shape().several || at_point.shape().bearing))
    return {};
  return analysis::thin_rim_warnings(bearing_sets(at_point));
}

analysis::PointResult judged(analysis::PointResult result, const std::vector<analysis::NamedSet>& sets) {
  if (result.status != "ok") return result;
  std::vector<Observation> observed = analysis::observations(sets);
  for (Observation& one : observations(result)) observed.push_back(std::move(one));
  result.status = judge(observed).status;
  return result;
}

namespace {

struct RareRows {
  std::size_t count = 0;
  std::string text, speed;  // of the first
  const SweepRow* last = nullptr;

  void add(const SweepRow& row, const analysis::PlausibleRange& range, double value) {
    if (std::exchange(last, &row) == &row || count++ > 0) return;
    text = analysis::rare_text(range, value);
    speed = fmt::format("{:g} rpm", speed_in_rpm(row.point.input_speed));
  }
};

}  // namespace

std::vector<std::string> rare_values(const std::vector<const SweepRow*>& rows) {
  const std::vector<analysis::PlausibleRange>& ranges = analysis::plausible_ranges();
  std::vector<std::pair<RareRows, RareRows>> found(ranges.size());  // low, high
  for (const SweepRow* row : rows)
    for (const Observation& one : observations(row->point)) {
      const analysis::PlausibleRange& range = *analysis::range_of(one.key);
      auto& [low, high] = found[static_cast<std::size_t>(&range - ranges.data())];
      if (one.value < range.rare_low.value) low.add(*row, range, one.value);
      if (one.value > range.rare_high.value) high.add(*row, range, one.value);
    }
  std::vector<std::string> warnings;
  for (const auto& [low, high] : found)
    for (const RareRows* rare : {&low, &high})
      if (rare->count > 0)
        warnings.push_back(fmt::format("{}: {} of {} points, first at {}", rare->text, rare->count,
                                       rows.size(), rare->speed));
  return warnings;
}

}  // namespace orbearing::app
