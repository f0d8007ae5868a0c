// States of an FMU as numbers, as participants save them.
#pragma once

#include <list>

#include "coupling/cosim/participant.hpp"
#include "coupling/fmu/import/foreign_instance.hpp"

namespace orbearing::fmu {

/// One state in the FMU's memory; empty where the FMU keeps none. Goes before its instance.
class KeptState {
 public:
  KeptState() = default;
  KeptState(ForeignInstance& instance, void* state) : instance_{&instance}, state_{state} {}
  ~KeptState() {
    if (instance_ != nullptr) instance_->free_state(state_);
  }
  KeptState(KeptState&& other) noexcept : instance_{other.instance_}, state_{other.state_} {
    other.instance_ = nullptr;
  }
  KeptState& operator=(KeptState&&) = delete;

  /// False where it is empty.
  bool set() const {
    if (instance_ != nullptr) instance_->set_state(state_);
    return instance_ != nullptr;
  }
  void* memory() const { return state_; }

 private:
  ForeignInstance* instance_ = nullptr;
  void* state_ = nullptr;
};

class StateKeeper {
 public:
  explicit StateKeeper(const ForeignDescription& description);

  /// Of all states; before the instance goes.
  void forget() { kept_.clear(); }
  KeptState current(ForeignInstance& instance) const;
  /// Appends to `numbers`: a mark of the model, the kind, then the bytes of the serialised state, six to a
  /// number, or the number of a state kept here. Throws ForeignFmuError where the FMU offers neither.
  void save(ForeignInstance& instance, cosim::SavedState& numbers);
  /// Of what begins at numbers[first]. Throws ForeignFmuError where it is not of this model or has gone.
  void restore(ForeignInstance& instance, const cosim::SavedState& numbers, std::size_t first) const;

 private:
  static constexpr std::size_t most_kept = 8;
  struct Numbered {
    double number;
    KeptState state;
  };

  bool keeps_, serialises_;
  double mark_;  // of the model: all saved states begin with it
  double next_ = 1.0;
  std::list<Numbered> kept_;
};

/// Any bytes as whole numbers below 2^48, after their count; exact, and equal where the bytes are.
void append_bytes(const std::vector<unsigned char>& bytes, std::vector<double>& numbers);
/// Of what stands at numbers[first] to the end. Throws ForeignFmuError where the numbers are none of these.
std::vector<unsigned char> bytes_of(const std::vector<double>& numbers, std::size_t first);

}  // namespace orbearing::fmu
