#include "app/case/derived_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/case/catalogue_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/oil_case.hpp"
#include "app/case/requirements_case.hpp"
#include "app/case/settings.hpp"
#include "app/case/spectrum_case.hpp"
#include "bearing/default_design.hpp"
#include "bearing/life/rating_lives.hpp"
#include "gearset/dynamics/bodies.hpp"

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
  bool given(std::string_view path) const { return find(path) && !find(path)->from_default; }
  const std::string& choice(std::string_view path) const { return find(path)->value.given; }

 private:
  // Values that all sets share are at the top level.
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
                  "({:.3g} GPa), the common cage material nearest in density",
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

std::optional<DerivedDefault> guide_land(const ValuesOfSet& value) {
  const bool balls = value.has({"bearing.balls"});
  const std::string_view diameter = balls ? "bearing.ball_diameter" : "bearing.roller_diameter",
                         length = balls ? diameter : "bearing.roller_length";
  if (!value.has({diameter, length, "bearing.pitch_diameter", "bearing.cage.guidance", "bearing.cage.width",
                  "bearing.cage.inner_diameter", "bearing.cage.outer_diameter"}) ||
      value("bearing.cage.width") <= value(length))
    return std::nullopt;
  const bool outside = value.choice("bearing.cage.guidance") == "outer";
  const double side = outside ? 1.0 : -1.0;
  const double cage = value(outside ? "bearing.cage.outer_diameter" : "bearing.cage.inner_diameter");
  const double raceway = value("bearing.pitch_diameter") + side * value(diameter);
  const double play = std::min(bearing::default_land_play(value(diameter)), 0.5 * side * (raceway - cage));
  if (!(play > 0.0)) return std::nullopt;
  return DerivedDefault{
      fmt::format("{:.9g} mm", 1e3 * (cage + side * play)),
      fmt::format(
          "a clearance of {:.3g} mm, 6 % of the {}'s diameter, at most half of that to the {} raceway",
          1e3 * play, balls ? "ball" : "roller", outside ? "outer" : "inner")};
}

std::optional<DerivedDefault> pocket_damping(const ValuesOfSet& value) {
  if (!value.has({"bearing.cage.density"})) return std::nullopt;
  const bearing::CageMaterial& material = bearing::default_cage_material(value("bearing.cage.density"));
  return DerivedDefault{fmt::format("{:g} s/m", material.damping),
                        fmt::format("{}, the common cage material nearest in density", material.name)};
}

// Teeth of the set; none where the case states masses and springs instead.
std::optional<gearset::PlanetarySet> teeth_of(const ValuesOfSet& value) {
  if (!value.has({"gearset.teeth.sun", "gearset.teeth.planet", "gearset.teeth.ring", "gearset.module",
                  "gearset.helix_angle", "gearset.pressure_angle", "material.youngs_modulus"}))
    return std::nullopt;
  const auto teeth = [&](std::string_view path) { return static_cast<int>(value(path)); };
  gearset::PlanetarySet set{.sun_teeth = teeth("gearset.teeth.sun"),
                            .planet_teeth = teeth("gearset.teeth.planet"),
                            .ring_teeth = teeth("gearset.teeth.ring"),
                            .module = value("gearset.module"),
                            .helix_angle = value("gearset.helix_angle")};
  set.rack.pressure_angle = value("gearset.pressure_angle");
  return set;
}

constexpr std::string_view sun_support_rule =
    "an overhung shaft of half the sun's diameter, 2.5 of its diameters long: proportional to size and "
    "modulus, 1e8 N/m for a sun of 111 mm in steel";
constexpr std::string_view ring_support_rule =
    "a ring bolted to its housing: proportional to size and modulus, 1e9 N/m for a ring of 237 mm in steel";
constexpr std::string_view carrier_support_rule =
    "two bearings of the carrier: proportional to size and modulus, 5e8 N/m at a centre distance of 88.5 mm "
    "in steel";
constexpr std::string_view sun_tilt_rule =
    "the same shaft under a moment: E I/l, in proportion to gearset.dynamics.sun.support_stiffness";
constexpr std::string_view sun_axial_rule =
    "the thrust of helical teeth needs a bearing: as stiff as the shaft of the sun is radially by default";
constexpr std::string_view flexpin_rule =
    "five eighths of the bore of the inner ring, which leaves room for a sleeve";
constexpr std::string_view backlash_rule =
    "least backlash recommended by ISO/TR 10064-2, 2/3 (0.06 + 0.0005 a + 0.03 m_n) mm normal to the teeth";

template <gearset::Member member, const std::string_view& reason>
std::optional<DerivedDefault> support(const ValuesOfSet& value) {
  const std::optional<gearset::PlanetarySet> set = teeth_of(value);
  if (!set) return std::nullopt;
  return DerivedDefault{stiffness_text(gearset::dynamics::default_support_stiffness(
                            *set, member, value("material.youngs_modulus"))),
                        std::string(reason)};
}

// For a set in three dimensions.
std::optional<DerivedDefault> sun_tilt(const ValuesOfSet& value) {
  const std::optional<gearset::PlanetarySet> set = teeth_of(value);
  if (!set || !value.has({"gearset.carrier.bearing_positions", "gearset.dynamics.sun.support_stiffness"}))
    return std::nullopt;
  return DerivedDefault{
      fmt::format("{:.6g} N.m/rad", gearset::dynamics::default_sun_tilt_stiffness(
                                        *set, value("gearset.dynamics.sun.support_stiffness"),
                                        value("material.youngs_modulus"))),
      std::string(sun_tilt_rule)};
}

std::optional<DerivedDefault> sun_axial(const ValuesOfSet& value) {
  const std::optional<gearset::PlanetarySet> set = teeth_of(value);
  if (!set || set->helix_angle == 0.0 || !value.has({"gearset.carrier.bearing_positions"}))
    return std::nullopt;
  return DerivedDefault{stiffness_text(gearset::dynamics::default_support_stiffness(
                            *set, gearset::Member::sun, value("material.youngs_modulus"))),
                        std::string(sun_axial_rule)};
}

bool is_flexpin(const ValuesOfSet& value) {
  return value.has({"support.pin_ends", "bearing.tilt_state"}) &&
         value.choice("support.pin_ends") == "flexpin" && value.choice("bearing.tilt_state") == "computed";
}

std::optional<DerivedDefault> flexpin_diameter(const ValuesOfSet& value) {
  if (!is_flexpin(value) || !value.has({"bearing.bore"})) return std::nullopt;
  return DerivedDefault{fmt::format("{:.6g} mm", 1e3 * 0.625 * value("bearing.bore")),
                        std::string(flexpin_rule)};
}

std::optional<DerivedDefault> backlash(const ValuesOfSet& value) {
  const std::optional<gearset::PlanetarySet> set = teeth_of(value);
  if (!set) return std::nullopt;
  return DerivedDefault{
      fmt::format("{:.6g} mm", 1e3 * gearset::dynamics::default_backlash(*set)),
      fmt::format("{}: a {:.4g} mm, m_n {:.4g} mm", backlash_rule,
                  1e3 * gearset::dynamics::reference_centre_distance(*set), 1e3 * set->module)};
}

bearing::PinEnds pin_ends(const ValuesOfSet& value) {
  if (is_flexpin(value)) return bearing::PinEnds::flexpin;
  const bool one = value.has({"support.pin_ends", "bearing.tilt_state"}) &&
                   value.choice("support.pin_ends") == "one" &&
                   value.choice("bearing.tilt_state") == "computed";
  return one ? bearing::PinEnds::one : bearing::PinEnds::both;
}

// Walls of the carrier as its mass has them: both together the plate ratio times the face width. Where tilts
// are computed, pins are as support.pin_* has them.
std::optional<DerivedDefault> pin_stiffness_of_bearing(const ValuesOfSet& value) {
  if (!value.has({"bearing.bore", "bearing.per_planet", "gearset.face_width", "material.youngs_modulus",
                  "material.poisson_ratio"}))
    return std::nullopt;
  const double face = value("gearset.face_width");
  constexpr double default_plate_ratio = 0.5;  // of sets among several, which state no carrier
  const double plates = value.has({"gearset.dynamics.carrier.plate_ratio"})
                            ? value("gearset.dynamics.carrier.plate_ratio")
                            : default_plate_ratio;
  bearing::PlanetPin pin{.diameter = value("bearing.bore"),
                         .loaded_length = face,
                         .span = face * (1.0 + 0.5 * plates),
                         .youngs_modulus = value("material.youngs_modulus"),
                         .poisson_ratio = value("material.poisson_ratio"),
                         .ends = pin_ends(value)};
  if (pin.ends != bearing::PinEnds::both) {
    pin.span = value.has({"support.pin_span"}) ? value("support.pin_span") : face;
    pin.loaded_length = std::min(face, pin.span);
  }
  if (pin.ends == bearing::PinEnds::flexpin) pin.diameter = value("support.pin_diameter");
  constexpr std::string_view held[] = {
      "between the middles of the carrier's walls",
      "clamped in one wall: twice the distance from there to the middle of the "
      "face",
      "from the wall to where it carries its sleeve: a flexpin"};
  return DerivedDefault{
      stiffness_text(bearing::pin_stiffness(pin) / value("bearing.per_planet")),
      fmt::format(
          "a solid pin of {:.4g} mm, {:.4g} mm {}, shared by the bearings of a planet; the walls are rigid",
          1e3 * pin.diameter, 1e3 * pin.span, held[static_cast<std::size_t>(pin.ends)])};
}

// No maker's roller has a sharp end.
std::optional<DerivedDefault> roller_profile(const ValuesOfSet& value) {
  if (!value.has({"bearing.rollers", "bearing.type"}) || value.choice("bearing.type") == "spherical-roller")
    return std::nullopt;
  return DerivedDefault{"iso16281",
                        "reference profile of ISO/TS 16281, since catalogue rollers have relieved ends; "
                        "straight ones state straight"};
}

std::optional<DerivedDefault> life_method(const ValuesOfSet& value) {
  const bool required =
      std::ranges::any_of(requirement_paths(), [&](const std::string& path) { return value.has({path}); });
  if (!required && !value.has({"bearing.dynamic_capacity"})) return std::nullopt;
  return DerivedDefault{"iso-16281", required ? "a requirement is stated" : "the rating C is known"};
}

bool oil_is_stated(const ValuesOfSet& value) {
  const auto is_stated = [&](std::string_view path) { return value.has({path}); };
  return std::ranges::any_of(kCleanlinessPaths, is_stated) || std::ranges::any_of(kViscosityPaths, is_stated);
}

std::optional<DerivedDefault> required_life(const ValuesOfSet& value) {
  if (!value.has({"requirements.life", "life.method"})) return std::nullopt;
  const bearing::rating::Life life = bearing::rating::governing_life(
      *value_named<bearing::rating::LifeMethod>(value.choice("life.method")), oil_is_stated(value));
  return DerivedDefault{bearing::rating::hours_key(life), "the governing life, by life.method"};
}

// Planet bearings have rollers.
std::optional<DerivedDefault> minimum_load(const ValuesOfSet& value) {
  if (!value.has({kSpectrumPath})) return std::nullopt;
  return DerivedDefault{"0.02", "makers' rule of thumb for roller bearings [SKFMinimumLoad]"};
}

// Who states the error of a step gets that one.
std::optional<DerivedDefault> load_error_share(const ValuesOfSet& value) {
  if (!value.given("simulation.length_error")) return std::nullopt;
  return DerivedDefault{"0", "simulation.length_error is given"};
}

// Who states the sliding speed gets that one.
std::optional<DerivedDefault> sliding_share(const ValuesOfSet& value) {
  if (!value.given("traction.sliding_scale")) return std::nullopt;
  return DerivedDefault{"0", "traction.sliding_scale is given"};
}

// Whether a structure of parameters needs the value, and whether bearings have it that are not moved in time.
enum class Needed { always, at_times, at_rest_too };

struct DefaultRule {
  std::string_view path;
  Rule apply;
  Needed needed;
  std::string_view text;
};

// In an order in which each finds what it follows from.
constexpr DefaultRule default_rules[] = {
    {"bearing.cage.pocket_clearance", pocket_clearance, Needed::always,
     "a fiftieth of the diameter of a roller or ball, at most half of the gap between them"},
    {"bearing.cage.pocket_stiffness", pocket_stiffness, Needed::always,
     "a bar between two pockets, clamped at both ends, of the common cage material nearest in density"},
    {"bearing.cage.touch_down_stiffness", touch_down_stiffness, Needed::always,
     "a fifth of the modulus of the common cage material nearest in density times the cage's width"},
    {"bearing.cage.guide_land_diameter", guide_land, Needed::at_times,
     "a clearance of 6 % of the roller or ball diameter, at most half of that to the raceway"},
    {"bearing.cage.pocket_damping", pocket_damping, Needed::at_times,
     "1 s/m of polyamide, 0.3 s/m of metals, by the common cage material nearest in density"},
    {"gearset.dynamics.sun.support_stiffness", support<gearset::Member::sun, sun_support_rule>,
     Needed::at_times, sun_support_rule},
    {"gearset.dynamics.ring.support_stiffness", support<gearset::Member::ring, ring_support_rule>,
     Needed::at_times, ring_support_rule},
    {"gearset.dynamics.carrier.support_stiffness", support<gearset::Member::carrier, carrier_support_rule>,
     Needed::at_times, carrier_support_rule},
    {"gearset.dynamics.backlash", backlash, Needed::at_times, backlash_rule},
    {"gearset.dynamics.sun.tilt_stiffness", sun_tilt, Needed::at_times, sun_tilt_rule},
    {"gearset.dynamics.sun.axial_stiffness", sun_axial, Needed::at_times, sun_axial_rule},
    {"support.pin_diameter", flexpin_diameter, Needed::at_times, flexpin_rule},
    {"support.stiffness", pin_stiffness_of_bearing, Needed::always,
     "a solid pin that fills the bore of the inner ring, between the middles of both walls of the carrier, "
     "shared by the bearings of a planet; each of several sets has its own. Held at one end, and as a "
     "flexpin, "
     "as support.pin_ends has it where tilts are computed"},
    {"bearing.profile.kind", roller_profile, Needed::at_rest_too,
     "iso16281: catalogue rollers have relieved ends; straight ones state straight"},
    {"life.method", life_method, Needed::at_rest_too,
     "iso-16281, where C is known from the catalogue or stated, or a requirement is"},
    {"requirements.life_key", required_life, Needed::at_rest_too,
     "the governing life, where requirements.life is given"},
    {"simulation.load_error_share", load_error_share, Needed::at_times,
     "0, where simulation.length_error is given"},
    {"traction.sliding_share", sliding_share, Needed::at_rest_too,
     "0, where traction.sliding_scale is given"},
    {"life.minimum_load", minimum_load, Needed::at_rest_too,
     "0.02, where spectrum is given: makers' rule of thumb for roller bearings"}};

void fill_one(CaseData& data, const std::string& prefix, const DefaultRule& rule) {
  const std::string path(rule.path);
  const Field* field = find_field(path);
  const std::string full = field != nullptr && in_each_set(*field) ? prefix + path : path;
  const auto stored = data.values.find(full);
  if (stored != data.values.end() && !stored->second.from_default) return;
  const std::optional<DerivedDefault> derived = rule.apply(ValuesOfSet(data, prefix));
  if (!derived && !field->default_text.empty()) return;  // nothing is there for it to follow from
  if (stored != data.values.end()) {
    data.assumed.erase(full);
    data.values.erase(stored);
  }
  if (!derived) return;
  FieldReading reading = read_field_text(*field, derived->text);
  if (!reading.good) return;  // outside the range of the field: the case must state a value
  data.values[full] = {std::move(reading.value), {}, true};
  data.assumed[full] = "default: " + derived->reason;
}

}  // namespace

std::string_view default_rule(std::string_view path) {
  for (const DefaultRule& rule : default_rules)
    if (rule.path == path) return rule.text;
  return {};
}

bool follows_always(std::string_view path) {
  return std::ranges::any_of(default_rules, [&](const DefaultRule& rule) {
    return rule.needed == Needed::always && rule.path == path;
  });
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
  for (const std::string& prefix : set_prefixes(data.shape))
    for (const DefaultRule& rule : default_rules) {
      const bool at_rest = rule.needed == Needed::at_rest_too;
      if (!in_time && !at_rest) continue;
      // The pin belongs to a set, though its field does not: each of several finds its own, in `of_set`.
      if (data.shape.several && !in_each_set(*find_field(rule.path)) && !at_rest) continue;
      if ((find_field(rule.path)->models & model) == 0) continue;
      fill_one(data, prefix, rule);
    }
}

}  // namespace orbearing::app
