#include "bearing/equilibrium/balance_slopes.hpp"

#include <cmath>

#include "bearing/contact/line_law.hpp"
#include "mechanics/sparse_dual.hpp"

namespace orbearing::bearing::laminae {

namespace {

using Contact = BalanceSlopes::Contact;
using Dual = mechanics::SparseDual<1u, double>;  // a number with its slope along one change

Dual number_along(double value, double slope) {
  return {value, {slope}};
}

// Eq. (1) of one of `n` laminae with the approach left to it, > 0, and ln of the whole contact's constant.
template <class LogStiffness, class Approach>
auto lamina_load(const LogStiffness& log_stiffness, const Approach& approach, double n) {
  using mechanics::exponential, mechanics::logarithm;
  return exponential(kLineExponent * logarithm(approach) + log_stiffness) * (1.0 / n);
}

Dual central_film(const FilmNumbers& film, const FilmNumbers& change, const Dual& load) {
  using mechanics::exponential, mechanics::logarithm;
  const FilmLaw<Dual> law{number_along(film.log_factor, change.log_factor),
                          number_along(film.log_cap_load, change.log_cap_load)};
  const Dual speed = number_along(film.log_speed, change.log_speed);
  return load.value > 0.0 ? exponential(law.log_central(logarithm(load), speed))
                          : exponential(law.log_unloaded(speed));
}

Contact contact_at(const ContactPlace& place, double log_stiffness, const Eigen::ArrayXd& drop,
                   const Film& film) {
  const Eigen::Index n = drop.size();
  Contact contact{.load = Eigen::ArrayXd::Zero(n), .slope = Eigen::ArrayXd::Zero(n), .oiled = film.oiled()};
  const std::vector<double> stations = lamina_places(static_cast<int>(n));
  contact.station = Eigen::Map<const Eigen::ArrayXd>(stations.data(), n);
  contact.approach = place.approach + place.end_displacement * contact.station - drop;
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!(contact.approach[k] > 0.0)) continue;
    const Dual load =
        lamina_load(log_stiffness, number_along(contact.approach[k], 1.0), static_cast<double>(n));
    contact.load[k] = load.value;
    contact.slope[k] = load.by<0>();
  }
  const Eigen::ArrayXd& s = contact.station;
  const double mixed = (contact.slope * s).sum();
  contact.force << contact.load.sum(), (contact.load * s).sum();
  contact.stiffness << contact.slope.sum(), mixed, mixed, (contact.slope * s * s).sum();
  contact.film_slope = film.slope(contact.force[0]);
  return contact;
}

// Slopes of the lamina loads while the bodies stand.
Eigen::ArrayXd standing_slopes(const Contact& contact, double log_stiffness, double log_stiffness_change,
                               const Eigen::ArrayXd& drop_change) {
  Eigen::ArrayXd slopes = Eigen::ArrayXd::Zero(contact.load.size());
  const Dual stiffness = number_along(log_stiffness, log_stiffness_change);
  for (Eigen::Index k = 0; k < slopes.size(); ++k)
    if (contact.approach[k] > 0.0)
      slopes[k] = lamina_load(stiffness, number_along(contact.approach[k], -drop_change[k]),
                              static_cast<double>(slopes.size()))
                      .by<0>();
  return slopes;
}

Eigen::Vector2d force_of(const Eigen::ArrayXd& loads, const Contact& contact) {
  return {loads.sum(), (loads * contact.station).sum()};
}

double film_change(const Contact& contact, const FilmNumbers& film, const FilmNumbers& change,
                   double load_change) {
  if (!contact.oiled) return 0.0;
  return central_film(film, change, number_along(contact.force[0], load_change)).by<0>();
}

// Eq. (17) by (a_i, b_i, a_o, b_o), its forces over `scale`.
Eigen::Matrix4d settling_matrix(const Contact& inner, const Contact& outer, double scale) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix.row(0) << 1.0, 0.0, 1.0, 0.0;
  matrix.row(0).head<2>() -= inner.film_slope * inner.stiffness.row(0);
  matrix.row(0).tail<2>() -= outer.film_slope * outer.stiffness.row(0);
  matrix.row(1) << 0.0, 1.0, 0.0, 1.0;
  matrix.bottomLeftCorner<2, 2>() = -inner.stiffness / scale;
  matrix.bottomRightCorner<2, 2>() = outer.stiffness / scale;
  return matrix;
}

FilmNumbers numbers_of(const Film& film) {
  return {film.law().log_factor, film.law().log_cap_load, film.log_speed()};
}

Eigen::ArrayXd drops_of(const Bearing& bearing, Race race) {
  const CylindricalRollers& rollers = bearing.rollers();
  if (rollers.laminae == 0) return Eigen::ArrayXd::Zero(1);
  const std::vector<double> drops =
      lamina_drops(rollers.profile, bearing.ring(race).profile, rollers.length, rollers.laminae);
  return Eigen::Map<const Eigen::ArrayXd>(drops.data(), static_cast<Eigen::Index>(drops.size()));
}

}  // namespace

RowNumbers row_numbers(const Bearing& bearing, const RollerContacts& contacts) {
  return {.log_stiffness = std::log(contacts.inner.elastic().constant()),
          .inner_film = numbers_of(contacts.inner.film()),
          .outer_film = numbers_of(contacts.outer.film()),
          .inner_drop = drops_of(bearing, Race::inner),
          .outer_drop = drops_of(bearing, Race::outer)};
}

BalanceSetting ring_setting(const Bearing& bearing, const RaceEquilibrium& problem,
                            const OperatingPoint& point, const Eigen::VectorXd& place) {
  const RingCoordinates<Eigen::Dynamic> ring(problem);
  const Eigen::Index rollers = problem.angle.size();
  RowNumbers row = row_numbers(bearing, problem.contacts);
  const bool cut = bearing.rollers().laminae > 0;
  const double lever = cut ? -0.5 * bearing.rollers().length : 0.0;
  row.end_displacement =
      lever * (problem.angle.cos() * point.bore_tilt.x() + problem.angle.sin() * point.bore_tilt.y());
  row.inertial_load = problem.inertial_load;
  row.approach.resize(rollers);
  row.moves.setZero(ring.size(), 2 * rollers);
  for (Eigen::Index j = 0; j < rollers; ++j) {
    row.approach[j] = ring.approach(j, place);
    row.moves.col(2 * j) = ring.outward(j);
  }
  mechanics::Imbalance<Eigen::Dynamic> rest = ring.without_rollers(place);
  return {{{std::move(row)}, std::move(rest.force)}, {problem.contacts}, std::move(rest.stiffness)};
}

std::vector<RollerPlace> roller_places(const LaminaState& state) {
  std::vector<RollerPlace> places;
  for (const RollerState& roller : state.rollers)
    places.push_back({{roller.inner_approach(), roller.inner_end_displacement},
                      {roller.outer_approach, roller.outer_end_displacement}});
  return places;
}

std::vector<RollerPlace> roller_places(const RaceEquilibrium& problem, const QuasiStaticState& state) {
  std::vector<RollerPlace> places;
  for (Eigen::Index j = 0; j < state.inner_load.size(); ++j)
    places.push_back({{problem.contacts.inner.elastic().approach(state.inner_load[j]), 0.0},
                      {problem.contacts.outer.elastic().approach(state.outer_load[j]), 0.0}});
  return places;
}

struct BalanceSlopes::Settling {
  Eigen::ArrayXd inner, outer;  // [N per unit]  (laminae)  of the loads while the roller stands
  Eigen::Vector4d place;        // [m per unit]  of both contacts
};

BalanceSlopes::BalanceSlopes(BalanceSetting setting, const std::vector<std::vector<RollerPlace>>& places)
    : numbers_(std::move(setting.numbers)) {
  const std::vector<RollerContacts>& contacts = setting.contacts;
  Eigen::MatrixXd stiffness = std::move(setting.rest_stiffness);
  for (std::size_t b = 0; b < numbers_.rows.size(); ++b) {
    const RowNumbers& row = numbers_.rows[b];
    std::vector<Roller>& rollers = rollers_.emplace_back();
    for (const RollerPlace& place : places[b]) {
      const auto j = static_cast<Eigen::Index>(rollers.size());
      rollers.push_back(
          roller_at(contact_at(place.inner, row.log_stiffness, row.inner_drop, contacts[b].inner.film()),
                    contact_at(place.outer, row.log_stiffness, row.outer_drop, contacts[b].outer.film())));
      const auto moves = row.moves.middleCols<2>(2 * j);
      stiffness += moves * rollers.back().stiffness * moves.transpose();
    }
  }
  stiffness_.compute(stiffness);
}

BalanceSlopes::Roller BalanceSlopes::roller_at(Contact inner, Contact outer) {
  Roller roller{.inner = std::move(inner), .outer = std::move(outer)};
  roller.scale = roller.inner.stiffness.trace() + roller.outer.stiffness.trace();
  if (roller.scale == 0.0) return roller;
  constexpr double kNothing = 1e-11;  // a tilt that one lamina alone touches moves no load
  roller.system.setThreshold(kNothing);
  roller.system.compute(settling_matrix(roller.inner, roller.outer, roller.scale));
  roller.by_races = roller.system.solve(Eigen::Matrix<double, 4, 2>::Identity());
  roller.stiffness = roller.outer.stiffness * roller.by_races.bottomRows<2>();
  return roller;
}

BalanceSlopes::Settling BalanceSlopes::settling(const Roller& roller, const RowNumbers& row,
                                                const RowNumbers& change, Eigen::Index j) const {
  Settling result{standing_slopes(roller.inner, row.log_stiffness, change.log_stiffness, change.inner_drop),
                  standing_slopes(roller.outer, row.log_stiffness, change.log_stiffness, change.outer_drop),
                  Eigen::Vector4d::Zero()};
  if (roller.scale == 0.0) return result;
  const Eigen::Vector2d inner = force_of(result.inner, roller.inner),
                        outer = force_of(result.outer, roller.outer);
  Eigen::Vector4d remains;
  remains[0] = change.approach[j] + film_change(roller.inner, row.inner_film, change.inner_film, inner[0]) +
               film_change(roller.outer, row.outer_film, change.outer_film, outer[0]);
  remains[1] = change.end_displacement[j];
  remains.tail<2>() = (inner - outer + change.inertial_load[j] * Eigen::Vector2d::UnitX()) / roller.scale;
  result.place = roller.system.solve(remains);
  return result;
}

std::vector<LaminaSlopes> BalanceSlopes::loads() const {
  std::vector<LaminaSlopes> all;
  for (std::size_t b = 0; b < rollers_.size(); ++b) {
    const auto count = static_cast<Eigen::Index>(rollers_[b].size());
    LaminaSlopes& loads = all.emplace_back();
    loads.inner.resize(numbers_.rows[b].inner_drop.size(), count);
    loads.outer.resize(numbers_.rows[b].outer_drop.size(), count);
    for (Eigen::Index j = 0; j < count; ++j) {
      loads.inner.col(j) = rollers_[b][static_cast<std::size_t>(j)].inner.load;
      loads.outer.col(j) = rollers_[b][static_cast<std::size_t>(j)].outer.load;
    }
  }
  return all;
}

Eigen::VectorXd BalanceSlopes::rings_along(const BalanceNumbers& change) const {
  std::vector<std::vector<Settling>> settled;
  return rings_along(change, settled);
}

Eigen::VectorXd BalanceSlopes::rings_along(const BalanceNumbers& change,
                                           std::vector<std::vector<Settling>>& settled) const {
  Eigen::VectorXd force = change.rest;
  settled.resize(rollers_.size());
  for (std::size_t b = 0; b < rollers_.size(); ++b)
    for (std::size_t k = 0; k < rollers_[b].size(); ++k) {
      const auto j = static_cast<Eigen::Index>(k);
      const Roller& roller = rollers_[b][k];
      settled[b].push_back(settling(roller, numbers_.rows[b], change.rows[b], j));
      const Settling& one = settled[b].back();
      const Eigen::Vector2d outer =
          force_of(one.outer, roller.outer) + roller.outer.stiffness * one.place.tail<2>();
      force += numbers_.rows[b].moves.middleCols<2>(2 * j) * outer +
               change.rows[b].moves.middleCols<2>(2 * j) * roller.outer.force;
    }
  return stiffness_.solve(force);
}

std::vector<LaminaSlopes> BalanceSlopes::along(const BalanceNumbers& change) const {
  std::vector<std::vector<Settling>> settled;
  const Eigen::VectorXd rings = rings_along(change, settled);
  std::vector<LaminaSlopes> all = loads();
  for (std::size_t b = 0; b < rollers_.size(); ++b)
    for (std::size_t k = 0; k < rollers_[b].size(); ++k) {
      const auto j = static_cast<Eigen::Index>(k);
      const Roller& roller = rollers_[b][k];
      const Eigen::Vector2d races = -numbers_.rows[b].moves.middleCols<2>(2 * j).transpose() * rings;
      const Eigen::Vector4d place = settled[b][k].place + roller.by_races * races;
      all[b].inner.col(j) =
          settled[b][k].inner + roller.inner.slope * (place[0] + place[1] * roller.inner.station);
      all[b].outer.col(j) =
          settled[b][k].outer + roller.outer.slope * (place[2] + place[3] * roller.outer.station);
    }
  return all;
}

}  // namespace orbearing::bearing::laminae
