// Cases for the tests of app/case, and the mistakes that a change brings.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/errors.hpp"

namespace orbearing::app {

/// A whole case of the smaller model; line 8 holds the number of rollers.
inline const std::string bearing_case = R"(name: small
source: made up
model: roller-bearing
load:
  radial: 4450 N
bearing:
  type: cylindrical-roller
  rollers: 14
  roller_diameter: 10 mm
  roller_length: 9.6 mm
  pitch_diameter: 65 mm
  radial_clearance: 40.6 um
)";

inline std::string shipped_path() {
  return ORBEARING_SOURCE_DIR "/cases/reducer_150kW/case.yaml";
}

inline ResolvedCase shipped(const std::vector<std::string>& settings = {}) {
  return read_case(shipped_path(), settings);
}

inline std::string text_of(const std::string& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Lines of the mistakes in a text; empty for a good case.
inline std::vector<std::string> mistakes(const std::string& text,
                                         const std::vector<std::string>& settings = {}) {
  try {
    parse_case(text, "case.yaml", settings);
  } catch (const BadInput& error) {
    return error.messages;
  }
  return {};
}

/// Mistakes of the shipped case under settings.
inline std::vector<std::string> setting_mistakes(const std::vector<std::string>& settings) {
  return mistakes(text_of(shipped_path()), settings);
}

/// A text with its first `old` replaced.
inline std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  return text.replace(text.find(old), old.size(), fresh);
}

}  // namespace orbearing::app
