#include "coupling/system/bearing_steps.hpp"
#include "mechanics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace orbearing::system {

namespace {

using constants::pi;

// Frequency of a roller between its races [rad/s].
double roller_frequency(const bearing::motion::BearingModel& model) {
  const double stiffness = 2.0 * race_load(model.inner, kTypicalApproach, 1.0) / kTypicalApproach;
  return std::sqrt(std::max(stiffness, 1.0) / model.roller.mass);
}

// Resistance of the oil between `race` and an unloaded roller of `mass` [kg] over the critical one, where the
// race runs past the contact at `speed` [m/s].
double damping_of_impact(const bearing::motion::RaceModel& race, double speed, double mass) {
  constexpr double kLoad = 1.0, kSlow = 1e-9;  // [N], [m/s]
  if (!race.squeezed) return 0.0;
  const bearing::SqueezeFilm<double>& law = race.squeeze;
  const double u = bearing::motion::entrainment_speed(speed, race.entrainment_scale);
  const double gap = std::max(std::exp(race.film_law.log_unloaded(std::log(u))), law.least);
  const double resistance = law.load(0.0, 0.0, gap, u, kSlow) / kSlow;
  const double compliance = bearing::LineContact(race.stiffness).compliance(kLoad);
  return resistance / (2.0 * std::sqrt(mass / compliance));
}

// Time of the ring on its rollers, of which a quarter are loaded [s].
double ring_time(const bearing::motion::BearingModel& model) {
  const double load = race_load(model.inner, kTypicalApproach, 1.0);
  const double races = 0.25 * static_cast<double>(model.layout.rollers) * load / kTypicalApproach;
  return std::sqrt(model.bore_mass / std::max(races, 1.0));
}

// Allowed errors and longest step of order 3 over those of order 2; where blows on the bars are damped, those
// of radial motion, of all that moves along the pitch circle, and of the bore, and the longest step over that
// of the ring.
constexpr double kThirdOrderErrors = 0.5;
constexpr double kThirdOrderSteps = 1.5;
constexpr double kDampedErrors = 0.3;
constexpr double kDampedAlongErrors = 2.4;
constexpr double kDampedBoreErrors = 0.12;
constexpr double kDampedSteps = 2.5;
// Allowed errors of order 4 over those of order 2.
constexpr double kFourthOrderErrors = 3.0;
// Slow motion: allowed errors fall with this power of slowness().
constexpr double kSlowErrors = 1.0, kSlowFourthOrderErrors = 1.5;

}  // namespace

bool impacts_are_damped(const bearing::motion::BearingModel& model) {
  const double cage =
      bearing::kinematic_cage_speed(model.geometry, model.point.inner_speed, model.point.outer_speed);
  const auto damped = [&](const bearing::motion::RaceModel& race, double speed) {
    return damping_of_impact(race, (speed - cage) * race.radius, model.roller.mass) >= kDampedImpact;
  };
  return damped(model.inner, model.point.inner_speed) && damped(model.outer, model.point.outer_speed);
}

// From half the clearance down to the roughness the film takes the momentum
//   integral of dQ/dV dg = 3 pi/4 (2 eta l) 2R (S(roughness) - S(half the clearance))
// by rigid_line_film.hpp, with psi = pi/2 as rolling has it.
bool blows_are_damped(const bearing::motion::BearingModel& model) {
  const bearing::PocketLaw& pocket = model.pocket;
  const double radius = model.geometry.element_radius;
  if (!model.layout.caged || !pocket.with_film()) return false;
  const bearing::RigidLineFilm<double> film{pocket.viscous, std::sqrt(2.0 * radius)};
  const double within = film.slenderness(pocket.roughness) - film.slenderness(pocket.half_clearance);
  const double momentum = 0.75 * pi * pocket.viscous * 2.0 * radius * within;
  return momentum >= kStoppedBlow * model.roller.mass;
}

Eigen::VectorXd allowed_errors(const bearing::motion::StateLayout& layout, double length, double radius,
                               double frequency) {
  using bearing::motion::VariableKind;
  const std::vector<VariableKind> kinds = bearing::motion::variable_kinds(layout);
  Eigen::VectorXd allowed(layout.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const bool angular = kinds[i] == VariableKind::angle || kinds[i] == VariableKind::angular_speed;
    const bool speed = kinds[i] == VariableKind::velocity || kinds[i] == VariableKind::angular_speed;
    allowed[static_cast<Eigen::Index>(i)] =
        length * (angular ? 1.0 / radius : 1.0) * (speed ? frequency : 1.0);
  }
  return allowed;
}

Eigen::VectorXd allowed_errors(const bearing::motion::BearingModel& model, double length) {
  return allowed_errors(model.layout, length, model.geometry.pitch_radius, roller_frequency(model));
}

std::vector<double> linearly_implicit_errors(const bearing::vectorised::VectorBearing& bearing,
                                             const Eigen::VectorXd& allowed_error) {
  std::vector<double> allowed = bearing.padded(kLinearlyImplicitErrorFactor * allowed_error);
  const bearing::vectorised::PaddedLayout& layout = bearing.layout();
  if (!impacts_are_damped(bearing.model())) {
    const auto radial_speeds = allowed.begin() + 2 * layout.lanes();
    std::for_each(radial_speeds, radial_speeds + layout.rollers,
                  [](double& error) { error *= kRadialSpeedShare; });
  }
  for (int group = 0; group < layout.groups(); ++group)
    std::fill(allowed.begin() + group * layout.lanes() + layout.rollers,
              allowed.begin() + (group + 1) * layout.lanes(), 0.0);
  return allowed;
}

double longest_step(const bearing::motion::BearingModel& model) {
  const double bar =
      model.layout.caged
          ? model.pocket.stiffness
          : bearing::LineContact(model.neighbours.stiffness).load(kTypicalApproach) / kTypicalApproach;
  const double impact = std::sqrt(model.roller.mass / std::max(bar, 1.0));
  return kStepOfImpact * std::min(ring_time(model), impact);
}

double slowness(const bearing::motion::BearingModel& model) {
  const double cage =
      bearing::kinematic_cage_speed(model.geometry, model.point.inner_speed, model.point.outer_speed);
  return slowness(model, cage);
}

double slowness(const bearing::motion::BearingModel& model, double cage) {
  if (cage == 0.0) return 1.0;
  const double passage = constants::two_pi / (static_cast<double>(model.layout.rollers) * std::abs(cage));
  return std::max(1.0, passage / (kStepsOfPassage * longest_step(model)));
}

std::string fastest_vibration(const bearing::motion::BearingModel& model) {
  struct Body {
    const char *name, *on, *change;
    double mass, stiffness;  // [kg], [N/m]
  };
  const double race = race_load(model.inner, kTypicalApproach, 1.0) / kTypicalApproach;
  const double races = 0.25 * static_cast<double>(model.layout.rollers) * race;
  std::vector<Body> bodies = {
      {"a roller", "its races", "state a larger bearing.roller_diameter or a shorter bearing.roller_length",
       model.roller.mass, 2.0 * race},
      {"the inner ring or pin", "support.stiffness and the rollers",
       "reduce support.stiffness, or state a smaller bearing.bore or a larger bearing.width", model.pin_mass,
       model.support.stiffness + races},
      {"the planet or outer ring", "the rollers",
       "state a heavier planet: gearset.face_width, gearset.module", model.bore_mass, races}};
  if (model.layout.caged) {
    bodies.push_back({"a roller", "bearing.cage.pocket_stiffness", "reduce it", model.roller.mass,
                      model.pocket.stiffness});
    bodies.push_back(
        {"the cage", "bearing.cage.pocket_stiffness",
         "reduce it, or state a heavier cage: bearing.cage.density, inner_diameter, outer_diameter, "
         "width",
         model.cage.mass, 0.5 * static_cast<double>(model.layout.rollers) * model.pocket.stiffness});
  }
  const auto fastest = std::max_element(bodies.begin(), bodies.end(), [](const Body& a, const Body& b) {
    return a.stiffness / a.mass < b.stiffness / b.mass;
  });
  std::ostringstream text;
  text << "the fastest vibration is that of " << fastest->name << " (" << fastest->mass << " kg) on "
       << fastest->on << " (" << fastest->stiffness << " N/m), with a period of "
       << constants::two_pi * std::sqrt(fastest->mass / fastest->stiffness) << " s; " << fastest->change;
  return text.str();
}

bool has_all_slopes(const bearing::motion::BearingModel& model) {
  using bearing::vectorised::turns_unevenly;
  return !model.layout.tilting && model.layout.waves == 0 && model.layout.followed == 0 &&
         !turns_unevenly(model.inner) && !turns_unevenly(model.outer);
}

int order_of_steps(const bearing::motion::BearingModel& model, bool shaken) {
  if (!impacts_are_damped(model) || !has_all_slopes(model)) return 2;
  if (slowness(model) > 1.0) return 4;
  return shaken && blows_are_damped(model) ? 4 : 3;
}

StepBounds third_order_steps(const bearing::vectorised::VectorBearing& bearing,
                             const Eigen::VectorXd& allowed_error) {
  const bearing::motion::BearingModel& model = bearing.model();
  if (!blows_are_damped(model))
    return {linearly_implicit_errors(bearing, kThirdOrderErrors * allowed_error),
            kThirdOrderSteps * longest_step(model)};
  std::vector<double> allowed = linearly_implicit_errors(bearing, allowed_error);
  const bearing::vectorised::PaddedLayout& layout = bearing.layout();
  const int lanes = layout.lanes(), cage = layout.cage(), bore = layout.bore();
  const auto scale = [&](int from, int to, double factor) {
    std::for_each(allowed.begin() + from, allowed.begin() + to, [&](double& error) { error *= factor; });
  };
  for (const int radial : {0, 2}) scale(radial * lanes, (radial + 1) * lanes, kDampedErrors);
  for (const int along : {1, 3, 4}) scale(along * lanes, (along + 1) * lanes, kDampedAlongErrors);
  scale(cage, bore, kDampedAlongErrors);
  scale(bore, bore + 4, kDampedBoreErrors);
  scale(layout.pin(), layout.size(), kDampedErrors);
  return {std::move(allowed), kDampedSteps * kStepOfImpact * ring_time(model),
          integration::StepRule::two_errors};
}

StepBounds fourth_order_steps(const bearing::vectorised::VectorBearing& bearing,
                              const Eigen::VectorXd& allowed_error) {
  return {linearly_implicit_errors(bearing, kFourthOrderErrors * allowed_error),
          kDampedSteps * kStepOfImpact * ring_time(bearing.model()), integration::StepRule::two_errors};
}

StepBounds steps_of_order(int order, const bearing::vectorised::VectorBearing& bearing,
                          const Eigen::VectorXd& allowed_error, double slow) {
  const Eigen::VectorXd allowed =
      allowed_error / std::pow(slow, order == 4 ? kSlowFourthOrderErrors : kSlowErrors);
  StepBounds bounds =
      order == 3   ? third_order_steps(bearing, allowed)
      : order == 4 ? fourth_order_steps(bearing, allowed)
                   : StepBounds{linearly_implicit_errors(bearing, allowed), longest_step(bearing.model())};
  bounds.longest *= slow;
  if (order == 2 && !bearing.model().layout.caged) {
    const auto radial_speeds = bounds.allowed.begin() + 2 * bearing.layout().lanes();
    std::for_each(radial_speeds, radial_speeds + bearing.layout().rollers,
                  [slow](double& error) { error *= slow; });
  }
  return bounds;
}

// A bar that has moved by half the thickness of its rollers holds them no longer; a roller off
// the pitch circle of the displaced rings by as much is on the other side of a race.
std::string out_of_place(const bearing::motion::BearingModel& model,
                         const Eigen::Ref<const Eigen::VectorXd>& x) {
  const auto now = bearing::motion::state_views(model.layout, x.data());
  const double limit = model.geometry.element_radius;
  const double cage = model.layout.caged ? (now.cage_position - now.pin_position).norm() : 0.0;
  std::ostringstream text;
  if (cage > limit)
    text << "the cage left the bearing: it is " << cage << " m off the pin";
  else if (const double off = (now.radius - model.geometry.pitch_radius).abs().maxCoeff(),
           rings = std::max(now.pin_position.norm(), now.bore_position.norm());
           off > limit + rings)
    text << "a roller left the bearing: it is " << off << " m off the pitch circle";
  else
    return {};
  text << "; required: at most the radius of a roller, " << limit << " m";
  if (cage > limit && !model.land.present)
    text << ". No land guides the cage: state bearing.cage.guide_land_diameter, the diameter of the ring's "
            "land that it runs on";
  return text.str();
}

std::vector<double> tilt_rates(const bearing::vectorised::PaddedLayout& layout, const double* from,
                               const double* to, double length) {
  if (!layout.tilting) return {};
  std::vector<double> rates(static_cast<std::size_t>(layout.rollers));
  constexpr std::ptrdiff_t kGroup = 5;  // radius, angle, their speeds and spin stand before
  const std::ptrdiff_t first = kGroup * layout.lanes();
  std::transform(to + first, to + first + layout.rollers, from + first, rates.begin(),
                 [length](double now, double before) { return (now - before) / length; });
  return rates;
}

WithinStep::WithinStep(double begin, const std::vector<double>& from, double end,
                       const std::vector<double>& to, double time, std::vector<double>& x)
    : from_(from), to_(to), x_(x), length_(end - begin), share_((time - begin) / length_) {
  for (std::size_t i = 0; i < from.size(); ++i) x[i] = from[i] + share_ * (to[i] - from[i]);
}

void WithinStep::bend(std::ptrdiff_t position, std::ptrdiff_t velocity, std::ptrdiff_t count) const {
  const double rise = share_ * (1.0 - share_);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto p = static_cast<std::size_t>(position + i), v = static_cast<std::size_t>(velocity + i);
    const double mean = to_[p] - from_[p];
    x_[p] += rise * ((1.0 - share_) * (length_ * from_[v] - mean) - share_ * (length_ * to_[v] - mean));
  }
}

void WithinStep::bend(const bearing::vectorised::PaddedLayout& layout, std::ptrdiff_t first) const {
  bend(first, first + 2 * layout.lanes(), 2 * layout.lanes());
  if (layout.caged) bend(first + layout.cage(), first + layout.cage() + 3, 3);
  bend(first + layout.bore(), first + layout.bore() + 2, 2);
  bend(first + layout.pin(), first + layout.pin() + 2, 2);
  bend(first + layout.wave(), first + layout.wave_speed(), layout.waves);
}

}  // namespace orbearing::system
