#include "coupling/analysis/planet_rating.hpp"

namespace orbearing::analysis {

namespace rating = bearing::rating;

namespace {

bool states_cleanliness(const LifeInputs& life) {
  return life.contamination_factor || life.cleanliness;
}
bool states_viscosity(const LifeInputs& life, const BearingOil& oil) {
  return life.viscosity_ratio || oil.kinematic_viscosity;
}

}  // namespace

std::optional<rating::StatedOil> stated_oil(const LifeInputs& life, const BearingOil& oil, double density) {
  if (!states_cleanliness(life) && !states_viscosity(life, oil)) return std::nullopt;
  rating::StatedOil stated{.viscosity_ratio = life.viscosity_ratio,
                           .contamination_factor = life.contamination_factor,
                           .lubrication = life.lubrication};
  if (!life.viscosity_ratio)
    stated.kinematic_viscosity = oil.kinematic_viscosity.value_or(oil.lubricant.viscosity / density);
  if (life.cleanliness) stated.cleanliness = *life.cleanliness;
  return stated;
}

bool cleanliness_is_assumed(const LifeInputs& life, const BearingOil& oil) {
  return states_viscosity(life, oil) && !states_cleanliness(life);
}

RatedBearing rated_bearing(const PlanetRating& in, double density, double roughness) {
  RatedBearing rated{.stated = in.capacities.ratings(),
                     .oil = stated_oil(in.life, in.oil, density),
                     .reliability_factor = rating::reliability_factor(in.life.reliability),
                     .method = in.life.method};
  rated.stated.reduction_factor = in.rollers.reduction_factor;
  rated.stated.stress_riser = in.rollers.stress_riser;
  if (in.viscosity_ratio_by == ViscosityRatioBy::film) rated.roughness = roughness;
  return rated;
}

}  // namespace orbearing::analysis
