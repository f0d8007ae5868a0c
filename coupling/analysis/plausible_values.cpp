#include "coupling/analysis/plausible_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "bearing/life/basic_life.hpp"
#include "bearing/life/life_modification.hpp"
#include "coupling/analysis/drivetrain_warnings.hpp"
#include "mechanics/constants.hpp"
#include "mechanics/number_text.hpp"

namespace orbearing::analysis {

namespace {

namespace rating = bearing::rating;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kStaticPressureMPa = 1e-6 * rating::static_pressure(rating::RollingElement::roller);
constexpr double kMillimetresPerMinute = 1e3 * 30.0 / constants::pi;  // mm rpm per m rad/s
constexpr double kMostTilt = 3.0;                                     // [mrad]
const std::string kOverTilted =
    "more than makers allow; state load.tilt where the shaft and its other bearing hold the ring";
const std::string kSkidding = "less than a hundredth of C, below which rolling elements skid";

}  // namespace

const std::vector<PlausibleRange>& plausible_ranges() {
  static const std::vector<PlausibleRange> ranges{
      // Hardened steel: hardness 700 HV is 6900 MPa, [ISO76] takes 4000 MPa for a permanent mark of D/10,000.
      {{{"contact_pressure_max_MPa", "pressure_max_MPa"}, "contact", "pressure", "MPa"},
       {-kNone, ""},
       {kStaticPressureMPa, "where rollers yield and elastic contact and life are not valid"},
       {-kNone, 10000.0, "above the hardness of bearing steel, where no elastic contact exists"}},
      // [ISO281] gives a_ISO from 0.1 on and takes 4 for all above.
      {{{"kappa"}, "life", "kappa", ""},
       {rating::kLeastViscosityRatio, "where ISO 281 gives no a_ISO and no modified life"},
       {50.0, "much more than lubrication requires: check the oil's viscosity and its unit"},
       {1e-4, 1e4, "check viscosity, temperature, speed and their units"}},
      // [ISO281] holds for P up to 0.5 C; makers' catalogues require a load of 0.01 C (balls) to 0.02 C
      // (rollers).
      {{{"C_over_P"}, "life", "C/P", ""},
       {2.0, "a load above the half of C, for which ISO 281 gives no life"},
       {100.0, kSkidding},
       {0.2, kNone, "the load is several times the rating C"}},
      // A turbine runs 1.8e5 h in 20 years; a test of a bearing some hours.
      {{{"life_h", "L10h", "L10rh", "L10mh", "L10mrh"}, "life", "life", "h"},
       {1.0, "which no machine is built for: check load, speed and their units"},
       {1e7, "over a thousand years: check load, speed and their units"},
       {1e-3, 1e12, "check power, speed and their units"}},
      // Makers allow 1 mrad to cylindrical rollers, 0.6 to 3 mrad to deep-groove balls.
      {{{"tilt_mrad"}, "load", "tilt of the inner ring", "mrad"},
       {-kMostTilt, kOverTilted},
       {kMostTilt, kOverTilted},
       {-kNone, kNone, ""}},
      // A molecule of oil is about 1 nm long; films of rolling contacts are 0.01 to 5 um.
      {{{"film_inner_um", "film_outer_um", "h_min_um"}, "film", "least film", "um"},
       {1e-3, "thinner than a molecule of oil"},
       {50.0, "far thicker than films of rolling contacts: check viscosity, speed and load"},
       {-kNone, 1e4, "check viscosity, speed, load and their units"}},
      // Lubrication by grease to 0.5e6, by oil jets to 1.5e6; main bearings of aero engines 2.5e6 to 3e6 mm
      // rpm.
      {{{"n_dm"}, "operation", "speed n d_m", "mm rpm"},
       {-kNone, ""},
       {1.5e6, "beyond usual lubrication of rolling bearings"},
       {-kNone, 6e6, "twice that of main bearings of aero engines"}},
      // Turbo gears to 200 m/s; above some 400 m/s a steel ring bursts by its own speed.
      {{{"pitch_line_speed_m_s"}, "operation", "pitch line speed against the carrier", "m/s"},
       {-kNone, ""},
       {200.0, "beyond usual turbo gears"},
       {-kNone, 400.0, "the speed at which a steel ring bursts"}},
      // [ISO6336Part3]: the tooth root is weakened below 1.2 times the tooth depth, 2.7 modules, and has no
      // strength below half of that depth, 1.1 modules.
      {{{kThinnestRim}, "gearset", "rim of a planet between roots and bore, in modules,", ""},
       {3.0,
        "which makes it oval and weakens the tooth roots: lives by a rigid rim are uncertain (use a smaller "
        "outside diameter, or compute gearset.planet_rim: elastic)"},
       {kNone, ""},
       {1.2, kNone, "a thinner rim bears no teeth"}},
      // Torque per module cubed, freed of face width and tooth number: F_n/(b m). The root stress is 4 to 5
      // times it;
      // case-hardened teeth bear some 100 to 250 MPa for good.
      {{{"unit_load_MPa"}, "gearset", "tooth force over face width and module", "MPa"},
       {1e-3, "teeth that carry next to nothing: check power, speed and their units"},
       {400.0, "more than teeth of hardened steel bear: check power, speed, module and face width"},
       {-kNone, 2000.0, "a root stress of some 9000 MPa, above the strength of any steel"}}};
  return ranges;
}

const PlausibleRange* range_of(const std::string& key) {
  const std::vector<PlausibleRange>& ranges = plausible_ranges();
  const auto found = std::find_if(ranges.begin(), ranges.end(), [&](const PlausibleRange& range) {
    return std::find(range.of.keys.begin(), range.of.keys.end(), key) != range.of.keys.end();
  });
  return found == ranges.end() ? nullptr : &*found;
}

namespace {

std::string number(double value) {
  constexpr int digits = 6;
  return mechanics::significant(value, digits);
}

std::string with_unit(double value, const PlausibleRange& range) {
  return range.of.unit.empty() ? number(value) : number(value) + " " + range.of.unit;
}

std::string beyond(const PlausibleRange& range, const PlausibleRange::Bound& bound, const char* side) {
  return range.of.block + ": " + range.of.name + " " + side + " " + with_unit(bound.value, range) + ", " +
         bound.why;
}

// Empty for a value that a machine can have.
std::string implausible_text(const PlausibleRange& range, double value) {
  if (value >= range.outer.least && value <= range.outer.most) return "";
  const bool low = value < range.outer.least;
  return std::string(kImplausible) + range.of.name + " " + with_unit(value, range) + " (" +
         (low ? "at least " : "at most ") + with_unit(low ? range.outer.least : range.outer.most, range) +
         ": " + range.outer.reason + ")";
}

// ISO 281 includes neither clearance nor tilt. Empty where the lives by the loads of all elements are not far
// shorter.
std::string uneven_text(const std::vector<Observation>& observed) {
  constexpr double far_shorter = 0.5;
  const auto value = [&](std::string_view key) {
    const auto found = std::ranges::find(observed, key, &Observation::key);
    return found == observed.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
  };
  for (const auto& [reference, basic] : {std::pair{"L10mrh", "L10mh"}, std::pair{"L10rh", "L10h"}})
    if (const double ratio = value(reference) / value(basic); std::isfinite(ratio))
      return ratio < far_shorter
                 ? std::string("life: ") + reference + " is " + mechanics::significant(100.0 * ratio, 2) +
                       " % of " + basic +
                       ". Clearance, preload, tilt or profile load the rolling elements unevenly, which " +
                       basic + " does not include. Check them; design by " + reference
                 : "";
  return "";
}

}  // namespace

std::string rare_text(const PlausibleRange& range, double value) {
  if (value < range.rare_low.value) return beyond(range, range.rare_low, "below");
  if (value > range.rare_high.value) return beyond(range, range.rare_high, "above");
  return "";
}

Judgement judge(const std::vector<Observation>& observed) {
  Judgement judgement;
  if (std::string uneven = uneven_text(observed); !uneven.empty())
    judgement.warnings.push_back(std::move(uneven));
  for (const Observation& one : observed) {
    const PlausibleRange* range = range_of(one.key);
    if (range == nullptr || !std::isfinite(one.value)) continue;
    const std::string rare = rare_text(*range, one.value);
    if (rare.empty()) continue;
    const std::string text = rare + ": " + with_unit(one.value, *range);
    const bool said = std::any_of(judgement.warnings.begin(), judgement.warnings.end(),
                                  [&](const std::string& warning) { return warning.starts_with(rare); });
    if (!said) judgement.warnings.push_back(text);
    if (const std::string far = implausible_text(*range, one.value); !far.empty() && judgement.status == "ok")
      judgement.status = far;
  }
  return judgement;
}

namespace {

void add_meshes(const gearset::PlanetarySet& set, const gearset::WorkingGeometry& geometry,
                const gearset::MeanLoads& loads, std::vector<Observation>& found) {
  found.push_back({"pitch_line_speed_m_s", std::abs(loads.planet_speed_relative) *
                                               planet_working_radius(geometry, geometry.sun_mesh)});
  found.push_back({"unit_load_MPa", 1e-6 * std::abs(loads.normal_force) / (set.face_width * set.module)});
}

}  // namespace

Observation observed_speed(double relative_speed, double pitch_diameter) {
  return {"n_dm", kMillimetresPerMinute * std::abs(relative_speed) * pitch_diameter};
}

std::vector<Observation> observations(const std::vector<NamedSet>& sets) {
  std::vector<Observation> found;
  for (const NamedSet& set : sets) {
    const gearset::MeanLoads loads = bearing_duty(set.drivetrain, set.geometry).gears;
    found.push_back(observed_speed(loads.planet_speed_relative, set.drivetrain.bearing.pitch_diameter));
    found.push_back({kThinnestRim, set.geometry.rim_over_module});
    add_meshes(set.drivetrain.set, set.geometry.gears, loads, found);
  }
  return found;
}

std::vector<Observation> observations_of_gears(const PlanetaryDrivetrain& drivetrain) {
  std::vector<Observation> found;
  const gearset::WorkingGeometry geometry = gearset::working_geometry(drivetrain.set);
  add_meshes(drivetrain.set, geometry, gearset::mean_loads(drivetrain.set, geometry, drivetrain.drive),
             found);
  return found;
}

std::vector<std::string> thin_rim_warnings(const std::vector<NamedSet>& sets) {
  std::vector<std::string> warnings;
  for (const NamedSet& set : sets)
    for (const std::string& text : judge({{kThinnestRim, set.geometry.rim_over_module}}).warnings)
      warnings.push_back(set_prefix(set.name) + text);
  return warnings;
}

}  // namespace orbearing::analysis
