#include "bearing/film/graded_oil.hpp"

namespace orbearing::bearing {

std::optional<OilGrade> oil_of(const GradedOil& stated, double density) {
  if (!stated.grade) return std::nullopt;
  OilGrade oil{.viscosity_40 = 1e-6 * static_cast<double>(*stated.grade),
               .viscosity_index = stated.viscosity_index,
               .density = density};
  if (*stated.grade != ViscosityGrade::stated) return oil;
  if (!stated.viscosity_40) return std::nullopt;
  oil.viscosity_40 = *stated.viscosity_40;
  oil.viscosity_100 = stated.viscosity_100;
  return oil;
}

}  // namespace orbearing::bearing
