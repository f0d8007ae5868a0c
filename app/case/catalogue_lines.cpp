#include "app/case/catalogue_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>

#include "app/case/catalogue_file.hpp"
#include "app/case/input_keys.hpp"
#include "mechanics/constants.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app::catalogue_lines {

using constants::pi;

namespace {

// Fullest rings of rollers keep this much of their diameter between neighbours, so that the last one goes in.
constexpr double kLeastGap = 1e-3;  // [-]

}  // namespace

int most_rollers(double pitch_diameter, double roller_diameter) {
  return static_cast<int>(std::floor(pi / std::asin((1.0 + kLeastGap) * roller_diameter / pitch_diameter)));
}

catalogue::ClearanceClass class_of(const std::string& name) {
  if (const auto known = value_named<catalogue::ClearanceClass>(name)) return *known;
  throw std::logic_error("no clearance class '" + name + "'");
}

catalogue::Family family_of(const catalogue::Entry* entry, unsigned model, bool has_contact_angle) {
  if (entry != nullptr) return entry->family;
  if ((model & with_rollers) != 0) return catalogue::Family::cylindrical;
  return has_contact_angle ? catalogue::Family::angular_contact : catalogue::Family::deep_groove;
}

const std::array<Seat, 2>& seats() {
  static const std::array<Seat, 2> both{
      {{catalogue_keys::kPinClass, keys().bore, keys().inner_interference, catalogue::inner_interference},
       {catalogue_keys::kPlanetClass, keys().outside_diameter, keys().outer_interference,
        catalogue::outer_interference}}};
  return both;
}

const catalogue::Inside& known_inside(const catalogue::Entry& entry) {
  static std::map<const catalogue::Entry*, catalogue::Inside> known;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  const auto found = known.find(&entry);
  return found != known.end() ? found->second
                              : known.emplace(&entry, catalogue::inside_of(entry)).first->second;
}

namespace {

// A user's own lines go before those of the program. `table` may be null.
const catalogue::Entry* line_as_written(const FieldValue* table, const std::string& designation) {
  if (table != nullptr && !table->texts.empty())
    if (const catalogue::Entry* own = catalogue::find(catalogue_of(*table), designation)) return own;
  return catalogue::find(built_in_catalogue(), designation);
}

}  // namespace

ReadDesignation read_designation(const FieldValue* table, const std::string& designation) {
  if (const catalogue::Entry* line = line_as_written(table, designation)) return {line, {designation, {}}};
  for (const catalogue::SuffixedName& reading : catalogue::suffixed_readings(designation))
    if (const catalogue::Entry* line = line_as_written(table, reading.base)) return {line, reading};
  return {};
}

const catalogue::Entry* line_of(const FieldValue* table, const std::string& designation) {
  return read_designation(table, designation).line;
}

const FieldValue* table_of_case(const ResolvedCase& in, const std::string& set) {
  const std::string path = set + catalogue_keys::kCatalogue;
  return in.has(path) ? &in.value(path) : nullptr;
}

const catalogue::Entry* line_of(const ResolvedCase& in, const std::string& set) {
  const std::string path = set + keys().designation;
  return in.has(path) ? line_of(table_of_case(in, set), in.text(path)) : nullptr;
}

std::string maker_name(const catalogue::Entry& entry, const std::string& designation) {
  const std::vector<catalogue::Entry> line{entry};
  if (catalogue::find(line, designation) == nullptr)
    for (const catalogue::SuffixedName& reading : catalogue::suffixed_readings(designation))
      if (catalogue::find(line, reading.base) != nullptr) return catalogue::full_name(entry, reading.base);
  return catalogue::full_name(entry, designation);
}

std::string name_of(const catalogue::Entry& entry, const std::string& designation) {
  return fmt::format("{} ({})", maker_name(entry, designation), entry.source);
}

std::vector<std::string> designations_of(const FieldValue* table, bool rollers) {
  std::vector<std::string> names;
  const auto add = [&](const std::vector<catalogue::Entry>& entries) {
    for (const catalogue::Entry& entry : entries)
      if (catalogue::has_rollers(entry.family) == rollers)
        for (const std::string& name : entry.designations)
          if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  if (table != nullptr && !table->texts.empty()) add(catalogue_of(*table));
  add(built_in_catalogue());
  return names;
}

std::array<PrintedRating, 3> ratings_of(const catalogue::Entry& entry) {
  return {{{keys().dynamic_capacity, entry.dynamic_rating},
           {keys().static_capacity, entry.static_rating},
           {keys().fatigue_load_limit, entry.fatigue_load_limit}}};
}

std::optional<NamedCage> cage_of(const FieldValue* table, const std::string& designation) {
  const catalogue::Entry* line = line_of(table, designation);
  if (line == nullptr) return std::nullopt;
  const auto by_suffix = [](const catalogue::Suffix& one, const std::string& name) {
    return NamedCage{one.cage, fmt::format("the suffix {} ({}) of {}", one.letters, one.meaning, name)};
  };
  for (const catalogue::SuffixedName& reading : catalogue::suffixed_readings(designation))
    for (const catalogue::Suffix* one : reading.suffixes)
      if (!one->cage.empty()) return by_suffix(*one, quote(designation));
  if (!line->cage.empty())
    return NamedCage{line->cage, fmt::format("a cage of {} in {}", line->cage, name_of(*line, designation))};
  const catalogue::Suffix* own = catalogue::suffix_named(line->suffix);
  if (own != nullptr && !own->cage.empty()) return by_suffix(*own, name_of(*line, designation));
  return std::nullopt;
}

std::string newtons(double force) {
  return fmt::format("{:g} N", force);
}

double exponent_of_number(std::string_view rating) {
  return rating == keys().dynamic_capacity ? 0.75 : 1.0;
}

double with_rollers_instead(const PrintedRating& rating, const catalogue::Inside& inside, int rollers) {
  return rating.value *
         std::pow(static_cast<double>(rollers) / inside.elements, exponent_of_number(rating.path));
}

catalogue::Family family_of(const ResolvedCase& in) {
  return family_of(line_of(in), in.model(), is_nonzero(in, keys().contact_angle));
}

std::optional<double> bore_of(const ResolvedCase& in) {
  if (const catalogue::Entry* entry = line_of(in)) return entry->bore;
  return in.has(keys().bore) ? std::optional<double>(in.quantity(keys().bore)) : std::nullopt;
}

}  // namespace orbearing::app::catalogue_lines
