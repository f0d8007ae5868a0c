// Force of the land on the cage and its slopes: dynamics/cage_guidance.hpp, written once for numbers and for
// numbers with derivatives.
#pragma once

#include "bearing/motion/vectorised/constants.hpp"
#include "mechanics/packs/dual.hpp"

namespace orbearing::bearing::fast::ORBEARING_PACKS {

using namespace mechanics::ORBEARING_PACKS;

template <class T>
struct LandMotion {
  T offset_x, offset_y;      // [m]      cage less land
  T velocity_x, velocity_y;  // [m/s]    cage less land
  T cage_speed;              // [rad/s]
};

template <class T>
struct LandForce {
  T x, y;    // [N]    on the cage; the land feels the opposite
  T moment;  // [N m]  on the cage
};

// Angle of the substitution of [Sommerfeld1904].
template <class T>
struct SubstitutedAngle {
  T cosine, sine;
};

template <class T>
SubstitutedAngle<T> substituted(const T& eccentricity, const T& root, const T& cosine, const T& sine) {
  const T inverse = 1.0 / (1.0 - eccentricity * cosine);
  return {(cosine - eccentricity) * inverse, root * sine * inverse};
}

// Force of the half film in axes along the eccentricity and across it, per film coefficient.
template <class T>
void half_film(const T& held, const T& along, const T& across, T& force_along, T& force_across) {
  constexpr double kTwoPi = 6.283185307179586476925286766559;
  force_along = force_across = T(0.0);
  const T speed_square = along * along + across * across;
  if (!(value_of(speed_square) > 0.0)) return;
  const T speed = root_of(speed_square);
  const T towards_x = along / speed, towards_y = across / speed;
  const T square = 1.0 - held * held;
  const T root = root_of(square);
  const SubstitutedAngle<T> from = substituted(held, root, towards_y, -towards_x);
  const SubstitutedAngle<T> to = substituted(held, root, -towards_y, towards_x);
  // Both angles lie half a turn of the plain angle apart; their difference in (0, 2 pi).
  T span =
      angle_of(from.cosine * to.sine - from.sine * to.cosine, from.cosine * to.cosine + from.sine * to.sine);
  if (value_of(span) <= 0.0) span = span + kTwoPi;
  const T sine_cosine = to.sine * to.cosine - from.sine * from.cosine;
  const T sine = to.sine - from.sine;
  const T cosine = to.cosine - from.cosine;
  const T sine_square = to.sine * to.sine - from.sine * from.sine;
  const T in_line =
      (0.5 * (span + sine_cosine) + 2.0 * held * sine + held * held * span) / (square * square * root);
  const T mixed = (0.5 * sine_square - held * cosine) / (square * square);
  const T crosswise = 0.5 * (span - sine_cosine) / (square * root);
  force_along = -(in_line * along + mixed * across);
  force_across = -(mixed * along + crosswise * across);
}

template <class T>
LandForce<T> land_force(const LandConstants& land, const LandMotion<T>& motion) {
  constexpr double kNoDirection = 1e-12, kPi = 3.141592653589793238462643383280;
  LandForce<T> force{T(0.0), T(0.0), T(0.0)};
  if (!land.present) return force;
  const T length_square = motion.offset_x * motion.offset_x + motion.offset_y * motion.offset_y;
  T length(0.0), e_x(1.0), e_y(0.0);
  if (value_of(length_square) > 0.0) length = root_of(length_square);
  if (value_of(length) > kNoDirection * land.clearance) {
    e_x = motion.offset_x / length;
    e_y = motion.offset_y / length;
  }
  const T eccentricity = length / land.clearance;
  const T held =
      value_of(eccentricity) < land.largest_eccentricity ? eccentricity : T(land.largest_eccentricity);
  const T mean_speed = 0.5 * (motion.cage_speed + land.speed);
  const T squeeze_x = motion.velocity_x + mean_speed * motion.offset_y;
  const T squeeze_y = motion.velocity_y - mean_speed * motion.offset_x;
  T f_along, f_across;
  if (land.as_printed) {
    const T surface = land.cage_radius * (motion.cage_speed + land.speed);
    const T square = 1.0 - held * held;
    const T size = value_of(surface) < 0.0 ? -surface : surface;
    f_along = -land.printed_scale * size * held * held / (square * square);
    f_across = land.printed_scale * surface * (0.25 * kPi) * held / (square * root_of(square));
  } else {
    half_film(held, squeeze_x * e_x + squeeze_y * e_y, squeeze_y * e_x - squeeze_x * e_y, f_along, f_across);
    f_along = land.film_scale * f_along;
    f_across = land.film_scale * f_across;
  }
  force.x = f_along * e_x - f_across * e_y;
  force.y = f_along * e_y + f_across * e_x;
  const T shear = land.shear_scale * (land.speed - motion.cage_speed) / root_of(1.0 - held * held);
  force.moment = shear - 0.5 * (motion.offset_x * force.y - motion.offset_y * force.x);

  const T depth = length - land.largest_eccentricity * land.clearance;
  if (value_of(depth) > 0.0) {
    const T growth = 1.0 + land.damping * (motion.velocity_x * e_x + motion.velocity_y * e_y);
    if (value_of(growth) <= 0.0) return force;
    const T load = land.stiffness * depth * growth;
    const double cage_arm = land.side * land.cage_radius;
    const T sliding = land.speed * (cage_arm + length) - motion.cage_speed * cage_arm -
                      (motion.velocity_y * e_x - motion.velocity_x * e_y);
    const T friction =
        land.friction * load * sliding / root_of(sliding * sliding + land.sliding_scale * land.sliding_scale);
    force.x = force.x - load * e_x - friction * e_y;
    force.y = force.y - load * e_y + friction * e_x;
    force.moment = force.moment + cage_arm * friction;
  }
  return force;
}

}  // namespace orbearing::bearing::fast::ORBEARING_PACKS
