#include "app/study/differentiated_life.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "app/case/defect_case.hpp"
#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/study/computable.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/static_study.hpp"
#include "bearing/equilibrium/static_slopes.hpp"
#include "coupling/study/life_slopes.hpp"

namespace orbearing::app {

namespace {

namespace rating = bearing::rating;
namespace equilibrium = bearing::equilibrium;

[[noreturn]] void refuse_life(const ResolvedCase& in, const std::string& path, const std::string& found,
                              const std::string& required) {
  throw BadInput(in.origin(path) + ": " + path + ": found " + found + "; required: " + required);
}

const study::NamedSet& life_set(const std::vector<study::NamedSet>& sets, const std::string& name) {
  return *std::find_if(sets.begin(), sets.end(),
                       [&](const study::NamedSet& set) { return set.name == name; });
}

DifferentiatedLife life_of_drivetrain(const ResolvedCase& in) {
  require_computable(in, "quasi-static", false);
  std::shared_ptr<const study::LifeSlopes> shortest;
  std::string of_set;
  for (const study::NamedSet& set : bearing_sets(in)) {
    if (set.drivetrain.uneven_planets)
      throw BadInput(
          in.file() +
          ": gearset: found planets that load unevenly; required: pins in their places, since the balance "
          "of gears that shares their loads is not differentiated");
    const auto one = std::make_shared<const study::LifeSlopes>(set.drivetrain, set.geometry);
    if (shortest && shortest->log_life() <= one->log_life()) continue;
    shortest = one;
    of_set = set.name;
  }
  return {.quantity = "life_h",
          .unit = "h",
          .value = std::exp(shortest->log_life()),
          .of_set = of_set,
          .analysis = use::quasi_static,
          .numbers =
              [shortest, of_set](const ResolvedCase& changed) {
                const std::vector<study::NamedSet> sets = bearing_sets(changed);
                const study::NamedSet& set = life_set(sets, of_set);
                return shortest->numbers(set.drivetrain, set.geometry);
              },
          .slope = [shortest](const Eigen::VectorXd& change) { return shortest->slope(change); }};
}

// A single bearing. Its numbers: ln of both capacities, then those behind the loads of its elements.
struct StaticLife {
  equilibrium::StaticSlopes slopes;
  rating::LifeGradient gradient;

  static Eigen::Vector2d log_capacities(const ResolvedCase& in, const bearing::Bearing& b) {
    const rating::ContactCapacities contacts = rating::ratings_of(b, stated_ratings_of(in)).contacts;
    return {std::log(contacts.inner), std::log(contacts.outer)};
  }
};

DifferentiatedLife life_of_static_bearing(const ResolvedCase& in) {
  const bearing::Bearing b = bearing_of(in);
  const equilibrium::RingLoad load = ring_load_of(in);
  if (!b.has_rollers() && row_motion_of(in).moves_balls())
    refuse_life(in, "operation.shaft_speed", in.given("operation.shaft_speed"),
                "rings at rest, or equilibrium.ball_inertia: false; the balance of balls that feel their "
                "motion is not "
                "differentiated");
  const equilibrium::RingState state = equilibrium::balance_bearing(b, load);
  if (!state.report.converged) throw ComputationFailed(in.text("name") + ": " + state.report.message);
  const rating::ElementLoads loads{state.contact_load, state.lamina_load};
  const auto life = std::make_shared<const StaticLife>(
      StaticLife{{b, load, state},
                 rating::reference_life_gradient(b, rating::ratings_of(b, stated_ratings_of(in)).contacts,
                                                 loads, loads)});
  if (!std::isfinite(life->gradient.life.bearing))
    throw ComputationFailed(in.text("name") + ": nothing is loaded; the life is without end");
  return {.quantity = "L10r_Mrev",
          .unit = "Mrev",
          .value = 1e-6 * life->gradient.life.bearing,
          .of_set = "",
          .analysis = use::static_load,
          .numbers =
              [life](const ResolvedCase& changed) {
                const bearing::Bearing other = bearing_of(changed);
                const Eigen::VectorXd balance = life->slopes.numbers(other, ring_load_of(changed));
                Eigen::VectorXd all(balance.size() + 2);
                all << StaticLife::log_capacities(changed, other), balance;
                return all;
              },
          .slope =
              [life](const Eigen::VectorXd& change) {
                const equilibrium::ElementSlopes loads_change =
                    life->slopes.along(change.tail(change.size() - 2));
                const Eigen::ArrayXXd by_load = life->gradient.inner + life->gradient.outer;
                const Eigen::ArrayXXd elements = loads_change.laminae.size() > 0
                                                     ? loads_change.laminae
                                                     : Eigen::ArrayXXd(loads_change.contact.transpose());
                return (by_load * elements).sum() + life->gradient.by_inner_capacity * change[0] +
                       life->gradient.by_outer_capacity * change[1];
              }};
}

}  // namespace

DifferentiatedLife differentiated_life(const ResolvedCase& in) {
  if (is_static_bearing(in)) return life_of_static_bearing(in);
  if (in.model() != planetary_drivetrain)
    refuse_life(in, "model", in.choice("model"),
                "a case with a life at rest: planetary-drivetrain, roller-bearing, or ball-bearing without "
                "simulation");
  if (is_planet_defect(in))
    throw BadInput(in.file() +
                   ": defect: found a scratched planet bearing; required: none, for a life at rest");
  if (!in.shape().bearing || (in.shape().several && bearing_set_names(in).empty()))
    throw BadInput(in.file() + ": bearing: missing; required: a planet bearing, for its life");
  return life_of_drivetrain(in);
}

}  // namespace orbearing::app
