#include "app/case/derived_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/case/catalogue_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/settings.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/default_design.hpp"

namespace orbearing::app {

namespace {

struct DerivedDefault {
  std::string text;  // as it would be written in a case
  std::string reason;
};

// Values of the set to which a derived default belongs.
class ValuesOfSet {
 public:
  ValuesOfSet(const CaseData& data, std::string prefix) : data_(data), prefix_(std::move(prefix)) {}

  bool has(std::initializer_list<std::string_view> paths) const {
    return std::all_of(paths.begin(), paths.end(), [this](std::string_view path) { return find(path); });
  }
  double operator()(std::string_view path) const { return find(path)->value.number; }

 private:
  // What all sets share stands at the top.
  const StoredValue* find(std::string_view path) const {
    for (const std::string& at : {prefix_ + std::string(path), std::string(path)})
      if (const auto found = data_.values.find(at); found != data_.values.end()) return &found->second;
    return nullptr;
  }

  const CaseData& data_;
  std::string prefix_;
};

using Rule = std::optional<DerivedDefault> (*)(const ValuesOfSet&);

std::string stiffness_text(double stiffness) {
  return fmt::format("{:.6g} N/m", stiffness);
}

std::optional<DerivedDefault> pocket_clearance(const ValuesOfSet& value) {
  const bool balls = value.has({"bearing.balls"});
  const std::string_view diameter = balls ? "bearing.ball_diameter" : "bearing.roller_diameter";
  const std::string_view count = balls ? "bearing.balls" : "bearing.rollers";
  if (!value.has({diameter, "bearing.pitch_diameter", count})) return std::nullopt;
  const double clearance = bearing::default_pocket_clearance(value(diameter), value("bearing.pitch_diameter"),
                                                             static_cast<int>(value(count)));
  if (!(clearance > 0.0)) return std::nullopt;
  return DerivedDefault{fmt::format("{:.6g} mm", 1e3 * clearance),
                        fmt::format("a fiftieth of the {0}'s diameter, at most half of the gap between {0}s",
                                    balls ? "ball" : "roller")};
}

std::optional<DerivedDefault> pocket_stiffness(const ValuesOfSet& value) {
  if (!value.has({"bearing.roller_diameter", "bearing.roller_length", "bearing.pitch_diameter",
                  "bearing.rollers", "bearing.cage.inner_diameter", "bearing.cage.outer_diameter",
                  "bearing.cage.pocket_clearance", "bearing.cage.density"}))
    return std::nullopt;
  const bearing::CageMaterial& material = bearing::default_cage_material(value("bearing.cage.density"));
  const bearing::CageBar bar{
      .length = value("bearing.roller_length"),
      .height = 0.5 * (value("bearing.cage.outer_diameter") - value("bearing.cage.inner_diameter")),
      .thickness = bearing::cage_bar_thickness(
          value("bearing.roller_diameter"), value("bearing.cage.pocket_clearance"),
          value("bearing.pitch_diameter"), static_cast<int>(value("bearing.rollers"))),
      .youngs_modulus = material.youngs_modulus};
  if (!(bar.height > 0.0) || !(bar.thickness > 0.0)) return std::nullopt;
  return DerivedDefault{
      stiffness_text(bearing::cage_bar_stiffness(bar)),
      fmt::format("a bar {:.3g} mm long, {:.3g} mm high and {:.3g} mm thick, clamped at both ends, of {} "
                  "({:.3g} GPa), the usual cage material nearest in density",
                  1e3 * bar.length, 1e3 * bar.height, 1e3 * bar.thickness, material.name,
                  1e-9 * bar.youngs_modulus)};
}

std::optional<DerivedDefault> touch_down_stiffness(const ValuesOfSet& value) {
  if (!value.has({"bearing.cage.width", "bearing.cage.density"})) return std::nullopt;
  const bearing::CageMaterial& material = bearing::default_cage_material(value("bearing.cage.density"));
  return DerivedDefault{
      stiffness_text(
          bearing::default_touch_down_stiffness(material.youngs_modulus, value("bearing.cage.width"))),
      fmt::format("a line contact of the cage's width, a fifth of the modulus of {} times the width",
                  material.name)};
}

// Walls of the carrier as its mass has them: both together the plate ratio times the face width.
std::optional<DerivedDefault> pin_stiffness_of_bearing(const ValuesOfSet& value) {
  if (!value.has({"bearing.bore", "bearing.per_planet", "gearset.face_width", "material.youngs_modulus",
                  "material.poisson_ratio"}))
    return std::nullopt;
  const double face = value("gearset.face_width");
  constexpr double default_plate_ratio = 0.5;  // of sets among several, which state no carrier
  const double plates = value.has({"gearset.dynamics.carrier.plate_ratio"})
                            ? value("gearset.dynamics.carrier.plate_ratio")
                            : default_plate_ratio;
  const bearing::PlanetPin pin{.diameter = value("bearing.bore"),
                               .loaded_length = face,
                               .span = face * (1.0 + 0.5 * plates),
                               .youngs_modulus = value("material.youngs_modulus"),
                               .poisson_ratio = value("material.poisson_ratio")};
  return DerivedDefault{
      stiffness_text(bearing::pin_stiffness(pin) / value("bearing.per_planet")),
      fmt::format("a solid pin of {:.4g} mm, {:.4g} mm between the middles of the carrier's walls, "
                  "shared by the bearings of a planet; the walls are rigid",
                  1e3 * pin.diameter, 1e3 * pin.span)};
}

std::optional<DerivedDefault> required_life(const ValuesOfSet& value) {
  if (!value.has({"requirements.life"})) return std::nullopt;
  return DerivedDefault{"L10mh", "the modified rating life of ISO 281, which includes oil and cleanliness"};
}

// Planet bearings have rollers.
std::optional<DerivedDefault> minimum_load(const ValuesOfSet& value) {
  if (!value.has({kSpectrumPath})) return std::nullopt;
  return DerivedDefault{"0.02", "makers' rule of thumb for roller bearings [SKFMinimumLoad]"};
}

struct DefaultRule {
  std::string_view path;
  std::string_view text;
  Rule apply;
  bool at_rest = false;  // also of bearings that are not moved in time
};

// In an order in which each finds what it follows from.
constexpr DefaultRule default_rules[] = {
    {"bearing.cage.pocket_clearance",
     "a fiftieth of the diameter of a roller or ball, at most half of the gap between them",
     pocket_clearance},
    {"bearing.cage.pocket_stiffness",
     "a bar between two pockets, clamped at both ends, of the usual cage material nearest in density",
     pocket_stiffness},
    {"bearing.cage.touch_down_stiffness",
     "a fifth of the modulus of the usual cage material nearest in density times the cage's width",
     touch_down_stiffness},
    {"support.stiffness",
     "a solid pin that fills the bore of the inner ring, between the middles of both walls of the carrier, "
     "shared by the bearings of a planet; each of several sets has its own",
     pin_stiffness_of_bearing},
    {"requirements.life_key", "L10mh, where requirements.life is given", required_life, true},
    {"life.minimum_load", "0.02, where spectrum is given: makers' rule of thumb for roller bearings",
     minimum_load, true}};

void fill_one(CaseData& data, const std::string& prefix, const DefaultRule& rule) {
  const std::string path(rule.path);
  const Field* field = find_field(path);
  const std::string full = field != nullptr && in_each_set(*field) ? prefix + path : path;
  const auto stored = data.values.find(full);
  if (stored != data.values.end() && !stored->second.from_default) return;
  if (stored != data.values.end()) {
    data.assumed.erase(full);
    data.values.erase(stored);
  }
  const std::optional<DerivedDefault> derived = rule.apply(ValuesOfSet(data, prefix));
  if (!derived) return;
  FieldReading reading = read_field_text(*field, derived->text);
  if (!reading.good) return;  // of a design beyond what the field takes: it wants a value of its own
  data.values[full] = {std::move(reading.value), {}, true};
  data.assumed[full] = "default: " + derived->reason;
}

}  // namespace

std::string_view default_rule(std::string_view path) {
  for (const DefaultRule& rule : default_rules)
    if (rule.path == path) return rule.text;
  return {};
}

void fill_derived_defaults(CaseData& data) {
  const auto found = data.values.find("model");
  if (found == data.values.end()) return;
  const Model model =
      specific_model(model_of(found->second.value.given), data.values.contains("simulation.duration"),
                     data.values.contains("bearing.rollers"));
  fill_from_catalogue(data, model);
  fill_from_grade(data, model);
  if ((model & planetary_drivetrain) != 0) fill_from_torque(data);
  const bool in_time = (model & described::in_time) != 0;
  std::vector<std::string> prefixes{""};
  if (data.shape.several) {
    prefixes.clear();
    for (const std::string& set : data.shape.sets) prefixes.push_back(set_prefix(set));
  }
  for (const std::string& prefix : prefixes)
    for (const DefaultRule& rule : default_rules) {
      if (!in_time && !rule.at_rest) continue;
      // The pin belongs to a set, though its field does not: each of several finds its own, in `of_set`.
      if (data.shape.several && !in_each_set(*find_field(rule.path)) && !rule.at_rest) continue;
      if ((find_field(rule.path)->models & model) == 0) continue;
      fill_one(data, prefix, rule);
    }
}

}  // namespace orbearing::app
