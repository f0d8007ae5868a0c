// A small deep-groove bearing, for the tests of ball bearings that run.
#pragma once

#include "bearing/motion/balls/parameters.hpp"
#include "bearing/parameters.hpp"

namespace orbearing::system {

/// Seven balls of 9.52 mm on 36 mm with `clearance` [m], the inner ring turning.
inline bearing::Bearing small_ball_bearing(double clearance) {
  bearing::Bearing b;
  b.elements = bearing::Balls{7, 9.52e-3, 0.0};
  b.pitch_diameter = 36e-3;
  b.radial_clearance = clearance;
  b.width = 15e-3;
  b.inner.seat_diameter = 20e-3;
  b.outer.seat_diameter = 52e-3;
  b.cage = {33e-3, 39e-3, 13e-3, 1310.0, bearing::Race::outer};
  b.motions = {bearing::RaceMotion::rotating, bearing::RaceMotion::stationary};
  return b;
}

/// A fiftieth of a ball of play in its pocket.
inline bearing::balls::MotionParameters small_ball_motion() {
  bearing::balls::MotionParameters p;
  p.cage.pocket_clearance = 0.2e-3;
  return p;
}

}  // namespace orbearing::system
