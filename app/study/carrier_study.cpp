#include "app/study/carrier_study.hpp"

#include <stdexcept>

#include "app/case/drivetrain_reader.hpp"
#include "app/case/input_keys.hpp"
#include "app/errors.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/spatial_modes.hpp"

namespace orbearing::app {

namespace {

// Reports an argument that the library refuses as a mistake of the case.
template <typename Call>
auto refused_as_input(const ResolvedCase& in, const Call& call) {
  try {
    return call();
  } catch (const std::invalid_argument& error) {
    throw BadInput(in.file() + ": " + error.what());
  }
}

}  // namespace

void require_carrier(const ResolvedCase& in) {
  if (in.model() != planetary_drivetrain || in.shape().several || !in.shape().teeth || !in.shape().bearing)
    throw BadInput(in.file() + ": found " +
                   (in.model() == planetary_drivetrain ? "a case without one set with teeth and bearings"
                                                       : "the model " + in.choice("model")) +
                   "; required: planetary-drivetrain with one gearset and its bearing");
  if (!in.has(keys().carrier_bearings))
    throw BadInput(in.file() + ": " + keys().carrier_bearings +
                   ": missing; required: the positions of the carrier's bearings, as [-250 mm, 250 mm]");
  if (stated_drivetrain(in).single().teeth.fixed_member != gearset::Member::ring)
    throw BadInput(in.file() + ": gearset.fixed: found a rotating ring; required: ring, held by the housing");
}

analysis::CarrierRevolution carrier_study(const ResolvedCase& resolved) {
  require_carrier(resolved);
  const analysis::NamedSet set = bearing_sets(resolved).front();
  if (!set.drivetrain.carrier_mounting)
    throw std::logic_error("carrier_study: of a case whose inputs were not asked for, require_used()");
  try {
    return refused_as_input(resolved,
                            [&] { return analysis::carrier_revolution(set.drivetrain, set.geometry); });
  } catch (const BadInput&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw ComputationFailed(resolved.text("name") + ": " + error.what());
  }
}

void describe_spatial_modes(described::Record& record, const ResolvedCase& resolved) {
  const analysis::NamedSet set = bearing_sets(resolved).front();
  describe(record, refused_as_input(resolved, [&] { return analysis::spatial_modes(set); }));
}

}  // namespace orbearing::app
