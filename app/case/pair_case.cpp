#include "app/case/pair_case.hpp"

#include <cmath>

namespace orbearing::app {

gearset::GearPair pair_of(const ResolvedCase& resolved) {
  const std::vector<double>& teeth = resolved.list("pair.teeth");
  const std::vector<double>& shift = resolved.list("pair.profile_shift");
  return {.teeth = {static_cast<int>(std::lround(teeth.at(0))), static_cast<int>(std::lround(teeth.at(1)))},
          .shift = {shift.at(0), shift.at(1)},
          .module = resolved.quantity("pair.module"),
          .face_width = resolved.quantity("pair.face_width"),
          .bore = resolved.quantity("pair.bore"),
          .rack = {.pressure_angle = resolved.quantity("pair.pressure_angle"),
                   .addendum = resolved.number("pair.addendum"),
                   .clearance = resolved.number("pair.clearance"),
                   .root_fillet_radius = resolved.number("pair.root_fillet_radius")}};
}

}  // namespace orbearing::app
