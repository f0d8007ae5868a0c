#include "coupling/fmu/machine.hpp"

#include <stdexcept>

namespace orbearing::fmu {

namespace {

[[noreturn]] void refuse(const std::string& model) {
  throw std::invalid_argument("model: found '" + model + "'; required: bearing or gearset");
}

NumberTable changed(NumberTable numbers, const std::vector<ShownField>& parameters,
                    const std::vector<double>& values) {
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (NumberRow& row : numbers.rows)
      if (row.name == parameters[i].facts.name) row.values = {values.at(i)};
  return numbers;
}

}  // namespace

ModelFacts facts_of(const NumberTable& numbers) {
  if (numbers.model == "bearing") return bearing_facts(numbers);
  if (numbers.model == "gearset") return gear_facts(numbers);
  refuse(numbers.model);
}

std::unique_ptr<Machine> make_machine(const NumberTable& numbers, const std::vector<double>& parameters) {
  const NumberTable own = changed(numbers, facts_of(numbers).parameters, parameters);
  return numbers.model == "gearset" ? make_gears(own) : make_bearing(own);
}

}  // namespace orbearing::fmu
