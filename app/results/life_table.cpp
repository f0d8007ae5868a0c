#include "app/results/life_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/json_number.hpp"
#include "app/units.hpp"
#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;

constexpr double kMegaRevolution = 1e-6;  // per revolution

/// One line of the table: names of its numbers, and what it is by.
struct LifeLine {
  const char* hours;
  const char* revolutions;
  std::string by;
};

std::array<LifeLine, 5> life_lines(const LifeWords& words) {
  const bool balls = words.element == rating::RollingElement::ball;
  const char* element = balls ? "ball" : "lamina";
  const std::string reduction = balls || words.reduction_factor == 0.0
                                    ? ""
                                    : fmt::format(", reduction factor {:g}", words.reduction_factor);
  return {{{"L10h", "L10_Mrev", fmt::format("ISO 281: (C/P)^{}", balls ? "3" : "(10/3)")},
           {"L10rh", "L10r_Mrev", fmt::format("ISO/TS 16281: load of each {}", element)},
           {"L10mh", "L10m_Mrev", "ISO 281: a_1 a_ISO L10h, a_ISO by C_u/P"},
           {"L10mrh", "L10mr_Mrev",
            balls ? std::string("ISO/TS 16281: a_1 a_ISO L10rh, a_ISO by the load that gives L10rh")
                  : std::string("ISO/TS 16281: a_1 and a_ISO of each lamina")},
           {"life_h", "life_Mrev",
            fmt::format("Lundberg-Palmgren: loads of this analysis, exponent {}{}", balls ? 3 : 4, reduction)}}};
}

std::string life_number_text(double value) {
  if (std::isinf(value)) return "no load";
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "-";
}

/// What stands below the table: name, symbol, unit.
struct LoadEntry {
  const char* name;
  const char* symbol;
  const char* unit;
};
constexpr std::array<LoadEntry, 5> kForces{
    {{"C_N", "C", "N"}, {"C0_N", "C0", "N"}, {"Cu_N", "C_u", "N"}, {"P_N", "P", "N"}, {"P0_N", "P0", "N"}}};
constexpr std::array<LoadEntry, 7> kRatios{{{"C_over_P", "C/P", ""},
                                            {"S0", "S0", ""},
                                            {"contact_pressure_max_MPa", "contact pressure", "MPa"},
                                            {"kappa", "kappa", ""},
                                            {"e_C", "e_C", ""},
                                            {"a_ISO", "a_ISO", ""},
                                            {"a_ISO_r", "a_ISO_r", ""}}};

/// "C 48417 N, C0 ...": what has no number is left out.
template <class Entries>
std::string listed(const LifeValue& value, const Entries& entries) {
  std::string text;
  for (const LoadEntry& entry : entries)
    if (const double found = value(entry.name); std::isfinite(found))
      text += fmt::format("{}{} {:.5g}{}{}", text.empty() ? "" : ", ", entry.symbol, found, *entry.unit ? " " : "",
                          entry.unit);
  return text.empty() ? "" : text + "\n";
}

bool has_modified(const LifeValue& value) {
  return !std::isnan(value("L10mr_Mrev")) || !std::isnan(value("L10mrh"));
}

}  // namespace

NamedValues life_values(const BearingLives& lives) {
  const rating::RatingLives& standard = lives.standard;
  const std::array<std::pair<const char*, double>, 5> of{{{"L10", standard.basic},
                                                          {"L10r", standard.reference.bearing},
                                                          {"L10m", standard.modified},
                                                          {"L10mr", standard.modified_reference.bearing},
                                                          {"life", lives.lundberg_palmgren}}};
  NamedValues values;
  for (const auto& [name, revolutions] : of)
    values.emplace_back(fmt::format("{}_Mrev", name), kMegaRevolution * revolutions);
  for (const auto& [name, revolutions] : of)
    values.emplace_back(std::string(name) == "life" ? "life_h" : fmt::format("{}h", name),
                        lives.speed != 0.0 ? bearing::hours(revolutions, lives.speed) : rating::kNotRated);
  const double kappa = standard.oil ? standard.oil->viscosity_ratio : rating::kNotRated;
  const double contamination = standard.oil ? standard.oil->contamination_factor : rating::kNotRated;
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, double>>{
           {"C_N", standard.dynamic_capacity},
           {"C0_N", standard.static_capacity},
           {"Cu_N", standard.fatigue_load_limit},
           {"P_N", standard.dynamic_load},
           {"P0_N", standard.static_load},
           {"C_over_P", standard.load_ratio()},
           {"S0", standard.static_safety()},
           {"contact_pressure_max_MPa", kMega * lives.pressure},
           {"kappa", kappa},
           {"e_C", contamination},
           {"a_ISO", standard.life_modification},
           {"a_ISO_r", standard.reference_modification}})
    values.emplace_back(name, value);
  return values;
}

std::string design_advice(bool oil, rating::RollingElement element) {
  const bool balls = element == rating::RollingElement::ball;
  const std::string includes = balls ? "clearance, tilt and the load of each ball"
                                     : "clearance, tilt, profile and the load of each lamina";
  std::string differ = fmt::format("The lives differ: {} P of a bearing without clearance and tilt.",
                                   oil ? "L10h and L10mh take" : "L10h takes");
  if (oil) differ += " L10h, L10rh and life_h do not include the oil.";
  if (!balls) differ += " life_h falls with the power 4 of the load, L10h with 10/3.";
  if (oil)
    return fmt::format("Design by L10mrh: it includes {}, the oil film and its cleanliness.\n{}\n", includes, differ);
  return fmt::format(
      "Design by L10rh: it includes {}. State lubricant.grade, lubricant.temperature and life.cleanliness to get "
      "L10mrh.\n{}\n",
      includes, differ);
}

LifeValue value_by_name(NamedValues values) {
  return [values = std::move(values)](const std::string& name) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const auto& one) { return one.first == name; });
    return found == values.end() ? rating::kNotRated : found->second;
  };
}

std::string lives_text(const LifeValue& value, const LifeWords& words) {
  std::string text = fmt::format("{:<20} {:>12} {:>12}  {}\n", "life of one bearing", "[h]", "[Mrev]", "by");
  for (const LifeLine& line : life_lines(words))
    text += fmt::format("{:<20} {:>12} {:>12}  {}\n", line.hours, life_number_text(value(line.hours)),
                        life_number_text(value(line.revolutions)), line.by);
  return text + listed(value, kForces) + listed(value, kRatios) + design_advice(has_modified(value), words.element);
}

nlohmann::ordered_json lives_record(const LifeValue& value, const LifeWords& words) {
  nlohmann::ordered_json record{{"lives", nlohmann::ordered_json::array()},
                                {"loads", nlohmann::ordered_json::array()},
                                {"advice", design_advice(has_modified(value), words.element)}};
  for (const LifeLine& line : life_lines(words))
    record["lives"].push_back({{"key", line.hours},
                               {"hours", number_or_null(value(line.hours))},
                               {"Mrev", number_or_null(value(line.revolutions))},
                               {"by", line.by}});
  const auto add = [&](const auto& entries) {
    for (const LoadEntry& entry : entries)
      record["loads"].push_back({{"key", entry.name},
                                 {"symbol", entry.symbol},
                                 {"value", number_or_null(value(entry.name))},
                                 {"unit", entry.unit}});
  };
  add(kForces);
  add(kRatios);
  return record;
}

}  // namespace orbearing::app
