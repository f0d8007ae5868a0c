// An FMU's archive, unpacked for as long as it is used.
#pragma once

#include <filesystem>

namespace orbearing::fmu {

/// Unpacks what running the FMU on this machine needs (description, resources, binaries of this platform)
/// into a folder of its own under the system's temporary folder (TMPDIR), which only this user can read and
/// which goes with the object. Nothing is written outside that folder, whatever the archive's names say.
class UnpackedFmu {
 public:
  /// Throws ForeignFmuError where the file is no archive, holds names that leave the folder, or unpacks to
  /// more than 2 GiB.
  explicit UnpackedFmu(const std::filesystem::path& file);
  ~UnpackedFmu();
  UnpackedFmu(const UnpackedFmu&) = delete;
  UnpackedFmu& operator=(const UnpackedFmu&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// The place of an entry below the folder into which it is unpacked. Throws ForeignFmuError where `name` is
/// empty, absolute, climbs with "..", names a drive or holds a backslash.
std::filesystem::path place_of_entry(const std::string& name);

}  // namespace orbearing::fmu
