// Description of an operating point: a row of a table, and arrays that are for files only.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "bearing/life/basic_life.hpp"
#include "bearing/life/rating_record.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/worst_bearing.hpp"
#include "mechanics/columns.hpp"

namespace orbearing::analysis {

namespace {

using described::Columns;
using described::kAbsent;
using described::Record;
namespace dimension = described::dimension;

constexpr described::Dimension kMicroseconds{"time", "s", "us", "", 1e-6};

constexpr const char* kRimMeaning = "rim of a planet between roots and bore, in normal modules";

struct NamedRace {
  std::string name;
  RaceResult* result;
};

template <class Result>
std::array<NamedRace, 2> races_of(Result& result) {
  return {{{"inner", &result.inner}, {"outer", &result.outer}}};
}

void list_loads_and_lives(Columns& columns, PointRow& row) {
  columns.value("input_speed_rpm", dimension::angular_speed,
                "input.speed: speed of the driving member, or of that which input.speed_of names",
                row.input_speed);
  columns.value("carrier_speed_rpm", dimension::angular_speed, "speed of the planet carrier",
                row.carrier_speed);
  columns.value("planet_load_N", dimension::force,
                "total load on the bore of one bearing, with cage and rollers", row.planet_load);
  columns.value("tangential_load_N", dimension::force, "load of both meshes in the direction of rotation",
                row.tangential_load);
  columns.value("centrifugal_load_N", dimension::force, "outward inertial load of planet, cage and rollers",
                row.centrifugal_load);
  for (const auto& [race, of] : races_of(row)) {
    columns.value(race + "_load_max_N", dimension::force,
                  "largest load of one roller on the " + race + " race", of->load_max);
    columns.value(race + "_load_rms_N", dimension::force,
                  "root mean square over time of one roller's load, " + race + " race", of->load_rms);
  }
  for (const auto& [race, of] : races_of(row))
    columns.value(race + "_life_Mrev", dimension::revolutions, "fatigue life of the " + race + " race",
                  of->life);
  columns.value("life_h", dimension::hours, "fatigue life of one bearing", row.life_hours);
  columns.value("system_life_h", dimension::hours, "fatigue life of all planet bearings of the set together",
                row.system_life_hours);
  columns.value("cage_slip", dimension::ratio, "1 minus cage speed divided by its kinematic speed",
                row.cage_slip);
  for (const auto& [race, of] : races_of(row))
    columns.value("film_" + race + "_um", dimension::small_length, "least film on the " + race + " race",
                  of->least_film);
  columns.text("status", "ok, or why the point failed", row.status);
}

void list_gears_and_fits(Columns& columns, PointRow& row) {
  columns.value("radial_mesh_load_N", dimension::force, "outward load of both meshes", row.radial_mesh_load);
  columns.value("axial_mesh_force_N", dimension::force,
                "axial force of the sun's helical teeth on one planet; that of the ring's is opposite",
                row.axial_mesh_force);
  columns.value("overturning_moment_N_m", dimension::torque,
                "moment of both axial forces on one planet about the tangential axis",
                row.overturning_moment);
  columns.value("sun_thrust_N", dimension::force,
                "axial force of all planets on the sun; that on the ring is opposite", row.sun_thrust);
  columns.value("contact_pressure_max_MPa", dimension::pressure,
                "largest pressure of roller and race, after Hertz", row.contact_pressure);
  columns.value("operating_clearance_um", dimension::small_length,
                "radial clearance of the running bearing, in diametral measure", row.radial_clearance);
  columns.value("rim_over_module", dimension::ratio, kRimMeaning, row.rim_over_module);
  columns.value("rim_ovality_um", dimension::small_length,
                "largest less least outward displacement of the outer race by bending of the planet's rim",
                row.rim_ovality);
}

// Ratings of one bearing by the standards.
void list_ratings(Columns& columns, PointRow& row) {
  bearing::rating::RatingLives& lives = row.rating.lives;
  columns.value("life_Mrev", dimension::revolutions, "fatigue life of one bearing, in revolutions", row.life)
      .variable = "life_revolutions";
  list(columns, row.rating.hours);
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    columns.value(std::string("system_") + life.name, dimension::hours,
                  std::string(life.name) + " of all planet bearings together",
                  row.rating.system_hours.*life.hours);
  const auto revolutions = [&](const char* name, const char* meaning, double& value) {
    columns.value(name, dimension::revolutions, meaning, value);
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
  list_loads(columns, lives);
  list_factors(columns, lives);
  columns.value(
      "static_safety", dimension::ratio,
      "S_0 of ISO 76: static capacity over load, by the largest pressure and 4000 MPa, of balls 4200 MPa",
      row.pressure_safety);
}

void list_losses(Columns& columns, bearing::motion::PowerLoss& loss) {
  const auto add = [&](const std::string& cause, const std::string& meaning, double& value) {
    columns.value("power_loss_" + cause + "_W", dimension::heat, "power lost " + meaning, value);
  };
  add("race_damping", "to damping of the race contacts", loss.race_damping);
  add("inner_traction", "to sliding on the inner race", loss.inner_traction);
  add("outer_traction", "to sliding on the outer race", loss.outer_traction);
  add("rolling", "to rolling resistance", loss.rolling);
  add("drag", "to the oil-air mixture", loss.drag);
  add("pockets", "in the cage pockets", loss.pockets);
  add("guidance", "in the cage guidance", loss.guidance);
  add("neighbours", "between rollers that touch one another, without a cage", loss.neighbours);
  add("support", "in the support of the pin", loss.support);
}

// Slip, friction and lightness of the load.
void list_slip(Columns& columns, MotionNumbers& motion) {
  columns.value("roller_slip", dimension::ratio, "1 minus mean roller spin divided by that at pure rolling",
                motion.roller_slip);
  columns.value("orbit_slip", dimension::ratio,
                "1 minus mean orbital speed of the rollers divided by that at pure rolling, without a cage",
                motion.orbit_slip);
  columns.value(
      "drag_over_traction", dimension::ratio,
      "drag of the oil on rollers and cage at pure rolling over the largest traction of the loaded rollers; "
      "above 1 the bearing is lightly loaded",
      motion.drag_over_traction);
  columns.value(
      "drag_slip", dimension::ratio,
      "cage_slip that the loads at rest give by traction, rolling resistance, drag and guidance of the cage; "
      "within 0.03 of cage_slip where rollers do not bounce",
      motion.drag_slip);
  columns.value(
      "friction_moment_N_m", dimension::torque,
      "mean friction moment of the bearing on the bore. Times the planet's speed relative to the carrier, "
      "plus vibration_power_W, it is power_loss_W within 3 %",
      motion.friction_moment);
  columns.value(
      "vibration_power_W", dimension::heat,
      "power that vibration of the planet brings into the bearing, beyond mean friction moment times "
      "mean speed",
      motion.vibration_power);
}

void list_motion(Columns& columns, PointRow& row) {
  columns.part(row.motion, [&](MotionNumbers& motion) { list_slip(columns, motion); });
  columns.value("power_loss_W", dimension::heat, "power lost in all", row.power_loss);
  columns.part(row.motion, [&](MotionNumbers& motion) {
    list_losses(columns, motion.loss);
    columns.value("steady", dimension::ratio, "1: the means were steady; 0: they drifted to the end",
                  motion.steady);
  });
}

void list(Columns& columns, UnlikeBearings& unlike) {
  columns.value("shortest_life_h", dimension::hours,
                "shortest life of a bearing, where planets load unevenly, their tilt is computed or bearings "
                "act on the gears",
                unlike.shortest_hours);
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    columns.value(std::string("shortest_") + life.name, dimension::hours,
                  std::string(life.name) +
                      ", shortest of all bearings, where planets load unevenly or their tilt is computed",
                  unlike.shortest_rated.*life.hours);
  columns.value("shortest_life_planet", dimension::ratio,
                "planet with the shortest bearing life, counted from 1, where life_h is that of unlike "
                "planets together",
                unlike.planet);
  columns.value("largest_load_share", dimension::ratio,
                "mean tangential load of the most loaded planet, divided by the mean of all planets",
                unlike.load_share);
}

// Results for planets or bearings that are unlike.
void list_sharing(Columns& columns, PointRow& row) {
  list(columns, row.unlike);
  columns.value("largest_bearing_tilt_mrad", dimension::small_angle,
                "largest tilt of a bore against its pin, where the tilt of planets is computed",
                row.largest_bearing_tilt);
  columns.value("largest_bearing_share", dimension::ratio,
                "load of the most loaded bearing of a planet, divided by the mean of its bearings, likewise",
                row.largest_bearing_share);
  columns.value("interface_energy_residual", dimension::ratio,
                "energy error of the exchange of gears and bearings, divided by the exchanged energy",
                row.exchange_residual);
  columns.value("interface_window_us", kMicroseconds, "mean time between two exchanges; 0: one system",
                row.exchange_window);
}

// force - stiffness x displacement - damping x velocity of a planet on all its bearings.
void list_law(Columns& columns, gearset::dynamics::AffineBearing& law) {
  const auto add = [&](const std::string& name, const char* unit, const described::Dimension& of,
                       double& value) {
    columns.value("one_way_" + name + unit, of, "fitted model of all bearings of a planet: one_way_" + name,
                  value);
  };
  const std::array<std::string, 2> axes{"x", "y"};
  const auto add_matrix = [&](const std::string& name, const char* unit, const described::Dimension& of,
                              Eigen::Matrix2d& matrix) {
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

void list_fit(Columns& columns, OneWayRecord& fit) {
  const auto add = [&](const std::string& name, const char* meaning, auto& value) {
    columns.value("one_way_" + name, dimension::ratio, meaning, value);
  };
  add("runs", "runs of gears and bearing for the fitted model between them", fit.runs);
  add("accepted",
      "1: the last run agrees with the fitted model that drove it, and the gears with its mean load; 0: no "
      "agreement",
      fit.accepted);
  add("residual", "share of the bearing force at mesh harmonics that the fitted model does not cover",
      fit.fitted.residual);
  add("stiffness_change", "change of the stiffness in the last run", fit.fitted.stiffness_change);
  add("damping_change", "change of the damping in the last run", fit.fitted.damping_change);
}

// The law that replaced the bearings in gears that drive one of them.
void list_one_way(Columns& columns, PointRow& row) {
  columns.part(row.one_way, [&](OneWayRecord& fit) { list_fit(columns, fit); });
  columns.part(row.motion, [&](MotionNumbers& motion) {
    columns.value(
        "one_way_load_difference", dimension::ratio,
        "of the gears' mean force on the planet's bearings from the load under which the bearing ran",
        motion.one_way_load_difference);
  });
  columns.part(row.one_way, [&](OneWayRecord& fit) { list_law(columns, fit.fitted.bearing); });
}

// Over a revolution of a carrier whose bearings are stated: the worst of all planet bearings.
void list_carrier(Columns& columns, CarrierNumbers& carrier) {
  columns.value(
      "carrier_load_share", dimension::ratio,
      "largest load of one planet bearing over a revolution of the carrier, over that of the torque "
      "shared evenly, where gearset.carrier states the carrier's bearings",
      carrier.load_share);
  columns.value("carrier_K_gamma", dimension::ratio,
                "largest mesh force of a planet over the mean of all, over a revolution, likewise",
                carrier.mesh_load_factor);
  columns.value("carrier_K_Hbeta_sun", dimension::ratio,
                "largest load per width of the sun's meshes over its mean, likewise", carrier.face_load_sun);
  columns.value("carrier_K_Hbeta_ring", dimension::ratio, "the same of the ring's meshes",
                carrier.face_load_ring);
  columns.value("carrier_back_flank_load_N", dimension::force,
                "largest normal force of back flanks over a revolution, likewise", carrier.back_flank_load);
  columns.value("carrier_life_h", dimension::hours,
                "life_h of the planet bearing with the shortest, under its loads over a revolution",
                carrier.life_hours);
  for (const bearing::rating::RatedLife& life : bearing::rating::kRatedLives)
    columns.value(std::string("carrier_") + life.name, dimension::hours,
                  std::string(life.name) + " of the planet bearing with the shortest, likewise",
                  carrier.rated_hours.*life.hours);
  columns.value("carrier_P0_N", dimension::force,
                "static equivalent load of the most loaded planet bearing over a revolution, likewise",
                carrier.static_load);
  columns.value("carrier_S0", dimension::ratio, "basic static load rating over that load",
                carrier.static_safety);
  columns.value("carrier_contact_pressure_max_MPa", dimension::pressure,
                "largest pressure of roller and race of all planet bearings over a revolution, likewise",
                carrier.contact_pressure);
}

double ovality(const std::vector<double>& race_form) {
  if (race_form.empty()) return 0.0;
  const auto [least, most] = std::ranges::minmax(race_form);
  return most - least;
}

double pressure_safety(const PointResult& point) {
  const bool rollers = point.element == bearing::rating::RollingElement::roller;
  return std::pow(bearing::rating::static_pressure(point.element) / point.contact_pressure, rollers ? 2 : 3);
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

CarrierNumbers numbers_of(const CarrierRevolution& revolution) {
  using One = BearingOverRevolution;
  const One& most_loaded = revolution.most_loaded(&One::static_load);
  CarrierNumbers numbers{
      .load_share = revolution.largest_share(),
      .mesh_load_factor = revolution.mesh_load_factor,
      .face_load_sun = revolution.face_load(true),
      .face_load_ring = revolution.face_load(false),
      .back_flank_load = revolution.back_flank_load(),
      .life_hours = std::ranges::min_element(revolution.bearings, {}, &One::life_hours)->life_hours,
      .static_load = most_loaded.static_load,
      .static_safety = most_loaded.static_safety,
      .contact_pressure = revolution.most_loaded(&One::largest_pressure).largest_pressure};
  for (const auto hours : bearing::rating::kRatedHours)
    numbers.rated_hours.*hours = revolution.worst(hours).rated_hours.*hours;
  return numbers;
}

void put_motion(const PointResult& point, PointRow& row) {
  row.motion = *point.dynamic;
  row.one_way = point.dynamic->one_way;
  bearing::motion::PowerLoss& loss = row.motion->loss;
  row.power_loss = loss.total();
  if (point.caged)
    loss.neighbours = kAbsent;
  else
    loss.pockets = loss.guidance = kAbsent;
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

PointRow row_of(const PointResult& point) {
  PointRow row{point};
  if (!point.caged) row.cage_slip = kAbsent;
  row.rim_ovality = ovality(point.distribution.race_form);
  row.pressure_safety = pressure_safety(point);
  if (point.dynamic) put_motion(point, row);
  row.unlike = unlike_bearings(point);
  row.largest_bearing_tilt = largest_of(point.seats, [](const SeatResult& seat) { return seat.tilt.norm(); });
  row.largest_bearing_share = largest_bearing_share(point);
  if (point.coupled) {
    row.exchange_residual = point.coupled->energy_residual;
    row.exchange_window = point.coupled->window;
  }
  if (point.carrier) row.carrier = numbers_of(*point.carrier);
  return row;
}

void list(Columns& columns, PointRow& row) {
  list_loads_and_lives(columns, row);
  list_gears_and_fits(columns, row);
  list_ratings(columns, row);
  list_motion(columns, row);
  list_sharing(columns, row);
  list_one_way(columns, row);
  columns.part(row.carrier, [&](CarrierNumbers& carrier) { list_carrier(columns, carrier); });
}

void describe_row(Record& record, const PointResult& point) {
  describe_listed(record, row_of(point));
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

void list(Columns& columns, PlanetResult& planet) {
  columns.value("load_share", dimension::ratio,
                "tangential load of a planet, mean over time, over the mean of all planets",
                planet.load_share);
  columns.value("bearing_load_N", dimension::force,
                "load of the rollers on the bore of one bearing, mean over time", planet.load);
  columns.value("life_h", dimension::hours, "fatigue life of one bearing", planet.life_hours);
  list(columns, planet.rated_hours);
}

void list(Columns& columns, SetResult& set) {
  columns.value("carrier_speed_rpm", dimension::angular_speed, "speed of the planet carrier",
                set.carrier_speed);
  columns.value("planet_load_N", dimension::force, "total load on the bore of one bearing", set.planet_load);
  for (const auto& [race, of] : races_of(set))
    columns.value(race + "_load_max_N", dimension::force,
                  "largest load of one roller on the " + race + " race", of->load_max);
  columns.value("life_h", dimension::hours, "fatigue life of one bearing", set.life_hours);
  list(columns, set.rating.hours);
  list_loads(columns, set.rating.lives);
  columns.value("contact_pressure_max_MPa", dimension::pressure,
                "largest pressure of roller and race, after Hertz", set.contact_pressure);
  list_factors(columns, set.rating.lives);
  columns.value("rim_over_module", dimension::ratio, kRimMeaning, set.rim_over_module);
  list(columns, set.unlike);
}

void describe(Record& record, const SetResult& set) {
  describe_listed(record, set);
}

}  // namespace orbearing::analysis
