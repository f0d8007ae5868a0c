#include "app/study/static_result.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/units.hpp"
#include "bearing/contact/line_law.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/rollers.hpp"
#include "bearing/equilibrium/static_bearing.hpp"
#include "bearing/life/reference_life.hpp"
#include "bearing/life/roller_capacity.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;
namespace rating = bearing::rating;
namespace equilibrium = bearing::equilibrium;

struct StepsOf {
  const bearing::Bearing& bearing;
  const rating::Ratings& ratings;
  const equilibrium::RingState& state;
  StaticSteps& steps;

  void operator()(const equilibrium::RollerRow& row) const {
    const equilibrium::RingPlace place = equilibrium::place_of(state, row.lever());
    const auto& contact = row.contact();
    const int laminae = contact.laminae();
    RollerSteps rollers{.constant = contact.constant(),
                        .lamina_place = row.lever() * contact.places(),
                        .drop = contact.drops(),
                        .tilt = steps.angle,
                        .stress_riser = rating::stress_riser(laminae),
                        .inner_lamina_capacity = rating::lamina_capacity(ratings.contacts.inner, laminae),
                        .outer_lamina_capacity = rating::lamina_capacity(ratings.contacts.outer, laminae)};
    for (Eigen::Index j = 0; j < steps.angle.size(); ++j) {
      const Eigen::Vector2d at = row.coordinates(j, place);
      steps.approach[j] = at[0];
      rollers.tilt[j] = -std::atan(at[1] / row.lever());
    }
    const Eigen::ArrayXXd felt = rating::with_stress_riser(state.lamina_load);
    steps.inner_equivalent = rating::equivalent_lamina_loads(felt, bearing.motions.inner);
    steps.outer_equivalent = rating::equivalent_lamina_loads(felt, bearing.motions.outer);
    steps.rollers = std::move(rollers);
  }

  void operator()(const equilibrium::BallRow& row) const {
    const equilibrium::RingPlace place = equilibrium::place_of(state, row.lever());
    for (Eigen::Index j = 0; j < steps.angle.size(); ++j) steps.approach[j] = row.place_of(j, place).approach;
    const auto equivalent = [&](bearing::RaceMotion motion) {
      return Eigen::ArrayXd::Constant(1, rating::equivalent_ball_load(state.contact_load, motion)).eval();
    };
    steps.inner_equivalent = equivalent(bearing.motions.inner);
    steps.outer_equivalent = equivalent(bearing.motions.outer);
    steps.balls = BallSteps{.inner = row.contact(bearing::Race::inner),
                            .outer = row.contact(bearing::Race::outer),
                            .constant = row.constant(),
                            .groove_distance = row.groove_distance(),
                            .tilt_radius = row.lever(),
                            .free_angle = row.free_angle()};
  }
};

Json numbers(const Eigen::ArrayXd& values, double unit = 1.0) {
  Json list = Json::array();
  for (const double value : values) list.push_back(unit * value);
  return list;
}

Json race_json(const bearing::PointContact& contact) {
  return {{"curvature_sum_per_mm", contact.curvature.sum / kMilli},
          {"curvature_difference", contact.curvature.difference},
          {"axis_ratio", contact.ellipse.axis_ratio},
          {"elliptic_K", contact.ellipse.first},
          {"elliptic_E", contact.ellipse.second}};
}

void add(const RollerSteps& rollers, Json& object) {
  object["c_L_N_per_mm_10_9"] = rollers.constant * std::pow(kMilli, -bearing::kLineExponent);
  object["lamina_places_mm"] = numbers(rollers.lamina_place, kMilli);
  object["drops_um"] = numbers(rollers.drop, kMicro);
  object["element_tilts_mrad"] = numbers(rollers.tilt, kMilli);
  object["stress_riser"] = numbers(rollers.stress_riser);
  object["lamina_capacities_N"] = {{"inner", rollers.inner_lamina_capacity},
                                   {"outer", rollers.outer_lamina_capacity}};
}

void add(const BallSteps& balls, Json& object) {
  object["inner_contact"] = race_json(balls.inner);
  object["outer_contact"] = race_json(balls.outer);
  object["c_P_N_per_mm_3_2"] = balls.constant * std::pow(kMilli, -1.5);
  object["groove_distance_mm"] = kMilli * balls.groove_distance;
  object["tilt_radius_mm"] = kMilli * balls.tilt_radius;
  object["free_angle_deg"] = kDegree * balls.free_angle;
}

}  // namespace

std::optional<StaticSteps> static_steps(const bearing::Bearing& bearing, const rating::Ratings& ratings,
                                        const equilibrium::RingState& state) {
  if (state.outer_load.size() > 0) return {};
  StaticSteps steps{.gamma = ratings.gamma,
                    .radial = state.radial,
                    .lateral = state.lateral,
                    .axial = state.axial,
                    .tilt = state.tilt,
                    .lateral_tilt = state.lateral_tilt,
                    .lateral_moment = state.lateral_moment,
                    .angle = equilibrium::element_angles(bearing),
                    .approach = Eigen::ArrayXd::Zero(bearing.element_count())};
  std::visit(StepsOf{bearing, ratings, state, steps}, equilibrium::row_of(bearing));
  return steps;
}

Json steps_json(const StaticSteps& steps) {
  Json object{{"gamma", steps.gamma}};
  if (steps.rollers) add(*steps.rollers, object);
  if (steps.balls) add(*steps.balls, object);
  object["ring"] = {{"radial_um", kMicro * steps.radial},
                    {"lateral_um", kMicro * steps.lateral},
                    {"axial_um", kMicro * steps.axial},
                    {"tilt_mrad", kMilli * steps.tilt},
                    {"lateral_tilt_mrad", kMilli * steps.lateral_tilt},
                    {"moment_across_N_m", steps.lateral_moment}};
  object["element_angles_deg"] = numbers(steps.angle, kDegree);
  object["approaches_um"] = numbers(steps.approach, kMicro);
  object["equivalent_loads_N"] = {{"inner", numbers(steps.inner_equivalent)},
                                  {"outer", numbers(steps.outer_equivalent)}};
  return object;
}

}  // namespace orbearing::app
