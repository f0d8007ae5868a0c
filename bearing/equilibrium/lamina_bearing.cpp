#include "bearing/equilibrium/lamina_bearing.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <sstream>

#include "bearing/equilibrium/elastic_waves.hpp"
#include "bearing/plane.hpp"
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

// What the balance of one cage angle is computed from, and the rollers that settle on the way.
struct Rollers {
  const LaminaBearing& bearing;
  const RaceEquilibrium& problem;
  Eigen::ArrayXd outer_end_displacement;  // [m]  (rollers)
  SettlingRollers settling;
};

struct SettledRoller {
  double outer_load = 0.0;  // [N]
  double stiffness = 0.0;   // [N/m]
};

// Forces on the outer ring with all rollers settled.
template <int N>
mechanics::Imbalance<N> imbalance_at(const Rollers& rollers, const RingCoordinates<N>& ring,
                                     const Eigen::Vector<double, N>& place) {
  return ring.imbalance(place, [&](Eigen::Index j, double approach) {
    const RollerState& state = rollers.settling.settle(j, approach, rollers.outer_end_displacement[j]);
    return SettledRoller{state.outer.load, state.stiffness};
  });
}

Eigen::ArrayXd outer_tips(const LaminaBearing& bearing, const OperatingPoint& point,
                          const RaceEquilibrium& problem) {
  return bearing.half_length() *
         (problem.angle.cos() * point.bore_tilt.x() + problem.angle.sin() * point.bore_tilt.y());
}

// The rigid contacts' reach, with what profiles and tilt add.
mechanics::SearchLimits limits_of(const Rollers& rollers) {
  mechanics::SearchLimits limits = search_limits(rollers.problem);
  const double more = 2.0 * largest_drop(rollers.bearing) + rollers.outer_end_displacement.abs().maxCoeff();
  limits.size += more + limits.reach;
  limits.reach += more;
  return limits;
}

std::string failure_text(const RaceEquilibrium& problem, double residual) {
  std::ostringstream text;
  text << "the races found no balance on laminae under " << problem.load.norm() << " N: " << residual
       << " N remain; check clearance, profiles and tilt";
  return text.str();
}

void put_report(const RaceEquilibrium& problem, const mechanics::SearchReport& search, LaminaState& state) {
  state.report = {search};
  state.report.converged = are_settled(state.rollers) && search.converged;
  if (!state.report.converged) state.report.message = failure_text(problem, state.report.residual);
}

}  // namespace

SettlingRollers::SettlingRollers(const LaminaBearing& bearing, const RaceEquilibrium& problem,
                                 std::vector<RollerState>& states)
    : roller_{bearing.contact(Race::inner), bearing.contact(Race::outer), problem.contacts.inner.film(),
              problem.contacts.outer.film()},
      problem_(problem),
      states_(states) {}

const RollerState& SettlingRollers::settle(Eigen::Index j, double approach,
                                           double outer_end_displacement) const {
  RollerState& state = states_[static_cast<std::size_t>(j)];
  settle_roller(roller_, {approach, 0.0, outer_end_displacement, problem_.inertial_load[j]}, state);
  return state;
}

Eigen::Vector2d force_on_bore(const LaminaState& state) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (Eigen::Index j = 0; j < state.angle.size(); ++j)
    sum += state.rollers[static_cast<std::size_t>(j)].outer.load * direction(state.angle[j]);
  return sum;
}

Eigen::Vector2d moment_on_bore(const LaminaBearing& bearing, const LaminaState& state) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (Eigen::Index j = 0; j < state.angle.size(); ++j)
    sum += bearing.half_length() * state.rollers[static_cast<std::size_t>(j)].outer.end_load *
           direction(state.angle[j]);
  return sum;
}

bool are_settled(const std::vector<RollerState>& rollers) {
  return std::all_of(rollers.begin(), rollers.end(),
                     [](const RollerState& roller) { return roller.settled; });
}

double largest_drop(const LaminaBearing& bearing) {
  return std::max(bearing.contact(Race::inner).greatest_drop(), bearing.contact(Race::outer).greatest_drop());
}

void put_position(const LaminaBearing& bearing, LaminaState state, Eigen::Index position,
                  Eigen::Index positions, LaminaResult& result) {
  const double part = 1.0 / static_cast<double>(positions);
  result.displacement += part * state.displacement;
  add_form(state.waves, part, result.angle, result.race_form);
  result.moment += part * state.moment;
  keep_worst(state.report, result.report);
  for (Eigen::Index j = 0; j < state.angle.size(); ++j) {
    const RollerState& roller = state.rollers[static_cast<std::size_t>(j)];
    const Eigen::Index place = position + j * positions;
    result.inner_load[place] = roller.inner.load;
    result.outer_load[place] = roller.outer.load;
    result.roller_tilt[place] = roller.end_displacement / bearing.half_length();
    bearing.contact(Race::inner)
        .put_loads(roller.inner_approach(), roller.inner_end_displacement,
                   result.inner_lamina_load.col(place).data());
    bearing.contact(Race::outer)
        .put_loads(roller.outer_approach, roller.outer_end_displacement,
                   result.outer_lamina_load.col(place).data());
  }
  result.states.push_back(std::move(state));
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
  result.race_form = Eigen::ArrayXd::Zero(places);
  result.report.converged = true;
  return result;
}

LaminaBearing::LaminaBearing(const Bearing& bearing, mechanics::InstructionSet set)
    : bearing_(sound(bearing)),
      geometry_(geometry_of(bearing_)),
      inner_(contact_of(bearing_, Race::inner, set)),
      outer_(contact_of(bearing_, Race::outer, set)) {}

namespace {

// From the place of a ring in a neighbouring balance, or from where the load would displace it.
template <int N>
Eigen::Vector<double, N> start_of(const RingCoordinates<N>& ring, const RaceEquilibrium& problem,
                                  const LaminaState* near) {
  if (near == nullptr) return ring.start(first_displacement(problem));
  Eigen::Vector<double, N> place = ring.start(near->displacement);
  place.tail(near->waves.size()) = near->waves;
  return place;
}

template <int N>
mechanics::SearchReport settle_ring(const Rollers& rollers, const LaminaState* near, LaminaState& state) {
  const RingCoordinates<N> ring(rollers.problem);
  Eigen::Vector<double, N> place = start_of<N>(ring, rollers.problem, near);
  mechanics::Imbalance<N> now;
  const mechanics::SearchReport search = mechanics::find_balance<N>(
      [&](const Eigen::Vector<double, N>& at) { return imbalance_at<N>(rollers, ring, at); },
      limits_of(rollers), place, now);
  state.displacement = place.template head<2>();
  state.stiffness = without_waves<N>(now);
  state.waves = place.tail(place.size() - 2);
  return search;
}

}  // namespace

LaminaState lamina_state(const LaminaBearing& bearing, const OperatingPoint& point,
                         const QuasiStaticOptions& options, double first_roller, const LaminaState* near) {
  const RaceEquilibrium problem =
      quasi_static_problem(bearing.bearing(), bearing.geometry(), point, options, first_roller);
  LaminaState state;
  if (near != nullptr) state.rollers = near->rollers;
  state.rollers.resize(static_cast<std::size_t>(problem.angle.size()));
  const Rollers rollers{
      bearing, problem, outer_tips(bearing, point, problem), {bearing, problem, state.rollers}};
  const mechanics::SearchReport search = problem.outer_race.is_rigid()
                                             ? settle_ring<2>(rollers, near, state)
                                             : settle_ring<Eigen::Dynamic>(rollers, near, state);
  state.angle = problem.angle;
  state.moment = moment_on_bore(bearing, state);
  put_report(problem, search, state);
  return state;
}

LaminaResult quasi_static_laminae(const LaminaBearing& bearing, const OperatingPoint& point,
                                  const QuasiStaticOptions& options) {
  require_equal_pitches(bearing.bearing());
  LaminaResult result = empty_result(bearing, point, options);
  const int positions = options.cage_positions;
  for (int position = 0; position < positions; ++position) {
    const LaminaState* near = result.states.empty() ? nullptr : &result.states.back();
    put_position(bearing, lamina_state(bearing, point, options, result.angle[position], near), position,
                 positions, result);
  }
  return result;
}

}  // namespace orbearing::bearing::laminae
