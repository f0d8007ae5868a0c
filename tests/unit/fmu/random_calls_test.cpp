// Any sequence of calls of the C interfaces, legal or not, ends in a status, with a reason where it is not
// OK; afterwards the instance works as a new one. RANDOM_CALLS: how many (20000 if unset).
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

#include "tests/unit/fmu/random_caller.hpp"

namespace orbearing::fmu::random_calls_test {
namespace {

using test::Caller;
using test::Resources;
using test::short_bearing;
using test::short_gears;

long calls_wanted() {
  const char* text = std::getenv("RANDOM_CALLS");
  return text == nullptr ? 20'000 : std::atol(text);
}

class RandomCalls {
 public:
  explicit RandomCalls(unsigned seed) : random_(seed) {
    for (const Resources* model : {&bearing_, &gears_})
      for (const bool fmi3 : {false, true}) callers_.push_back(std::make_unique<Caller>(*model, fmi3));
  }

  void call() {
    Caller& it = *callers_[below(callers_.size())];
    it.messages.list.clear();
    const int status = random_call(it);
    ASSERT_GE(status, 0);
    ASSERT_LE(status, 3) << it.messages.last();
    ASSERT_EQ(status == 0, it.messages.list.empty()) << status << " " << it.messages.last();
    ++statuses[static_cast<std::size_t>(status)];
  }

  // Each instance, whatever befell it, runs as a new one after its reset.
  void expect_sound() {
    for (const auto& it : callers_) {
      const std::vector<double> found = plain_run(*it);
      it->drop();
      it->make();
      EXPECT_EQ(found, plain_run(*it));
    }
  }

  std::array<long, 4> statuses{};

 private:
  std::size_t below(std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
  }
  bool sometimes() { return below(20) == 0; }

  double value() {
    constexpr double limit = std::numeric_limits<double>::max();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double wild[] = {0.0,
                               1.0,
                               -1.0,
                               limit,
                               -limit,
                               infinity,
                               -infinity,
                               5e-324,
                               1e-3,
                               1e9,
                               std::numeric_limits<double>::quiet_NaN()};
    if (below(3) == 0) return wild[below(std::size(wild))];
    return std::uniform_real_distribution<double>(-1e-5, 3e-5)(random_);
  }

  std::vector<std::uint32_t> references(std::size_t most) {
    std::vector<std::uint32_t> list(below(most + 1));
    for (std::uint32_t& one : list)
      one = sometimes() ? static_cast<std::uint32_t>(random_()) : static_cast<std::uint32_t>(below(110));
    return list;
  }
  std::vector<double> values(std::size_t number) {
    std::vector<double> list(number);
    for (double& one : list) one = value();
    return list;
  }
  template <class T>
  T* or_null(std::vector<T>& list) {
    return sometimes() ? nullptr : list.data();
  }
  void* state(Caller& it) {
    if (it.states.empty() || sometimes()) return sometimes() ? static_cast<void*>(&random_) : nullptr;
    return it.states[below(it.states.size())];
  }

  int get(Caller& it) {
    std::vector<std::uint32_t> vr = references(4);
    std::vector<double> out(vr.size() + 1);
    return it.get(or_null(vr), vr.size(), or_null(out), vr.size() + (sometimes() ? 1 : 0));
  }
  int get_whole(Caller& it) {
    std::vector<std::uint32_t> vr = references(3);
    std::vector<std::int32_t> out(vr.size() + 1);
    return it.fmi3
               ? static_cast<int>(fmi3GetInt32(it.component, vr.data(), vr.size(), or_null(out), vr.size()))
               : static_cast<int>(fmi2GetInteger(it.component, or_null(vr), vr.size(), out.data()));
  }
  int set(Caller& it) {
    std::vector<std::uint32_t> vr = references(3);
    std::vector<double> in = values(vr.size());
    return it.set(or_null(vr), vr.size(), or_null(in));
  }
  int set_derivatives(Caller& it) {
    std::vector<std::uint32_t> vr = references(3);
    std::vector<double> in = values(vr.size());
    std::vector<int> orders(vr.size());
    for (int& order : orders) order = static_cast<int>(below(4));
    if (it.fmi3)
      return fmi3GetOutputDerivatives(it.component, vr.data(), vr.size(), orders.data(), in.data(),
                                      in.size());
    return fmi2SetRealInputDerivatives(it.component, or_null(vr), vr.size(), or_null(orders), or_null(in));
  }
  int step(Caller& it) {
    const double size = below(4) == 0 ? value() : 1e-6 * static_cast<double>(1 + below(5));
    return it.step(sometimes() ? value() : it.time, size);
  }
  int begin(Caller& it) {
    const double start = below(3) == 0 ? value() : 0.0;
    const int which = static_cast<int>(below(3));
    if (it.fmi3) {
      if (which == 0) return fmi3ExitInitializationMode(it.component);
      return fmi3EnterInitializationMode(it.component, false, 0.0, start, sometimes(), value());
    }
    if (which == 0) return fmi2SetupExperiment(it.component, 0, 0.0, start, sometimes() ? 1 : 0, value());
    return which == 1 ? fmi2EnterInitializationMode(it.component) : fmi2ExitInitializationMode(it.component);
  }
  int end(Caller& it) { return below(3) == 0 ? it.terminate() : it.reset(); }
  int keep(Caller& it) {
    void* made = sometimes() ? state(it) : nullptr;
    const int status = it.keep(&made);
    if (status == 0) it.states.push_back(made);
    if (status == 0 && it.states.size() > 6) {
      it.free_state(&it.states.front());
      it.states.erase(it.states.begin());
      it.messages.list.clear();  // it may have been freed before
    }
    return status;
  }
  int go_back(Caller& it) {
    const int status = it.go_to(state(it));
    const std::uint32_t time = 0;
    it.get(&time, 1, &it.time, 1);
    return status;
  }
  int free_state(Caller& it) {
    void* which = state(it);
    return it.free_state(&which);
  }
  int serialize(Caller& it) {
    void* const which = state(it);
    std::size_t size = 0;
    const int status = it.state_size(which, &size);
    if (status != 0) return status;
    it.bytes.assign(sometimes() ? size / 2 : size, '\0');
    return it.write_state(which);
  }
  int deserialize(Caller& it) {
    std::vector<char> bytes = callers_[below(callers_.size())]->bytes;
    if (!bytes.empty() && below(2) == 0) bytes[below(bytes.size())] = static_cast<char>(random_());
    if (sometimes()) bytes.resize(below(bytes.size() + 20));
    void* made = nullptr;
    const int status = it.read_state(or_null(bytes), bytes.size(), &made);
    if (status == 0) it.states.push_back(made);
    return status;
  }
  int slopes(Caller& it) {
    std::vector<std::uint32_t> unknowns = references(3), knowns = references(3);
    std::vector<double> seed = values(4), out(4);
    if (it.fmi3 && below(2) == 0)
      return fmi3GetAdjointDerivative(it.component, unknowns.data(), unknowns.size(), knowns.data(),
                                      knowns.size(), seed.data(), unknowns.size(), out.data(), knowns.size());
    if (it.fmi3)
      return fmi3GetDirectionalDerivative(it.component, unknowns.data(), unknowns.size(), knowns.data(),
                                          knowns.size(), seed.data(), knowns.size(), out.data(),
                                          unknowns.size());
    return fmi2GetDirectionalDerivative(it.component, or_null(unknowns), unknowns.size(), or_null(knowns),
                                        knowns.size(), or_null(seed), or_null(out));
  }
  int rare(Caller& it) {
    const fmi2ValueReference vr = 3;
    double one = 0.0;
    int flag = 0;
    if (it.fmi3) {
      switch (below(6)) {
        case 0:
          return fmi3EnterEventMode(it.component);
        case 1:
          return fmi3EnterConfigurationMode(it.component);
        case 2:
          return fmi3GetString(it.component, &vr, 1, nullptr, 1);
        case 3:
          return fmi3SetTime(it.component, 1.0);
        case 4:
          return fmi3GetVariableDependencies(it.component, vr, nullptr, nullptr, nullptr, nullptr, below(7));
        default:
          return fmi3GetIntervalDecimal(it.component, &vr, 1, nullptr, nullptr);
      }
    }
    switch (below(6)) {
      case 0:
        return fmi2CancelStep(it.component);
      case 1:
        return fmi2GetBooleanStatus(it.component, fmi2Terminated, sometimes() ? nullptr : &flag);
      case 2:
        return fmi2GetRealOutputDerivatives(it.component, &vr, 1, &flag, &one);
      case 3:
        return fmi2SetBoolean(it.component, &vr, below(2), &flag);
      case 4:
        return fmi2GetStatus(it.component, fmi2DoStepStatus, nullptr);
      default:
        return fmi2SetDebugLogging(it.component, fmi2False, below(2), nullptr);
    }
  }
  int replace(Caller& it) {
    it.drop();
    it.make();
    return 0;
  }

  int random_call(Caller& it) {
    const std::size_t chance = below(200);
    if (chance < 40) return get(it);
    if (chance < 80) return set(it);
    if (chance < 115) return step(it);
    if (chance < 125) return begin(it);
    if (chance < 128) return end(it);
    if (chance < 133) return it.start();
    if (chance < 143) return keep(it);
    if (chance < 153) return go_back(it);
    if (chance < 158) return free_state(it);
    if (chance < 164) return serialize(it);
    if (chance < 170) return deserialize(it);
    if (chance < 180) return slopes(it);
    if (chance < 186) return set_derivatives(it);
    if (chance < 190) return get_whole(it);
    return chance < 199 ? rare(it) : replace(it);
  }

  std::vector<double> plain_run(Caller& it) {
    EXPECT_EQ(it.start(), 0) << it.messages.last();
    for (int i = 0; i < 5; ++i) EXPECT_EQ(it.step(i * 2e-6, 2e-6), 0) << it.messages.last();
    const std::size_t last = variables_of(facts_of(it.resources->numbers())).size() - 1;
    std::vector<std::uint32_t> vr;
    for (std::size_t back = 0; back < 20; ++back) vr.push_back(static_cast<std::uint32_t>(last - back));
    std::vector<double> out(vr.size());
    EXPECT_EQ(it.get(vr.data(), vr.size(), out.data(), out.size()), 0) << it.messages.last();
    return out;
  }

  std::mt19937 random_;
  const Resources bearing_{short_bearing()}, gears_{short_gears()};
  std::vector<std::unique_ptr<Caller>> callers_;
};

TEST(FmuRandomCalls, EndInAStatusAndAReason) {
  constexpr long kPart = 20'000;  // of one seed, so that a failure can be found again
  std::array<long, 4> statuses{};
  for (long done = 0, seed = 1; done < calls_wanted(); done += kPart, ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomCalls calls(static_cast<unsigned>(seed));
    for (long i = 0; i < kPart && !HasFatalFailure(); ++i) calls.call();
    calls.expect_sound();
    for (std::size_t i = 0; i < 4; ++i) statuses[i] += calls.statuses[i];
    if (HasFailure()) break;
  }
  std::printf("%ld OK, %ld discarded, %ld refused\n", statuses[0], statuses[2], statuses[3]);
  EXPECT_GT(statuses[0], calls_wanted() / 5) << "most calls were refused: the test reaches too little";
  EXPECT_GT(statuses[3], calls_wanted() / 10);
}

}  // namespace
}  // namespace orbearing::fmu::random_calls_test
