#include "app/case/analysis_names.hpp"

#include <utility>

#include "app/case/machine_rows.hpp"

namespace orbearing::app {

namespace {

// In the order in which they are listed to users.
constexpr std::pair<use::Analysis, const char*> kNames[] = {
    {use::quasi_static, "--fidelity quasi-static"},
    {use::dynamic, "--fidelity dynamic"},
    {use::dynamic_of_sets, "--fidelity dynamic of several sets"},
    {use::co_simulated, "--fidelity co-simulated"},
    {use::monolithic, "--fidelity monolithic"},
    {use::crown, "crown"},
    {use::gears, "run --gears"},
    {use::modes, "modes"},
    {use::modes_at_speed, "modes --speed"},
    {use::mesh, "mesh"},
    {use::fmu_bearing, "fmu --model bearing"},
    {use::fmu_gearset, "fmu --model gearset"},
    {use::planet_defect, "run of a set with a scratched planet bearing"},
    {use::planet_stiffness, "stiffness of a planet bearing"},
    {use::carrier, "carrier"},
};

}  // namespace

const std::vector<use::Analysis>& analyses() {
  static const std::vector<use::Analysis> all = [] {
    std::vector<use::Analysis> list;
    for (const auto& [analysis, name] : kNames) list.push_back(analysis);
    MachineAnalyses::each([&](auto, std::size_t number) { list.push_back(use_of_machine_analysis(number)); });
    return list;
  }();
  return all;
}

std::string analysis_name(use::Analysis analysis) {
  for (const auto& [one, name] : kNames)
    if (one == analysis) return name;
  std::string name;
  MachineAnalyses::each([&]<class Row>(Row, std::size_t number) {
    if (use_of_machine_analysis(number) == analysis) name = Row::name;
  });
  return name;
}

}  // namespace orbearing::app
