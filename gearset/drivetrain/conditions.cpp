#include "gearset/drivetrain/conditions.hpp"

#include <cassert>

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

std::vector<SpeedCondition> speed_conditions(const Arrangement& arrangement) {
  std::vector<SpeedCondition> conditions;
  for (std::size_t set = 0; set < arrangement.sets.size(); ++set)
    conditions.push_back({SpeedCondition::Kind::willis, set});
  for (std::size_t shaft = 0; shaft < arrangement.shafts.size(); ++shaft) {
    if (arrangement.shafts[shaft].ground) conditions.push_back({SpeedCondition::Kind::ground, shaft});
    if (arrangement.shafts[shaft].motor) conditions.push_back({SpeedCondition::Kind::motor, shaft});
  }
  return conditions;
}

std::vector<TorqueUnknown> torque_unknowns(const Arrangement& arrangement) {
  std::vector<TorqueUnknown> unknowns;
  for (std::size_t set = 0; set < arrangement.sets.size(); ++set)
    unknowns.push_back({TorqueUnknown::Kind::set, set});
  for (std::size_t shaft = 0; shaft < arrangement.shafts.size(); ++shaft) {
    if (arrangement.shafts[shaft].ground) unknowns.push_back({TorqueUnknown::Kind::ground, shaft});
    if (arrangement.shafts[shaft].load) unknowns.push_back({TorqueUnknown::Kind::load, shaft});
  }
  return unknowns;
}

}  // namespace

double willis_weight(const ArrangedSet& set, Member member) {
  assert(set.sun_teeth > 0 && set.ring_teeth > 0);
  const double sum = set.sun_teeth + set.ring_teeth;
  if (member == Member::carrier) return -1.0;
  return (member == Member::sun ? set.sun_teeth : set.ring_teeth) / sum;
}

// Eqs. (26) and (27).
SpeedSystem speed_system(const Arrangement& arrangement) {
  SpeedSystem system;
  system.conditions = speed_conditions(arrangement);
  const Eigen::Index rows = as_index(system.conditions.size());
  const Eigen::Index sets = as_index(arrangement.sets.size());
  system.matrix = Eigen::MatrixXd::Zero(rows, as_index(arrangement.shafts.size()));
  system.right = Eigen::VectorXd::Zero(rows);
  system.matrix.topRows(sets) = willis_matrix(arrangement);
  for (Eigen::Index row = sets; row < rows; ++row) {
    const SpeedCondition& condition = system.conditions[static_cast<std::size_t>(row)];
    system.matrix(row, as_index(condition.index)) = 1.0;
    if (condition.kind == SpeedCondition::Kind::motor) system.right(row) = 1.0;
  }
  return system;
}

// Eqs. (28) and (29).
TorqueSystem torque_system(const Arrangement& arrangement) {
  TorqueSystem system;
  system.unknowns = torque_unknowns(arrangement);
  const Eigen::Index columns = as_index(system.unknowns.size());
  const Eigen::Index sets = as_index(arrangement.sets.size());
  const Eigen::Index shafts = as_index(arrangement.shafts.size());
  system.matrix = Eigen::MatrixXd::Zero(shafts, columns);
  system.right = Eigen::VectorXd::Zero(shafts);
  system.matrix.leftCols(sets) = willis_matrix(arrangement).transpose();
  for (Eigen::Index column = sets; column < columns; ++column)
    system.matrix(as_index(system.unknowns[static_cast<std::size_t>(column)].index), column) = -1.0;
  for (Eigen::Index shaft = 0; shaft < shafts; ++shaft)
    if (arrangement.shafts[static_cast<std::size_t>(shaft)].motor) system.right(shaft) = 1.0;
  return system;
}

}  // namespace orbearing::gearset
