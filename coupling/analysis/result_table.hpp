// Results tabulated over a box of inputs: sparse polynomials in cells, with an error measured in each cell.
//
// All inputs are coordinates from -1 to 1. With the local coordinates t of a cell a result is
//
//   (1)  y(t) = sum over degrees k of w_k prod_i h_(k_i)(t_i),   h_m(t) = prod_(j<m) (t - t_j)/(t_m - t_j)
//
// on the nodes t_m of [Chkifa2013]: those of Clenshaw and Curtis, one after the other. Each term has one
// point, and its weight is the surplus there: the computed value less that of all terms before. The set of
// degrees grows where the surplus is large, by dimension [Gerstner2003]. A cell that needs too many terms, as
// across a kink, is halved. Check points, which no term uses, measure the error of each cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace orbearing::analysis {

inline constexpr std::size_t kMostTableInputs = 6;
inline constexpr std::size_t kMostTableDegree = 16;  // of one input in one cell

using TablePoint = std::array<double, kMostTableInputs>;          // [-]  -1 to 1; 0 beyond the inputs in use
using TableDegrees = std::array<std::uint8_t, kMostTableInputs>;  // of one term

/// The node of degree m [-]; the first m + 1 nodes give a polynomial of degree m.
double table_node(std::size_t m);

/// Error of what has no value.
inline constexpr double kNoTableValue = std::numeric_limits<double>::max();

struct TableCell {
  TablePoint lower{}, upper{};
  std::vector<TableDegrees> terms;  // in ascending order
  std::vector<double> weights;      // (results, terms)
  std::vector<double> error;        // (results)  kNoTableValue: the cell has no values
};

/// A halved part of the box. A half is a split, or ~(number of a cell) where it is negative.
struct TableSplit {
  std::size_t input = 0;
  double at = 0.0;  // [-]  where it is halved
  int below = 0, above = 0;
};

struct TableValue {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = kNoTableValue;  // outside the box
};

/// Does not change; threads may share it.
class ResultTable {
 public:
  ResultTable() = default;
  /// `splits`: the whole box first; none: one cell is the box. Throws std::invalid_argument where the parts
  /// do not fit each other.
  ResultTable(std::size_t inputs, std::size_t results, std::vector<TableSplit> splits,
              std::vector<TableCell> cells);

  std::size_t inputs() const { return inputs_; }
  std::size_t results() const { return results_; }
  const std::vector<TableSplit>& splits() const { return splits_; }
  const std::vector<TableCell>& cells() const { return cells_; }

  TableValue at(const TablePoint& point, std::size_t result) const;
  /// Volume of the cells whose error is at most `bound` for all results, over that of the box [-].
  double share_within(double bound) const;

 private:
  struct Steps {
    TableDegrees most{};  // degrees of each input
    std::vector<std::uint8_t>
        first;  // of each term: the first input whose degree is not that of the term before
  };
  std::size_t cell_of(const TablePoint& point) const;
  std::size_t inputs_ = 0, results_ = 0;
  std::vector<TableSplit> splits_;
  std::vector<TableCell> cells_;
  std::vector<Steps> steps_;
};

/// Target of a table. Values and errors have the unit of the results, which are all alike in it.
struct TableTarget {
  std::size_t inputs = 1, results = 1;
  double bound = 0.01;  // error at which a cell is finished
  std::size_t most_points = 50000;
  double scatter = 0.0;          // of the computed values: no cell has a smaller error
  std::size_t checks = 24;       // check points that a cell begins with
  std::size_t box_checks = 400;  // further ones over the box, before its cells are finished
  std::uint64_t seed = 1;        // of the check points
};

/// The least number of points of a table.
inline std::size_t table_first_points(std::size_t inputs, std::size_t checks) {
  return (inputs + 1) * (inputs + 2) / 2 + checks;
}

/// Builds a table round by round. The same values give the same points and the same table.
class TableBuilder {
 public:
  explicit TableBuilder(const TableTarget& target);

  /// Points to compute next; none: the table is finished, or the number of points is reached.
  std::vector<TablePoint> next();
  /// Values (points of next(), results); NaN where a point has none.
  void take(const std::vector<std::vector<double>>& values);

  ResultTable table() const;

 private:
  struct Term {
    std::vector<double> value, weight;  // (results)
    double surplus = 0.0;               // largest contribution to a result
    bool accepted = false;              // its neighbours of higher degree have been computed
  };
  struct Check {
    TablePoint point;
    std::vector<double> value, miss;  // (results)
  };
  struct Cell {
    TablePoint lower{}, upper{};
    int depth = 0;
    std::map<TableDegrees, Term> terms;
    std::vector<Check> checks;
    std::vector<double> error;  // (results)
    std::vector<TableDegrees> wanted;
    std::vector<TablePoint> wanted_checks;
    std::size_t random_checks = 0;  // so far
    bool failed = false, finished = false;
    // Number of consecutive checks within the bound, at check points that were not used for the terms: at
    // random, in its corners and near the largest errors.
    std::size_t confirmed = 0;
    std::size_t split_input = 0;
    std::size_t below = 0;  // number of its lower half; the upper one follows; 0: not halved
  };

  TablePoint point_of(const Cell& cell, const TableDegrees& degrees) const;
  std::vector<double> sum_of_terms(const Cell& cell, const TablePoint& point) const;
  void want_first_points(Cell& cell);
  void want_checks(Cell& cell, std::size_t count);
  void want_check(Cell& cell, const TablePoint& middle, double radius);
  void want_corners(Cell& cell);
  void want_checks_near_worst(Cell& cell, double radius);
  bool is_admissible(const Cell& cell, const TableDegrees& degrees) const;
  bool want_more_terms(Cell& cell);
  void decide(std::size_t cell);
  void halve(std::size_t cell);
  std::size_t roughest_input(const Cell& cell) const;
  void add_term(Cell& cell, const TableDegrees& degrees, const std::vector<double>& value);
  void estimate_error(Cell& cell) const;
  int add_cell(const Cell& cell, std::vector<TableCell>& cells) const;
  int add_part(const Cell& cell, std::vector<TableSplit>& splits, std::vector<TableCell>& cells) const;

  TableTarget target_;
  std::vector<Cell> cells_;
  std::size_t given_ = 0;  // points so far
  bool exhausted_ = false;
};

/// Random numbers in [-1, 1], the same on every machine: number `index` of the sequence `seed`.
double table_random(std::uint64_t seed, std::uint64_t index);

}  // namespace orbearing::analysis
