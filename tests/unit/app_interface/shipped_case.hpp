// Cases of the project, by their names.
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "orbearing/case.hpp"

namespace orbearing {

inline Case shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return Case::read(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml", settings);
}

/// The same under the name case.yaml, for messages.
inline Case parsed(const std::string& name, const std::vector<std::string>& settings = {}) {
  std::ifstream file(ORBEARING_SOURCE_DIR "/cases/" + name + "/case.yaml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return Case::parse(text, "case.yaml", settings);
}

}  // namespace orbearing
