// An oil as a case states it: by its grade, or by the viscosities of its data sheet, at a temperature.
#pragma once

#include <optional>

#include "bearing/film/oil_grade.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing {

/// Grades of [ISO3448] that reach 2 mm^2/s at 100 degC, each with its number of mm^2/s at 40 degC; `stated`:
/// the viscosity at 40 degC is stated instead.
enum class ViscosityGrade {
  vg7 = 7,
  vg10 = 10,
  vg15 = 15,
  vg22 = 22,
  vg32 = 32,
  vg46 = 46,
  vg68 = 68,
  vg100 = 100,
  vg150 = 150,
  vg220 = 220,
  vg320 = 320,
  vg460 = 460,
  vg680 = 680,
  vg1000 = 1000,
  vg1500 = 1500,
  vg2200 = 2200,
  vg3200 = 3200,
  stated = 0
};

constexpr described::Names<ViscosityGrade, 18> names_of(ViscosityGrade) {
  using enum ViscosityGrade;
  return {{{vg7, "ISO VG 7"},
           {vg10, "ISO VG 10"},
           {vg15, "ISO VG 15"},
           {vg22, "ISO VG 22"},
           {vg32, "ISO VG 32"},
           {vg46, "ISO VG 46"},
           {vg68, "ISO VG 68"},
           {vg100, "ISO VG 100"},
           {vg150, "ISO VG 150"},
           {vg220, "ISO VG 220"},
           {vg320, "ISO VG 320"},
           {vg460, "ISO VG 460"},
           {vg680, "ISO VG 680"},
           {vg1000, "ISO VG 1000"},
           {vg1500, "ISO VG 1500"},
           {vg2200, "ISO VG 2200"},
           {vg3200, "ISO VG 3200"},
           {stated, "stated"}}};
}

struct GradedOil {
  std::optional<ViscosityGrade> grade;  // none: the oil is not stated by a grade
  std::optional<double> viscosity_40;   // [m^2/s]  kinematic, at 40 degC; of the grade `stated`
  std::optional<double> viscosity_100;  // [m^2/s]  the same at 100 degC; none: by the viscosity index
  double temperature = 70.0;            // [degC]  at which the oil runs
  double viscosity_index = OilGrade{}.viscosity_index;  // [-]

  bool operator==(const GradedOil&) const = default;
};

template <class Visitor>
void describe(Visitor& visit, GradedOil& m) {
  using namespace described;
  members(
      visit, m,
      input(m.grade, "lubricant.grade",
            "viscosity grade of a mineral oil; with the temperature it replaces lubricant.viscosity, "
            "pressure_viscosity and kinematic_viscosity. stated: lubricant.viscosity_40 says it"),
      input(m.viscosity_40, "lubricant.viscosity_40",
            "kinematic viscosity at 40 degC as a data sheet states it, instead of a grade",
            {.dimension = dimension::kinematic_viscosity, .range = positive(1e6)}),
      input(m.viscosity_100, "lubricant.viscosity_100",
            "kinematic viscosity at 100 degC, stated with viscosity_40; by the viscosity index if absent",
            {.dimension = dimension::kinematic_viscosity, .range = {2.0, 1e6}}),
      input(m.temperature, "lubricant.temperature", "running temperature of the oil, stated with its grade",
            {.dimension = dimension::temperature,
             .range = {-20.0, 150.0},
             .reason = "oil of a gearbox at full load"}),
      input(m.viscosity_index, "lubricant.viscosity_index", "viscosity index, stated with the grade",
            {.range = {0.0, 100.0}, .reason = "an ordinary mineral oil"}));
}

/// The oil that is stated; none without a grade, and for the grade `stated` without a viscosity.
/// @param density [kg/m^3]
std::optional<OilGrade> oil_of(const GradedOil& stated, double density = OilGrade{}.density);

}  // namespace orbearing::bearing
