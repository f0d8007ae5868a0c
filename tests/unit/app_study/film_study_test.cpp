// Films of a single contact, and of the balls of a bearing in equilibrium.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/case/case_file.hpp"
#include "app/case/machine_of.hpp"
#include "app/case/static_case.hpp"
#include "app/errors.hpp"
#include "app/results/record_writers.hpp"
#include "coupling/analysis/ball_films.hpp"

namespace orbearing::app::film_study_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

ResolvedCase shipped(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_case(std::string(ORBEARING_SOURCE_DIR "/cases/") + name + "/case.yaml", settings);
}

analysis::BallsUnderLoad inputs_of(const std::string& name, const std::vector<std::string>& settings) {
  return machine_of<analysis::BallsUnderLoad>(shipped(name, settings));
}

analysis::FilmOfContact film_study(const ResolvedCase& in) {
  return analysis::film_of_contact(machine_of<analysis::SpinFilm>(in));
}

Record record_of(const analysis::FilmOfContact& study) {
  Record record;
  describe(record, study);
  return record;
}

double number(const nlohmann::ordered_json& row, const char* key) {
  return row.at(key).get<double>();
}

std::string csv_called(const std::string& file, const analysis::FilmOfContact& study) {
  const Record record = record_of(study);
  for (const described::Entry& entry : record.entries())
    if (entry.file == file) return csv_of(entry);
  return "no such file";
}

TEST(FilmStudy, RowsOfPointsInSi) {
  const ResolvedCase in =
      shipped("spin_film_guo2013", {"points=[[1.5 kN, 600 m/min, 300 rad/s], [1 N, 1 m/s, 0 rad/s]]"});
  EXPECT_THAT(in.list("points"), ElementsAre(1500.0, 10.0, 300.0, 1.0, 1.0, 0.0));
  EXPECT_EQ(in.given("points"), "[[1.5 kN, 600 m/min, 300 rad/s], [1 N, 1 m/s, 0 rad/s]]");
  EXPECT_EQ(film_study(in).points.size(), 2u);
  EXPECT_EQ(film_study(in).points[0].motion.spin, 300.0);
}

TEST(FilmStudy, RowsThatAreNone) {
  for (const char* text : {"[1 N]", "[[1 N, 1 m/s]]", "[[1 N, 1 m/s, 1 rad/s, 1 N]]",
                           "[[0 N, 1 m/s, 1 rad/s]]", "[[1 m/s, 1 N, 1 rad/s]]", "[]", "1 N"})
    EXPECT_THROW(shipped("spin_film_guo2013", {std::string("points=") + text}), BadInput) << text;
}

// The printed rows, by the names that the validation table has.
TEST(FilmStudy, ThePrintedRowsAreMet) {
  const analysis::FilmOfContact study = film_study(shipped("spin_film_guo2013", {"points=[[500 N, 10 m/s, 300 rad/s]]"}));
  constexpr double asked = 0.015;
  const nlohmann::ordered_json row = json_of(record_of(study)).at("film").at(0);
  EXPECT_NEAR(number(row, "h_c_HamrockDowson_um") / 0.6428, 1.0, asked);
  EXPECT_NEAR(number(row, "h_c_um") / 0.6429, 1.0, asked);
  EXPECT_NEAR(number(row, "h_min_HamrockDowson_um") / 0.5236, 1.0, asked);
  EXPECT_NEAR(number(row, "h_min_um") / 0.4891, 1.0, asked);
  EXPECT_THAT(study.warnings, IsEmpty());
}

// A film that spin alone has made vanish is none; nothing is used beyond its range without a word.
TEST(FilmStudy, WhatIsBeyondTheRangesIsReported) {
  const analysis::FilmOfContact study = film_study(shipped("spin_film_guo2013", {"points=[[500 N, 5 m/s, 5000 rad/s]]"}));
  EXPECT_EQ(study.points[0].films.least, 0.0);
  EXPECT_THAT(study.warnings, ElementsAre(HasSubstr("spin [rad/s] is 5000")));
}

// Central films are near those of Hamrock and Dowson, which have them from such solutions; spin lowers the
// least one.
TEST(FilmStudy, BySolvingReynoldsEquation) {
  const std::vector<std::string> points{"contact.ellipticity=3",
                                        "points=[[20 N, 5 m/s, 3000 rad/s], [20 N, 5 m/s, 0 rad/s]]"};
  std::vector<std::string> settings = points;
  settings.emplace_back("film.solver=reynolds");
  const analysis::FilmOfContact study = film_study(shipped("spin_film_guo2013", settings));
  ASSERT_EQ(study.points.size(), 2u);
  EXPECT_THAT(study.warnings, IsEmpty());
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(study.points[i].solution && study.points[i].solution->converged);
    EXPECT_NEAR(study.points[i].films.central / study.points[i].films.central_hamrock_dowson, 1.0, 0.15);
    EXPECT_GT(study.points[i].films.rigid, 0.0);
  }
  EXPECT_LT(study.points[0].films.least, study.points[1].films.least);
  EXPECT_THAT(csv_called("film_map_1.csv", study), StartsWith("x_mm,y_mm,pressure_GPa,film_um"));
}

// A film of a tenth of a squared step: null in the results, with a warning that names the row.
TEST(FilmStudy, APointThatReynoldsEquationDoesNotSolveIsNullAndWarned) {
  const analysis::FilmOfContact study =
      film_study(shipped("spin_film_guo2013", {"film.solver=reynolds", "contact.ellipticity=1",
                                               "points=[[2000 N, 0.001 m/s, 0 rad/s]]"}));
  ASSERT_FALSE(study.points.at(0).solution->converged);
  EXPECT_THAT(study.warnings, ElementsAre(HasSubstr("row 1 Reynolds' equation was not solved")));
  const nlohmann::ordered_json row = json_of(record_of(study)).at("film").at(0);
  EXPECT_TRUE(row.at("h_c_um").is_null());
  EXPECT_TRUE(row.at("h_min_um").is_null());
  EXPECT_TRUE(row.at("h_0_um").is_null());
  EXPECT_EQ(row.at("status"), "failed");
  EXPECT_TRUE(row.at("h_c_HamrockDowson_um").is_number());
}

// The case's own contact, without its regression.
TEST(FilmStudy, ThePublishedContactIsSolvedByReynoldsEquation) {
  const analysis::FilmOfContact study = film_study(shipped("spin_film_guo2013", {"film.solver=reynolds"}));
  EXPECT_THAT(study.warnings, IsEmpty());
  for (const analysis::FilmPoint& point : study.points) EXPECT_TRUE(point.solution->converged);
}

// Rollers have lines: the same command, with results of their own.
TEST(FilmStudy, ALineContactIsSolved) {
  const analysis::FilmOfContact study = film_study(shipped("reynolds_line", {"points=[[684 N, 1.14 m/s, 0 rad/s]]"}));
  EXPECT_THAT(study.warnings, IsEmpty());
  const nlohmann::ordered_json row = json_of(record_of(study)).at("film").at(0);
  EXPECT_NEAR(number(row, "h_min_um") / number(row, "h_min_DowsonHigginson_um"), 1.0, 0.1);
  EXPECT_GT(number(row, "h_flow_um"), number(row, "h_c_um"));
  EXPECT_GT(number(row, "rolling_resistance_N"), 0.0);
  EXPECT_FALSE(row.contains("h_c_HamrockDowson_um"));
  EXPECT_THAT(csv_called("film.csv", study),
              HasSubstr("h_flow_um,h_min_DowsonHigginson_um,rolling_resistance_N,status\n"));
  EXPECT_THAT(text_of(record_of(study)), HasSubstr("rolling_resistance_N"));
  EXPECT_THAT(csv_called("film_line_1.csv", study), StartsWith("x_mm,pressure_GPa,film_um,oil_fraction\n"));
}

TEST(FilmStudy, AContactIsAnEllipseOrALine) {
  struct {
    std::vector<std::string> settings;
    const char* word;
  } const refused[]{{{"film.solver=regression"}, "the regressions are for ellipses only"},
                    {{"points=[[684 N, 1.14 m/s, 5 rad/s]]"}, "a line contact that spins"}};
  for (const auto& one : refused) {
    try {
      shipped("reynolds_line", one.settings);
      ADD_FAILURE() << one.word;
    } catch (const BadInput& refusal) {
      EXPECT_THAT(refusal.what(), HasSubstr(one.word));
    }
  }
}

TEST(BallFilms, OfLoadedBallsAlone) {
  const analysis::BearingUnderLoad study = bearing_under_load(
      shipped("spin_bearing_7210", {"load.radial=4 kN", "load.axial=500 N", "operation.shaft_speed=6000 rpm",
                                    "operation.speeds=[6000 rpm]"}));
  ASSERT_TRUE(study.films);
  const bearing::equilibrium::RingState& state = study.state;
  Eigen::Index loaded = (state.contact_load > 0.0).count() + (state.outer_load > 0.0).count();
  EXPECT_EQ(static_cast<Eigen::Index>(study.films->size()), loaded);
  EXPECT_LT(loaded, 2 * state.contact_load.size());
  for (const analysis::BallFilm& film : *study.films) {
    const Eigen::ArrayXd& load = film.race == bearing::Race::inner ? state.contact_load : state.outer_load;
    EXPECT_EQ(film.point.motion.load, load[film.ball]);
    EXPECT_GT(film.point.motion.rolling, 0.0);
    EXPECT_GE(film.point.motion.spin, 0.0);
  }
}

// The approach with a film is Eq. (10)'s at the load and motion found: the film's own, not Hertz's.
TEST(BallFilms, TheApproachIsTheFilms) {
  const std::optional<analysis::SpeedTable> table =
      speed_table(inputs_of("spin_bearing_7210", {"operation.speeds=[9000 rpm]"}));
  ASSERT_TRUE(table);
  const auto value = [&](const std::string& name) { return number_in(table->rows[0], name); };
  const bearing::film::Films films = bearing::film::spin_films(
      bearing::film::ball_contact(
          {.inner = {.osculation = 0.52},
           .outer = {.osculation = 0.52},
           .elements = bearing::Balls{.count = 15, .diameter = 12.7e-3, .contact_angle = 0.6981317007977318},
           .pitch_diameter = 70e-3},
          bearing::Race::outer),
      {.viscosity = 0.01988, .pressure_viscosity = 19.75e-9},
      {.load = value("film_outer_load_N"),
       .rolling = value("film_outer_rolling_speed_m_s"),
       .spin = value("film_outer_spin_rad_s")});
  EXPECT_NEAR(value("film_outer_approach_um"), 1e6 * films.rigid, 1e-9);
  EXPECT_LT(value("film_outer_approach_um"), value("hertz_outer_approach_um"));
  EXPECT_NEAR(value("film_outer_h_min_um"), 1e6 * films.least, 1e-9);
}

// The turning point is that of the table; a shorter one does not invent it.
TEST(BallFilms, TheTurningPointNeedsBothSides) {
  const auto rotating = [](const char* speeds) {
    return speed_table(inputs_of("spin_bearing_7210", {std::string("operation.speeds=") + speeds}))
        ->inner_rotating;
  };
  const std::optional<double> coarse = rotating("[9000 rpm, 11000 rpm, 13000 rpm]");
  const std::optional<double> fine = rotating("[11200 rpm, 11300 rpm, 11400 rpm, 11500 rpm]");
  ASSERT_TRUE(coarse && fine);
  EXPECT_NEAR(*coarse / *fine, 1.0, 0.02);
  EXPECT_FALSE(rotating("[3000 rpm, 6000 rpm, 9000 rpm]"));
  EXPECT_FALSE(rotating("[12000 rpm, 13000 rpm]"));
}

}  // namespace
}  // namespace orbearing::app::film_study_test
