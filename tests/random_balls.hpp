// Ball bearings in motion and states of them, drawn at random, the same in every run.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "bearing/motion/balls/ball_bearing.hpp"

namespace orbearing::bearing::balls {

struct DrawnBalls {
  Bearing bearing;
  MotionParameters parameters;
  BallDuty duty;
};

class RandomBalls {
 public:
  explicit RandomBalls(std::uint64_t seed = 20261122) : engine_(seed) {}

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }
  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(engine_); }

  DrawnBalls next() {
    DrawnBalls drawn;
    drawn.bearing = bearing();
    drawn.parameters = parameters(drawn.bearing);
    drawn.duty = duty(drawn.bearing);
    return drawn;
  }

  /// Displaces and speeds up everything in `x` at random, `size` times micrometres and millimetres per
  /// second.
  void disturb(const BallNumbers& c, double size, std::vector<double>& x) {
    const StateLayout layout{c.balls};
    const int lanes = layout.lanes();
    const auto shift = [&](int position, double by) {
      x[static_cast<std::size_t>(position)] += by * between(-size, size);
    };
    for (int j = 0; j < c.balls; ++j) {
      shift(j, 2e-6);
      shift(lanes + j, 0.6 * c.pocket.play / c.pitch_radius);
      shift(2 * lanes + j, 4e-6);
      shift(3 * lanes + j, 0.02);
      shift(4 * lanes + j, 1.0);
      shift(5 * lanes + j, 0.02);
      for (int group = 6; group < 9; ++group) shift(group * lanes + j, 50.0);
    }
    const auto body = [&](int first, int unknowns, double position) {
      for (int i = 0; i < kRingUnknowns; ++i) {
        shift(first + i, i < 3 ? position : position / c.pitch_radius);
        shift(first + unknowns + i, i < 3 ? 0.02 : 0.02 / c.pitch_radius);
      }
    };
    body(layout.cage(), kCageUnknowns, 5e-5);
    shift(layout.cage() + 5, 0.3 * c.pocket.play / c.pitch_radius);
    shift(layout.cage() + 2 * kCageUnknowns - 1, 2.0);
    if (c.inner_ring.mass > 0.0) body(layout.inner(), kRingUnknowns, 2e-6);
    if (c.outer_ring.mass > 0.0) body(layout.outer(), kRingUnknowns, 2e-6);
  }

 private:
  Bearing bearing() {
    Bearing b;
    Balls balls;
    balls.count = whole(6, 20);
    balls.diameter = between(4e-3, 20e-3);
    balls.contact_angle = whole(0, 1) == 0 ? 0.0 : between(0.2, 0.7);
    b.pitch_diameter = balls.diameter / std::sin(3.141592653589793 / balls.count) * between(1.1, 1.5);
    b.radial_clearance = balls.contact_angle == 0.0 ? between(2e-6, 20e-6) : 0.0;
    b.inner.osculation = between(0.515, 0.54);
    b.outer.osculation = between(0.515, 0.54);
    b.width = 1.8 * balls.diameter;
    b.inner.seat_diameter = std::max(0.3 * b.pitch_diameter, b.pitch_diameter - 2.0 * balls.diameter);
    b.outer.seat_diameter = b.pitch_diameter + 2.0 * balls.diameter;
    b.cage = {b.pitch_diameter - 0.3 * balls.diameter, b.pitch_diameter + 0.3 * balls.diameter,
              1.5 * balls.diameter, whole(0, 1) == 0 ? 1310.0 : 7850.0,
              whole(0, 1) == 0 ? Race::outer : Race::inner};
    b.motions = {RaceMotion::rotating, RaceMotion::stationary};
    b.elements = balls;
    return b;
  }
  MotionParameters parameters(const Bearing& b) {
    MotionParameters p;
    p.race.traction = static_cast<TractionLaw>(whole(0, kTractionLaws - 1));
    p.cage.pocket_clearance = between(0.01, 0.04) * b.balls().diameter;
    if (b.balls().count % 2 == 1) p.cage.pocket_film = motion::PocketFilm::hydrodynamic;
    p.pocket.straight = whole(0, 1) == 0 ? 0.0 : between(0.0, 0.03) * b.balls().diameter;
    if (whole(0, 2) > 0) {
      const double clearance = between(0.2e-3, 0.5e-3);
      p.cage.guide_diameter = b.cage.guidance == Race::outer ? b.cage.outer_diameter + clearance
                                                             : b.cage.inner_diameter - clearance;
    }
    p.ellipse.slices = whole(3, 9);
    p.ellipse.rows = whole(1, 2);
    p.inner.mass = between(0.2, 3.0);
    p.inner.across = p.inner.mass * 0.1 * b.pitch_diameter * b.pitch_diameter;
    p.outer.held = whole(0, 1) == 0;
    return p;
  }
  // A load that presses each ball by some hundred newtons.
  BallDuty duty(const Bearing& b) {
    const double size = 1e7 * b.balls().diameter * b.balls().diameter;
    const double radial = between(0.1, 1.0) * size,
                 axial = b.contact_angle() > 0.0 ? between(0.3, 2.0) * size : between(0.0, 0.1) * size;
    const double speed = between(0.1, 1.0) * 1e4 / (1e3 * b.pitch_diameter) * 3.0;
    BallDuty duty{RingDrive::steady(speed),
                  RingDrive::steady(whole(0, 1) == 0 ? 0.0 : between(-0.3, 0.3) * speed),
                  {{radial, 0.0, axial, 0.0, 0.0}},
                  {{-radial, 0.0, -axial, 0.0, 0.0}}};
    if (whole(0, 4) == 0) std::swap(duty.inner, duty.outer);
    return duty;
  }

  std::mt19937_64 engine_;
};

}  // namespace orbearing::bearing::balls
