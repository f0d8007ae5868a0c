// expected.yaml beside a case: published numbers, and other readings of what the source leaves open.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/named_change.hpp"

namespace orbearing::app {

/// Where a number that ours is compared with comes from.
enum class Evidence {
  published,   // printed by the source, or a result of a program of others
  recomputed,  // from the source's formulas and data, by scripts independent of this project
};

/// One published number.
struct PublishedValue {
  std::string source;    // with its key in REFERENCES.md
  std::string quantity;  // a name that the validation table knows how to compute
  std::string meaning;
  std::optional<double> value;  // none: the source has it, the project cannot compare it yet
  double tolerance = 0.0;       // [-]  relative
  bool trend = false;           // only a direction is claimed
  Evidence evidence = Evidence::published;
  std::vector<std::string>
      settings{};  // path=value  of the case, where the number belongs to a variant of it
};

/// Readings that only the motion in time feels, and where they are looked at.
struct MotionPlan {
  std::string fidelity = "monolithic";
  std::vector<double> speed_rpm;
  std::vector<NamedChange> alternatives;
};

struct ExpectedFile {
  std::vector<PublishedValue> published;
  std::vector<NamedChange> alternatives;  // other readings of single assumptions
  std::optional<MotionPlan> motion{};
};

/// Reads `file`; empty where there is none. Throws BadInput with file and line where it is not as described
/// here.
ExpectedFile read_expected(const std::string& file);

/// The case files that `names` (files or folders) stand for; all that ship where `names` is empty.
std::vector<std::string> case_files(const std::vector<std::string>& names);

/// expected.yaml of the shipped case called `name`; the file need not exist.
std::string shipped_expected(const std::string& name);

/// expected.yaml beside a case file.
std::string expected_beside(const std::string& case_file);

}  // namespace orbearing::app
