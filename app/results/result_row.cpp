#include "app/results/result_row.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "bearing/life/basic_life.hpp"

namespace orbearing::app {
namespace {

using study::PointResult;

constexpr double rpm_per_rad_s = 9.549296585513721;  // 30 / pi
constexpr double million_revolutions = 1e-6;
constexpr double micrometres = 1e6;
constexpr double microseconds = 1e6;
constexpr double megapascals = 1e-6;
constexpr double static_pressure = bearing::rating::static_pressure(bearing::rating::RollingElement::roller);

/// Messages of libraries may hold line ends or bytes that are not UTF-8; tables and JSON need neither.
std::string printable(const std::string& status) {
  if (status.empty()) return "failed without a reason";
  const nlohmann::json text = status;
  std::string clean =
      nlohmann::json::parse(text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
          .get<std::string>();
  std::replace_if(
      clean.begin(), clean.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return clean;
}

using PowerLoss = bearing::motion::PowerLoss;

Column loss_column(const std::string& cause, const std::string& meaning, double (*part)(const PowerLoss&)) {
  return {"power_loss" + cause + "_W",
          "power_loss" + cause,
          "W",
          "power lost " + meaning,
          1.0,
          [part](const PointResult& r) { return r.dynamic ? part(r.dynamic->loss) : not_given; }};
}

// What is lost to a part that is there in bearings with a cage alone, or without one alone.
Column loss_column(bool caged, const std::string& cause, const std::string& meaning,
                   double (*part)(const PowerLoss&)) {
  Column column = loss_column(cause, meaning, part);
  column.value = [caged, value = column.value](const PointResult& r) {
    return r.caged == caged ? value(r) : not_given;
  };
  return column;
}

std::vector<study::PlanetResult>::const_iterator shortest_lived(const PointResult& result) {
  return std::min_element(result.planets.begin(), result.planets.end(),
                          [](const auto& a, const auto& b) { return a.life_hours < b.life_hours; });
}

double shortest_life(const PointResult& result) {
  if (result.coupled)
    return *std::min_element(result.coupled->bearing_life_hours.begin(),
                             result.coupled->bearing_life_hours.end());
  if (!result.seats.empty()) {
    const auto shorter = [](const auto& a, const auto& b) { return a.life_hours < b.life_hours; };
    return std::min_element(result.seats.begin(), result.seats.end(), shorter)->life_hours;
  }
  return result.planets.empty() ? not_given : shortest_lived(result)->life_hours;
}

using gearset::dynamics::AffineBearing;
using study::OneWayRecord;

using bearing::rating::RatedHours;
using bearing::rating::RatingLives;

// Of one bearing, by the standards.
Column rating_column(const std::string& name, const std::string& variable, const std::string& units,
                     const std::string& meaning, double per_unit, double (*part)(const RatingLives&)) {
  return {name, variable, units, meaning, per_unit,
          [part](const PointResult& r) { return part(r.rating.lives); }};
}

Column force_column(const std::string& symbol, const std::string& meaning, double RatingLives::*member) {
  return {symbol + "_N", symbol, "N", meaning, 1.0,
          [member](const PointResult& r) { return r.rating.lives.*member; }};
}

// A life in hours of one bearing.
Column hours_column(const std::string& name, const std::string& meaning, double RatedHours::*life) {
  return {name, name, "h", meaning, 1.0, [life](const PointResult& r) { return r.rating.hours.*life; }};
}

Column system_column(const std::string& name, const std::string& life_name, double RatedHours::*life) {
  return {name, name, "h", life_name + " of all planet bearings together", 1.0,
          [life](const PointResult& r) { return r.rating.system_hours.*life; }};
}

Column revolutions_column(const std::string& name, const std::string& meaning,
                          double (*part)(const RatingLives&)) {
  return rating_column(name + "_Mrev", name, "revolution", meaning, million_revolutions, part);
}

std::vector<Column> rating_columns() {
  return {
      {"life_Mrev", "life_revolutions", "revolution", "fatigue life of one bearing, in revolutions",
       million_revolutions, [](const PointResult& r) { return r.life; }},
      hours_column("L10h", "basic rating life of ISO 281", &RatedHours::basic),
      hours_column("L10rh", "basic reference rating life of ISO/TS 16281", &RatedHours::reference),
      hours_column("L10mh", "modified rating life of ISO 281: a_1 a_ISO L10h", &RatedHours::modified),
      hours_column("L10mrh", "modified reference rating life of ISO/TS 16281, a_ISO lamina by lamina",
                   &RatedHours::modified_reference),
      system_column("system_L10h", "L10h", &RatedHours::basic),
      system_column("system_L10rh", "L10rh", &RatedHours::reference),
      system_column("system_L10mh", "L10mh", &RatedHours::modified),
      system_column("system_L10mrh", "L10mrh", &RatedHours::modified_reference),
      revolutions_column("L10", "basic rating life of ISO 281",
                         [](const RatingLives& l) { return l.basic; }),
      revolutions_column("L10r", "basic reference rating life of ISO/TS 16281",
                         [](const RatingLives& l) { return l.reference.bearing; }),
      revolutions_column("L10m", "modified rating life of ISO 281",
                         [](const RatingLives& l) { return l.modified; }),
      revolutions_column("L10mr", "modified reference rating life of ISO/TS 16281",
                         [](const RatingLives& l) { return l.modified_reference.bearing; }),
      revolutions_column("inner_L10m", "modified reference rating life of ISO/TS 16281 of the inner race",
                         [](const RatingLives& l) { return l.modified_reference.inner; }),
      revolutions_column("outer_L10m", "modified reference rating life of ISO/TS 16281 of the outer race",
                         [](const RatingLives& l) { return l.modified_reference.outer; }),
      force_column("C", "basic dynamic load rating", &RatingLives::dynamic_capacity),
      force_column("C0", "basic static load rating", &RatingLives::static_capacity),
      force_column("Cu", "fatigue load limit", &RatingLives::fatigue_load_limit),
      force_column("P", "dynamic equivalent load of one bearing", &RatingLives::dynamic_load),
      force_column("P0", "static equivalent load of the most loaded bearing", &RatingLives::static_load),
      rating_column("C_over_P", "C_over_P", "1", "basic dynamic load rating over equivalent load", 1.0,
                    [](const RatingLives& l) { return l.load_ratio(); }),
      rating_column("S0", "S0", "1", "basic static load rating over static equivalent load", 1.0,
                    [](const RatingLives& l) { return l.static_safety(); }),
      rating_column("kappa", "kappa", "1", "viscosity ratio of ISO 281", 1.0,
                    [](const RatingLives& l) { return l.oil ? l.oil->viscosity_ratio : not_given; }),
      rating_column("e_C", "e_C", "1", "contamination factor of ISO 281", 1.0,
                    [](const RatingLives& l) { return l.oil ? l.oil->contamination_factor : not_given; }),
      rating_column("a_ISO", "a_ISO", "1", "life modification factor of ISO 281, from C_u/P", 1.0,
                    [](const RatingLives& l) { return l.life_modification; }),
      rating_column("a_ISO_r", "a_ISO_r", "1",
                    "L10mrh over L10rh at a reliability of 90 %: life modification factor lamina by lamina", 1.0,
                    [](const RatingLives& l) { return l.reference_modification; })};
}

// What stood for the bearings in gears that drive one of them.
Column fit_column(const std::string& name, const std::string& units, const std::string& meaning,
                  double (*part)(const OneWayRecord&)) {
  return {"one_way_" + name, "one_way_" + name, units, meaning, 1.0, [part](const PointResult& r) {
            return r.dynamic && r.dynamic->one_way ? part(*r.dynamic->one_way) : not_given;
          }};
}

// Of the law: force - stiffness x displacement - damping x velocity of a planet on all its bearings.
Column law_column(const std::string& name, const std::string& units, double (*part)(const AffineBearing&)) {
  const std::string variable = "one_way_" + name.substr(0, name.find("_N"));
  return {"one_way_" + name,
          variable,
          units,
          "fitted law of all bearings of a planet: " + variable,
          1.0,
          [part](const PointResult& r) {
            return r.dynamic && r.dynamic->one_way ? part(r.dynamic->one_way->fitted.bearing) : not_given;
          }};
}

}  // namespace

const std::vector<Column>& leading_columns() {
  static const std::vector<Column> columns = {
      {"input_speed_rpm", "input_speed", "rad s-1", "speed of the driving member", rpm_per_rad_s,
       [](const PointResult& r) { return r.input_speed; }},
      {"carrier_speed_rpm", "carrier_speed", "rad s-1", "speed of the planet carrier", rpm_per_rad_s,
       [](const PointResult& r) { return r.carrier_speed; }},
      {"planet_load_N", "planet_load", "N", "total load on the bore of one bearing, with cage and rollers",
       1.0, [](const PointResult& r) { return r.planet_load; }},
      {"tangential_load_N", "tangential_load", "N", "load of both meshes in the direction of rotation", 1.0,
       [](const PointResult& r) { return r.tangential_load; }},
      {"centrifugal_load_N", "centrifugal_load", "N", "outward inertial load of planet, cage and rollers",
       1.0, [](const PointResult& r) { return r.centrifugal_load; }},
      {"inner_load_max_N", "inner_load_max", "N", "largest load of one roller on the inner race", 1.0,
       [](const PointResult& r) { return r.inner.load_max; }},
      {"inner_load_rms_N", "inner_load_rms", "N",
       "root mean square over time of one roller's load, inner race", 1.0,
       [](const PointResult& r) { return r.inner.load_rms; }},
      {"outer_load_max_N", "outer_load_max", "N", "largest load of one roller on the outer race", 1.0,
       [](const PointResult& r) { return r.outer.load_max; }},
      {"outer_load_rms_N", "outer_load_rms", "N",
       "root mean square over time of one roller's load, outer race", 1.0,
       [](const PointResult& r) { return r.outer.load_rms; }},
      {"inner_life_Mrev", "inner_life", "revolution", "fatigue life of the inner race", million_revolutions,
       [](const PointResult& r) { return r.inner.life; }},
      {"outer_life_Mrev", "outer_life", "revolution", "fatigue life of the outer race", million_revolutions,
       [](const PointResult& r) { return r.outer.life; }},
      {"life_h", "life", "h", "fatigue life of one bearing", 1.0,
       [](const PointResult& r) { return r.life_hours; }},
      {"system_life_h", "system_life", "h", "fatigue life of all planet bearings of the set together", 1.0,
       [](const PointResult& r) { return r.system_life_hours; }},
      {"cage_slip", "cage_slip", "1", "one less the cage's speed over its kinematic speed", 1.0,
       [](const PointResult& r) { return r.caged ? r.cage_slip : not_given; }},
      {"film_inner_um", "film_inner", "m", "least film on the inner race", micrometres,
       [](const PointResult& r) { return r.inner.least_film; }},
      {"film_outer_um", "film_outer", "m", "least film on the outer race", micrometres,
       [](const PointResult& r) { return r.outer.least_film; }}};
  return columns;
}

namespace {

// The lives by the standards come after `before`.
std::vector<Column> with_ratings(std::string_view before, std::vector<Column> columns) {
  const std::vector<Column> ratings = rating_columns();
  const auto place = std::find_if(columns.begin(), columns.end(),
                                  [&](const Column& column) { return column.name == before; });
  columns.insert(place + 1, ratings.begin(), ratings.end());
  return columns;
}

}  // namespace

const std::vector<Column>& trailing_columns() {
  static const std::vector<Column> columns = with_ratings("rim_ovality_um", {
      {"radial_mesh_load_N", "radial_mesh_load", "N", "outward load of both meshes", 1.0,
       [](const PointResult& r) { return r.radial_mesh_load; }},
      {"axial_mesh_force_N", "axial_mesh_force", "N",
       "axial force of the sun's helical teeth on one planet; that of the ring's is opposite", 1.0,
       [](const PointResult& r) { return r.axial_mesh_force; }},
      {"overturning_moment_N_m", "overturning_moment", "N m",
       "moment of both axial forces on one planet about the tangential axis", 1.0,
       [](const PointResult& r) { return r.overturning_moment; }},
      {"sun_thrust_N", "sun_thrust", "N",
       "axial force of all planets on the sun; that on the ring is opposite", 1.0,
       [](const PointResult& r) { return r.sun_thrust; }},
      {"contact_pressure_max_MPa", "contact_pressure_max", "Pa",
       "largest pressure of roller and race, after Hertz", megapascals,
       [](const PointResult& r) { return r.contact_pressure; }},
      {"operating_clearance_um", "operating_clearance", "m",
       "radial clearance of the running bearing, in diametral measure", micrometres,
       [](const PointResult& r) { return r.radial_clearance; }},
      {"rim_ovality_um", "rim_ovality", "m",
       "largest less least outward displacement of the outer race by bending of the planet's rim",
       micrometres,
       [](const PointResult& r) {
         const std::vector<double>& form = r.distribution.race_form;
         if (form.empty()) return 0.0;
         const auto [least, most] = std::minmax_element(form.begin(), form.end());
         return *most - *least;
       }},
      {"static_safety", "static_safety", "1",
       "S_0 of ISO 76: static capacity over load, by the largest pressure and 4000 MPa", 1.0,
       [](const PointResult& r) {
         return std::pow(static_pressure / r.contact_pressure, 2);
       }},
      {"roller_slip", "roller_slip", "1", "one less the mean roller spin over that at pure rolling", 1.0,
       [](const PointResult& r) { return r.dynamic ? r.dynamic->roller_slip : not_given; }},
      {"orbit_slip", "orbit_slip", "1",
       "one less the mean orbital speed of the rollers over that at pure rolling, without a cage", 1.0,
       [](const PointResult& r) {
         return r.dynamic ? r.dynamic->orbit_slip.value_or(not_given) : not_given;
       }},
      {"friction_moment_N_m", "friction_moment", "N m", "friction moment of the bearing on the bore", 1.0,
       [](const PointResult& r) { return r.dynamic ? r.dynamic->friction_moment : not_given; }},
      loss_column("", "in all", [](const PowerLoss& loss) { return loss.total(); }),
      loss_column("_race_damping", "to damping of the race contacts",
                  [](const PowerLoss& l) { return l.race_damping; }),
      loss_column("_inner_traction", "to sliding on the inner race",
                  [](const PowerLoss& l) { return l.inner_traction; }),
      loss_column("_outer_traction", "to sliding on the outer race",
                  [](const PowerLoss& l) { return l.outer_traction; }),
      loss_column("_rolling", "to rolling resistance", [](const PowerLoss& l) { return l.rolling; }),
      loss_column("_drag", "to the oil-air mixture", [](const PowerLoss& l) { return l.drag; }),
      loss_column(true, "_pockets", "in the cage pockets", [](const PowerLoss& l) { return l.pockets; }),
      loss_column(true, "_guidance", "in the cage guidance", [](const PowerLoss& l) { return l.guidance; }),
      loss_column(false, "_neighbours", "between rollers that touch one another, without a cage",
                  [](const PowerLoss& l) { return l.neighbours; }),
      loss_column("_support", "in the support of the pin", [](const PowerLoss& l) { return l.support; }),
      {"steady", "steady", "1", "1: the means stood still; 0: they drifted to the end", 1.0,
       [](const PointResult& r) { return r.dynamic ? (r.dynamic->steady ? 1.0 : 0.0) : not_given; }},
      {"shortest_life_h", "shortest_life", "h",
       "life of the bearing that lives shortest, where planets load unevenly, their tilt is computed or "
       "bearings act "
       "back on the gears",
       1.0, shortest_life},
      {"shortest_life_planet", "shortest_life_planet", "1",
       "planet whose bearings live shortest, counted from 1, where life_h is that of unlike planets together",
       1.0,
       [](const PointResult& r) {
         return r.planets.empty() ? not_given
                                  : static_cast<double>(shortest_lived(r) - r.planets.begin() + 1);
       }},
      {"largest_load_share", "largest_load_share", "1",
       "mean tangential load of the planet that carries most, over the mean of all planets", 1.0,
       [](const PointResult& r) {
         double most = not_given;
         for (const study::PlanetResult& planet : r.planets) most = std::fmax(most, planet.load_share);
         return most;
       }},
      {"largest_bearing_tilt_mrad", "largest_bearing_tilt", "rad",
       "largest tilt of a bore against its pin, where the tilt of planets is computed", 1e3,
       [](const PointResult& r) {
         double most = not_given;
         for (const study::SeatResult& seat : r.seats) most = std::fmax(most, seat.tilt.norm());
         return most;
       }},
      {"largest_bearing_share", "largest_bearing_share", "1",
       "load of the bearing of a planet that carries most, over the mean of its bearings, likewise", 1.0,
       [](const PointResult& r) {
         double most = not_given, sum = 0.0;
         for (const study::SeatResult& seat : r.seats) {
           most = std::fmax(most, seat.load);
           sum += seat.load;
         }
         return most * static_cast<double>(r.seats.size()) / sum;
       }},
      {"interface_energy_residual", "interface_energy_residual", "1",
       "energy that the exchange of gears and bearings made or lost, over that which passed", 1.0,
       [](const PointResult& r) { return r.coupled ? r.coupled->energy_residual : not_given; }},
      {"interface_window_us", "interface_window", "s", "mean time between two exchanges; 0: one system",
       microseconds, [](const PointResult& r) { return r.coupled ? r.coupled->window : not_given; }},
      fit_column("runs", "1", "runs of gears and bearing until the law between them was found",
                 [](const OneWayRecord& fit) { return double(fit.runs); }),
      fit_column(
          "accepted", "1",
          "1: the last run agrees with the law that drove it, and the gears with its mean load; 0: not",
          [](const OneWayRecord& fit) { return fit.accepted ? 1.0 : 0.0; }),
      fit_column("residual", "1", "share of the bearing force at mesh harmonics that the law leaves",
                 [](const OneWayRecord& fit) { return fit.fitted.residual; }),
      fit_column("stiffness_change", "1", "change of the stiffness in the last run",
                 [](const OneWayRecord& fit) { return fit.fitted.stiffness_change; }),
      fit_column("damping_change", "1", "change of the damping in the last run",
                 [](const OneWayRecord& fit) { return fit.fitted.damping_change; }),
      fit_column(
          "load_difference", "1",
          "of the gears' mean force on the planet's bearings from the load under which the bearing ran",
          [](const OneWayRecord& fit) { return fit.load_difference; }),
      law_column("stiffness_xx_N_per_m", "N m-1", [](const AffineBearing& b) { return b.stiffness(0, 0); }),
      law_column("stiffness_xy_N_per_m", "N m-1", [](const AffineBearing& b) { return b.stiffness(0, 1); }),
      law_column("stiffness_yx_N_per_m", "N m-1", [](const AffineBearing& b) { return b.stiffness(1, 0); }),
      law_column("stiffness_yy_N_per_m", "N m-1", [](const AffineBearing& b) { return b.stiffness(1, 1); }),
      law_column("damping_xx_N_s_per_m", "N s m-1", [](const AffineBearing& b) { return b.damping(0, 0); }),
      law_column("damping_xy_N_s_per_m", "N s m-1", [](const AffineBearing& b) { return b.damping(0, 1); }),
      law_column("damping_yx_N_s_per_m", "N s m-1", [](const AffineBearing& b) { return b.damping(1, 0); }),
      law_column("damping_yy_N_s_per_m", "N s m-1", [](const AffineBearing& b) { return b.damping(1, 1); }),
      law_column("force_x_N", "N", [](const AffineBearing& b) { return b.force.x(); }),
      law_column("force_y_N", "N", [](const AffineBearing& b) { return b.force.y(); })});
  return columns;
}

const std::vector<SetColumn>& set_columns() {
  using study::SetResult;
  static const std::vector<SetColumn> columns = {
      {"carrier_speed_rpm", "carrier_speed", "rad s-1", "speed of the planet carrier", rpm_per_rad_s,
       [](const SetResult& r) { return r.carrier_speed; }},
      {"planet_load_N", "planet_load", "N", "total load on the bore of one bearing", 1.0,
       [](const SetResult& r) { return r.planet_load; }},
      {"inner_load_max_N", "inner_load_max", "N", "largest load of one roller on the inner race", 1.0,
       [](const SetResult& r) { return r.inner.load_max; }},
      {"outer_load_max_N", "outer_load_max", "N", "largest load of one roller on the outer race", 1.0,
       [](const SetResult& r) { return r.outer.load_max; }},
      {"life_h", "life", "h", "fatigue life of one bearing", 1.0,
       [](const SetResult& r) { return r.life_hours; }},
      {"L10h", "L10h", "h", "basic rating life of ISO 281", 1.0,
       [](const SetResult& r) { return r.rating.hours.basic; }},
      {"L10rh", "L10rh", "h", "basic reference rating life of ISO/TS 16281", 1.0,
       [](const SetResult& r) { return r.rating.hours.reference; }},
      {"L10mh", "L10mh", "h", "modified rating life of ISO 281", 1.0,
       [](const SetResult& r) { return r.rating.hours.modified; }},
      {"L10mrh", "L10mrh", "h", "modified reference rating life of ISO/TS 16281", 1.0,
       [](const SetResult& r) { return r.rating.hours.modified_reference; }}};
  return columns;
}

namespace {

// Text first, then the numbers.
constexpr std::array resonance_columns = {"resonance_kind", "resonance_mode", "resonance_frequency_Hz",
                                          "resonance_harmonic", "resonance_speed_rpm"};

void add_set_columns(const std::vector<std::string>& sets, TableHead& head) {
  head.set_place = head.names.size();
  head.names.emplace_back(limiting_set_column);
  for (const std::string& set : sets)
    for (const SetColumn& column : set_columns()) head.names.push_back("sets." + set + "." + column.name);
}

}  // namespace

TableHead table_head(const std::vector<SweptAxis>& axes, const std::vector<std::string>& sets,
                     bool resonances) {
  TableHead head;
  for (const Column& column : leading_columns()) head.names.push_back(column.name);
  head.status_place = head.names.size();
  head.names.emplace_back(status_column);
  for (const Column& column : trailing_columns()) head.names.push_back(column.name);
  head.refined_place = head.names.size();
  head.names.emplace_back(refined_column);
  head.first_axis = head.names.size();
  head.axes = axes.size();
  for (const SweptAxis& axis : axes) head.names.push_back(axis.column);
  if (!sets.empty()) add_set_columns(sets, head);
  if (!resonances) return head;
  head.first_resonance = head.names.size();
  head.names.insert(head.names.end(), resonance_columns.begin(), resonance_columns.end());
  return head;
}

double in_table_unit(double value, double per_unit) {
  if (!std::isfinite(value)) return not_given;
  if (per_unit == 1.0) return value;
  constexpr int digits_after_first = 14;
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value * per_unit, std::chars_format::scientific,
                                 digits_after_first)
                       .ptr;
  double rounded = not_given;
  std::from_chars(text, end, rounded);
  return std::isfinite(rounded) ? rounded : not_given;
}

double speed_in_rpm(double speed) {
  return in_table_unit(speed, rpm_per_rad_s);
}

namespace {

// A failed point has results of no set.
void add_sets(const PointResult& result, std::size_t sets, ResultRow& row) {
  if (sets == 0) return;
  row.values.push_back(not_given);
  if (row.ok()) row.limiting_set = result.limiting_set;
  for (std::size_t set = 0; set < sets; ++set)
    for (const SetColumn& column : set_columns()) {
      const bool known = row.ok() && set < result.sets.size();
      row.values.push_back(known ? in_table_unit(column.value(result.sets[set]), column.per_unit)
                                 : not_given);
    }
}

}  // namespace

ResultRow result_row(const PointResult& result, const std::vector<double>& axis_values,
                     const std::vector<std::string>& sets) {
  ResultRow row;
  row.status = printable(result.status);
  const auto add = [&](const Column& column) {
    const bool known = row.ok() || column.variable == "input_speed";
    row.values.push_back(known ? in_table_unit(column.value(result), column.per_unit) : not_given);
  };
  for (const Column& column : leading_columns()) add(column);
  row.values.push_back(not_given);
  for (const Column& column : trailing_columns()) add(column);
  row.values.push_back(not_given);  // refined
  for (const double value : axis_values) row.values.push_back(in_table_unit(value, 1.0));
  add_sets(result, sets.size(), row);
  return row;
}

void add_resonance(const std::optional<Resonance>& resonance, ResultRow& row) {
  row.values.insert(row.values.end(), resonance_columns.size(), not_given);
  if (!resonance) return;
  row.resonance_kind = resonance->kind;
  row.resonance_mode = resonance->mode;
  double* const numbers = row.values.data() + row.values.size() - 3;
  numbers[0] = in_table_unit(resonance->frequency, 1.0);
  numbers[1] = resonance->harmonic;
  numbers[2] = speed_in_rpm(resonance->speed);
}

bool on_one_line(const TableHead& head, const ResultRow& one, const ResultRow& other) {
  const auto first = static_cast<std::ptrdiff_t>(head.first_axis);
  const auto axes = static_cast<std::ptrdiff_t>(head.axes);
  return std::equal(one.values.begin() + first, one.values.begin() + first + axes,
                    other.values.begin() + first);
}

double value_of(const TableHead& head, const ResultRow& row, const std::string& name) {
  const auto place = std::find(head.names.begin(), head.names.end(), name);
  return place == head.names.end() ? not_given
                                   : row.values[static_cast<std::size_t>(place - head.names.begin())];
}

double life_to_go_by(const TableHead& head, const ResultRow& row) {
  return value_of(head, row, head.life);
}

}  // namespace orbearing::app
