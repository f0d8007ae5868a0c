// One operating point of a planetary drivetrain: from the power that enters to the life of a planet bearing.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bearing/life/rating_lives.hpp"
#include "coupling/analysis/carrier_revolution.hpp"
#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/one_way.hpp"

namespace orbearing::described {
class Columns;
class Record;
}  // namespace orbearing::described

namespace orbearing::analysis {

/// Fidelity of the planet bearing, in ascending order.
enum class Fidelity {
  quasi_static,
  dynamic,       // in time, driven by the gears: one way
  co_simulated,  // gears and all bearings act on each other, each with its own integrator
  monolithic,    // the same as one system of equations
};

/// Loads, life and film of one race.
struct RaceResult {
  double load_max = 0.0;    // [N]    largest load of one roller
  double load_rms = 0.0;    // [N]    over time for one roller, unloaded time included
  double life = 0.0;        // [rev]  revolutions of the turning race, Lundberg and Palmgren
  double least_film = 0.0;  // [m]    under the most loaded roller; NaN where nothing rolls or no oil is given
  double lamina_load_max = 0.0;  // [N]  largest load of one lamina; 0: all carry alike

  /// [N]  of a roller all of which carried as the most loaded lamina
  double largest_even_load(int laminae) const {
    return lamina_load_max > 0.0 ? laminae * lamina_load_max : load_max;
  }
};

/// Roller loads by position on the race, in the carrier frame.
struct LoadDistribution {
  std::vector<double> angle;       // [rad]  from the outward radial direction towards carrier rotation
  std::vector<double> inner_load;  // [N]    roller on pin
  std::vector<double> outer_load;  // [N]    roller on planet bore
  std::vector<double> race_form;   // [m]    outward displacement of an elastic outer race; empty: rigid
};

/// Results of a bearing cut into laminae only. Arrays (positions, laminae) have the laminae fastest.
struct LaminaRecord {
  std::vector<double> lamina_position;  // [m]    (laminae)  middles, from the middle of the roller
  std::vector<double> inner_load;       // [N]    (positions, laminae)
  std::vector<double> outer_load;       // [N]    (positions, laminae)
  std::vector<double> roller_tilt;      // [rad]  (positions)  outward at positive lamina positions
  Eigen::Vector2d bore_tilt = Eigen::Vector2d::Zero();  // [rad]  of the bore's axis against the pin's
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();     // [N m]  of the rollers on the bore, along its tilt
};

/// Numbers of the motion in time.
struct MotionNumbers {
  bool steady = false;               // false: the means still drifted when they were taken
  double roller_slip = 0.0;          // [-]  1 - mean roller spin / spin at pure rolling
  std::optional<double> orbit_slip;  // [-]  1 - mean orbital speed of rollers without cage / at pure rolling
  double friction_moment = 0.0;      // [N m]  of the bearing on the bore
  double vibration_power = 0.0;      // [W]    that the bearing takes from the bore beyond that
  bearing::motion::PowerLoss loss;   // [W]  by cause
  std::optional<double> one_way_load_difference = std::nullopt;  // [-]  also where only mean loads drive it
  std::optional<double> drag_over_traction = std::nullopt;       // [-]  how lightly the bearing is loaded
  std::optional<double> drag_slip = std::nullopt;                // [-]  of the cage, under the loads at rest
};

/// Results of the motion in time only.
struct DynamicRecord : MotionNumbers {
  system::BearingSeries series;         // of the last cage revolution
  integration::IntegrationReport run;   // what it took
  Eigen::VectorXd final_state;          // final state; a neighbouring point may start from it
  bearing::motion::StateLayout layout;  // of that state
  std::optional<OneWayRecord> one_way;  // the law that replaced the bearings in gears that drive one of them
};

/// Results of gears and bearings that act on each other only.
struct CoupledRecord {
  std::vector<double> bearing_life_hours;  // [h]  (planets x bearings per planet), planet by planet
  double energy_residual = 0.0;            // [-]  of all exchanges over the energy that passed the ports
  double window = 0.0;                     // [s]  mean time between exchanges; 0: one system
};

/// Lives of one bearing by the standards, in addition to that of Lundberg and Palmgren and on the same loads.
struct RatingRecord {
  bearing::rating::RatingLives lives;
  bearing::rating::RatedHours hours;         // of one bearing
  bearing::rating::RatedHours system_hours;  // of all planet bearings of all sets
};

/// One planet where planets differ or were computed one by one. Loads and life are those of one bearing.
struct PlanetResult {
  double load_share = 1.0;  // [-]  tangential load, mean over time, over the mean of all planets
  double load = 0.0;        // [N]  of the rollers on the bore, mean over time
  double life_hours = 0.0;  // [h]
  bearing::rating::RatedHours rated_hours{};
};

/// One bearing of a planet whose tilt is computed, or of a type other than cylindrical rollers.
struct SeatResult {
  double position = 0.0;                           // [m]    along the axis, from the middle of the face
  double load = 0.0;                               // [N]    on its bore, mean over time
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();  // [rad]  of its bore against the pin, outward and ahead
  double life_hours = 0.0;                         // [h]
  bearing::rating::RatedHours rated_hours{};
  double axial_load = 0.0;  // [N]  induced by a contact angle
  double rib_load = 0.0;    // [N]  largest of one tapered roller on the rib of the inner ring
};

/// The worst of bearings that carry unlike loads. Not a number where all carry alike.
struct UnlikeBearings {
  static constexpr double kAlike = std::numeric_limits<double>::quiet_NaN();
  double shortest_hours = kAlike;                // [h]  Lundberg and Palmgren
  bearing::rating::RatedHours shortest_rated{};  // [h]  shortest life by life
  double planet = kAlike;                        // with the shortest life, counted from 1
  double load_share = kAlike;                    // [-]  largest of all planets
};

/// One of several sets at an operating point. Loads and life are those of one bearing.
struct SetResult {
  std::string set;
  double carrier_speed = 0.0;  // [rad/s]
  double planet_load = 0.0;    // [N]  total on the bore, with cage and rollers
  RaceResult inner;
  RaceResult outer;
  double life_hours = 0.0;  // [h]
  RatingRecord rating{};
  double contact_pressure = 0.0;                                      // [Pa]  as of a point
  double rim_over_module = std::numeric_limits<double>::quiet_NaN();  // [-]  as of a point
  UnlikeBearings unlike{};
};

/// Numbers of one operating point. Loads and lives are those of one bearing: of several sets, of the one
/// whose bearings have the shortest life.
struct PointNumbers {
  double input_speed = 0.0;         // [rad/s]
  double carrier_speed = 0.0;       // [rad/s]
  double planet_load = 0.0;         // [N]  total on the bore of one bearing, with cage and rollers
  double tangential_load = 0.0;     // [N]  y: from both meshes
  double radial_mesh_load = 0.0;    // [N]  x: from both meshes, positive outward
  double centrifugal_load = 0.0;    // [N]  x: planet, cage and the tangential halves of the rollers
  double axial_mesh_force = 0.0;    // [N]    z: of the sun on one planet; the ring's is opposite
  double overturning_moment = 0.0;  // [N m]  about y: of both axial forces on one planet
  double sun_thrust = 0.0;          // [N]    z: of all planets on the sun; the ring's is opposite
  RaceResult inner;
  RaceResult outer;
  double life = 0.0;               // [rev]  one bearing, Lundberg and Palmgren, as the three that follow
  double life_hours = 0.0;         // [h]  one bearing
  double system_life_hours = 0.0;  // [h]  all planet bearings of all sets
  double contact_pressure =
      0.0;                 // [Pa] largest of both races, after Hertz; of laminae, the most loaded one's
  double cage_slip = 0.0;  // [-]  1 - cage speed / kinematic cage speed; 0 at rest
  double radial_clearance = 0.0;  // [m]  of the running bearing
  double rim_over_module =
      std::numeric_limits<double>::quiet_NaN();  // [-]  of a planet, between roots and bore, normal modules
  RatingRecord rating;
  std::vector<PlanetResult> planets;  // none where all planets carry alike
  std::string limiting_set;           // of several sets, the one these numbers belong to
  std::vector<SetResult> sets;        // of several sets, all with bearings, in the order given
  std::string status = "ok";          // "ok" or why the point failed
};

/// Results of one operating point.
struct PointResult : PointNumbers {
  bool caged = true;  // else there are no results of a cage
  bearing::rating::LifeMethod life_method = bearing::rating::LifeMethod::lundberg_palmgren;
  bearing::rating::RollingElement element = bearing::rating::RollingElement::roller;
  LoadDistribution distribution;
  std::optional<DynamicRecord> dynamic;  // none from the quasi-static model
  std::optional<LaminaRecord> laminae;   // none from whole contacts
  std::vector<SeatResult> seats;         // of one planet, or of unlike ones in turn, where tilts are computed
  std::optional<CarrierRevolution> carrier;  // at rest, where the carrier's bearings are stated
  std::optional<CoupledRecord> coupled;      // none where the bearings do not act back on the gears
};

/// The worst of all planet bearings over a revolution of a carrier on its own bearings.
struct CarrierNumbers {
  double load_share = 0.0;                  // [-]  largest load over that of the torque shared evenly
  double mesh_load_factor = 0.0;            // [-]  K_gamma
  double face_load_sun = 0.0;               // [-]  K_Hbeta of the sun's meshes
  double face_load_ring = 0.0;              // [-]
  double back_flank_load = 0.0;             // [N]
  double life_hours = 0.0;                  // [h]  of the bearing with the shortest
  bearing::rating::RatedHours rated_hours;  // [h]  of the bearing with the shortest by each
  double static_load = 0.0;                 // [N]  P_0 of the most loaded
  double static_safety = 0.0;               // [-]  S_0 of it
  double contact_pressure = 0.0;            // [Pa]
};

/// A row of a table of points: single values. Those of a point that failed are not numbers but its speed.
struct PointRow : PointNumbers {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double rim_ovality = kNone;           // [m]  largest less least displacement of the outer race by the rim
  double pressure_safety = kNone;       // [-]  S_0 by the largest pressure
  double power_loss = kNone;            // [W]  in all, in motion
  std::optional<MotionNumbers> motion;  // losses in what a bearing lacks, as in its cage: no number
  UnlikeBearings unlike;
  double largest_bearing_tilt = kNone;   // [rad]
  double largest_bearing_share = kNone;  // [-]  of the load of a planet, over the mean of its bearings
  double exchange_residual = kNone;      // [-]  as of CoupledRecord
  double exchange_window = kNone;        // [s]
  std::optional<OneWayRecord> one_way;   // without its difference of loads, which is in `motion`
  std::optional<CarrierNumbers> carrier;
};

PointRow row_of(const PointResult& point);

/// The columns of a table, in their order.
void list(described::Columns& columns, PointRow& row);
/// Those of one of several sets, and of one planet where planets carry unlike loads.
void list(described::Columns& columns, SetResult& set);
void list(described::Columns& columns, PlanetResult& planet);

/// Name of the array that holds the state in which the motion ended.
inline constexpr const char* kFinalState = "final_state";

/// Row of a table. For a failed point only input speed and status have a meaning.
void describe_row(described::Record& record, const PointResult& point);
/// The same, with loads by position, bearings and planets one by one and the motion in time, which are for
/// files.
void describe(described::Record& record, const PointResult& point);
void describe(described::Record& record, const SetResult& set);

/// The governing life of a point.
bearing::rating::Life governing_life(const PointResult& result);
/// Governing life of one bearing, by the drivetrain's method [h]; not a number where the standards give none.
double governing_hours(const PointResult& result);

/// Loads, lives and the largest pressure of bearings that are not cylindrical, at rest; speeds and loads on
/// the bore are not put in. The overturning moment of helical teeth is included where a planet has two
/// bearings or more. Throws std::runtime_error where no equilibrium is found.
PointResult inclined_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           const BearingDuty& duty);

/// bearing_dynamics() with what `gears` give at this duty.
bearing::motion::DynamicsParameters dynamics_parameters(const PlanetaryDrivetrain& drivetrain,
                                                        const DrivetrainGeometry& geometry,
                                                        const BearingDuty& duty, const GearsOnTangent& gears);

/// Drag over traction (bearing/motion/drag_slip.hpp) above which a bearing is lightly loaded.
inline constexpr double kLightLoad = 1.0;  // [-]

/// By how much drag_slip() and the slip of a cage in motion differ: docs/slip_and_branches.md.
inline constexpr double kDragSlipError = 0.03;  // [-]

/// Whether a point with one-way drive is solved as one system with its gears. Driven one way the bore is free
/// under a stated force, while meshes as stiff as the bearing hold it in fact. Rollers without a cage strike
/// each other and the races: lives on a free bore are up to an eighth too short. A lightly loaded bearing
/// whirls on a free bore, and its own whirl gives it the load not to skid. False where gears and bearings
/// have no common motion in time: several sets, a run-up, a computed tilt.
bool moves_with_its_gears(const PlanetaryDrivetrain& drivetrain, double drag_over_traction);

/// Computes one point. Throws std::runtime_error with the solver's reason if there is no equilibrium or the
/// motion could not be followed.
PointResult evaluate(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                     Fidelity fidelity = Fidelity::quasi_static);

/// [-]  by which the life at rest is longer on a rim `factor` times as stiff, of all influences alike. Above
/// 0 where a rim is softer than that of the longest life: an oval bore then presses the ends of its load
/// zone. 0 on a rigid one. Throws as evaluate().
double gain_by_stiffer_rim(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           double factor);

/// The motion at one point from `start`, the final state of a neighbouring point, taken as it is. Throws as
/// above, and std::invalid_argument where the state is not one of a bearing with that many rollers.
PointResult evaluate_from(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                          const Eigen::VectorXd& start);

}  // namespace orbearing::analysis
