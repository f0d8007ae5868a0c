#include "gearset/drivetrain/power_flow.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gearset/drivetrain/arrangement.hpp"
#include "gearset/drivetrain/arrangement_checks.hpp"
#include "gearset/stepped_planet.hpp"

namespace orbearing::gearset {

namespace {

// A member that carries the whole input, as every member of a chain without branches does, is above it by
// round-off at most.
constexpr double circulation_margin = 1e-9;

void require_sound(const Arrangement& arrangement) {
  const std::vector<ArrangementProblem> problems = arrangement_problems(arrangement);
  if (!problems.empty())
    throw std::invalid_argument("found " + problems.front().found + "; " + problems.front().required);
}

// A sound arrangement has as many conditions as unknowns; one step of refinement makes the last digits those
// of the equations.
Eigen::VectorXd solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  const Eigen::FullPivLU<Eigen::MatrixXd> decomposition(matrix);
  Eigen::VectorXd unknowns = decomposition.solve(right);
  unknowns += decomposition.solve(right - matrix * unknowns);
  return unknowns;
}

// Ratios of teeth that differ do so by far more: what is left of none is none, so that a set that turns as a
// block has no planet that creeps, and an idle one no load.
constexpr double kRoundOff = 1e-12;  // [-]  of the largest

void drop_round_off(Eigen::VectorXd& values) {
  const double least = kRoundOff * values.cwiseAbs().maxCoeff();
  for (double& value : values)
    if (std::abs(value) < least) value = 0.0;
}

double& part(Member member, double& sun, double& ring, double& carrier) {
  return member == Member::sun ? sun : member == Member::ring ? ring : carrier;
}

// Eq. (16) for each set's planets.
void add_planet_speeds(const Arrangement& arrangement, PowerFlow& flow) {
  for (std::size_t set = 0; set < arrangement.sets.size(); ++set) {
    Speeds& speed = flow.sets[set].speed;
    const ArrangedSet& teeth = arrangement.sets[set];
    if (teeth.is_parallel()) continue;
    const double turn = speed.sun - speed.carrier;
    if (std::abs(turn) > kRoundOff * (std::abs(speed.sun) + std::abs(speed.carrier)))
      speed.planet_relative = -turn * teeth.sun_teeth / teeth.planet_teeth;
  }
}

void put_member(const MemberFlow& member, PowerFlow& flow) {
  MemberRatios& ratios = flow.sets[member.member.set];
  part(member.member.member, ratios.speed.sun, ratios.speed.ring, ratios.speed.carrier) = member.speed;
  part(member.member.member, ratios.torque.sun, ratios.torque.ring, ratios.torque.carrier) = member.torque;
  flow.members[3 * member.member.set + static_cast<std::size_t>(member.member.member)] = member;
}

// The external torque on a shaft is the sum of the torques of its members. Eqs. (28) and (30).
void put_shaft(const Arrangement& arrangement, const Eigen::VectorXd& speeds,
               const Eigen::VectorXd& set_torque, std::size_t index, PowerFlow& flow) {
  ShaftFlow& shaft = flow.shafts[index];
  shaft.speed = speeds(static_cast<Eigen::Index>(index));
  for (const SetMember& joined : arrangement.shafts[index].members) {
    const double torque = set_torque(static_cast<Eigen::Index>(joined.set)) *
                          willis_weight(arrangement.sets[joined.set], joined.member);
    put_member({joined, index, shaft.speed, torque, torque * shaft.speed}, flow);
    shaft.torque += torque;
  }
  shaft.power = shaft.torque * shaft.speed;
}

}  // namespace

PowerFlow power_flow(const Arrangement& arrangement) {
  require_sound(arrangement);
  const ArrangementSystem speed_equations = speed_system(arrangement);
  const ArrangementSystem torque_equations = torque_system(arrangement);
  Eigen::VectorXd speeds = solution(speed_equations.matrix, speed_equations.right);
  Eigen::VectorXd torques = solution(torque_equations.matrix, torque_equations.right);
  drop_round_off(speeds);
  drop_round_off(torques);
  PowerFlow flow;
  flow.sets.resize(arrangement.sets.size());
  flow.members.resize(3 * arrangement.sets.size());
  flow.shafts.resize(arrangement.shafts.size());
  for (std::size_t shaft = 0; shaft < arrangement.shafts.size(); ++shaft)
    put_shaft(arrangement, speeds, torques, shaft, flow);
  add_planet_speeds(arrangement, flow);
  return flow;
}

PowerCirculation power_circulation(const PowerFlow& flow) {
  PowerCirculation circulation;
  for (const MemberFlow& member : flow.members) {
    const double share = std::abs(member.power);
    circulation.largest_share = std::max(circulation.largest_share, share);
    if (share > 1.0 + circulation_margin) circulation.members.push_back(member.member);
  }
  return circulation;
}

std::vector<std::size_t> idle_sets(const PowerFlow& flow) {
  std::vector<std::size_t> idle;
  for (std::size_t set = 0; set < flow.sets.size(); ++set)
    if (const Torques& torque = flow.sets[set].torque;
        torque.sun == 0.0 && torque.ring == 0.0 && torque.carrier == 0.0)
      idle.push_back(set);
  return idle;
}

Arrangement arrangement_of(const PlanetarySet& set, Member driven, const std::string& name) {
  if (driven == set.fixed_member)
    throw std::invalid_argument(
        "the driven member is the fixed one; drive another member or fix another one");
  const WillisTeeth teeth = willis_teeth(set);
  Arrangement arrangement{{{name, teeth.sun, teeth.planet, teeth.ring}}, {}};
  for (const SetMember& member : members_of_set(0)) {
    const bool ground = member.member == set.fixed_member;
    const bool motor = member.member == driven;
    const bool load = !ground && !motor;
    arrangement.shafts.push_back({ground  ? "ground"
                                  : motor ? "motor"
                                          : "load",
                                  {member},
                                  motor,
                                  load,
                                  ground});
  }
  return arrangement;
}

}  // namespace orbearing::gearset
