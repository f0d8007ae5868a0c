#include "app/case/profile_case.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "app/case/described_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/reference_life.hpp"

namespace orbearing::app {

namespace {

const std::string kBlock = "bearing.profile.";

// ISO/TS 16281 has no life with fewer laminae; for straight rollers the stress riser accounts for the roller
// ends.
void check_laminae(CheckedCase& in) {
  if (!has_all(in, {keys().laminae, keys().profile_kind, keys().life_method})) return;
  const int laminae = in.integer(keys().laminae);
  if (laminae == 0 || laminae >= bearing::rating::kLeastRatedLaminae) return;
  if (!in.is(keys().profile_kind, "straight") || !in.is(keys().life_method, "iso-16281")) return;
  in.add_error_at(keys().laminae,
                  fmt::format("{} laminae of straight rollers with life.method: iso-16281", laminae),
                  fmt::format("at least {} are required, as ISO/TS 16281 has L10r; or bearing.profile.kind: "
                              "iso16281; or life.method: lundberg-palmgren",
                              bearing::rating::kLeastRatedLaminae));
}

std::string first_of(const ResolvedCase& in, const std::string& block) {
  for (const Field& field : all_fields())
    if (field.path.starts_with(block) && in.has(field.path)) return field.path;
  return {};
}

}  // namespace

void check_profile(CheckedCase& in) {
  const std::string misaligned = first_of(in, "bearing.misalignment.");
  if (!misaligned.empty() && !in.has(keys().laminae))
    in.add_error_at(misaligned, "an entry without bearing.laminae",
                    "laminae, which it acts on, are required: for instance bearing.laminae: 40");
  check_laminae(in);
  const std::string profile = first_of(in, kBlock);
  if (!profile.empty() && !in.has(keys().profile_kind))
    in.add_error_at(profile, "a profile without bearing.profile.kind", "a kind of profile is required");
  if (!has_all(in, {keys().profile_kind, keys().roller_length, keys().roller_diameter, keys().pitch_diameter,
                    keys().radial_clearance}))
    return;
  try {
    auto bearing = from_case<bearing::Bearing>(in);
    put_profile(from_case<bearing::profile::StatedProfile>(in), bearing);
  } catch (const std::invalid_argument& error) {
    in.add_error(keys().profile_kind, error.what());
  }
}

}  // namespace orbearing::app
