// expected.yaml beside a case: published numbers, and other readings of what the source leaves open.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/study/named_change.hpp"
#include "mechanics/described.hpp"

namespace orbearing::app {

/// Evidence for a number that is compared with ours.
enum class EvidenceKind {
  measurement,     // a measured value
  program,         // computed by another program or by the source's own model
  worked_example,  // a printed example or table of a textbook, standard or catalogue
  closed_form,     // a formula
  recomputed,      // from the source's formulas and data, by scripts independent of this project
};

/// As expected.yaml writes them, in the order in which they are listed.
constexpr described::Names<EvidenceKind, 5> names_of(EvidenceKind) {
  return {{{EvidenceKind::measurement, "measurement"},
           {EvidenceKind::program, "program"},
           {EvidenceKind::worked_example, "worked-example"},
           {EvidenceKind::closed_form, "closed-form"},
           {EvidenceKind::recomputed, "recomputed"}}};
}

/// Whether numbers of this kind are values of other sources: formulas and recomputed numbers are not.
bool counts(EvidenceKind kind);

/// One published number.
struct PublishedValue {
  std::string source;  // with its key in REFERENCES.md
  EvidenceKind kind = EvidenceKind::recomputed;
  std::string of;        // class of the quantity: "natural frequency"; "trend" where only a direction is claimed
  std::string quantity;  // a name that the validation table can compute, or COMMAND:/json/pointer
  std::string meaning;
  std::optional<double> value;  // none: the source has it, the project cannot compare it yet
  double tolerance = 0.0;       // [-]  relative
  std::optional<double> scatter{};  // [-]  relative standard deviation of the measurement
  std::vector<std::string>
      settings{};        // path=value  of the case, where the number belongs to a variant of it
  // path=value  of another variant: the number is the quantity over that under these, or of a trend 1 where
  // the quantity is larger than under these and 0 where it is not
  std::vector<std::string> against{};
  std::string fidelity = "quasi-static";  // of the command, where the quantity is COMMAND:/json/pointer
  std::string why{};     // it is missed
  bool memory = false;   // remembered, not read
  bool fitted = false;   // constants of the case were identified from it, among others

  bool is_trend() const { return of == "trend"; }
};

/// Command and JSON pointer of a quantity such as "run:/life_h"; none where it is a name.
struct ResultPointer {
  std::string command;
  std::string pointer;
};
std::optional<ResultPointer> result_pointer(const std::string& quantity);

/// Readings that affect the motion in time alone, and the speeds at which they are compared.
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

/// The case files that `names` (files or folders) refer to; where `names` is empty, all shipped cases with
/// published numbers, in `cases` and in `cases/validation`.
std::vector<std::string> case_files(const std::vector<std::string>& names);

/// expected.yaml of the shipped case called `name`; the file need not exist.
std::string shipped_expected(const std::string& name);

/// expected.yaml beside a case file.
std::string expected_beside(const std::string& case_file);

}  // namespace orbearing::app
