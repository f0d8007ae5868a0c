#include "app/results/life_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/results/record_writers.hpp"
#include "bearing/life/lundberg_palmgren.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;

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
  return {
      {{"L10h", "L10_Mrev", fmt::format("ISO 281: (C/P)^{}", balls ? "3" : "(10/3)")},
       {"L10rh", "L10r_Mrev", fmt::format("ISO/TS 16281: load of each {}", element)},
       {"L10mh", "L10m_Mrev", "ISO 281: a_1 a_ISO L10h, a_ISO by C_u/P"},
       {"L10mrh", "L10mr_Mrev",
        balls ? std::string("ISO/TS 16281: a_1 a_ISO L10rh, a_ISO by the load that gives L10rh")
              : std::string("ISO/TS 16281: a_1 and a_ISO of each lamina")},
       {"life_h", "life_Mrev",
        fmt::format("Lundberg-Palmgren: loads of this analysis, exponent {}{}", balls ? 3 : 4, reduction)}}};
}

// Ratings, loads and factors of all bearings: those with a symbol.
std::vector<described::Entry> load_entries() {
  Record names;
  describe(names, BearingLives{});
  std::vector<described::Entry> loads = names.entries();
  std::erase_if(loads, [](const described::Entry& entry) { return entry.symbol.empty(); });
  return loads;
}

const char* unit_beside(const described::Entry& entry) {
  return entry.dimension.customary == "1" ? "" : entry.dimension.customary.data();
}

std::string life_number_text(double value) {
  if (std::isinf(value)) return "no load";
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "-";
}

// "C 48417 N, C0 ...": what has no number is left out.
std::string listed(const LifeValue& value, const std::vector<described::Entry>& entries) {
  std::string text;
  for (const described::Entry& entry : entries)
    if (const double found = value(entry.name); std::isfinite(found))
      text += fmt::format("{}{} {:.5g}{}{}", text.empty() ? "" : ", ", entry.symbol, found,
                          *unit_beside(entry) ? " " : "", unit_beside(entry));
  return text.empty() ? "" : text + "\n";
}

bool has_modified(const LifeValue& value) {
  return !std::isnan(value("L10mr_Mrev")) || !std::isnan(value("L10mrh"));
}

std::string included(rating::Life life, bool balls) {
  using rating::Life;
  const std::string loads = balls ? "clearance, tilt and the load of each ball"
                                  : "clearance, tilt, profile and the load of each lamina";
  switch (life) {
    case Life::modified_reference:
      return loads + ", the oil film and its cleanliness";
    case Life::reference:
      return loads + ". State lubricant.grade, lubricant.temperature and life.cleanliness to get L10mrh";
    case Life::modified:
      return "the equivalent load P, the oil film and its cleanliness";
    case Life::basic:
      return "the equivalent load P alone";
    case Life::lundberg_palmgren:
      break;
  }
  return balls ? "the load of each ball" : "the load of each roller, as published lives do, not the oil";
}

// Which life governs, and why the lives differ.
std::string design_advice(const LifeValue& value, const LifeWords& words) {
  const bool balls = words.element == rating::RollingElement::ball, oil = has_modified(value);
  std::string differ = fmt::format("The lives differ: {} P of a bearing without clearance and tilt.",
                                   oil ? "L10h and L10mh take" : "L10h takes");
  if (oil) differ += " L10h, L10rh and life_h do not include the oil.";
  if (!balls) differ += " life_h falls with the power 4 of the load, L10h with 10/3.";
  return fmt::format("Governing life: {} (life.method). It includes {}.\n{}\n",
                     rating::hours_key(words.governing), included(words.governing, balls), differ);
}

}  // namespace

LifeValue value_by_name(const BearingLives& lives) {
  Record record;
  describe(record, lives);
  return [record = std::move(record)](const std::string& name) {
    for (const described::Entry& entry : record.entries())
      if (entry.name == name) {
        const double value = std::get<described::Numbers>(entry.content).values.front();
        return std::isinf(value) ? value : in_customary_unit(entry.dimension, value);
      }
    return described::kAbsent;
  };
}

void describe(Record& record, const LifeTable& table) {
  using namespace described;
  const LifeValue& value =
      table.value;  // by itself: clang 14 lets no lambda capture parts of a structured binding
  const LifeWords& words = table.words;
  record.table(
      "lives", "rated_life", "of one bearing", life_lines(words), [&](Record& row, const LifeLine& line) {
        row.value("key", "name among the results", line.hours);
        row.value("hours", dimension::hours, "at the speed of the analysis", value(line.hours));
        row.value("Mrev", in_million_revolutions, "the same in revolutions", value(line.revolutions));
        row.value("by", "standard or method", line.by);
      });
  record.table("loads", "rating_value", "ratings, loads and factors", load_entries(),
               [&](Record& row, const described::Entry& entry) {
                 row.value("key", "name among the results", entry.name);
                 row.value("symbol", "of the standard", entry.symbol);
                 row.value("value", {}, "in the stated unit", value(entry.name));
                 row.value("unit", "of the value", unit_beside(entry));
               });
  record.value("governing", "key of the governing life, by life.method", rating::hours_key(words.governing));
  record.value("advice", "governing life, and why the lives differ", design_advice(value, words));
}

std::string lives_text(const LifeTable& table) {
  const auto& [value, words] = table;
  std::string text = fmt::format("{:<20} {:>12} {:>12}  {}\n", "life of one bearing", "[h]", "[Mrev]", "by");
  for (const LifeLine& line : life_lines(words))
    text += fmt::format("{:<20} {:>12} {:>12}  {}\n", line.hours, life_number_text(value(line.hours)),
                        life_number_text(value(line.revolutions)), line.by);
  const std::vector<described::Entry> loads = load_entries();
  const auto ratios = std::ranges::find_if(loads, [](const auto& entry) { return entry.name == "C_over_P"; });
  return text + listed(value, {loads.begin(), ratios}) + listed(value, {ratios, loads.end()}) +
         design_advice(value, words);
}

}  // namespace orbearing::app
