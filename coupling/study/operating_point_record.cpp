// Description of an operating point: a row of a table, and arrays that are for files only.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "bearing/life/basic_life.hpp"
#include "bearing/life/rating_record.hpp"
#include "coupling/study/operating_point.hpp"
#include "coupling/study/worst_bearing.hpp"
#include "mechanics/record.hpp"

namespace orbearing::study {

namespace {

using described::kAbsent;
using described::Record;
namespace dimension = described::dimension;

constexpr described::Dimension kMicroseconds{"time", "s", "us", "", 1e-6};

constexpr const char* kRimMeaning = "rim of a planet between roots and bore, in normal modules";

struct NamedRace {
  std::string name;
  const RaceResult* result;
};

template <class Result>
std::array<NamedRace, 2> races_of(const Result& result) {
  return {{{"inner", &result.inner}, {"outer", &result.outer}}};
}

void describe_loads_and_lives(Record& record, const PointResult& point) {
  record.value("input_speed_rpm", dimension::angular_speed,
               "input.speed: speed of the driving member, or of that which input.speed_of names",
               point.input_speed);
  record.value("carrier_speed_rpm", dimension::angular_speed, "speed of the planet carrier",
               point.carrier_speed);
  record.value("planet_load_N", dimension::force,
               "total load on the bore of one bearing, with cage and rollers", point.planet_load);
  record.value("tangential_load_N", dimension::force, "load of both meshes in the direction of rotation",
               point.tangential_load);
  record.value("centrifugal_load_N", dimension::force, "outward inertial load of planet, cage and rollers",
               point.centrifugal_load);
  for (const auto& [race, of] : races_of(point)) {
    record.value(race + "_load_max_N", dimension::force,
                 "largest load of one roller on the " + race + " race", of->load_max);
    record.value(race + "_load_rms_N", dimension::force,
                 "root mean square over time of one roller's load, " + race + " race", of->load_rms);
  }
  for (const auto& [race, of] : races_of(point))
    record.value(race + "_life_Mrev", dimension::revolutions, "fatigue life of the " + race + " race",
                 of->life);
  record.value("life_h", dimension::hours, "fatigue life of one bearing", point.life_hours);
  record.value("system_life_h", dimension::hours, "fatigue life of all planet bearings of the set together",
               point.system_life_hours);
  record.value("cage_slip", dimension::ratio, "1 minus cage speed divided by its kinematic speed",
               point.caged ? point.cage_slip : kAbsent);
  for (const auto& [race, of] : races_of(point))
    record.value("film_" + race + "_um", dimension::small_length, "least film on the " + race + " race",
                 of->least_film);
  record.value("status", "ok, or why the point failed", point.status);
}

double ovality(const std::vector<double>& race_form) {
  if (race_form.empty()) return 0.0;
  const auto [least, most] = std::ranges::minmax(race_form);
  return most - least;
}

void describe_gears_and_fits(Record& record, const PointResult& point) {
  record.value("radial_mesh_load_N", dimension::force, "outward load of both meshes", point.radial_mesh_load);
  record.value("axial_mesh_force_N", dimension::force,
               "axial force of the sun's helical teeth on one planet; that of the ring's is opposite",
               point.axial_mesh_force);
  record.value("overturning_moment_N_m", dimension::torque,
               "moment of both axial forces on one planet about the tangential axis",
               point.overturning_moment);
  record.value("sun_thrust_N", dimension::force,
               "axial force of all planets on the sun; that on the ring is opposite", point.sun_thrust);
  record.value("contact_pressure_max_MPa", dimension::pressure,
               "largest pressure of roller and race, after Hertz", point.contact_pressure);
  record.value("operating_clearance_um", dimension::small_length,
               "radial clearance of the running bearing, in diametral measure", point.radial_clearance);
  record.value("rim_over_module", dimension::ratio, kRimMeaning, point.rim_over_module);
  record.value("rim_ovality_um", dimension::small_length,
               "largest less least outward displacement of the outer race by bending of the planet's rim",
               ovality(point.distribution.race_form));
}

// Ratings of one bearing by the standards.
void describe_ratings(Record& record, const PointResult& point) {
  const bearing::rating::RatingLives& lives = point.rating.lives;
  record.value("life_Mrev", dimension::revolutions, "fatigue life of one bearing, in revolutions", point.life)
      .variable = "life_revolutions";
  describe(record, point.rating.hours);
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    record.value(std::string("system_") + life.name, dimension::hours,
                 std::string(life.name) + " of all planet bearings together",
                 point.rating.system_hours.*life.hours);
  const auto revolutions = [&](const char* name, const char* meaning, double value) {
    record.value(name, dimension::revolutions, meaning, value);
  };
  revolutions("L10_Mrev", "basic rating life of ISO 281", lives.basic);
  revolutions("L10r_Mrev", "basic reference rating life of ISO/TS 16281", lives.reference.bearing);
  revolutions("L10m_Mrev", "modified rating life of ISO 281", lives.modified);
  revolutions("L10mr_Mrev", "modified reference rating life of ISO/TS 16281",
              lives.modified_reference.bearing);
  revolutions("inner_L10m_Mrev", "modified reference rating life of ISO/TS 16281 of the inner race",
              lives.modified_reference.inner);
  revolutions("outer_L10m_Mrev", "modified reference rating life of ISO/TS 16281 of the outer race",
              lives.modified_reference.outer);
  describe_loads(record, lives);
  describe_factors(record, lives);
  const double allowed = bearing::rating::static_pressure(point.element);
  const bool rollers = point.element == bearing::rating::RollingElement::roller;
  record.value(
      "static_safety", dimension::ratio,
      "S_0 of ISO 76: static capacity over load, by the largest pressure and 4000 MPa, of balls 4200 MPa",
      std::pow(allowed / point.contact_pressure, rollers ? 2 : 3));
}

void describe_losses(Record& record, const PointResult& point) {
  const bool moves = point.dynamic.has_value();
  const bearing::motion::PowerLoss loss = moves ? point.dynamic->loss : bearing::motion::PowerLoss{};
  const auto add = [&](const std::string& cause, const std::string& meaning, double value,
                       bool there = true) {
    record.value("power_loss" + cause + "_W", dimension::heat, "power lost " + meaning,
                 moves && there ? value : kAbsent);
  };
  add("", "in all", loss.total());
  add("_race_damping", "to damping of the race contacts", loss.race_damping);
  add("_inner_traction", "to sliding on the inner race", loss.inner_traction);
  add("_outer_traction", "to sliding on the outer race", loss.outer_traction);
  add("_rolling", "to rolling resistance", loss.rolling);
  add("_drag", "to the oil-air mixture", loss.drag);
  add("_pockets", "in the cage pockets", loss.pockets, point.caged);
  add("_guidance", "in the cage guidance", loss.guidance, point.caged);
  add("_neighbours", "between rollers that touch one another, without a cage", loss.neighbours, !point.caged);
  add("_support", "in the support of the pin", loss.support);
}

// Absent from the quasi-static model.
void describe_motion(Record& record, const PointResult& point) {
  const auto moving = [&](const auto& part) { return point.dynamic ? part(*point.dynamic) : kAbsent; };
  record.value("roller_slip", dimension::ratio, "1 minus mean roller spin divided by that at pure rolling",
               moving([](const DynamicRecord& d) { return d.roller_slip; }));
  record.value("orbit_slip", dimension::ratio,
               "1 minus mean orbital speed of the rollers divided by that at pure rolling, without a cage",
               moving([](const DynamicRecord& d) { return d.orbit_slip.value_or(kAbsent); }));
  record.value(
      "drag_over_traction", dimension::ratio,
      "drag of the oil on rollers and cage at pure rolling over the largest traction of the loaded rollers; "
      "above 1 the bearing is lightly loaded",
      moving([](const DynamicRecord& d) { return d.drag_over_traction.value_or(kAbsent); }));
  record.value(
      "drag_slip", dimension::ratio,
      "cage_slip that the loads at rest give by traction, rolling resistance, drag and guidance of the cage; "
      "within 0.03 of cage_slip where rollers do not bounce",
      moving([](const DynamicRecord& d) { return d.drag_slip.value_or(kAbsent); }));
  record.value(
      "friction_moment_N_m", dimension::torque,
      "mean friction moment of the bearing on the bore. Times the planet's speed relative to the carrier, "
      "plus vibration_power_W, it is power_loss_W within 3 %",
      moving([](const DynamicRecord& d) { return d.friction_moment; }));
  record.value(
      "vibration_power_W", dimension::heat,
      "power that vibration of the planet brings into the bearing, beyond mean friction moment times "
      "mean speed",
      moving([](const DynamicRecord& d) { return d.vibration_power; }));
  describe_losses(record, point);
  record.value("steady", dimension::ratio, "1: the means were steady; 0: they drifted to the end",
               moving([](const DynamicRecord& d) { return d.steady ? 1.0 : 0.0; }));
}

template <class Items, class Value>
double largest_of(const Items& items, const Value& value) {
  double most = kAbsent;
  for (const auto& item : items) most = std::fmax(most, value(item));
  return most;
}

// Largest share of a bearing in the load of its planet; over all planets if they are unlike.
double largest_bearing_share(const PointResult& point) {
  const std::size_t planets = std::max<std::size_t>(point.planets.size(), 1);
  const std::size_t bearings = point.seats.size() / planets;
  double most = kAbsent;
  for (std::size_t planet = 0; planet < planets && bearings > 0; ++planet) {
    const std::span<const SeatResult> seats(&point.seats[planet * bearings], bearings);
    double sum = 0.0;
    for (const SeatResult& seat : seats) sum += seat.load;
    most = std::fmax(most, largest_of(seats, [](const SeatResult& seat) { return seat.load; }) *
                               static_cast<double>(bearings) / sum);
  }
  return most;
}

void describe(Record& record, const UnlikeBearings& unlike) {
  record.value("shortest_life_h", dimension::hours,
               "shortest life of a bearing, where planets load unevenly, their tilt is computed or bearings "
               "act on the gears",
               unlike.shortest_hours);
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    record.value(std::string("shortest_") + life.name, dimension::hours,
                 std::string(life.name) +
                     ", shortest of all bearings, where planets load unevenly or their tilt is computed",
                 unlike.shortest_rated.*life.hours);
  record.value("shortest_life_planet", dimension::ratio,
               "planet with the shortest bearing life, counted from 1, where life_h is that of unlike "
               "planets together",
               unlike.planet);
  record.value("largest_load_share", dimension::ratio,
               "mean tangential load of the most loaded planet, divided by the mean of all planets",
               unlike.load_share);
}

// Results for planets or bearings that are unlike.
void describe_sharing(Record& record, const PointResult& point) {
  describe(record, unlike_bearings(point));
  record.value("largest_bearing_tilt_mrad", dimension::small_angle,
               "largest tilt of a bore against its pin, where the tilt of planets is computed",
               largest_of(point.seats, [](const SeatResult& seat) { return seat.tilt.norm(); }));
  record.value("largest_bearing_share", dimension::ratio,
               "load of the most loaded bearing of a planet, divided by the mean of its bearings, likewise",
               largest_bearing_share(point));
  record.value("interface_energy_residual", dimension::ratio,
               "energy error of the exchange of gears and bearings, divided by the exchanged energy",
               point.coupled ? point.coupled->energy_residual : kAbsent);
  record.value("interface_window_us", kMicroseconds, "mean time between two exchanges; 0: one system",
               point.coupled ? point.coupled->window : kAbsent);
}

// force - stiffness x displacement - damping x velocity of a planet on all its bearings.
void describe_law(Record& record, const gearset::dynamics::AffineBearing& law) {
  const auto add = [&](const std::string& name, const char* unit, const described::Dimension& of,
                       double value) {
    record.value("one_way_" + name + unit, of, "fitted model of all bearings of a planet: one_way_" + name,
                 value);
  };
  const std::array<std::string, 2> axes{"x", "y"};
  const auto add_matrix = [&](const std::string& name, const char* unit, const described::Dimension& of,
                              const Eigen::Matrix2d& matrix) {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        add(name + "_" + axes[static_cast<std::size_t>(i)] + axes[static_cast<std::size_t>(j)], unit, of,
            matrix(i, j));
  };
  add_matrix("stiffness", "_N_per_m", dimension::stiffness, law.stiffness);
  add_matrix("damping", "_N_s_per_m", dimension::damping, law.damping);
  add("force_x", "_N", dimension::force, law.force.x());
  add("force_y", "_N", dimension::force, law.force.y());
}

// The law that replaced the bearings in gears that drive one of them.
void describe_one_way(Record& record, const PointResult& point) {
  OneWayRecord fit;
  const bool there = point.dynamic && point.dynamic->one_way;
  if (there) {
    fit = *point.dynamic->one_way;
  } else {
    fit.fitted.bearing.stiffness.setConstant(kAbsent);
    fit.fitted.bearing.damping.setConstant(kAbsent);
    fit.fitted.bearing.force.setConstant(kAbsent);
  }
  const auto add = [&](const char* name, const char* meaning, double value) {
    record.value(std::string("one_way_") + name, dimension::ratio, meaning, there ? value : kAbsent);
  };
  add("runs", "runs of gears and bearing for the fitted model between them", fit.runs);
  add("accepted",
      "1: the last run agrees with the fitted model that drove it, and the gears with its mean load; 0: no "
      "agreement",
      fit.accepted ? 1.0 : 0.0);
  add("residual", "share of the bearing force at mesh harmonics that the fitted model does not cover",
      fit.fitted.residual);
  add("stiffness_change", "change of the stiffness in the last run", fit.fitted.stiffness_change);
  add("damping_change", "change of the damping in the last run", fit.fitted.damping_change);
  const bool compared = point.dynamic && point.dynamic->one_way_load_difference;
  record.value("one_way_load_difference", dimension::ratio,
               "of the gears' mean force on the planet's bearings from the load under which the bearing ran",
               compared ? *point.dynamic->one_way_load_difference : kAbsent);
  describe_law(record, fit.fitted.bearing);
}

// Over a revolution of a carrier whose bearings are stated: the worst of all planet bearings.
void describe_carrier(Record& record, const PointResult& point) {
  const auto of = [&](const auto& part) { return point.carrier ? part(*point.carrier) : kAbsent; };
  using Whole = CarrierRevolution;
  record.value("carrier_load_share", dimension::ratio,
               "largest load of one planet bearing over a revolution of the carrier, over that of the torque "
               "shared evenly, where gearset.carrier states the carrier's bearings",
               of([](const Whole& r) { return r.largest_share(); }));
  record.value("carrier_K_gamma", dimension::ratio,
               "largest mesh force of a planet over the mean of all, over a revolution, likewise",
               of([](const Whole& r) { return r.mesh_load_factor; }));
  record.value("carrier_K_Hbeta_sun", dimension::ratio,
               "largest load per width of the sun's meshes over its mean, likewise",
               of([](const Whole& r) { return r.face_load(true); }));
  record.value("carrier_K_Hbeta_ring", dimension::ratio, "the same of the ring's meshes",
               of([](const Whole& r) { return r.face_load(false); }));
  record.value("carrier_back_flank_load_N", dimension::force,
               "largest normal force of back flanks over a revolution, likewise",
               of([](const Whole& r) { return r.back_flank_load(); }));
  record.value(
      "carrier_life_h", dimension::hours,
      "life_h of the planet bearing with the shortest, under its loads over a revolution",
      of([](const Whole& r) {
        return std::ranges::min_element(r.bearings, {}, &BearingOverRevolution::life_hours)->life_hours;
      }));
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    record.value(std::string("carrier_") + life.name, dimension::hours,
                 std::string(life.name) + " of the planet bearing with the shortest, likewise",
                 of([&](const Whole& r) { return r.worst(life.hours).rated_hours.*life.hours; }));
  using One = BearingOverRevolution;
  record.value("carrier_P0_N", dimension::force,
               "static equivalent load of the most loaded planet bearing over a revolution, likewise",
               of([](const Whole& r) { return r.most_loaded(&One::static_load).static_load; }));
  record.value("carrier_S0", dimension::ratio, "basic static load rating over that load",
               of([](const Whole& r) { return r.most_loaded(&One::static_load).static_safety; }));
  record.value("carrier_contact_pressure_max_MPa", dimension::pressure,
               "largest pressure of roller and race of all planet bearings over a revolution, likewise",
               of([](const Whole& r) { return r.most_loaded(&One::largest_pressure).largest_pressure; }));
}

void describe_distribution(Record& record, const LoadDistribution& loads) {
  record.series("angle", {"angle", "rad", "rad", ""},
                "position on the race, from the outward radial direction towards carrier rotation", {"place"},
                loads.angle);
  record.series("inner_load", dimension::force, "load of a roller on the inner race", {"place"},
                loads.inner_load);
  record.series("outer_load", dimension::force, "load of a roller on the outer race", {"place"},
                loads.outer_load);
  record.series("race_form", dimension::length,
                "outward displacement of the outer race by bending of the planet's rim", {"place"},
                loads.race_form);
}

void describe_direction(Record& record, const std::string& name, const described::Dimension& of,
                        const std::string& meaning, const Eigen::Vector2d& vector) {
  record.value(name + "_x", of, meaning + ", outward", vector.x());
  record.value(name + "_y", of, meaning + ", in the sense of rotation", vector.y());
}

// Loads of a bearing cut into laminae, whose positions are those of the distribution.
void describe_laminae(Record& record, const LaminaRecord& laminae) {
  using Table = Eigen::Map<const Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
  const auto count = static_cast<Eigen::Index>(laminae.lamina_position.size());
  const auto by_lamina = [&](const char* name, const char* meaning, const std::vector<double>& loads) {
    record.series(name, dimension::force, meaning, {"place", "lamina"},
                  Table(loads.data(), static_cast<Eigen::Index>(loads.size()) / count, count));
  };
  record.series("lamina_place", dimension::length, "middle of a lamina, from the middle of the roller",
                {"lamina"}, laminae.lamina_position);
  by_lamina("inner_lamina_load", "load of a lamina of a roller on the inner race", laminae.inner_load);
  by_lamina("outer_lamina_load", "load of a lamina of a roller on the outer race", laminae.outer_load);
  record.series("roller_tilt", dimension::angle, "tilt of a roller, outward at positive lamina positions",
                {"place"}, laminae.roller_tilt);
  describe_direction(record, "bore_tilt", dimension::angle,
                     "inclination of the bore's axis against the pin's", laminae.bore_tilt);
  describe_direction(record, "bore_moment", dimension::torque,
                     "moment of the rollers on the bore along its tilt", laminae.moment);
}

// The bearings of a planet whose tilt is computed, or of another type than cylindrical rollers.
void describe(Record& row, const SeatResult& seat) {
  row.value("place", dimension::length, "position along the axis, from the middle of the face",
            seat.position);
  row.value("load", dimension::force, "load of the rollers on the bore", seat.load);
  describe_direction(row, "tilt", dimension::angle, "tilt of the bore against the pin", seat.tilt);
  row.value("life", dimension::hours, "fatigue life of one bearing", seat.life_hours);
  describe(row, seat.rated_hours);
  row.value("axial_load", dimension::force, "axial load of the bearing, induced by its contact angle",
            seat.axial_load);
  row.value("rib_load", dimension::force, "largest load of a tapered roller on the rib of the inner ring",
            seat.rib_load);
}

void describe(Record& row, const PlanetResult& planet) {
  row.value("load_share", dimension::ratio,
            "tangential load of a planet, mean over time, over the mean of all planets", planet.load_share);
  row.value("bearing_load", dimension::force,
            "load of the rollers on the bore of one bearing of a planet, mean over time", planet.load);
  row.value("life", dimension::hours, "fatigue life of one bearing of a planet", planet.life_hours);
  describe(row, planet.rated_hours);
}

// One orbit of the rollers.
void describe_series(Record& record, const system::BearingSeries& series) {
  if (series.time.size() == 0) return;
  const auto along_time = [&](const char* name, const described::Dimension& of, const char* meaning,
                              const Eigen::ArrayXd& values) {
    record.series(name, of, meaning, {"time"}, values);
  };
  const auto of_rollers = [&](const char* name, const described::Dimension& of, const char* meaning,
                              const Eigen::ArrayXXd& values) {
    record.series(name, of, meaning, {"roller", "time"}, values);
  };
  along_time("time", dimension::time, "time since the start of the run", series.time);
  of_rollers("roller_angle", dimension::angle, "position of each roller in the carrier frame", series.angle);
  of_rollers("roller_inner_load", dimension::force, "load on the inner race", series.inner_load);
  of_rollers("roller_outer_load", dimension::force, "load on the outer race", series.outer_load);
  of_rollers("roller_inner_sliding", dimension::speed,
             "surface speed of the inner race less that of the roller", series.inner_sliding);
  of_rollers("roller_outer_sliding", dimension::speed,
             "surface speed of the outer race less that of the roller", series.outer_sliding);
  of_rollers("roller_inner_film", dimension::length, "least film on the inner race", series.inner_film);
  of_rollers("roller_outer_film", dimension::length, "least film on the outer race", series.outer_film);
  if (series.caged) {
    of_rollers("roller_pocket_load", dimension::force,
               "load on the cage bar, positive where the roller drives the cage", series.pocket_load);
    record.series("cage_position", dimension::length, "cage centre, x outward and y in the sense of rotation",
                  {"direction", "time"}, series.cage_position);
    along_time("cage_angle", dimension::angle,
               "rotation of the cage in the carrier frame, grows without bound", series.orbit_angle);
    along_time("cage_speed", dimension::spin, "speed of the cage relative to the carrier",
               series.orbit_speed);
  } else {
    of_rollers("roller_neighbour_load", dimension::force, "load on the roller ahead", series.neighbour_load);
    along_time("orbit_speed", dimension::spin, "mean orbital speed of the rollers relative to the carrier",
               series.orbit_speed);
  }
  of_rollers("roller_spin", dimension::spin, "spin relative to the carrier", series.spin);
  along_time("power_loss_over_time", dimension::heat, "total power loss", series.power_loss);
}

void describe_final_state(Record& record, const DynamicRecord& motion) {
  if (motion.final_state.size() == 0) return;
  std::string names;
  for (const std::string& name : bearing::motion::variable_names(motion.layout))
    names += (names.empty() ? "" : ", ") + name;
  record.series(kFinalState, dimension::ratio,
                "state at the end of the run, from which a neighbouring point may continue, in SI: " + names,
                {"state"}, motion.final_state);
}

}  // namespace

void describe_row(Record& record, const PointResult& point) {
  describe_loads_and_lives(record, point);
  describe_gears_and_fits(record, point);
  describe_ratings(record, point);
  describe_motion(record, point);
  describe_sharing(record, point);
  describe_one_way(record, point);
  describe_carrier(record, point);
}

void describe(Record& record, const PointResult& point) {
  describe_row(record, point);
  describe_distribution(record, point.distribution);
  if (point.laminae) describe_laminae(record, *point.laminae);
  const auto table = [&](const char* along, const auto& items) {
    record
        .table(along, along, "of one planet", items,
               [](Record& row, const auto& item) { describe(row, item); })
        .in_files_alone = true;
  };
  table("bearing", point.seats);
  table("planet", point.planets);
  described::Entry& revolution =
      record.child("carrier", "the carrier in three dimensions, over a revolution", point.carrier);
  revolution.variable = "revolution";
  revolution.in_files_alone = true;
  if (!point.dynamic) return;
  describe_series(record, point.dynamic->series);
  describe_final_state(record, *point.dynamic);
}

void describe_planet(Record& record, const PlanetResult& planet) {
  record.value("load_share", dimension::ratio,
               "tangential load of a planet, mean over time, over the mean of all planets",
               planet.load_share);
  record.value("bearing_load_N", dimension::force,
               "load of the rollers on the bore of one bearing, mean over time", planet.load);
  record.value("life_h", dimension::hours, "fatigue life of one bearing", planet.life_hours);
  describe(record, planet.rated_hours);
}

void describe(Record& record, const SetResult& set) {
  record.value("carrier_speed_rpm", dimension::angular_speed, "speed of the planet carrier",
               set.carrier_speed);
  record.value("planet_load_N", dimension::force, "total load on the bore of one bearing", set.planet_load);
  for (const auto& [race, of] : races_of(set))
    record.value(race + "_load_max_N", dimension::force,
                 "largest load of one roller on the " + race + " race", of->load_max);
  record.value("life_h", dimension::hours, "fatigue life of one bearing", set.life_hours);
  describe(record, set.rating.hours);
  describe_loads(record, set.rating.lives);
  record.value("contact_pressure_max_MPa", dimension::pressure,
               "largest pressure of roller and race, after Hertz", set.contact_pressure);
  describe_factors(record, set.rating.lives);
  record.value("rim_over_module", dimension::ratio, kRimMeaning, set.rim_over_module);
  describe(record, set.unlike);
}

}  // namespace orbearing::study
