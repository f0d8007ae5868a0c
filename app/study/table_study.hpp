// Results of a case tabulated over some of its inputs (coupling/analysis/result_table.hpp), the file that
// holds them, and their interpolation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/case/resolved_case.hpp"
#include "app/results/sweep_run.hpp"
#include "coupling/analysis/result_table.hpp"
#include "orbearing/table.hpp"

namespace orbearing::app {

inline constexpr const char* table_file_name = "table.json";

/// A result, tabulated by its logarithm where all first points have it above zero and it has a unit.
struct TabulatedResult {
  std::string name;  // column of a sweep's table
  std::string unit;
  bool by_logarithm = false;
  double scale =
      1.0;  // [unit]  of errors that are not by logarithm: the largest magnitude of the first points
  // Errors at the independent check points in cells within the bound: divided by the value, or by `scale`.
  double largest_error = 0.0, mean_error = 0.0;
  double within_bound_share = 1.0, within_stated_share = 1.0;

  double tabulated(double value) const;                // not finite where it has none
  double value(double tabulated) const;                // [unit]
  double error(double value, double tabulated) const;  // [unit]
};

struct TabulatedCase {
  std::string file;  // in messages
  std::string case_name, case_hash, program_version, instruction_set, fidelity;
  std::string resolved_case;
  std::vector<TableInput> inputs;
  std::vector<TabulatedResult> results;
  double bound = 0.01;   // [-]
  double scatter = 0.0;  // [-]  of computed values
  std::size_t points = 0, failed_points = 0;
  std::size_t check_points = 0;  // independent ones within the bound
  analysis::ResultTable table;
};

void describe(described::Record& record, const TabulatedCase& table);

/// The text of a table's file, and back. Throws BadInput where the file is damaged or of another version.
std::string table_text(const TabulatedCase& table);
TabulatedCase read_table(const std::string& file);

/// An input as a coordinate of the table: -1 to 1 within its range.
class Coordinate {
 public:
  explicit Coordinate(const TableInput& input);
  double operator()(double value) const;

 private:
  const TableInput& input_;
  double range_;
};

/// A value of an input in its customary unit: "6000 rpm".
std::string in_customary(const TableInput& input, double value);

struct TableChoice {
  std::vector<std::string> over;     // PATH=FROM..TO; none: the ranges of the case's sweep
  std::vector<std::string> results;  // none: the life that results go by
  double bound = 0.01;               // [-]
  std::size_t points = 0;            // at most; 0: the default of quasi-static points
};

/// The case whose sweep has the two ends of each input. Throws BadInput.
ResolvedCase over_box(const ResolvedCase& resolved, const std::vector<std::string>& over);

/// A table as a sweep whose points are added where the table needs them.
class TableStudy {
 public:
  /// Throws BadInput as sweep_request(), and where ends, results or the number of points do not fit.
  TableStudy(const ResolvedCase& resolved, const std::string& fidelity, const TableChoice& choice);

  /// Computation for run_sweep(); shares the state of this study.
  SweepRequest request() const;
  /// Table after that computation.
  TabulatedCase result(const SweepOutcome& outcome) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace orbearing::app
