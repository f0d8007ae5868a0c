// A bearing as a case states it by a catalogue: what its dimensions and its clearance follow from.
#pragma once

#include <optional>
#include <string>

#include "bearing/catalogue/classes.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::catalogue {

struct CatalogueBearing {
  std::optional<std::string> designation;         // none: the dimensions are stated
  std::optional<ClearanceClass> clearance_class;  // none: the clearance is stated

  bool operator==(const CatalogueBearing&) const = default;
};

template <class Visitor>
void describe(Visitor& visit, CatalogueBearing& m) {
  using namespace described;
  members(
      visit, m,
      input(m.designation, "bearing.designation",
            "designation of the bearing in a catalogue, such as NU 205, 6205, 7205 B or K 20x24x10: boundary "
            "dimensions and ratings as printed, rollers or balls inferred from them"),
      input(m.clearance_class, "bearing.clearance_class",
            "clearance class of the unmounted bearing, ISO 5753; the middle of its range is used"));
}

}  // namespace orbearing::bearing::catalogue
