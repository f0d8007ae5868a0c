#include "app/case/drivetrain_analyses.hpp"

#include <cassert>
#include <cstddef>

#include "app/case/machine_rows.hpp"

namespace orbearing::app {

namespace {

using analysis::Physics;
using analysis::PhysicsSet;

// Physics that several analyses have in common.
struct Shared {
  PhysicsSet teeth{Physics::everywhere, Physics::planet};
  PhysicsSet bearings = teeth | PhysicsSet{Physics::balance, Physics::carrier, Physics::at_rest};
  PhysicsSet lives = bearings | PhysicsSet{Physics::life, Physics::rated_lives};
  PhysicsSet gears{Physics::central_teeth, Physics::gear_bodies, Physics::positions};
  PhysicsSet moving_gears = gears | PhysicsSet{Physics::gear_motion, Physics::load_sharing};
  PhysicsSet pins{Physics::walls, Physics::pin};
  PhysicsSet moving_rollers = lives | pins | PhysicsSet{Physics::motion, Physics::run};
  PhysicsSet one_set_in_time = moving_rollers | moving_gears;
  PhysicsSet vibration = bearings | gears | pins | PhysicsSet{Physics::springs, Physics::vibration};
  PhysicsSet gears_alone = bearings | moving_gears | pins | PhysicsSet{Physics::springs, Physics::euler};
};

DrivetrainAnalysis row_of(AnalysisId analysis) {
  using enum Physics;
  const Shared shared;
  const PhysicsSet sharing{load_sharing, positions};
  const TakenDrivetrains one_or_several{.several_sets = true},
      only_several{.single_set = false, .several_sets = true}, without_bearing{.without_bearing = true},
      masses_too{.without_bearing = true, .without_teeth = true};
  switch (analysis) {
    case AnalysisId::quasi_static:
      return {"--fidelity quasi-static", shared.lives | sharing | equilibrium, defect, one_or_several};
    case AnalysisId::dynamic:
      return {"--fidelity dynamic", shared.one_set_in_time | PhysicsSet{euler, run_up}, defect};
    case AnalysisId::dynamic_of_sets:
      return {"--fidelity dynamic of several sets",
              shared.moving_rollers | sharing | PhysicsSet{euler, run_up},
              PhysicsSet{gear_bodies, gear_motion, central_teeth, defect}, only_several};
    case AnalysisId::co_simulated:
      return {"--fidelity co-simulated", shared.one_set_in_time | PhysicsSet{coupled, exchange}, defect};
    case AnalysisId::monolithic:
      return {"--fidelity monolithic", shared.one_set_in_time | coupled, defect};
    case AnalysisId::crown:  // varies a planet of the mean load
      return {"crown", shared.lives | equilibrium, sharing | defect, one_or_several};
    case AnalysisId::gears:
      return {"run --gears", shared.gears_alone, defect, without_bearing};
    case AnalysisId::modes:
      return {"modes", shared.vibration, {}, masses_too};
    case AnalysisId::modes_at_speed:
      return {"modes --speed", shared.vibration, {}, masses_too};
    case AnalysisId::mesh:
      return {"mesh", shared.teeth | PhysicsSet{thrust, central_teeth, positions}, {}, without_bearing};
    case AnalysisId::fmu_bearing:
      return {"fmu --model bearing",
              shared.teeth | shared.pins | PhysicsSet{balance, carrier, motion, euler, life}, defect};
    case AnalysisId::fmu_gearset:
      return {"fmu --model gearset", shared.gears_alone, defect, without_bearing};
    case AnalysisId::planet_defect:  // moves as monolithic does (drivetrain_uses.cpp)
      return {"run of a set with a scratched planet bearing", shared.teeth | defect, {}, one_or_several};
    case AnalysisId::planet_stiffness:
      return {"stiffness of a planet bearing", shared.bearings | equilibrium, sharing | defect,
              one_or_several};
    case AnalysisId::carrier:  // besides, what modes and quasi-static points use (drivetrain_uses.cpp)
      return {"carrier", shared.teeth | carrier_body};
    case AnalysisId::first_of_machines:
      break;
  }
  assert(false);
  return {};
}

constexpr std::size_t kDrivetrainAnalyses = static_cast<std::size_t>(AnalysisId::first_of_machines);

const std::vector<DrivetrainAnalysis>& rows() {
  static const std::vector<DrivetrainAnalysis> all = [] {
    std::vector<DrivetrainAnalysis> list;
    for (const AnalysisId analysis : drivetrain_analyses()) list.push_back(row_of(analysis));
    return list;
  }();
  return all;
}

AnalysisSet those_with(Physics physics, PhysicsSet DrivetrainAnalysis::*of) {
  AnalysisSet found;
  for (const AnalysisId analysis : drivetrain_analyses())
    if ((drivetrain_analysis(analysis).*of).has(physics)) found |= analysis;
  return found;
}

}  // namespace

const DrivetrainAnalysis& drivetrain_analysis(AnalysisId analysis) {
  return rows().at(static_cast<std::size_t>(analysis));
}

const std::vector<AnalysisId>& drivetrain_analyses() {
  static const std::vector<AnalysisId> all = [] {
    std::vector<AnalysisId> list;
    for (std::size_t i = 0; i < kDrivetrainAnalyses; ++i) list.push_back(static_cast<AnalysisId>(i));
    return list;
  }();
  return all;
}

AnalysisSet all_of_drivetrains() {
  AnalysisSet all;
  for (const AnalysisId analysis : drivetrain_analyses()) all |= analysis;
  return all;
}

AnalysisSet analyses_with(Physics physics) {
  return those_with(physics, &DrivetrainAnalysis::holds);
}
AnalysisSet analyses_leaving_out(Physics physics) {
  return those_with(physics, &DrivetrainAnalysis::leaves_out);
}

std::string analysis_name(AnalysisId analysis) {
  if (analysis < AnalysisId::first_of_machines) return drivetrain_analysis(analysis).name;
  std::string name;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    if (id_of_machine_analysis(number) == analysis) name = Row::name;
  });
  return name;
}

const std::vector<AnalysisId>& every_analysis() {
  static const std::vector<AnalysisId> all = [] {
    std::vector<AnalysisId> list = drivetrain_analyses();
    MachineAnalyses::each([&](auto, std::size_t number) { list.push_back(id_of_machine_analysis(number)); });
    return list;
  }();
  return all;
}

}  // namespace orbearing::app
