#include "bearing/defect/scratched_bearing.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "bearing/contact/damping.hpp"
#include "bearing/contact/line_contact.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/ring_balance.hpp"
#include "bearing/geometry.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::bearing::defect {

double rolling_speed(const Bearing& bearing, double inner_speed, double outer_speed) {
  const BearingGeometry geometry = geometry_of(bearing);
  const double gamma =
      geometry.slenderness;  // with the cosine of the contact angle, which the ratio of radii is without
  return 0.5 * (outer_speed - inner_speed) * geometry.pitch_radius / geometry.element_radius *
         (1.0 - gamma * gamma);
}

PassingFrequencies passing_frequencies(const Bearing& bearing, double shaft_speed) {
  return passing_frequencies(bearing, shaft_speed, 0.0);
}

PassingFrequencies passing_frequencies(const Bearing& bearing, double inner_speed, double outer_speed) {
  const double hertz = 1.0 / constants::two_pi;  // [Hz per rad/s]
  const BearingGeometry geometry = geometry_of(bearing);
  const double cage = kinematic_cage_speed(geometry, inner_speed, outer_speed);
  const double count = bearing.element_count();
  return {.shaft = std::abs(inner_speed - outer_speed) * hertz,
          .cage = std::abs(cage) * hertz,
          .outer_pass = count * std::abs(outer_speed - cage) * hertz,
          .inner_pass = count * std::abs(inner_speed - cage) * hertz,
          .element_pass = 2.0 * std::abs(rolling_speed(bearing, inner_speed, outer_speed)) * hertz};
}

void describe(described::Record& record, const PassingFrequencies& of) {
  using described::dimension::cycles;
  record.value("shaft_Hz", cycles, "inner ring relative to the outer ring", of.shaft);
  record.value("FTF_Hz", cycles, "fundamental train frequency: speed of the cage", of.cage);
  record.value("BPFO_Hz", cycles, "passing frequency of a defect of the outer race", of.outer_pass);
  record.value("BPFI_Hz", cycles, "passing frequency of a defect of the inner race", of.inner_pass);
  record.value("BSF_Hz", cycles,
               "spin frequency of a rolling element; its defect meets the races at twice this",
               0.5 * of.element_pass);
}

namespace {

constexpr double kHalfTurn = constants::pi;

// Q = constant approach^exponent of an element between both races.
struct PowerLaw {
  double constant;
  double exponent;
};

struct LawOf {
  const Bearing& bearing;

  PowerLaw operator()(const Balls&) const { return {equilibrium::BallRow(bearing).constant(), 1.5}; }
  PowerLaw operator()(const CylindricalRollers& rollers) const {
    const LineContact both = both_in_series(roller_race_contact(bearing.contact_law, rollers.length));
    return {both.constant(), LineContact::kExponent};
  }
};

// Continues below zero, as required for a smooth step across the opening.
double elastic(double constant, double exponent, double approach) {
  return std::copysign(constant * std::pow(std::abs(approach), exponent), approach);
}

}  // namespace

double weight_of(const VibratingRing& ring) {
  constexpr double kGravity = 9.80665;  // [m/s^2]
  return ring.mass * kGravity;
}

ScratchedMotion::ScratchedMotion(const ScratchedBearing& parameters)
    : in_(parameters), geometry_(geometry_of(parameters.bearing)) {
  mechanics::require_positive(in_.ring.mass, "mass of the outer ring [kg]");
  mechanics::require_positive(in_.load, "radial load [N]");
  const PowerLaw law = std::visit(LawOf{in_.bearing}, in_.bearing.elements);
  constant_ = law.constant;
  exponent_ = law.exponent;
  cosine_ = std::cos(in_.bearing.contact_angle());
  cage_speed_ = kinematic_cage_speed(geometry_, in_.shaft_speed, 0.0);
  first_angle_ = equilibrium::element_angles(in_.bearing);
  set_scratches();
  on_.setConstant(switches(), false);
  static_ = find_static_position();
  if (!static_.report.converged)
    mechanics::refuse("radial load [N]", in_.load, "one under which the ring finds a static equilibrium");
  set_damping();
}

void ScratchedMotion::set_scratches() {
  const Scratch& scratch = in_.scratch;
  if (scratch.race == Scratched::none) return;
  if (of_element(scratch.race)) {
    const bool balls = std::holds_alternative<Balls>(in_.bearing.elements);
    mechanics::require((scratch.race == Scratched::ball) == balls, "scratched element",
                       std::string(balls ? "a roller" : "a ball"), balls ? "a ball" : "a roller");
    mechanics::require(scratch.element >= 1 && scratch.element <= elements(), "scratched element",
                       scratch.element, "one of the bearing's, counted from 1");
  }
  require_sound(scratch);
  middle_ = angles_of(scratch);
  on_inner_ = scratch_law(scratch, Race::inner, geometry_);
  on_outer_ = scratch_law(scratch, Race::outer, geometry_);
  between_ = 2.0 * kHalfTurn;
  switch (scratch.race) {
    case Scratched::outer:
      track_speed_ = cage_speed_;
      track_radius_ = geometry_.outer_radius;
      return;
    case Scratched::inner:
      track_speed_ = cage_speed_ - in_.shaft_speed;
      track_radius_ = geometry_.inner_radius;
      return;
    case Scratched::ball:  // meets a race every half turn
    case Scratched::roller:
      track_speed_ = rolling_speed(in_.bearing, in_.shaft_speed, 0.0);
      track_radius_ = geometry_.element_radius;
      between_ = kHalfTurn;
      return;
    case Scratched::none:
      return;
  }
}

double ScratchedMotion::from_middle(Eigen::Index element, Eigen::Index scratch, double time) const {
  const bool own = of_element(in_.scratch.race);
  if (own && element != in_.scratch.element - 1) return std::numeric_limits<double>::max();
  const double start = own ? 0.0 : first_angle_[element];
  const double angle =
      start - middle_[static_cast<std::size_t>(scratch)] + track_speed_ * in_.run_up.turned_at(time);
  return track_radius_ * std::remainder(angle, between_);
}

DefectDepth<double> ScratchedMotion::depth_of(Eigen::Index element, double time) const {
  DefectDepth<double> sum;
  const auto scratches = static_cast<Eigen::Index>(middle_.size());
  for (Eigen::Index i = 0; i < scratches; ++i) {
    if (!on_[elements() + element * scratches + i]) continue;
    bool outer = in_.scratch.race == Scratched::outer;
    if (of_element(in_.scratch.race)) {
      const double turned = track_speed_ * in_.run_up.turned_at(time) - middle_[static_cast<std::size_t>(i)];
      outer = std::abs(std::remainder(turned, 2.0 * kHalfTurn)) < 0.5 * kHalfTurn;
    }
    const DefectDepth<double> one =
        defect_depth(outer ? on_outer_ : on_inner_, from_middle(element, i, time));
    sum.depth += one.depth;
    sum.slope += one.slope;
  }
  return sum;
}

ScratchedMotion::Contact ScratchedMotion::contact(Eigen::Index element, double time,
                                                  const ConstState& x) const {
  const double share = in_.run_up.share_at(time);
  Contact now{.angle = first_angle_[element] + cage_speed_ * in_.run_up.turned_at(time)};
  const double cosine = std::cos(now.angle), sine = std::sin(now.angle);
  const DefectDepth<double> element_depth = depth_of(element, time);
  const double along = x[0] * cosine + x[1] * sine, across = x[1] * cosine - x[0] * sine;
  now.approach = (along - 0.5 * in_.bearing.radial_clearance) * cosine_ - element_depth.depth;
  now.approach_speed = (x[2] * cosine + x[3] * sine + share * cage_speed_ * across) * cosine_ -
                       element_depth.slope * track_radius_ * share * track_speed_;
  if (!on_[element]) return now;
  now.elastic_load = elastic(constant_, exponent_, now.approach);
  now.load = in_.ring.damping_law == DampingLaw::viscous
                 ? now.elastic_load + damping_ * now.approach_speed
                 : damped_load(now.elastic_load, damping_, now.approach_speed).load;
  return now;
}

void ScratchedMotion::rates(double time, const ConstState& x, Eigen::Ref<Eigen::VectorXd> dx) const {
  Eigen::Vector2d force(in_.load + weight(), 0.0);
  for (Eigen::Index j = 0; j < elements(); ++j) {
    if (!on_[j]) continue;
    const Contact now = contact(j, time, x);
    force -= now.load * cosine_ * Eigen::Vector2d(std::cos(now.angle), std::sin(now.angle));
  }
  dx.head<2>() = x.tail<2>();
  dx.tail<2>() = force / in_.ring.mass;
}

void ScratchedMotion::switch_values(double time, const ConstState& x,
                                    Eigen::Ref<Eigen::ArrayXd> values) const {
  const auto scratches = static_cast<Eigen::Index>(middle_.size());
  for (Eigen::Index j = 0; j < elements(); ++j) {
    values[j] = contact(j, time, x).approach;
    for (Eigen::Index i = 0; i < scratches; ++i)
      values[elements() + j * scratches + i] = 0.5 * in_.scratch.width - std::abs(from_middle(j, i, time));
  }
}

double ScratchedMotion::passing_time() const {
  if (middle_.empty()) return std::numeric_limits<double>::infinity();
  return in_.scratch.width / (track_radius_ * std::abs(track_speed_));
}

double ScratchedMotion::weight() const {
  return weight_of(in_.ring);
}

StaticPosition ScratchedMotion::find_static_position() const {
  StaticPosition found{.load = Eigen::ArrayXd::Zero(elements())};
  const double force = in_.load + weight();
  const auto imbalance_at = [&](const Eigen::Vector2d& position) {
    mechanics::Imbalance<2> sum{.force = {force, 0.0}, .scale = force};
    for (Eigen::Index j = 0; j < elements(); ++j) {
      const Eigen::Vector2d direction(std::cos(first_angle_[j]), std::sin(first_angle_[j]));
      const double approach = (position.dot(direction) - 0.5 * in_.bearing.radial_clearance) * cosine_;
      found.load[j] = approach > 0.0 ? elastic(constant_, exponent_, approach) : 0.0;
      if (approach <= 0.0) continue;
      sum.force -= found.load[j] * cosine_ * direction;
      sum.stiffness +=
          exponent_ * found.load[j] / approach * cosine_ * cosine_ * direction * direction.transpose();
    }
    return sum;
  };
  const double elastic_length = std::pow(force / constant_, 1.0 / exponent_);
  const mechanics::SearchLimits limits{.reach = 4.0 * elastic_length + std::abs(in_.bearing.radial_clearance),
                                       .size = std::abs(in_.bearing.radial_clearance),
                                       .tolerance = 1e-13};
  mechanics::Imbalance<2> now;
  found.report = mechanics::find_balance<2>(imbalance_at, limits, found.position, now);
  now = imbalance_at(found.position);
  found.stiffness = now.stiffness(0, 0);
  found.natural_frequency = std::sqrt(found.stiffness / in_.ring.mass) / (2.0 * kHalfTurn);
  return found;
}

// Damping of all loaded contacts together: the stated share of 2 sqrt(k m) along the load.
void ScratchedMotion::set_damping() {
  const double wanted = 2.0 * in_.ring.damping_ratio * std::sqrt(static_.stiffness * in_.ring.mass);
  const bool viscous = in_.ring.damping_law == DampingLaw::viscous;
  const Eigen::ArrayXd share = (cosine_ * first_angle_.cos()).square();
  const double sum = viscous ? (static_.load > 0.0).select(share, 0.0).sum() : (static_.load * share).sum();
  damping_ = wanted / sum;
}

}  // namespace orbearing::bearing::defect
