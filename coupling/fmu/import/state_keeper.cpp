#include "coupling/fmu/import/state_keeper.hpp"

#include <cmath>
#include <cstdint>

#include "coupling/fmu/import/errors.hpp"

namespace orbearing::fmu {
namespace {

constexpr std::size_t bytes_in_number = 6;
constexpr double serialised_kind = 1.0;
constexpr double kept_kind = 2.0;

// FNV-1a, its low 48 bits.
double mark_of(const ForeignDescription& description) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : description.model_name + '\n' + description.token) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return static_cast<double>(hash & ((1ULL << 48) - 1));
}

bool whole(double number, double limit) {
  return number >= 0.0 && number < limit && number == std::floor(number);
}

}  // namespace

void append_bytes(const std::vector<unsigned char>& bytes, std::vector<double>& numbers) {
  numbers.push_back(static_cast<double>(bytes.size()));
  for (std::size_t i = 0; i < bytes.size(); i += bytes_in_number) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < bytes_in_number && i + k < bytes.size(); ++k) {
      word |= std::uint64_t{bytes[i + k]} << (8 * k);
    }
    numbers.push_back(static_cast<double>(word));
  }
}

std::vector<unsigned char> bytes_of(const std::vector<double>& numbers, std::size_t first) {
  const std::size_t words = numbers.size() > first ? numbers.size() - first - 1 : 0;
  const double count = numbers.size() > first ? numbers[first] : -1.0;
  if (!whole(count, static_cast<double>(words * bytes_in_number) + 1.0) ||
      std::ceil(count / bytes_in_number) != static_cast<double>(words)) {
    throw ForeignFmuError("a saved state that is cut short or damaged");
  }
  std::vector<unsigned char> bytes(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double number = numbers[first + 1 + i / bytes_in_number];
    if (!whole(number, 0x1p48)) throw ForeignFmuError("a saved state that is damaged");
    const auto shift = 8 * (i % bytes_in_number);
    bytes[i] = static_cast<unsigned char>(static_cast<std::uint64_t>(number) >> shift & 255U);
  }
  return bytes;
}

StateKeeper::StateKeeper(const ForeignDescription& description)
    : keeps_{description.keeps_state},
      serialises_{description.keeps_state && description.serialises_state},
      mark_{mark_of(description)} {}

KeptState StateKeeper::current(ForeignInstance& instance) const {
  return keeps_ ? KeptState{instance, instance.take_state()} : KeptState{};
}

void StateKeeper::save(ForeignInstance& instance, cosim::SavedState& numbers) {
  if (!keeps_) {
    throw ForeignFmuError(
        "cannot save its state (canGetAndSetFMUstate is not true in modelDescription.xml); use a scheme that "
        "does not repeat windows");
  }
  KeptState state = current(instance);
  numbers.push_back(mark_);
  if (serialises_) {
    numbers.push_back(serialised_kind);
    append_bytes(instance.serialised(state.memory()), numbers);
    return;
  }
  numbers.push_back(kept_kind);
  numbers.push_back(next_);
  kept_.push_back({next_, std::move(state)});
  next_ += 1.0;
  if (kept_.size() > most_kept) kept_.pop_front();
}

void StateKeeper::restore(ForeignInstance& instance, const cosim::SavedState& numbers,
                          std::size_t first) const {
  if (numbers.size() < first + 3 || numbers[first] != mark_) {
    throw ForeignFmuError("a saved state of another model");
  }
  if (serialises_ && numbers[first + 1] == serialised_kind) {
    const KeptState state{instance, instance.deserialised(bytes_of(numbers, first + 2))};
    state.set();
    return;
  }
  for (const Numbered& kept : kept_) {
    if (numbers[first + 1] == kept_kind && kept.number == numbers[first + 2]) {
      kept.state.set();
      return;
    }
  }
  throw ForeignFmuError(
      "a saved state that is gone: the FMU cannot serialise its states, and only the last 8 since "
      "initialize() are kept");
}

}  // namespace orbearing::fmu
