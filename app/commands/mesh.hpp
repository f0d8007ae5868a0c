// `orbearing mesh`: stiffness of meshes.
#pragma once

#include "app/commands/common_options.hpp"

namespace orbearing::app {

struct MeshOptions {
  static constexpr const char* command = "mesh";
  static constexpr const char* purpose = "mesh stiffness over a mesh period, contact ratio, phases";
  Printing print;
  StatedCase stated;
};
inline void describe(OptionList& list, MeshOptions& m) {
  described::members(list, m, described::part(m.print), described::part(m.stated));
}

int execute(const MeshOptions& options);

}  // namespace orbearing::app
