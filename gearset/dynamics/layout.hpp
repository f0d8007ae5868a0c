// Where each variable of the planetary set stands in the flat state, and what it is called. No other file
// knows.
//
//   positions [ sun x y u | ring x y u | carrier x y u | planet 1 x y u | ... ], then the same as velocities
//
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gearset/parameters.hpp"

namespace orbearing::gearset::dynamics {

/// Order of the state of a set with `planets` planets.
struct SetLayout {
  Eigen::Index planets = 0;

  Eigen::Index bodies() const { return 3 + planets; }
  Eigen::Index freedoms() const { return 3 * bodies(); }
  Eigen::Index size() const { return 2 * freedoms(); }

  /// First of the three indices of a body among the positions.
  static constexpr Eigen::Index sun() { return 0; }
  static constexpr Eigen::Index ring() { return 3; }
  static constexpr Eigen::Index carrier() { return 6; }
  static constexpr Eigen::Index central(Member member) {
    return member == Member::sun ? sun() : member == Member::ring ? ring() : carrier();
  }
  static constexpr Eigen::Index planet(Eigen::Index n) { return 9 + 3 * n; }
};

/// Name and unit of each variable in the order of the state, e.g. "planet_3_y [m]"; planets count from 1.
std::vector<std::string> variable_names(const SetLayout& layout);

}  // namespace orbearing::gearset::dynamics
