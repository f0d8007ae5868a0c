#include "app/study/static_result.hpp"

#include <cmath>
#include <variant>

#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/rollers.hpp"
#include "bearing/equilibrium/static_bearing.hpp"
#include "bearing/life/reference_life.hpp"
#include "bearing/life/roller_capacity.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;
namespace equilibrium = bearing::equilibrium;

struct StepsOf {
  const bearing::Bearing& bearing;
  const rating::Ratings& ratings;
  const equilibrium::RingState& state;
  StaticSteps& steps;

  void operator()(const equilibrium::RollerRow& row) const {
    const equilibrium::RingPosition position = equilibrium::position_of(state, row.lever());
    const auto& contact = row.contact();
    const int laminae = contact.laminae();
    RollerSteps rollers{.constant = contact.constant(),
                        .lamina_position = row.lever() * contact.positions(),
                        .drop = contact.drops(),
                        .tilt = steps.angle,
                        .stress_riser = rating::stress_riser(laminae),
                        .inner_lamina_capacity = rating::lamina_capacity(ratings.contacts.inner, laminae),
                        .outer_lamina_capacity = rating::lamina_capacity(ratings.contacts.outer, laminae)};
    for (Eigen::Index j = 0; j < steps.angle.size(); ++j) {
      const Eigen::Vector2d at = row.coordinates(j, position);
      steps.approach[j] = at[0];
      rollers.tilt[j] = -std::atan(at[1] / row.lever());
    }
    const Eigen::ArrayXXd felt = rating::with_stress_riser(state.lamina_load);
    steps.inner_equivalent = rating::equivalent_lamina_loads(felt, bearing.motions.inner);
    steps.outer_equivalent = rating::equivalent_lamina_loads(felt, bearing.motions.outer);
    steps.rollers = std::move(rollers);
  }

  void operator()(const equilibrium::BallRow& row) const {
    const equilibrium::RingPosition position = equilibrium::position_of(state, row.lever());
    for (Eigen::Index j = 0; j < steps.angle.size(); ++j)
      steps.approach[j] = row.position_of(j, position).approach;
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

}  // namespace orbearing::app
