// A bearing in a housing under a load of its own, the models roller-bearing and ball-bearing: inputs by the
// analyses that take them, and what follows from the inputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bearing/catalogue/catalogue_bearing.hpp"
#include "bearing/equilibrium/jones_balls.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/film/graded_oil.hpp"
#include "bearing/friction/published_torque.hpp"
#include "bearing/life/rating_lives.hpp"
#include "bearing/motion/parameters.hpp"
#include "coupling/analysis/bearing_rows.hpp"
#include "coupling/analysis/stated_capacities.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/heated_balls.hpp"
#include "mechanics/conditional.hpp"
#include "mechanics/no_result.hpp"
#include "mechanics/part_rows.hpp"
#include "mechanics/problem.hpp"

namespace orbearing::analysis {

using mechanics::NoResult;

/// Speeds of the rings, and which of them rotates relative to the load.
struct RingRotation {
  double shaft_speed = 0.0;  // [rad/s]  of the inner ring
  double outer_speed = 0.0;  // [rad/s]
  bearing::Race turning_race = bearing::Race::inner;

  double relative() const { return shaft_speed - outer_speed; }  // [rad/s]
  bearing::equilibrium::RingSpeeds speeds() const { return {shaft_speed, outer_speed}; }
};
template <class Visitor>
void describe(Visitor& visit, RingRotation& m) {
  using namespace described;
  const auto speed = [](double& member, const char* key, const char* meaning) {
    return input(
        member, key, meaning,
        {.dimension = dimension::angular_speed, .range = {-1e6, 1e6}, .reason = "a stationary ring"});
  };
  members(visit, m, speed(m.shaft_speed, "operation.shaft_speed", "speed of the inner ring"),
          speed(m.outer_speed, "operation.outer_speed", "speed of the outer ring"),
          input(m.turning_race, "operation.turning_race", "race that rotates relative to the load",
                {.reason = "a stationary load on a rotating shaft"}));
}

inline auto speeds_row(std::vector<double>& speeds) {
  using namespace described;
  return input(
      speeds, "operation.speeds",
      "speeds of the inner ring over which run and stiffness tabulate the equilibrium, and modes and "
      "run of a duplex pair its natural frequencies",
      {.dimension = dimension::angular_speed, .range = {-1e6, 1e6}});
}

/// How lives are computed, and cleanliness of the oil.
struct LifeInputs {
  bearing::rating::LifeMethod method = bearing::rating::LifeMethod::lundberg_palmgren;
  double reliability = 0.9;                      // [-]
  std::optional<double> viscosity_ratio;         // [-]  kappa
  std::optional<double> contamination_factor{};  // [-]  e_C
  bearing::rating::Lubrication lubrication = bearing::rating::Lubrication::circulating_oil;
  std::optional<bearing::rating::Cleanliness> cleanliness{};
};
template <class Visitor>
void describe(Visitor& visit, LifeInputs& m) {
  using namespace described;
  members(
      visit, m,
      input(m.method, "life.method",
            "governing life, by which requirements, peaks, spectra, crowns and sensitivities go. "
            "lundberg-palmgren: life_h; iso-281: L10mh where the oil is stated, else L10h; iso-16281: L10mrh "
            "where the oil is stated, else L10rh. crown uses life_h with iso-281, whose life is that of all "
            "crowns",
            {.reason = "neither the rating C nor a requirement is stated"}),
      input(m.reliability, "life.reliability", "reliability: share of bearings that reach the life",
            {.range = {.least = 0.0, .most = 1.0, .least_allowed = false, .most_allowed = false},
             .reason = "rating lives are those of 90 %"}),
      input(m.viscosity_ratio, "life.viscosity_ratio",
            "viscosity ratio kappa of ISO 281; with it the life includes a_ISO", {.range = {0.1, 1000.0}}),
      input(m.contamination_factor, "life.contamination_factor", "e_C of ISO 281", {.range = {0.0, 1.0}}),
      input(m.lubrication, "life.lubrication", "kind of lubrication, for the contamination factor",
            {.reason = "oil with a filter in its line"}),
      input(m.cleanliness, "life.cleanliness",
            "level of cleanliness, or its ISO 4406 code for filtered oil, instead of the contamination "
            "factor"));
}

/// Additional inputs for rollers.
struct RollerLifeInputs {
  double reduction_factor = bearing::rating::RollerSet{}.reduction_factor;  // [-]  of the capacities
  bearing::rating::StressRiser stress_riser = bearing::rating::StressRiser::position;
};
template <class Visitor>
void describe(Visitor& visit, RollerLifeInputs& m) {
  using namespace described;
  members(visit, m, system::reduction_factor_row(m.reduction_factor),
          input(m.stress_riser, "life.stress_riser",
                "stress at the ends of rollers in L10rh and L10mrh. position: a function of the position "
                "along the roller, equal to the formula of ISO/TS 16281 for 30 laminae; standard: its "
                "formula for the laminae of the case, on whose number lives of straight rollers then depend",
                {.reason = "lives do not depend on the number of laminae"}));
}

/// A level of cleanliness that does not fit how the bearing is lubricated, or that is stated twice.
mechanics::Problems problems(const LifeInputs& life);

/// The oil of a bearing, for films, friction and kappa.
struct BearingOil {
  bearing::GradedOil stated;                              // by its grade; else as below
  std::optional<double> kinematic_viscosity;              // [m^2/s]  at running temperature
  bearing::Lubricant lubricant = bearing::warm_gear_oil;  // of the grade, or as stated with its own rows
};
template <class Visitor>
void describe(Visitor& visit, BearingOil& m) {
  using namespace described;
  members(visit, m, part(m.stated),
          input(m.kinematic_viscosity, "lubricant.kinematic_viscosity",
                "kinematic viscosity at running temperature, instead of kappa",
                {.dimension = dimension::kinematic_viscosity, .range = positive(1e6)}),
          internal(m.lubricant, "lubricant"));
}

/// Inputs of all runs of a bearing under a load of its own.
struct LoadedBearing {
  bearing::equilibrium::RingLoad load;
  RingRotation rotation;
  bearing::catalogue::CatalogueBearing catalogue;
  bearing::Bearing bearing;
  bearing::profile::StatedProfile profile;  // of rollers; none: that of `bearing`
  StatedCapacities capacities;
  LifeInputs life;
  BearingOil oil;
  std::optional<bearing::friction::BearingSize> size;  // boundary dimensions, without C_0; none: not known
};
/// Rollers take no axial load.
template <class Visitor>
void describe_on_rollers(Visitor& visit, bearing::equilibrium::RingLoad& m) {
  describe_without(visit, m, m.axial);
}

/// Without boundary dimensions and cage.
template <class Visitor>
void describe(Visitor& visit, LoadedBearing& m) {
  using namespace described;
  members(visit, m,
          part(m.load,
               [&] {
                 if (m.bearing.has_rollers())
                   describe_on_rollers(visit, m.load);
                 else
                   describe(visit, m.load);
               }),
          part(m.rotation), part(m.catalogue), part(m.bearing, [&] { describe_inside(visit, m.bearing); }),
          part(m.profile,
               [&] {
                 if (m.bearing.has_rollers()) describe(visit, m.profile);
               }),
          part(m.capacities), part(m.life), part(m.oil), internal(m.size, "bearing.size"));
}

/// Laminae of rollers where a case states none: at rest they are always cut.
inline constexpr int default_laminae = bearing::rating::kLeastRatedLaminae;

/// Oil between the rollers of a bearing, and the heat that it takes along.
struct RollerOil {
  double share = bearing::motion::OilDragParameters{}.oil_share;  // [-]  of the free volume
  double flow = 0.0;                                              // [m^3/s]
  bearing::motion::Starvation starvation = bearing::motion::Starvation::none;
  bool heated = false;  // the oil has the temperature at which it leaves with all heat
  system::HeatModel model = system::HeatModel::network;
  double inlet = system::HeatParameters{}.inlet;  // [degC]
};
template <class Visitor>
void describe(Visitor& visit, RollerOil& m) {
  using namespace bearing;
  described::members(visit, m, motion::oil_share_row(m.share), balls::oil_flow_row(m.flow),
                     motion::starvation_row(m.starvation), system::heat_enabled_row(m.heated),
                     system::heat_model_row(m.model), system::heat_inlet_row(m.inlet));
}

/// Inputs of the run of a roller bearing, at rest.
struct RollersUnderLoad {
  LoadedBearing loaded{.bearing = {.elements = bearing::CylindricalRollers{.laminae = default_laminae}}};
  RollerLifeInputs life;
  RollerOil oil;

  static std::vector<mechanics::Conditional<RollersUnderLoad>> conditions();
};
template <class Visitor>
void describe(Visitor& visit, RollersUnderLoad& m) {
  using namespace described;
  members(visit, m,
          part(m.loaded,
               [&] {
                 describe(visit, m.loaded);
                 describe_dimensions(visit, m.loaded.bearing);
               }),
          part(m.life), part(m.oil));
}

/// Effects of the motion of balls on their equilibrium.
struct BallsOnRaces {
  bearing::equilibrium::BallInertia inertia;
  bool film = false;  // takes part in the approach
};
template <class Visitor>
void describe(Visitor& visit, BallsOnRaces& m) {
  described::members(visit, m, described::part(m.inertia), bearing::motion::film_row(m.film));
}

/// Inputs of the run of a ball bearing at rest.
struct BallsUnderLoad {
  LoadedBearing loaded{.bearing = {.elements = bearing::Balls{}}};
  BallsOnRaces balls;
  std::vector<double> speeds;  // [rad/s]  of the inner ring, over which its equilibrium is tabulated

  static std::vector<mechanics::Conditional<BallsUnderLoad>> conditions();
};
template <class Visitor>
void describe(Visitor& visit, BallsUnderLoad& m) {
  using namespace described;
  members(visit, m,
          part(m.loaded,
               [&] {
                 describe(visit, m.loaded);
                 describe_dimensions(visit, m.loaded.bearing);
                 describe(visit, m.loaded.oil.lubricant);
               }),
          part(m.balls), speeds_row(m.speeds));
}

/// Motion of the balls and the cage in time.
struct BallSimulation {
  double shaft_acceleration = 0.0;  // [rad/s^2]  from rest up to the speed; 0: that speed from the start on
  bearing::balls::MotionParameters motion;
  system::BallRunOptions options;
  system::HeatParameters heat;
};
template <class Visitor>
void describe(Visitor& visit, BallSimulation& m) {
  using namespace described;
  members(
      visit, m,
      input(m.shaft_acceleration, "operation.shaft_acceleration",
            "acceleration of the inner ring from rest up to its speed; 0: that speed from the start on",
            {.dimension = dimension::angular_acceleration, .range = {0.0, 1e9}, .reason = "steady speed"}),
      part(m.motion), part(m.options), part(m.heat));
}

/// Inputs of the run of a ball bearing in time: the machine of the model ball-bearing with a block
/// `simulation`.
struct BallsInTime {
  LoadedBearing loaded{.bearing = {.elements = bearing::Balls{}}};
  BallSimulation simulation;

  static std::vector<mechanics::Conditional<BallsInTime>> conditions();
  /// Inputs that would change the motion and cannot be included.
  static std::vector<std::string> refused();
};
inline const bearing::balls::MotionParameters& moving_balls(const BallsInTime& in) {
  return in.simulation.motion;
}
template <class Visitor>
void describe(Visitor& visit, BallsInTime& m) {
  using namespace described;
  members(visit, m,
          part(m.loaded,
               [&] {
                 describe(visit, m.loaded);
                 describe_dimensions(visit, m.loaded.bearing);
                 describe(visit, m.loaded.bearing.cage);
               }),
          part(m.simulation));
}

inline auto load_factors_row(std::vector<double>& factors) {
  using namespace described;
  return input(factors, "operation.load_factors",
               "factors of the whole load at which stiffness is given; left out: 1",
               {.range = positive(1e6)});
}

/// Inputs of the stiffness of a roller bearing.
struct RollerSupport {
  bearing::equilibrium::RingLoad load;
  bearing::Bearing bearing{.elements = bearing::CylindricalRollers{.laminae = default_laminae}};
  bearing::profile::StatedProfile profile;  // none: that of `bearing`
  std::vector<double> load_factors;         // [-]  none: 1
};
template <class Visitor>
void describe(Visitor& visit, RollerSupport& m) {
  using namespace described;
  members(visit, m, part(m.load, [&] { describe_on_rollers(visit, m.load); }),
          part(m.bearing, [&] { describe_inside(visit, m.bearing, m.bearing.material.density); }),
          part(m.profile), load_factors_row(m.load_factors));
}

/// Inputs of the stiffness of a ball bearing.
struct BallSupport {
  bearing::equilibrium::RingLoad load;
  RingRotation rotation;
  bearing::Bearing bearing{.elements = bearing::Balls{}};
  BallsOnRaces balls;
  BearingOil oil;
  std::vector<double> speeds;        // [rad/s]  of the inner ring; none: its own
  std::vector<double> load_factors;  // [-]  none: 1

  static std::vector<mechanics::Conditional<BallSupport>> conditions();
};
template <class Visitor>
void describe(Visitor& visit, BallSupport& m) {
  using namespace described;
  members(visit, m, part(m.load),
          part(m.rotation, [&] { describe_without(visit, m.rotation, m.rotation.turning_race); }),
          part(m.bearing, [&] { describe_inside(visit, m.bearing); }), part(m.balls),
          part(m.oil,
               [&] {
                 describe_without(visit, m.oil, m.oil.kinematic_viscosity);
                 describe(visit, m.oil.lubricant);
               }),
          speeds_row(m.speeds), load_factors_row(m.load_factors));
}

/// Inputs of rollers in motion and of their films, which a case may state and no analysis at rest includes.
struct MotionOfRollers {
  bearing::Cage cage;
  double guide_land = 0.0;  // [m]  diameter
  bearing::Lubricant lubricant = bearing::warm_gear_oil;
};
template <class Visitor>
void describe(Visitor& visit, MotionOfRollers& m) {
  using namespace described;
  members(visit, m,
          part(m.cage,
               [&] {
                 mechanics::RowsNotRequired<Visitor> rows(visit);
                 describe_without(rows, m.cage, m.cage.guidance);
               }),
          bearing::motion::guide_land_row(m.guide_land), part(m.lubricant));
}

/// The machine of the model roller-bearing.
struct RollerBearing {
  RollersUnderLoad run;
  std::vector<double> load_factors;  // [-]  of its stiffness
  MotionOfRollers motion;
};
template <class Visitor>
void describe(Visitor& visit, RollerBearing& m) {
  using namespace described;
  members(visit, m, part(m.run), load_factors_row(m.load_factors), part(m.motion));
}

/// The machine of the model ball-bearing.
struct BallBearing {
  BallsUnderLoad run;
  std::vector<double> load_factors;  // [-]  of its stiffness
};
template <class Visitor>
void describe(Visitor& visit, BallBearing& m) {
  described::members(visit, m, described::part(m.run), load_factors_row(m.load_factors));
}

/// Inconsistencies of the whole machine.
mechanics::Problems problems(const BallsInTime& machine);

// Parts of machines whose inconsistencies are found without the other inputs.

/// Oil and heat of rollers at rest.
struct OilOfRollers {
  RollerOil oil;
  std::optional<bearing::friction::BearingSize> size;
};
template <class Visitor>
void describe(Visitor& visit, OilOfRollers& m) {
  described::members(visit, m, described::part(m.oil), described::internal(m.size, "bearing.size"));
}
mechanics::Problems problems(const OilOfRollers& machine);

/// The load on an inner ring.
struct LoadOnRing {
  bearing::equilibrium::RingLoad load;
};
template <class Visitor>
void describe(Visitor& visit, LoadOnRing& m) {
  using namespace described;
  members(visit, m, part(m.load));
}
mechanics::Problems problems(const LoadOnRing& machine);

/// The same on rollers, whose laminae hold the moment.
struct LoadOnRollers {
  bearing::equilibrium::RingLoad load;
  int laminae = default_laminae;
};
template <class Visitor>
void describe(Visitor& visit, LoadOnRollers& m) {
  using namespace described;
  members(visit, m, part(m.load, [&] { describe_on_rollers(visit, m.load); }),
          bearing::laminae_row(m.laminae));
}
mechanics::Problems problems(const LoadOnRollers& machine);

/// How the oil of lives is stated.
struct OilOfLife {
  LifeInputs life;
  BearingOil oil;
};
template <class Visitor>
void describe(Visitor& visit, OilOfLife& m) {
  described::members(visit, m, described::part(m.life), described::part(m.oil));
}
mechanics::Problems problems(const OilOfLife& machine);

/// The viscosity ratio of that oil.
struct ViscosityRatio {
  RingRotation rotation;
  double pitch_diameter = 0.0;  // [m]
  OilOfLife oil;
};
template <class Visitor>
void describe(Visitor& visit, ViscosityRatio& m) {
  using namespace described;
  members(visit, m, part(m.rotation), bearing::pitch_diameter_row(m.pitch_diameter), part(m.oil));
}
mechanics::Problems problems(const ViscosityRatio& machine);

// Parameters of the analyses, which follow from these inputs.

/// The bearing with its motion relative to the load.
bearing::Bearing rotating_bearing(const LoadedBearing& in);
/// Motion of a row of balls, and its film where that takes part.
bearing::equilibrium::RowMotion row_motion(const RingRotation& rotation, const BallsOnRaces& balls,
                                           const bearing::Lubricant& lubricant);

bearing::rating::StatedRatings stated_ratings(const RollersUnderLoad& in);

/// None where neither oil nor cleanliness is stated: then lives have no a_ISO.
std::optional<bearing::rating::StatedOil> stated_oil(const LoadedBearing& in);
/// P, P_0, oil and a_1. Throws std::invalid_argument where kappa is below the range of a_ISO.
bearing::rating::RatingCondition rating_condition(const LoadedBearing& in);
bearing::rating::Life governing_life(const LoadedBearing& in);

/// Equilibrium of a bearing under its load. Throws NoResult where there is none.
bearing::equilibrium::RingState balanced(const bearing::Bearing& bearing,
                                         const bearing::equilibrium::RowMotion& motion,
                                         const bearing::equilibrium::RingLoad& load);

}  // namespace orbearing::analysis
