#include "coupling/fmu/bearing_fields.hpp"

#include "coupling/fmu/profile_numbers.hpp"

namespace orbearing::fmu {

namespace {

using Fields = FieldList<BearingModel>;
using enum Use;
using enum Allowed;

void add_dimensions(Fields& f) {
  f.number(
       {"bearing.rollers", "1", "number of rollers", constant, positive},
       [](auto& m) -> auto& { return m.setup.bearing.rollers; })
      .number(
          {"bearing.roller_diameter", "m", "diameter of a roller", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.roller_diameter; })
      .number(
          {"bearing.roller_length", "m", "effective contact length of a roller", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.roller_length; })
      .number(
          {"bearing.pitch_diameter", "m", "diameter of the pitch circle", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.pitch_diameter; })
      .number(
          {"bearing.radial_clearance", "m", "radial internal clearance, diametral", parameter, any},
          [](auto& m) -> auto& { return m.setup.bearing.radial_clearance; })
      .number(
          {"bearing.bore", "m", "bore of the inner ring", parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.bearing.bore; })
      .number(
          {"bearing.outside_diameter", "m", "outside diameter of the outer ring", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.outside_diameter; })
      .number(
          {"bearing.width", "m", "width of the rings", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.width; });
}

void add_cage(Fields& f) {
  f.number(
       {"bearing.cage.inner_diameter", "m", "inner diameter of the cage", parameter, positive},
       [](auto& m) -> auto& { return m.setup.bearing.cage.inner_diameter; })
      .number(
          {"bearing.cage.outer_diameter", "m", "outer diameter of the cage", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.cage.outer_diameter; })
      .number(
          {"bearing.cage.width", "m", "width of the cage", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.cage.width; })
      .number(
          {"bearing.cage.density", "kg/m3", "density of the cage", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.cage.density; })
      .number(
          {"bearing.cage.guidance"}, [](auto& m) -> auto& { return m.setup.bearing.cage.guidance; });
}

void add_material(Fields& f) {
  f.number(
       {"material.youngs_modulus", "Pa", "Young's modulus of rings and rollers", parameter, positive},
       [](auto& m) -> auto& { return m.setup.bearing.material.youngs_modulus; })
      .number(
          {"material.poisson_ratio", "1", "Poisson's ratio of rings and rollers", parameter, share},
          [](auto& m) -> auto& { return m.setup.bearing.material.poisson_ratio; })
      .number(
          {"material.density", "kg/m3", "density of rings and rollers", parameter, positive},
          [](auto& m) -> auto& { return m.setup.bearing.material.density; })
      .number(
          {"contact.law"}, [](auto& m) -> auto& { return m.setup.bearing.contact_law; })
      .number(
          {"bearing.laminae"}, [](auto& m) -> auto& { return m.setup.bearing.laminae; })
      .number(
          {"lubricant.viscosity", "Pa.s", "dynamic viscosity of the oil", parameter, not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.lubricant.viscosity; })
      .number(
          {"lubricant.pressure_viscosity", "1/Pa", "pressure-viscosity coefficient of the oil", parameter,
           not_negative},
          [](auto& m) -> auto& { return m.setup.dynamics.lubricant.pressure_viscosity; });
}

std::vector<double> numbers_of(const std::vector<bearing::RaceHarmonic>& form) {
  std::vector<double> numbers;
  for (const bearing::RaceHarmonic& wave : form)
    numbers.insert(numbers.end(), {static_cast<double>(wave.order), wave.amplitude, wave.phase,
                                   static_cast<double>(wave.turning)});
  return numbers;
}

std::vector<bearing::RaceHarmonic> form_from(const std::vector<double>& numbers) {
  std::vector<bearing::RaceHarmonic> form;
  for (std::size_t i = 0; i + 3 < numbers.size(); i += 4)
    form.push_back({static_cast<int>(numbers[i]), numbers[i + 1], numbers[i + 2], numbers[i + 3] != 0.0});
  return form;
}

// `member` gives a reference to a list of one kind, `to` and `from` turn it into numbers and back.
template <class Member, class To, class From>
void add_list(Fields& f, const char* name, Member member, To to, From from) {
  f.list(
      name, [=](const BearingModel& m) { return to(member(m)); },
      [=](BearingModel& m, const std::vector<double>& numbers) { member(m) = from(numbers); });
}

void add_surfaces(Fields& f) {
  const auto same = [](const std::vector<double>& list) { return list; };
  const auto waves = [](const std::vector<bearing::RaceHarmonic>& form) { return numbers_of(form); };
  const auto relief = [](const bearing::profile::Profile& profile) { return profile_numbers(profile); };
  add_list(
      f, "bearing.inner_race.form", [](auto& m) -> auto& { return m.setup.bearing.inner_form; }, waves,
      form_from);
  add_list(
      f, "bearing.outer_race.form", [](auto& m) -> auto& { return m.setup.bearing.outer_form; }, waves,
      form_from);
  add_list(
      f, "bearing.roller_diameter_deviation",
      [](auto& m) -> auto& { return m.setup.bearing.roller_diameter_deviation; }, same, same);
  add_list(
      f, "bearing.profile", [](auto& m) -> auto& { return m.setup.bearing.roller_profile; }, relief,
      profile_from);
  add_list(
      f, "bearing.inner_race.profile", [](auto& m) -> auto& { return m.setup.bearing.inner_race_profile; },
      relief, profile_from);
  add_list(
      f, "bearing.outer_race.profile", [](auto& m) -> auto& { return m.setup.bearing.outer_race_profile; },
      relief, profile_from);
}

void add_run(Fields& f) {
  f.number(
       {"gearset.centre_distance", "m", "from the carrier's axis to the pin's", parameter, not_negative},
       [](auto& m) -> auto& { return m.setup.orbit_radius; })
      .number(
          {"first_roller", "rad", "place of the first roller at the start", parameter, any},
          [](auto& m) -> auto& { return m.setup.first_roller; })
      .number(
          {"bearing.misalignment.x", "rad",
           "tilt of the bore's axis against the pin's: outward at the bearing's positive end; felt by "
           "laminae",
           parameter, any},
          [](auto& m) -> auto& { return m.setup.bore_tilt.x(); })
      .number(
          {"bearing.misalignment.y", "rad", "the same in the sense of carrier rotation", parameter, any},
          [](auto& m) -> auto& { return m.setup.bore_tilt.y(); })
      .number(
          {"life.lambda", "1", "product of lambda and nu of ISO/TR 1281-1", parameter, positive},
          [](auto& m) -> auto& { return m.setup.lambda; })
      .number(
          {"simulation.length_error", "m", "allowed error of one internal step", parameter, positive},
          [](auto& m) -> auto& { return m.setup.allowed_length_error; })
      .number(
          {"simulation.places"}, [](auto& m) -> auto& { return m.setup.places; })
      .number(
          {"simulation.most_steps"}, [](auto& m) -> auto& { return m.setup.most_steps; })
      .number(
          {"operation.planet_speed"}, [](auto& m) -> auto& { return m.planet_speed; })
      .number(
          {"operation.carrier_speed"}, [](auto& m) -> auto& { return m.carrier_speed; });
}

}  // namespace

std::vector<SetupField<BearingModel>> bearing_fields() {
  Fields fields;
  add_dimensions(fields);
  add_cage(fields);
  add_material(fields);
  add_surfaces(fields);
  add_race_fields(fields);
  add_cage_motion_fields(fields);
  add_run(fields);
  return fields.fields();
}

NumberTable numbers_of(const BearingModel& model) {
  return numbers_of_fields("bearing", bearing_fields(), model);
}

BearingModel bearing_from(const NumberTable& numbers) {
  return setup_from<BearingModel>(bearing_fields(), numbers);
}

}  // namespace orbearing::fmu
