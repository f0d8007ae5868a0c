#include "bearing/equilibrium/race_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bearing/contact/least_approach.hpp"
#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/plane.hpp"
#include "mechanics/force_left.hpp"

namespace orbearing::bearing {

namespace {

using laminae::RollerState;

// The largest gap or overlap [m] of the concentric races.
double largest_gap(const RaceEquilibrium& problem) {
  const double extra = problem.extra_approach.size() == 0 ? 0.0 : problem.extra_approach.abs().maxCoeff();
  const ElasticRace& race = problem.outer_race;
  return std::abs(problem.clearance) + 2.0 * extra + 2.0 * (race.cosine.abs().sum() + race.sine.abs().sum());
}

// Deflection of an elastic race under all loads at one position.
double wave_reach(const RaceEquilibrium& problem, double load) {
  return problem.outer_race.is_rigid() ? 0.0 : problem.outer_race.compliance.sum() * load;
}

// Contribution of profiles and a stated tilt [m].
double lamina_reach(const RaceEquilibrium& problem) {
  return problem.cut ? 2.0 * largest_drop(*problem.cut) + problem.end_displacement.abs().maxCoeff() : 0.0;
}

laminae::Element element_of(const RaceEquilibrium& races) {
  if (!races.cut) return WholeRoller{races.contacts};
  return laminae::TiltedRoller{races.cut->contact(Race::inner), races.cut->contact(Race::outer),
                               races.contacts.inner.film(), races.contacts.outer.film()};
}

std::string failure_text(const RaceEquilibrium& problem, double residual) {
  std::ostringstream text;
  text << "the races found no static equilibrium under " << problem.load.norm()
       << " N: " << mechanics::force_left_text(residual) << "; check the clearance and the roller count";
  return text.str();
}

template <int N>
QuasiStaticState solve_in(const RaceEquilibrium& problem, const QuasiStaticState* near) {
  std::vector<RollerState> rollers = near && problem.cut ? near->rollers : std::vector<RollerState>();
  rollers.resize(static_cast<std::size_t>(problem.angle.size()));
  const RingsOnRollers<N> ring = ring_on_rollers<N>(problem, rollers);
  Eigen::Vector<double, N> position = ring.rest;
  position.template head<2>() = near ? near->displacement : first_displacement(problem);
  if (near) position.tail(near->waves.size()) = near->waves;
  mechanics::Imbalance<N> now;
  QuasiStaticState state;
  state.report = {mechanics::find_balance<N>(ring, search_limits(problem), position, now)};
  state.report.residual = mechanics::force_left(state.report.residual);
  state.displacement = position.template head<2>();
  state.waves = position.tail(position.size() - 2);
  state.stiffness = without_waves<N>(now);
  put_rollers(problem, std::move(rollers), state);
  state.report.converged = state.report.converged && are_settled(state.rollers);
  if (!state.report.converged) state.report.message = failure_text(problem, state.report.residual);
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

template <int N>
SettlingRow<N> row_of(const RaceEquilibrium& races, typename SettlingRow<N>::Moves outward,
                      std::vector<RollerState>& rollers) {
  Eigen::ArrayXd concentric(races.angle.size());
  for (Eigen::Index j = 0; j < concentric.size(); ++j)
    concentric[j] = races.approach(j, Eigen::Vector2d::Zero());
  return {element_of(races),
          std::move(concentric),
          races.inertial_load,
          races.end_displacement,
          std::move(outward),
          {},
          rollers};
}

template <int N>
void SettlingRow<N>::add(Eigen::Index j, const Eigen::Vector<double, N>& position,
                         mechanics::Imbalance<N>& sum) const {
  RollerState& roller = rollers[static_cast<std::size_t>(j)];
  const auto out = outward.col(j);
  laminae::RollerSetting setting{
      .approach =
          without_round_off(concentric[j] - position.dot(out), std::abs(concentric[j]) + position.norm()),
      .outer_end_displacement = end_displacement.size() == 0 ? 0.0 : end_displacement[j],
      .inertial_load = inertial_load[j]};
  if (tilting.size() == 0) {
    laminae::converge_element(element, setting, roller);
    sum.force += roller.outer.load * out;
    sum.stiffness += roller.stiffness * out * out.transpose();
    return;
  }
  setting.outer_end_displacement += position.dot(tilting.col(j));
  laminae::converge_element(element, setting, roller);
  const auto tilted = tilting.col(j);
  const Eigen::Matrix2d k = laminae::roller_stiffness(roller);
  sum.force += roller.outer.load * out + roller.outer.end_load * tilted;
  sum.stiffness.noalias() += (k(0, 0) * out + k(1, 0) * tilted) * out.transpose();
  sum.stiffness.noalias() += (k(0, 1) * out + k(1, 1) * tilted) * tilted.transpose();
}

template <int N>
mechanics::Imbalance<N> RingsOnRollers<N>::operator()(const Position& position) const {
  mechanics::Imbalance<N> sum{load, stiffness, scale};
  if constexpr (N == Eigen::Dynamic) sum.force -= stiffness * (position - rest);
  for (const SettlingRow<N>& row : rows)
    for (Eigen::Index j = 0; j < row.concentric.size(); ++j) row.add(j, position, sum);
  return sum;
}

template <int N>
RingsOnRollers<N> ring_on_rollers(const RaceEquilibrium& races, std::vector<RollerState>& rollers) {
  const Eigen::VectorXd waves = N == 2 ? Eigen::VectorXd() : wave_stiffness(races.outer_race);
  const Eigen::Index size = 2 + waves.size();
  typename SettlingRow<N>::Moves outward(size, races.angle.size());
  for (Eigen::Index j = 0; j < races.angle.size(); ++j) {
    outward.col(j).template head<2>() = direction(races.angle[j]);
    if (waves.size() > 0) outward.col(j).tail(waves.size()) = wave_shapes(races.outer_race, races.angle[j]);
  }
  RingsOnRollers<N> ring;
  ring.load.setZero(size);
  ring.load.template head<2>() = races.load;
  ring.stiffness.setZero(size, size);
  ring.rest.setZero(size);
  if (waves.size() > 0) {
    ring.stiffness.diagonal().tail(waves.size()) = waves;
    ring.rest.tail(waves.size()) = waves_at_rest(races.outer_race);
  }
  ring.scale = races.force_scale();
  ring.rows.push_back(row_of<N>(races, std::move(outward), rollers));
  return ring;
}

template struct SettlingRow<2>;
template struct SettlingRow<5>;
template struct SettlingRow<Eigen::Dynamic>;
template struct RingsOnRollers<2>;
template struct RingsOnRollers<5>;
template struct RingsOnRollers<Eigen::Dynamic>;
template SettlingRow<Eigen::Dynamic> row_of<Eigen::Dynamic>(const RaceEquilibrium&, Eigen::MatrixXd,
                                                            std::vector<RollerState>&);
template RingsOnRollers<2> ring_on_rollers<2>(const RaceEquilibrium&, std::vector<RollerState>&);
template RingsOnRollers<Eigen::Dynamic> ring_on_rollers<Eigen::Dynamic>(const RaceEquilibrium&,
                                                                        std::vector<RollerState>&);

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
  const double gap = largest_gap(problem), more = lamina_reach(problem);
  const double reach = std::max(gap, 1e-6) + elastic + wave_reach(problem, all);
  return {.reach = reach + more, .size = problem.cut ? gap + reach + more : gap};
}

void put_rollers(const RaceEquilibrium& problem, std::vector<RollerState> rollers, QuasiStaticState& state) {
  state.angle = problem.angle;
  state.inner_load.resize(problem.angle.size());
  state.outer_load.resize(problem.angle.size());
  for (Eigen::Index j = 0; j < problem.angle.size(); ++j) {
    const RollerState& roller = rollers[static_cast<std::size_t>(j)];
    state.inner_load[j] = roller.inner.load;
    state.outer_load[j] = roller.outer.load;
    if (problem.cut)
      state.moment += problem.cut->half_length() * roller.outer.end_load * direction(problem.angle[j]);
  }
  state.rollers = std::move(rollers);
}

QuasiStaticState solve(const RaceEquilibrium& problem, const QuasiStaticState* near) {
  return problem.outer_race.is_rigid() ? solve_in<2>(problem, near) : solve_in<Eigen::Dynamic>(problem, near);
}

}  // namespace orbearing::bearing
