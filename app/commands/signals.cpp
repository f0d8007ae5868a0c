#include "app/commands/signals.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>

#include "app/case/input_keys.hpp"
#include "app/case/mistake.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/text_parts.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/scratch_case.hpp"
#include "app/study/sweep_study.hpp"
#include "coupling/analysis/parallel.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostSignals = 100000;

// A path of the case and the texts of its values.
struct SignalAxis {
  std::string path;
  std::vector<std::string> values;
};

// One signal of the grid, by what it differs in from the case.
using SignalVariant = std::vector<Setting>;

// Noise of the instrument, added to the acceleration along the load and across it.
struct SignalNoise {
  double rms = 0.0;        // [m/s^2]
  std::uint64_t seed = 1;  // of the first signal; each has its own
};

// Texts between commas that are outside inner brackets.
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

bool used_by_scratches_alone(const std::string& path) {
  return path.starts_with("defect.") && path != keys().scratched;
}

// From options such as "operation.shaft_speed=[1000 rpm, 1500 rpm]"; without any, all that can be scratched
// in that case. Throws BadInput for a text that is no path and list.
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
    axes.push_back({keys().scratched,
                    {"none", "outer", "inner", resolved.model() == roller_defect ? "roller" : "ball"}});
  return axes;
}

// All combinations, the last axis fastest. Inputs that affect only a scratch do not vary without one: a sound
// bearing is in the grid once. Throws BadInput where the case cannot be changed so.
std::vector<SignalVariant> signal_variants(const ResolvedCase& resolved,
                                           const std::vector<SignalAxis>& axes) {
  std::size_t count = 1;
  for (const SignalAxis& axis : axes) {
    count *= axis.values.size();
    if (count > kMostSignals)
      throw BadInput(
          fmt::format("--vary: found more than {} combinations; required: at most as many", kMostSignals));
  }
  std::vector<SignalVariant> variants;
  std::vector<std::pair<std::string, std::string>> names;
  for (const SignalAxis& axis : axes) names.emplace_back("--set: " + axis.path, "--vary: " + axis.path);
  for (std::size_t number = 0; number < count; ++number) {
    std::vector<Setting> settings;
    std::string race = resolved.choice(keys().scratched);
    bool first_of_defect = true;
    std::size_t rest = number;
    for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
      const std::size_t which = rest % axis->values.size();
      rest /= axis->values.size();
      settings.insert(settings.begin(), Setting{axis->path, axis->values[which]});
      if (axis->path == keys().scratched) race = axis->values[which];
      if (used_by_scratches_alone(axis->path) && which > 0) first_of_defect = false;
    }
    if (race == "none" && !first_of_defect) continue;
    // Refuses what cannot be, before the first is computed.
    (void)named_by_option(names, [&] { return resolved.with(settings); });
    variants.push_back(std::move(settings));
  }
  return variants;
}

void require_effect_of(const std::vector<SignalAxis>& axes, const std::vector<SignalVariant>& variants,
                       const ResolvedCase& resolved, AnalysisId analysis) {
  std::vector<std::string> paths;
  for (const SignalAxis& axis : axes) paths.push_back(axis.path);
  std::vector<ResolvedCase> points;
  for (const SignalVariant& variant : variants) points.push_back(resolved.with(variant));
  require_effect(points, analysis, paths);
}

// Warns of each axis along which no signal differs, though its labels do. Signals with noise differ always.
std::vector<std::string> axes_without_effect(const std::vector<SignalAxis>& axes,
                                             const std::vector<SignalVariant>& variants,
                                             const std::vector<Json>& labels) {
  std::vector<std::string> warnings;
  for (const SignalAxis& axis : axes) {
    std::map<std::vector<Setting>, std::size_t> first;  // by what they have in common
    std::size_t compared = 0, unlike = 0;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      std::vector<Setting> others = variants[i];
      std::erase_if(others, [&](const Setting& setting) { return setting.path == axis.path; });
      const auto [found, is_first] = first.try_emplace(std::move(others), i);
      if (is_first) continue;
      ++compared;
      const Json& other = labels[found->second];
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

// Adds noise of the `number`-th signal. The same for a seed and number, whatever the order of signals.
void add_noise(const SignalNoise& noise, std::size_t number, analysis::RingVibration& vibration) {
  if (!(noise.rms > 0.0)) return;
  std::seed_seq seed{noise.seed, static_cast<std::uint64_t>(number)};
  std::mt19937_64 chance(seed);
  std::normal_distribution<double> normal(0.0, noise.rms);
  for (double& value : vibration.acceleration.reshaped()) value += normal(chance);
}

// Labels for the training of a diagnosis: scratched part, speed, load, size, frequencies, level.
void describe_labels(described::Record& record, const ResolvedCase& in,
                     const analysis::ScratchedVibration& study, const SignalNoise& noise) {
  namespace dimension = described::dimension;
  const auto of_scratch = [&](const std::string& path) {
    return study.scratched != bearing::defect::Scratched::none ? in.quantity(path) : described::kAbsent;
  };
  const auto frequency = [&](const char* name, const char* meaning, const std::optional<double>& value) {
    record.value(name, dimension::cycles, meaning, value);
  };
  const Eigen::ArrayXd signal = study.vibration.acceleration.row(0).transpose();
  // Means of a run-up; orders keep.
  const double slower_by = study.turned.shaft / study.passing.shaft;
  const double met = study.defect_frequency.value_or(described::kAbsent);
  record.value("defect", "race or element with the scratch", in.choice(keys().scratched));
  record.value("width_mm", dimension::length, "of the scratch along the race",
               of_scratch(keys().scratch_width));
  record.value("depth_mm", dimension::length, "of the scratch", of_scratch(keys().scratch_depth));
  frequency("shaft_Hz", "of the shaft, mean of a run-up", study.turned.shaft);
  record.value("run_up_from", dimension::ratio, "speed at which a run-up begins, over that of its end",
               in.number("signal.run_up_from"));
  record.value("load_N", dimension::force, "radial", in.quantity("load.radial"));
  frequency("cage_Hz", "of the cage", study.turned.cage);
  frequency("outer_pass_Hz", "elements over the outer race", study.turned.outer_pass);
  frequency("inner_pass_Hz", "elements over the inner race", study.turned.inner_pass);
  frequency(study.rollers ? "roller_pass_Hz" : "ball_pass_Hz", "a point of an element over either race",
            study.turned.element_pass);
  frequency("defect_Hz", "frequency of contacts with a scratch", slower_by * met);
  record.value("defect_order", dimension::ratio, "the same in a turn of the shaft",
               met / study.passing.shaft);
  frequency("sampling_rate_Hz", "samples a second", study.vibration.rate);
  record.value("samples", "of the signal", signal.size());
  record.value("rms_m_s2", dimension::acceleration, "root mean square of the outer ring along the load",
               analysis::root_mean_square(signal));
  record.value("max_m_s2", dimension::acceleration, "largest magnitude", signal.abs().maxCoeff());
  record.value("noise_m_s2", dimension::acceleration, "root mean square of the instrument's noise",
               noise.rms);
}

// Labels as rows of text, their names first.
std::string labels_csv(const std::vector<Json>& labels) {
  std::string text;
  const auto field = [](const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_null() ? std::string() : value.dump();
  };
  for (const Json& row : labels) {
    if (text.empty())
      for (const auto& [name, value] : row.items()) text += (text.empty() ? "" : ",") + name;
    std::string line;
    for (const auto& [name, value] : row.items()) line += (line.empty() ? "\n" : ",") + field(value);
    text += line;
  }
  return text + "\n";
}

std::filesystem::path signal_file(const ResultFolder& folder, std::size_t number, const char* ending) {
  return folder.path() / "signals" / fmt::format("{:05}{}", number, ending);
}

// The variations and the noise determine the signals as much as the case does.
std::string grid_text(const SignalsOptions& options, const std::vector<SignalAxis>& axes) {
  std::string text = "signals";
  if (options.fidelity == "dynamic") text += ", all in motion";
  for (const SignalAxis& axis : axes)
    text += fmt::format("; {}=[{}]", axis.path, fmt::join(axis.values, ", "));
  if (options.noise > 0.0) text += fmt::format("; noise {} m/s2, seed {}", options.noise, options.seed);
  return text;
}

void describe_signal(Record& labels, std::size_t number, const std::string& file,
                     const std::vector<Setting>& varied) {
  labels.value("signal", "number", number);
  if (!file.empty()) labels.value("file", "of the signal", file);
  for (const Setting& setting : varied)
    if (setting.path != keys().scratched) labels.value(setting.path, "varied", setting.text);
}

// Labels as they are described, whether computed now or earlier.
Record form_of_labels(const ResolvedCase& resolved) {
  analysis::ScratchedVibration study{.rollers = resolved.model() == roller_defect};
  study.vibration.acceleration = Eigen::Array2Xd::Zero(2, 1);
  Record record;
  record.table("signals", "signal", "with what they are labelled", std::array{study},
               [&](Record& row, const analysis::ScratchedVibration& of) {
                 describe_signal(row, 0, "signals/00000.csv", {});
                 describe_labels(row, resolved, of, {});
               });
  return record;
}

class SignalSet {
 public:
  SignalSet(const ResolvedCase& resolved, const SignalsOptions& options, const ManifestHeader& header,
            ResultFolder& folder, std::vector<SignalVariant> variants)
      : resolved_(resolved),
        options_(options),
        header_(header),
        folder_(folder),
        variants_(std::move(variants)),
        labels_(variants_.size()) {}

  // Those of an earlier run are read back.
  void compute() {
    std::vector<std::size_t> missing;
    for (std::size_t number = 0; number < variants_.size(); ++number)
      if (folder_.finished().contains(number))
        labels_[number] = Json::parse(std::ifstream(signal_file(folder_, number, ".json")));
      else
        missing.push_back(number);
    if (!folder_.path().empty()) std::filesystem::create_directories(folder_.path() / "signals");
    Progress progress(variants_.size() - missing.size(), variants_.size(), !options_.print.quiet,
                      "signals: ");
    std::size_t done = variants_.size() - missing.size();
    std::mutex one_writer;
    const auto one = [&](std::size_t location) {
      const std::size_t number = missing[location];
      const ResolvedCase changed = resolved_.with(variants_[number]);
      const SignalNoise noise{options_.noise, options_.seed};
      const analysis::ScratchedVibration study = scratched_vibration(
          changed, moving_parts(),
          [&](analysis::RingVibration& vibration) { add_noise(noise, number, vibration); });
      const std::scoped_lock lock(one_writer);
      labels_[number] = labelled(number, changed, study, noise);
      if (!folder_.path().empty()) keep(number, study);
      progress.show(++done);
    };
    try {
      analysis::in_parallel(missing.size(), options_.jobs, one);
    } catch (const Cancelled&) {
      throw Interrupted(fmt::format(
          "signals: interrupted with {} of {} signals done; {}", done, variants_.size(),
          folder_.path().empty() ? "nothing of it is kept without --output" : "continue with --resume"));
    }
  }

  const std::vector<Json>& labels() const { return labels_; }

 private:
  MovingParts moving_parts() const {
    return options_.fidelity == "dynamic" ? MovingParts::all : MovingParts::ring;
  }

  Json labelled(std::size_t number, const ResolvedCase& changed, const analysis::ScratchedVibration& study,
                const SignalNoise& noise) const {
    Record labels;
    describe_signal(labels, number, folder_.path().empty() ? "" : fmt::format("signals/{:05}.csv", number),
                    variants_[number]);
    describe_labels(labels, changed, study, noise);
    return json_of(labels);
  }

  void keep(std::size_t number, const analysis::ScratchedVibration& study) {
    const auto contents = study.files();
    const std::string labels = labels_[number].dump(2) + "\n";
    std::vector<FileContent> files;
    for (const auto& [name, content] : contents)
      files.push_back(
          {signal_file(folder_, number, std::filesystem::path(name).extension().c_str()), content});
    files.push_back({signal_file(folder_, number, ".json"), labels});
    write_aside_and_rename(files);
    AnalysisResult result{.record = record_of(study)};
    put_largest_load(study.largest_load(), result);
    folder_.keep({{number, result_file(header_, analysis_of(resolved_)->names.title, result.record),
                   row_of_numbers(result.row, header_)}});
  }

  const ResolvedCase& resolved_;
  const SignalsOptions& options_;
  const ManifestHeader& header_;
  ResultFolder& folder_;
  std::vector<SignalVariant> variants_;
  std::vector<Json> labels_;
};

void print_labels(const std::vector<Json>& labels) {
  fmt::print("{:>6} {:>8} {:>10} {:>10} {:>12} {:>12}\n", "signal", "defect", "shaft [Hz]", "defect [Hz]",
             "rms [m/s2]", "max [m/s2]");
  for (const Json& one : labels)
    fmt::print("{:>6} {:>8} {:>10.4g} {:>11} {:>12.4g} {:>12.4g}\n", one["signal"].get<std::size_t>(),
               one["defect"].get<std::string>(), one["shaft_Hz"].get<double>(),
               one["defect_Hz"].is_null() ? "none" : fmt::format("{:.5g}", one["defect_Hz"].get<double>()),
               one["rms_m_s2"].get<double>(), one["max_m_s2"].get<double>());
}

}  // namespace

std::vector<std::string> problems(const SignalsOptions& options) {
  constexpr double most = 1e9;  // [m/s^2]
  std::vector<std::string> found = problems(ResultPlace{options.output, options.resume}, options.print);
  if (!(options.noise >= 0.0 && options.noise <= most))
    found.push_back(fmt::format("--noise: found {}; required: 0 to 1e9 m/s2", options.noise));
  if (options.noise == 0.0 && options.seed != SignalsOptions{}.seed)
    found.push_back(
        fmt::format("--seed: found {} without noise; required: --noise, whose random numbers it determines",
                    options.seed));
  return found;
}

int execute(const SignalsOptions& options) {
  const ResolvedCase resolved = point_of(options.stated);
  if (!is_defect(resolved))
    throw BadInput(fmt::format("signals: found a case of the model {}; required: raceway-defect",
                               resolved.choice("model")));
  std::vector<std::string> warnings = require_used(resolved, analysis_of(resolved, options.fidelity)->used);
  const std::vector<SignalAxis> axes = signal_axes(options.varied, resolved);
  std::vector<SignalVariant> variants = signal_variants(resolved, axes);
  require_effect_of(axes, variants, resolved, analysis_of(resolved, options.fidelity)->used);
  const ManifestHeader header = manifest_header(resolved, grid_text(options, axes), variants.size());
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.print.quiet);
  const std::vector<SignalVariant> compared = variants;
  SignalSet set(resolved, options, header, folder, std::move(variants));
  set.compute();
  for (std::string& text : axes_without_effect(axes, compared, set.labels()))
    warnings.push_back(std::move(text));
  if (!folder.path().empty()) write_aside_and_rename(folder.path() / "labels.csv", labels_csv(set.labels()));
  if (options.print.json) {
    Json object{{"case", resolved.text("name")},
                {"signals", set.labels()},
                {"assumptions", assumptions_json(resolved)},
                {"warnings", warnings},
                {"versions", versions_json()}};
    print_result(std::move(object), form_of_labels(resolved), options.print);
  } else if (!options.print.quiet) {
    print_labels(set.labels());
    print_warnings(warnings);
  }
  return 0;
}

}  // namespace orbearing::app
