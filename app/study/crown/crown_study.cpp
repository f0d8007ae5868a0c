#include "app/study/crown/crown_study.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/errors.hpp"
#include "app/results/durable_file.hpp"
#include "bearing/life/basic_life.hpp"
#include "orbearing/files.hpp"

namespace orbearing::app {

namespace {

using namespace analysis::crowning;
using bearing::profile::Profile;

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double kAtEnd = 1e-6;  // of the greatest drop

// All that computing needs, laid out once.
struct Bench {
  const CrownRequest& request;
  CrownProblem problem;
  RollerPressure pressure;
  int jobs;
};

// Whether there is a band of the worst case; a population has no band of its own.
bool has_band(const CrownRequest& request) {
  if (request.computes_tilt()) return false;
  return request.tolerance.drop > 0.0 || request.tolerance.tilt > 0.0;
}

std::vector<CrownPoint> grid_of(const Bench& bench, const ProfileFamily& family,
                                const Progressed& progressed) {
  std::vector<Profile> profiles;
  for (const double drop : bench.request.drops)
    profiles.push_back(profile_of(family, {drop, default_share(family)}));
  return crown_grid(bench.problem, bench.pressure, profiles, bench.request.drops, bench.request.tilts,
                    bench.jobs, progressed);
}

// Lives and pressures of one profile over the tilts.
CrownDesign design_of(const Bench& bench, const std::string& name, const Profile& made, double drop) {
  const std::vector<double>& tilts = bench.request.tilts;
  const auto points = crown_grid(bench.problem, bench.pressure, {made}, {drop}, tilts, bench.jobs, {});
  CrownDesign design{.profile = name, .crown = {drop, 1.0}, .made = made};
  design.life_hours = design.lundberg_palmgren_hours = std::numeric_limits<double>::infinity();
  design.rated_hours = points.front().rated_hours;
  for (const CrownPoint& point : points) {
    if (point.status != "ok") throw ComputationFailed("crown: profile " + name + ": " + point.status);
    design.life_hours = std::min(design.life_hours, point.life_hours);
    design.lundberg_palmgren_hours = std::min(design.lundberg_palmgren_hours, point.lundberg_palmgren_hours);
    for (const auto life : bearing::rating::kRatedHours)
      if (!(point.rated_hours.*life >= design.rated_hours.*life))
        design.rated_hours.*life = point.rated_hours.*life;
    if (point.pressure.peak <= design.peak_pressure) continue;
    design.peak_pressure = point.pressure.peak;
    design.edge_ratio = point.pressure.edge_ratio;
  }
  const std::vector<double> lives = pressure_lives(bench.problem, bench.pressure, made, tilts, bench.jobs);
  design.pressure_life_hours = *std::min_element(lives.begin(), lives.end());
  design.life_in_band = design.untilted_life_hours = design.untilted_pressure_life_hours = kNotKnown;
  if (bench.request.computes_tilt()) return design;
  const Lean none = Lean::Zero();
  const bool studied = tilts.front() == 0.0;
  design.untilted_life_hours = studied ? points.front().life_hours : life_hours(bench.problem, made, none);
  design.untilted_pressure_life_hours =
      studied ? lives.front() : pressure_life_hours(bench.problem, bench.pressure, made, none);
  return design;
}

// Governing life of the rollers as the case has them, worst over the tilts.
double case_hours(const Bench& bench) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const double tilt : bench.request.tilts)
    shortest = std::min(shortest, life_hours(bench.problem, bench.problem.bearing.rollers().profile,
                                             lean_by(bench.problem, tilt)));
  return shortest;
}

CrownDesign crowned(const Bench& bench, const std::string& name, const ProfileFamily& family,
                    const Crown& crown) {
  CrownDesign design = design_of(bench, name, profile_of(family, crown), crown.drop);
  design.crown = crown;
  design.has_share = has_share(family);
  if (has_band(bench.request))
    design.life_in_band = worst_life_hours(bench.problem, family, crown,
                                           members_of(bench.request.tilts, bench.request.tolerance));
  return design;
}

CrownSearch search_of(const Bench& bench, const std::string& name, const ProfileFamily& family,
                      const Tolerance& tolerance) {
  const SearchOptions options{.greatest_drop = bench.request.drops.back(),
                              .least_drop = tolerance.drop,
                              .starts = bench.request.starts,
                              .jobs = bench.jobs};
  const CrownOptimum best =
      best_crown(bench.problem, family, members_of(bench.request.tilts, tolerance), options);
  return {crowned(bench, name, family, best.crown), best.ends, best.in_best,
          best.crown.drop >= (1.0 - kAtEnd) * options.greatest_drop};
}

template <class Life>
std::size_t longest(const std::vector<CrownSearch>& searches, Life&& life) {
  const auto best = std::max_element(searches.begin(), searches.end(), [&](const auto& a, const auto& b) {
    return life(a.best) < life(b.best);
  });
  return static_cast<std::size_t>(best - searches.begin());
}

void add_warnings(CrownStudy& study) {
  for (const CrownSearch& search : study.searches) {
    if (search.at_end)
      study.warnings.push_back(
          fmt::format("profile {}: the best drop is the greatest studied, {:.4g} um; a greater one in "
                      "--drops may be better",
                      search.best.profile, 1e6 * search.best.crown.drop));
    if (search.in_best < static_cast<int>(search.ends.size()))
      study.warnings.push_back(
          fmt::format("profile {}: {} of {} starts of the search ended in the best crown; "
                      "the others in lesser ones, listed under starts",
                      search.best.profile, search.in_best, search.ends.size()));
  }
}

// Beyond it a roller contact yields.
constexpr double kYield = static_pressure(bearing::rating::RollingElement::roller);

void add_pressure_warning(CrownStudy& study) {
  double peak = 0.0;
  for (const DutyRecord& duty : study.recommended.duties) peak = std::max(peak, duty.pressure.peak);
  if (peak > kYield)
    study.warnings.push_back(
        fmt::format("recommended: rollers press up to {:.4g} MPa; above {:g} MPa they yield, and elastic "
                    "contact, life and this advice are not valid",
                    1e-6 * peak, 1e-6 * kYield));
}

void add_advice_warnings(CrownStudy& study) {
  constexpr double noted = 0.01;  // of a life
  const HalfSpaceAdvice& advice = study.recommended.advice;
  if (advice.band.open)
    study.warnings.push_back(
        fmt::format("recommended: the band of drops ends at {:.3g} um because greater ones were not studied; "
                    "its upper end lies beyond. Give --drops that reach further",
                    1e6 * advice.band.most));
  if (advice.interpolation_error > noted)
    study.warnings.push_back(fmt::format(
        "recommended: lives between the drops at which they were computed miss by {:.2g} of themselves",
        advice.interpolation_error));
  if (advice.quadrature_error > noted)
    study.warnings.push_back(
        fmt::format("recommended: twice as many nodes within the tolerances change the life by {:.2g} of it",
                    advice.quadrature_error));
}

void put_points(const Bench& bench, const Progressed& progressed, CrownStudy& study) {
  std::size_t before = 0;
  for (const std::string& name : study.request.profiles) {
    const auto shifted = [&](std::size_t done) {
      if (progressed) progressed(before + done);
    };
    study.points.push_back(grid_of(bench, family_in(bench.problem, name), shifted));
    before += study.points.back().size();
    study.worst.push_back(worst_of_tilts(study.points.back(), study.request.tilts.size()));
    for (const CrownPoint& point : study.points.back()) study.failed += point.status != "ok";
  }
}

void put_searches(const Bench& bench, CrownStudy& study) {
  for (const std::string& name : study.request.profiles) {
    const ProfileFamily family = family_in(bench.problem, name);
    study.searches.push_back(search_of(bench, name, family, {}));
    if (has_band(study.request))
      study.robust.push_back(search_of(bench, name, family, study.request.tolerance));
  }
  study.best = longest(study.searches, [](const CrownDesign& design) { return design.life_hours; });
  study.best_robust = longest(study.robust, [](const CrownDesign& design) { return design.life_in_band; });
}

// The share of a crown without depth is none.
double share_beside(const CrownSearch& search, const ProfileFamily& family, double greatest) {
  return search.best.crown.drop > kAtEnd * greatest ? search.best.crown.share : default_share(family);
}

// Best drop of each kind of profile by half-space pressures, with the share found with laminae; the profile
// with the longest life.
Recommendation recommendation(const Bench& bench, const CrownStudy& study) {
  constexpr double default_miss = 1e-6;  // [m]
  const CrownRequest& request = bench.request;
  Recommendation best;
  for (std::size_t i = 0; i < study.searches.size(); ++i) {
    const CrownSearch& search = study.searches[i];
    const ProfileFamily family = family_in(bench.problem, request.profiles[i]);
    const double share = share_beside(search, family, request.drops.back());
    const HalfSpaceAdvice advice =
        half_space_advice(bench.problem, bench.pressure, family, share,
                          {.tilts = request.tilts,
                           .tolerance = request.tolerance,
                           .distribution = request.distribution,
                           .greatest_drop = request.drops.back(),
                           .miss = request.tolerance.drop > 0.0 ? request.tolerance.drop : default_miss,
                           .other_drop = search.best.crown.drop,
                           .jobs = bench.jobs});
    if (advice.life_hours <= best.advice.life_hours) continue;
    best.advice = advice;
    best.design = crowned(bench, request.profiles[i], family, {advice.drop, share});
  }
  best.duties = duty_records(bench.problem, bench.pressure, best.design.made, request.tilts, bench.jobs);
  return best;
}

// Without warnings.
CrownStudy studied(const CrownRequest& request, int jobs, const Progressed& progressed) {
  CrownStudy study{.request = request};
  const CrownProblem problem = problem_of(request);
  const Bench bench{study.request, problem, RollerPressure(problem), jobs};
  study.life = problem.governing;
  try {
    put_points(bench, progressed, study);
    put_searches(bench, study);
    study.straight = design_of(bench, "straight", bearing::profile::Straight{}, 0.0);
    const double drop = reference_drop(problem.bearing);
    const ProfileFamily standard = family_of("iso16281", problem.bearing, 1.0);
    study.reference = crowned(bench, "iso16281", standard, {drop, 1.0});
    study.recommended = recommendation(bench, study);
    study.case_hours = case_hours(bench);
  } catch (const std::runtime_error& error) {
    throw ComputationFailed(std::string("crown: ") + error.what());
  }
  return study;
}

// Whether a greater drop than those studied may be better.
bool ends_at_greatest(const CrownStudy& study) {
  constexpr double near = 5e-3;  // of the greatest: two steps of the scan for the best
  return study.recommended.advice.drop >= (1.0 - near) * study.request.drops.back() ||
         std::ranges::any_of(study.searches, &CrownSearch::at_end);
}

}  // namespace

std::size_t grid_size(const CrownRequest& request) {
  return request.profiles.size() * request.drops.size() * request.tilts.size();
}

CrownProblem problem_of(const CrownRequest& request) {
  return crown_problem(request.drivetrain, request.geometry, request.spectrum, request.method,
                       request.laminae);
}

// A profile that the case states lends its proportions; another is laid out for the load that 4.08 F/Z of the
// most loaded duty gives.
ProfileFamily family_in(const CrownProblem& problem, const std::string& name) {
  if (bearing::profile::kind(problem.bearing.rollers().profile) == name)
    return family_like(problem.bearing.rollers().profile, problem.bearing);
  double load = 0.0;
  for (const Duty& duty : problem.duties) load = std::max(load, duty.point.bore_load.norm());
  return family_of(name, problem.bearing, 4.08 * load / problem.bearing.rollers().count);
}

CrownStudy crown_study(const CrownRequest& request, int jobs, const Progressed& progressed) {
  CrownStudy study = studied(request, jobs, progressed);
  for (CrownRequest wider = request; !request.drops_stated && ends_at_greatest(study);) {
    if (2.0 * wider.drops.back() > kMostDrop) break;
    for (double& drop : wider.drops) drop *= 2.0;
    study = studied(wider, jobs, progressed);
  }
  add_warnings(study);
  add_advice_warnings(study);
  add_pressure_warning(study);
  return study;
}

namespace fs = std::filesystem;

void write_crown(const fs::path& folder, const CrownResult& result) {
  const nlohmann::ordered_json file{
      {"result", result.object}, {"text", result.text}, {"failed", result.failed}};
  write_aside_and_rename(folder / crown_file_name, file.dump(1) + "\n");
  sync_folder(folder);
}

CrownResult read_crown(const fs::path& folder) {
  const fs::path path = folder / crown_file_name;
  try {
    const auto file = nlohmann::ordered_json::parse(read_file(path));
    return {file.at("result"), file.at("text"), file.at("failed")};
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(path.string() + ": is not a crowning study of this program (" + error.what() +
                   "); required: an untouched one. Run crown again into another folder");
  }
}

bool holds_crown(const fs::path& folder) {
  return fs::exists(folder / crown_file_name);
}

}  // namespace orbearing::app
