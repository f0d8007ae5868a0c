// Which participant is behind the C interface, and all that is known of it before it runs. Knows neither FMI
// nor files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/setup_numbers.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "coupling/system/driven_gears.hpp"

namespace orbearing::fmu {

/// All that is known of a model before it runs.
struct ModelFacts {
  std::string model;    // "bearing" or "gearset"
  std::string meaning;  // one sentence
  ShownFields shown;
  std::vector<system::Input> inputs;
  std::vector<system::Output> outputs;
};

NumberTable numbers_of(const system::DrivenBearingSetup& setup);
NumberTable numbers_of(const system::DrivenGearsSetup& setup);

/// Throws std::invalid_argument where `numbers` are those of no model.
ModelFacts facts_of(const NumberTable& numbers);

/// With values of the parameters in the order of the facts. Throws std::invalid_argument where they make no
/// sense.
std::unique_ptr<system::Participant> make_participant(const NumberTable& numbers,
                                                      const std::vector<double>& parameters);

}  // namespace orbearing::fmu
