// Fields of the gear set and of the power that drives it.
#include "app/case/field_table.hpp"

namespace orbearing::app::table {

namespace {

constexpr unsigned drivetrain = planetary_drivetrain;

const Use& by_all() {
  static const Use use(use::of_a_drivetrain, 0);
  return use;
}

const std::vector<std::string>& members() {
  static const std::vector<std::string> names{"sun", "ring", "carrier"};
  return names;
}

Field count(std::string path, std::string meaning, const Use& use, double least, double most) {
  return {.path = std::move(path),
          .kind = Kind::integer,
          .meaning = std::move(meaning),
          .use = use,
          .models = drivetrain,
          .required_by = drivetrain,
          .range = {least, most}};
}

Field length(std::string path, std::string meaning, double most) {
  return {.path = std::move(path),
          .kind = Kind::quantity,
          .meaning = std::move(meaning),
          .use = by_all(),
          .models = drivetrain,
          .required_by = drivetrain,
          .dimension = dimension::length,
          .range = {.least = 0.0, .most = most, .least_allowed = false}};
}

Field ratio(std::string path, std::string meaning, const Use& use, Range range, std::string default_text,
            std::string reason) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .use = use,
          .models = drivetrain,
          .range = range,
          .default_text = std::move(default_text),
          .default_reason = std::move(reason)};
}

Field shift(std::string path, std::string meaning) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .use = by_all(),
          .models = drivetrain,
          .required_by = drivetrain,
          .range = {-2.0, 2.0}};
}

void add_input(std::vector<Field>& fields) {
  fields.push_back({.path = "input.member",
                    .kind = Kind::choice,
                    .meaning = "member that the power enters by",
                    .use = by_all(),
                    .models = drivetrain,
                    .choices = members(),
                    .default_text = "sun",
                    .default_reason = "the usual reduction gear"});
  fields.push_back({.path = "input.power",
                    .kind = Kind::quantity,
                    .meaning = "power that enters",
                    .use = Use(use::lives | use::bearings_as_springs, use::mesh | use::fmu_bearing),
                    .models = drivetrain,
                    .required_by = drivetrain,
                    .dimension = dimension::power,
                    .range = {1e-6, 1e7}});
  fields.push_back({.path = "input.speed",
                    .kind = Kind::quantity,
                    .meaning = "speed of the driven member relative to the housing",
                    .use = Use(use::of_a_drivetrain & ~unsigned{use::mesh}, use::mesh),
                    .models = drivetrain,
                    .required_by = drivetrain,
                    .dimension = dimension::angular_speed,
                    .range = {1e-3, 1e6}});
}

void add_rack(std::vector<Field>& fields) {
  const std::string rack = "the basic rack of ISO 53";
  fields.push_back({.path = "gearset.pressure_angle",
                    .kind = Kind::quantity,
                    .meaning = "normal pressure angle of the basic rack",
                    .use = by_all(),
                    .models = drivetrain,
                    .dimension = dimension::angle,
                    .range = {10.0, 35.0},
                    .default_text = "20 deg",
                    .default_reason = rack});
  fields.push_back(shift("gearset.profile_shift.sun", "profile shift of the sun, in modules"));
  fields.push_back(
      shift("gearset.profile_shift.ring", "profile shift of the ring, in modules, positive outward"));
  fields.push_back(length("gearset.face_width", "width of the teeth", 1e4));
  fields.push_back(
      ratio("gearset.addendum", "addendum of the basic rack, in modules", by_all(), {0.5, 1.5}, "1.0", rack));
  fields.push_back(ratio("gearset.clearance", "bottom clearance of the basic rack, in modules", by_all(),
                         {0.0, 0.6}, "0.25", rack));
  fields.push_back(ratio("gearset.root_fillet_radius", "root fillet radius of the basic rack, in modules",
                         by_all(), {0.0, 0.6}, "0.38", rack));
}

void add_bodies(std::vector<Field>& fields) {
  const Use bodies =
      Use(use::gears_in_motion | use::natural | use::mesh, use::rollers_at_rest | use::fmu_bearing)
          .felt_too(use::quasi_static, where_pins_are_displaced());
  const Use planet = Use(use::bearings_as_springs | use::mesh, use::lives | use::fmu_bearing)
                         .when(where_absent("bearing.rollers"));
  fields.push_back(ratio("gearset.sun_bore_ratio", "bore of the sun as a share of its root diameter", bodies,
                         {0.02, 0.98}, "0.5",
                         "a sun on a shaft; mesh stiffness and mass of the sun feel it"));
  fields.push_back(ratio("gearset.ring_outside_ratio",
                         "outside diameter of the ring, where it is held, as a multiple of its root diameter",
                         bodies, {1.005, 20.0}, "1.15",
                         "a rim of some five modules; mesh stiffness and mass of the ring feel it"));
  fields.push_back(ratio("gearset.planet_bore_ratio",
                         "bore of a planet that has no given bearing, as a share of module x (teeth - 2.5)",
                         planet, {0.02, 0.98}, "0.7",
                         "room for roller bearings under a rim of a few modules"));
}

}  // namespace

void add_drivetrain_fields(std::vector<Field>& fields) {
  add_input(fields);
  fields.push_back({.path = "gearset.fixed",
                    .kind = Kind::choice,
                    .meaning = "member held by the housing",
                    .use = by_all(),
                    .models = drivetrain,
                    .choices = members(),
                    .default_text = "ring",
                    .default_reason = "the usual reduction gear"});
  fields.push_back(count("gearset.planets", "number of equally spaced planets",
                         Use(use::of_a_drivetrain & ~unsigned{use::fmu_bearing}, use::fmu_bearing), 1, 24));
  fields.push_back(count("gearset.teeth.sun", "teeth of the sun", by_all(), 5, 2000));
  fields.push_back(count("gearset.teeth.planet", "teeth of a planet", by_all(), 5, 2000));
  fields.push_back(count("gearset.teeth.ring", "teeth of the ring", by_all(), 15, 4000));
  fields.push_back(length("gearset.module", "normal module", 100.0));
  add_rack(fields);
  add_bodies(fields);
}

}  // namespace orbearing::app::table
