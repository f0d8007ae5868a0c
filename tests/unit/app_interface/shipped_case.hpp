// Cases of the project, by their names.
#pragma once

#include <string>
#include <vector>

#include "orbearing/case.hpp"

namespace orbearing {

inline Case shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return Case::read(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", settings);
}

}  // namespace orbearing
