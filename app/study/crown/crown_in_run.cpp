// Lives that `run` gives a case with the rollers that a crowning study recommends.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "app/case/input_keys.hpp"
#include "app/case/spectrum_case.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/results/sweep_run.hpp"
#include "app/study/analysis.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/derivatives.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/planetary_case.hpp"
#include "app/study/sweep_study.hpp"
#include "app/units.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app {

namespace {

using analysis::crowning::Crown;

constexpr double kNoDrop = 1e-10;  // [m]  round-off of a search that ends at a straight roller
constexpr double kShorter = 1e-5;  // [-]  of a life: settings of a drop have six digits

// Governing life [h] of the worst bearing: at the operating point, or under the spectrum of the case.
WorstBearing life_of_run(const ResolvedCase& in, int jobs) {
  if (!in.has(kSpectrumPath)) {
    const ScalarResult::Value life = scalar_result(in).compute(in);
    return {life.number, life.key, life.of_set};
  }
  SweepRequest request = sweep_request(in, "quasi-static");
  request.jobs = jobs;
  request.quiet = true;
  const SweepOutcome outcome = run_sweep(request);
  return outcome.spectra.empty() ? WorstBearing{} : outcome.spectra.front().worst;
}

// The case with a profile of that kind, as a user would state it.
class WithRollers {
 public:
  WithRollers(const ResolvedCase& in, const CrownDesign& design, const std::string& set, int jobs)
      : in_(in), design_(design), set_(set.empty() ? "" : set_prefix(set)), jobs_(jobs) {}

  /// [h]  NaN where there is no such case, or no such life.
  double hours(double drop) const {
    try {
      return life_of_run(in_.with(settings(drop)), jobs_).value;
    } catch (const std::exception&) {  // no such case, or no equilibrium
      throw_if_stopped();
      return described::kAbsent;
    }
  }

 private:
  std::vector<Setting> settings(double drop) const {
    const std::string block = set_ + "bearing.profile.";
    std::vector<Setting> settings{{block + "kind", design_.profile},
                                  {block + "drop", fmt::format("{:.6g} um", per_micro * drop)}};
    if (!design_.has_share) return settings;
    const double share = design_.crown.share, length = in_.quantity(set_ + keys().roller_length);
    if (design_.profile == "chamfer")
      settings.push_back({block + "chamfer_length", fmt::format("{} m", 0.5 * share * length)});
    else if (design_.profile == "straight-circular")
      settings.push_back({block + "straight_length", fmt::format("{} m", (1.0 - share) * length)});
    else
      settings.push_back({block + "k2", fmt::format("{}", share)});
    return settings;
  }

  const ResolvedCase& in_;
  const CrownDesign& design_;
  std::string set_;
  int jobs_;
};

// The longest one over the drops of the study, and between them.
void put_longest(const WithRollers& rollers, std::vector<double> drops, LivesOfCrowns& lives) {
  constexpr int digits = 12;  // binary ones of the drop: the life is flat there
  if (drops.front() > 0.0) drops.insert(drops.begin(), 0.0);
  lives.longest = -std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  const auto take = [&](double drop, double hours) {
    if (!(hours > lives.longest)) return false;
    lives.longest = hours;
    lives.longest_drop = drop;
    return true;
  };
  for (std::size_t i = 0; i < drops.size(); ++i)
    if (take(drops[i], rollers.hours(drops[i]))) best = i;
  const double low = drops[best > 0 ? best - 1 : best], high = drops[std::min(best + 1, drops.size() - 1)];
  if (lives.longest < 0.0) lives.longest = described::kAbsent;
  if (!(high > low) || !std::isfinite(lives.longest)) return;
  const auto shorter = [&](double micrometres) {
    const double hours = rollers.hours(micrometres / per_micro);
    return std::isnan(hours) ? 0.0 : -hours;
  };
  const auto [drop, negative] =
      boost::math::tools::brent_find_minima(shorter, per_micro * low, per_micro * high, digits);
  take(drop / per_micro, -negative);
}

}  // namespace

bool LivesOfCrowns::is_shorter() const {
  return recommended < (1.0 - kShorter) * of_case;
}

bool LivesInRun::is_shorter() const {
  return run.is_shorter() || at_study_tilt.is_shorter();
}

void put_lives_in_run(const ResolvedCase& given, const std::string& set, int jobs, CrownStudy& study) {
  const CrownDesign& design = study.recommended.design;
  const ResolvedCase point = given.without_sweep();
  const WithRollers rollers(point, design, set, jobs);
  const WorstBearing here = life_of_run(point, jobs);
  LivesInRun lives{.key = here.key};
  lives.run = {.of_case = here.value,
               .recommended = rollers.hours(design.crown.drop),
               .longest_profile = design.profile};
  put_longest(rollers, study.request.drops, lives.run);
  const CrownDesign& longest = study.searches[study.best].best;
  lives.at_study_tilt = {.of_case = study.case_hours,
                         .recommended = design.life_hours,
                         .longest = longest.life_hours,
                         .longest_drop = longest.crown.drop > kNoDrop ? longest.crown.drop : 0.0,
                         .longest_profile = longest.profile};
  study.in_run = std::move(lives);
}

std::string status_of_recommended(const CrownStudy& study) {
  if (!study.in_run || !study.in_run->is_shorter()) return "ok";
  const auto& [key, run, tilted] = *study.in_run;
  std::string text;
  const auto add = [&](std::string_view life, const char* where, const LivesOfCrowns& lives) {
    if (!lives.is_shorter()) return;
    text += fmt::format(
        "{}shortens {} {} from {:.6g} to {:.6g} h; the longest is {:.6g} h at a drop of {:.3g} um",
        text.empty() ? "" : ", and ", life, where, lives.of_case, lives.recommended, lives.longest,
        per_micro * lives.longest_drop);
  };
  add(key, "of run", run);
  add(bearing::rating::hours_key(study.life), "at the tilts of this study", tilted);
  return text;
}

std::string warning_of_recommended(const CrownStudy& study) {
  const std::string status = status_of_recommended(study);
  if (status == "ok") return "";
  return fmt::format("recommended: a drop of {:.3g} um {}", per_micro * study.recommended.design.crown.drop,
                     status);
}

// A spectrum uses the speeds of a sweep and no other swept values.
std::vector<std::string> require_crown_uses(const ResolvedCase& resolved, const CrownChoices& choices) {
  const bool spectrum = choices.spectrum || !choices.shares.empty();
  return require_used(resolved, AnalysisId::crown, spectrum ? Axes::speed : Axes::none);
}

std::vector<std::string> crown_warnings(const ResolvedCase& resolved, const CrownChoices& choices,
                                        const std::vector<std::string>& noted, const CrownStudy& study) {
  std::vector<std::string> warnings =
      joined(study.warnings, noted, gear_warnings(resolved), slope_warnings(resolved),
             overturning_warnings(resolved.without_sweep()),
             analysis::clearance_warnings(stated_sets(resolved)), require_crown_uses(resolved, choices));
  if (const std::string warning = warning_of_recommended(study); !warning.empty())
    warnings.insert(warnings.begin(), warning);
  return warnings;
}

std::string text_in_run(const CrownStudy& study) {
  if (!study.in_run) return "";
  const auto& [key, run, tilted] = *study.in_run;
  const auto line = [](const std::string& begin, const LivesOfCrowns& lives) {
    return fmt::format(
        "{} {:.6g} h for the case, {:.6g} h with the recommended profile, longest {:.6g} h at {:.3g} um\n",
        begin, lives.of_case, lives.recommended, lives.longest, per_micro * lives.longest_drop);
  };
  return "\n" +
         line("at the tilts of this study: " + std::string(bearing::rating::hours_key(study.life)), tilted) +
         line("run gives " + key, run);
}

}  // namespace orbearing::app
