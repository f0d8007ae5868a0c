#include "bearing/equilibrium/inclined_rows.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "bearing/carrier_frame.hpp"
#include "bearing/contact/least_approach.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/lamina_bearing.hpp"
#include "bearing/equilibrium/quasi_static.hpp"
#include "mechanics/checks.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/force_left.hpp"

namespace orbearing::bearing {

namespace {

using constants::two_pi;

InclinedContacts contacts_of(const Bearing& bearing, double taper) {
  if (!bearing.has_rollers()) {
    const equilibrium::BallRow balls(bearing);
    return {balls.contact(Race::inner), balls.contact(Race::outer)};
  }
  return {roller_race_contact(bearing.contact_law, bearing.rollers().length), taper};
}

std::optional<LaminatedContacts> cut_of(const Bearing& bearing, const PlanetRows& rows) {
  if (!rows.is_tapered() || bearing.rollers().laminae == 0) return std::nullopt;
  const laminae::LaminaBearing cut(bearing);
  return LaminatedContacts{cut.contact(Race::inner), cut.contact(Race::outer)};
}

laminae::TiltedRoller roller_of(const InclinedRow& row) {
  static const Film dry{};
  return {row.cut->inner, row.cut->outer, dry, dry, std::cos(row.taper)};
}

// Approach [m] at which a roller that nothing else moves carries `load` [N] on the outer race: Newton's
// method on a load that grows ever faster, from above.
double approach_under(const InclinedRow& row, double load) {
  const double whole = row.contacts.approach(load);
  if (!row.cut || load == 0.0) return whole;
  double approach = whole + row.cut->inner.greatest_drop() + row.cut->outer.greatest_drop();
  laminae::RollerState state;
  for (int i = 0; i < 100; ++i) {
    laminae::converge_roller(roller_of(row), {.approach = approach}, state);
    const double step = (state.outer.load - load) / state.stiffness;
    approach -= step;
    if (std::abs(step) <= 1e-15 * whole) break;
  }
  return approach;
}

// By which a pair is pressed together, along the axis of each row [m].
double mounted_approach(const PlanetRows& rows, const InclinedRow& row) {
  if (!rows.is_tapered()) return 0.0;
  if (rows.approach) return 0.5 * *rows.approach;
  if (!rows.preload) return 0.0;
  const double load = *rows.preload / (row.count * std::sin(row.contact_angle));
  return approach_under(row, load) / std::sin(row.contact_angle);
}

void require_fit(const Bearing& bearing, const PlanetRows& rows, std::size_t bearings) {
  mechanics::require(bearings > 0, "bearings of a planet", bearings, "at least one");
  mechanics::require(bearing.has_rollers() != rows.has_balls(), "rolling elements of a planet bearing",
                     bearing.has_rollers() ? "rollers" : "balls", "those of its type");
  mechanics::require(!rows.is_tapered() || bearings == 2, "tapered roller bearings of a planet", bearings,
                     "2, a pair whose axial forces balance");
  mechanics::require(!rows.is_tapered() || rows.contact_angle > 0.0, "contact angle of tapered rollers [rad]",
                     rows.contact_angle, "greater than 0");
}

// The races of a tapered pair are inclined as wedges against each other, towards the middle of the pair or
// away.
double side_of(const PlanetRows& rows, std::size_t bearing) {
  const double outward = bearing == 0 ? 1.0 : -1.0;
  return rows.arrangement == RowArrangement::back_to_back ? outward : -outward;
}

}  // namespace

InclinedContacts::InclinedContacts(const LineContact& contact, double taper)
    : cosine_(std::cos(taper)),
      lines_(RollerContacts{{contact, Film()}, {contact.through_lever(cosine_), Film()}}) {}

InclinedContacts::InclinedContacts(const PointContact& inner, const PointContact& outer)
    : inner_(inner), outer_(outer) {}

// Equilibrium of Eq. (18), with outer load and approach times and over the cosine of the taper.
RollerBalance InclinedContacts::balance(double inertial_load, double approach) const {
  if (!lines_) return balance_ball(*inner_, *outer_, inertial_load, approach);
  RollerBalance both = balance_roller(lines_->inner, lines_->outer, inertial_load, approach / cosine_);
  both.outer_load /= cosine_;
  both.stiffness /= cosine_ * cosine_;
  return both;
}

double InclinedContacts::approach(double outer_load) const {
  if (!lines_) return std::pow(outer_load / in_series(*inner_, *outer_), 2.0 / 3.0);
  const double scaled = cosine_ * outer_load;
  return cosine_ * (lines_->inner.approach(scaled) + lines_->outer.approach(scaled));
}

double taper_of(double element_diameter, double pitch_diameter, double contact_angle) {
  const double ratio = element_diameter / pitch_diameter;
  return 2.0 * std::atan2(ratio * std::sin(contact_angle), 1.0 + ratio * std::cos(contact_angle));
}

BearingGeometry geometry_of(const Bearing& bearing, const PlanetRows& rows) {
  BearingGeometry geometry = geometry_of(bearing);
  if (rows.is_cylindrical() || rows.has_balls()) return geometry;
  const double cosine = std::cos(rows.contact_angle);
  const double shift = geometry.element_radius * (1.0 - cosine), inner = geometry.inner_radius,
               outer = geometry.outer_radius;
  geometry.slenderness *= cosine;
  const double per_area = bearing.material.density * constants::pi * bearing.width;
  geometry.inner_ring_mass += per_area * shift * (2.0 * inner + shift);
  geometry.outer_ring_mass += per_area * shift * (2.0 * outer - shift);
  geometry.inner_radius = inner + shift;
  geometry.outer_radius = outer - shift;
  geometry.cage_mass *= rows.rows();
  geometry.cage_inertia *= rows.rows();
  return geometry;
}

std::vector<InclinedRow> inclined_rows(const Bearing& bearing, const PlanetRows& rows,
                                       const std::vector<double>& positions) {
  require_fit(bearing, rows, positions.size());
  const BearingGeometry geometry = geometry_of(bearing, rows);
  const double angle = rows.has_balls() ? 0.0 : rows.contact_angle;
  const double taper =
      rows.is_tapered() ? taper_of(bearing.element_diameter(), bearing.pitch_diameter, angle) : 0.0;
  InclinedRow row{.contacts = contacts_of(bearing, taper),
                  .cut = cut_of(bearing, rows),
                  .count = bearing.element_count(),
                  .contact_angle = angle,
                  .taper = taper,
                  .element_mass = geometry.element_mass,
                  .pitch_radius = geometry.pitch_radius,
                  .slenderness = geometry.slenderness};
  row.approach =
      -0.5 * bearing.radial_clearance * std::cos(angle) + mounted_approach(rows, row) * std::sin(angle);
  std::vector<InclinedRow> all;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    row.bearing = static_cast<int>(k);
    row.side = rows.is_tapered() ? side_of(rows, k) : -1.0;
    // Normals of a spherical race meet in its centre, the middle of the bearing.
    row.pressure_centre =
        positions[k] - (rows.is_tapered() ? row.side * row.pitch_radius * std::tan(angle) : 0.0);
    all.push_back(row);
    if (rows.rows() == 1) continue;
    row.side = 1.0;
    all.push_back(row);
  }
  return all;
}

InclinedPlanet::InclinedPlanet(std::vector<InclinedRow> rows, const OperatingPoint& point,
                               const InertiaSwitches& inertia)
    : rows_(std::move(rows)), point_(point), inertia_(inertia) {
  mechanics::require(!rows_.empty(), "rows of a planet", rows_.size(), "at least one");
  require_finite(point_);
  constexpr double same = 1e-9;  // [m]  pressure centres
  for (const InclinedRow& row : rows_) {
    lever_ = std::max({lever_, std::abs(row.pressure_centre), row.pitch_radius});
    axial_ = axial_ || row.contact_angle != 0.0;
    tilt_ = tilt_ || std::abs(row.pressure_centre - rows_.front().pressure_centre) > same;
  }
}

double InclinedPlanet::inertial_load(const InclinedRow& row, double angle) const {
  const double cage = kinematic_cage_speed(row.slenderness, point_.inner_speed, point_.outer_speed);
  return row.element_mass *
         radial_inertial_acceleration(carrier_frame(point_.carrier, inertia_), row.pitch_radius, angle, cage);
}

double InclinedPlanet::along_inner_normal(const InclinedRow& row, double angle) const {
  return inertial_load(row, angle) * std::cos(row.contact_angle - row.taper);
}

// Displacement of the outer race outward along its normal by each coordinate, Eq. (17).
InclinedPlanet::Position InclinedPlanet::moves(const InclinedRow& row, double angle) const {
  const double cosine = std::cos(row.contact_angle), tilting = cosine * row.pressure_centre / lever_;
  const double x = std::cos(angle), y = std::sin(angle);
  Position all;
  all << cosine * x, cosine * y, row.side * std::sin(row.contact_angle), tilting * x, tilting * y;
  return all;
}

// End displacement of the outer race by each coordinate, at the end of its rollers along +z, Eq. (21).
InclinedPlanet::Position InclinedPlanet::tilts(const InclinedRow& row, double angle) const {
  const double arm = row.cut->outer.half_length() / lever_;
  Position all = Position::Zero();
  all.tail<2>() << arm * std::cos(angle), arm * std::sin(angle);
  return all;
}

void InclinedPlanet::settle(const InclinedRow& row, double angle, const Position& position,
                            laminae::RollerState& state) const {
  const double approach = without_round_off(row.approach - moves(row, angle).dot(position),
                                            std::abs(row.approach) + position.norm()),
               inertial_load = along_inner_normal(row, angle);
  if (!row.cut) return laminae::set_whole_contacts(row.contacts.balance(inertial_load, approach), state);
  laminae::converge_roller(roller_of(row),
                           {.approach = approach,
                            .outer_end_displacement = tilts(row, angle).dot(position),
                            .inertial_load = inertial_load},
                           state);
}

template <class Use>
void InclinedPlanet::for_each(double first_element, const Use& use) const {
  for (std::size_t k = 0; k < rows_.size(); ++k)
    for (int j = 0; j < rows_[k].count; ++j) use(k, j, first_element + two_pi * j / rows_[k].count);
}

mechanics::Imbalance<5> InclinedPlanet::forces(const Position& position, double first_element,
                                               std::vector<laminae::RollerState>* rollers) const {
  mechanics::Imbalance<5> sum;
  std::size_t next = 0;
  for_each(first_element, [&](std::size_t k, int, double angle) {
    const InclinedRow& row = rows_[k];
    const Position out = moves(row, angle);
    laminae::RollerState fresh;
    laminae::RollerState& state = rollers ? (*rollers)[next++] : fresh;
    settle(row, angle, position, state);
    sum.scale = std::max(sum.scale, state.outer.load);
    if (!row.cut) {
      sum.force += state.outer.load * out;
      sum.stiffness += state.stiffness * out * out.transpose();
      return;
    }
    Eigen::Matrix<double, 5, 2> ways;
    ways << out, tilts(row, angle);
    sum.force += ways * Eigen::Vector2d(state.outer.load, state.outer.end_load);
    sum.stiffness += ways * laminae::roller_stiffness(state) * ways.transpose();
  });
  return sum;
}

namespace {

// All forces on one element, over the clearance or preload and what the tilt adds.
mechanics::SearchLimits search_limits_of(const InclinedPlanet& planet, double force, double first_element) {
  double approach = 1e-6, all = force;
  for (const InclinedRow& row : planet.rows()) {
    for (int j = 0; j < row.count; ++j)
      all += std::abs(planet.inertial_load(row, first_element + two_pi * j / row.count));
    approach = std::max(approach, std::abs(row.approach));
    if (row.cut)
      approach = std::max({approach, row.cut->inner.greatest_drop(), row.cut->outer.greatest_drop()});
  }
  double elastic = 0.0, sine = 1.0;
  for (const InclinedRow& row : planet.rows()) {
    elastic = std::max(elastic, row.contacts.approach(all));
    if (row.contact_angle > 0.0) sine = std::min(sine, std::sin(row.contact_angle));
  }
  return {.reach = (approach + elastic) / sine, .size = approach};
}

std::string no_balance_text(double load, double residual) {
  std::ostringstream text;
  text << "the planet found no balance on its bearings under " << load
       << " N: " << mechanics::force_left_text(residual)
       << "; check clearance, preload and the number of rolling elements";
  return text.str();
}

}  // namespace

InclinedState InclinedPlanet::balance(const PlanetLoad& load, double first_element,
                                      const InclinedState* near) const {
  Position outer;
  outer << load.force, load.axial, load.moment / lever_;
  const Eigen::Array<bool, 5, 1> held(false, false, !axial_, !tilt_, !tilt_);
  InclinedState state;
  for (const InclinedRow& row : rows_)
    state.rollers.resize(state.rollers.size() + static_cast<std::size_t>(row.count));
  const auto imbalance_at = [&](const Position& at) {
    mechanics::Imbalance<5> sum = forces(at, first_element, &state.rollers);
    sum.force += outer;
    sum.scale = std::max(sum.scale, outer.cwiseAbs().maxCoeff());
    mechanics::hold<5>(held, sum);
    return sum;
  };
  const mechanics::SearchLimits limits = search_limits_of(*this, outer.norm(), first_element);
  Position position = Position::Zero();
  if (near)
    position << near->displacement, near->axial, lever_ * near->tilt;
  else if (load.force.norm() > 0.0)  // into contact
    position.head<2>() =
        load.force.normalized() *
        (limits.size + rows_.front().contacts.approach(load.force.norm() / rows_.front().count));
  mechanics::Imbalance<5> now;
  state.report = {mechanics::find_balance<5>(imbalance_at, limits, position, now)};
  state.report.residual = mechanics::force_left(state.report.residual);
  if (!state.report.converged) state.report.message = no_balance_text(outer.norm(), state.report.residual);
  state.displacement = position.head<2>();
  state.axial = position[2];
  state.tilt = position.tail<2>() / lever_;
  state.stiffness = equilibrium::by_tilt(now.stiffness, lever_);
  for (const InclinedRow& row : rows_) {
    state.inner_load.emplace_back(Eigen::ArrayXd::Zero(row.count));
    state.outer_load.emplace_back(Eigen::ArrayXd::Zero(row.count));
  }
  std::size_t next = 0;
  for_each(first_element, [&](std::size_t k, int j, double) {
    const laminae::RollerState& roller = state.rollers[next++];
    state.inner_load[k][j] = roller.inner.load;
    state.outer_load[k][j] = roller.outer.load;
  });
  if (state.report.converged && !laminae::are_settled(state.rollers)) {
    state.report.converged = false;
    state.report.message = no_balance_text(outer.norm(), state.report.residual);
  }
  return state;
}

namespace {

// Load of the rib of the inner ring, which holds a tapered roller along that ring's race, Eq. (19).
double rib_load(const InclinedRow& row, double outer_load, double inertial_load) {
  if (row.taper == 0.0) return 0.0;
  const double along =
      outer_load * std::sin(row.taper) + inertial_load * std::sin(row.contact_angle - row.taper);
  return std::max(0.0, along);
}

// Laminae of one roller at `angle` [rad].
void put_laminae(const InclinedRow& row, const laminae::RollerState& roller, double angle, double part,
                 Eigen::Index column, InclinedRowLoads& loads) {
  loads.inner_lamina_load.col(column) =
      row.cut->inner.loads(roller.inner_approach(), roller.inner_end_displacement);
  loads.outer_lamina_load.col(column) =
      row.cut->outer.loads(roller.outer_approach, roller.outer_end_displacement);
  const double half = row.cut->outer.half_length();
  loads.roller_tilt[column] = roller.end_displacement / half;
  loads.moment += part * half * roller.outer.end_load * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

void put_angle(const InclinedPlanet& planet, const InclinedState& state, Eigen::Index position,
               Eigen::Index positions, InclinedResult& result) {
  const double part = 1.0 / static_cast<double>(positions);
  result.tilt += part * state.tilt;
  keep_worst(state.report, result.report);
  std::size_t next = 0;
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const InclinedRow& row = planet.rows()[k];
    InclinedRowLoads& loads = result.rows[k];
    for (Eigen::Index j = 0; j < row.count; ++j) {
      const Eigen::Index column = position + j * positions;
      const double angle = result.angle[column], outer = state.outer_load[k][j];
      loads.inner_load[column] = state.inner_load[k][j];
      loads.outer_load[column] = outer;
      loads.rib_load[column] = rib_load(row, outer, planet.inertial_load(row, angle));
      loads.radial +=
          part * outer * std::cos(row.contact_angle) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      loads.axial += part * outer * std::sin(row.contact_angle);
      const laminae::RollerState& roller = state.rollers[next++];
      if (row.cut) put_laminae(row, roller, angle, part, column, loads);
    }
  }
}

}  // namespace

InclinedResult inclined_planet_over_a_pitch(const InclinedPlanet& planet, const PlanetLoad& load,
                                            int cage_positions) {
  mechanics::require(cage_positions > 0, "cage angles over a pitch", cage_positions, "at least 1");
  const Eigen::Index all = static_cast<Eigen::Index>(cage_positions) * planet.rows().front().count;
  const double count = static_cast<double>(all);
  InclinedResult result;
  result.angle = Eigen::ArrayXd::LinSpaced(all, 0.0, two_pi * (count - 1.0) / count);
  result.report.converged = true;
  const Eigen::ArrayXd none = Eigen::ArrayXd::Zero(all);
  result.rows.assign(planet.rows().size(), {.inner_load = none, .outer_load = none, .rib_load = none});
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    if (!planet.rows()[k].cut) continue;
    InclinedRowLoads& row = result.rows[k];
    row.roller_tilt = none;
    row.inner_lamina_load = row.outer_lamina_load =
        Eigen::ArrayXXd::Zero(planet.rows()[k].cut->outer.laminae(), all);
  }
  std::optional<InclinedState> near;
  for (int position = 0; position < cage_positions; ++position) {
    near = planet.balance(load, result.angle[position], near ? &*near : nullptr);
    put_angle(planet, *near, position, cage_positions, result);
  }
  return result;
}

}  // namespace orbearing::bearing
