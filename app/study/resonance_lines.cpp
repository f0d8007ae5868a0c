#include "app/study/resonance_lines.hpp"

#include <algorithm>
#include <memory>

#include "app/study/fidelity.hpp"
#include "app/study/life_peak.hpp"

namespace orbearing::app {

namespace {

std::vector<Setting> other_settings(std::vector<Setting> settings) {
  std::erase_if(settings, [](const Setting& setting) { return setting.path == kSpeedPath; });
  return settings;
}

}  // namespace

std::vector<double> speeds_rpm(const ResolvedCase& resolved) {
  std::vector<double> speeds;
  for (const double speed : swept_speeds(resolved)) speeds.push_back(speed_in_rpm(speed));
  return speeds;
}

LinesOfResonances::LinesOfResonances(const ResolvedCase& resolved) : resolved_(resolved.without_sweep()) {
  const std::vector<double> speeds = speeds_rpm(resolved);
  const auto [low, high] = std::minmax_element(speeds.begin(), speeds.end());
  lowest_ = *low;
  highest_ = *high;
}

const std::vector<Resonance>& LinesOfResonances::of(const std::vector<Setting>& settings) {
  const std::vector<Setting> line = other_settings(settings);
  const auto [position, is_new] = lines_.try_emplace(line);
  if (is_new) position->second = computed(line);
  return position->second;
}

// A line on which the gears cannot be computed has points that say why.
std::vector<Resonance> LinesOfResonances::computed(const std::vector<Setting>& line) const try {
  return resonances(line.empty() ? resolved_ : resolved_.with(line), lowest_, highest_);
} catch (const std::exception&) {
  return {};
}

void name_resonances(const ResolvedCase& resolved, SweepRequest& request) {
  if (!in_time(fidelity_of(request.header.fidelity)) || !has_resonances(resolved)) return;
  request.header.resonances = true;
  request.resonance_of = [lines = std::make_shared<LinesOfResonances>(resolved)](const SweepPoint& point) {
    return nearest(lines->of(point.settings), point.input_speed);
  };
}

}  // namespace orbearing::app
