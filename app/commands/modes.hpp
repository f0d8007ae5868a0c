// `orbearing modes`: natural frequencies.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct ModesOptions {
  static constexpr const char* command = "modes";
  static constexpr const char* purpose =
      "natural frequencies and kinds of modes of gears, or of a shaft on a pair of bearings";
  Printing print;
  StatedCase stated;
  std::string speed;  // empty: at rest
};
inline void describe(OptionList& list, ModesOptions& m) {
  described::members(
      list, m, described::part(m.print), described::part(m.stated),
      option(m.speed, "--speed",
             "speed of the driven member (of the carrier if the set has no teeth), e.g. \"6000 rpm\"; "
             "of a shaft on a pair of bearings, instead of operation.shaft_speed; default: at rest"));
}

int execute(const ModesOptions& options);

}  // namespace orbearing::app
