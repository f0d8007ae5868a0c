#include "app/case/catalogue_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "app/case/catalogue_case.hpp"
#include "app/case/catalogue_lines.hpp"
#include "app/case/input_keys.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

using namespace catalogue_lines;

namespace {

// Types of which no catalogue holds a line, by their basic numbers as ISO and DIN 623 write them.
struct OtherType {
  std::size_t digits;
  std::string_view letters;                // "*": any but those of cylindrical bearings, NU, NJ, NUP and N
  std::array<std::string_view, 4> begins;  // of the digits; they may repeat, and an empty one is in all
  const char *words, *type;                // of planet bearings; null: not computed
};

constexpr std::array kOtherTypes{
    OtherType{5, "*", {"30", "31", "32", "33"}, "a tapered roller bearing", "tapered-roller"},
    OtherType{5, "", {"292", "293", "294", "294"}, "a spherical roller thrust bearing", nullptr},
    OtherType{5, "*", {"21", "22", "23", "24"}, "a spherical roller bearing", "spherical-roller"},
    OtherType{5, "", {"51", "52", "53", "54"}, "a thrust ball bearing", nullptr},
    OtherType{5, "", {"81", "81", "89", "89"}, "a cylindrical roller thrust bearing", nullptr},
    OtherType{4, "", {"12", "13", "22", "23"}, "a self-aligning ball bearing", nullptr},
    OtherType{4, "", {"3", "3", "3", "3"}, "a double-row angular contact ball bearing", nullptr},
    OtherType{3, "QJ", {}, "a four-point contact ball bearing", nullptr},
    OtherType{4, "C", {}, "a toroidal roller bearing", nullptr}};

// Null for types with lines, and for names that are none of these.
const OtherType* other_type(std::string_view name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto begin = std::ranges::find_if(name, is_digit);
  const auto end = std::find_if_not(begin, name.end(), is_digit);
  const std::string_view digits =
      name.substr(static_cast<std::size_t>(begin - name.begin()), static_cast<std::size_t>(end - begin));
  std::string_view letters = name.substr(0, static_cast<std::size_t>(begin - name.begin()));
  while (!letters.empty() && letters.back() == ' ') letters.remove_suffix(1);
  const auto found = std::ranges::find_if(kOtherTypes, [&](const OtherType& one) {
    const bool fits = one.letters == "*" ? !name.starts_with('N') : one.letters == letters;
    return fits && one.digits == digits.size() &&
           std::ranges::any_of(one.begins,
                               [&](std::string_view number) { return digits.starts_with(number); });
  });
  return found == kOtherTypes.end() ? nullptr : found;
}

// "NCF 2207", "SL 18 2207", "NJG 2307": series of several makers.
bool is_full_complement_name(std::string_view name) {
  return std::ranges::any_of(std::array<std::string_view, 5>{"NCF", "SL", "NJG", "NNCF", "NNC"},
                             [&](std::string_view series) { return name.starts_with(series); });
}

}  // namespace

std::optional<ConsistencyMessage> unknown_designation(const std::string& name, const FieldValue* table,
                                                      Model model) {
  if (line_of(table, name) != nullptr) return std::nullopt;
  if (const OtherType* other = other_type(name))
    return ConsistencyMessage{
        fmt::format("{}, {}, of which no catalogue has a line", quote(name), other->words),
        other->type == nullptr
            ? std::string("a cylindrical, needle, tapered or spherical roller bearing, or a deep groove or "
                          "angular contact ball bearing, is required: others are not computed")
        : (model & planetary_drivetrain) != 0
            ? fmt::format("bearing.type: {} with bearing.rows.contact_angle and number, diameter, length and "
                          "pitch diameter of its rollers is required instead of the designation",
                          other->type)
            : fmt::format("a planet bearing is required (model: planetary-drivetrain, bearing.type: {}): "
                          "single bearings of this type are not computed",
                          other->type)};
  constexpr std::size_t shown = 5;
  const bool rollers = (model & with_rollers) != 0;
  const std::string found = fmt::format("{} is {}", quote(name),
                                        table == nullptr ? "not in the catalogue" : "in neither catalogue");
  if (rollers && is_full_complement_name(name))
    return ConsistencyMessage{
        found + ", which lists bearings with a cage",
        "for a full complement state bearing.complement: full with roller_diameter, roller_length, "
        "pitch_diameter, bore, outside_diameter and width, and its ratings where they are printed; or your "
        "own "
        "row (bearing.catalogue: FILE)"};
  return ConsistencyMessage{
      found,
      fmt::format(
          "a listed designation is required, perhaps with common suffixes; nearest: {}. For another bearing, "
          "state your own row (bearing.catalogue: FILE), or number, diameter and pitch diameter of its {}",
          fmt::join(catalogue::nearest(designations_of(table, rollers), name, shown), ", "),
          rollers ? "rollers" : "balls")};
}

namespace {

void check_designation(CheckedCase& in) {
  if (!in.has(keys().designation)) return;
  const auto add_error = [&](std::string found, std::string required) {
    in.add_error_at(keys().designation, std::move(found), std::move(required));
  };
  const std::string& name = in.text(keys().designation);
  const bool of_rollers = (in.model() & with_rollers) != 0;
  if (const auto message = unknown_designation(name, table_of_case(in), in.model()))
    return add_error(message->found, message->required);
  const catalogue::Entry* entry = line_of(in);
  const bool rollers = catalogue::has_rollers(entry->family);
  if (rollers != of_rollers)
    return add_error(
        fmt::format("'{}', a bearing of {}", name, rollers ? "rollers" : "balls"),
        rollers ? "one of balls, such as 6205, is required" : "one of rollers, such as NU 205, is required");
  if (entry->family == catalogue::Family::needle_cage && in.has(keys().rings) &&
      in.choice(keys().rings) != "none")
    in.add_error_at(keys().rings, fmt::format("{} together with {}", in.choice(keys().rings), name),
                    "none is required: needles in a cage run on the pin and in the planet");
  try {
    (void)known_inside(*entry);
  } catch (const std::invalid_argument& error) {
    add_error(name_of(*entry, name), error.what());
  }
}

// Ratings of a line are those of steel, as are the formulas of the standards.
void check_rated_material(CheckedCase& in) {
  const std::string& modulus = keys().modulus;
  constexpr double softest = 190e9, stiffest = 225e9;  // [Pa]  of steels
  if (line_of(in) == nullptr || !is_stated(in, modulus) || is_stated(in, keys().dynamic_capacity)) return;
  if (const double stated = in.quantity(modulus); stated < softest || stated > stiffest)
    in.add_error_at(modulus,
                    fmt::format("{} together with {}, whose ratings are those of steel", in.given(modulus),
                                in.text(keys().designation)),
                    "a modulus of steel, 190 to 225 GPa, or bearing.dynamic_capacity, static_capacity and "
                    "fatigue_load_limit of a bearing of that material, is required");
}

void check_class(CheckedCase& in) {
  if (!in.has(keys().clearance_class)) return;
  // For an unknown bearing the mistake is reported at its designation.
  if (std::any_of(in.mistakes.begin(), in.mistakes.end(),
                  [](const Mistake& mistake) { return mistake.path.ends_with(keys().designation); }))
    return;
  const auto add_error = [&](std::string found, std::string required) {
    in.add_error_at(keys().clearance_class, std::move(found), std::move(required));
  };
  // A class that its table does not have leaves the default, which is no mistake of the case.
  const auto state = in.assumed().find(keys().clearance_state);
  const bool stated = state == in.assumed().end();
  if (stated && in.has(keys().clearance_state) && in.choice(keys().clearance_state) == "operating")
    add_error("a clearance class together with bearing.clearance_state: operating",
              "bearing.clearance_state: unmounted, or a radial clearance instead of the class, is required. "
              "A class is for an unmounted bearing");
  if (in.has(keys().rings) && in.choice(keys().rings) != "both")
    add_error("a clearance class of a bearing without both rings",
              "bearing.radial_clearance, of pin, rollers and bore together, is required");
  const std::optional<double> bore = bore_of(in);
  if (!bore) {
    add_error("a clearance class without a bore", kBoreRequired);
    return;
  }
  try {
    (void)catalogue::clearance_range(family_of(in), class_of(in.choice(keys().clearance_class)), *bore);
  } catch (const std::invalid_argument& error) {
    add_error(in.choice(keys().clearance_class), error.what());
  }
}

void check_seats(CheckedCase& in) {
  for (const Seat& seat : seats()) {
    if (!has_all(in, {seat.tolerance, seat.diameter})) continue;
    try {
      (void)catalogue::shaft_deviations("h6", in.quantity(seat.diameter));
    } catch (const std::invalid_argument& error) {
      in.add_error_at(seat.tolerance,
                      fmt::format("{} on {}", in.choice(seat.tolerance), in.given(seat.diameter)),
                      error.what());
    }
  }
}

void check_complement(CheckedCase& in) {
  if (!is_full_complement(in) ||
      !has_all(in, {keys().rollers, keys().pitch_diameter, keys().roller_diameter}))
    return;
  const double pitch = in.quantity(keys().pitch_diameter), diameter = in.quantity(keys().roller_diameter);
  if (!(diameter < pitch)) return;
  const int most = most_rollers(pitch, diameter);
  if (in.integer(keys().rollers) < most)
    in.add_error_at(keys().complement,
                    fmt::format("a full complement of {} rollers with room for {} more",
                                in.integer(keys().rollers), most - in.integer(keys().rollers)),
                    fmt::format("{} rollers, or their number left out, are required", most));
}

}  // namespace

void check_catalogue_bearing(CheckedCase& in) {
  check_designation(in);
  check_rated_material(in);
  check_class(in);
  check_seats(in);
  check_complement(in);
}

}  // namespace orbearing::app
