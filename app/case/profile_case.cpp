#include "app/case/profile_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "app/case/described_case.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "bearing/geometry.hpp"
#include "bearing/life/reference_life.hpp"

namespace orbearing::app {

namespace {

using namespace bearing::profile;

const std::string kBlock = "bearing.profile.";

double value_or(const ResolvedCase& in, const std::string& key, double otherwise) {
  return in.has(kBlock + key) ? in.value(kBlock + key).number : otherwise;
}

// Properties of the roller that its profile uses.
struct Roller {
  double length = 0.0;    // [m]
  double diameter = 0.0;  // [m]
  double drop = 0.0;      // [m]  at kDropPosition: stated, or that of the standard's profile
  DesignLoad design;      // of the more strongly curved contact, on the inner race
};

Roller roller_of(const ResolvedCase& in) {
  Roller out{.length = in.quantity(keys().roller_length), .diameter = in.quantity(keys().roller_diameter)};
  const double station = kDropPosition * 0.5 * out.length;
  const double standard = drop(Iso16281{out.length, out.diameter, 1.0}, station);
  out.drop = value_or(in, "drop", standard);
  out.design = bearing::design_under(from_case<bearing::Bearing>(in), 0.0);
  out.design.load =
      value_or(in, "design_load", design_load_of_drop(out.design, out.drop > 0.0 ? out.drop : standard));
  return out;
}

FujiwaraKawase fujiwara_kawase(const ResolvedCase& in, const Roller& roller) {
  const double k1 = value_or(in, "k1", 1.0);
  const double end = k1 * drop(johns_gohar_for(roller.design), 0.5 * roller.length);
  return fujiwara_kawase_for(roller.design, k1, value_or(in, "k2", 1.0), value_or(in, "end_drop", end));
}

Table table(const ResolvedCase& in) {
  Table out;
  if (in.has(kBlock + "x")) out.x = in.list(kBlock + "x");
  if (in.has(kBlock + "drops")) out.drop = in.list(kBlock + "drops");
  return out;
}

// With the depth that its own entries give it; one that has none yet is as deep at its end as it shall be at
// kDropPosition.
Profile own_profile(const ResolvedCase& in, const Roller& roller) {
  const std::string& kind = in.choice(kProfileKind);
  const double l = roller.length, depth = std::max(roller.drop, 1e-9);
  if (kind == "chamfer") return Chamfer{l, value_or(in, "chamfer_length", 0.1 * l), depth};
  if (kind == "circular") return CircularCrown{l, depth};
  if (kind == "straight-circular")
    return StraightCircular{l, value_or(in, "straight_length", 0.6 * l), depth};
  if (kind == "lundberg") return lundberg_for(roller.design);
  if (kind == "johns-gohar") return johns_gohar_for(roller.design);
  if (kind == "iso16281") return Iso16281{l, roller.diameter, 1.0};
  if (kind == "fujiwara-kawase") return fujiwara_kawase(in, roller);
  if (kind == "table") return table(in);
  return Straight{};
}

// Kinds whose depth lies in other entries than the drop.
bool has_own_depth(const ResolvedCase& in) {
  const std::string& kind = in.choice(kProfileKind);
  if (kind == "straight" || kind == "table" || kind == "iso16281") return true;
  return in.has(kBlock + "design_load") &&
         (kind == "lundberg" || kind == "johns-gohar" || kind == "fujiwara-kawase");
}

// ISO/TS 16281 has no life with fewer laminae; for straight rollers the stress riser accounts for the roller
// ends.
void check_laminae(CheckedCase& in) {
  if (!has_all(in, {keys().laminae, kProfileKind, keys().life_method})) return;
  const int laminae = in.integer(keys().laminae);
  if (laminae == 0 || laminae >= bearing::rating::kLeastRatedLaminae) return;
  if (!in.is(kProfileKind, "straight") || !in.is(keys().life_method, "iso-16281")) return;
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

struct RollerProfile {
  Profile profile;
};

Profile found_profile(const ResolvedCase& in) {
  if (!in.has(kProfileKind)) return Straight{};
  const Roller roller = roller_of(in);
  const Profile own = own_profile(in, roller);
  require_sound(own);
  if (!in.has(kBlock + "drop") && has_own_depth(in)) return own;
  const Profile deep = with_drop(own, kDropPosition * 0.5 * roller.length, roller.drop);
  require_sound(deep);
  return deep;
}

}  // namespace

const Profile& roller_profile_of(const ResolvedCase& in) {
  return in.once<RollerProfile>([&] { return RollerProfile{found_profile(in)}; }).profile;
}

void check_profile(CheckedCase& in) {
  const std::string misaligned = first_of(in, "bearing.misalignment.");
  if (!misaligned.empty() && !in.has(keys().laminae))
    in.add_error_at(misaligned, "an entry without bearing.laminae",
                    "laminae, which it acts on, are required: for instance bearing.laminae: 40");
  check_laminae(in);
  const std::string profile = first_of(in, kBlock);
  if (!profile.empty() && !in.has(kProfileKind))
    in.add_error_at(profile, "a profile without bearing.profile.kind", "a kind of profile is required");
  if (!has_all(in, {kProfileKind, keys().roller_length, keys().roller_diameter, keys().pitch_diameter,
                    keys().radial_clearance}))
    return;
  try {
    roller_profile_of(in);
  } catch (const std::invalid_argument& error) {
    in.add_error(kProfileKind, error.what());
  }
}

}  // namespace orbearing::app
