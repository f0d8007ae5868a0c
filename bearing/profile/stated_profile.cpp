#include "bearing/profile/stated_profile.hpp"

#include <algorithm>

namespace orbearing::bearing::profile {

namespace {

double station_of(double length) {
  return kDropPosition * 0.5 * length;
}

bool is_logarithmic_for_a_load(Kind kind) {
  return kind == Kind::lundberg || kind == Kind::johns_gohar || kind == Kind::fujiwara_kawase;
}

// Kinds whose depth lies in other entries than the drop.
bool has_own_depth(const StatedProfile& stated, Kind kind) {
  if (kind == Kind::straight || kind == Kind::table || kind == Kind::iso16281) return true;
  return stated.design_load && is_logarithmic_for_a_load(kind);
}

FujiwaraKawase fujiwara_kawase(const StatedProfile& stated, const DesignLoad& design) {
  const double k1 = stated.k1.value_or(1.0);
  const double end = k1 * drop(johns_gohar_for(design), 0.5 * design.length);
  return fujiwara_kawase_for(design, k1, stated.k2.value_or(1.0), stated.end_drop.value_or(end));
}

// With the depth that its own entries give it; one that has none yet is as deep at its end as it shall be at
// kDropPosition.
Profile own_profile(const StatedProfile& stated, Kind kind, double diameter, double depth,
                    const DesignLoad& design) {
  const double l = design.length, at_end = std::max(depth, 1e-9);
  switch (kind) {
    case Kind::straight:
      break;
    case Kind::chamfer:
      return Chamfer{l, stated.chamfer_length.value_or(0.1 * l), at_end};
    case Kind::circular:
      return CircularCrown{l, at_end};
    case Kind::straight_circular:
      return StraightCircular{l, stated.straight_length.value_or(0.6 * l), at_end};
    case Kind::lundberg:
      return lundberg_for(design);
    case Kind::johns_gohar:
      return johns_gohar_for(design);
    case Kind::iso16281:
      return Iso16281{l, diameter, 1.0};
    case Kind::fujiwara_kawase:
      return fujiwara_kawase(stated, design);
    case Kind::table:
      return Table{.x = stated.x, .drop = stated.drops};
  }
  return Straight{};
}

// The stated load, else that of the depth.
double design_load(const StatedProfile& stated, double depth, double standard, const DesignLoad& design) {
  return stated.design_load ? *stated.design_load
                            : design_load_of_drop(design, depth > 0.0 ? depth : standard);
}

}  // namespace

Profile profile_of(const StatedProfile& stated, double diameter, DesignLoad design) {
  if (!stated.kind) return Straight{};
  const double station = station_of(design.length);
  const double standard = drop(Iso16281{design.length, diameter, 1.0}, station);
  const double depth = stated.drop.value_or(standard);
  if (is_logarithmic_for_a_load(*stated.kind)) design.load = design_load(stated, depth, standard, design);
  Profile own = own_profile(stated, *stated.kind, diameter, depth, design);
  require_sound(own);
  if (!stated.drop && has_own_depth(stated, *stated.kind)) return own;
  Profile deep = with_drop(own, station, depth);
  require_sound(deep);
  return deep;
}

}  // namespace orbearing::bearing::profile
