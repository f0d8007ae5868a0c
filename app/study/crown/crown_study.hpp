// The crowning study of a case: grid, optimum, what it is compared with.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/study/crown/crown_options.hpp"
#include "mechanics/record.hpp"

namespace orbearing::app {

/// A profile with the worst of its lives and pressures over the tilts studied.
struct CrownDesign {
  std::string profile;
  analysis::crowning::Crown crown;  // share: of kinds with a straight middle
  bool has_share = false;
  bearing::profile::Profile made;
  double life_hours = 0.0;                    // [h]   the governing one, as all but the next
  double lundberg_palmgren_hours = 0.0;       // [h]
  double peak_pressure = 0.0;                 // [Pa]
  double edge_ratio = 0.0;                    // [-]   at that pressure
  bearing::rating::RatedHours rated_hours{};  // worst of each, by the standards; NaN where they give none
  double untilted_life_hours = 0.0;           // [h]   NaN where tilts are computed, as below
  double pressure_life_hours = 0.0;           // [h]  worst, from half-space pressures
  double untilted_pressure_life_hours = 0.0;  // [h]
  double life_in_band = 0.0;                  // [h]   worst within the tolerances; NaN without any
};

/// Result of a search for one kind of profile.
struct CrownSearch {
  CrownDesign best;
  std::vector<analysis::crowning::SearchEnd> ends;
  int in_best = 0;      // starts that ended in the best
  bool at_end = false;  // the greatest drop studied is the best: a greater one may be better
};

/// The drop to take by half-space pressures, how closely, and what each duty does to it.
struct Recommendation {
  CrownDesign design;
  analysis::crowning::HalfSpaceAdvice advice;
  std::vector<analysis::crowning::DutyRecord> duties;  // those of the problem: at speed, for some time
};

/// Lives [h] of the case as it is, with the recommended profile, and with the drop that has the longest one.
struct LivesOfCrowns {
  double of_case = 0.0;
  double recommended = 0.0;
  double longest = 0.0;
  double longest_drop = 0.0;  // [m]
  std::string longest_profile;

  /// Whether the recommended profile shortens the life.
  bool is_shorter() const;
};

/// By the governing life of the case, and by that of the study.
struct LivesInRun {
  std::string key;
  LivesOfCrowns run;            // of the worst bearing, as `run` has it: its tilts, its spectrum
  LivesOfCrowns at_study_tilt;  // of one bearing, by the laminae and the tilts of the study

  bool is_shorter() const;
};

struct CrownStudy {
  CrownRequest request;
  bearing::rating::Life life = bearing::rating::Life::lundberg_palmgren;  // that is made longest
  std::vector<std::vector<analysis::crowning::CrownPoint>> points;        // (profiles)(drops x tilts)
  std::vector<std::vector<analysis::crowning::WorstOfTilts>> worst;       // (profiles)(drops)
  std::vector<CrownSearch> searches;                                      // (profiles)
  std::size_t best = 0;                                                   // the profile with the longest life
  CrownDesign straight;
  CrownDesign reference;  // profile of ISO/TS 16281 as in the standard
  std::vector<CrownSearch>
      robust;  // (profiles) best within the tolerances; empty without any, or computed tilts
  std::size_t best_robust = 0;
  Recommendation recommended;        // for the tolerances where there are such
  double case_hours = 0.0;           // [h]  governing life with the profile of the case, worst over the tilts
  std::optional<LivesInRun> in_run;  // once put_lives_in_run() has computed it
  std::vector<std::string> warnings;
  int failed = 0;  // points without equilibrium
};

/// Runs it on `jobs` threads (0: all); `progressed` is called with finished points of the grid. Throws
/// ComputationFailed where no crown could be found at all.
CrownStudy crown_study(const CrownRequest& request, int jobs,
                       const analysis::crowning::Progressed& progressed);

/// Lives with the recommended profile as `run` of the case gives them, under its spectrum where it states
/// one; `set`: of several sets, the one that was studied.
void put_lives_in_run(const ResolvedCase& given, const std::string& set, int jobs, CrownStudy& study);

/// "ok", or by how much the recommended profile shortens the life that results go by.
std::string status_of_recommended(const CrownStudy& study);
/// The same as a warning; empty where there is none.
std::string warning_of_recommended(const CrownStudy& study);

/// Warnings of inputs without effect; throws BadInput for those that a study ought to take and cannot.
std::vector<std::string> require_crown_uses(const ResolvedCase& resolved, const CrownChoices& choices);
/// All that is warned of: the recommended profile, the study, `noted` of its case (CrownCase), gears and
/// bearings, and inputs without effect.
std::vector<std::string> crown_warnings(const ResolvedCase& resolved, const CrownChoices& choices,
                                        const std::vector<std::string>& noted, const CrownStudy& study);

/// The lives in run for terminals.
std::string text_in_run(const CrownStudy& study);

/// `points`, `optimum`, `straight` and further results; nothing where a point failed.
void describe(described::Record& record, const CrownStudy& study);

/// Points of the grid.
std::size_t grid_size(const CrownRequest& request);

/// The parts it is made of, for pictures.
analysis::crowning::CrownProblem problem_of(const CrownRequest& request);
analysis::crowning::ProfileFamily family_in(const analysis::crowning::CrownProblem& problem,
                                            const std::string& name);

// crown.json in the folder of a crowning study: its result, kept for --resume and for the report.

inline constexpr const char* crown_file_name = "crown.json";

/// Output of the command, as JSON and as text.
struct CrownResult {
  nlohmann::ordered_json object;
  std::string text;
  int failed = 0;  // points without equilibrium
};

void write_crown(const std::filesystem::path& folder, const CrownResult& result);

/// Throws BadInput where the file is missing or is not what this program writes.
CrownResult read_crown(const std::filesystem::path& folder);

/// Whether `folder` holds a crowning study.
bool holds_crown(const std::filesystem::path& folder);

/// Data of figures besides the result, which the command printed as JSON: `profiles` (to scale), `pressure`
/// (curves along the roller, each profile with and without tilt), `zone` (pressure over the load zone), `map`
/// (life over drop and tilt), `fronts` (life against pressure, each kind of profile), `speeds` (life over
/// input speed).
nlohmann::ordered_json crown_figures(const ResolvedCase& resolved, const CrownRequest& request,
                                     const nlohmann::ordered_json& result);

}  // namespace orbearing::app
