// Ratings of a bearing that a case states.
#pragma once

#include <optional>

#include "bearing/life/standard_life.hpp"
#include "mechanics/described.hpp"

namespace orbearing::analysis {

/// Ratings that replace those of the standards.
struct StatedCapacities {
  std::optional<double> dynamic_capacity{};    // [N]  C
  std::optional<double> static_capacity{};     // [N]  C_0
  std::optional<double> fatigue_load_limit{};  // [N]  C_u

  bearing::rating::StatedRatings ratings() const {
    return {.dynamic_capacity = dynamic_capacity,
            .static_capacity = static_capacity,
            .fatigue_load_limit = fatigue_load_limit};
  }
};
template <class Visitor>
void describe(Visitor& visit, StatedCapacities& m) {
  using namespace described;
  const Details of_load{.dimension = dimension::force, .range = positive(1e9)};
  members(visit, m,
          input(m.dynamic_capacity, "bearing.dynamic_capacity",
                "basic dynamic load rating C, for the lives by ISO 281 and ISO/TS 16281; if absent, C by ISO "
                "281",
                of_load),
          input(m.static_capacity, "bearing.static_capacity",
                "basic static load rating C_0; if absent, C_0 by ISO 76", of_load),
          input(m.fatigue_load_limit, "bearing.fatigue_load_limit",
                "fatigue load limit C_u; if absent, C_u by ISO 281 from C_0", of_load));
}

}  // namespace orbearing::analysis
