// One instance of an FMU, whatever the version of the interface: what may be called when, inputs over a step,
// outputs, states. All wrong calls throw Refused and change nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/fmu/model.hpp"
#include "coupling/fmu/model_file.hpp"
#include "coupling/system/participant.hpp"

namespace orbearing::fmu {

// All that an instance's future depends on, and its form as bytes for another process.

enum class Phase { instantiated, initializing, stepping, terminated };

struct InstanceState {
  Phase phase = Phase::instantiated;
  bool experiment_set = false;
  bool has_stop = false;
  bool computed = false;  // the participant holds a state
  double time = 0.0;      // [s]
  double elapsed = 0.0;   // [s]  since the start: the participant's clock, whatever the start time
  double stop = 0.0;      // [s]
  std::vector<double> parameters;
  std::vector<double> inputs;
  std::vector<bool> given;     // inputs that the importer set
  std::vector<double> first;   // [unit/s]    derivatives of the inputs for the next step
  std::vector<double> second;  // [unit/s^2]
  std::vector<bool> has_first;
  system::SavedState participant;
};

/// Number of values of each kind in a model.
struct StateSizes {
  std::size_t parameters = 0;
  std::size_t inputs = 0;
};

/// Header (magic, format, length, hashes of program version and model, checksum), then all numbers.
/// @param model hash of the model and the program's version
std::string bytes_of(const InstanceState& state, std::uint64_t model);

/// Throws Refused with the reason where `bytes` are not a whole state of this model and version.
InstanceState state_from(const char* bytes, std::size_t size, std::uint64_t model, const StateSizes& sizes);

/// Receiver of messages: status, category, text.
using Log = std::function<void(Status, const char*, const char*)>;

/// Start and end of a run; no end: open.
struct Experiment {
  double start = 0.0;  // [s]
  std::optional<double> stop;
};

/// Value references of a call; all that the caller gave.
struct References {
  const std::uint32_t* list = nullptr;
  std::size_t number = 0;
};

class Instance {
 public:
  /// Throws Refused where `token` is not that of the model.
  Instance(NumberTable numbers, const std::string& token, Log log, bool logging);

  /// @param categories names of the standard; none: all
  void set_logging(bool on, std::vector<std::string> categories);
  /// Reasons always reach the log, unless their category was not chosen; events only where logging is on.
  void log(Status status, const char* function, const char* text) const noexcept;

  void setup_experiment(const Experiment& experiment);
  void enter_initialization();
  void exit_initialization();
  void terminate();
  void reset();

  void get(References references, double* values);
  /// Values of integers, in the form that both versions of the interface use.
  void get_whole(References references, std::int32_t* values);
  void set(References references, const double* values);
  /// Derivatives of inputs by time for the next step, of order 1 or 2.
  void set_derivatives(References references, const int* orders, const double* values);

  void step(double point, double size);
  double time() const { return state_.time; }

  /// sensitivity = d(unknowns)/d(knowns) seed, the state of the model held.
  void directional(References unknowns, References knowns, const double* seed, double* sensitivity);
  /// sensitivity = seed d(unknowns)/d(knowns).
  void adjoint(References unknowns, References knowns, const double* seed, double* sensitivity);

  /// A state stays the instance's own until it is freed. `again`: an earlier one to be written over, or null.
  InstanceState* keep_state(InstanceState* again);
  void go_to_state(const InstanceState* state);
  void free_state(const InstanceState* state);
  std::size_t state_size(const InstanceState* state) const;
  void serialize(const InstanceState* state, char* bytes, std::size_t size) const;
  InstanceState* deserialize(const char* bytes, std::size_t size, InstanceState* again);

  bool experiment_set() const { return state_.experiment_set; }
  Phase phase() const { return state_.phase; }
  const ModelFacts& facts() const { return facts_; }
  const std::vector<Variable>& variables() const { return variables_; }
  /// Throws Refused where there is no such variable.
  const Variable& variable(std::uint32_t reference) const;

 private:
  void require_phase(std::initializer_list<Phase> allowed, const char* what) const;
  void require_settable(const Variable& variable, double value) const;
  void require_known(const InstanceState* state) const;
  void require_step(double point, double size) const;
  double accepted_length(double length, const std::vector<system::InputPolynomial>& inputs);
  [[noreturn]] void refuse_step(double length, const std::vector<system::InputPolynomial>& inputs,
                                const std::string& reason);
  system::Participant& participant();
  void compute_start();
  const std::vector<double>& outputs();
  double value_of(const Variable& variable);
  std::vector<system::InputPolynomial> polynomials() const;
  std::vector<double> input_values(const std::vector<system::InputPolynomial>& polynomials,
                                   double since) const;
  template <class Function>
  void for_each_slope(References unknowns, References knowns, const Function& function);
  void clear_derivatives();
  InstanceState present() const;
  InstanceState* place_state(InstanceState state, InstanceState* again);

  NumberTable numbers_;
  ModelFacts facts_;
  std::vector<Variable> variables_;
  std::uint64_t hash_ = 0;  // of model and version
  Log log_;
  bool logging_ = false;
  std::vector<std::string> categories_;
  InstanceState state_;  // but for the participant's numbers
  std::unique_ptr<system::Participant> participant_;
  std::optional<std::vector<double>> outputs_;  // at the present time, where they are known
  std::list<InstanceState> kept_;
};

}  // namespace orbearing::fmu
