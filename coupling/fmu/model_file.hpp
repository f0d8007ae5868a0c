// The file with a model's numbers among the resources of an unpacked FMU.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace orbearing::fmu {

// Why a call of the C interface was not carried out.

/// A time in a message; by default with all digits in which times of a run differ.
inline std::string seconds(double value, int digits = 15) {
  std::ostringstream text;
  text.precision(digits);
  text << value << " s";
  return text.str();
}

/// As both versions of FMI number them.
enum class Status { ok, warning, discard, error, fatal };

/// Discard: the step could not be computed, the instance is unchanged. Error: the call was wrong.
struct Refused : std::runtime_error {
  Refused(Status how, const std::string& reason) : std::runtime_error(reason), status(how) {}
  explicit Refused(const std::string& reason) : Refused(Status::error, reason) {}
  Status status;
};

inline constexpr const char* kModelFile = "model.txt";

/// Folder of a resource location as FMI 2.0 gives it, a URI with the scheme file (%xx decoded), or as FMI 3.0
/// does, a path. Throws Refused for NULL, other schemes, other hosts and broken %xx.
std::string resource_folder(const char* location);

/// Throws Refused where the file cannot be read.
std::string read_model(const std::string& folder);

}  // namespace orbearing::fmu
