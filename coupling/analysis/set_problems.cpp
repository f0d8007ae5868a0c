#include "coupling/analysis/set_problems.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "bearing/contact/traction_law.hpp"
#include "bearing/design_problems.hpp"
#include "gearset/checks.hpp"
#include "gearset/planet_angles.hpp"
#include "gearset/spatial/housing_stiffness.hpp"
#include "gearset/stepped_planet.hpp"
#include "mechanics/append.hpp"
#include "mechanics/member_keys.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

using described::text_of;
using mechanics::append;
using mechanics::Problems;
using mechanics::significant;

namespace {

constexpr double fits_within = 1e-9;  // [m]

std::string millimetres(double length) {
  return significant(1e3 * length, 4) + " mm";
}
std::string of_list(std::size_t count) {
  return "a list of " + std::to_string(count);
}

/// Finds what does not fit in one set.
class SetCheck {
 public:
  explicit SetCheck(const StatedSet& set) : set_(set), planets_(set.planets), key_(set) {}

  Problems problems() {
    find_traction_of_balls();
    find_bad_gears();
    find_bad_error_lists();
    find_bad_carrier();
    find_bad_widths();
    find_bad_forms();
    find_bad_type();
    find_bad_rim();
    find_bad_tooth_contact();
    find_bad_tilt();
    find_bad_steps();
    find_bad_pairs();
    find_bad_positions();
    find_surplus_deviations();
    return std::move(found_);
  }

 private:
  using Lists = std::vector<const std::vector<double>*>;

  template <class Member>
  void add(const Member& of, const std::string& found, const std::string& required) {
    found_.push_back({key_(of), found + "; " + required});
  }
  template <class Member>
  std::string written(const Member& member) const {
    return mechanics::as_written(key_(member));
  }
  /// "gearset.planet_rim: elastic"
  template <class Choice>
  std::string chosen(const Choice& choice) const {
    return key_(choice) + ": " + std::string(text_of(choice));
  }

  bool tilt_is_computed() const { return planets_.seats.tilt == TiltState::computed; }
  bool has_elastic_rim() const { return planets_.rim == PlanetRim::elastic; }
  bool is_unmounted() const { return planets_.mounting.state == bearing::ClearanceState::unmounted; }
  bool has_loaded_teeth() const { return set_.teeth.flanks.contact == gearset::ToothContact::loaded; }

  /// Lists that make rollers unequal, or waves of the races.
  Lists uneven_rollers() const {
    return {&set_.rollers().diameter_deviation, &set_.forms.inner.waviness.amplitudes,
            &set_.forms.outer.waviness.amplitudes};
  }

  double planet_length() const {
    return set_.teeth.stepped.present() ? gearset::gear_planes(set_.teeth).length : set_.teeth.face_width;
  }

  void find_traction_of_balls() {
    const bearing::TractionLaw& stated = planets_.dynamics.race.traction;
    if (set_.rollers().count == 0 || nature_of(stated).of_rollers) return;
    add(stated, "'" + std::string(text_of(stated)) + "', a traction model for balls",
        bearing::kRollerLaws.text + std::string(" is required for rollers"));
  }

  bool has_all_of_gears() const {
    const bearing::Bearing& bearing = planets_.bearing;
    const bool begun = set_.has_bearing() || bearing.pitch_diameter > 0.0 || bearing.width > 0.0 ||
                       bearing.inner.seat_diameter > 0.0;
    return set_.teeth.module > 0.0 && set_.teeth.face_width > 0.0 &&
           (!begun || bearing.outer.seat_diameter > 0.0);
  }

  // Tooth numbers alone are checked beside missing inputs.
  void find_bad_gears() {
    const gearset::PlanetarySet& teeth = set_.teeth;
    if (teeth.sun_teeth == 0 || teeth.planet_teeth == 0 || teeth.ring_teeth == 0 || teeth.planets == 0)
      return;
    const bool pairs = set_.second_planet.present(), whole = has_all_of_gears();
    Problems problems;
    if (whole && pairs)
      problems = gearset::pair_problems(with_bore(set_), set_.second_planet);
    else if (!pairs)
      problems = whole ? gearset::assembly_problems(with_bore(set_)) : gearset::spacing_problems(teeth);
    if (problems.empty() && !pairs && whole)
      for (const mechanics::Problem& one : gearset::geometry_problems(with_bore(set_), set_.geometry))
        found_.push_back({one.key, "'" + mechanics::as_written(one.key) + "'; " + one.text});
    for (mechanics::Problem& one : problems)
      found_.push_back({key_in_case(set_, one.key), std::move(one.text)});
  }

  // Errors are listed pin by pin, and over a mesh period at more than one place.
  void find_bad_error_lists() {
    const GearDynamicsChoice& choice = set_.gears.choice;
    const auto planets = static_cast<std::size_t>(set_.teeth.planets);
    for (const auto* errors : Lists{&choice.pin_error_radial, &choice.pin_error_tangential})
      if (!errors->empty() && planets > 0 && errors->size() != planets)
        add(*errors, of_list(errors->size()),
            "one value for each of the " + std::to_string(planets) + " planets is required");
    if (!set_.teeth.planet_angles.empty() && planets > 0 && !set_.has_teeth())
      append(gearset::position_problems(
                 {.planets = set_.teeth.planets, .planet_angles = set_.teeth.planet_angles}),
             found_);
    for (const auto* errors : Lists{&choice.sun_error, &choice.ring_error})
      if (!errors->empty() && errors->size() < 3)
        add(*errors, of_list(errors->size()),
            "at least three values, at equal steps of a mesh period, are required");
  }

  void find_bad_carrier() {
    const gearset::spatial::CarrierMounting& carrier = set_.carrier;
    const std::size_t bearings = carrier.positions.size();
    if (bearings == 0) return;
    if (bearings < 2)
      return add(carrier.positions, of_list(bearings),
                 "at least two bearings, which hold the carrier against tilting, are required");
    for (const auto& [list, count] : {std::pair{&carrier.radial_stiffness, bearings},
                                      {&carrier.clearances, bearings},
                                      {&carrier.rotor_force, std::size_t{3}},
                                      {&carrier.rotor_moment, std::size_t{2}}})
      if (!list->empty() && list->size() != count)
        add(*list, of_list(list->size()), std::to_string(count) + " values are required");
    const std::size_t seats = std::size_t{gearset::spatial::kSeatDirections} * bearings;
    if (!carrier.housing.empty() && carrier.housing.size() != seats * seats)
      add(carrier.housing, of_list(carrier.housing.size()),
          std::to_string(seats * seats) + " values, " + std::to_string(seats) + " rows and columns for " +
              std::to_string(bearings) + " bearings, are required");
  }

  void find_bad_widths() {
    const double width = planets_.bearing.width;
    if (width == 0.0 || set_.teeth.face_width == 0.0) return;
    if (!bearing::are_in_order(planets_.bearings_per_planet * width, planet_length(), true))
      bearing::require_order(key_(planets_.bearings_per_planet),
                             "bearings within the planet's face: their widths in all",
                             planets_.bearings_per_planet * width, planet_length(), found_, true);
  }

  // A wave needs its order and its amplitude; phases may be left out altogether.
  void find_bad_waves(const bearing::RaceWaves& waves) {
    const bool has_order = !waves.orders.empty(), has_amplitude = !waves.amplitudes.empty();
    if (!has_order && !has_amplitude && waves.phases.empty()) return;
    if (!has_order || !has_amplitude)
      return add(has_order       ? waves.orders
                 : has_amplitude ? waves.amplitudes
                                 : waves.phases,
                 std::string("waves without ") + (has_order ? "amplitude" : "order"),
                 "orders and amplitudes in lists of equal length are required");
    for (const auto* values : Lists{&waves.amplitudes, &waves.phases})
      if (!values->empty() && values->size() != waves.orders.size())
        add(*values,
            std::to_string(values->size()) + " values for " + std::to_string(waves.orders.size()) + " waves",
            "as many values as orders are required");
  }

  void find_bad_forms() {
    for (const bearing::RaceForm* form : {&set_.forms.inner, &set_.forms.outer}) {
      find_bad_waves(form->out_of_roundness);
      find_bad_waves(form->waviness);
    }
  }

  // A rim rests on rollers that are known; springs of the gears follow from them.
  void find_bad_rim() {
    if (!has_elastic_rim()) return;
    if (!set_.has_bearing())
      add(planets_.rim, "elastic without a bearing", "rollers on which the rim rests are required");
    if (const auto& spring = set_.gears.choice.bearing_stiffness)
      add(planets_.rim, "elastic together with " + key_(spring),
          "no stiffness of the bearings is required, which follows from their rollers");
  }

  // Teeth under load push only, and follow from their form.
  void find_bad_tooth_contact() {
    const gearset::ToothContact& contact = set_.teeth.flanks.contact;
    const GearDynamicsChoice& choice = set_.gears.choice;
    if (!has_loaded_teeth()) return;
    if (!choice.separation)
      add(contact, "loaded together with " + key_(choice.separation) + ": false",
          "teeth that transmit compression only are required");
    for (const auto* stated : {&choice.sun_mesh_stiffness, &choice.ring_mesh_stiffness})
      if (*stated)
        add(contact, "loaded together with " + key_(*stated),
            "no stated mesh stiffness is required, which follows from the teeth");
  }

  // Computed tilt of a planet: it acts on laminae, and is that of bearings at rest.
  void find_bad_tilt() {
    const PinSeats& seats = planets_.seats;
    if (!tilt_is_computed() || !set_.has_bearing()) return;
    if (set_.rollers().laminae == 0)
      add(seats.tilt, "computed without " + key_(set_.rollers().laminae),
          "a number of laminae, which the tilt acts on, is required");
    for (const auto* list : uneven_rollers())
      if (is_anywhere_nonzero(*list))
        add(seats.tilt, "computed together with " + key_(*list),
            "equal rollers and races without waviness are required, since the tilt is that of bearings at "
            "rest");
    const auto bearings = static_cast<std::size_t>(planets_.bearings_per_planet);
    for (const auto* list : Lists{&seats.axial_positions, &seats.clearance_differences})
      if (!list->empty() && list->size() != bearings)
        add(*list, std::to_string(list->size()) + " values",
            "one for each of the " + std::to_string(bearings) + " bearings of a planet is required");
  }

  // Planets with two gears, or in pairs, are spur gears on rigid bodies whose bearings carry equal loads.
  void require_plain_planets(const int& teeth, const std::string& planets, const std::string& alike) {
    const auto object_to = [&](bool stated, const std::string& other, const std::string& required) {
      if (stated) add(teeth, planets + " together with " + other, required + " is required");
    };
    object_to(set_.teeth.helix_angle != 0.0, key_(set_.teeth.helix_angle), "0 deg");
    object_to(has_elastic_rim(), chosen(planets_.rim), "a rigid rim");
    object_to(has_loaded_teeth(), chosen(set_.teeth.flanks.contact), "linear contact");
    object_to(is_unmounted(), chosen(planets_.mounting.state), "the clearance in operation");
    const std::string uneven = unequal_loads_by(set_);
    object_to(!uneven.empty(), uneven, alike);
  }

  // The bearings of a planet with two gears hold its couple.
  void find_bad_steps() {
    const gearset::SteppedPlanet& second = set_.teeth.stepped;
    if (!second.present() || set_.teeth.face_width == 0.0) return;
    require_plain_planets(second.teeth, "two gears on each planet", "planets that carry alike");
    if (set_.has_bearing() && !tilt_is_computed())
      add(second.teeth, "two gears on each planet together with " + chosen(planets_.seats.tilt),
          "computed, by which the bearings hold the couple of both meshes, is required");
    const double apart = 0.5 * (set_.teeth.face_width + gearset::ring_face(set_.teeth));  // [m]
    if (std::abs(second.offset) >= apart - fits_within) return;
    const std::string required = key_(second.offset) + " of at least " + millimetres(apart) +
                                 " either way, half of both faces, is required";
    if (second.offset != 0.0)
      add(second.offset, "'" + written(second.offset) + "'", required);
    else
      add(second.teeth, "no " + key_(second.offset), required);
  }

  // Each planet of a pair is on bearings of its own pin.
  void find_bad_pairs() {
    const gearset::SecondPlanet& second = set_.second_planet;
    if (!second.present()) return;
    const auto refuse_where = [&](bool stated, const std::string& other, const std::string& required) {
      if (stated) add(second.teeth, "planets in pairs together with " + other, required + " is required");
    };
    refuse_where(!set_.has_bearing(), "no bearing", "a planet bearing, which each planet then has,");
    refuse_where(set_.teeth.stepped.present(), "gearset.stepped_planet", "one of both");
    require_plain_planets(second.teeth, "planets in pairs", "pairs that carry alike");
    refuse_where(tilt_is_computed(), chosen(planets_.seats.tilt), "stated");
    const auto refuse_list = [&](const std::vector<double>& list) {
      refuse_where(!list.empty(), key_(list), "a case without it");
    };
    refuse_list(set_.teeth.planet_angles);
    refuse_where(set_.geometry.centre_distance.has_value(), key_(set_.geometry.centre_distance),
                 "a case without it");
    refuse_list(set_.carrier.positions);
    refuse_where(set_.geometry.planet_shift.has_value(), key_(set_.geometry.planet_shift),
                 key_(second.first_shift) + " instead of it");
  }

  void find_bad_pin() {
    const PinSeats& seats = planets_.seats;
    if (seats.carrier_twist && seats.ends != bearing::PinEnds::both)
      add(seats.carrier_twist, written(seats.carrier_twist) + " together with " + chosen(seats.ends),
          "pins between two walls are required, of which one twists against the other");
    if (seats.span && *seats.span < planet_length())
      add(seats.span,
          written(seats.span) + " with a face of " +
              (set_.teeth.stepped.present() ? millimetres(planet_length()) : written(set_.teeth.face_width)),
          "at least the face is required: the supports lie outside it");
    const double& bore = planets_.bearing.inner.seat_diameter;
    if (seats.diameter && bore > 0.0 && *seats.diameter >= bore)
      add(seats.diameter, written(seats.diameter) + " with a " + key_(bore) + " of " + written(bore),
          "less than the bore is required: the sleeve of a flexpin lies between");
  }

  // Bearings lie side by side within the face, or the length of a stepped planet, which lies within the
  // supports of the pin.
  void find_bad_positions() {
    if (!tilt_is_computed() || set_.teeth.face_width == 0.0) return;
    find_bad_pin();
    const double face = planet_length(), width = planets_.bearing.width;
    if (width == 0.0) return;
    std::vector<double> sorted = planets_.seats.axial_positions;
    std::ranges::sort(sorted);
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      const bool within = std::abs(sorted[k]) + 0.5 * width <= 0.5 * face + fits_within;
      const bool apart = k == 0 || sorted[k] - sorted[k - 1] >= width - fits_within;
      if (within && apart) continue;
      return add(planets_.seats.axial_positions,
                 within ? "bearings that overlap" : "a bearing that reaches beyond the face",
                 "positions at least their width of " + millimetres(width) +
                     " apart and within the face of " + millimetres(face) + " are required");
    }
  }

  void find_surplus_deviations() {
    const std::vector<double>& deviations = set_.rollers().diameter_deviation;
    const int rollers = set_.rollers().count;
    if (rollers > 0 && deviations.size() > static_cast<std::size_t>(rollers))
      add(deviations, std::to_string(deviations.size()) + " values",
          "at most one for each of the " + std::to_string(rollers) + " rollers is required");
  }

  // Bearings of other types than cylindrical rollers.

  std::string with_type() const { return " together with " + chosen(set_.bearing_type); }

  template <class Member>
  void refuse_where(bool stated, const Member& member, const std::string& value) {
    if (stated)
      add(member, value + with_type(),
          "none is required, or " + key_(set_.bearing_type) + ": cylindrical-roller");
  }
  template <class Choice>
  void refuse_choice(const Choice& choice, Choice modelled) {
    refuse_where(choice != modelled, choice, std::string(text_of(choice)));
  }

  // Inputs that are modelled with cylindrical rollers alone.
  void find_refinements_of_cylindrical() {
    refuse_choice(set_.complement, Complement::caged);
    refuse_choice(planets_.mounting.state, bearing::ClearanceState::operating);
    refuse_choice(planets_.seats.tilt, TiltState::stated);
    refuse_choice(planets_.rim, PlanetRim::rigid);
    refuse_choice(set_.rating.viscosity_ratio_by, ViscosityRatioBy::speed);
    refuse_choice(planets_.mounting.rings, bearing::Rings::both);
    refuse_where(planets_.dynamics.race.film_in_approach, planets_.dynamics.race.film_in_approach, "true");
    for (const auto* tilt : {&planets_.misalignment.planet_tilt, &planets_.misalignment.carrier_wind_up})
      if (tilt->value_or(0.0) != 0.0) refuse_where(true, *tilt, written(*tilt));
    Lists lists = uneven_rollers();
    append(
        Lists{&set_.forms.inner.out_of_roundness.amplitudes, &set_.forms.outer.out_of_roundness.amplitudes},
        lists);
    for (const auto* list : lists) refuse_where(is_anywhere_nonzero(*list), *list, "a list");
    if (const std::string uneven = unequal_loads_by(set_); !uneven.empty())
      found_.push_back({uneven, "a list" + with_type() + "; none is required, or " + key_(set_.bearing_type) +
                                    ": cylindrical-roller"});
  }

  // The moment of helical teeth needs two bearings, or a pair, to hold it.
  void find_unheld_moment() {
    if (planets_.bearings_per_planet > 1 || set_.teeth.helix_angle == 0.0) return;
    add(planets_.bearings_per_planet,
        "one bearing of " + chosen(set_.bearing_type) + " together with " + key_(set_.teeth.helix_angle),
        "two bearings or more are required, which hold the moment of helical teeth");
  }

  void find_bad_tapered() {
    const bearing::PlanetRows& rows = planets_.rows;
    const double& clearance = planets_.bearing.radial_clearance;
    if (planets_.bearings_per_planet != 2)
      add(planets_.bearings_per_planet,
          std::to_string(planets_.bearings_per_planet) + " tapered roller bearings",
          "2 are required: a pair whose axial forces balance");
    if (rows.preload && rows.approach)
      add(rows.approach, "a value together with " + key_(rows.preload), "one of the two is required");
    for (const auto* mounted : {&rows.preload, &rows.approach})
      if (*mounted && clearance != 0.0)
        add(clearance, written(clearance) + " together with " + key_(*mounted),
            "0 um is required: mounting sets preload or play of a pair");
    const double width = planets_.bearing.width, face = set_.teeth.face_width;
    if (!rows.distance || width == 0.0 || face == 0.0) return;
    if (*rows.distance < width - fits_within || *rows.distance + width > face + fits_within)
      add(rows.distance, written(rows.distance),
          "a distance from the width of a bearing, " + millimetres(width) + ", to the face less that, " +
              millimetres(face - width) + ", is required");
  }

  void find_rollers_beside_balls() {
    const bearing::CylindricalRollers& rollers = set_.rollers();
    const bearing::PlanetRows& rows = planets_.rows;
    const auto refuse = [&](const auto& member) {
      if (member > 0)
        add(member, written(member) + with_type(),
            key_(rows.balls) + " and " + key_(rows.ball_diameter) + " are required instead");
    };
    refuse(rollers.count);
    refuse(rollers.diameter);
    refuse(rollers.length);
    append(bearing::ball_problems({.balls = rows.balls,
                                   .ball_diameter = rows.ball_diameter,
                                   .pitch_diameter = planets_.bearing.pitch_diameter}),
           found_);
  }

  // Rollers and balls do not share a bearing.
  void find_balls_beside_rollers() {
    const auto refuse = [&](const auto& member) {
      if (member > 0)
        add(member, written(member) + " in a bearing with rollers",
            "none is required, or " + key_(set_.bearing_type) + ": deep-groove-ball without rollers");
    };
    refuse(planets_.rows.balls);
    refuse(planets_.rows.ball_diameter);
  }

  void find_bad_type() {
    using enum bearing::PlanetBearingType;
    if (!set_.has_balls()) find_balls_beside_rollers();
    if (set_.bearing_type == cylindrical_roller) return;
    find_refinements_of_cylindrical();
    find_unheld_moment();
    if (set_.bearing_type == tapered_roller) find_bad_tapered();
    if (set_.has_balls()) find_rollers_beside_balls();
  }

  const StatedSet& set_;
  const PlanetaryDrivetrain& planets_;
  mechanics::MemberKeys<StatedSet> key_;
  Problems found_;
};

}  // namespace

Problems problems(const StatedSet& set) {
  return SetCheck(set).problems();
}

namespace {

// Beyond it the equations of the whole train lose the digits that distinguish contradictions from round-off.
constexpr double largest_stage_ratio = 1e6;  // [-]  up or down, of all stages
constexpr std::size_t most_stages = 20;

void find_bad_stage_teeth(const std::string& key, const gearset::StageTeeth& teeth, Problems& found) {
  constexpr int least = 5;  // as of a sun
  if (teeth[0] < least || teeth[1] < least)
    found.push_back({key, std::to_string(teeth[0]) + " and " + std::to_string(teeth[1]) +
                              " teeth; at least 5 of each gear, or [1, 1] for no stage, are required"});
}

}  // namespace

Problems problems(const gearset::ParallelStages& stages) {
  const mechanics::MemberKeys key(stages);
  Problems found;
  double ratio = 1.0;
  std::size_t count = 0;
  for (const auto* list : {&stages.front, &stages.behind}) {
    if (*list == std::vector<gearset::StageTeeth>{{1, 1}}) continue;  // none
    for (const gearset::StageTeeth& teeth : *list) {
      find_bad_stage_teeth(key(*list), teeth, found);
      ratio *= static_cast<double>(std::max(teeth[0], teeth[1])) / std::min(teeth[0], teeth[1]);
      ++count;
    }
    if (count <= most_stages && ratio <= largest_stage_ratio) continue;
    found.push_back({key(*list), std::to_string(count) + " parallel stages of " + significant(ratio, 3) +
                                     " in all; at most " + std::to_string(most_stages) +
                                     " stages, and ratios whose product (each as larger over smaller gear) "
                                     "is at most 1e6, are required"});
    break;
  }
  return found;
}

Problems speed_problems(const StatedDrivetrain& in, const std::string& torque) {
  using gearset::SpeedOf;
  constexpr double still = 1e-9;  // [-]  of the motor's speed: round-off of a zero speed
  const SpeedOf& member = in.drive.speed_of;
  if (member == SpeedOf::motor) return {};
  const std::string key = mechanics::MemberKeys(in.drive)(member), name(text_of(member));
  if (!in.is_single() && member != SpeedOf::load)
    return {{key, name + " of several sets; motor or load is required"}};
  if (member == SpeedOf::planet && !torque.empty())
    return {{key, "planet together with " + torque +
                      "; the speed of a shaft, whose torque it is, or input.power is required"}};
  if (std::abs(stated_speed_ratio(in)) < still)
    return {{key, name + ", which is stationary; a member that rotates is required"}};
  return {};
}

}  // namespace orbearing::analysis
