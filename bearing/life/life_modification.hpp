// Life modification factor a_ISO of [ISO281]: lubrication, contamination and fatigue load limit.
#pragma once

#include <optional>

#include "bearing/life/basic_life.hpp"
#include "mechanics/described.hpp"

namespace orbearing::bearing::rating {

/// The least kappa [-] for which [ISO281] gives an a_ISO.
inline constexpr double kLeastViscosityRatio = 0.1;
/// The largest kappa [-] that counts, in a_ISO and in e_C.
inline constexpr double kLargestViscosityRatio = 4.0;
/// The smallest a_ISO [-] of [ISO281], without any fatigue limit, and its largest.
inline constexpr double kLeastLifeModification = 0.1;
inline constexpr double kLargestLifeModification = 50.0;

/// Viscosity nu_1 [m^2/s] that a bearing of `pitch_diameter` [m] needs at `speed` [rad/s] between its rings:
/// in mm^2/s, rpm and mm 45000 n^-0.83 d_m^-0.5 below 1000 rpm, else 4500 n^-0.5 d_m^-0.5. (The two differ by
/// 2 % where they meet.) Throws std::invalid_argument at rest.
double required_viscosity(double speed, double pitch_diameter);

/// Fatigue load limit C_u [N] in the simplified form of [ISO281]: C_0/22 for balls, C_0/8.2 for rollers, less
/// by (100 mm/d_m)^0.5 or ^0.3 above d_m = 100 mm. `static_capacity` [N], `pitch_diameter` [m].
double fatigue_load_limit(RollingElement element, double static_capacity, double pitch_diameter);

/// Lubrication and cleaning of the oil.
enum class Lubrication { circulating_oil, oil_bath, grease };

constexpr described::Names<Lubrication, 3> names_of(Lubrication) {
  return {{{Lubrication::circulating_oil, "circulating-oil"},
           {Lubrication::oil_bath, "oil-bath"},
           {Lubrication::grease, "grease"}}};
}

/// Level of cleanliness, from best to worst. Oil: ISO 4406 codes -/13/10, -/15/12, -/17/14, -/19/16 and, for
/// oil baths only, -/21/18; circulating oil with filters of beta_6 = 200, beta_12 = 200, beta_25 = 75 and
/// beta_40 = 75. Grease: high, normal, slight to typical contamination, severe, very severe.
enum class Cleanliness { highest, high, medium, low, lowest };

/// In words, and by the equivalent codes where oil circulates.
constexpr described::Names<Cleanliness, 10> names_of(Cleanliness) {
  return {{{Cleanliness::highest, "highest"},
           {Cleanliness::high, "high"},
           {Cleanliness::medium, "medium"},
           {Cleanliness::low, "low"},
           {Cleanliness::lowest, "lowest"},
           {Cleanliness::highest, "-/13/10"},
           {Cleanliness::high, "-/15/12"},
           {Cleanliness::medium, "-/17/14"},
           {Cleanliness::low, "-/19/16"},
           {Cleanliness::lowest, "-/21/18"}}};
}

/// Contamination factor e_C [-] for kappa [-] and d_m [m]: a (1 - c/d_m^(1/3)), a = min(b kappa^0.68
/// d_m^0.55, 1), d_m in mm, of annex A of [ISO281]; kappa above 4 counts as 4. Coefficients b and c are from
/// memory of the annex. Never negative; not a number where kappa is none. Throws std::invalid_argument for a
/// level that the annex does not have.
double contamination_factor(Lubrication lubrication, Cleanliness cleanliness, double kappa,
                            double pitch_diameter);

/// Input of a_ISO besides the loads.
struct OilCondition {
  double viscosity_ratio = 0.0;       // [-]  kappa: viscosity at running temperature over the required one
  double contamination_factor = 0.0;  // [-]  e_C
};

/// Stated film and cleanliness.
struct StatedOil {
  std::optional<double> viscosity_ratio{};       // [-]      kappa; none: of the viscosity and the speed
  double kinematic_viscosity = 0.0;              // [m^2/s]  at running temperature
  std::optional<double> contamination_factor{};  // [-]  e_C; none: by the two below
  Lubrication lubrication = Lubrication::circulating_oil;
  Cleanliness cleanliness = Cleanliness::high;
};

/// Both for rings that turn at `speed` [rad/s] against each other. Throws as the functions above do.
OilCondition oil_condition(const StatedOil& oil, double speed, double pitch_diameter);

/// kappa [-] of a film: (least film/composite roughness)^1.3, as [ISO281] has it. Both [m].
double viscosity_ratio_of_film(double least_film, double roughness);

/// a_ISO [-] of radial bearings for kappa [-] and contamination factor times fatigue load limit over
/// equivalent load e_C C_u/P [-]. From 0.1 to 50; kappa above 4 counts as 4. Throws std::invalid_argument for
/// kappa below 0.1, where the standard gives none.
double life_modification_factor(RollingElement element, double kappa, double fatigue_ratio);

}  // namespace orbearing::bearing::rating
