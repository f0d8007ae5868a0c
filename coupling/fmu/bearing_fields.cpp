#include "coupling/fmu/bearing_fields.hpp"

#include "coupling/fmu/setup_numbers.hpp"

namespace orbearing::fmu {

NumberTable numbers_of(const BearingModel& model) {
  return numbers_of_setup("bearing", model);
}

BearingModel bearing_from(const NumberTable& numbers) {
  return setup_from<BearingModel>(numbers);
}

}  // namespace orbearing::fmu
