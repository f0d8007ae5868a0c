// `orbearing carrier`: planet bearings over a revolution of the carrier.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct CarrierOptions {
  static constexpr const char* command = "carrier";
  static constexpr const char* purpose =
      "loads and lives of each planet bearing over a revolution of a carrier on its own bearings";
  Printing print;
  StatedCase stated;
};
inline void describe(OptionList& list, CarrierOptions& m) {
  described::members(list, m, described::part(m.print), described::part(m.stated));
}

int execute(const CarrierOptions& options);

}  // namespace orbearing::app
