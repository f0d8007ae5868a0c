#include "app/case/field_use.hpp"

namespace orbearing::app {

Condition where(std::string path, std::vector<std::string> values) {
  return {.paths = {std::move(path)}, .values = std::move(values)};
}

Condition where_given(std::vector<std::string> paths) {
  return {.paths = std::move(paths)};
}

Condition where_absent(std::string path) {
  return {.paths = {std::move(path)}, .absent = true};
}

Condition where_pins_are_displaced() {
  return where_given({"gearset.dynamics.pin_error.radial", "gearset.dynamics.pin_error.tangential"});
}

Use Use::when(Condition condition) const {
  Use more = *this;
  more.conditions.push_back(std::move(condition));
  return more;
}

Use Use::felt_too(unsigned analyses, Condition condition) const {
  Use more = *this;
  more.felt_beside = analyses;
  more.beside = std::move(condition);
  return more;
}

const std::vector<use::Analysis>& analyses() {
  static const std::vector<use::Analysis> every{
      use::quasi_static, use::dynamic,     use::dynamic_of_sets, use::co_simulated,   use::monolithic,
      use::crown,        use::gears,       use::modes,           use::modes_at_speed, use::mesh,
      use::fmu_bearing,  use::fmu_gearset, use::static_load};
  return every;
}

std::string analysis_name(use::Analysis analysis) {
  switch (analysis) {
    case use::quasi_static:
      return "--fidelity quasi-static";
    case use::dynamic:
      return "--fidelity dynamic";
    case use::dynamic_of_sets:
      return "--fidelity dynamic of several sets";
    case use::co_simulated:
      return "--fidelity co-simulated";
    case use::monolithic:
      return "--fidelity monolithic";
    case use::crown:
      return "crown";
    case use::gears:
      return "run --gears";
    case use::modes:
      return "modes";
    case use::modes_at_speed:
      return "modes --speed";
    case use::mesh:
      return "mesh";
    case use::fmu_bearing:
      return "fmu --model bearing";
    case use::fmu_gearset:
      return "fmu --model gearset";
    case use::static_load:
      return "run of a single bearing";
  }
  return "";
}

}  // namespace orbearing::app
