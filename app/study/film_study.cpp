#include "app/study/film_study.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/case/described_case.hpp"
#include "app/results/json_number.hpp"

namespace orbearing::app {

namespace {

namespace film = bearing::film;
using Json = nlohmann::ordered_json;

struct FilmQuantity {
  const char* name;
  const char* meaning;
  double film::Films::*value;
};

constexpr std::array<FilmQuantity, 5> film_quantities{
    {{"h_c", "central film, Eq. (11) of [Guo2013] or by Reynolds' equation", &film::Films::central},
     {"h_min", "least film, Eq. (12) or by Reynolds' equation", &film::Films::least},
     {"h_c_HamrockDowson", "central film without spin, Eq. (13)", &film::Films::central_hamrock_dowson},
     {"h_min_HamrockDowson", "least film without spin, Eq. (13)", &film::Films::least_hamrock_dowson},
     {"h_0", "approach of the rigid bodies, Eq. (10) or by Reynolds' equation", &film::Films::rigid}}};

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

NamedArray over_points(std::string name, std::string units, std::string meaning) {
  return {std::move(name), {"point"}, std::move(units), std::move(meaning), {}};
}

FilmPoint solved(const film::EllipticalContact& contact, const bearing::Lubricant& oil,
                 const film::ContactMotion& motion) {
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
  const auto oil = from_case<bearing::Lubricant>(in);
  const auto choice = from_case<film::FilmChoice>(in);
  const std::vector<double>& rows = in.list("points");
  FilmStudy study;
  for (std::size_t i = 0; i < rows.size(); i += motion_quantities.size()) {
    const film::ContactMotion motion{.load = rows[i], .rolling = rows[i + 1], .spin = rows[i + 2]};
    if (choice.solver == film::FilmSolver::reynolds) {
      study.points.push_back(solved(contact, oil, motion));
      if (!study.points.back().solution->converged)
        study.warnings.push_back(
            fmt::format("points: in row {} Reynolds' equation was not solved", study.points.size()));
      continue;
    }
    study.points.push_back({motion, film::spin_films(contact, oil, motion), {}});
    for (const std::string& what : film::outside_of_range(contact, motion))
      study.warnings.push_back(fmt::format("points: in row {} the {}", study.points.size(), what));
  }
  return study;
}

double film_property(const FilmStudy& study, const std::string& quantity) {
  for (const FilmQuantity& one : film_quantities)
    if (quantity == std::string(one.name) + "_um") return 1e6 * study.points.front().films.*one.value;
  return std::numeric_limits<double>::quiet_NaN();
}

Json film_json(const FilmPoint& point) {
  Json object;
  for (const MotionQuantity& one : motion_quantities) object[one.name] = point.motion.*one.value;
  for (const FilmQuantity& one : film_quantities)
    object[std::string(one.name) + "_um"] = number_or_null(1e6 * point.films.*one.value);
  return object;
}

Json film_json(const FilmStudy& study) {
  Json rows = Json::array();
  for (const FilmPoint& point : study.points) rows.push_back(film_json(point));
  return {{"film", rows}};
}

std::string film_text(const FilmStudy& study) {
  std::string text = fmt::format("{:>10} {:>14} {:>12}", "load [N]", "rolling [m/s]", "spin [rad/s]");
  for (const FilmQuantity& one : film_quantities)
    text += fmt::format(" {:>24}", std::string(one.name) + " [um]");
  for (const FilmPoint& point : study.points) {
    text += fmt::format("\n{:>10.6g} {:>14.6g} {:>12.6g}", point.motion.load, point.motion.rolling,
                        point.motion.spin);
    for (const FilmQuantity& one : film_quantities)
      text += fmt::format(" {:>24.4f}", 1e6 * point.films.*one.value);
  }
  return text + "\n";
}

PointContent film_content(const FilmStudy& study) {
  PointContent content{.dimensions = {{"point", study.points.size()}}, .arrays = {}, .attributes = {}};
  for (const MotionQuantity& one : motion_quantities) {
    content.arrays.push_back(over_points(one.variable, one.units, one.meaning));
    for (const FilmPoint& point : study.points)
      content.arrays.back().values.push_back(point.motion.*one.value);
  }
  for (const FilmQuantity& one : film_quantities) {
    content.arrays.push_back(over_points(one.name, "m", one.meaning));
    for (const FilmPoint& point : study.points)
      content.arrays.back().values.push_back(point.films.*one.value);
  }
  return content;
}

std::string film_csv(const FilmStudy& study) {
  std::string text;
  for (const MotionQuantity& one : motion_quantities) text += std::string(one.name) + ",";
  for (const FilmQuantity& one : film_quantities) text += std::string(one.name) + "_um,";
  text.back() = '\n';
  for (const FilmPoint& point : study.points) {
    for (const MotionQuantity& one : motion_quantities) text += fmt::format("{},", point.motion.*one.value);
    for (const FilmQuantity& one : film_quantities)
      text += fmt::format("{:.9g},", 1e6 * point.films.*one.value);
    text.back() = '\n';
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

}  // namespace orbearing::app
