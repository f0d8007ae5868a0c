// Do the values of planet bearings fit their type? See consistency.hpp.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "app/case/bearing_type.hpp"
#include "app/case/consistency.hpp"
#include "app/case/set_case.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::app {

namespace {

using bearing::PlanetBearingType;

constexpr const char* kBearingType = "bearing.type";

class TypeCheck {
 public:
  TypeCheck(const ResolvedCase& in, std::vector<Mistake>& mistakes)
      : in_(in), type_(in.choice(kBearingType)), mistakes_(mistakes) {}

  void add(const std::string& path, std::string found, std::string required) {
    add_error_at(in_, path, std::move(found), std::move(required), mistakes_);
  }
  void need(const char* path) {
    if (!in_.has(path)) add(path, "missing", fmt::format("a value is required with bearing.type: {}", type_));
  }
  // What these bearings are not computed with.
  void not_with_type(const std::string& path, const std::string& value) {
    add(path, fmt::format("{} together with bearing.type: {}", value, type_),
        path == "bearing.laminae" || path == "bearing.profile.kind"
            ? "none is required, or bearing.type: cylindrical-roller or tapered-roller"
            : "none is required, or bearing.type: cylindrical-roller");
  }
  void refuse_stated(const char* path) {
    if (is_stated(in_, path)) not_with_type(path, in_.given(path));
  }
  void refuse_choice(const char* path, const char* value) {
    if (in_.has(path) && in_.choice(path) == value) not_with_type(path, value);
  }
  bool is_nonzero(const char* path) const { return in_.has(path) && in_.quantity(path) != 0.0; }

  void check_refinements() {
    for (const char* path :
         {"bearing.designation", "bearing.clearance_class", "bearing.axial_places", "defect.race"})
      refuse_stated(path);
    if (type_ != "tapered-roller")
      for (const char* path : {"bearing.laminae", "bearing.profile.kind"}) refuse_stated(path);
    for (const auto& [path, value] : {std::pair{"bearing.complement", "full"},
                                      {"bearing.clearance_state", "unmounted"},
                                      {"bearing.tilt_state", "computed"},
                                      {"gearset.planet_rim", "elastic"},
                                      {"life.viscosity_ratio_by", "film"}})
      refuse_choice(path, value);
    if (in_.has("bearing.rings") && in_.choice("bearing.rings") != "both")
      not_with_type("bearing.rings", in_.choice("bearing.rings"));
    if (in_.has("film.enabled") && in_.flag("film.enabled")) not_with_type("film.enabled", "true");
    for (const char* path : {"bearing.misalignment.planet_tilt", "bearing.misalignment.carrier_wind_up"})
      if (is_nonzero(path)) not_with_type(path, in_.given(path));
    for (const char* list :
         {"bearing.roller_diameter_deviation", "bearing.inner_race.waviness.amplitude",
          "bearing.outer_race.waviness.amplitude", "bearing.inner_race.out_of_roundness.amplitude",
          "bearing.outer_race.out_of_roundness.amplitude"})
      if (is_anywhere_nonzero(in_, list)) not_with_type(list, "a list");
    if (const std::string uneven = uneven_planets_by(in_); !uneven.empty()) not_with_type(uneven, "a list");
  }

  // The moment of helical teeth needs two bearings, or a pair, to hold it.
  void check_moment() {
    if (!in_.has("bearing.per_planet") || in_.integer("bearing.per_planet") > 1 ||
        !is_nonzero("gearset.helix_angle"))
      return;
    add("bearing.per_planet",
        fmt::format("one bearing of bearing.type: {} together with gearset.helix_angle", type_),
        "two bearings or more are required, which hold the moment of helical teeth");
  }

  void check_tapered() {
    need("bearing.rows.contact_angle");
    need("bearing.rows.arrangement");
    if (in_.has("bearing.per_planet") && in_.integer("bearing.per_planet") != 2)
      add("bearing.per_planet", fmt::format("{} tapered roller bearings", in_.integer("bearing.per_planet")),
          "2 are required: a pair whose axial forces balance");
    if (in_.has("bearing.rows.preload") && in_.has("bearing.rows.approach"))
      add("bearing.rows.approach", "a value together with bearing.rows.preload",
          "one of the two is required");
    for (const char* mounted : {"bearing.rows.preload", "bearing.rows.approach"})
      if (in_.has(mounted) && is_nonzero("bearing.radial_clearance"))
        add("bearing.radial_clearance",
            fmt::format("{} together with {}", in_.given("bearing.radial_clearance"), mounted),
            "0 um is required: mounting sets preload or play of a pair");
    if (!has_all(in_, {"bearing.rows.distance", "bearing.width", "gearset.face_width"})) return;
    const double distance = in_.quantity("bearing.rows.distance"), width = in_.quantity("bearing.width"),
                 face = in_.quantity("gearset.face_width");
    constexpr double round_off = 1e-9;  // [m]
    if (distance < width - round_off || distance + width > face + round_off)
      add("bearing.rows.distance", in_.given("bearing.rows.distance"),
          fmt::format(
              "a distance from the width of a bearing, {:.4g} mm, to the face less that, {:.4g} mm, is "
              "required",
              1e3 * width, 1e3 * (face - width)));
  }

  void check_balls() {
    refuse_stated("spectrum");
    need("bearing.balls");
    need("bearing.ball_diameter");
    for (const char* path : {"bearing.rollers", "bearing.roller_diameter", "bearing.roller_length"})
      if (in_.has(path))
        add(path, fmt::format("{} together with bearing.type: {}", in_.given(path), type_),
            "bearing.balls and bearing.ball_diameter are required instead");
    if (!has_all(in_, {"bearing.balls", "bearing.ball_diameter", "bearing.pitch_diameter"})) return;
    const double diameter = in_.quantity("bearing.ball_diameter");
    const double spacing =
        in_.quantity("bearing.pitch_diameter") * std::sin(constants::pi / in_.integer("bearing.balls"));
    if (diameter >= spacing)
      add("bearing.balls",
          fmt::format("{} balls do not fit around the pitch circle", in_.integer("bearing.balls")),
          fmt::format(
              "a ball diameter ({:.4g} mm) less than the distance of their centres, {:.4g} mm, is required",
              1e3 * diameter, 1e3 * spacing));
  }

 private:
  const ResolvedCase& in_;
  std::string type_;
  std::vector<Mistake>& mistakes_;
};

}  // namespace

void check_bearing_type(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  const PlanetBearingType type = bearing_type_of(in);
  if (type == PlanetBearingType::cylindrical_roller) return;
  TypeCheck check(in, mistakes);
  if (in.model() != planetary_drivetrain)
    return check.add(
        kBearingType, fmt::format("'{}' in a case of one bearing", in.choice(kBearingType)),
        "cylindrical-roller is required; other types are those of planets, in cases of the model "
        "planetary-drivetrain");
  check.check_refinements();
  check.check_moment();
  if (type == PlanetBearingType::tapered_roller) check.check_tapered();
  if (type == PlanetBearingType::spherical_roller) check.need("bearing.rows.contact_angle");
  if (type == PlanetBearingType::deep_groove_ball) check.check_balls();
}

}  // namespace orbearing::app
