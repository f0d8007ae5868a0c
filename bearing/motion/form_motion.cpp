#include "bearing/motion/form_motion.hpp"

#include <cmath>

namespace orbearing::bearing::motion {

FormSlope add_form(const std::vector<RaceHarmonic>& form, double side, const BodyMotion& race,
                   ContactMotion& motion) {
  const FormAt here = form_at(form, std::atan2(motion.normal.y(), motion.normal.x()), race.angle);
  motion.approach -= side * here.height;
  motion.approach_speed -= side * (here.slope * motion.line_speed - here.turning_slope * race.speed);
  return {here.slope, here.turning_slope, 0.0};
}

namespace {

// Calls `visit(order, cosine, sine, place of the cosine)` for orders 2 and more of `count` waves.
template <class Visit>
void each_order(const Vector2& normal, Eigen::Index count, Visit&& visit) {
  Vector2 turned = normal;  // cosine and sine of the order times the angle
  for (Eigen::Index i = 1; i + 1 < count; i += 2) {
    turned = {turned.x() * normal.x() - turned.y() * normal.y(),
              turned.x() * normal.y() + turned.y() * normal.x()};
    visit(static_cast<double>(i + 3) / 2.0, turned.x(), turned.y(), i);
  }
}

}  // namespace

void add_waves(const RaceWaves& waves, double side, ContactMotion& motion, FormSlope& slope) {
  if (waves.count == 0) return;
  double height = waves.place[0], rate = waves.speed[0], steep = 0.0;
  each_order(motion.normal, waves.count, [&](double order, double cosine, double sine, Eigen::Index i) {
    height += waves.place[i] * cosine + waves.place[i + 1] * sine;
    rate += waves.speed[i] * cosine + waves.speed[i + 1] * sine;
    steep += order * (waves.place[i + 1] * cosine - waves.place[i] * sine);
  });
  motion.approach -= side * height;
  motion.approach_speed -= side * (steep * motion.line_speed + rate);
  slope.all += steep;
}

void add_wave_forces(double load, const Vector2& normal, Eigen::Ref<Eigen::VectorXd> force) {
  force[0] += load;
  each_order(normal, force.size(), [&](double, double cosine, double sine, Eigen::Index i) {
    force[i] += load * cosine;
    force[i + 1] += load * sine;
  });
}

void add_scratches(const std::vector<RaceScratch>& scratches, double side, const BodyMotion& race,
                   ContactMotion& motion, FormSlope& slope) {
  for (const RaceScratch& scratch : scratches) {
    const TrackSinking<double> sunk = sinking_at(scratch.law, scratch.radius, scratch.angle + race.angle,
                                                 motion.normal.x(), motion.normal.y());
    motion.approach -= sunk.depth;
    motion.approach_speed -= sunk.by_angle * (motion.line_speed - race.speed);
    slope.all += side * sunk.by_angle;
    slope.turning += side * sunk.by_angle;
  }
}

void add_scratches(const std::vector<RollerScratch>& scratches, int roller, const BodyMotion& body, double side,
                   ContactMotion& motion, FormSlope& slope) {
  for (const RollerScratch& scratch : scratches) {
    if (scratch.roller != roller) continue;
    // From the roller's centre the contact lies along side n.
    const TrackSinking<double> sunk =
        sinking_at(side < 0.0 ? scratch.on_inner : scratch.on_outer, scratch.radius, scratch.angle + body.angle,
                   side * motion.normal.x(), side * motion.normal.y());
    motion.approach -= sunk.depth;
    motion.approach_speed -= sunk.by_angle * (motion.line_speed - body.speed);
    slope.all += side * sunk.by_angle;
    slope.rolling += side * sunk.by_angle;
  }
}

}  // namespace orbearing::bearing::motion
