#include "bearing/equilibrium/lamina_bearing.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <sstream>

#include "mechanics/convex_search.hpp"

namespace orbearing::bearing::laminae {

namespace {

const Bearing& sound(const Bearing& bearing) {
  for (const profile::Profile* profile :
       {&bearing.rollers().profile, &bearing.inner.profile, &bearing.outer.profile})
    profile::require_sound(*profile);
  return bearing;
}

LaminaContact contact_of(const Bearing& bearing, Race race, mechanics::InstructionSet set) {
  const CylindricalRollers& rollers = bearing.rollers();
  return {lamina_law(roller_race_contact(bearing.contact_law, rollers.length)), rollers.length,
          lamina_drops(rollers.profile, bearing.ring(race).profile, rollers.length, rollers.laminae), set};
}

// Forces on the outer ring with all rollers settled.
struct Ring {
  const LaminaBearing& bearing;
  const OperatingPoint& point;
  const RaceEquilibrium& problem;
  Eigen::Matrix2Xd outward;  // [-]  (rollers)
  Eigen::ArrayXd outer_tip;  // [m]  (rollers)
  std::vector<RollerState>& rollers;

  double scale() const { return std::max(problem.load.norm(), problem.inertial_load.abs().maxCoeff()); }

  mechanics::Imbalance<2> operator()(const Eigen::Vector2d& displacement) const {
    const TiltedRoller roller{bearing.contact(Race::inner), bearing.contact(Race::outer),
                              problem.contacts.inner.film(), problem.contacts.outer.film()};
    mechanics::Imbalance<2> slope;
    slope.force = problem.load;
    slope.scale = scale();
    for (Eigen::Index j = 0; j < outward.cols(); ++j) {
      RollerState& state = rollers[static_cast<std::size_t>(j)];
      settle_roller(roller, {approach(j, displacement), 0.0, outer_tip[j], problem.inertial_load[j]}, state);
      slope.force += state.outer.load * outward.col(j);
      slope.stiffness += state.stiffness * outward.col(j) * outward.col(j).transpose();
    }
    return slope;
  }

  double approach(Eigen::Index j, const Eigen::Vector2d& displacement) const {
    const double round = -0.5 * problem.clearance - displacement.dot(outward.col(j));
    return problem.extra_approach.size() == 0 ? round : round + problem.extra_approach[j];
  }
};

Ring ring_of(const LaminaBearing& bearing, const OperatingPoint& point, const RaceEquilibrium& problem,
             std::vector<RollerState>& rollers) {
  const Eigen::Index count = problem.angle.size();
  Ring ring{bearing, point, problem, Eigen::Matrix2Xd(2, count), Eigen::ArrayXd(count), rollers};
  ring.outward.row(0) = problem.angle.cos().matrix();
  ring.outward.row(1) = problem.angle.sin().matrix();
  ring.outer_tip = bearing.half_length() * (ring.outward.transpose() * point.bore_tilt).array();
  return ring;
}

double largest_drop(const LaminaBearing& bearing) {
  return std::max(bearing.contact(Race::inner).greatest_drop(), bearing.contact(Race::outer).greatest_drop());
}

// The lengths [m] by which the races miss each other where they are concentric.
double gaps(const Ring& ring) {
  const Eigen::ArrayXd& extra = ring.problem.extra_approach;
  return std::abs(ring.problem.clearance) + (extra.size() == 0 ? 0.0 : 2.0 * extra.abs().maxCoeff()) +
         2.0 * largest_drop(ring.bearing) + ring.outer_tip.abs().maxCoeff();
}

mechanics::SearchLimits limits_of(const Ring& ring) {
  const RaceEquilibrium& problem = ring.problem;
  const double all = problem.load.norm() + problem.inertial_load.abs().sum();
  const double elastic =
      problem.contacts.inner.elastic().approach(all) + problem.contacts.outer.elastic().approach(all);
  const double known = gaps(ring);
  return {.reach = std::max(known, 1e-6) + elastic, .size = known + elastic};
}

std::string failure_text(const RaceEquilibrium& problem, double residual) {
  std::ostringstream text;
  text << "the races found no balance on laminae under " << problem.load.norm() << " N: " << residual
       << " N remain; check clearance, profiles and tilt";
  return text.str();
}

void put_report(const Ring& ring, const mechanics::SearchReport& search, LaminaState& state) {
  const bool rollers_settled =
      std::all_of(state.rollers.begin(), state.rollers.end(), [](const RollerState& r) { return r.settled; });
  state.report = {search};
  state.report.converged = rollers_settled && search.converged;
  if (!state.report.converged) state.report.message = failure_text(ring.problem, state.report.residual);
}

void put_position(const LaminaBearing& bearing, const LaminaState& state, Eigen::Index position,
                  Eigen::Index positions, LaminaResult& result) {
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const RollerState& roller = state.rollers[static_cast<std::size_t>(j)];
    const Eigen::Index place = position + j * positions;
    result.inner_load[place] = roller.inner.load;
    result.outer_load[place] = roller.outer.load;
    result.roller_tilt[place] = roller.tip / bearing.half_length();
    bearing.contact(Race::inner)
        .put_loads(roller.inner_approach(), roller.inner_tip, result.inner_lamina_load.col(place).data());
    bearing.contact(Race::outer)
        .put_loads(roller.outer_approach, roller.outer_tip, result.outer_lamina_load.col(place).data());
  }
}

LaminaResult empty_result(const LaminaBearing& bearing, const OperatingPoint& point,
                          const QuasiStaticOptions& options) {
  const Bearing& b = bearing.bearing();
  const int places = options.cage_positions * b.rollers().count;
  LaminaResult result;
  result.angle =
      options.first_roller +
      Eigen::ArrayXd::LinSpaced(places, 0.0, boost::math::double_constants::two_pi * (places - 1) / places);
  for (Eigen::ArrayXd* array : {&result.inner_load, &result.outer_load, &result.roller_tilt})
    array->resize(places);
  for (Eigen::ArrayXXd* array : {&result.inner_lamina_load, &result.outer_lamina_load})
    array->resize(b.rollers().laminae, places);
  result.total_bore_load = total_bore_load(b, bearing.geometry(), point, options.inertia);
  result.report.converged = true;
  return result;
}

}  // namespace

LaminaBearing::LaminaBearing(const Bearing& bearing, mechanics::InstructionSet set)
    : bearing_(sound(bearing)),
      geometry_(geometry_of(bearing_)),
      inner_(contact_of(bearing_, Race::inner, set)),
      outer_(contact_of(bearing_, Race::outer, set)) {}

LaminaState lamina_state(const LaminaBearing& bearing, const OperatingPoint& point,
                         const QuasiStaticOptions& options, double first_roller, const LaminaState* near) {
  const RaceEquilibrium problem =
      quasi_static_problem(bearing.bearing(), bearing.geometry(), point, options, first_roller);
  LaminaState state;
  if (near != nullptr) state.rollers = near->rollers;
  state.rollers.resize(static_cast<std::size_t>(problem.angle.size()));
  state.displacement = near != nullptr ? near->displacement : first_displacement(problem);
  const Ring ring = ring_of(bearing, point, problem, state.rollers);
  mechanics::Imbalance<2> now;
  const mechanics::SearchReport search =
      mechanics::find_balance<2>(ring, limits_of(ring), state.displacement, now);
  state.angle = problem.angle;
  for (Eigen::Index j = 0; j < state.angle.size(); ++j)
    state.moment += bearing.half_length() * state.rollers[static_cast<std::size_t>(j)].outer.tip_load *
                    ring.outward.col(j);
  put_report(ring, search, state);
  return state;
}

LaminaResult quasi_static_laminae(const LaminaBearing& bearing, const OperatingPoint& point,
                                  const QuasiStaticOptions& options) {
  require_equal_pitches(bearing.bearing());
  LaminaResult result = empty_result(bearing, point, options);
  const int positions = options.cage_positions;
  for (int position = 0; position < positions; ++position) {
    const LaminaState* near = result.states.empty() ? nullptr : &result.states.back();
    LaminaState state = lamina_state(bearing, point, options, result.angle[position], near);
    put_position(bearing, state, position, positions, result);
    result.displacement += state.displacement / positions;
    result.moment += state.moment / positions;
    keep_worst(state.report, result.report);
    result.states.push_back(std::move(state));
  }
  return result;
}

}  // namespace orbearing::bearing::laminae
