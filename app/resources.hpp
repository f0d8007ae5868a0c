// What the program reads beside itself: libraries of FMUs, shipped cases, the Python package; and who runs that.
#pragma once

#include <filesystem>

namespace orbearing::app {

/// Where things stand. The default is that of a program called orbearing in a folder "bin".
struct Resources {
  /// A build folder, or the prefix of an installation. Libraries of FMUs stand in its "lib/orbearing/fmu", cases
  /// of an installation in "share/orbearing/cases".
  std::filesystem::path folder;
  std::filesystem::path package;      // holds the folder "orbearing" of the Python package
  std::filesystem::path interpreter;  // of Python
};

/// Of a build folder or an installation.
Resources resources_of(const std::filesystem::path& folder);

const Resources& resources();

/// Takes others, for a program that is a part of another, as of Python's interpreter. To be called before the
/// first command.
void use_resources(Resources others);

}  // namespace orbearing::app
