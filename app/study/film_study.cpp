#include "app/study/film_study.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "app/case/described_case.hpp"
#include "app/results/json_number.hpp"

namespace orbearing::app {

namespace {

namespace film = bearing::film;
using Json = nlohmann::ordered_json;

constexpr double kMicrometres = 1e6, kNewtons = 1.0;

struct FilmQuantity {
  const char* name;
  double scale;  // of results and tables, with its unit
  const char* unit;
  const char* units;  // in files of arrays
  const char* meaning;
  double (*value)(const FilmPoint&);
};

constexpr std::array<FilmQuantity, 5> ellipse_quantities{
    {{"h_c", kMicrometres, "um", "m", "central film, Eq. (11) of [Guo2013] or by Reynolds' equation",
      [](const FilmPoint& point) { return point.films.central; }},
     {"h_min", kMicrometres, "um", "m", "least film, Eq. (12) or by Reynolds' equation",
      [](const FilmPoint& point) { return point.films.least; }},
     {"h_c_HamrockDowson", kMicrometres, "um", "m", "central film without spin, Eq. (13)",
      [](const FilmPoint& point) { return point.films.central_hamrock_dowson; }},
     {"h_min_HamrockDowson", kMicrometres, "um", "m", "least film without spin, Eq. (13)",
      [](const FilmPoint& point) { return point.films.least_hamrock_dowson; }},
     {"h_0", kMicrometres, "um", "m", "approach of the rigid bodies, Eq. (10) or by Reynolds' equation",
      [](const FilmPoint& point) { return point.films.rigid; }}}};

// Of a line contact; nothing where Reynolds' equation was not solved.
template <double film::LineFilm::*member>
double of_line(const FilmPoint& point) {
  return !point.lost() ? (*point.line).*member : std::numeric_limits<double>::quiet_NaN();
}

constexpr std::array<FilmQuantity, 5> line_quantities{
    {{"h_c", kMicrometres, "um", "m", "central film by Reynolds' equation",
      of_line<&film::LineFilm::central>},
     {"h_min", kMicrometres, "um", "m", "least film by Reynolds' equation", of_line<&film::LineFilm::least>},
     {"h_flow", kMicrometres, "um", "m", "oil that passes, as a film without pressure at the rolling speed",
      of_line<&film::LineFilm::flow>},
     {"h_min_DowsonHigginson", kMicrometres, "um", "m", "least film, [DowsonHigginson1966]",
      [](const FilmPoint& point) { return point.least_dowson_higginson; }},
     {"rolling_resistance", kNewtons, "N", "N",
      "by which the oil in the inlet holds each surface back, isothermal, of an inlet without end",
      [](const FilmPoint& point) {
        return point.length * (of_line<&film::LineFilm::rolling_traction>(point) +
                               of_line<&film::LineFilm::inlet_beyond>(point));
      }}}};

std::span<const FilmQuantity> quantities_of(const FilmPoint& point) {
  return point.line ? std::span<const FilmQuantity>(line_quantities) : ellipse_quantities;
}

std::string name_of(const FilmQuantity& one) {
  return std::string(one.name) + "_" + one.unit;
}

struct MotionQuantity {
  const char* name;  // as in results
  const char* variable;
  const char* units;
  const char* meaning;
  double film::ContactMotion::*value;
};

constexpr std::array<MotionQuantity, 3> motion_quantities{
    {{"load_N", "load", "N", "of the contact", &film::ContactMotion::load},
     {"rolling_speed_m_s", "rolling_speed", "m s-1", "mean of both surfaces", &film::ContactMotion::rolling},
     {"spin_rad_s", "spin", "rad s-1", "of one surface against the other", &film::ContactMotion::spin}}};

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
  for (std::size_t i = 0; i < rows.size(); i += motion_quantities.size()) {
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

double film_property(const FilmStudy& study, const std::string& quantity) {
  const FilmPoint& point = study.points.front();
  for (const FilmQuantity& one : quantities_of(point))
    if (quantity == name_of(one)) return one.scale * one.value(point);
  return std::numeric_limits<double>::quiet_NaN();
}

Json film_json(const FilmPoint& point) {
  Json object;
  for (const MotionQuantity& one : motion_quantities) object[one.name] = point.motion.*one.value;
  for (const FilmQuantity& one : quantities_of(point))
    object[name_of(one)] = number_or_null(one.scale * one.value(point));
  return object;
}

namespace {

std::string status_of(const FilmPoint& point) {
  return point.lost() ? "failed" : "ok";
}

}  // namespace

Json film_json(const FilmStudy& study) {
  Json rows = Json::array();
  for (const FilmPoint& point : study.points) {
    rows.push_back(film_json(point));
    rows.back()["status"] = status_of(point);
  }
  return {{"film", rows}};
}

std::string film_text(const FilmStudy& study) {
  std::string text = fmt::format("{:>10} {:>14} {:>12}", "load [N]", "rolling [m/s]", "spin [rad/s]");
  const std::span<const FilmQuantity> quantities = quantities_of(study.points.front());
  for (const FilmQuantity& one : quantities)
    text += fmt::format(" {:>26}", fmt::format("{} [{}]", one.name, one.unit));
  for (const FilmPoint& point : study.points) {
    text += fmt::format("\n{:>10.6g} {:>14.6g} {:>12.6g}", point.motion.load, point.motion.rolling,
                        point.motion.spin);
    for (const FilmQuantity& one : quantities)
      text += fmt::format(" {:>26.4f}", one.scale * one.value(point));
  }
  return text + "\n";
}

PointContent film_content(const FilmStudy& study) {
  PointContent content;
  content.add_dimension("point", study.points.size());
  for (const MotionQuantity& one : motion_quantities)
    content.add_each(one.variable, {"point"}, one.units, one.meaning, study.points,
                     [&](const FilmPoint& point) { return point.motion.*one.value; });
  for (const FilmQuantity& one : quantities_of(study.points.front()))
    content.add_each(one.name, {"point"}, one.units, one.meaning, study.points, one.value);
  return content;
}

std::string film_csv(const FilmStudy& study) {
  std::string text;
  for (const MotionQuantity& one : motion_quantities) text += std::string(one.name) + ",";
  const std::span<const FilmQuantity> quantities = quantities_of(study.points.front());
  for (const FilmQuantity& one : quantities) text += name_of(one) + ",";
  text += "status\n";
  for (const FilmPoint& point : study.points) {
    for (const MotionQuantity& one : motion_quantities) text += fmt::format("{},", point.motion.*one.value);
    for (const FilmQuantity& one : quantities) text += fmt::format("{:.9g},", one.scale * one.value(point));
    text += status_of(point) + "\n";
  }
  return text;
}

std::string film_map_csv(const film::PointFilm& solution) {
  std::string text = "x_mm,y_mm,pressure_GPa,film_um,oil_fraction\n";
  for (Eigen::Index j = 0; j < solution.y.size(); ++j)
    for (Eigen::Index i = 0; i < solution.x.size(); ++i)
      text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.4g}\n", 1e3 * solution.x[i], 1e3 * solution.y[j],
                          1e-9 * solution.pressure(i, j), 1e6 * solution.film(i, j), solution.fraction(i, j));
  return text;
}

std::string film_line_csv(const film::LineFilm& solution) {
  std::string text = "x_mm,pressure_GPa,film_um,oil_fraction\n";
  for (Eigen::Index i = 0; i < solution.x.size(); ++i)
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.4g}\n", 1e3 * solution.x[i], 1e-9 * solution.pressure[i],
                        1e6 * solution.film[i], solution.fraction[i]);
  return text;
}

}  // namespace orbearing::app
