// A single contact that rolls and spins, the model spin-film, and its film at given loads and speeds.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bearing/film/film_choice.hpp"
#include "bearing/parameters.hpp"
#include "mechanics/problem.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

struct EllipseOfContact {
  double ellipticity = 1.0;  // [-]  axis across rolling over that along it
};
template <class Visitor>
void describe(Visitor& visit, EllipseOfContact& m) {
  using namespace described;
  members(
      visit, m,
      input(m.ellipticity, "ellipticity", "axis of the ellipse of contact across rolling over that along it",
            {.range = {0.01, 100.0}}));
}

struct LineOfContact {
  double length = 0.0;  // [m]
};
template <class Visitor>
void describe(Visitor& visit, LineOfContact& m) {
  using namespace described;
  members(visit, m,
          input(m.length, "length", "length of a line contact, instead of contact.ellipticity",
                {.dimension = dimension::length, .range = positive(1e4)}));
}

struct ContactOfBodies {
  double rolling_radius = 0.0;  // [m]   equivalent, in the plane of rolling
  std::variant<EllipseOfContact, LineOfContact> shape{};
  double modulus = 0.0;  // [Pa]  E/(1 - nu^2) for like bodies

  /// As used in the regressions; of a line with the ellipticity 1.
  bearing::film::EllipticalContact ellipse() const;
};
template <class Visitor>
void describe(Visitor& visit, ContactOfBodies& m) {
  using namespace described;
  members(visit, m,
          input(m.rolling_radius, "rolling_radius", "equivalent radius of curvature in the plane of rolling",
                {.dimension = dimension::length, .range = positive(1e4)}),
          either(m.shape),
          input(m.modulus, "modulus", "effective modulus E': E/(1 - nu^2) for like bodies",
                {.dimension = dimension::stress, .range = positive(1e4)}));
}

/// The machine of the model spin-film.
struct SpinFilm {
  static constexpr std::string_view model = "spin-film";

  ContactOfBodies contact;
  bearing::Lubricant lubricant = bearing::warm_gear_oil;
  bearing::film::FilmSolver solver = bearing::film::FilmSolver::regression;
  std::vector<bearing::film::ContactMotion> points;
};
template <class Visitor>
void describe(Visitor& visit, SpinFilm& m) {
  using namespace described;
  members(visit, m, block(m.contact, "contact"), part(m.lubricant),
          input(m.solver, "film.solver",
                "film by the source's regressions, or by Reynolds' equation with elastic bodies (129 x 129 "
                "nodes)",
                {.reason = "as the source; a solution takes about a second and has no range to leave"}),
          input(m.points, "points", "loads and motions for which the film is computed"));
}

/// Inconsistencies of the inputs.
mechanics::Problems problems(const SpinFilm& machine);

/// Central film of a line, over a step of its grid squared, below which the grid does not resolve it: its
/// least film is some tenths too thin there.
inline constexpr double least_film_in_steps = 60.0;

struct FilmPoint {
  bearing::film::ContactMotion motion;
  bearing::film::Films films;
  std::optional<bearing::film::PointFilm> solution{};  // of Reynolds' equation
  std::optional<bearing::film::LineFilm> line{};       // the same of a line contact, which has nothing else
  double length = 0.0;                                 // [m]  of that contact
  double least_dowson_higginson = 0.0;                 // [m]  of it

  /// Whether Reynolds' equation was to be solved and was not.
  bool lost() const {
    return (solution && !solution->converged) ||
           (line && (!line->converged || line->film_in_steps < least_film_in_steps));
  }
};
/// Its motion and films; nothing where it is not loaded.
void describe(described::Record& row, const FilmPoint& point);

struct FilmOfContact {
  std::vector<FilmPoint> points;
  std::vector<std::string> warnings;  // what lies outside of the ranges of the regressions, or was not solved

  bool failed() const;  // in parts
};
/// With pressure and film at each node of the solutions of Reynolds' equation.
void describe(described::Record& record, const FilmOfContact& result);

FilmOfContact film_of_contact(const SpinFilm& machine);

}  // namespace orbearing::analysis
