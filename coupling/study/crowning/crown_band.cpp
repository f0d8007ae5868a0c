#include "coupling/study/crowning/crown_band.hpp"

#include <algorithm>

#include "coupling/study/parallel.hpp"

namespace orbearing::study::crowning {

namespace {

using bearing::profile::Profile;

constexpr int kHalvings = 10;

std::vector<double> lives_over_tilts(const CrownProblem& problem, const Profile& profile,
                                     const std::vector<double>& tilts, int jobs) {
  std::vector<double> lives(tilts.size());
  in_parallel(tilts.size(), jobs, [&](std::size_t i) { lives[i] = life_hours(problem, profile, tilts[i]); });
  return lives;
}

// The drop nearest to `bad`, at which too little life is left, that still leaves enough. `good` leaves
// enough.
template <class Enough>
double end_of_band(double good, double bad, const Enough& enough) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (enough(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

DropBand drop_band(const CrownProblem& problem, const ProfileFamily& family, const Crown& best,
                   const std::vector<double>& tilts, double greatest, int jobs) {
  const auto shortest = [&](double drop) {
    const std::vector<double> lives =
        lives_over_tilts(problem, profile_of(family, {drop, best.share}), tilts, jobs);
    return *std::min_element(lives.begin(), lives.end());
  };
  const double required = kKeptLife * shortest(best.drop);
  const auto enough = [&](double drop) { return shortest(drop) >= required; };
  DropBand band;
  if (!enough(0.0)) band.least = end_of_band(best.drop, 0.0, enough);
  band.open = enough(greatest);
  band.most = band.open ? greatest : end_of_band(best.drop, greatest, enough);
  return band;
}

std::vector<DutyRecord> duty_records(const CrownProblem& problem, const RollerPressure& pressure,
                                     const Profile& profile, const std::vector<double>& tilts, int jobs) {
  const std::vector<double> lives = lives_over_tilts(problem, profile, tilts, jobs);
  const auto worst = std::min_element(lives.begin(), lives.end());
  const double tilt = tilts[static_cast<std::size_t>(worst - lives.begin())];
  std::vector<DutyRecord> records(problem.duties.size());
  in_parallel(records.size(), jobs, [&](std::size_t duty) {
    const bearing::laminae::LaminaResult loads = loads_at(problem, profile, tilt, duty);
    const double hours = duty_hours(problem, loads, duty);
    records[duty] = {tilt, hours, problem.duties[duty].share * *worst / hours,
                     peak_pressure(one_duty(problem, duty), pressure, profile, {loads})};
  });
  return records;
}

}  // namespace orbearing::study::crowning
