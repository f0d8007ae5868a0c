// FMUs that others made as participants of a co-simulation: a user's gears, shafts or whole machine drive
// our bearing.
//
//   ForeignSetup shaft;
//   shaft.file = "shaft.fmu";
//   shaft.ports = {{.port = {"planet.x", PortKind::translation, Gives::motion},
//                   .displacement = {"pos_x"}, .velocity = {"vel_x"}, .force = {"force_x"}}, ...};
//   shaft.values = {{"mass", 2.5}};
//   const auto participant = import_fmu(shaft);
#pragma once

#include <memory>

#include "coupling/cosim/participant.hpp"
#include "coupling/fmu/import/foreign_setup.hpp"

namespace orbearing::fmu {

/// Reads, unpacks and loads the FMU and checks the mapping; the instance is made by initialize(), anew at
/// each call. All errors are ForeignFmuError and begin with the name of the file.
///
/// Inputs over a window: FMUs of 2.0 that interpolate get the values at the beginning and the derivatives up
/// to ForeignSetup::slopes. For all others they are held, see ForeignQuantity::held: a mean force gives the
/// body the right momentum, a motion at the end of the window gives a force without delay.
///
/// save() gives the FMU's serialised state. Where it cannot serialise but keep states, the last 8 saved ones
/// are kept here, and restore() of an older one, or in another process, throws. Where it can do neither, both
/// throw: such an FMU takes part in schemes that do not repeat windows. After an error in advance() an FMU
/// without states is of no use until the next initialize().
std::unique_ptr<cosim::Participant> import_fmu(const ForeignSetup& setup);

/// Reads modelDescription.xml alone, without loading the library.
ForeignDescription describe_fmu(const std::filesystem::path& file);

}  // namespace orbearing::fmu
