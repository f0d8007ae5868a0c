// From a resolved case to the numbers of an FMU.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "coupling/fmu/export/description.hpp"
#include "coupling/fmu/number_table.hpp"

namespace orbearing::app {

/// One bearing of one planet, its speeds and its load at the start those of the case's operating point.
/// Throws BadInput for a case of another model, of several sets, without bearing or with inputs that a driven
/// bearing does not include, as require_used().
fmu::NumberTable bearing_numbers(const ResolvedCase& resolved);

/// The gear set with its planet bearings left out; at the start they hold the mean loads of the case. Throws
/// BadInput for a case of another model, of several sets, without teeth or with what they do not include.
fmu::NumberTable gear_numbers(const ResolvedCase& resolved);

// An FMU as a file: what is packed, and where the libraries inside it come from.

/// The library of one platform, as it was built beside the program.
struct FmuLibrary {
  std::string platform;  // folder inside the FMU
  std::string file;      // name inside the FMU
  std::string content;
};

/// The library for this platform and, with `windows`, the one for Windows. A missing one is built where a
/// program build_<platform> is in the same folder, with its progress on standard error unless `quiet`. Throws
/// ComputationFailed where there is none.
std::vector<FmuLibrary> fmu_libraries(const fmu::NumberTable& numbers, fmu::Interface interface, bool windows,
                                      bool quiet);

/// The archive's bytes.
std::string fmu_content(const fmu::NumberTable& numbers, const fmu::DescriptionOptions& options,
                        const std::vector<FmuLibrary>& libraries);

}  // namespace orbearing::app
