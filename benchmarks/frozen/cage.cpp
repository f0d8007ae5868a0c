#include "benchmarks/frozen/cage.hpp"
#include "mechanics/constants.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::bench::frozen {

namespace {

using constants::two_pi;

constexpr double kNoDirection = 1e-12;  // [-]  of the clearance

struct Offset {
  Vector2 vector;               // [m]
  double length = 0.0;          // [m]
  Vector2 direction{1.0, 0.0};  // [-]
};

Offset offset_of(const Guidance& model, const Vector2& cage, const Vector2& land) {
  Offset offset{.vector = cage - land};
  offset.length = offset.vector.norm();
  if (offset.length > kNoDirection * model.clearance) offset.direction = offset.vector / offset.length;
  return offset;
}

// Angle gamma of the substitution 1 - eps cos(theta) = (1 - eps^2) / (1 + eps cos(gamma)).
struct SubstitutedAngle {
  double cosine;
  double sine;
  double angle;
};

SubstitutedAngle substituted(double eccentricity, double root, double cosine, double sine) {
  const double gap = 1.0 - eccentricity * cosine;
  const double c = (cosine - eccentricity) / gap;
  const double s = root * sine / gap;
  return {c, s, std::atan2(s, c)};
}

struct FilmResistance {
  double along = 0.0;   // [-]
  double mixed = 0.0;   // [-]
  double across = 0.0;  // [-]
};

FilmResistance half_film_resistance(double eccentricity, const Vector2& direction) {
  const double speed = direction.norm();
  if (speed <= 0.0) return {};
  const double square = 1.0 - eccentricity * eccentricity;
  const double root = std::sqrt(square);
  const Vector2 towards = direction / speed;
  const SubstitutedAngle from = substituted(eccentricity, root, towards.y(), -towards.x());
  const SubstitutedAngle to = substituted(eccentricity, root, -towards.y(), towards.x());
  const double span = to.angle > from.angle ? to.angle - from.angle : to.angle - from.angle + two_pi;
  const double sine_cosine = to.sine * to.cosine - from.sine * from.cosine;
  const double sine = to.sine - from.sine;
  const double cosine = to.cosine - from.cosine;
  const double sine_square = to.sine * to.sine - from.sine * from.sine;
  return {(0.5 * (span + sine_cosine) + 2.0 * eccentricity * sine + eccentricity * eccentricity * span) /
              (square * square * root),
          (0.5 * sine_square - eccentricity * cosine) / (square * square),
          0.5 * (span - sine_cosine) / (square * root)};
}

void add_film(const Guidance& model, const BodyMotion& cage, const BodyMotion& land, const Offset& offset,
              double held, GuidanceForces& forces) {
  const Vector2 squeeze =
      cage.velocity - land.velocity - 0.5 * (cage.speed + land.speed) * across(offset.vector);
  const Vector2 local(squeeze.dot(offset.direction), squeeze.dot(across(offset.direction)));
  const FilmResistance film = half_film_resistance(held, local);
  const Vector2 resisted(film.along * local.x() + film.mixed * local.y(),
                         film.mixed * local.x() + film.across * local.y());
  const Vector2 local_force = -model.film_scale * resisted;
  const Vector2 force = local_force.x() * offset.direction + local_force.y() * across(offset.direction);

  const double shear = model.shear_scale * (land.speed - cage.speed) / std::sqrt(1.0 - held * held);
  const double couple = 0.5 * cross(offset.vector, force);
  forces.on_cage += {force, shear - couple};
  forces.on_land += {-force, -shear - couple};
}

void add_touch_down(const Guidance& model, const BodyMotion& cage, const BodyMotion& land,
                    const Offset& offset, double depth, GuidanceForces& forces) {
  const Vector2 relative_velocity = cage.velocity - land.velocity;
  const double load =
      damped_load(model.stiffness * depth, model.damping, relative_velocity.dot(offset.direction));
  const double cage_arm = model.side * model.cage_radius;
  const double land_arm = cage_arm + offset.length;
  const Vector2 tangent = across(offset.direction);
  const double sliding = land.speed * land_arm - cage.speed * cage_arm - relative_velocity.dot(tangent);
  const double friction = regularised_friction(model.friction, load, sliding, model.sliding_scale);
  const Vector2 force = -load * offset.direction + friction * tangent;
  forces.on_cage += force_at(cage_arm * offset.direction, force);
  forces.on_land += force_at(land_arm * offset.direction, -force);
}

}  // namespace

GuidanceForces guidance_forces(const Guidance& model, const BodyMotion& cage, const BodyMotion& land) {
  GuidanceForces forces;
  const Offset offset = offset_of(model, cage.position, land.position);
  const double eccentricity = offset.length / model.clearance;
  add_film(model, cage, land, offset, std::min(eccentricity, model.largest_eccentricity), forces);
  const double depth = offset.length - model.largest_eccentricity * model.clearance;
  if (depth > 0.0) add_touch_down(model, cage, land, offset, depth, forces);
  return forces;
}

}  // namespace orbearing::bench::frozen
