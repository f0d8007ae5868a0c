#include "orbearing/quantity.hpp"

#include "app/case/units.hpp"
#include "orbearing/text.hpp"

namespace orbearing {

double in_unit(const std::string& quantity, const std::string& unit) {
  const app::Reading<app::WrittenQuantity> written = app::split_quantity(quantity);
  if (!written.value) throw BadInput(written.fault + "; required: a number with its unit");
  const app::Reading<double> number = app::convert(written.value->value, written.value->unit, unit);
  if (!number.value)
    throw BadInput(number.fault + "; required: a unit of the same dimension as " + quote(unit));
  return *number.value;
}

}  // namespace orbearing
