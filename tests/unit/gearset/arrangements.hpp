// Arrangements of sets that several tests share.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gearset/drivetrain/arrangement.hpp"

namespace orbearing::gearset::example_sets {

inline ArrangedSet arranged(const std::string& name, int sun, int planet, int ring) {
  return {name, sun, planet, ring};
}

inline constexpr Member sun = Member::sun;
inline constexpr Member ring = Member::ring;
inline constexpr Member carrier = Member::carrier;

inline Shaft shaft(std::string name, std::vector<SetMember> members) {
  return {std::move(name), std::move(members), false, false, false};
}
inline Shaft motor(std::vector<SetMember> members) {
  return {"input", std::move(members), true, false, false};
}
inline Shaft load(std::vector<SetMember> members) {
  return {"output", std::move(members), false, true, false};
}
inline Shaft ground(std::vector<SetMember> members) {
  return {"housing", std::move(members), false, false, true};
}

/// Sun drives, ring stationary, carrier delivers.
inline Arrangement reducer_alone() {
  return {{arranged("reduction", 37, 22, 79)},
          {motor({{0, sun}}), ground({{0, ring}}), load({{0, carrier}})}};
}

/// The three sets of [Gai2025] one after the other.
inline Arrangement three_in_series() {
  return {
      {arranged("reduction", 37, 22, 79), arranged("coupling", 30, 19, 66),
       arranged("transmission", 23, 18, 57)},
      {motor({{0, sun}}), shaft("first", {{0, carrier}, {1, sun}}), shaft("second", {{1, carrier}, {2, sun}}),
       load({{2, carrier}}), ground({{0, ring}, {1, ring}, {2, ring}})}};
}

/// Simpson's gear train in its low gear: one sun for both sets; the front ring drives, the front carrier
/// delivers together with the rear ring, the rear carrier is stationary.
inline Arrangement simpson_low() {
  return {{arranged("front", 28, 17, 62), arranged("rear", 28, 17, 62)},
          {motor({{0, ring}}), shaft("suns", {{0, sun}, {1, sun}}), load({{0, carrier}, {1, ring}}),
           ground({{1, carrier}})}};
}

/// A set whose ring is driven backwards by a second one from the same input: power goes round in a circle.
inline Arrangement circulating() {
  return {{arranged("main", 30, 30, 90), arranged("control", 30, 15, 60)},
          {motor({{0, sun}, {1, sun}}), shaft("rings", {{0, ring}, {1, ring}}), load({{0, carrier}}),
           ground({{1, carrier}})}};
}

}  // namespace orbearing::gearset::example_sets
