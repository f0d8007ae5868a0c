#include "bearing/profile/profile.hpp"

#include <array>
#include <stdexcept>

namespace orbearing::bearing::profile {

namespace {

double* parameter_of(Straight&) {
  return nullptr;
}
double* parameter_of(Chamfer& profile) {
  return &profile.depth;
}
double* parameter_of(CircularCrown& profile) {
  return &profile.end_drop;
}
double* parameter_of(StraightCircular& profile) {
  return &profile.end_drop;
}
double* parameter_of(Lundberg& profile) {
  return &profile.amplitude;
}
double* parameter_of(JohnsGohar& profile) {
  return &profile.amplitude;
}
double* parameter_of(Iso16281& profile) {
  return &profile.scale;
}
double* parameter_of(FujiwaraKawase& profile) {
  return &profile.end_drop;
}
double* parameter_of(Table& profile) {
  return &profile.scale;
}

[[noreturn]] void throw_no_relief(const Profile& profile) {
  throw std::invalid_argument("profile " + kind(profile) +
                              ": found no relief at the place whose drop is asked for; required: a kind that "
                              "falls away there. Choose another kind or a longer end");
}

}  // namespace

Relief relief(const Profile& profile, double x) {
  return std::visit([x](const auto& shape) { return relief_of(shape, x); }, profile);
}

double drop(const Profile& profile, double x) {
  return relief(profile, x).drop;
}

double leading_parameter(const Profile& profile) {
  Profile copy = profile;
  const double* parameter = std::visit([](auto& shape) { return parameter_of(shape); }, copy);
  return parameter ? *parameter : 0.0;
}

Profile with_parameter(Profile profile, double value) {
  double* parameter = std::visit([](auto& shape) { return parameter_of(shape); }, profile);
  if (parameter) *parameter = value;
  return profile;
}

// All but the circular kinds are proportional to their parameter, and those nearly: a few steps of Newton's
// method from zero depth end at round-off.
Profile with_drop(const Profile& profile, double station, double depth) {
  constexpr int kSteps = 8;
  Profile deeper = with_parameter(profile, 0.0);
  if (depth == 0.0) return deeper;
  for (int i = 0; i < kSteps; ++i) {
    const Relief now = relief(deeper, station);
    if (now.per_parameter <= 0.0) throw_no_relief(profile);
    deeper = with_parameter(deeper, leading_parameter(deeper) + (depth - now.drop) / now.per_parameter);
  }
  return deeper;
}

std::string kind(const Profile& profile) {
  static constexpr std::array<const char*, std::variant_size_v<Profile>> names{
      "straight", "chamfer",         "circular", "straight-circular", "lundberg", "johns-gohar",
      "iso16281", "fujiwara-kawase", "table"};
  return names.at(profile.index());
}

}  // namespace orbearing::bearing::profile
