#include "gearset/drivetrain/arrangement_checks.hpp"

#include <algorithm>

#include "gearset/drivetrain/arrangement_problem_text.hpp"
#include "gearset/drivetrain/conditions.hpp"
#include "gearset/drivetrain/linear_faults.hpp"

namespace orbearing::gearset {

namespace {

using Problems = std::vector<ArrangementProblem>;
using Shafts = std::vector<std::size_t>;

Shafts shafts_where(const Arrangement& arrangement, bool Shaft::*property) {
  Shafts found;
  for (std::size_t i = 0; i < arrangement.shafts.size(); ++i)
    if (arrangement.shafts[i].*property) found.push_back(i);
  return found;
}

void check_ports(const Arrangement& arrangement, Problems& problems) {
  const Shafts motors = shafts_where(arrangement, &Shaft::motor);
  if (motors.empty())
    problems.push_back({{}, {}, "no motor on any shaft", "one shaft with 'motor' is required"});
  if (motors.size() > 1)
    problems.push_back(
        {motors, {}, "motors on " + shaft_names(arrangement, motors), "one motor is required"});
  if (shafts_where(arrangement, &Shaft::load).empty())
    problems.push_back({{}, {}, "no load on any shaft", "a shaft with 'load' is required"});
}

void check_shaft(const Arrangement& arrangement, std::size_t index, Problems& problems) {
  const Shaft& shaft = arrangement.shafts[index];
  const bool held = shaft.motor || shaft.load || shaft.ground;
  if (shaft.ground && (shaft.motor || shaft.load))
    problems.push_back({{index},
                        shaft.members,
                        "the ground beside the " + std::string(shaft.motor ? "motor" : "load"),
                        "a shaft that either stands or carries power is required"});
  if (shaft.members.empty())
    problems.push_back({{index}, {}, "no member of a set", "a shaft that turns a member is required"});
  if (shaft.members.size() == 1 && !held)
    problems.push_back({{index},
                        shaft.members,
                        name_of(arrangement, shaft.members.front()) + " alone, so that it floats",
                        "another member, the motor, the load or the ground beside it is required"});
}

Shafts shafts_of(const Arrangement& arrangement, const SetMember& member) {
  Shafts found;
  for (std::size_t i = 0; i < arrangement.shafts.size(); ++i)
    for (const SetMember& joined : arrangement.shafts[i].members)
      if (joined == member) found.push_back(i);
  return found;
}

void check_member(const Arrangement& arrangement, const SetMember& member, Problems& problems) {
  const Shafts positions = shafts_of(arrangement, member);
  if (positions.size() == 1) return;
  const std::string name = name_of(arrangement, member);
  if (positions.empty())
    problems.push_back({{},
                        {member},
                        name + " on no shaft, so that it floats",
                        "each member on a shaft with another, or with the motor, the load or the ground, is "
                        "required"});
  else
    problems.push_back({{positions.rbegin(), positions.rend()},
                        {member},
                        name + " on " + shaft_names(arrangement, positions),
                        "each member once is required"});
}

/// What can be seen without solving anything.
Problems structural_problems(const Arrangement& arrangement) {
  Problems problems;
  check_ports(arrangement, problems);
  for (std::size_t i = 0; i < arrangement.shafts.size(); ++i) check_shaft(arrangement, i, problems);
  for (std::size_t set = 0; set < arrangement.sets.size(); ++set)
    for (const SetMember& member : members_of_set(set)) check_member(arrangement, member, problems);
  return problems;
}

void add_members(const std::vector<SetMember>& more, std::vector<SetMember>& members) {
  for (const SetMember& member : more)
    if (std::find(members.begin(), members.end(), member) == members.end()) members.push_back(member);
}

// The shafts that ask for a speed are the culprits; the sets only pass it on.
void check_speed_conflict(const Arrangement& arrangement, const SpeedSystem& system, Problems& problems) {
  ArrangementProblem problem;
  for (const Eigen::Index row : minimal_conflict(system.matrix, system.right)) {
    const SpeedCondition& condition = system.conditions[static_cast<std::size_t>(row)];
    if (condition.kind == SpeedCondition::Kind::willis)
      add_members(members_of_set(condition.index), problem.members);
    else
      problem.shafts.push_back(condition.index);
  }
  if (problem.shafts.empty()) return;
  // Grounds before the motor: a ground too many is the likelier slip.
  std::stable_partition(problem.shafts.begin(), problem.shafts.end(),
                        [&](std::size_t shaft) { return arrangement.shafts[shaft].ground; });
  problem.found = "speeds that contradict each other: " + shaft_names(arrangement, problem.shafts) +
                  " fix more than Willis' equation allows to " +
                  member_positions(arrangement, problem.members);
  problem.required = "one of these members on a shaft that is free to turn is required";
  problems.push_back(std::move(problem));
}

void check_speed_freedom(const Arrangement& arrangement, const SpeedSystem& system, Problems& problems) {
  ArrangementProblem problem;
  for (const Eigen::Index column : undetermined_unknowns(system.matrix)) {
    const auto shaft = static_cast<std::size_t>(column);
    problem.shafts.push_back(shaft);
    add_members(arrangement.shafts[shaft].members, problem.members);
  }
  if (problem.shafts.empty()) return;
  problem.found = "speeds left open: of " + member_positions(arrangement, problem.members);
  problem.required = "another ground, or a member joined to another shaft, is required";
  problems.push_back(std::move(problem));
}

// With all speeds fixed, the torques fail to balance only where the power cannot leave.
void check_torque_conflict(const Arrangement& arrangement, const TorqueSystem& system, Problems& problems) {
  if (is_consistent(system.matrix, system.right)) return;
  ArrangementProblem problem;
  problem.shafts = shafts_where(arrangement, &Shaft::load);
  for (const std::size_t shaft : problem.shafts)
    add_members(arrangement.shafts[shaft].members, problem.members);
  problem.found =
      "a load that stands still whatever the motor does: " + member_positions(arrangement, problem.members) +
      " cannot take the power";
  problem.required = "a load on a shaft that the motor turns is required";
  problems.push_back(std::move(problem));
}

void check_torque_freedom(const Arrangement& arrangement, const TorqueSystem& system, Problems& problems) {
  ArrangementProblem problem;
  for (const Eigen::Index column : undetermined_unknowns(system.matrix)) {
    const TorqueUnknown& unknown = system.unknowns[static_cast<std::size_t>(column)];
    if (unknown.kind == TorqueUnknown::Kind::set) {
      add_members(members_of_set(unknown.index), problem.members);
    } else {
      problem.shafts.push_back(unknown.index);
      add_members(arrangement.shafts[unknown.index].members, problem.members);
    }
  }
  if (problem.members.empty()) return;
  const Shafts loads = shafts_where(arrangement, &Shaft::load);
  problem.found = loads.size() > 1 ? "torques left open: how the loads on " +
                                         shaft_names(arrangement, loads) + " share the power does not follow"
                                   : "torques left open: more than one way for them through " +
                                         member_positions(arrangement, problem.members);
  problem.required = loads.size() > 1
                         ? "one load is required"
                         : "no second path, joint or ground that the speeds do without is required";
  problems.push_back(std::move(problem));
}

}  // namespace

Problems arrangement_problems(const Arrangement& arrangement) {
  Problems problems = structural_problems(arrangement);
  if (!problems.empty()) return problems;
  const SpeedSystem speeds = speed_system(arrangement);
  check_speed_conflict(arrangement, speeds, problems);
  check_speed_freedom(arrangement, speeds, problems);
  if (!problems.empty()) return problems;
  const TorqueSystem torques = torque_system(arrangement);
  check_torque_conflict(arrangement, torques, problems);
  check_torque_freedom(arrangement, torques, problems);
  return problems;
}

}  // namespace orbearing::gearset
