// Rows of a bearing that is a machine of its own, or one of two in a pair.
#pragma once

#include "bearing/parameters.hpp"
#include "mechanics/part_rows.hpp"

namespace orbearing::analysis {

using mechanics::describe_not_required;
using mechanics::describe_only;
using mechanics::describe_without;

/// Rolling elements, races and material of a single bearing, without seats, width and cage, and without the
/// members `left_out`.
template <class Visitor, class... LeftOut>
void describe_inside(Visitor& visit, bearing::Bearing& m, const LeftOut&... left_out) {
  const auto describe_but = [&](const auto& member) {
    describe_without(visit, m, m.inner.seat_diameter, m.outer.seat_diameter, m.width, m.cage, m.inner.form,
                     m.outer.form, m.inner.profile, m.outer.profile, member, left_out...);
  };
  if (m.has_rollers())
    describe_but(m.rollers().diameter_deviation);  // of planets
  else
    describe_but(m.contact_law);  // of rollers
}

/// Boundary dimensions of a single bearing: stated, or those of a designation.
template <class Visitor>
void describe_dimensions(Visitor& visit, bearing::Bearing& m) {
  mechanics::RowsNotRequired<Visitor> rows(visit);
  describe_only(rows, m, m.inner.seat_diameter, m.outer.seat_diameter, m.width);
}

}  // namespace orbearing::analysis
