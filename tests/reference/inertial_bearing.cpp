#include "tests/reference/inertial_bearing.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::reference {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Plane kTurn{0.0, 1.0};  // by a right angle, counter-clockwise

double along(Plane vector, Plane direction) {
  return vector.real() * direction.real() + vector.imag() * direction.imag();
}

double moment_of(Plane arm, Plane force) {
  return arm.real() * force.imag() - arm.imag() * force.real();
}

Plane velocity_at(const Body& body, Plane point) {
  return body.velocity + kTurn * body.speed * (point - body.position);
}

struct Load {
  Plane force{};
  double moment = 0.0;

  void add(const Body& body, Plane point, Plane force_there) {
    force += force_there;
    moment += moment_of(point - body.position, force_there);
  }
};

double coulomb(double friction, double load, double sliding, double scale) {
  return friction * load * sliding / std::hypot(sliding, scale);
}

// Palmgren, one contact: Q = 8.06e4 l^(8/9) delta^(10/9) in N and mm.
double palmgren_load(double length, double approach) {
  if (approach <= 0.0) return 0.0;
  return 8.06e4 * std::pow(1e3 * length, 8.0 / 9.0) * std::pow(1e3 * approach, 10.0 / 9.0);
}

// Dowson and Higginson, central film 4/3 of the least, at one speed.
struct OilFilm {
  OilFilm(const BearingNumbers& b, double radius, double speed) : length(b.roller_length) {
    const double modulus = b.young / (1.0 - b.poisson * b.poisson);
    at_unit_load = 4.0 / 3.0 * 2.65 * std::pow(b.oil.pressure_viscosity, 0.54) *
                   std::pow(b.oil.viscosity * speed, 0.7) * std::pow(radius, 0.43) / std::pow(modulus, 0.03);
    // No thicker than where it meets the rigid film, by bisection in ln q.
    const double rigid = 4.896 * b.oil.viscosity * speed * radius;
    double low = std::log(1e-12), high = std::log(1e12);
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (elastic(std::exp(middle)) * std::exp(middle) < rigid ? low : high) = middle;
    }
    least_line_load = std::exp(low);
  }
  double elastic(double line_load) const { return at_unit_load * std::pow(line_load, -0.13); }
  double central(double load) const { return elastic(std::max(load / length, least_line_load)); }

  double length, at_unit_load = 0.0, least_line_load = 0.0;
};

// Load whose elastic approach is the approach of the rigid bodies and the film under that load.
double filmed_load(const BearingNumbers& b, double radius, double speed, double approach) {
  const OilFilm film(b, radius, speed);
  const auto pressed = [&](double load) {
    return palmgren_load(b.roller_length, approach + film.central(load));
  };
  double low = 0.0, high = pressed(0.0);
  for (int i = 0; high > 0.0 && i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (pressed(middle) > middle ? low : high) = middle;
  }
  return high > 0.0 ? 0.5 * (low + high) : 0.0;
}

// Pressure of rigid bodies that roll past and approach each other, p = eta (6 V R - 4 u x)/h^2 over all x
// where it is positive: by Simpson's rule over the angle t, x = (2 R g)^(1/2) tan t.
double rigid_film_load(const BearingNumbers& b, double radius, double gap, double speed, double closing) {
  constexpr int kPieces = 400;
  const double scale = std::sqrt(2.0 * radius * gap);
  const double begin = -0.5 * kPi, end = std::atan(1.5 * closing * radius / (speed * scale));
  const auto density = [&](double t) {
    return (6.0 * closing * radius * std::cos(t) - 4.0 * speed * scale * std::sin(t)) * std::cos(t);
  };
  double sum = density(begin) + density(end);
  for (int i = 1; i < kPieces; ++i)
    sum += (i % 2 == 1 ? 4.0 : 2.0) * density(begin + (end - begin) * i / kPieces);
  return b.oil.viscosity * b.roller_length * scale / (gap * gap) * sum * (end - begin) / (3.0 * kPieces);
}

// Load that squeezing adds to a contact that carries `load` where the surfaces are `gap` apart, negative for
// an overlap. Film and bodies deflect in series under one load.
double squeezed_load(const BearingNumbers& b, double radius, double speed, double gap, double load,
                     double closing) {
  const double central = OilFilm(b, radius, speed).central(load);
  const double pressed = 1e-3 * std::pow(load / palmgren_load(b.roller_length, 1e-3), 0.9);
  const double apart = load > 0.0 ? 0.0 : b.film ? gap - central : std::max(gap, 0.0);
  const double film = std::max(central + apart, b.roughness);
  const double wedge = rigid_film_load(b, radius, film, speed, 0.0);
  double share = 1.0;
  if (load > 0.0) {
    const double power = (wedge + 0.13 * load) / (wedge + load);  // of the load, at which the film thins
    const double film_yields = power * film / load, bodies_yield = 0.9 * pressed / load;
    share = film_yields / (film_yields + bodies_yield);
  }
  return share * (rigid_film_load(b, radius, film, speed, share * closing) - wedge);
}

// Drag of the oil at the inlet, in the groups of Moes; below 1 N in proportion to the load.
double inlet_drag(const BearingNumbers& b, double radius, double speed, double load) {
  const double modulus = b.young / (1.0 - b.poisson * b.poisson);
  const double twice_U = 2.0 * b.oil.viscosity * speed / (modulus * radius);
  const double W = load / (modulus * radius * b.roller_length);
  const double M = W / std::sqrt(twice_U);
  const double L = b.oil.pressure_viscosity * modulus * std::pow(twice_U, 0.25);
  const double rigid = 1.4705 * std::sqrt(M);
  const double elastic = 2.2818 / (std::pow(M, 0.04543) * std::pow(L, 0.0923));
  const double group = 1.0 / std::cbrt(1.0 / std::pow(rigid, 3) + 1.0 / std::pow(elastic, 3));
  return modulus * radius * b.roller_length * std::pow(twice_U, 0.75) * group *
         std::sqrt(load / (load + 1.0));
}

// The bore where it bends, seen from outside: its radius at `angle` less that of the circle.
struct Rim {
  const BearingNumbers& b;
  const Carrier& carrier;
  const Bodies& bodies;

  double further(double angle, const std::vector<Plane>& amplitudes) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < b.rim.size(); ++i)
      sum += (std::conj(amplitudes[i]) * std::polar(1.0, b.rim[i].order * (angle - carrier.angle))).real();
    return sum;
  }
  double slope(double angle) const {
    constexpr double kStep =
        1e-3;  // [rad]  central differences of higher order: error 1e-9 of a wave of order 6
    const auto difference = [&](double step) {
      return (further(angle + step, bodies.bent) - further(angle - step, bodies.bent)) / (2.0 * step);
    };
    return (difference(2.0 * kStep) - 20.0 * difference(kStep) + 64.0 * difference(0.5 * kStep)) / 45.0;
  }
};

// `outside`: the race is the bore, which lies around the roller.
// The bore may bend: the load on each of its waves goes into `on_rim`.
void press(const BearingNumbers& b, bool outside, const Body& roller, const Body& race, const Rim& rim,
           Load& on_roller, Load& on_race, std::vector<Plane>& on_rim) {
  const double a = b.roller_radius, race_radius = outside ? b.bore_radius : b.pin_radius;
  const Plane line = roller.position - race.position;
  const double distance = std::abs(line);
  const Plane outward = line / distance, tangent = kTurn * outward;
  const Plane towards_race = outside ? outward : -outward;
  const double position = std::arg(line);
  const double further = outside ? rim.further(position, rim.bodies.bent) : 0.0;
  const double steep = outside ? rim.slope(position) : 0.0;
  const double gap = outside ? race_radius + further - distance - a : distance - race_radius - a;
  const Plane touch = roller.position + a * towards_race;
  // The point of contact remains on the line of centres, which passes along a bore whose form is fixed to the
  // carrier.
  const double line_speed = along(roller.velocity - race.velocity, tangent) / distance;
  double closing = along(roller.velocity - race.velocity, towards_race);
  if (outside)
    closing -= steep * (line_speed - rim.carrier.speed) + rim.further(position, rim.bodies.bending);
  const Plane touch_velocity = roller.velocity + kTurn * line_speed * (touch - roller.position);
  const double race_surface = along(velocity_at(race, touch) - touch_velocity, tangent);
  const double roller_surface = along(velocity_at(roller, touch) - touch_velocity, tangent);
  const double sliding = race_surface - roller_surface, rolling = 0.5 * (race_surface + roller_surface);
  const double speed = std::hypot(rolling, b.entrainment_scale);

  const double radius = outside ? 1.0 / (1.0 / a - 1.0 / race_radius) : 1.0 / (1.0 / a + 1.0 / race_radius);
  const double elastic = b.film ? filmed_load(b, radius, speed, -gap) : palmgren_load(b.roller_length, -gap);
  double load = elastic * std::max(0.0, 1.0 + b.damping * closing);
  if (b.squeeze) load += squeezed_load(b, radius, speed, gap, elastic, closing);
  if (load <= 0.0) return;

  const Plane friction = coulomb(b.friction, load, sliding, b.sliding_scale) * tangent;
  on_roller.add(roller, touch, -load * towards_race + friction);
  on_race.add(race, touch, load * towards_race - friction);

  // A slope pushes the roller through its centre, as the work on it requires: load times the change of the
  // gap.
  on_roller.force += load * steep / distance * tangent;
  on_race.add(race, roller.position, -load * steep / distance * tangent);
  for (std::size_t i = 0; outside && i < b.rim.size(); ++i)
    on_rim[i] += load * std::polar(1.0, b.rim[i].order * (position - rim.carrier.angle));

  // Oil at the inlet drags both surfaces back, each about its own centre; the force that keeps both in
  // equilibrium of forces and moments passes through the centres.
  const double drag = inlet_drag(b, radius, speed, load) * rolling / speed;
  const double roller_arm = along(touch - roller.position, outward);
  const double race_arm = along(touch - race.position, outward);
  const Plane through_centres = drag * (race_arm + roller_arm) / distance * tangent;
  on_roller.force += through_centres;
  on_roller.moment -= drag * roller_arm;
  on_race.force -= through_centres;
  on_race.moment -= drag * race_arm;
}

// The pocket's middle line runs outward from the cage's centre at `angle`.
void push(const BearingNumbers& b, double angle, const Body& roller, const Body& cage, Load& on_roller,
          Load& on_cage) {
  const Plane outward = std::polar(1.0, angle), ahead = kTurn * outward;
  const Plane arm = roller.position - cage.position;
  const double offset = along(arm, ahead);
  const double depth = std::abs(offset) - 0.5 * b.pocket_clearance;
  if (depth <= 0.0) return;
  const Plane towards_bar = offset > 0.0 ? ahead : -ahead;
  const double closing = along(roller.velocity - velocity_at(cage, roller.position), towards_bar);
  const double load = b.pocket_stiffness * depth * std::max(0.0, 1.0 + b.pocket_damping * closing);
  const Plane touch = roller.position + b.roller_radius * towards_bar;
  const double sliding = along(velocity_at(cage, touch) - velocity_at(roller, touch), outward);
  const Plane force =
      -load * towards_bar + coulomb(b.pocket_friction, load, sliding, b.sliding_scale) * outward;
  on_roller.add(roller, touch, force);
  on_cage.add(cage, touch, -force);
}

// Two rollers that meet without a cage, in the middle of their overlap.
void meet(const BearingNumbers& b, const Body& one, const Body& other, Load& on_one, Load& on_other) {
  const Plane line = other.position - one.position, towards_other = line / std::abs(line);
  const double overlap = 2.0 * b.roller_radius - std::abs(line);
  const double closing = along(one.velocity - other.velocity, towards_other);
  const double load = palmgren_load(b.roller_length, overlap) * std::max(0.0, 1.0 + b.damping * closing);
  if (load <= 0.0) return;
  const Plane touch = 0.5 * (one.position + other.position), tangent = kTurn * towards_other;
  const double sliding = along(velocity_at(other, touch) - velocity_at(one, touch), tangent);
  const Plane force =
      -load * towards_other + coulomb(b.neighbour_friction, load, sliding, b.sliding_scale) * tangent;
  on_one.add(one, touch, force);
  on_other.add(other, touch, -force);
}

// Resultant on the cage of the short bearing's film that is squeezed, pressure nowhere below that around it.
Plane squeezed(const BearingNumbers& b, double eccentricity, Plane towards, Plane squeeze) {
  constexpr int kPoints = 4000;  // midpoint rule; the integrand ends with zero slope nowhere, error 1e-8
  const double width = b.land_width;
  const double scale = b.lands * b.oil.viscosity * width * width * width * b.cage_guide_radius /
                       std::pow(b.land_clearance, 3.0);
  const double begin = std::arg(squeeze) - 0.5 * kPi, towards_angle = std::arg(towards);
  Plane sum{};
  for (int i = 0; i < kPoints; ++i) {
    const double angle = begin + (i + 0.5) * kPi / kPoints;
    const Plane u = std::polar(1.0, angle);
    sum += u * along(u, squeeze) / std::pow(1.0 - eccentricity * std::cos(angle - towards_angle), 3.0);
  }
  return -scale * (kPi / kPoints) * sum;
}

void guide(const BearingNumbers& b, const Body& cage, const Body& land, Load& on_cage, Load& on_land) {
  const Plane offset = cage.position - land.position;
  const double length = std::abs(offset);
  const Plane towards = length > 0.0 ? offset / length : Plane{1.0, 0.0};
  const double held = std::min(length / b.land_clearance, b.held_eccentricity);
  // Velocity of the cage in a frame that rotates with the mean of both surfaces.
  const Plane squeeze = cage.velocity - land.velocity - 0.5 * (cage.speed + land.speed) * kTurn * offset;
  const Plane force = std::abs(squeeze) > 0.0 ? squeezed(b, held, towards, squeeze) : Plane{};
  const double shear = 2.0 * kPi * b.oil.viscosity * std::pow(b.cage_guide_radius, 3.0) * b.lands *
                       b.land_width * (land.speed - cage.speed) /
                       (b.land_clearance * std::sqrt(1.0 - held * held));
  const double couple = 0.5 * moment_of(offset, force);
  on_cage.force += force;
  on_cage.moment += shear - couple;
  on_land.force -= force;
  on_land.moment += -shear - couple;

  const double depth = length - b.held_eccentricity * b.land_clearance;
  if (depth <= 0.0) return;
  const double closing = along(cage.velocity - land.velocity, towards);
  const double load = b.land_stiffness * depth * std::max(0.0, 1.0 + b.land_damping * closing);
  const Plane touch = cage.position + b.cage_guide_radius * towards, tangent = kTurn * towards;
  const double sliding = along(velocity_at(land, touch) - velocity_at(cage, touch), tangent);
  const Plane contact = -load * towards + coulomb(b.land_friction, load, sliding, b.sliding_scale) * tangent;
  on_cage.add(cage, touch, contact);
  on_land.add(land, touch, -contact);
}

}  // namespace

Accelerations accelerations(const BearingNumbers& b, const Carrier& carrier, const Bodies& bodies,
                            Plane bore_force) {
  const Plane pin_axis = std::polar(carrier.orbit_radius, carrier.angle);
  const auto carrier_velocity = [&](Plane point) { return kTurn * carrier.speed * point; };
  const double length = b.roller_length, a = b.roller_radius;
  const auto churned = [&](double radius, double width, double speed) {
    const double rotating = speed - carrier.speed;
    return -0.5 * b.churning * b.mixture_density * std::pow(radius, 4.0) * width * rotating *
           std::abs(rotating);
  };

  const Plane falling{0.0, -b.gravity};
  Accelerations result;
  Load on_cage, on_bore, on_pin;
  const Rim rim{b, carrier, bodies};
  std::vector<Plane> on_rim(b.rim.size());
  const double pitch = 2.0 * kPi / static_cast<double>(bodies.rollers.size());
  const std::size_t count = bodies.rollers.size();
  std::vector<Load> from_neighbours(count);
  for (std::size_t j = 0; !b.caged && j < count; ++j)
    meet(b, bodies.rollers[j], bodies.rollers[(j + 1) % count], from_neighbours[j],
         from_neighbours[(j + 1) % count]);
  for (std::size_t j = 0; j < bodies.rollers.size(); ++j) {
    const Body& roller = bodies.rollers[j];
    Load load = from_neighbours[j];
    press(b, false, roller, bodies.pin, rim, load, on_pin, on_rim);
    press(b, true, roller, bodies.bore, rim, load, on_bore, on_rim);
    if (b.caged)
      push(b, bodies.cage.angle + static_cast<double>(j) * pitch, roller, bodies.cage, load, on_cage);

    // The mixture rests in the carrier; it resists the way around the pin.
    const Plane way = kTurn * (roller.position - pin_axis) / std::abs(roller.position - pin_axis);
    const double passing = along(roller.velocity - carrier_velocity(roller.position), way);
    load.force -=
        0.5 * b.cylinder_drag * b.mixture_density * 2.0 * a * length * passing * std::abs(passing) * way;
    load.moment += churned(a, length, roller.speed);
    result.rollers.push_back({load.force / b.roller_mass + falling, load.moment / b.roller_inertia});
  }
  if (b.caged) guide(b, bodies.cage, bodies.bore, on_cage, on_bore);
  on_cage.moment += churned(b.cage_mean_radius, b.cage_width, bodies.cage.speed);
  on_pin.force -= b.support_stiffness * (bodies.pin.position - pin_axis) +
                  b.support_damping * (bodies.pin.velocity - carrier_velocity(bodies.pin.position));
  if (b.caged) result.cage = {on_cage.force / b.cage_mass + falling, on_cage.moment / b.cage_inertia};
  result.bore = {(on_bore.force + bore_force) / b.bore_mass + falling, 0.0};
  result.pin = {on_pin.force / b.pin_mass + falling, 0.0};
  for (std::size_t i = 0; i < b.rim.size(); ++i) {
    const RimWave& wave = b.rim[i];
    Plane force =
        on_rim[i] - wave.damping * bodies.bending[i] - wave.stiffness * (bodies.bent[i] - wave.at_rest);
    if (wave.order == 0) force = force.real();
    result.rim.push_back(force / wave.mass);
  }
  result.bore_moment = on_bore.moment;
  result.pin_moment = on_pin.moment;
  return result;
}

}  // namespace orbearing::reference
