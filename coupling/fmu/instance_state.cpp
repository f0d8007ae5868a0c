#include "coupling/fmu/instance_state.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

#include "coupling/fmu/number_table.hpp"
#include "coupling/fmu/refused.hpp"

namespace orbearing::fmu {

namespace {

struct Header {
  std::array<char, 8> magic{'O', 'R', 'B', 'F', 'M', 'U', 'S', 'T'};
  std::uint64_t format = 2;
  std::uint64_t model = 0;     // hash
  std::uint64_t numbers = 0;   // doubles that follow
  std::uint64_t checksum = 0;  // of their bytes
};

std::vector<double> numbers_of(const InstanceState& s) {
  std::vector<double> numbers{static_cast<double>(s.phase),
                              static_cast<double>(s.experiment_set),
                              static_cast<double>(s.has_stop),
                              static_cast<double>(s.computed),
                              s.time,
                              s.stop};
  const auto add = [&](const auto& list) { numbers.insert(numbers.end(), list.begin(), list.end()); };
  add(s.parameters);
  add(s.inputs);
  add(s.first);
  add(s.second);
  for (const bool has : s.has_first) numbers.push_back(has ? 1.0 : 0.0);
  for (const bool was : s.given) numbers.push_back(was ? 1.0 : 0.0);
  add(s.participant);
  return numbers;
}

constexpr std::size_t kFixed = 6;  // numbers before the lists

std::size_t count_of(const StateSizes& sizes) {
  return kFixed + sizes.parameters + 5 * sizes.inputs;
}

// The numbers of the participant are its own business; all before must be finite.
InstanceState state_of(const std::vector<double>& numbers, const StateSizes& sizes) {
  for (std::size_t i = 0; i < count_of(sizes); ++i)
    if (!std::isfinite(numbers[i])) throw Refused("serialised state: found a number that is not finite");
  InstanceState s;
  const int phase = static_cast<int>(std::fmin(std::fmax(numbers[0], -1.0), 9.0));
  if (phase < 0 || phase > static_cast<int>(Phase::terminated))
    throw Refused("serialised state: found phase " + std::to_string(phase) + "; required: 0 to 3");
  s.phase = static_cast<Phase>(phase);
  s.experiment_set = numbers[1] != 0.0;
  s.has_stop = numbers[2] != 0.0;
  s.computed = numbers[3] != 0.0;
  s.time = numbers[4];
  s.stop = numbers[5];
  auto from = numbers.begin() + kFixed;
  const auto take = [&](std::size_t count) {
    const auto begin = from;
    from += static_cast<std::ptrdiff_t>(count);
    return std::vector<double>(begin, from);
  };
  s.parameters = take(sizes.parameters);
  s.inputs = take(sizes.inputs);
  s.first = take(sizes.inputs);
  s.second = take(sizes.inputs);
  for (const double has : take(sizes.inputs)) s.has_first.push_back(has != 0.0);
  for (const double was : take(sizes.inputs)) s.given.push_back(was != 0.0);
  s.participant.assign(from, numbers.end());
  return s;
}

Refused no_state(const std::string& found, const std::string& required) {
  return Refused("serialised state: found " + found + "; required: " + required);
}

}  // namespace

std::size_t byte_number(const InstanceState& s) {
  const std::size_t lists = s.parameters.size() + 5 * s.inputs.size() + s.participant.size();
  return sizeof(Header) + (kFixed + lists) * sizeof(double);
}

std::string bytes_of(const InstanceState& state, std::uint64_t model) {
  const std::vector<double> numbers = numbers_of(state);
  std::string body(numbers.size() * sizeof(double), '\0');
  std::memcpy(body.data(), numbers.data(), body.size());
  const Header header{.model = model, .numbers = numbers.size(), .checksum = hash_of(body)};
  std::string bytes(sizeof(Header), '\0');
  std::memcpy(bytes.data(), &header, sizeof(Header));
  return bytes + body;
}

InstanceState state_from(const char* bytes, std::size_t size, std::uint64_t model, const StateSizes& sizes) {
  if (size < sizeof(Header))
    throw no_state(std::to_string(size) + " bytes", "at least " + std::to_string(sizeof(Header)));
  Header header;
  std::memcpy(&header, bytes, sizeof(Header));
  if (header.magic != Header{}.magic) throw no_state("other bytes", "a state of an FMU of Orbearing");
  if (header.format != Header{}.format)
    throw no_state("format " + std::to_string(header.format), std::to_string(Header{}.format));
  if (header.model != model)
    throw no_state("that of another model or version of Orbearing", "one of this very model");
  const std::string_view body(bytes + sizeof(Header), size - sizeof(Header));
  if (header.numbers != body.size() / sizeof(double) || body.size() % sizeof(double) != 0)
    throw no_state(std::to_string(size) + " bytes", "a whole state");
  if (header.checksum != hash_of(body)) throw no_state("changed bytes", "a state as it was written");
  std::vector<double> numbers(body.size() / sizeof(double));
  if (numbers.size() < count_of(sizes))
    throw no_state(std::to_string(numbers.size()) + " numbers",
                   "at least " + std::to_string(count_of(sizes)));
  std::memcpy(numbers.data(), body.data(), body.size());
  return state_of(numbers, sizes);
}

}  // namespace orbearing::fmu
