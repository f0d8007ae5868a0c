// Resources of the program: libraries of FMUs, shipped cases, files of the page, the Python package and its
// interpreter.
#pragma once

#include <filesystem>

namespace orbearing::app {

/// Locations of resources. The default is that of a program called orbearing in a folder "bin".
struct Resources {
  /// A build folder, or the prefix of an installation. Libraries of FMUs are in its "lib/orbearing/fmu",
  /// cases of an installation in "share/orbearing/cases".
  std::filesystem::path folder;
  std::filesystem::path package;      // holds the folder "orbearing" of the Python package
  std::filesystem::path interpreter;  // of Python
};

/// Resources of a build folder or an installation.
Resources resources_of(const std::filesystem::path& folder);

const Resources& resources();

/// The folder of cases: of a wheel or of the source tree this program was built from, or beside an installed
/// program.
std::filesystem::path shipped_cases();

/// Folder of the page's files: of a wheel or of the source tree, or beside an installed program.
std::filesystem::path page_files();

/// Takes others, for a program that is a part of another, as of Python's interpreter. To be called before the
/// first command.
void use_resources(Resources others);

}  // namespace orbearing::app
