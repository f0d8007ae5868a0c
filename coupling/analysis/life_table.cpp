#include "coupling/analysis/life_table.hpp"

#include <cmath>
#include <utility>

#include "bearing/life/lundberg_palmgren.hpp"
#include "bearing/life/rating_record.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

namespace rating = bearing::rating;

using described::Record;

// Those of results that are stored in it.
constexpr described::Dimension in_million_revolutions{"revolutions", "Mrev", "Mrev", ""};

}  // namespace

std::array<LifeLine, 5> life_lines(const LifeWords& words) {
  const bool balls = words.element == rating::RollingElement::ball;
  const char* element = balls ? "ball" : "lamina";
  const std::string reduction =
      balls || words.reduction_factor == 0.0
          ? ""
          : ", reduction factor " + mechanics::significant(words.reduction_factor, 6);
  return {{{"L10h", "L10_Mrev", std::string("ISO 281: (C/P)^") + (balls ? "3" : "(10/3)")},
           {"L10rh", "L10r_Mrev", std::string("ISO/TS 16281: load of each ") + element},
           {"L10mh", "L10m_Mrev", "ISO 281: a_1 a_ISO L10h, a_ISO by C_u/P"},
           {"L10mrh", "L10mr_Mrev",
            balls ? std::string("ISO/TS 16281: a_1 a_ISO L10rh, a_ISO by the load that gives L10rh")
                  : std::string("ISO/TS 16281: a_1 and a_ISO of each lamina")},
           {"life_h", "life_Mrev",
            std::string("Lundberg-Palmgren: loads of this analysis, exponent ") + (balls ? "3" : "4") +
                reduction}}};
}

std::vector<described::Entry> load_entries() {
  Record names;
  describe(names, BearingLives{});
  std::vector<described::Entry> loads = names.entries();
  std::erase_if(loads, [](const described::Entry& entry) { return entry.symbol.empty(); });
  return loads;
}

namespace {

const char* unit_beside(const described::Entry& entry) {
  return entry.dimension.customary == "1" ? "" : entry.dimension.customary.data();
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

}  // namespace

std::string design_advice(const LifeTable& table) {
  const LifeWords& words = table.words;
  const bool balls = words.element == rating::RollingElement::ball, oil = has_modified(table.value);
  std::string differ = std::string("The lives differ: ") + (oil ? "L10h and L10mh take" : "L10h takes") +
                       " P of a bearing without clearance and tilt.";
  if (oil) differ += " L10h, L10rh and life_h do not include the oil.";
  if (!balls) differ += " life_h falls with the power 4 of the load, L10h with 10/3.";
  return std::string("Governing life: ") + rating::hours_key(words.governing) +
         " (life.method). It includes " + included(words.governing, balls) + ".\n" + differ + "\n";
}

LifeValue value_by_name(const BearingLives& lives) {
  Record record;
  describe(record, lives);
  return [record = std::move(record)](const std::string& name) {
    for (const described::Entry& entry : record.entries())
      if (entry.name == name) {
        const double value = std::get<described::Numbers>(entry.content).values.front();
        return std::isinf(value) ? value : mechanics::in_unit(value, 1.0 / entry.dimension.factor);
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
  record.value("advice", "governing life, and why the lives differ", design_advice(table));
}

}  // namespace orbearing::analysis
