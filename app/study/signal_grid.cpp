#include "app/study/signal_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "app/errors.hpp"
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

nlohmann::ordered_json signal_labels(const ResolvedCase& in, const DefectStudy& study,
                                     const SignalNoise& noise) {
  const bool scratched = study.scratched != bearing::defect::Scratched::none;
  const Eigen::ArrayXd signal = study.vibration.acceleration.row(0).transpose();
  const auto of_scratch = [&](const char* path) {
    return scratched ? nlohmann::ordered_json(1e3 * in.quantity(path)) : nlohmann::ordered_json(nullptr);
  };
  // Means of a run-up; orders keep.
  const double slower_by = study.turned.shaft / study.passing.shaft;
  const auto of_defect = [&](double factor) {
    return study.defect_frequency ? nlohmann::ordered_json(factor * *study.defect_frequency)
                                  : nlohmann::ordered_json(nullptr);
  };
  return {{"defect", in.choice("defect.race")},
          {"width_mm", of_scratch("defect.width")},
          {"depth_mm", of_scratch("defect.depth")},
          {"shaft_Hz", study.turned.shaft},
          {"run_up_from", in.number("signal.run_up_from")},
          {"load_N", in.quantity("load.radial")},
          {"cage_Hz", study.turned.cage},
          {"outer_pass_Hz", study.turned.outer_pass},
          {"inner_pass_Hz", study.turned.inner_pass},
          {study.rollers ? "roller_pass_Hz" : "ball_pass_Hz", study.turned.element_pass},
          {"defect_Hz", of_defect(slower_by)},
          {"defect_order", of_defect(1.0 / study.passing.shaft)},
          {"sampling_rate_Hz", study.vibration.rate},
          {"samples", signal.size()},
          {"rms_m_s2", std::sqrt((signal - signal.mean()).square().mean())},
          {"max_m_s2", signal.abs().maxCoeff()},
          {"noise_m_s2", noise.rms}};
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
