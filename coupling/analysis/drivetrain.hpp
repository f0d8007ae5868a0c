// A planetary drivetrain with roller bearings in its planets: what is stated, and what follows once and for
// all.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "bearing/equilibrium/quasi_static.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/life_modification.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/motion/parameters.hpp"
#include "bearing/mounted_clearance.hpp"
#include "bearing/parameters.hpp"
#include "bearing/pin_beam.hpp"
#include "bearing/planet_rows.hpp"
#include "coupling/cosim/coupled_run.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/steady_state.hpp"
#include "gearset/dynamics/parameters.hpp"
#include "gearset/mean_loads.hpp"
#include "gearset/parameters.hpp"
#include "gearset/planet_body.hpp"
#include "gearset/planet_pair.hpp"
#include "gearset/rim/rim_influence.hpp"
#include "gearset/spatial/spatial_set.hpp"
#include "gearset/working_geometry.hpp"

namespace orbearing::bearing::vectorised {
struct PitchResults;
}

namespace orbearing::analysis {

/// Growth of the input speed at constant power, for the dynamic bearing.
struct RunUp {
  double acceleration = 0.0;  // [rad/s^2]  of the driven member; 0: steady speeds
  double duration = 0.05;     // [s]
};

template <class Visitor>
void describe(Visitor& visit, RunUp& m) {
  using namespace described;
  members(
      visit, m,
      input(m.acceleration, "input.acceleration",
            "growth of the input speed at constant power, for a single dynamic run",
            {.dimension = dimension::angular_acceleration, .range = {-1e9, 1e9}, .reason = "steady speeds"}),
      input(m.duration, "simulation.run_up_time", "time of the run-up",
            {.dimension = dimension::time,
             .range = positive(1e4),
             .reason = "some revolutions of the cage",
             .where = {"input.acceleration"}}));
}

/// Misalignment of the bore on the pin. Affects bearings cut into laminae only.
struct Misalignment {
  std::optional<double> planet_tilt;  // [rad]  in the plane of the load: the bore leans towards the load at
                                      //        positive z
  std::optional<double> carrier_wind_up;  // [rad]  in the tangential plane: the bore leads at positive z
};

template <class Visitor>
void describe(Visitor& visit, Misalignment& m) {
  using namespace described;
  const Details angle{
      .dimension = dimension::angle, .range = {-2.0, 2.0}, .where = {"bearing.tilt_state", "stated"}};
  members(
      visit, m,
      input(
          m.planet_tilt, "bearing.misalignment.planet_tilt",
          "tilt of the planet on its pin, in the plane of the load on its bearing; positive: the bore leans "
          "towards the load at its positive end",
          angle),
      input(m.carrier_wind_up, "bearing.misalignment.carrier_wind_up",
            "tilt of the bore against the pin in the tangential plane, by the twist of the carrier; "
            "positive: the "
            "bore leads at its positive end",
            angle));
}

/// Model of the planet around its bearings.
enum class PlanetRim {
  rigid,    // as published models have it
  elastic,  // rim and outer rings bend between rollers and teeth
};

constexpr described::Names<PlanetRim, 2> names_of(PlanetRim) {
  return {{{PlanetRim::rigid, "rigid"}, {PlanetRim::elastic, "elastic"}}};
}

/// Origin of the tilt of a planet on its pin.
enum class TiltState {
  stated,    // by Misalignment
  computed,  // from the equilibrium of all bearings of a planet on their pin
};

constexpr described::Names<TiltState, 2> names_of(TiltState) {
  return {{{TiltState::stated, "stated"}, {TiltState::computed, "computed"}}};
}

/// Seats of the bearings of a planet on their pin. Used if the tilt is computed.
struct PinSeats {
  TiltState tilt = TiltState::stated;
  std::vector<double>
      axial_positions;  // [m]  (bearings)  from the middle of the face; none: evenly across it
  std::vector<double> clearance_differences;  // [m]  (bearings)  beyond the stated clearance; none: alike
  bearing::PinEnds ends = bearing::PinEnds::both;
  std::optional<double> span;      // [m]  of the pin; none: by the face, pin_span()
  std::optional<double> diameter;  // [m]  of a flexpin, within its sleeve; none: the bore of the bearing
  std::optional<double>
      carrier_twist;                // [N m/rad]  of one wall of the carrier against the other; none: rigid
  double radial_inclination = 0.0;  // [rad]  of an unloaded pin: its positive end is outward
  double tangential_inclination = 0.0;  // [rad]  its positive end leads
};

template <class Visitor>
void describe(Visitor& visit, PinSeats& m) {
  using namespace described;
  const Where computed{"bearing.tilt_state", "computed"};
  const auto inclination = [&](double& member, const std::string& direction, const std::string& sense) {
    return input(member, "support.pin_inclination." + direction,
                 "inclination of the unloaded pin against the gears' axes, " + sense,
                 {.dimension = dimension::angle, .range = {-2.0, 2.0}, .where = computed});
  };
  members(
      visit, m,
      input(m.tilt, "bearing.tilt_state",
            "tilt of the planet on its pin: stated by bearing.misalignment, or computed from all its "
            "bearings, the "
            "pin and the meshes",
            {.reason = "as published models have it"}),
      input(m.axial_positions, "bearing.axial_places",
            "axial positions of the bearings of a planet, from the middle of the face; equally spaced if "
            "absent",
            {.dimension = dimension::length, .range = {-1e4, 1e4}, .where = computed}),
      input(m.clearance_differences, "bearing.clearance_differences",
            "clearance of each bearing of a planet minus the stated clearance",
            {.dimension = dimension::small_length, .range = {-1000.0, 1000.0}, .where = computed}),
      input(
          m.ends, "support.pin_ends",
          "ends by which the carrier holds a pin: it rests in both walls, or is clamped in the one at its "
          "negative end; flexpin: clamped so, with the bearings on a rigid sleeve that its free end carries",
          {.reason = "planets between two walls of the carrier", .where = computed}),
      input(m.span, "support.pin_span",
            "length of the pin between the middles of both walls; held at one end, twice that from the wall "
            "to the "
            "middle of the face; of a flexpin from the wall to where it carries its sleeve",
            {.dimension = dimension::length, .range = positive(1e4), .where = computed}),
      input(
          m.diameter, "support.pin_diameter",
          "diameter of the pin of a flexpin, within the sleeve on which the bearings sit",
          {.dimension = dimension::length, .range = positive(1e4), .where = {"support.pin_ends", "flexpin"}}),
      input(m.carrier_twist, "support.carrier_twist_stiffness",
            "torsional stiffness of the carrier between its wall at the positive end and the wall at the "
            "negative end, which transmits the torque; rigid if absent",
            {.dimension = dimension::rotating_stiffness, .range = positive(1e15), .where = computed}),
      inclination(m.radial_inclination, "radial", "its positive end outward"),
      inclination(m.tangential_inclination, "tangential", "its positive end ahead in the sense of rotation"));
}

/// Data for the lives by the standards besides the loads of a bearing.
struct RatedBearing {
  bearing::rating::StatedRatings stated{};          // replace the values of the standards
  std::optional<bearing::rating::StatedOil> oil{};  // none: not stated
  std::optional<double>
      roughness{};  // [m]  composite: kappa by the film that was computed; none: as given by `oil`
  double reliability_factor = 1.0;  // [-]  a_1
  bearing::rating::LifeMethod method =
      bearing::rating::LifeMethod::lundberg_palmgren;  // the governing life of the results
};

/// Parameters of a planetary set and its drive, single or among several sets. A sweep changes one or the
/// other and derives anew.
struct PlanetaryDrivetrain {
  gearset::PlanetarySet set;
  gearset::Drive drive;
  /// Among several sets: how this one's members turn and are loaded for what `drive` puts into the whole, of
  /// which only power and speed count then. None: the set is single and driven at drive.member.
  std::optional<gearset::MemberRatios> in_arrangement;
  /// Which planet of a pair this is; none: planets are single. With in_arrangement, and at rest only.
  std::optional<gearset::PlanetOfPair> of_pair;
  bearing::Bearing bearing;    // with the clearance that it has at this drive
  bearing::Mounting mounting;  // from which that clearance follows, where a case states it so
  bearing::PlanetRows rows;    // which kind of bearing it is; others than cylindrical at rest only
  int bearings_per_planet = 1;
  PlanetRim rim = PlanetRim::rigid;
  double reduction_factor = 0.83;  // [-]  product lambda nu of ISO/TR 1281-1
  Misalignment misalignment;
  PinSeats seats;
  bearing::motion::DynamicsParameters dynamics;  // roller dynamics; oil, film and inertia at rest too
  system::SteadyStateOptions steady_state;
  cosim::CoupledOptions exchange{.window = 5e-6};  // of gears and bearings that are co-simulated
  RunUp run_up;
  /// Bodies and meshes of the gears, whose motion at each speed shakes the bearing in time; none: the meshes
  /// give their mean forces. Called by each analysis anew, from any thread: the same every time.
  std::function<gearset::dynamics::SetParameters()> gear_set;
  bool uneven_planets =
      false;  // of gear_set: pins off their positions or at unequal steps make planets load unevenly
  /// Support of the carrier in the housing, of gear_set; none: its sag and tilt are left out at rest.
  std::optional<gearset::spatial::CarrierMounting> carrier_mounting;
  bool mesh_variation = true;  // false: the meshes keep their mean stiffness, and give their mean forces
  RatedBearing rated;
  int cage_positions = 16;  // cage angles over one roller pitch that the quasi-static model averages

  /// Else planets turn on their pins as they are.
  bool has_bearing() const { return bearing.element_count() > 0; }
};

/// Parameters in a case besides the gears.
template <class Visitor>
void describe(Visitor& visit, PlanetaryDrivetrain& m) {
  using namespace described;
  members(
      visit, m, apart(m.set), apart(m.drive), apart(m.in_arrangement), apart(m.of_pair), part(m.bearing),
      part(m.mounting), part(m.rows),
      input(m.bearings_per_planet, "bearing.per_planet", "bearings side by side in a planet",
            {.range = {1, 8}}),
      input(m.rim, "gearset.planet_rim",
            "rim of the planet with the outer rings of its bearings: rigid, or elastic between rollers and "
            "teeth",
            {.reason = "as published models have it; thin rims bend"}),
      system::reduction_factor_row(m.reduction_factor), part(m.misalignment), part(m.seats), part(m.dynamics),
      part(m.steady_state), part(m.exchange), part(m.run_up), apart(m.gear_set), apart(m.uneven_planets),
      apart(m.carrier_mounting), apart(m.rated),
      input(m.mesh_variation, "gearset.mesh_variation",
            "the mesh stiffness varies over the mesh period and excites gears and planet bearings; false: "
            "constant mean stiffness",
            {.reason = "nothing left out; several sets always give mean forces"}),
      input(m.cage_positions, "numerics.cage_positions",
            "number of positions of the roller set over one roller pitch for the mean",
            {.range = {1, 10000},
             .reason = "evenly over one pitch, so that the position of the rollers averages out",
             .numerical = true}));
}

/// Values that follow from the parameters and do not depend on power and speed.
struct DrivetrainGeometry {
  gearset::WorkingGeometry gears;
  gearset::PlanetBody planet_gear;
  bearing::BearingGeometry bearing;
  bearing::rating::BearingRating rating;
  double planet_mass = 0.0;  // [kg]  gear body and the outer rings of its bearings
  double rim_over_module =
      std::numeric_limits<double>::quiet_NaN();  // [-]  of a planet, between roots and bore, normal modules
  std::shared_ptr<const gearset::rim::RimInfluence> rim;  // none: rigid
};

/// Throws std::domain_error where the gears have no common centre distance or the planet no rim.
DrivetrainGeometry derive(const PlanetaryDrivetrain& drivetrain);

/// Speeds and torques of the members, whether the set is single or one of several: of the dynamics and the
/// static equilibrium of the set's gears. In an arrangement all torques are stated, and none follows from the
/// power.
/// @throws std::invalid_argument as gearset::mean_loads()
gearset::dynamics::Operation set_operation(const PlanetaryDrivetrain& drivetrain,
                                           const gearset::WorkingGeometry& gears);

/// The clearance of the bearing at the drivetrain's speed, from the shelf on.
bearing::ClearanceChain clearance_chain(const PlanetaryDrivetrain& drivetrain);

/// Gives the bearing the clearance that it has at the drivetrain's speed, where that follows from its
/// mounting. To be called whenever speed or position in an arrangement have changed; geometry is to be
/// derived after it.
void mount(PlanetaryDrivetrain& drivetrain);

/// Another speed of the input [rad/s], with the clearance and geometry that it brings.
void turn_at(double speed, PlanetaryDrivetrain& drivetrain, DrivetrainGeometry& geometry);

/// Elastic outer race of one bearing with equal loads of all bearings of its planet and mean forces of both
/// meshes; rigid if the rim is.
bearing::ElasticRace outer_race(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                const gearset::MeanLoads& gears);

/// Load of the gears on the bore of one bearing and what belongs to it.
struct BearingDuty {
  gearset::MeanLoads gears;
  bearing::OperatingPoint point;  // bore_load: both meshes and the planet's inertia, shared by its bearings
  int planet = 0;                 // [-]  whose, counted from 0
  double share = 1.0;             // [-]  of its planet's load, over the mean of that planet's bearings
  /// Couple of both gears of a stepped planet and their inertia, about the middle of the planet: leans its
  /// axis outward and ahead at positive z. [N m]
  Eigen::Vector2d couple = Eigen::Vector2d::Zero();
  /// Known equilibria of the bearing under nearly that load.
  std::shared_ptr<const bearing::vectorised::PitchResults> near{};
};

/// Film, inertia and cage angles of the quasi-static bearing.
bearing::QuasiStaticOptions quasi_static_options(const PlanetaryDrivetrain& drivetrain);

/// Parameters of the bearing's motion in time, for any drive: no excitation of the meshes, no run-up.
bearing::motion::DynamicsParameters bearing_dynamics(const PlanetaryDrivetrain& drivetrain,
                                                     const DrivetrainGeometry& geometry);

/// The same of the bearing of one planet, with gravity at the position of the planet on its carrier.
bearing::motion::DynamicsParameters bearing_dynamics_of(const BearingDuty& duty,
                                                        const PlanetaryDrivetrain& drivetrain,
                                                        const DrivetrainGeometry& geometry);

/// Inclination of the bore's axis against the pin's [rad], (x, y): the planet's tilt along `load` [N], the
/// wind-up along y.
Eigen::Vector2d bore_tilt(const Misalignment& misalignment, const Eigen::Vector2d& load);

/// Duty of one planet bearing at the drivetrain's power and speed. Throws std::invalid_argument where power
/// or speed is not positive.
BearingDuty bearing_duty(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry);

}  // namespace orbearing::analysis
