// Fields of the gear set and of the power that drives it.
#include <algorithm>

#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "app/case/spectrum_case.hpp"
#include "gearset/parameters.hpp"
#include "gearset/planet_pair.hpp"
#include "gearset/spatial/spatial_set.hpp"

namespace orbearing::app::table {

namespace {

Field ratio(std::string path, std::string meaning, const Use& use, Range range, std::string default_text,
            std::string reason) {
  return {.path = std::move(path),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .use = use,
          .models = planetary_drivetrain,
          .range = range,
          .default_text = std::move(default_text),
          .default_reason = std::move(reason)};
}

void add_bodies(std::vector<Field>& fields) {
  const Use bodies =
      Use(use::gears_in_motion | use::natural | use::mesh, use::rollers_at_rest | use::fmu_bearing)
          .used_too(use::quasi_static, where_planets_carry_unlike_loads());
  const Use planet =
      Use(use::bearings_as_springs | use::mesh, use::lives | use::fmu_bearing | use::planet_stiffness)
          .when(where_absent("bearing.rollers"))
          .when(where_absent("bearing.balls"));
  fields.push_back(ratio("gearset.sun_bore_ratio", "bore of the sun as a share of its root diameter", bodies,
                         {0.02, 0.98}, "0.5",
                         "a sun on a shaft; affects mesh stiffness and mass of the sun"));
  fields.push_back(ratio("gearset.ring_outside_ratio",
                         "outside diameter of the ring, where it is held, as a multiple of its root diameter",
                         bodies, {1.005, 20.0}, "1.15",
                         "a rim of some five modules; affects mesh stiffness and mass of the ring"));
  fields.push_back(ratio("gearset.planet_bore_ratio",
                         "bore of a planet without a stated bearing, as a share of module x (teeth - 2.5)",
                         planet, {0.02, 0.98}, "0.7",
                         "room for roller bearings under a rim of a few modules"));
}

// What follows from other values, and may be stated so that it is checked: no result follows from it.
void add_checks(std::vector<Field>& fields) {
  const Use checked(use::of_a_drivetrain, 0);
  fields.push_back({.path = "gearset.centre_distance",
                    .kind = Kind::quantity,
                    .meaning = "check only: working centre distance of a drawing; refused if teeth, module "
                               "and shifts give a value more than 0.01 mm away",
                    .use = checked,
                    .models = planetary_drivetrain,
                    .dimension = dimension::length,
                    .range = positive(1e5)});
  fields.push_back({.path = "gearset.profile_shift.planet",
                    .kind = Kind::number,
                    .meaning = "check only: profile shift of a planet, in modules; refused if the common "
                               "centre distance gives a value more than 0.005 away",
                    .use = checked,
                    .models = planetary_drivetrain,
                    .range = {-2.0, 2.0}});
}

}  // namespace

void add_drivetrain_fields(std::vector<Field>& fields) {
  add_described(fields, gearset::Drive{});
  const auto power = std::ranges::find(fields, kPowerPath, &Field::path);
  const Use use_of_power = power->use;
  const auto behind = fields.insert(power + 1, torque_field(use_of_power));
  fields.insert(behind + 1, torque_curve_field(use_of_power));
  fields.push_back(spectrum_field());
  add_described(fields, gearset::PlanetarySet{});
  add_described(fields, gearset::SecondPlanet{});
  add_described(fields, gearset::spatial::CarrierMounting{});
  std::ranges::find(fields, "gearset.carrier.housing_stiffness", &Field::path)->from_file = true;
  add_bodies(fields);
  add_checks(fields);
}

}  // namespace orbearing::app::table
