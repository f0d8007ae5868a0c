#include "coupling/analysis/ball_films.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "bearing/equilibrium/row_group.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

using described::Record;
namespace balance = bearing::equilibrium;
using bearing::Race;

using mechanics::significant;

constexpr double kMissing = described::kAbsent;
constexpr double kRpm = 30.0 / constants::pi, kDegree = 180.0 / constants::pi;  // [per rad/s], [per rad]
constexpr std::array<Race, 2> both_races{Race::inner, Race::outer};

double in_rpm(double speed) {
  return mechanics::in_unit(speed, kRpm);
}

double number_in(const Record& record, const std::string& name) {
  for (const described::Entry& entry : record.entries())
    if (entry.name == name) return std::get<described::Numbers>(entry.content).values.front();
  return kMissing;
}

const char* race_name(Race race) {
  return race == Race::inner ? "inner" : "outer";
}

bearing::film::ContactMotion contact_motion(const balance::RingState& state, Race race, Eigen::Index ball) {
  const bool inner = race == Race::inner;
  return {.load = (inner ? state.contact_load : state.outer_load)[ball],
          .rolling = std::abs((inner ? state.inner_rolling : state.outer_rolling)[ball]),
          .spin = std::abs((inner ? state.inner_spin : state.outer_spin)[ball])};
}

// One equilibrium of the table, with film or without; absent where none was found.
void describe_balance(Record& row, const bearing::Bearing& bearing, const balance::RowMotion& motion,
                      const std::optional<balance::RingState>& state) {
  const std::string kind = motion.film ? "film_" : "hertz_", with = motion.film ? "with film" : "after Hertz";
  const auto put = [&](const std::string& name, const char* units, const std::string& meaning, double value) {
    row.value(kind + name, {"", units, units, ""}, meaning + ", " + with, value).variable = kind + name;
  };
  put("axial_um", "um", "axial displacement", state ? 1e6 * state->axial : kMissing);
  put("radial_um", "um", "displacement along the radial load", state ? 1e6 * state->radial : kMissing);
  for (const Race race : both_races) {
    const std::string name = race_name(race), where = " on the " + name + " race";
    double load = kMissing, angle = kMissing, approach = kMissing;
    FilmPoint film{.motion = {kMissing, kMissing, kMissing},
                   .films = {kMissing, kMissing, kMissing, kMissing, kMissing}};
    if (state) {
      Eigen::Index ball = 0;
      state->contact_load.maxCoeff(&ball);
      const bool unlike = state->outer_load.size() > 0 && race == Race::outer;
      load = (unlike ? state->outer_load : state->contact_load)[ball];
      angle = (unlike ? state->outer_angle : state->contact_angle)[ball];
      approach = std::pow(load / balance::BallRow(bearing).contact(race).constant, 2.0 / 3.0);
      if (motion.film && state->inner_rolling.size() > 0) {
        film.motion = contact_motion(*state, race, ball);
        film.films = spin_films(bearing::film::ball_contact(bearing, race), *motion.film, film.motion);
        approach = film.films.rigid;
      }
    }
    put(name + "_load_N", "N", "load" + where, load);
    put(name + "_contact_angle_deg", "degree", "contact angle" + where, kDegree * angle);
    put(name + "_approach_um", "um", "approach of the bodies" + where, 1e6 * approach);
    if (!motion.film) continue;
    put(name + "_rolling_speed_m_s", "m s-1", "rolling speed" + where, film.motion.rolling);
    put(name + "_spin_rad_s", "rad s-1", "spin" + where, film.motion.spin);
    put(name + "_h_c_um", "um", "central film" + where, 1e6 * film.films.central);
    put(name + "_h_min_um", "um", "least film" + where, 1e6 * film.films.least);
    put(name + "_h_c_HamrockDowson_um", "um", "central film without spin" + where,
        1e6 * film.films.central_hamrock_dowson);
    put(name + "_h_min_HamrockDowson_um", "um", "least film without spin" + where,
        1e6 * film.films.least_hamrock_dowson);
  }
}

// Speed at the vertex of a parabola through the largest value and its neighbours; none at an end.
std::optional<double> highest_at(const SpeedTable& table, const std::string& name) {
  const auto value = [&](std::size_t row) { return number_in(table.rows[row], name); };
  const auto speed = [&](std::size_t row) { return number_in(table.rows[row], "speed_rpm"); };
  std::size_t best = 0;
  for (std::size_t row = 1; row < table.rows.size(); ++row)
    if (value(row) > value(best) || std::isnan(value(best))) best = row;
  if (best == 0 || best + 1 == table.rows.size()) return std::nullopt;
  const double x0 = speed(best - 1), x1 = speed(best), x2 = speed(best + 1);
  const double left = (value(best) - value(best - 1)) / (x1 - x0),
               right = (value(best + 1) - value(best)) / (x2 - x1);
  const double bend = (right - left) / (x2 - x0);
  if (!(bend < 0.0)) return std::nullopt;
  return (0.5 * (x0 + x1) - left / (2.0 * bend)) / kRpm;
}

std::optional<balance::RingState> state_or_warning(const bearing::Bearing& bearing,
                                                   const balance::RowMotion& motion,
                                                   const balance::RingLoad& load, double speed,
                                                   SpeedTable& table) {
  balance::RingState state = balance::balance_bearing(bearing, motion, load);
  if (state.report.converged) return state;
  table.warnings.push_back("operation.speeds: " + significant(in_rpm(speed), 6) +
                           " rpm: " + state.report.message);
  return std::nullopt;
}

void add_row(const bearing::Bearing& bearing, balance::RowMotion motion, const balance::RingLoad& load,
             double speed, SpeedTable& table, std::vector<double>& beyond) {
  motion.speeds.inner = speed;
  Record& row = table.rows.emplace_back();
  row.value("speed_rpm", {"", "rpm", "rpm", ""}, "of the inner ring", in_rpm(speed)).variable = "speed_rpm";
  balance::RowMotion dry = motion;
  dry.film.reset();
  describe_balance(row, bearing, dry, state_or_warning(bearing, dry, load, speed, table));
  if (motion.film) {
    const std::optional<balance::RingState> state = state_or_warning(bearing, motion, load, speed, table);
    describe_balance(row, bearing, motion, state);
    if (state && !film_warnings(bearing, ball_films(bearing, *motion.film, *state)).empty())
      beyond.push_back(in_rpm(speed));
  }
}

}  // namespace

std::vector<BallFilm> ball_films(const bearing::Bearing& bearing, const bearing::Lubricant& oil,
                                 const balance::RingState& state) {
  std::vector<BallFilm> films;
  for (const Race race : both_races) {
    const bearing::film::EllipticalContact contact = bearing::film::ball_contact(bearing, race);
    for (Eigen::Index ball = 0; ball < state.inner_rolling.size(); ++ball) {
      const bearing::film::ContactMotion motion = contact_motion(state, race, ball);
      if (!(motion.load > 0.0)) continue;
      films.push_back({ball, race, {motion, spin_films(contact, oil, motion)}});
    }
  }
  return films;
}

std::vector<std::string> film_warnings(const bearing::Bearing& bearing, const std::vector<BallFilm>& films) {
  std::vector<std::string> warnings;
  std::map<std::string, std::size_t> known;  // by race and quantity
  std::map<std::string, int> others;
  for (const BallFilm& film : films) {
    const std::string race = race_name(film.race);
    for (const std::string& what :
         outside_of_range(bearing::film::ball_contact(bearing, film.race), film.point.motion)) {
      const std::string key = race + what.substr(0, what.find(" is "));
      if (known.emplace(key, warnings.size()).second)
        warnings.push_back("film: on the " + race + " race the " + what);
      else
        ++others[key];
    }
  }
  for (const auto& [key, index] : known)
    if (others[key] > 0) warnings[index] += "; so on " + std::to_string(others[key]) + " more balls";
  return warnings;
}

void describe(described::Record& row, const BallFilm& film) {
  row.value("ball", "counted from 0", film.ball);
  row.value("race", "inner or outer", race_name(film.race));
  describe(row, film.point);
}

std::optional<SpeedTable> speed_table(const BallsUnderLoad& in) {
  if (in.speeds.empty()) return std::nullopt;
  const bearing::Bearing bearing = rotating_bearing(in.loaded);
  const balance::RowMotion motion = row_motion(in.loaded.rotation, in.balls, in.loaded.oil.lubricant);
  SpeedTable table;
  std::vector<double> beyond;
  for (const double speed : in.speeds) add_row(bearing, motion, in.loaded.load, speed, table, beyond);
  if (!beyond.empty()) {
    std::string speeds;
    for (const double speed : beyond) speeds += (speeds.empty() ? "" : ", ") + significant(speed, 6);
    table.warnings.push_back("operation.speeds: the film at " + speeds +
                             " rpm lies outside of the ranges of its regressions");
  }
  table.inner_rotating = highest_at(table, "film_inner_h_min_um");
  table.outer_rotating = highest_at(table, "film_outer_h_min_um");
  return table;
}

void describe(described::Record& record, const SpeedTable& table) {
  record.table("over_speed", "speed", "the most loaded ball at operation.speeds", table.rows,
               [](described::Record& row, const described::Record& of) { row = of; });
  record.array("least_film_turns_at_rpm", described::dimension::angular_speed,
               "speed of the largest least film", {{"race", {"inner", "outer"}}},
               std::array{table.inner_rotating.value_or(kMissing), table.outer_rotating.value_or(kMissing)});
}

}  // namespace orbearing::analysis
