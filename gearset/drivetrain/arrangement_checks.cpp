#include "gearset/drivetrain/arrangement_checks.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::gearset {

namespace {

Eigen::Index as_index(std::size_t value) {
  return static_cast<Eigen::Index>(value);
}

// Willis' equations over the speeds of shafts: a set whose members share a shaft adds their weights there.
Eigen::MatrixXd willis_matrix(const Arrangement& arrangement) {
  Eigen::MatrixXd weights =
      Eigen::MatrixXd::Zero(as_index(arrangement.sets.size()), as_index(arrangement.shafts.size()));
  for (std::size_t shaft = 0; shaft < arrangement.shafts.size(); ++shaft)
    for (const SetMember& joined : arrangement.shafts[shaft].members)
      weights(as_index(joined.set), as_index(shaft)) +=
          willis_weight(arrangement.sets[joined.set], joined.member);
  return weights;
}

// Origins of all sets, then shaft by shaft of grounds and of shafts that have the port.
std::vector<Origin> origins_of(const Arrangement& arrangement, bool Shaft::*port) {
  std::vector<Origin> origins;
  for (std::size_t set = 0; set < arrangement.sets.size(); ++set) origins.push_back({Origin::Kind::set, set});
  for (std::size_t shaft = 0; shaft < arrangement.shafts.size(); ++shaft) {
    if (arrangement.shafts[shaft].ground) origins.push_back({Origin::Kind::ground, shaft});
    if (arrangement.shafts[shaft].*port) origins.push_back({Origin::Kind::port, shaft});
  }
  return origins;
}

}  // namespace

double willis_weight(const ArrangedSet& set, Member member) {
  assert(set.sun_teeth > 0 && set.ring_teeth != 0);
  const double sum = set.sun_teeth + set.ring_teeth;
  if (member == Member::carrier) return -1.0;
  return (member == Member::sun ? set.sun_teeth : set.ring_teeth) / sum;
}

// Eqs. (26) and (27).
ArrangementSystem speed_system(const Arrangement& arrangement) {
  ArrangementSystem system{.matrix = {}, .right = {}, .origins = origins_of(arrangement, &Shaft::motor)};
  const Eigen::Index rows = as_index(system.origins.size());
  const Eigen::Index sets = as_index(arrangement.sets.size());
  system.matrix = Eigen::MatrixXd::Zero(rows, as_index(arrangement.shafts.size()));
  system.right = Eigen::VectorXd::Zero(rows);
  system.matrix.topRows(sets) = willis_matrix(arrangement);
  for (Eigen::Index row = sets; row < rows; ++row) {
    const Origin& origin = system.origins[static_cast<std::size_t>(row)];
    system.matrix(row, as_index(origin.index)) = 1.0;
    if (origin.kind == Origin::Kind::port) system.right(row) = 1.0;
  }
  return system;
}

// Eqs. (28) and (29).
ArrangementSystem torque_system(const Arrangement& arrangement) {
  ArrangementSystem system{.matrix = {}, .right = {}, .origins = origins_of(arrangement, &Shaft::load)};
  const Eigen::Index columns = as_index(system.origins.size());
  const Eigen::Index sets = as_index(arrangement.sets.size());
  const Eigen::Index shafts = as_index(arrangement.shafts.size());
  system.matrix = Eigen::MatrixXd::Zero(shafts, columns);
  system.right = Eigen::VectorXd::Zero(shafts);
  system.matrix.leftCols(sets) = willis_matrix(arrangement).transpose();
  for (Eigen::Index column = sets; column < columns; ++column)
    system.matrix(as_index(system.origins[static_cast<std::size_t>(column)].index), column) = -1.0;
  for (Eigen::Index shaft = 0; shaft < shafts; ++shaft)
    if (arrangement.shafts[static_cast<std::size_t>(shaft)].motor) system.right(shaft) = 1.0;
  return system;
}

namespace {

// Weights are ratios of teeth. A pivot that is not zero is then a fraction over a product of sums of teeth,
// above 1e-9 for four sets of 150 teeth even if it is the least possible one; a pivot that is zero is
// round-off.
constexpr double rank_tolerance = 1e-10;

Eigen::FullPivLU<Eigen::MatrixXd> ranked(const Eigen::MatrixXd& matrix) {
  Eigen::FullPivLU<Eigen::MatrixXd> decomposition(matrix);
  decomposition.setThreshold(rank_tolerance);
  return decomposition;
}

Eigen::Index rank_of(const Eigen::MatrixXd& matrix) {
  return matrix.size() == 0 ? 0 : ranked(matrix).rank();
}

Eigen::MatrixXd with_column(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& column) {
  Eigen::MatrixXd joined(matrix.rows(), matrix.cols() + 1);
  joined << matrix, column;
  return joined;
}

std::vector<Eigen::Index> without(const std::vector<Eigen::Index>& rows, std::size_t position) {
  std::vector<Eigen::Index> fewer;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (i != position) fewer.push_back(rows[i]);
  return fewer;
}

// Whether some x satisfies matrix * x = right. Entries are expected to be of order 1.
bool is_consistent(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return rank_of(with_column(matrix, right)) == rank_of(matrix);
}

// Rows that contradict each other and of which none can be left out without the contradiction going away;
// none of a consistent system. Deletion filter: a row without which the contradiction stays is not needed.
std::vector<Eigen::Index> minimal_conflict(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  if (is_consistent(matrix, right)) return {};
  std::vector<Eigen::Index> kept;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) kept.push_back(row);
  for (std::size_t position = 0; position < kept.size();) {
    const std::vector<Eigen::Index> fewer = without(kept, position);
    if (is_consistent(matrix(fewer, Eigen::all), right(fewer)))
      ++position;
    else
      kept = fewer;
  }
  return kept;
}

// Unknowns that the equations do not fix: those in which some vector of the null space has a part.
std::vector<Eigen::Index> undetermined_unknowns(const Eigen::MatrixXd& matrix) {
  const auto decomposition = ranked(matrix);
  if (decomposition.rank() == matrix.cols()) return {};
  const Eigen::MatrixXd null_space = decomposition.kernel();
  std::vector<Eigen::Index> unknowns;
  for (Eigen::Index i = 0; i < matrix.cols(); ++i)
    if (null_space.row(i).norm() > rank_tolerance) unknowns.push_back(i);
  return unknowns;
}

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
  if (shaft.ground && (shaft.motor || shaft.load))
    problems.push_back({{index},
                        shaft.members,
                        "the ground together with the " + std::string(shaft.motor ? "motor" : "load"),
                        "a shaft that is either stationary or carries power is required"});
  if (shaft.members.empty())
    problems.push_back({{index}, {}, "no member of a set", "a shaft that rotates a member is required"});
}

// Shafts that turn one member and nothing else. If all speeds are known, they leave their set without torque:
// it idles. Else they are the likeliest error.
Problems floating_members(const Arrangement& arrangement) {
  Problems problems;
  for (std::size_t index = 0; index < arrangement.shafts.size(); ++index) {
    const Shaft& shaft = arrangement.shafts[index];
    if (shaft.members.size() == 1 && !shaft.motor && !shaft.load && !shaft.ground)
      problems.push_back({{index},
                          shaft.members,
                          name_of(arrangement, shaft.members.front()) + " alone, so that it floats",
                          "another member, the motor, the load or the ground on the same shaft is required"});
  }
  return problems;
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

/// Problems found without a solution of the equations.
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
void check_speed_conflict(const Arrangement& arrangement, const ArrangementSystem& system,
                          Problems& problems) {
  ArrangementProblem problem;
  for (const Eigen::Index row : minimal_conflict(system.matrix, system.right)) {
    const Origin& origin = system.origins[static_cast<std::size_t>(row)];
    if (origin.kind == Origin::Kind::set)
      add_members(members_of_set(origin.index), problem.members);
    else
      problem.shafts.push_back(origin.index);
  }
  if (problem.shafts.empty()) return;
  // Grounds before the motor: a ground too many is the likelier slip.
  std::stable_partition(problem.shafts.begin(), problem.shafts.end(),
                        [&](std::size_t shaft) { return arrangement.shafts[shaft].ground; });
  problem.found = "speeds that contradict each other: " + shaft_names(arrangement, problem.shafts) +
                  " fix more than Willis' equation allows to " +
                  member_positions(arrangement, problem.members);
  problem.required = "one of these members on a free shaft is required";
  problems.push_back(std::move(problem));
}

void check_speed_freedom(const Arrangement& arrangement, const ArrangementSystem& system,
                         Problems& problems) {
  ArrangementProblem problem;
  for (const Eigen::Index column : undetermined_unknowns(system.matrix)) {
    const auto shaft = static_cast<std::size_t>(column);
    problem.shafts.push_back(shaft);
    add_members(arrangement.shafts[shaft].members, problem.members);
  }
  if (problem.shafts.empty()) return;
  problem.found = "speeds undetermined: of " + member_positions(arrangement, problem.members);
  problem.required = "another ground, or a member joined to another shaft, is required";
  problems.push_back(std::move(problem));
}

// With all speeds fixed, the torques are out of equilibrium only if the power cannot leave.
void check_torque_conflict(const Arrangement& arrangement, const ArrangementSystem& system,
                           Problems& problems) {
  if (is_consistent(system.matrix, system.right)) return;
  ArrangementProblem problem;
  problem.shafts = shafts_where(arrangement, &Shaft::load);
  for (const std::size_t shaft : problem.shafts)
    add_members(arrangement.shafts[shaft].members, problem.members);
  problem.found =
      "a load that is stationary at any motor speed: " + member_positions(arrangement, problem.members) +
      " cannot take the power";
  problem.required = "a load on a shaft that the motor turns is required";
  problems.push_back(std::move(problem));
}

void check_torque_freedom(const Arrangement& arrangement, const ArrangementSystem& system,
                          Problems& problems) {
  ArrangementProblem problem;
  for (const Eigen::Index column : undetermined_unknowns(system.matrix)) {
    const Origin& unknown = system.origins[static_cast<std::size_t>(column)];
    if (unknown.kind == Origin::Kind::set) {
      add_members(members_of_set(unknown.index), problem.members);
    } else {
      problem.shafts.push_back(unknown.index);
      add_members(arrangement.shafts[unknown.index].members, problem.members);
    }
  }
  if (problem.members.empty()) return;
  const Shafts loads = shafts_where(arrangement, &Shaft::load);
  problem.found = loads.size() > 1 ? "torques undetermined: how the loads on " +
                                         shaft_names(arrangement, loads) + " share the power is not defined"
                                   : "torques undetermined: more than one path through " +
                                         member_positions(arrangement, problem.members);
  problem.required = loads.size() > 1
                         ? "one load is required"
                         : "no second path, joint or ground that the speeds do without is required";
  problems.push_back(std::move(problem));
}

}  // namespace

namespace {

/// Problems found only by the equations of speeds and torques.
Problems problems_of_motion(const Arrangement& arrangement) {
  Problems problems;
  const ArrangementSystem speeds = speed_system(arrangement);
  check_speed_conflict(arrangement, speeds, problems);
  check_speed_freedom(arrangement, speeds, problems);
  if (!problems.empty()) return problems;
  const ArrangementSystem torques = torque_system(arrangement);
  check_torque_conflict(arrangement, torques, problems);
  check_torque_freedom(arrangement, torques, problems);
  return problems;
}

}  // namespace

Problems arrangement_problems(const Arrangement& arrangement) {
  Problems problems = structural_problems(arrangement);
  const Problems floating = floating_members(arrangement);
  const Problems of_motion = problems.empty() ? problems_of_motion(arrangement) : Problems{};
  const bool moves = problems.empty() && of_motion.empty();
  if (!moves) problems.insert(problems.end(), floating.begin(), floating.end());
  return problems.empty() ? of_motion : problems;
}

}  // namespace orbearing::gearset
