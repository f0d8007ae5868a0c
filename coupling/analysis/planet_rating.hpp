// Inputs of the lives of planet bearings by the standards.
#pragma once

#include <optional>

#include "coupling/analysis/drivetrain.hpp"
#include "coupling/analysis/single_bearing.hpp"

namespace orbearing::analysis {

/// Origin of the viscosity ratio kappa.
enum class ViscosityRatioBy { speed, film };

constexpr described::Names<ViscosityRatioBy, 2> names_of(ViscosityRatioBy) {
  return {{{ViscosityRatioBy::speed, "speed"}, {ViscosityRatioBy::film, "film"}}};
}

/// Inputs besides those of the bearing and its motion.
struct PlanetRating {
  LifeInputs life;
  RollerLifeInputs rollers;
  StatedCapacities capacities;
  BearingOil oil;
  ViscosityRatioBy viscosity_ratio_by = ViscosityRatioBy::speed;
};
template <class Visitor>
void describe(Visitor& visit, PlanetRating& m) {
  using namespace described;
  members(visit, m, part(m.life), part(m.rollers), part(m.capacities), part(m.oil),
          input(m.viscosity_ratio_by, "life.viscosity_ratio_by",
                "source of kappa: speed and viscosity, or the ratio of the least computed film to "
                "contact.roughness, to the power of 1.3",
                {.reason = "as ISO 281 defines kappa; the film's own is its alternative"}));
}

/// The oil of a bearing for the modified life, of which a case may state the dynamic viscosity alone; none
/// where neither oil nor cleanliness is stated: then lives have no a_ISO.
/// @param density [kg/m^3] of the oil
std::optional<bearing::rating::StatedOil> stated_oil(const LifeInputs& life, const BearingOil& oil,
                                                     double density);
/// Whether a viscosity is stated and no cleanliness, which is assumed then.
bool cleanliness_is_assumed(const LifeInputs& life, const BearingOil& oil);

/// @param roughness [m] composite, of which kappa by the film is
RatedBearing rated_bearing(const PlanetRating& in, double density, double roughness);

}  // namespace orbearing::analysis
