#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>

#include "app/case/resolved_writer.hpp"
#include "app/case/unused_inputs.hpp"
#include "app/commands/kept_result.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/results/progress.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/defect_output.hpp"
#include "app/study/signal_grid.hpp"
#include "app/study/sweep_study.hpp"
#include "coupling/study/parallel.hpp"
#include "mechanics/cancellation.hpp"

namespace orbearing::app {

namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path signal_file(const ResultFolder& folder, std::size_t number, const char* ending) {
  return folder.path() / "signals" / fmt::format("{:05}{}", number, ending);
}

// What varies and the noise decide the signals as much as the case does.
std::string grid_text(const Options& options, const std::vector<SignalAxis>& axes) {
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
    if (setting.path != "defect.race") labels.value(setting.path, "varied", setting.text);
}

// Labels as they are described, whether computed now or earlier.
Record form_of_labels(const ResolvedCase& resolved) {
  DefectStudy study{.rollers = resolved.model() == described::roller_defect};
  study.vibration.acceleration = Eigen::Array2Xd::Zero(2, 1);
  Record record;
  record.table("signals", "signal", "with what they are labelled", std::array{study},
               [&](Record& row, const DefectStudy& of) {
                 describe_signal(row, 0, "signals/00000.csv", {});
                 describe_labels(row, resolved, of, {});
               });
  return record;
}

class SignalSet {
 public:
  SignalSet(const ResolvedCase& resolved, const Options& options, const ManifestHeader& header,
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
    Progress progress(variants_.size() - missing.size(), variants_.size(), !options_.quiet, "signals: ");
    std::size_t done = variants_.size() - missing.size();
    std::mutex one_writer;
    const auto one = [&](std::size_t location) {
      const std::size_t number = missing[location];
      const ResolvedCase changed = resolved_.with(variants_[number].settings);
      const SignalNoise noise{options_.noise, options_.seed};
      const DefectStudy study = defect_study(
          changed, rung(), {}, [&](study::RingVibration& vibration) { add_noise(noise, number, vibration); });
      const std::scoped_lock lock(one_writer);
      labels_[number] = labelled(number, changed, study, noise);
      if (!folder_.path().empty()) keep(number, study);
      progress.show(++done);
    };
    try {
      study::in_parallel(missing.size(), options_.jobs, one);
    } catch (const Cancelled&) {
      throw Interrupted(fmt::format(
          "signals: interrupted with {} of {} signals done; {}", done, variants_.size(),
          folder_.path().empty() ? "nothing of it is kept without --output" : "go on with --resume"));
    }
  }

  const std::vector<Json>& labels() const { return labels_; }

 private:
  DefectRung rung() const { return options_.fidelity == "dynamic" ? DefectRung::all : DefectRung::ring; }

  Json labelled(std::size_t number, const ResolvedCase& changed, const DefectStudy& study,
                const SignalNoise& noise) const {
    Record labels;
    describe_signal(labels, number, folder_.path().empty() ? "" : fmt::format("signals/{:05}.csv", number),
                    variants_[number].settings);
    describe_labels(labels, changed, study, noise);
    return json_of(labels);
  }

  void keep(std::size_t number, const DefectStudy& study) {
    write_aside_and_rename({{signal_file(folder_, number, ".csv"), signal_csv(study)},
                            {signal_file(folder_, number, ".wav"), signal_wav(study)},
                            {signal_file(folder_, number, ".json"), labels_[number].dump(2) + "\n"}});
    const AnalysisResult result = defect_result(study, false);
    folder_.keep({{number, result_file(header_, analysis_of(resolved_)->title, result.record),
                   row_of_values(folder_.head(), result.row)}});
  }

  const ResolvedCase& resolved_;
  const Options& options_;
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

void require_noise(const Options& options) {
  constexpr double most = 1e9;  // [m/s^2]
  if (!(options.noise >= 0.0 && options.noise <= most))
    throw BadInput(fmt::format("--noise: found {}; required: 0 to 1e9 m/s2", options.noise));
  if (options.noise == 0.0 && options.seed != Options{}.seed)
    throw BadInput(fmt::format(
        "--seed: found {} without noise; required: --noise beside it, whose random numbers it decides",
        options.seed));
}

int signals_command(const Options& options) {
  require_output(options);
  require_noise(options);
  const ResolvedCase resolved = point_of(options);
  if (!is_defect(resolved))
    throw BadInput(fmt::format("signals: found a case of the model {}; required: raceway-defect",
                               resolved.choice("model")));
  std::vector<std::string> warnings = require_used(resolved, analysis_of(resolved, options.fidelity)->used);
  const std::vector<SignalAxis> axes = signal_axes(options.varied, resolved);
  std::vector<SignalVariant> variants = signal_variants(resolved, axes);
  const ManifestHeader header = manifest_header(resolved, grid_text(options, axes), variants.size());
  ResultFolder folder =
      open_results(options.output, header, write_resolved(resolved), options.resume, options.quiet);
  const std::vector<SignalVariant> compared = variants;
  SignalSet set(resolved, options, header, folder, std::move(variants));
  set.compute();
  for (std::string& text : axes_without_effect(axes, compared, set.labels()))
    warnings.push_back(std::move(text));
  if (!folder.path().empty()) write_aside_and_rename(folder.path() / "labels.csv", labels_csv(set.labels()));
  if (options.json) {
    Json object{{"case", resolved.text("name")},
                {"signals", set.labels()},
                {"assumptions", assumptions_json(resolved)},
                {"warnings", warnings},
                {"versions", versions_json()}};
    print_result(std::move(object), form_of_labels(resolved), options);
  } else if (!options.quiet) {
    print_labels(set.labels());
    print_warnings(warnings);
  }
  return 0;
}

}  // namespace orbearing::app
