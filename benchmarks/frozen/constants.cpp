#include "benchmarks/frozen/constants.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "bearing/motion/vector_bearing.hpp"

namespace orbearing::bench::frozen {

namespace {

void require_within(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("the frozen equations have no ") + what);
}

bool is_plain(const bearing::motion::BearingModel& model) {
  const auto round = [](const bearing::motion::RaceModel& race) {
    return race.form.empty() && race.scratches.empty();
  };
  const auto equal = [](double deviation) { return deviation == 0.0; };
  return model.layout.caged && round(model.inner) && round(model.outer) && !model.laminae &&
         model.rim.empty() &&
         std::all_of(model.radius_deviation.begin(), model.radius_deviation.end(), equal) &&
         !model.inner.friction.mixed && !model.pocket.with_film();
}

void check(const bearing::motion::BearingModel& model) {
  using namespace bearing;
  require_within(is_plain(model), "waves, unequal or crowned rollers, mixed lubrication or pocket film");
  require_within(model.inner.film, "dry contacts");
  const auto& friction = model.inner.friction;
  require_within(friction.traction == bearing::TractionLaw::regularised_coulomb &&
                     friction.rolling_resistance && !friction.computed_rolling,
                 "law of friction but Coulomb's, and not rolling resistance off or computed");
  require_within(model.land.present && model.land.on_bore, "other guidance than on the outer ring");
  require_within(model.excitation.harmonics.empty() && model.driving.ramp == 0.0,
                 "loads that change in time");
}

Race race_of(const bearing::motion::RaceModel& race, const bearing::FilmContact& film, double roller_radius) {
  const OiledLine line{.stiffness = race.stiffness,
                       .equivalent_radius = film.equivalent_radius,
                       .length = film.length,
                       .reduced_modulus = film.reduced_modulus,
                       .viscosity = film.lubricant.viscosity,
                       .pressure_viscosity = film.lubricant.pressure_viscosity};
  return {.side = race.side,
          .radius = race.radius,
          .roller_radius = roller_radius,
          .damping = race.damping,
          .entrainment_scale = race.entrainment_scale,
          .friction = race.friction.coulomb.friction,
          .sliding_scale = race.friction.coulomb.sliding_scale,
          .load = RaceLoadLaw(line),
          .rolling = RollingResistance(line)};
}

}  // namespace

Model constants_of(const bearing::motion::BearingModel& model) {
  check(model);
  const auto& frame = model.frame;
  const auto& pocket = model.pocket;
  const auto& land = model.land.law;
  return {
      .rollers = model.layout.rollers,
      .frame = {frame.coriolis_speed, frame.centrifugal, frame.euler, frame.own_orbit, frame.orbit_radius},
      .roller_mass = model.roller.mass,
      .roller_inertia = model.roller.inertia,
      .cage_mass = model.cage.mass,
      .cage_inertia = model.cage.inertia,
      .bore_mass = model.bore_mass,
      .pin_mass = model.pin_mass,
      .outer_speed = model.point.outer_speed,
      .inner_speed = model.point.inner_speed,
      .bore_load = model.point.bore_load,
      .inner = race_of(model.inner, model.inner_film, model.geometry.element_radius),
      .outer = race_of(model.outer, model.outer_film, model.geometry.element_radius),
      .pocket = {pocket.half_clearance, pocket.stiffness, pocket.damping, pocket.friction.friction,
                 pocket.friction.sliding_scale, model.geometry.element_radius},
      .pocket_direction = model.pocket_direction,
      .guidance = {land.side, land.clearance, land.cage_radius, land.film_scale, land.shear_scale,
                   land.largest_eccentricity, land.stiffness, land.damping, land.friction.friction,
                   land.friction.sliding_scale},
      .support_stiffness = model.support.stiffness,
      .support_damping = model.support.damping,
      .orbit_drag = {model.orbit_drag.coefficient},
      .spin_drag = {model.spin_drag.coefficient},
      .cage_drag = {model.cage_drag.coefficient}};
}

Difference largest_difference(const bearing::motion::BearingModel& model, const Eigen::VectorXd& x,
                              int states) {
  constexpr double kLength = 2e-6, kSpeed = 0.05, kRotating = 0.01;  // [m], [m/s], [-] of an angular speed
  const Equations frozen(constants_of(model));
  bearing::vectorised::VectorBearing today(model);
  const auto kinds = bearing::motion::variable_kinds(model.layout);
  std::mt19937 chance(1);
  std::uniform_real_distribution<double> some(-1.0, 1.0);
  Difference largest;
  for (int i = 0; i < states; ++i) {
    Eigen::VectorXd moved = x, rounded = x;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      using enum bearing::motion::VariableKind;
      const auto kind = kinds[static_cast<std::size_t>(k)];
      moved[k] += some(chance) * (kind == length          ? kLength
                                  : kind == velocity      ? kSpeed
                                  : kind == angular_speed ? kRotating * std::abs(x[k])
                                                          : kLength / model.geometry.pitch_radius);
      rounded[k] = std::nextafter(moved[k], std::copysign(INFINITY, some(chance)));
    }
    Eigen::VectorXd then(x.size()), beside(x.size()), now(x.size());
    frozen.derivative(moved, then);
    frozen.derivative(rounded, beside);
    today.derivative(0.0, moved, now);
    for (const auto kind : kinds) {
      double difference = 0.0, by_rounding = 0.0, size = 0.0;
      for (Eigen::Index k = 0; k < x.size(); ++k) {
        if (kinds[static_cast<std::size_t>(k)] != kind) continue;
        difference = std::max(difference, std::abs(then[k] - now[k]));
        by_rounding = std::max(by_rounding, std::abs(then[k] - beside[k]));
        size = std::max(size, std::abs(now[k]));
      }
      largest.of_rates = std::max(largest.of_rates, difference / size);
      largest.by_rounding = std::max(largest.by_rounding, by_rounding / size);
    }
  }
  return largest;
}

}  // namespace orbearing::bench::frozen
