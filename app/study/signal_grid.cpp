#include "app/study/signal_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "app/errors.hpp"
#include "app/study/defect_output.hpp"
#include "app/units.hpp"

namespace orbearing::app {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// What stands between commas that no inner brackets hold.
std::vector<std::string> entries_of(const std::string& list) {
  std::vector<std::string> entries(1);
  int depth = 0;
  for (const char sign : list) {
    depth += (sign == '[') - (sign == ']');
    if (sign == ',' && depth == 0)
      entries.emplace_back();
    else
      entries.back() += sign;
  }
  for (std::string& entry : entries) entry = trimmed(entry);
  return entries;
}

bool felt_by_scratches_alone(const std::string& path) {
  return path.starts_with("defect.") && path != "defect.race";
}

}  // namespace

std::vector<SignalAxis> signal_axes(const std::vector<std::string>& options, const ResolvedCase& resolved) {
  std::vector<SignalAxis> axes;
  for (const std::string& option : options) {
    const std::size_t equals = option.find('=');
    const std::string path = trimmed(option.substr(0, equals));
    const std::string list = equals == std::string::npos ? "" : trimmed(option.substr(equals + 1));
    if (path.empty() || list.size() < 2 || list.front() != '[' || list.back() != ']')
      throw BadInput(
          fmt::format("--vary: found '{}'; required: path=[value, value], e.g. --vary "
                      "\"operation.shaft_speed=[1000 rpm, 1500 rpm]\"",
                      option));
    if (std::any_of(axes.begin(), axes.end(), [&](const SignalAxis& axis) { return axis.path == path; }))
      throw BadInput(fmt::format("--vary: found {} twice; required: all values of a path in one list", path));
    axes.push_back({path, entries_of(list.substr(1, list.size() - 2))});
    for (const std::string& value : axes.back().values)
      if (value.empty()) throw BadInput("--vary: found '" + option + "'; required: a value between commas");
  }
  if (axes.empty())
    axes.push_back(
        {"defect.race",
         {"none", "outer", "inner", resolved.model() == described::roller_defect ? "roller" : "ball"}});
  return axes;
}

std::vector<SignalVariant> signal_variants(const ResolvedCase& resolved,
                                           const std::vector<SignalAxis>& axes) {
  std::size_t count = 1;
  for (const SignalAxis& axis : axes) count *= axis.values.size();
  std::vector<SignalVariant> variants;
  for (std::size_t number = 0; number < count; ++number) {
    std::vector<Setting> settings;
    std::string race = resolved.choice("defect.race");
    bool first_of_defect = true;
    std::size_t rest = number;
    for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
      const std::size_t which = rest % axis->values.size();
      rest /= axis->values.size();
      settings.insert(settings.begin(), Setting{axis->path, axis->values[which]});
      if (axis->path == "defect.race") race = axis->values[which];
      if (felt_by_scratches_alone(axis->path) && which > 0) first_of_defect = false;
    }
    if (race == "none" && !first_of_defect) continue;
    (void)resolved.with(settings);  // refuses what cannot be, before the first is computed
    variants.push_back({std::move(settings)});
  }
  return variants;
}

std::vector<std::string> axes_without_effect(const std::vector<SignalAxis>& axes,
                                             const std::vector<SignalVariant>& variants,
                                             const std::vector<nlohmann::ordered_json>& labels) {
  std::vector<std::string> warnings;
  for (const SignalAxis& axis : axes) {
    std::map<std::vector<Setting>, std::size_t> first;  // by what they have in common
    std::size_t compared = 0, unlike = 0;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      std::vector<Setting> others = variants[i].settings;
      std::erase_if(others, [&](const Setting& setting) { return setting.path == axis.path; });
      const auto [found, is_first] = first.try_emplace(std::move(others), i);
      if (is_first) continue;
      ++compared;
      const nlohmann::ordered_json& other = labels[found->second];
      for (const char* level : {"rms_m_s2", "max_m_s2"})
        if (labels[i].at(level) != other.at(level)) {
          ++unlike;
          break;
        }
    }
    if (compared > 0 && unlike == 0)
      warnings.push_back("--vary: " + axis.path + ": no signal differs by it, only their labels");
  }
  return warnings;
}

void add_noise(const SignalNoise& noise, std::size_t number, study::RingVibration& vibration) {
  if (!(noise.rms > 0.0)) return;
  std::seed_seq seed{noise.seed, static_cast<std::uint64_t>(number)};
  std::mt19937_64 chance(seed);
  std::normal_distribution<double> normal(0.0, noise.rms);
  for (double& value : vibration.acceleration.reshaped()) value += normal(chance);
}

void describe_labels(described::Record& record, const ResolvedCase& in, const DefectStudy& study,
                     const SignalNoise& noise) {
  namespace dimension = described::dimension;
  const auto of_scratch = [&](const char* path) {
    return study.scratched != bearing::defect::Scratched::none ? in.quantity(path) : described::kAbsent;
  };
  const auto frequency = [&](const char* name, const char* meaning, const std::optional<double>& value) {
    record.value(name, dimension::cycles, meaning, value);
  };
  const Eigen::ArrayXd signal = study.vibration.acceleration.row(0).transpose();
  // Means of a run-up; orders keep.
  const double slower_by = study.turned.shaft / study.passing.shaft;
  const double met = study.defect_frequency.value_or(described::kAbsent);
  record.value("defect", "race or element with the scratch", in.choice("defect.race"));
  record.value("width_mm", dimension::length, "of the scratch along the race", of_scratch("defect.width"));
  record.value("depth_mm", dimension::length, "of the scratch", of_scratch("defect.depth"));
  frequency("shaft_Hz", "of the shaft, mean of a run-up", study.turned.shaft);
  record.value("run_up_from", dimension::ratio, "speed at which a run-up begins, over that of its end",
               in.number("signal.run_up_from"));
  record.value("load_N", dimension::force, "radial", in.quantity("load.radial"));
  frequency("cage_Hz", "of the cage", study.turned.cage);
  frequency("outer_pass_Hz", "elements over the outer race", study.turned.outer_pass);
  frequency("inner_pass_Hz", "elements over the inner race", study.turned.inner_pass);
  frequency(study.rollers ? "roller_pass_Hz" : "ball_pass_Hz", "a place of an element over either race",
            study.turned.element_pass);
  frequency("defect_Hz", "how often a scratch is met", slower_by * met);
  record.value("defect_order", dimension::ratio, "the same in a turn of the shaft",
               met / study.passing.shaft);
  frequency("sampling_rate_Hz", "samples a second", study.vibration.rate);
  record.value("samples", "of the signal", signal.size());
  record.value("rms_m_s2", dimension::acceleration, "root mean square of the outer ring along the load",
               root_mean_square(signal));
  record.value("max_m_s2", dimension::acceleration, "largest magnitude", signal.abs().maxCoeff());
  record.value("noise_m_s2", dimension::acceleration, "root mean square of the instrument's noise",
               noise.rms);
}

std::string labels_csv(const std::vector<nlohmann::ordered_json>& labels) {
  std::string text;
  const auto field = [](const nlohmann::ordered_json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_null() ? std::string() : value.dump();
  };
  for (const nlohmann::ordered_json& row : labels) {
    if (text.empty())
      for (const auto& [name, value] : row.items()) text += (text.empty() ? "" : ",") + name;
    std::string line;
    for (const auto& [name, value] : row.items()) line += (line.empty() ? "\n" : ",") + field(value);
    text += line;
  }
  return text + "\n";
}

}  // namespace orbearing::app
