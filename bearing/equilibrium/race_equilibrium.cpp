#include "bearing/equilibrium/race_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/roller_balance.hpp"
#include "bearing/plane.hpp"

namespace orbearing::bearing {

namespace {

// The largest length [m] by which the races stand apart or overlap where they are concentric.
double largest_gap(const RaceEquilibrium& problem) {
  const double extra = problem.extra_approach.size() == 0 ? 0.0 : problem.extra_approach.abs().maxCoeff();
  const ElasticRace& race = problem.outer_race;
  return std::abs(problem.clearance) + 2.0 * extra + 2.0 * (race.cosine.abs().sum() + race.sine.abs().sum());
}

// How far an elastic race gives way under all loads at one place.
double wave_reach(const RaceEquilibrium& problem, double load) {
  return problem.outer_race.is_rigid() ? 0.0 : problem.outer_race.compliance.sum() * load;
}

std::string failure_text(const RaceEquilibrium& problem, double residual) {
  std::ostringstream text;
  text << "the races found no balance under " << problem.load.norm() << " N: " << residual
       << " N remain; check the clearance and the roller count";
  return text.str();
}

RollerBalance roller_at(const RaceEquilibrium& problem, Eigen::Index j, double approach) {
  return balance_roller(problem.contacts.inner, problem.contacts.outer, problem.inertial_load[j], approach);
}

template <int N>
void fill_loads(const RaceEquilibrium& problem, const RingCoordinates<N>& ring,
                const Eigen::Vector<double, N>& place, QuasiStaticState& state) {
  state.displacement = place.template head<2>();
  state.waves = place.tail(place.size() - 2);
  state.angle = problem.angle;
  state.inner_load.resize(problem.angle.size());
  state.outer_load.resize(problem.angle.size());
  for (Eigen::Index j = 0; j < problem.angle.size(); ++j) {
    const RollerBalance roller = roller_at(problem, j, ring.approach(j, place));
    state.inner_load[j] = roller.inner_load;
    state.outer_load[j] = roller.outer_load;
  }
}

template <int N>
mechanics::Imbalance<N> imbalance_at(const RaceEquilibrium& problem, const RingCoordinates<N>& ring,
                                     const Eigen::Vector<double, N>& place) {
  return ring.imbalance(place,
                        [&](Eigen::Index j, double approach) { return roller_at(problem, j, approach); });
}

template <int N>
QuasiStaticState solve_in(const RaceEquilibrium& problem, const QuasiStaticState* near) {
  const RingCoordinates<N> ring(problem);
  Eigen::Vector<double, N> place = ring.start(near ? near->displacement : first_displacement(problem));
  if (near) place.tail(near->waves.size()) = near->waves;
  mechanics::Imbalance<N> now;
  QuasiStaticState state;
  state.report = {mechanics::find_balance<N>(
      [&](const Eigen::Vector<double, N>& at) { return imbalance_at<N>(problem, ring, at); },
      search_limits(problem), place, now)};
  if (!state.report.converged) state.report.message = failure_text(problem, state.report.residual);
  fill_loads<N>(problem, ring, place, state);
  state.stiffness = without_waves<N>(now);
  return state;
}

}  // namespace

double RaceEquilibrium::approach(Eigen::Index j, const Eigen::Vector2d& displacement) const {
  const double round = -0.5 * clearance - displacement.dot(direction(angle[j]));
  return extra_approach.size() == 0 ? round : round + extra_approach[j];
}

double RaceEquilibrium::force_scale() const {
  return std::max(load.norm(), inertial_load.abs().maxCoeff());
}

mechanics::Imbalance<2> RaceEquilibrium::imbalance(const Eigen::Vector2d& displacement) const {
  return imbalance_at<2>(*this, RingCoordinates<2>(*this), displacement);
}

template <int N>
RingCoordinates<N>::RingCoordinates(const RaceEquilibrium& problem)
    : concentric_(problem.angle.size()), load_(problem.load), scale_(problem.force_scale()) {
  const Eigen::Index rollers = problem.angle.size();
  if constexpr (N == Eigen::Dynamic) {
    wave_stiffness_ = wave_stiffness(problem.outer_race);
    wave_at_rest_ = waves_at_rest(problem.outer_race);
  }
  const Eigen::Index waves = wave_stiffness_.size();
  outward_.resize(2 + waves, rollers);
  for (Eigen::Index j = 0; j < rollers; ++j) {
    outward_.col(j).template head<2>() = direction(problem.angle[j]);
    if (waves > 0) outward_.col(j).tail(waves) = wave_shapes(problem.outer_race, problem.angle[j]);
    concentric_[j] = problem.approach(j, Eigen::Vector2d::Zero());
  }
}

template <int N>
mechanics::Imbalance<N> RingCoordinates<N>::without_rollers(const Place& place) const {
  const Eigen::Index waves = wave_stiffness_.size();
  mechanics::Imbalance<N> sum;
  sum.force.setZero(size());
  sum.stiffness.setZero(size(), size());
  sum.scale = scale_;
  sum.force.template head<2>() = load_;
  sum.force.tail(waves) -= wave_stiffness_.cwiseProduct(place.tail(waves) - wave_at_rest_);
  sum.stiffness.diagonal().tail(waves) += wave_stiffness_;
  return sum;
}

template <int N>
Eigen::Vector<double, N> RingCoordinates<N>::start(const Eigen::Vector2d& displacement) const {
  Place place(size());
  place.template head<2>() = displacement;
  place.tail(wave_at_rest_.size()) = wave_at_rest_;
  return place;
}

template class RingCoordinates<2>;
template class RingCoordinates<Eigen::Dynamic>;

Eigen::Vector2d first_displacement(const RaceEquilibrium& problem) {
  const double load = problem.load.norm();
  if (load == 0.0) return Eigen::Vector2d::Zero();
  const double share = 4.0 * load / static_cast<double>(problem.angle.size());
  const double elastic = problem.contacts.inner.approach(share) + problem.contacts.outer.approach(share);
  return problem.load / load * std::max(0.5 * problem.clearance + elastic, 0.0);
}

// The contacts change over the clearance and the elastic approach under all forces at hand, for the rollers'
// inertial loads alone can outweigh the load on the ring by far.
mechanics::SearchLimits search_limits(const RaceEquilibrium& problem) {
  const double all = problem.load.norm() + problem.inertial_load.abs().sum();
  const double elastic =
      problem.contacts.inner.elastic().approach(all) + problem.contacts.outer.elastic().approach(all);
  const double gap = largest_gap(problem);
  return {.reach = std::max(gap, 1e-6) + elastic + wave_reach(problem, all), .size = gap};
}

QuasiStaticState solve(const RaceEquilibrium& problem, const QuasiStaticState* near) {
  return problem.outer_race.is_rigid() ? solve_in<2>(problem, near) : solve_in<Eigen::Dynamic>(problem, near);
}

namespace {

// Where the ring stands in a balance that was found.
Eigen::VectorXd place_of(const RingCoordinates<Eigen::Dynamic>& ring, const QuasiStaticState& state) {
  Eigen::VectorXd place(ring.size());
  place << state.displacement, state.waves;
  return place;
}

}  // namespace

Eigen::ArrayXd roller_stiffness(const RaceEquilibrium& problem, const QuasiStaticState& state) {
  const RingCoordinates<Eigen::Dynamic> ring(problem);
  const Eigen::VectorXd place = place_of(ring, state);
  Eigen::ArrayXd stiffness(problem.angle.size());
  for (Eigen::Index j = 0; j < stiffness.size(); ++j)
    stiffness[j] = roller_at(problem, j, ring.approach(j, place)).stiffness;
  return stiffness;
}

Eigen::Matrix2d stiffness_at(const RaceEquilibrium& problem, const QuasiStaticState& state) {
  if (problem.outer_race.is_rigid()) return problem.imbalance(state.displacement).stiffness;
  const RingCoordinates<Eigen::Dynamic> ring(problem);
  return without_waves(imbalance_at<Eigen::Dynamic>(problem, ring, place_of(ring, state)).stiffness, 2);
}

}  // namespace orbearing::bearing
