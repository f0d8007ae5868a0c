#include "coupling/fmu/profile_numbers.hpp"

#include <stdexcept>
#include <string>

namespace orbearing::fmu {

namespace {

using namespace bearing::profile;

// Members in the order in which they are written; one list serves both ways.
std::vector<double*> members_of(Straight&) {
  return {};
}
std::vector<double*> members_of(Chamfer& p) {
  return {&p.length, &p.chamfer_length, &p.depth};
}
std::vector<double*> members_of(CircularCrown& p) {
  return {&p.length, &p.end_drop};
}
std::vector<double*> members_of(StraightCircular& p) {
  return {&p.length, &p.straight_length, &p.end_drop};
}
std::vector<double*> members_of(Lundberg& p) {
  return {&p.length, &p.amplitude, &p.width_ratio};
}
std::vector<double*> members_of(JohnsGohar& p) {
  return {&p.length, &p.amplitude, &p.width_ratio};
}
std::vector<double*> members_of(Iso16281& p) {
  return {&p.length, &p.diameter, &p.scale};
}
std::vector<double*> members_of(FujiwaraKawase& p) {
  return {&p.length, &p.end_drop, &p.steepness, &p.crowned_fraction};
}
std::vector<double*> members_of(Table& p) {
  std::vector<double*> members{&p.scale};
  for (double& x : p.x) members.push_back(&x);
  for (double& drop : p.drop) members.push_back(&drop);
  return members;
}

[[noreturn]] void refuse(std::size_t found) {
  throw std::invalid_argument("profile in the model: found " + std::to_string(found) +
                              " numbers; required: those of a known kind");
}

// The variant's alternative at a place known at run time, empty but for the length of a table.
template <std::size_t I = 0>
Profile empty_profile(std::size_t position, std::size_t numbers) {
  if constexpr (I < std::variant_size_v<Profile>) {
    if (position != I) return empty_profile<I + 1>(position, numbers);
    std::variant_alternative_t<I, Profile> profile{};
    if constexpr (std::is_same_v<decltype(profile), Table>) {
      profile.x.resize(numbers < 2 ? 0 : (numbers - 2) / 2);
      profile.drop.resize(profile.x.size());
    }
    return profile;
  } else {
    refuse(numbers);
  }
}

}  // namespace

std::vector<double> profile_numbers(const Profile& profile) {
  std::vector<double> numbers{static_cast<double>(profile.index())};
  Profile copy = profile;
  std::visit(
      [&](auto& p) {
        for (const double* member : members_of(p)) numbers.push_back(*member);
      },
      copy);
  return numbers;
}

Profile profile_from(const std::vector<double>& numbers) {
  if (numbers.empty() || !(numbers[0] >= 0.0 && numbers[0] < 100.0)) refuse(numbers.size());
  Profile profile = empty_profile(static_cast<std::size_t>(numbers[0]), numbers.size());
  std::visit(
      [&](auto& p) {
        const std::vector<double*> members = members_of(p);
        if (members.size() + 1 != numbers.size()) refuse(numbers.size());
        for (std::size_t i = 0; i < members.size(); ++i) *members[i] = numbers[i + 1];
      },
      profile);
  return profile;
}

}  // namespace orbearing::fmu
