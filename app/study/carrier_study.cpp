#include "app/study/carrier_study.hpp"

#include <stdexcept>

#include "app/case/described_case.hpp"
#include "app/errors.hpp"
#include "app/study/drivetrain_case.hpp"
#include "app/study/gear_case.hpp"

namespace orbearing::app {

namespace {

using gearset::spatial::CarrierMounting;
constexpr const char* kPositions = "gearset.carrier.bearing_positions";

void require_carrier(const ResolvedCase& in) {
  if (in.model() != planetary_drivetrain || in.shape().several || !in.shape().teeth || !in.shape().bearing)
    throw BadInput(in.file() + ": found " +
                   (in.model() == planetary_drivetrain ? "a case without one set with teeth and bearings"
                                                       : "the model " + in.choice("model")) +
                   "; required: planetary-drivetrain with one gearset and its bearing");
  if (!in.has(kPositions))
    throw BadInput(in.file() + ": " + kPositions +
                   ": missing; required: the positions of the carrier's bearings, as [-250 mm, 250 mm]");
}

void require_held_ring(const ResolvedCase& in, const gearset::dynamics::SetModel& model) {
  if (model.operation.speeds.ring == 0.0) return;
  throw BadInput(in.file() + ": gearset.fixed: found a rotating ring; required: ring, held by the housing");
}

}  // namespace

void describe(described::Record& record, const CarrierStudy& study) {
  describe(record, study.revolution);
}

CarrierStudy carrier_study(const ResolvedCase& resolved) {
  require_carrier(resolved);
  const auto mounting = from_case<CarrierMounting>(resolved);
  const study::PlanetaryDrivetrain drivetrain = drivetrain_without_gear_set(resolved);
  const gearset::dynamics::SetModel model = gear_model_of(resolved, drivetrain);
  require_held_ring(resolved, model);
  const study::DrivetrainGeometry geometry = study::derive(drivetrain);
  try {
    return {.revolution = study::carrier_revolution(
                study::spatial_set(drivetrain, model, geometry.gears.base_helix_angle, mounting),
                study::spatial_load(model, mounting), geometry.rating.ratings.dynamic_capacity,
                model.operation.speeds.planet_relative),
            .warnings = gear_warnings(resolved)};
  } catch (const std::invalid_argument& error) {
    throw BadInput(resolved.file() + ": " + error.what());
  } catch (const std::runtime_error& error) {
    throw ComputationFailed(resolved.text("name") + ": " + error.what());
  }
}

}  // namespace orbearing::app
