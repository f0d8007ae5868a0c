#include "coupling/analysis/contact_film.hpp"

#include <algorithm>
#include <utility>

#include "mechanics/member_keys.hpp"

namespace orbearing::analysis {

namespace {

namespace film = bearing::film;
using described::Record;
namespace dimension = described::dimension;

FilmPoint solved(const film::EllipticalContact& ellipse, const bearing::Lubricant& oil,
                 const film::ContactMotion& motion) {
  FilmPoint point{.motion = motion, .films = {}, .solution = {}};
  point.solution = film::solve_point_film(film::point_film_case(ellipse, oil, motion));
  point.films = film::films_of(*point.solution, ellipse, oil, motion);
  return point;
}

FilmPoint solved(const film::EllipticalContact& contact, double length, const bearing::Lubricant& oil,
                 const film::ContactMotion& motion) {
  const film::LineFilmCase line = film::line_film_case(contact, length, oil, motion);
  return {.motion = motion,
          .films = {},
          .line = film::solve_line_film(line),
          .length = length,
          .least_dowson_higginson = film::dowson_higginson(line)};
}

FilmPoint by_reynolds(const SpinFilm& machine, const film::ContactMotion& motion) {
  const film::EllipticalContact ellipse = machine.contact.ellipse();
  const auto* line = std::get_if<LineOfContact>(&machine.contact.shape);
  return line != nullptr ? solved(ellipse, line->length, machine.lubricant, motion)
                         : solved(ellipse, machine.lubricant, motion);
}

std::string row_text(std::size_t row) {
  return "points: in row " + std::to_string(row) + " ";
}

}  // namespace

film::EllipticalContact ContactOfBodies::ellipse() const {
  film::EllipticalContact found{.rolling_radius = rolling_radius, .modulus = modulus};
  if (const auto* stated = std::get_if<EllipseOfContact>(&shape)) found.ellipticity = stated->ellipticity;
  return found;
}

mechanics::Problems problems(const SpinFilm& machine) {
  const auto* line = std::get_if<LineOfContact>(&machine.contact.shape);
  if (line == nullptr) return {};
  const mechanics::MemberKeys key(machine);
  if (machine.solver != film::FilmSolver::reynolds)
    return {{key(line->length),
             "a line contact together with film.solver: regression; film.solver: reynolds is required: the "
             "regressions are for ellipses only"}};
  if (std::ranges::any_of(machine.points, [](const auto& point) { return point.spin != 0.0; }))
    return {{"points", "a line contact that spins; no spin is required together with contact.length"}};
  return {};
}

bool FilmOfContact::failed() const {
  return std::ranges::any_of(points, &FilmPoint::lost);
}

FilmOfContact film_of_contact(const SpinFilm& machine) {
  FilmOfContact result;
  const film::EllipticalContact ellipse = machine.contact.ellipse();
  for (const film::ContactMotion& motion : machine.points) {
    const std::string row = row_text(result.points.size() + 1);
    if (machine.solver == film::FilmSolver::reynolds) {
      result.points.push_back(by_reynolds(machine, motion));
      if (result.points.back().lost())
        result.warnings.push_back(
            row +
            "Reynolds' equation was not solved: a film too thin for the grid, or bodies "
            "that penetrate each other");
      continue;
    }
    result.points.push_back({motion, film::spin_films(ellipse, machine.lubricant, motion), {}});
    for (const std::string& what : film::outside_of_range(ellipse, motion))
      result.warnings.push_back(row + "the " + what);
  }
  return result;
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
      "rolling resistance of the oil in the inlet on each surface, isothermal, of an inlet without end",
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

void describe(Record& record, const FilmOfContact& result) {
  described::Entry& table = record.table(
      "film", "point", "of each row of points", result.points, [](Record& row, const FilmPoint& point) {
        describe(row, point);
        row.value("status", "ok, or failed: not solved", point.lost() ? "failed" : "ok");
      });
  table.variable = "";
  table.file = "film.csv";
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const FilmPoint& point = result.points[i];
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

}  // namespace orbearing::analysis
