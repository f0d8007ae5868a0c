// Models of FMUs and their unpacked resources, for tests through the C interface.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "coupling/fmu/fmi2.hpp"
#include "coupling/fmu/model.hpp"
#include "coupling/fmu/model_file.hpp"
#include "tests/gear_sets.hpp"
#include "tests/messages.hpp"
#include "tests/unit/cosim/driven_reducer.hpp"

namespace orbearing::fmu::test {

/// The reducer's bearing pressed by its planet at 6000 rpm of the sun.
inline system::DrivenBearingSetup bearing_model() {
  const bearing::motion::BoreMotion motion = orbearing::test::pressed_motion();
  system::DrivenBearingSetup setup = orbearing::test::driven_reducer();
  setup.planet_speed = motion.speed;
  setup.carrier_speed = motion.carrier_speed;
  return setup;
}

inline system::DrivenGearsSetup gear_model() {
  system::DrivenGearsSetup setup{.set = gearset::dynamics::test::reducer_dynamics(),
                                 .operation = gearset::dynamics::test::reducer_operation(628.0)};
  setup.set.planet.coupled_bearing = true;
  return setup;
}

/// Resources of an unpacked FMU in a folder of their own, with a blank in its name.
class Resources {
 public:
  explicit Resources(NumberTable numbers) : numbers_(std::move(numbers)) {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("fmu resources " + numbers_.model + std::to_string(getpid()) + "_" + std::to_string(next()++));
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / kModelFile) << text_of(numbers_);
    for (const Variable& variable : variables_of(facts_of(numbers_))) names_.push_back(variable.name);
    token_ = token_of(numbers_);
  }
  ~Resources() { std::filesystem::remove_all(folder_); }

  std::string folder() const { return folder_.string(); }
  /// As FMI 2.0 requires it.
  std::string uri() const {
    std::string uri = "file://";
    for (const char c : folder_.string()) uri += c == ' ' ? std::string("%20") : std::string(1, c);
    return uri;
  }
  const std::string& token() const { return token_; }
  const NumberTable& numbers() const { return numbers_; }
  std::uint32_t reference(const std::string& name) const {
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (names_[i] == name) return static_cast<std::uint32_t>(i);
    throw std::out_of_range(name);
  }

 private:
  static int& next() {
    static int number = 0;
    return number;
  }
  NumberTable numbers_;
  std::filesystem::path folder_;
  std::vector<std::string> names_;
  std::string token_;
};

/// Messages that an instance logged.
struct Messages {
  std::vector<std::pair<int, std::string>> list;  // status, text

  std::string last() const { return list.empty() ? "" : list.back().second; }
  static void take(fmi2ComponentEnvironment to, fmi2String, fmi2Status status, fmi2String, fmi2String text,
                   ...) {
    static_cast<Messages*>(to)->list.emplace_back(status, text);
  }
};

/// Outcome of a call: its status and its log, as 'error: fmi2DoStep: ...'. Clears the log.
inline std::string said(Messages& log, int status) {
  constexpr const char* names[] = {"ok", "warning", "discard", "error", "fatal"};
  std::string text = names[status];
  for (const auto& [logged, line] : log.list)
    text += (logged == status ? ": " : ": logged as " + std::to_string(logged) + ": ") + line;
  log.list.clear();
  // How far a run came before it failed is up to its steps.
  const std::string before = "at t = ";
  const std::size_t from = text.find(before), to = text.find(" s of the window");
  if (from != std::string::npos && to != std::string::npos)
    text.replace(from + before.size(), to - from - before.size(), "TIME");
  return text;
}

/// The text with each place of an unpacked FMU as its name.
inline std::string with_names(std::string text, const Resources& resources) {
  const std::pair<std::string, std::string> names[] = {{resources.token(), "TOKEN"},
                                                       {resources.folder(), "FOLDER"}};
  for (const auto& [word, name] : names)
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;)
      text.replace(at, word.size(), name);
  return text;
}

/// One instance of FMI 2.0 with its log.
class Instance2 {
 public:
  explicit Instance2(const Resources& resources, bool logging = false) : resources_(&resources) {
    callbacks_ = {&Messages::take, nullptr, nullptr, nullptr, &messages};
    component = fmi2Instantiate("one", fmi2CoSimulation, resources.token().c_str(), resources.uri().c_str(),
                                &callbacks_, fmi2False, logging ? fmi2True : fmi2False);
  }
  ~Instance2() { fmi2FreeInstance(component); }
  Instance2(const Instance2&) = delete;
  Instance2& operator=(const Instance2&) = delete;

  std::uint32_t reference(const std::string& name) const { return resources_->reference(name); }
  fmi2Status set(const std::string& name, double value) {
    const fmi2ValueReference vr = reference(name);
    return fmi2SetReal(component, &vr, 1, &value);
  }
  double get(const std::string& name) {
    const fmi2ValueReference vr = reference(name);
    double value = std::nan("");
    EXPECT_EQ(fmi2GetReal(component, &vr, 1, &value), fmi2OK) << name << ": " << messages.last();
    return value;
  }
  fmi2Status begin(double start = 0.0) {
    fmi2Status worst = fmi2SetupExperiment(component, fmi2False, 0.0, start, fmi2False, 0.0);
    worst = std::max(worst, fmi2EnterInitializationMode(component));
    return std::max(worst, fmi2ExitInitializationMode(component));
  }
  fmi2Status step(double time, double size) { return fmi2DoStep(component, time, size, fmi2True); }

  Messages messages;
  fmi2Component component = nullptr;

 private:
  const Resources* resources_;
  fmi2CallbackFunctions callbacks_{};
};

inline std::string said(Instance2& it, fmi2Status status) {
  return said(it.messages, status);
}

/// Displacement that presses the reducer's bearing.
inline void press(Instance2& instance) {
  instance.set("planet.displacement.x", 2e-6);
  instance.set("planet.displacement.y", 25e-6);
}

inline constexpr double kStep = 1e-5;  // [s]

/// Some outputs of a bearing.
inline std::vector<double> forces(Instance2& instance) {
  return {instance.get("force.x"), instance.get("force.y"), instance.get("moment"), instance.get("life_used"),
          instance.get("roller[3].inner_load")};
}

/// Steps from `first` to before `last`.
inline void run(Instance2& instance, int first, int last) {
  for (int i = first; i < last; ++i) {
    ASSERT_EQ(instance.step(i * kStep, kStep), fmi2OK) << instance.messages.last();
  }
}

}  // namespace orbearing::fmu::test
