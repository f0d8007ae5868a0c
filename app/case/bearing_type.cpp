#include "app/case/bearing_type.hpp"

#include "app/case/input_keys.hpp"

#include <algorithm>

namespace orbearing::app {

namespace {

using bearing::PlanetBearingType;

PlanetBearingType type_named(std::string_view text) {
  return value_named<PlanetBearingType>(text).value_or(PlanetBearingType::cylindrical_roller);
}

std::string path_in(std::string_view set, std::string_view path) {
  return std::string(set) + std::string(path);
}

}  // namespace

PlanetBearingType bearing_type_of(const ResolvedCase& in, std::string_view set) {
  const std::string path = path_in(set, keys().bearing_type);
  return in.has(path) ? type_named(in.choice(path)) : PlanetBearingType::cylindrical_roller;
}

bool has_cylindrical_rollers(const ResolvedCase& in) {
  const auto is_cylindrical = [&](std::string_view set) {
    return bearing_type_of(in, set) == PlanetBearingType::cylindrical_roller;
  };
  const std::vector<std::string>& sets = in.shape().sets;
  return is_cylindrical("") &&
         std::ranges::all_of(sets, [&](const std::string& set) { return is_cylindrical(set_prefix(set)); });
}

bool has_planet_bearing(const ResolvedCase& in, std::string_view set) {
  return in.has(path_in(set, keys().rollers)) ||
         (in.model() == planetary_drivetrain && in.has(path_in(set, keys().balls)));
}

bool is_unknown_type(const ResolvedCase& in, const Input& input, AnalysisId analysis) {
  return input.field->path == keys().bearing_type && in.has(input.path) && !knows_every_type.has(analysis) &&
         type_named(in.choice(input.path)) != PlanetBearingType::cylindrical_roller;
}

bool goes_without(std::string_view type, std::string_view path) {
  return type_named(type) == PlanetBearingType::deep_groove_ball &&
         is_one_of(path, {keys().rollers, keys().roller_diameter, keys().roller_length});
}

}  // namespace orbearing::app
