#include "coupling/fmu/gear_fields.hpp"

#include "coupling/fmu/setup_numbers.hpp"

namespace orbearing::fmu {

NumberTable numbers_of(const GearModel& model) {
  return numbers_of_setup("gearset", model);
}

GearModel gears_from(const NumberTable& numbers) {
  return setup_from<GearModel>(numbers);
}

}  // namespace orbearing::fmu
