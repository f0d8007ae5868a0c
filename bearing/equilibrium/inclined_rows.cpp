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

WholeElement contacts_of(const Bearing& bearing, double taper) {
  if (!bearing.has_rollers()) {
    const equilibrium::BallRow balls(bearing);
    return WholeBall{balls.contact(Race::inner), balls.contact(Race::outer)};
  }
  return tapered_roller(roller_race_contact(bearing.contact_law, bearing.rollers().length), taper);
}

std::optional<LaminatedContacts> cut_of(const Bearing& bearing, const PlanetRows& rows) {
  if (!rows.is_tapered() || bearing.rollers().laminae == 0) return std::nullopt;
  const laminae::LaminaBearing cut(bearing);
  return LaminatedContacts{cut.contact(Race::inner), cut.contact(Race::outer)};
}

laminae::Element element_of(const InclinedRow& row) {
  static const Film dry{};
  if (!row.cut) return row.contacts;
  return laminae::TiltedRoller{row.cut->inner, row.cut->outer, dry, dry, std::cos(row.taper)};
}

// Approach [m] at which a roller that nothing else moves carries `load` [N] on the outer race: Newton's
// method on a load that grows ever faster, from above.
double approach_under(const InclinedRow& row, double load) {
  const double whole = whole_approach(row.contacts, load);
  if (!row.cut || load == 0.0) return whole;
  double approach = whole + row.cut->inner.greatest_drop() + row.cut->outer.greatest_drop();
  laminae::RollerState state;
  for (int i = 0; i < 100; ++i) {
    laminae::converge_element(element_of(row), {.approach = approach}, state);
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

std::vector<laminae::RollerState> InclinedPlanet::elements() const {
  std::size_t count = 0;
  for (const InclinedRow& row : rows_) count += static_cast<std::size_t>(row.count);
  return std::vector<laminae::RollerState>(count);
}

SettlingRow<5> InclinedPlanet::row_at(const InclinedRow& row, double first_element,
                                      std::span<laminae::RollerState> elements) const {
  SettlingRow<5> at{.element = element_of(row),
                    .concentric = Eigen::ArrayXd::Constant(row.count, row.approach),
                    .inertial_load = Eigen::ArrayXd::Zero(row.count),
                    .end_displacement = {},
                    .outward = SettlingRow<5>::Moves::Zero(5, row.count),
                    .tilting = SettlingRow<5>::Moves::Zero(5, row.cut ? row.count : 0),
                    .rollers = elements};
  for (int j = 0; j < row.count; ++j) {
    const double angle = first_element + two_pi * j / row.count;
    at.inertial_load[j] = along_inner_normal(row, angle);
    at.outward.col(j) = moves(row, angle);
    if (row.cut) at.tilting.col(j) = tilts(row, angle);
  }
  return at;
}

RingsOnRollers<5> InclinedPlanet::rings(double first_element,
                                        std::span<laminae::RollerState> elements) const {
  RingsOnRollers<5> all{Position::Zero(), Eigen::Matrix<double, 5, 5>::Zero(), Position::Zero(), 0.0, {}};
  for (const InclinedRow& row : rows_) {
    const auto count = static_cast<std::size_t>(row.count);
    all.rows.push_back(row_at(row, first_element, elements.first(count)));
    elements = elements.subspan(count);
  }
  return all;
}

mechanics::Imbalance<5> InclinedPlanet::forces(const Position& position, double first_element) const {
  std::vector<laminae::RollerState> of_elements = elements();
  return rings(first_element, of_elements)(position);
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
    elastic = std::max(elastic, whole_approach(row.contacts, all));
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
  state.rollers = elements();
  const RingsOnRollers<5> on_rows = rings(first_element, state.rollers);
  const auto imbalance_at = [&](const Position& at) {
    mechanics::Imbalance<5> sum = on_rows(at);
    sum.force += outer;
    sum.scale = outer.cwiseAbs().maxCoeff();
    for (const laminae::RollerState& one : state.rollers) sum.scale = std::max(sum.scale, one.outer.load);
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
        (limits.size + whole_approach(rows_.front().contacts, load.force.norm() / rows_.front().count));
  mechanics::Imbalance<5> now;
  state.report = {mechanics::find_balance<5>(imbalance_at, limits, position, now)};
  state.report.residual = mechanics::force_left(state.report.residual);
  if (!state.report.converged) state.report.message = no_balance_text(outer.norm(), state.report.residual);
  state.displacement = position.head<2>();
  state.axial = position[2];
  state.tilt = position.tail<2>() / lever_;
  state.stiffness = equilibrium::by_tilt(now.stiffness, lever_);
  std::size_t next = 0;
  for (const InclinedRow& row : rows_) {
    Eigen::ArrayXd& inner = state.inner_load.emplace_back(row.count);
    Eigen::ArrayXd& on_outer = state.outer_load.emplace_back(row.count);
    for (int j = 0; j < row.count; ++j, ++next) {
      inner[j] = state.rollers[next].inner.load;
      on_outer[j] = state.rollers[next].outer.load;
    }
  }
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
      if (!row.cut) continue;
      loads.put_laminae(row.cut->inner, row.cut->outer, roller, column);
      loads.moment += part * row.cut->outer.half_length() * roller.outer.end_load *
                      Eigen::Vector2d(std::cos(angle), std::sin(angle));
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
  for (const InclinedRow& row : planet.rows()) {
    InclinedRowLoads& loads = result.rows.emplace_back();
    loads.resize(row.cut ? row.cut->outer.laminae() : 0, all);
    loads.rib_load = Eigen::ArrayXd::Zero(all);
  }
  std::optional<InclinedState> near;
  for (int position = 0; position < cage_positions; ++position) {
    near = planet.balance(load, result.angle[position], near ? &*near : nullptr);
    put_angle(planet, *near, position, cage_positions, result);
  }
  return result;
}

}  // namespace orbearing::bearing
