// An operating point of planets on tapered or spherical roller bearings or on balls, at rest: the loads of
// their rows in the carrier's frame, and the lives of their bearings.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/carrier_frame.hpp"
#include "bearing/contact/point_contact.hpp"
#include "bearing/equilibrium/balls.hpp"
#include "bearing/equilibrium/inclined_rows.hpp"
#include "bearing/life/inclined_rating.hpp"
#include "bearing/life/lundberg_palmgren.hpp"
#include "coupling/analysis/operating_point.hpp"
#include "coupling/analysis/rated_bearing.hpp"
#include "coupling/analysis/tilting_planet.hpp"
#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

namespace rating = bearing::rating;
using bearing::Race;
using Rows = std::vector<const bearing::InclinedRowLoads*>;

// Loads of several rows one behind the other.
Eigen::ArrayXd all_loads(const Rows& rows, Eigen::ArrayXd bearing::InclinedRowLoads::*race) {
  const Eigen::Index positions = (rows.front()->*race).size();
  Eigen::ArrayXd all(positions * static_cast<Eigen::Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k)
    all.segment(static_cast<Eigen::Index>(k) * positions, positions) = rows[k]->*race;
  return all;
}

// The same of laminae, (laminae, positions): those of a pair counted from the same end of the rollers.
Eigen::ArrayXXd all_lamina_loads(const Rows& rows, const std::vector<double>& sides,
                                 Eigen::ArrayXXd bearing::InclinedRowLoads::*race) {
  const Eigen::Index laminae = (rows.front()->*race).rows(), positions = (rows.front()->*race).cols();
  Eigen::ArrayXXd all(laminae, positions * static_cast<Eigen::Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto part = all.middleCols(static_cast<Eigen::Index>(k) * positions, positions);
    const Eigen::ArrayXXd& own = rows[k]->*race;
    if (sides[k] < 0.0)
      part = own.colwise().reverse();
    else
      part = own;
  }
  return all;
}

bool are_cut(const Rows& rows) {
  return rows.front()->inner_lamina_load.size() > 0;
}

// The same bearing under both kinds of loads [N].
struct RatedLoads {
  double dynamic = 0.0;  // P
  double most = 0.0;     // P_0
};

class InclinedBearings {
 public:
  InclinedBearings(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                   const BearingDuty& duty)
      : drivetrain_(drivetrain),
        geometry_(geometry),
        speed_(rotating_speed(drivetrain.bearing, duty.point)),
        rows_(bearing::inclined_rows(drivetrain.bearing, drivetrain.rows, axial_positions(drivetrain))) {
    const bearing::InclinedPlanet planet(rows_, duty.point, drivetrain.dynamics.inertia);
    const double count = drivetrain.bearings_per_planet;
    result_ = bearing::inclined_planet_over_a_pitch(
        planet,
        {.force = count * bore_load_with_cage(drivetrain, geometry, duty.point),
         .moment = Eigen::Vector2d(duty.gears.overturning_moment, 0.0)},
        drivetrain.cage_positions);
    if (!result_.report.converged) throw std::runtime_error(result_.report.message);
  }

  const bearing::InclinedResult& result() const { return result_; }

  Rows of(int bearing) const {
    Rows own;
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (rows_[k].bearing == bearing) own.push_back(&result_.rows[k]);
    return own;
  }
  Rows all() const {
    Rows own;
    for (const bearing::InclinedRowLoads& one : result_.rows) own.push_back(&one);
    return own;
  }

  Eigen::Vector2d radial_load(int bearing) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const bearing::InclinedRowLoads* one : of(bearing)) sum += one->radial;
    return sum;
  }
  // Axial load of both rows of one bearing together.
  double axial_load(int bearing) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < rows_.size(); ++k)
      if (rows_[k].bearing == bearing) sum += rows_[k].side * result_.rows[k].axial;
    return std::abs(sum);
  }

  RatedLoads rated_loads(int bearing) const {
    const double radial = radial_load(bearing).norm(), axial = axial_load(bearing);
    if (drivetrain_.rows.has_balls()) return {radial, radial};
    const rating::RollerSet set = rating::roller_set(drivetrain_.bearing, drivetrain_.rows);
    return {rating::inclined_equivalent_load(set, radial, axial),
            rating::inclined_static_load(set, radial, axial)};
  }

  using Lives = PlanetBearingRating::Lives;
  /// Lives of a bearing with `rows`, or of several taken together as passages of one.
  Lives lives(const Rows& rows, const RatedLoads& loads) const {
    const rating::RatingCondition condition = rating_condition(drivetrain_.rated, loads.dynamic, loads.most,
                                                               speed_, drivetrain_.bearing.pitch_diameter);
    Lives all = drivetrain_.rows.has_balls() ? ball_lives(rows, condition) : roller_lives(rows, condition);
    all.hours = bearing::hours(all.life.bearing, speed_);
    all.rated_hours = hours_at(all.rating, speed_);
    return all;
  }

 private:
  // Balls by the capacities of ISO 16281, which are those of Lundberg and Palmgren.
  Lives ball_lives(const Rows& rows, const rating::RatingCondition& condition) const {
    const auto equivalent = [&](Eigen::ArrayXd bearing::InclinedRowLoads::*race, bearing::RaceMotion motion) {
      return rating::equivalent_ball_load(all_loads(rows, race), motion);
    };
    const bearing::RaceMotions& motions = drivetrain_.bearing.motions;
    Lives all;
    all.rating = rating::rating_lives(
        geometry_.rating, condition,
        rating::EquivalentBallLoads{equivalent(&bearing::InclinedRowLoads::inner_load, motions.inner),
                                    equivalent(&bearing::InclinedRowLoads::outer_load, motions.outer)});
    all.life = all.rating.reference;
    return all;
  }

  // None of the rows of a bearing may fail, each a row of its own race; rows of one bearing carry alike.
  Lives roller_lives(const Rows& rows, const rating::RatingCondition& condition) const {
    const bearing::Bearing& rollers = drivetrain_.bearing;
    const bool cut = are_cut(rows);
    const bearing::life::LaminaMeans means =
        cut ? bearing::life::means_of_loads(rollers.motions,
                                            lamina_loads(rows, &bearing::InclinedRowLoads::inner_lamina_load),
                                            lamina_loads(rows, &bearing::InclinedRowLoads::outer_lamina_load))
            : bearing::life::means_of_loads(
                  rollers.motions, all_loads(rows, &bearing::InclinedRowLoads::inner_load).transpose(),
                  all_loads(rows, &bearing::InclinedRowLoads::outer_load).transpose());
    const bearing::life::LaminaRating contacts = bearing::life::lamina_rating(
        rating::planet_contact_capacities(rollers, drivetrain_.rows, drivetrain_.reduction_factor),
        cut ? rollers.rollers().laminae : 1, rollers.motions);
    Lives all{.life = bearing::life::life_of_means(contacts, means),
              .rating = rating::rating_lives(geometry_.rating, condition, means)};
    const int count = drivetrain_.rows.rows();
    for (bearing::BearingLife* life : {&all.life, &all.rating.reference, &all.rating.modified_reference})
      for (double* part : {&life->inner, &life->outer, &life->bearing})
        *part = bearing::system_life(*part, count);
    return all;
  }

  Eigen::ArrayXXd lamina_loads(const Rows& rows, Eigen::ArrayXXd bearing::InclinedRowLoads::*race) const {
    std::vector<double> sides;
    for (const bearing::InclinedRowLoads* one : rows)
      sides.push_back(rows_[static_cast<std::size_t>(one - result_.rows.data())].side);
    return all_lamina_loads(rows, sides, race);
  }

  const PlanetaryDrivetrain& drivetrain_;
  const DrivetrainGeometry& geometry_;
  double speed_ = 0.0;  // [rad/s]  of the race that turns relative to the load
  std::vector<bearing::InclinedRow> rows_;
  bearing::InclinedResult result_;
};

RaceResult race_of(const Eigen::ArrayXd& loads) {
  return {.load_max = loads.maxCoeff(),
          .load_rms = std::sqrt(loads.square().mean()),
          .least_film = std::numeric_limits<double>::quiet_NaN()};  // of balls
}

// Films of rollers at the middle of their length; they take no part in the approach.
void put_races(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
               const bearing::OperatingPoint& point, const Rows& rows, PointResult& result) {
  result.inner = race_of(all_loads(rows, &bearing::InclinedRowLoads::inner_load));
  result.outer = race_of(all_loads(rows, &bearing::InclinedRowLoads::outer_load));
  if (!drivetrain.rows.has_balls()) {
    const bearing::RollerContacts rolling =
        bearing::rolling_contacts(drivetrain.bearing, geometry.bearing, point.inner_speed, point.outer_speed,
                                  drivetrain.dynamics.lubricant);
    const auto put = [&](bearing::Race race, const bearing::Film& film, RaceResult& of) {
      of.least_film = least_film_at_rest(drivetrain, geometry, race, film, of.load_max);
    };
    put(bearing::Race::inner, rolling.inner.film(), result.inner);
    put(bearing::Race::outer, rolling.outer.film(), result.outer);
  }
  if (!are_cut(rows)) return;
  for (const bearing::InclinedRowLoads* row : rows) {
    const auto widen = [](RaceResult& race, const Eigen::ArrayXXd& loads) {
      race.lamina_load_max = std::max(race.lamina_load_max, loads.maxCoeff());
    };
    widen(result.inner, row->inner_lamina_load);
    widen(result.outer, row->outer_lamina_load);
  }
}

// (laminae, positions) with the laminae fastest, as LaminaRecord has them.
std::vector<double> flattened(const Eigen::ArrayXXd& loads) {
  return {loads.data(), loads.data() + loads.size()};
}

// Laminae of the bearing of a planet with the shortest life.
std::optional<LaminaRecord> record_of_laminae(const PlanetaryDrivetrain& drivetrain,
                                              const InclinedBearings& bearings, const PointResult& point) {
  const auto shortest = std::ranges::min_element(point.seats, {}, &SeatResult::life_hours);
  const bearing::InclinedRowLoads& row =
      *bearings.of(static_cast<int>(shortest - point.seats.begin())).front();
  if (row.inner_lamina_load.size() == 0) return std::nullopt;
  const bearing::CylindricalRollers& rollers = drivetrain.bearing.rollers();
  std::vector<double> positions = bearing::laminae::lamina_positions(rollers.laminae);
  for (double& position : positions) position *= 0.5 * rollers.length;
  return LaminaRecord{.lamina_position = positions,
                      .inner_load = flattened(row.inner_lamina_load),
                      .outer_load = flattened(row.outer_lamina_load),
                      .roller_tilt = {row.roller_tilt.begin(), row.roller_tilt.end()},
                      .bore_tilt = bearings.result().tilt,
                      .moment = row.moment};
}

std::vector<double> mean_over_rows(const Rows& rows, Eigen::ArrayXd bearing::InclinedRowLoads::*race) {
  Eigen::ArrayXd sum = rows.front()->*race;
  for (std::size_t k = 1; k < rows.size(); ++k) sum += rows[k]->*race;
  sum /= static_cast<double>(rows.size());
  return {sum.begin(), sum.end()};
}

double pressure_of_inclined(const PlanetaryDrivetrain& drivetrain, const PointResult& point) {
  const bearing::Bearing of_contact = rating::upright(drivetrain.bearing, drivetrain.rows);
  const bearing::BearingGeometry geometry = bearing::geometry_of(of_contact);
  const auto pressure = [&](Race race, double load) {
    if (drivetrain.rows.has_balls())
      return bearing::point_pressure(bearing::equilibrium::BallRow(of_contact).contact(race), load).pressure;
    return bearing::hertz_pressure(load, bearing::equivalent_radius(geometry, race),
                                   of_contact.rollers().length, of_contact.material);
  };
  const int laminae = drivetrain.rows.has_balls() ? 0 : drivetrain.bearing.rollers().laminae;
  return std::max(pressure(Race::inner, point.inner.largest_even_load(laminae)),
                  pressure(Race::outer, point.outer.largest_even_load(laminae)));
}

// Bearing by bearing of one planet, and all planets alike.
void put_bearings(const PlanetaryDrivetrain& drivetrain, const InclinedBearings& bearings, double slope,
                  PointResult& result) {
  const std::vector<double> positions = axial_positions(drivetrain);
  Eigen::ArrayXd lives(static_cast<Eigen::Index>(positions.size()));
  std::vector<rating::RatedHours> rated;
  for (int k = 0; k < drivetrain.bearings_per_planet; ++k) {
    const Rows rows = bearings.of(k);
    const InclinedBearings::Lives one = bearings.lives(rows, bearings.rated_loads(k));
    lives[k] = one.hours;
    rated.push_back(one.rated_hours);
    result.seats.push_back({.position = positions[static_cast<std::size_t>(k)],
                            .load = bearings.radial_load(k).norm(),
                            .tilt = bearings.result().tilt,
                            .life_hours = one.hours,
                            .rated_hours = one.rated_hours,
                            .axial_load = bearings.axial_load(k),
                            .rib_load = all_loads(rows, &bearing::InclinedRowLoads::rib_load).maxCoeff()});
  }
  const double planets = std::pow(drivetrain.set.planets, -1.0 / slope);
  result.system_life_hours = planets * rating::system_life(lives, slope);
  result.rating.system_hours =
      rating::hours_of_equal(rating::hours_together(rated, slope), drivetrain.set.planets, slope);
}

// Means over the bearings, by the exponent of the basic life; the largest P_0.
RatedLoads loads_together(const PlanetaryDrivetrain& drivetrain, const InclinedBearings& bearings,
                          rating::RollingElement element) {
  RatedLoads all;
  Eigen::ArrayXd loads(drivetrain.bearings_per_planet);
  for (int k = 0; k < drivetrain.bearings_per_planet; ++k) {
    const RatedLoads one = bearings.rated_loads(k);
    loads[k] = one.dynamic;
    all.most = std::max(all.most, one.most);
  }
  const bearing::life::FatigueLaw mean{rating::life_exponent(element), 1.0};
  all.dynamic = mean.equivalent_load(loads, bearing::RaceMotion::rotating);
  return all;
}

}  // namespace

Eigen::Vector2d bore_load_with_cage(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                                    const bearing::OperatingPoint& point) {
  const bearing::Bearing& one = drivetrain.bearing;
  if (drivetrain.rows.is_cylindrical())
    return bearing::total_bore_load(one, geometry.bearing, point, drivetrain.dynamics.inertia);
  if (one.cage.guidance != Race::outer) return point.bore_load;
  const int elements = drivetrain.rows.rows() * one.element_count();
  const double mass = geometry.bearing.cage_mass + 0.5 * elements * geometry.bearing.element_mass;
  return point.bore_load + mass * bearing::inertial_acceleration(
                                      bearing::carrier_frame(point.carrier, drivetrain.dynamics.inertia),
                                      Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
}

PointResult inclined_point(const PlanetaryDrivetrain& drivetrain, const DrivetrainGeometry& geometry,
                           const BearingDuty& duty) {
  const InclinedBearings bearings(drivetrain, geometry, duty);
  const Rows rows = bearings.all();
  PointResult result;
  result.element = geometry.rating.element;
  const double slope = rating::weibull_slope(result.element);
  put_races(drivetrain, geometry, duty.point, rows, result);
  const Eigen::ArrayXd& angle = bearings.result().angle;
  result.distribution = {{angle.begin(), angle.end()},
                         mean_over_rows(rows, &bearing::InclinedRowLoads::inner_load),
                         mean_over_rows(rows, &bearing::InclinedRowLoads::outer_load),
                         {}};
  const InclinedBearings::Lives one =
      bearings.lives(rows, loads_together(drivetrain, bearings, result.element));
  result.inner.life = one.life.inner;
  result.outer.life = one.life.outer;
  result.life = one.life.bearing;
  result.life_hours = one.hours;
  result.rating = {one.rating, one.rated_hours, {}};
  result.life_method = drivetrain.rated.method;
  put_bearings(drivetrain, bearings, slope, result);
  result.laminae = record_of_laminae(drivetrain, bearings, result);
  result.contact_pressure = pressure_of_inclined(drivetrain, result);
  return result;
}

}  // namespace orbearing::analysis
