// Quantities of a planetary set and its planet bearings that follow from the inputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/analysis/multi_stage.hpp"
#include "coupling/analysis/set_gears.hpp"
#include "mechanics/record.hpp"

namespace orbearing::analysis {

/// A value, or why it is not computed; neither where it has no meaning.
template <class Value>
struct Computed {
  std::optional<Value> value{};
  std::string failure{};
};

/// A speed of the input with its text.
struct NamedSpeed {
  std::string text;    // "6000 rpm"
  double speed = 0.0;  // [rad/s]
};

/// From the shelf to the running bearing, and how it runs at other speeds.
struct MountedClearance {
  bearing::ClearanceChain chain;
  std::vector<std::pair<std::string, double>> at_speeds{};  // [m]  by the text of the speed
};

/// Effect of uneven load sharing: one pin displaced tangentially by js7 of ISO 286-1 at the centre distance.
struct OnePinOff {
  double error = 0.0;          // [m]
  bool without_tilt = false;   // the computed tilt is left out
  double load_share = 0.0;     // [-]  K_gamma: load of the most loaded planet over the mean
  double shortest_life = 0.0;  // [h]  governing life
  bearing::rating::Life governing = bearing::rating::Life::lundberg_palmgren;
};

/// A set with planet bearings.
struct SetQuantities {
  NamedSet set;
  Computed<MountedClearance> clearance;  // none: the clearance is stated as that in operation
  Computed<BearingDuty> duty;
  Computed<OnePinOff> one_pin_off;  // none: planets carry unequal loads as stated, or must carry equal ones
};

/// @param speeds at which the clearance is given besides
SetQuantities quantities_of(const NamedSet& set, const SetGears& gears,
                            const std::vector<NamedSpeed>& speeds = {});
void describe(described::Record& record, const SetQuantities& of);

/// A set without planet bearings.
struct GearSetQuantities {
  PlanetaryDrivetrain drivetrain;
  DrivetrainGeometry geometry;  // of gears and planet alone
  gearset::MeanLoads loads;
};

/// A single set, or one of several by its part in the flow of power.
GearSetQuantities quantities_of_gears(const PlanetaryDrivetrain& drivetrain);
void describe(described::Record& record, const GearSetQuantities& of);

}  // namespace orbearing::analysis
