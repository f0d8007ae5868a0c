// Results of a case over some of its inputs, tabulated by `orbearing table` with the error of each answer.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orbearing/case.hpp"

namespace orbearing {

namespace app {
struct TabulatedCase;
}

/// An input of a table with its range.
struct TableInput {
  std::string path;
  double from = 0.0, to = 0.0;  // [SI]
  bool by_logarithm = false;
};

struct TableQuery {
  std::optional<double> bound{};  // [-]  largest error of an answer; none: that of the table
  bool compute = true;            // else a query that the table cannot answer is refused
  int jobs = 0;                   // threads of these computations; 0: one for each core
};

struct TableAnswers {
  std::vector<double> values;  // [the unit that ends the result's name]; NaN where a computation failed
  std::vector<double> errors;  // [the same]  stated error of the table; scatter of a computed value
  std::vector<char> computed;  // 1 for a query outside the box or above the bound: by the program
  std::map<std::size_t, std::string> failures;  // reasons by the number of the query
};

/// Does not change; threads may share it.
class Table {
 public:
  /// A file table.json or the folder that holds it. Throws BadInput.
  static Table read(const std::string& file);

  const std::vector<TableInput>& inputs() const;
  std::vector<std::string> results() const;
  double bound() const;  // [-]
  /// The case of the table; an input that is not tabulated has the value in that case.
  const Case& stated() const { return stated_; }

  /// A result at each row of `values` [SI] (queries, inputs), the inputs fastest. Nothing is extrapolated: a
  /// query outside the box, or where the table's error is above the bound, is computed by the program. Throws
  /// BadInput where it may not be computed (TableQuery), or where the program has another version than the
  /// table.
  TableAnswers answers(const std::string& result, const std::vector<double>& values,
                       const TableQuery& query = {}) const;

 private:
  Table(std::shared_ptr<const app::TabulatedCase> content, Case stated);
  std::shared_ptr<const app::TabulatedCase> content_;
  Case stated_;
};

}  // namespace orbearing
