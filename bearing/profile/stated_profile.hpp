// The profile of rollers as a case states it: its kind, and what of its shape is not left to defaults.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bearing/profile/profile.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::profile {

struct StatedProfile {
  std::optional<Kind> kind;               // none: no profile is stated
  std::optional<double> drop;             // [m]  at kDropPosition
  std::optional<double> design_load;      // [N]  of one roller
  std::optional<double> chamfer_length;   // [m]  at each end
  std::optional<double> straight_length;  // [m]  of the whole middle part
  std::optional<double> k1;               // [-]  factor of the design load
  std::optional<double> k2;               // [-]  crowned share of each half
  std::optional<double> end_drop;         // [m]  z_m
  std::vector<double> x;                  // [m]  of a table
  std::vector<double> drops;              // [m]  at these positions

  bool operator==(const StatedProfile&) const = default;
};

template <class Visitor>
void describe(Visitor& visit, StatedProfile& m) {
  using namespace described;
  constexpr Range end_length{0.0, 1e4}, relief{0.0, 1000.0};
  const auto length = [&](auto& member, std::string key, std::string meaning) {
    return input(member, "bearing.profile." + key, std::move(meaning),
                 {.dimension = dimension::length, .range = end_length});
  };
  const auto of_relief = [&](auto& member, std::string key, std::string meaning) {
    return input(member, "bearing.profile." + key, std::move(meaning),
                 {.dimension = dimension::small_length, .range = relief});
  };
  members(
      visit, m,
      input(m.kind, "bearing.profile.kind",
            "profile of the rollers along their length; straight: with sharp ends"),
      of_relief(m.drop, "drop",
                "relief of one roller at the outermost of 40 laminae; left out: what the other entries of "
                "the profile give, else the relief of the profile of ISO/TS 16281 there"),
      input(m.design_load, "bearing.profile.design_load",
            "design load of one roller for lundberg, johns-gohar and fujiwara-kawase; left out: the load "
            "that corresponds to the drop",
            {.dimension = dimension::force, .range = positive(1e8)}),
      length(m.chamfer_length, "chamfer_length",
             "chamfer: its length at each end; left out: a tenth of the roller"),
      length(m.straight_length, "straight_length",
             "straight-circular: its straight middle; left out: six tenths of the roller"),
      input(m.k1, "bearing.profile.k1", "fujiwara-kawase: K1, factor of the design load; left out: 1",
            {.range = positive(1000.0)}),
      input(m.k2, "bearing.profile.k2", "fujiwara-kawase: K2, crowned share of each half; left out: 1",
            {.range = positive(1.0)}),
      of_relief(m.end_drop, "end_drop",
                "fujiwara-kawase: z_m, relief at the end; left out: as Johns and Gohar"),
      input(m.x, "bearing.profile.x", "table: ascending positions from the middle of the roller",
            {.dimension = dimension::length, .range = {-1e4, 1e4}}),
      of_relief(m.drops, "drops", "table: relief at those positions"));
}

/// The profile that is stated of rollers of that diameter [m]; straight where none is.
/// @param design of the more strongly curved contact, whose load does not count
/// @throws std::invalid_argument where it has no meaning
Profile profile_of(const StatedProfile& stated, double roller_diameter, DesignLoad design);

}  // namespace orbearing::bearing::profile
