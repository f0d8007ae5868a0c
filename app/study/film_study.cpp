#include "app/study/film_study.hpp"

#include <fmt/format.h>

#include <string>

#include "app/case/described_case.hpp"

namespace orbearing::app {

namespace {

namespace film = bearing::film;
using described::Record;
namespace dimension = described::dimension;

constexpr std::size_t kColumnsOfPoint = 3;  // load, rolling speed, spin

FilmPoint solved(const film::EllipticalContact& contact, double length, const bearing::Lubricant& oil,
                 const film::ContactMotion& motion) {
  if (length > 0.0) {
    const film::LineFilmCase line = film::line_film_case(contact, length, oil, motion);
    return {.motion = motion,
            .films = {},
            .line = film::solve_line_film(line),
            .length = length,
            .least_dowson_higginson = film::dowson_higginson(line)};
  }
  FilmPoint point{.motion = motion, .films = {}, .solution = {}};
  point.solution = film::solve_point_film(film::point_film_case(contact, oil, motion));
  point.films = film::films_of(*point.solution, contact, oil, motion);
  return point;
}

}  // namespace

bool is_spin_film(const ResolvedCase& resolved) {
  return resolved.model() == spin_film;
}

FilmStudy film_study(const ResolvedCase& in) {
  const auto contact = from_case<film::EllipticalContact>(in);
  const auto line = from_case<film::LineContact>(in);
  const auto oil = from_case<bearing::Lubricant>(in);
  const auto choice = from_case<film::FilmChoice>(in);
  const std::vector<double>& rows = in.list("points");
  FilmStudy study;
  for (std::size_t i = 0; i < rows.size(); i += kColumnsOfPoint) {
    const film::ContactMotion motion{.load = rows[i], .rolling = rows[i + 1], .spin = rows[i + 2]};
    if (choice.solver == film::FilmSolver::reynolds) {
      study.points.push_back(solved(contact, line.length, oil, motion));
      if (study.points.back().lost())
        study.warnings.push_back(
            fmt::format("points: in row {} Reynolds' equation was not solved: a film too thin for the grid, "
                        "or bodies that run through each other",
                        study.points.size()));
      continue;
    }
    study.points.push_back({motion, film::spin_films(contact, oil, motion), {}});
    for (const std::string& what : film::outside_of_range(contact, motion))
      study.warnings.push_back(fmt::format("points: in row {} the {}", study.points.size(), what));
  }
  return study;
}

namespace {

void describe_ellipse(Record& row, const film::Films& films) {
  const auto add = [&](const char* name, const char* meaning, double value) {
    row.value(name, dimension::small_length, meaning, value);
  };
  add("h_c_um", "central film, Eq. (11) of [Guo2013] or by Reynolds' equation", films.central);
  add("h_min_um", "least film, Eq. (12) or by Reynolds' equation", films.least);
  add("h_c_HamrockDowson_um", "central film without spin, Eq. (13)", films.central_hamrock_dowson);
  add("h_min_HamrockDowson_um", "least film without spin, Eq. (13)", films.least_hamrock_dowson);
  add("h_0_um", "approach of the rigid bodies, Eq. (10) or by Reynolds' equation", films.rigid);
}

// Nothing of Reynolds' equation where it was not solved.
void describe_line(Record& row, const FilmPoint& point) {
  const film::LineFilm& line = *point.line;
  const auto add = [&](const char* name, const described::Dimension& of, const char* meaning, double value) {
    row.value(name, of, meaning, point.lost() ? described::kAbsent : value);
  };
  add("h_c_um", dimension::small_length, "central film by Reynolds' equation", line.central);
  add("h_min_um", dimension::small_length, "least film by Reynolds' equation", line.least);
  add("h_flow_um", dimension::small_length,
      "oil that passes, as a film without pressure at the rolling speed", line.flow);
  row.value("h_min_DowsonHigginson_um", dimension::small_length, "least film, [DowsonHigginson1966]",
            point.least_dowson_higginson);
  add("rolling_resistance_N", dimension::force,
      "by which the oil in the inlet holds each surface back, isothermal, of an inlet without end",
      point.length * (line.rolling_traction + line.inlet_beyond));
}

// Along dimensions of its own, since grids differ.
void describe_map(Record& record, const film::PointFilm& solution, const std::string& number) {
  const std::string x = "x_" + number, y = "y_" + number;
  record.series("x_mm", dimension::length, "along rolling", {x}, solution.x);
  record.series("y_mm", dimension::length, "across it", {y}, solution.y);
  record.series("pressure_GPa", dimension::stress, "of the oil", {x, y}, solution.pressure);
  record.series("film_um", dimension::small_length, "gap of the bodies", {x, y}, solution.film);
  record.series("oil_fraction", dimension::ratio, "of the gap", {x, y}, solution.fraction);
}

void describe_map(Record& record, const film::LineFilm& solution, const std::string& number) {
  const std::string x = "x_" + number;
  record.series("x_mm", dimension::length, "along rolling", {x}, solution.x);
  record.series("pressure_GPa", dimension::stress, "of the oil", {x}, solution.pressure);
  record.series("film_um", dimension::small_length, "gap of the bodies", {x}, solution.film);
  record.series("oil_fraction", dimension::ratio, "of the gap", {x}, solution.fraction);
}

}  // namespace

void describe(Record& row, const FilmPoint& point) {
  row.value("load_N", dimension::force, "of the contact", point.motion.load);
  row.value("rolling_speed_m_s", dimension::speed, "mean of both surfaces", point.motion.rolling);
  row.value("spin_rad_s", dimension::spin, "of one surface against the other", point.motion.spin);
  if (point.line)
    describe_line(row, point);
  else
    describe_ellipse(row, point.films);
}

void describe(Record& record, const FilmStudy& study) {
  described::Entry& table = record.table(
      "film", "point", "of each row of points", study.points, [](Record& row, const FilmPoint& point) {
        describe(row, point);
        row.value("status", "ok, or failed: not solved", point.lost() ? "failed" : "ok");
      });
  table.variable = "";
  table.file = "film.csv";
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const FilmPoint& point = study.points[i];
    const std::string number = std::to_string(i + 1);
    const auto add = [&](const std::string& name, const auto& solution) {
      described::Entry& map =
          record.child(name + number, "each node of the grid", solution,
                       [&](Record& nodes, const auto& of) { describe_map(nodes, of, number); });
      map.in_files_alone = true;
      map.file = name + number + ".csv";
    };
    if (!point.lost() && point.solution) add("film_map_", *point.solution);
    if (!point.lost() && point.line) add("film_line_", *point.line);
  }
}

}  // namespace orbearing::app
