#include "coupling/fmu/import/foreign_participant.hpp"

#include <cmath>
#include <sstream>

#include "coupling/fmu/import/errors.hpp"
#include "coupling/fmu/import/held_input.hpp"
#include "coupling/fmu/import/state_keeper.hpp"
#include "coupling/fmu/import/unpacked_fmu.hpp"

namespace orbearing::fmu {
namespace {

using cosim::PortInput;
using cosim::PortOutput;
using cosim::SavedState;
using cosim::Window;

#if defined(__linux__) && defined(__x86_64__)
std::filesystem::path binary_of(const ForeignDescription& description) {
  return std::filesystem::path("binaries") / (description.version == 2 ? "linux64" : "x86_64-linux") /
         (description.identifier + ".so");
}
#else
#error "The folder of an FMU's binaries is known for linux on x86_64 only"
#endif

// All that stays while instances come and go.
struct Loaded {
  explicit Loaded(const ForeignSetup& setup) : unpacked{setup.file} {
    for (const std::string& name : setup.host_libraries) {
      host.push_back(std::make_unique<SharedLibrary>(name, SharedLibrary::Symbols::for_all));
    }
    fmu.description = read_description(unpacked.folder() / "modelDescription.xml");
    fmu.resources = unpacked.folder() / "resources";
    std::filesystem::create_directories(fmu.resources);
    const std::filesystem::path binary = binary_of(fmu.description);
    if (!std::filesystem::exists(unpacked.folder() / binary)) {
      throw ForeignFmuError("holds no " + binary.string() + ", the library for this machine");
    }
    library = std::make_unique<SharedLibrary>(unpacked.folder() / binary);
    fmu.library = library.get();
  }

  UnpackedFmu unpacked;
  std::vector<std::unique_ptr<SharedLibrary>> host;
  std::unique_ptr<SharedLibrary> library;
  LoadedFmu fmu;
};

class ForeignParticipant final : public cosim::Participant {
 public:
  explicit ForeignParticipant(const ForeignSetup& setup)
      : setup_{setup},
        loaded_{setup},
        start_variables_{find_start_values(description(), setup.values)},
        keeper_{description()} {
    if (setup.steps_per_window < 1)
      throw ForeignFmuError("steps_per_window is below 1; required is 1 or more");
    if (setup.slopes < 0 || setup.slopes > 3) throw ForeignFmuError("slopes shall be 0, 1, 2 or 3");
    for (const ForeignPort& port : setup.ports) ports_.push_back(port.port);
    const auto channels = find_channels(description(), setup.ports);
    inputs_ = HeldInputs{ports_, channels, description().interpolates_inputs ? setup.slopes : 0};
    outputs_ = ForeignOutputs{ports_, channels};
  }

  std::string name() const override { return setup_.name.empty() ? description().model_name : setup_.name; }
  const std::vector<cosim::Port>& ports() const override { return ports_; }

  void initialize(double time, const std::vector<PortInput>& inputs) override {
    guarded([&] {
      keeper_.forget();
      lost_ = "it could not be initialized";
      instance_.reset();  // before the next one: some FMUs live but once in a process
      instance_ = description().version == 2 ? instantiate_fmi2(loaded_.fmu, name())
                                             : instantiate_fmi3(loaded_.fmu, name());
      std::size_t i = 0;
      for (const auto& [key, value] : setup_.values) instance_->set_start(*start_variables_[i++], value);
      instance_->enter_initialization(time);
      inputs_.take(inputs);
      inputs_.set(*instance_, 0.0, 0.0);
      instance_->exit_initialization();
      time_ = time;
      step_ = 0.0;
      lost_.clear();
    });
  }

  void set_input(const std::vector<PortInput>& inputs) override {
    guarded([&] {
      require_instance();
      inputs_.take(inputs);
      if (setup_.answers_between_steps) inputs_.set(*instance_, 0.0, 0.0);
    });
  }

  void advance(const Window& window) override {
    guarded([&] {
      require_instance();
      check_window(window);
      const KeptState before = keeper_.current(*instance_);
      try {
        make_steps(window);
      } catch (...) {
        go_back(before);
        throw;
      }
    });
  }

  void output(std::vector<PortOutput>& outputs) const override {
    guarded([&] {
      require_instance();
      outputs_.get(*instance_, outputs);
    });
  }

  bool can_restore() const override { return description().keeps_state; }

  void save(SavedState& state) const override {
    guarded([&] {
      require_instance();
      state.assign({time_, step_});
      keeper_.save(*instance_, state);
    });
  }

  void restore(const SavedState& state) override {
    guarded([&] {
      if (!instance_) throw ForeignFmuError("restore() before initialize()");
      if (state.size() < 2) throw ForeignFmuError("a saved state of too few numbers");
      keeper_.restore(*instance_, state, 2);
      time_ = state[0];
      step_ = state[1];
      lost_.clear();
    });
  }

 private:
  const ForeignDescription& description() const { return loaded_.fmu.description; }

  template <typename Work>
  void guarded(const Work& work) const {
    try {
      work();
    } catch (const ForeignFmuError& error) {
      throw ForeignFmuError(setup_.file.filename().string() + ": " + error.what());
    }
  }

  void require_instance() const {
    if (!instance_) throw ForeignFmuError("is not initialized yet");
    if (!lost_.empty()) throw ForeignFmuError("cannot go on after an error: " + lost_);
  }

  void check_window(const Window& window) const {
    constexpr double round_off = 1e-9;  // of times that are products of a number and a step
    std::ostringstream text;
    const double length = window.length();
    if (!(length > 0.0) || !std::isfinite(length) ||
        std::abs(window.begin - time_) > round_off * (length + std::abs(time_))) {
      text << "window from " << window.begin << " s to " << window.end << " s; required is one from " << time_
           << " s, where the FMU stands, to a later time";
      throw ForeignFmuError(text.str());
    }
    const double step = length / setup_.steps_per_window;
    const double unit = description().fixed_step > 0.0 ? description().fixed_step : step_;
    if (description().variable_step || unit == 0.0) return;
    const double count = std::round(step / unit);
    if (count < 1.0 || (description().fixed_step == 0.0 && count != 1.0) ||
        std::abs(step - count * unit) > 1e-6 * unit) {
      text << "step of " << step << " s; the FMU takes steps of " << unit << " s"
           << (description().fixed_step > 0.0 ? " and multiples of it" : " only, as the first one was");
      throw ForeignFmuError(text.str());
    }
  }

  void make_steps(const Window& window) {
    const int count = setup_.steps_per_window;
    const auto since = [&](int k) { return window.length() * k / count; };
    for (int k = 0; k < count; ++k) {
      inputs_.set(*instance_, since(k), since(k + 1));
      const double begin = window.begin + since(k);
      instance_->step(begin, (k + 1 == count ? window.end : window.begin + since(k + 1)) - begin);
    }
    time_ = window.end;
    if (step_ == 0.0) step_ = window.length() / count;
  }

  // To the beginning of the window after a step that failed, where the FMU can.
  void go_back(const KeptState& before) {
    try {
      if (!before.set()) lost_ = "it does not keep states; initialize it anew";
    } catch (const std::exception& error) {
      lost_ = error.what();
    }
  }

  ForeignSetup setup_;
  Loaded loaded_;
  std::vector<const ForeignVariableInfo*> start_variables_;
  std::vector<cosim::Port> ports_;
  HeldInputs inputs_;
  ForeignOutputs outputs_;
  double time_ = 0.0;  // [s]
  double step_ = 0.0;  // [s]  of the first step; 0 before
  std::string lost_;   // why it cannot go on
  std::unique_ptr<ForeignInstance> instance_;
  mutable StateKeeper keeper_;  // its states go before the instance
};

}  // namespace

std::unique_ptr<cosim::Participant> import_fmu(const ForeignSetup& setup) {
  try {
    return std::make_unique<ForeignParticipant>(setup);
  } catch (const ForeignFmuError& error) {
    throw ForeignFmuError(setup.file.filename().string() + ": " + error.what());
  }
}

ForeignDescription describe_fmu(const std::filesystem::path& file) {
  try {
    return read_description(UnpackedFmu{file}.folder() / "modelDescription.xml");
  } catch (const ForeignFmuError& error) {
    throw ForeignFmuError(file.filename().string() + ": " + error.what());
  }
}

}  // namespace orbearing::fmu
