#include "bearing/equilibrium/tilted_roller.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "mechanics/convex_search.hpp"

namespace orbearing::bearing::laminae {

namespace {

constexpr double kRollerTolerance = 1e-13;  // of the loads
constexpr double kRollerRoundOff = 2e-16;   // of the lengths at hand
constexpr int kMostFilmSteps = 60;

using RollerImbalance = mechanics::Imbalance<2>;

// The roller between races whose elastic approaches add up to `elastic`: the energy of both contacts and of
// the inertial load is convex in its position and end displacement.
struct DryRoller {
  const TiltedRoller& roller;
  const RollerSetting& setting;
  double elastic;
  RollerState& state;

  RollerImbalance operator()(const Eigen::Vector2d& at) const {
    const double cosine = roller.taper_cosine;
    state.inner = roller.inner.evaluate((elastic - at[0]) / cosine, setting.inner_end_displacement - at[1]);
    state.outer = roller.outer.evaluate(at[0], at[1] - setting.outer_end_displacement);
    const LaminaForce &in = state.inner, &out = state.outer;
    RollerImbalance slope;
    slope.force << (setting.inertial_load + in.load) / cosine - out.load, in.end_load - out.end_load;
    slope.stiffness = settling_stiffness(state);
    slope.scale = std::abs(setting.inertial_load) + in.load + out.load;
    return slope;
  }
};

double lengths_at_hand(const TiltedRoller& roller, const RollerSetting& setting, double elastic) {
  return std::abs(elastic) + std::abs(setting.approach) + std::abs(setting.inner_end_displacement) +
         std::abs(setting.outer_end_displacement) +
         std::max(roller.inner.greatest_drop(), roller.outer.greatest_drop());
}

// Elastic approach of a straight contact [m].
double straight_approach(const LaminaContact& contact, double load) {
  return load > 0.0 ? contact.whole().approach(load) : 0.0;
}

// Rather too deep than not in contact: an untilted roller between the tilted races.
Eigen::Vector2d first_guess(const TiltedRoller& roller, const RollerSetting& setting, double elastic) {
  const double load = setting.inertial_load, half = 0.5 * elastic;
  const double outer = load > 0.0 ? std::max(half, straight_approach(roller.outer, load)) : half;
  const double position =
      load < 0.0 ? std::min(half, elastic - straight_approach(roller.inner, -load)) : outer;
  return {position, 0.5 * (setting.inner_end_displacement + setting.outer_end_displacement)};
}

mechanics::SearchLimits limits_of(const TiltedRoller& roller, const RollerSetting& setting, double elastic) {
  const double lengths = lengths_at_hand(roller, setting, elastic);
  return {.reach = lengths + straight_approach(roller.outer, std::abs(setting.inertial_load)) + 1e-9,
          .size = lengths,
          .tolerance = kRollerTolerance,
          .resolution = kRollerRoundOff};
}

// Zero of a force that falls from at least zero at `low` to at most zero at `high`, to the last bit.
template <class Force>
double zero_of_falling(const Force& force, double low, double high) {
  std::uintmax_t most = 200;
  const double at_low = force(low), at_high = force(high);
  if (!(at_low > 0.0)) return low;
  if (!(at_high < 0.0)) return high;
  const auto [left, right] = boost::math::tools::toms748_solve(
      force, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(), most);
  return std::abs(force(left)) <= std::abs(force(right)) ? left : right;
}

// The same least of the energy by two searches, one within the other, each along one unknown in which the
// force falls: slow, and sure where a lamina or two barely touch and Newton's steps lead to and fro. The
// energy that is least in the position is convex in the end displacement.
RollerImbalance converge_within_brackets(const DryRoller& roller, double reach, Eigen::Vector2d& at) {
  RollerImbalance now;
  const auto converge_position = [&](double end_displacement) {
    at[1] = end_displacement;
    at[0] = zero_of_falling(
        [&](double position) {
          return roller({position, end_displacement}).force[0];
        },
        -reach, reach);
    now = roller(at);
    return now.force[1];
  };
  converge_position(zero_of_falling(converge_position, -reach, reach));
  return now;
}

// Slopes of the settled roller by the sum of the elastic approaches: d(energy slope)/d(elastic) is minus the
// inner contact's stiffness.
double put_slopes(const RollerImbalance& now, RollerState& state) {
  const double cosine = state.taper_cosine, by_approach = state.inner.by_approach / (cosine * cosine);
  const Eigen::Vector2d by_elastic(by_approach, state.inner.mixed / cosine);
  state.per_elastic = mechanics::lengths_under<2>(by_elastic, now.stiffness);
  return std::max(0.0, by_approach - by_elastic.dot(state.per_elastic));
}

// Settles the roller for one sum of elastic approaches; returns d(load)/d(that sum).
double converge_dry(const TiltedRoller& roller, const RollerSetting& setting, double elastic,
                    RollerState& state) {
  Eigen::Vector2d at = first_guess(roller, setting, elastic);
  if (state.known)
    at = Eigen::Vector2d(state.outer_approach, state.end_displacement) +
         (elastic - state.elastic) * state.per_elastic;
  RollerImbalance now;
  const DryRoller problem{roller, setting, elastic, state};
  const mechanics::SearchLimits limits = limits_of(roller, setting, elastic);
  const mechanics::SearchReport report = mechanics::find_balance<2>(problem, limits, at, now);
  if (!report.converged) now = converge_within_brackets(problem, 2.0 * limits.reach, at);
  state.known = true;
  state.settled = report.converged || mechanics::is_balanced<2>(now, at, limits);
  state.elastic = elastic;
  state.outer_approach = at[0];
  state.end_displacement = at[1];
  return put_slopes(now, state);
}

// The films take part of the approach: elastic - h_i - h_o = approach, whose left side grows with the elastic
// part at least as fast as that, for films thin under load.
void converge_with_film(const TiltedRoller& roller, const RollerSetting& setting, RollerState& state) {
  const Film &in = roller.inner_film, &out = roller.outer_film;
  double low = setting.approach, high = setting.approach + in.cap() + out.cap();
  double elastic =
      state.known ? state.elastic + state.per_approach * (setting.approach - state.approach) : high;
  elastic = std::clamp(elastic, low, high);
  const double smallest = kRollerRoundOff * lengths_at_hand(roller, setting, elastic);
  for (int i = 0; i < kMostFilmSteps; ++i) {
    const double dry_stiffness = converge_dry(roller, setting, elastic, state);
    const double excess =
        elastic - in.central(state.inner.load) - out.central(state.outer.load) - setting.approach;
    const double growth = 1.0 - (in.slope(state.inner.load) + out.slope(state.outer.load)) * dry_stiffness;
    state.per_approach = 1.0 / growth;
    state.stiffness = dry_stiffness / growth;
    (excess > 0.0 ? high : low) = elastic;
    double next = elastic - excess / growth;
    if (next < low || next > high) next = 0.5 * (low + high);
    if (std::abs(next - elastic) <= smallest) break;
    elastic = next;
  }
}

// By approach and end displacement of one contact [N/m].
Eigen::Matrix2d contact_stiffness(const LaminaForce& force) {
  Eigen::Matrix2d stiffness;
  stiffness << force.by_approach, force.mixed, force.mixed, force.by_end_displacement;
  return stiffness;
}

constexpr double kSingular = 1e-14;  // of a determinant over the square of the trace

// A contact that a single lamina touches holds no tilt about it: then that of what it does hold.
Eigen::Matrix2d pseudo_inverse(const Eigen::Matrix2d& symmetric) {
  const double size = symmetric.trace();
  if (!(size > 0.0)) return Eigen::Matrix2d::Zero();
  if (symmetric.determinant() > kSingular * size * size) return symmetric.inverse();
  return symmetric / (size * size);
}

}  // namespace

// Both contacts in series, where one of them or both may be open or hold no tilt; then the films, which yield
// with the load alone.
Eigen::Matrix2d roller_stiffness(const RollerState& roller) {
  const Eigen::Vector2d taper(1.0 / roller.taper_cosine, 1.0);
  const Eigen::Matrix2d inner = taper.asDiagonal() * contact_stiffness(roller.inner) * taper.asDiagonal(),
                        outer = contact_stiffness(roller.outer);
  Eigen::Matrix2d series = inner * pseudo_inverse(inner + outer) * outer;
  series = 0.5 * (series + series.transpose()).eval();
  if (!(series(0, 0) > 0.0)) return Eigen::Matrix2d::Zero();
  const double share = roller.stiffness / series(0, 0);  // that the films leave
  series(1, 1) -= (1.0 - share) * series(0, 1) * series(1, 0) / series(0, 0);
  series(0, 0) *= share;
  series(0, 1) *= share;
  series(1, 0) *= share;
  return series;
}

void converge_roller(const TiltedRoller& roller, const RollerSetting& setting, RollerState& state) {
  const bool dry = roller.inner_film.cap() == 0.0 && roller.outer_film.cap() == 0.0;
  state.taper_cosine = roller.taper_cosine;
  if (dry) {
    state.per_approach = 1.0;
    state.stiffness = converge_dry(roller, setting, setting.approach, state);
  } else {
    converge_with_film(roller, setting, state);
  }
  state.approach = setting.approach;
  state.inner_end_displacement = setting.inner_end_displacement - state.end_displacement;
  state.outer_end_displacement = state.end_displacement - setting.outer_end_displacement;
}

void converge_element(const Element& element, const RollerSetting& setting, RollerState& state) {
  const auto* uncut = std::get_if<WholeElement>(&element);
  if (!uncut) return converge_roller(std::get<TiltedRoller>(element), setting, state);
  const RollerBalance whole = balance_whole(*uncut, setting.inertial_load, setting.approach);
  state.inner.load = whole.inner_load;
  state.outer.load = whole.outer_load;
  state.stiffness = whole.stiffness;
  state.settled = true;
}

}  // namespace orbearing::bearing::laminae
