#include "app/study/carrier_study.hpp"

#include <stdexcept>

#include "app/errors.hpp"
#include "app/study/planetary_case.hpp"

namespace orbearing::app {

namespace {

using gearset::spatial::SpatialMode;
namespace dimension = described::dimension;
constexpr const char* kPositions = "gearset.carrier.bearing_positions";

void describe_mode(described::Record& row, const SpatialMode& mode) {
  const auto share = [&](const char* name, const char* meaning, double value) {
    row.value(name, dimension::ratio, meaning, value);
  };
  row.value("frequency_Hz", dimension::cycles, "natural frequency", mode.frequency);
  row.value("multiplicity", "modes of this frequency", mode.multiplicity);
  share("in_plane", "share of the kinetic energy: displacement across the axis and rotation about it",
        mode.in_plane);
  share("axial", "the same along the axis", mode.axial);
  share("tilting", "the same of tilts", mode.tilting);
  share("carrier", "the same of the carrier", mode.carrier);
  share("sun", "the same of the sun", mode.sun);
  share("ring", "the same of the ring", mode.ring);
  share("planets", "the same of the planets", mode.planets);
  row.array(
         "shape", dimension::ratio,
         "x, y, z and rotations about them times the centre distance of carrier, sun, planets and ring over "
         "the largest, in a frame of the carrier",
         {"body", "freedom"}, mode.shape)
      .detail = true;
}

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
  if (!in.has(kPositions))
    throw BadInput(in.file() + ": " + kPositions +
                   ": missing; required: the positions of the carrier's bearings, as [-250 mm, 250 mm]");
  if (in.choice("gearset.fixed") != "ring")
    throw BadInput(in.file() + ": gearset.fixed: found a rotating ring; required: ring, held by the housing");
}

study::CarrierRevolution carrier_study(const ResolvedCase& resolved) {
  require_carrier(resolved);
  const study::NamedSet set = bearing_sets(resolved).front();
  if (!set.drivetrain.carrier_mounting)
    throw std::logic_error("carrier_study: of a case whose inputs were not asked for, require_used()");
  try {
    return refused_as_input(resolved,
                            [&] { return study::carrier_revolution(set.drivetrain, set.geometry); });
  } catch (const BadInput&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw ComputationFailed(resolved.text("name") + ": " + error.what());
  }
}

void describe_spatial_modes(described::Record& record, const ResolvedCase& resolved) {
  const study::NamedSet set = bearing_sets(resolved).front();
  const auto modes = refused_as_input(resolved, [&] {
    return gearset::spatial::modes_at_rest(
        study::moving_set(set.drivetrain, set.drivetrain.gear_set(), set.geometry.gears.base_helix_angle));
  });
  record.table("modes", "spatial_mode", "natural modes", modes, describe_mode);
}

}  // namespace orbearing::app
