#include "app/study/differentiated_life.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include "app/case/defect_case.hpp"
#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/results/result_row.hpp"
#include "app/study/computable.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/rated_oil.hpp"
#include "app/study/static_study.hpp"
#include "bearing/equilibrium/static_slopes.hpp"
#include "coupling/study/life_slopes.hpp"
#include "coupling/study/multi_stage.hpp"

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
  std::variant<equilibrium::StaticSlopes, equilibrium::MovingBallSlopes> slopes;
  rating::LifeGradient gradient;

  Eigen::VectorXd balance_numbers(const ResolvedCase& in, const bearing::Bearing& b) const {
    if (const auto* moving = std::get_if<equilibrium::MovingBallSlopes>(&slopes))
      return moving->numbers(b, row_motion_of(in), ring_load_of(in));
    return std::get<equilibrium::StaticSlopes>(slopes).numbers(b, ring_load_of(in));
  }
  equilibrium::ElementSlopes along(const Eigen::Ref<const Eigen::VectorXd>& change) const {
    return std::visit([&](const auto& one) { return one.along(change); }, slopes);
  }
  double slope(const Eigen::VectorXd& change) const {
    const equilibrium::ElementSlopes loads = along(change.tail(change.size() - 2));
    double sum = gradient.by_inner_capacity * change[0] + gradient.by_outer_capacity * change[1];
    if (loads.laminae.size() > 0) return sum + ((gradient.inner + gradient.outer) * loads.laminae).sum();
    const Eigen::ArrayXd& outer = loads.outer.size() > 0 ? loads.outer : loads.contact;
    return sum + (gradient.inner.row(0).transpose() * loads.contact).sum() +
           (gradient.outer.row(0).transpose() * outer).sum();
  }

  static Eigen::Vector2d log_capacities(const ResolvedCase& in, const bearing::Bearing& b) {
    const rating::ContactCapacities contacts = rating::ratings_of(b, stated_ratings_of(in)).contacts;
    return {std::log(contacts.inner), std::log(contacts.outer)};
  }
};

DifferentiatedLife life_of_static_bearing(const ResolvedCase& in) {
  const bearing::Bearing b = bearing_of(in);
  const equilibrium::RingLoad load = ring_load_of(in);
  const equilibrium::RowMotion motion = row_motion_of(in);
  const equilibrium::RingState state = equilibrium::balance_bearing(b, motion, load);
  if (!state.report.converged) throw ComputationFailed(in.text("name") + ": " + state.report.message);
  const bool moving = !b.has_rollers() && motion.moves_balls();
  const rating::ElementLoads inner{state.contact_load, state.lamina_load};
  const rating::ElementLoads outer{moving ? state.outer_load : state.contact_load, state.lamina_load};
  const rating::LifeGradient gradient =
      rating::reference_life_gradient(b, rating::ratings_of(b, stated_ratings_of(in)).contacts, inner, outer);
  const auto life = std::make_shared<const StaticLife>(
      moving ? StaticLife{equilibrium::MovingBallSlopes(b, motion, load, state), gradient}
             : StaticLife{equilibrium::StaticSlopes(b, load, state), gradient});
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
                const Eigen::VectorXd balance = life->balance_numbers(changed, other);
                Eigen::VectorXd all(balance.size() + 2);
                all << StaticLife::log_capacities(changed, other), balance;
                return all;
              },
          .slope = [life](const Eigen::VectorXd& change) { return life->slope(change); }};
}

// Of any other life: ln of the life is the one number, whose slopes by the inputs come by differences of the whole
// analysis, with an estimate of their error.
DifferentiatedLife by_differences(const ResolvedCase& in, std::string quantity, std::string unit,
                                  use::Analysis analysis,
                                  const std::function<double(const ResolvedCase&)>& life) {
  const double value = life(in);
  if (!(value > 0.0) || !std::isfinite(value))
    refuse_life(in, "life.method", in.choice("life.method") + ", by which there is no " + quantity + " here",
                "a case with that life, or lundberg-palmgren");
  return {.quantity = std::move(quantity),
          .unit = std::move(unit),
          .value = value,
          .of_set = "",
          .analysis = analysis,
          .numbers = [life](const ResolvedCase& changed) -> Eigen::VectorXd {
            return Eigen::VectorXd::Constant(1, std::log(life(changed)));
          },
          .slope = [](const Eigen::VectorXd& change) { return change[0]; }};
}

double value_in_table(const std::string& name, const study::PointResult& result) {
  const std::vector<Column>& columns = trailing_columns();
  const auto column =
      std::find_if(columns.begin(), columns.end(), [&](const Column& one) { return one.name == name; });
  return column->per_unit * column->value(result);
}

DifferentiatedLife rated_life(const ResolvedCase& in, const std::string& key) {
  require_computable(in, "quasi-static", false);
  return by_differences(in, key, "h", use::quasi_static, [key](const ResolvedCase& changed) {
    return value_in_table(key, study::evaluate(bearing_sets(changed)));
  });
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
  const std::string key = life_to_go_by(in);
  return key == "life_h" ? life_of_drivetrain(in) : rated_life(in, key);
}

}  // namespace orbearing::app
