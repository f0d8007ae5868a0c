#include "coupling/analysis/result_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "mechanics/constants.hpp"

namespace orbearing::analysis {

namespace {

// A check point finds an error anywhere but not everywhere: the stated error is so many times the largest
// found.
constexpr double kErrorOverMiss = 2.0;
// Terms are refined whose surplus is at least this part of the largest one.
constexpr double kRefinedShare = 0.1;
constexpr std::size_t kTermsPerInput = 40;  // more terms than this times the inputs: a cell is halved
constexpr int kFailedDepth = 2;  // times the inputs: cells in which points fail are halved so often
constexpr int kMostDepth = 10;   // times the inputs
// Radius of the checks around the largest errors of a cell, over its half widths.
constexpr std::array<double, 2> kNearWorst{0.4, 0.15};

constexpr std::size_t kNodes = kMostTableDegree + 1;

/// Nodes, and of each h_m the factor 1/prod (t_m - t_j) and its largest value in the cell.
struct Basis {
  std::array<double, kNodes> node{}, factor{}, largest{};

  Basis() {
    std::array<double, kNodes> angle{0.0, constants::pi, 0.5 * constants::pi};
    for (std::size_t m = 3; m < kNodes; ++m)
      angle[m] = m % 2 == 1 ? 0.5 * angle[(m + 1) / 2] : angle[m - 1] + constants::pi;
    for (std::size_t m = 3; m < kNodes; ++m) node[m] = std::cos(angle[m]);
    node[0] = 0.0;  // the middle first
    node[1] = 1.0;
    node[2] = -1.0;
    for (std::size_t m = 0; m < kNodes; ++m) {
      double product = 1.0;
      for (std::size_t j = 0; j < m; ++j) product *= node[m] - node[j];
      factor[m] = 1.0 / product;
    }
    constexpr int samples = 400;
    for (int i = 0; i <= samples; ++i) {
      std::array<double, kNodes> value{};
      values(std::cos(constants::pi * i / samples), kMostTableDegree, value.data());
      for (std::size_t m = 0; m < kNodes; ++m) largest[m] = std::max(largest[m], std::abs(value[m]));
    }
  }

  /// h_0 to h_most at t.
  void values(double t, std::size_t most, double* into) const {
    double product = 1.0;
    into[0] = 1.0;
    for (std::size_t m = 1; m <= most; ++m) {
      product *= t - node[m - 1];
      into[m] = product * factor[m];
    }
  }
};

const Basis& basis() {
  static const Basis all;
  return all;
}

double local(double coordinate, double lower, double upper) {
  return (2.0 * coordinate - lower - upper) / (upper - lower);
}

std::size_t sum_of(const TableDegrees& degrees) {
  return std::accumulate(degrees.begin(), degrees.end(), std::size_t{0});
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

TableDegrees raised(TableDegrees degrees, std::size_t input, int by = 1) {
  degrees.at(input) = static_cast<std::uint8_t>(degrees.at(input) + by);
  return degrees;
}

}  // namespace

double table_node(std::size_t m) {
  return basis().node.at(m);
}

double table_random(std::uint64_t seed, std::uint64_t index) {
  // SplitMix64 [Steele2014], its seed spread by the same steps.
  std::uint64_t bits = (seed << 32U) * 0x9e3779b97f4a7c15U + (index + 1) * 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  bits ^= bits >> 31U;
  return static_cast<double>(bits >> 11U) * 0x1.0p-52 - 1.0;
}

ResultTable::ResultTable(std::size_t inputs, std::size_t results, std::vector<TableSplit> splits,
                         std::vector<TableCell> cells)
    : inputs_(inputs), results_(results), splits_(std::move(splits)), cells_(std::move(cells)) {
  const auto require = [](bool fits) {
    if (!fits) throw std::invalid_argument("parts of a table that do not fit each other");
  };
  require(inputs >= 1 && inputs <= kMostTableInputs && cells_.size() == splits_.size() + 1);
  for (std::size_t split = 0; split < splits_.size(); ++split) {
    require(splits_[split].input < inputs);
    // Halves follow what they are halves of, so that every way ends in a cell.
    for (const int half : {splits_[split].below, splits_[split].above})
      require(half < 0 ? static_cast<std::size_t>(~half) < cells_.size()
                       : static_cast<std::size_t>(half) > split &&
                             static_cast<std::size_t>(half) < splits_.size());
  }
  for (const TableCell& cell : cells_) {
    require(cell.error.size() == results && cell.weights.size() == results * cell.terms.size());
    require(!cell.terms.empty() && std::is_sorted(cell.terms.begin(), cell.terms.end()));
    Steps steps;
    for (std::size_t term = 0; term < cell.terms.size(); ++term) {
      std::size_t first = 0;
      while (term > 0 && first + 1 < inputs && cell.terms[term][first] == cell.terms[term - 1][first])
        ++first;
      steps.first.push_back(static_cast<std::uint8_t>(first));
      for (std::size_t i = 0; i < inputs; ++i) {
        require(cell.terms[term][i] <= kMostTableDegree && cell.lower[i] < cell.upper[i]);
        steps.most[i] = std::max(steps.most[i], cell.terms[term][i]);
      }
    }
    steps_.push_back(std::move(steps));
  }
}

std::size_t ResultTable::cell_of(const TablePoint& point) const {
  int part = splits_.empty() ? ~0 : 0;
  while (part >= 0) {
    const TableSplit& split = splits_[static_cast<std::size_t>(part)];
    part = point[split.input] < split.at ? split.below : split.above;
  }
  return static_cast<std::size_t>(~part);
}

TableValue ResultTable::at(const TablePoint& point, std::size_t result) const {
  for (std::size_t i = 0; i < inputs_; ++i)
    if (!(std::abs(point[i]) <= 1.0)) return {};
  const std::size_t number = cell_of(point);
  const TableCell& cell = cells_[number];
  const Steps& steps = steps_[number];
  std::array<std::array<double, kNodes>, kMostTableInputs> values;
  for (std::size_t i = 0; i < inputs_; ++i)
    basis().values(local(point[i], cell.lower[i], cell.upper[i]), steps.most[i], values[i].data());
  // Products of terms before are kept: ascending terms differ in their last inputs.
  std::array<double, kMostTableInputs + 1> product;
  product[0] = 1.0;
  const double* weight = cell.weights.data() + result * cell.terms.size();
  double sum = 0.0;
  for (std::size_t term = 0; term < cell.terms.size(); ++term) {
    const TableDegrees& degrees = cell.terms[term];
    for (std::size_t i = steps.first[term]; i < inputs_; ++i)
      product[i + 1] = product[i] * values[i][degrees[i]];
    sum += weight[term] * product[inputs_];
  }
  const double error = cell.error[result];
  return {error == kNoTableValue ? std::numeric_limits<double>::quiet_NaN() : sum, error};
}

double ResultTable::share_within(double bound) const {
  double share = 0.0;
  // For a cell that also covers one of its halves: the part of that half.
  const auto add = [&](const auto& self, int part, double volume) -> void {
    if (part >= 0) {
      const TableSplit& split = splits_[static_cast<std::size_t>(part)];
      self(self, split.below, 0.5 * volume);
      self(self, split.above, 0.5 * volume);
    } else if (std::ranges::all_of(cells_[static_cast<std::size_t>(~part)].error,
                                   [&](double error) { return error <= bound; })) {
      share += volume;
    }
  };
  add(add, splits_.empty() ? ~0 : 0, 1.0);
  return share;
}

TableBuilder::TableBuilder(const TableTarget& target) : target_(target) {
  Cell whole;
  for (std::size_t i = 0; i < target_.inputs; ++i) {
    whole.lower[i] = -1.0;
    whole.upper[i] = 1.0;
  }
  cells_.push_back(std::move(whole));
}

TablePoint TableBuilder::point_of(const Cell& cell, const TableDegrees& degrees) const {
  TablePoint point{};
  for (std::size_t i = 0; i < target_.inputs; ++i) {
    const double node = basis().node[degrees[i]];
    point[i] = 0.5 * ((1.0 - node) * cell.lower[i] + (1.0 + node) * cell.upper[i]);
  }
  return point;
}

std::vector<double> TableBuilder::sum_of_terms(const Cell& cell, const TablePoint& point) const {
  std::array<std::array<double, kNodes>, kMostTableInputs> values;
  for (std::size_t i = 0; i < target_.inputs; ++i)
    basis().values(local(point[i], cell.lower[i], cell.upper[i]), kMostTableDegree, values[i].data());
  std::vector<double> sum(target_.results, 0.0);
  for (const auto& [degrees, term] : cell.terms) {
    double product = 1.0;
    for (std::size_t i = 0; i < target_.inputs; ++i) product *= values[i][degrees[i]];
    for (std::size_t r = 0; r < target_.results; ++r) sum[r] += term.weight[r] * product;
  }
  return sum;
}

// All terms up to the second degree, and check points: at least half of them of this cell only.
void TableBuilder::want_first_points(Cell& cell) {
  cell.wanted.push_back({});
  for (std::size_t i = 0; i < target_.inputs; ++i) cell.wanted.push_back(raised({}, i));
  for (std::size_t i = 0; i < target_.inputs; ++i)
    for (std::size_t j = i; j < target_.inputs; ++j) cell.wanted.push_back(raised(raised({}, i), j));
  const std::size_t inherited = std::min(cell.checks.size(), target_.checks);
  want_checks(cell, std::max((target_.checks + 1) / 2, target_.checks - inherited));
}

void TableBuilder::want_checks(Cell& cell, std::size_t count) {
  constexpr double whole = 1.0;
  for (; count > 0; --count) want_check(cell, point_of(cell, {}), whole);
}

// At random about a point, as far from it as this part of the cell's half widths, and in the cell.
void TableBuilder::want_check(Cell& cell, const TablePoint& middle, double radius) {
  const auto number = static_cast<std::uint64_t>(&cell - cells_.data());
  TablePoint point{};
  for (std::size_t i = 0; i < target_.inputs; ++i) {
    const double at = table_random(target_.seed + number, cell.random_checks * kMostTableInputs + i);
    point[i] = std::clamp(middle[i] + 0.5 * radius * at * (cell.upper[i] - cell.lower[i]), cell.lower[i],
                          cell.upper[i]);
  }
  ++cell.random_checks;
  cell.wanted_checks.push_back(point);
}

// A kink that runs through a cell cuts off a corner at least.
void TableBuilder::want_corners(Cell& cell) {
  const std::size_t corners = std::min(std::size_t{1} << target_.inputs, target_.checks);
  for (std::size_t corner = 0; corner < corners; ++corner) {
    TablePoint point{};
    for (std::size_t i = 0; i < target_.inputs; ++i)
      point[i] = ((corner >> i) & 1U) != 0 ? cell.upper[i] : cell.lower[i];
    cell.wanted_checks.push_back(point);
  }
}

// If a result has a kink, its error is largest in a narrow part of the cell, which few random points hit:
// checks follow the largest error of each result.
void TableBuilder::want_checks_near_worst(Cell& cell, double radius) {
  std::vector<TablePoint> worst;
  for (std::size_t r = 0; r < target_.results; ++r) {
    const auto most =
        std::ranges::max_element(cell.checks, {}, [&](const Check& one) { return one.miss[r]; });
    if (std::ranges::find(worst, most->point) == worst.end()) worst.push_back(most->point);
  }
  const std::size_t each = std::max<std::size_t>(1, target_.checks / 6);
  for (const TablePoint& point : worst)
    for (std::size_t k = 0; k < each; ++k) want_check(cell, point, radius);
}

// Whether all terms one degree lower have been accepted.
bool TableBuilder::is_admissible(const Cell& cell, const TableDegrees& degrees) const {
  for (std::size_t i = 0; i < target_.inputs; ++i) {
    if (degrees[i] == 0) continue;
    const auto lower = cell.terms.find(raised(degrees, i, -1));
    if (lower == cell.terms.end() || !lower->second.accepted) return false;
  }
  return true;
}

// Accepts the terms of the largest surplus until they have new neighbours. False where there are none, or too
// many.
bool TableBuilder::want_more_terms(Cell& cell) {
  for (double largest = 1.0; cell.wanted.empty() && largest >= 0.0;) {
    largest = -1.0;
    for (const auto& [degrees, term] : cell.terms)
      if (!term.accepted) largest = std::max(largest, term.surplus);
    for (auto& [degrees, term] : cell.terms)
      term.accepted = term.accepted || term.surplus >= kRefinedShare * largest;
    for (const auto& [degrees, term] : cell.terms)
      for (std::size_t i = 0; i < target_.inputs; ++i) {
        const TableDegrees next = raised(degrees, i);
        if (term.accepted && next[i] <= kMostTableDegree && !cell.terms.contains(next) &&
            is_admissible(cell, next))
          cell.wanted.push_back(next);
      }
  }
  std::sort(cell.wanted.begin(), cell.wanted.end());
  cell.wanted.erase(std::unique(cell.wanted.begin(), cell.wanted.end()), cell.wanted.end());
  if (!cell.wanted.empty() && cell.terms.size() + cell.wanted.size() <= kTermsPerInput * target_.inputs)
    return true;
  cell.wanted.clear();
  return false;
}

// The input whose high degrees still have the largest surplus.
std::size_t TableBuilder::roughest_input(const Cell& cell) const {
  if (cell.failed) return static_cast<std::size_t>(cell.depth) % target_.inputs;
  std::vector<double> roughness(target_.inputs, 0.0);
  for (const auto& [degrees, term] : cell.terms)
    for (std::size_t i = 0; i < target_.inputs && !term.accepted; ++i)
      roughness[i] +=
          term.surplus * degrees[i] / static_cast<double>(std::max<std::size_t>(1, sum_of(degrees)));
  return static_cast<std::size_t>(std::max_element(roughness.begin(), roughness.end()) - roughness.begin());
}

// The halves inherit all points in them as check points: none of their own terms will use these.
void TableBuilder::halve(std::size_t number) {
  const std::size_t input = roughest_input(cells_[number]);
  cells_[number].split_input = input;
  cells_[number].below = cells_.size();
  for (const bool above : {false, true}) {
    const Cell& whole = cells_[number];
    Cell half;
    half.lower = whole.lower;
    half.upper = whole.upper;
    half.depth = whole.depth + 1;
    (above ? half.lower : half.upper)[input] = 0.5 * (whole.lower[input] + whole.upper[input]);
    const auto inherit = [&](const TablePoint& point, const std::vector<double>& value) {
      const auto is_in = [&](std::size_t i) {
        return point[i] >= half.lower[i] && point[i] <= half.upper[i];
      };
      if (all_finite(value) && is_in(input)) half.checks.push_back({point, value, value});
    };
    for (const Check& check : whole.checks) inherit(check.point, check.value);
    for (const auto& [degrees, term] : whole.terms) inherit(point_of(whole, degrees), term.value);
    cells_.push_back(std::move(half));
  }
}

void TableBuilder::decide(std::size_t number) {
  Cell& cell = cells_[number];
  if (cell.finished || cell.below > 0) return;
  if (cell.terms.empty() && !cell.failed) return want_first_points(cell);
  const double worst = *std::max_element(cell.error.begin(), cell.error.end());
  const int most_depth = (cell.failed ? kFailedDepth : kMostDepth) * static_cast<int>(target_.inputs);
  const bool within = worst <= target_.bound;
  const std::size_t confirmed = std::exchange(cell.confirmed, within ? cell.confirmed + 1 : 0);
  if (within) {
    cell.finished = confirmed > kNearWorst.size();
    if (confirmed == 0)
      want_checks(cell, std::max(target_.checks, target_.box_checks >> std::min(cell.depth, 60)));
    if (confirmed == 1) want_corners(cell);
    if (confirmed > 0 && !cell.finished) want_checks_near_worst(cell, kNearWorst[confirmed - 1]);
  } else if (cell.failed || !want_more_terms(cell)) {
    if (cell.depth < most_depth)
      halve(number);
    else
      cell.finished = true;
  }
}

// Points of the last round: as many terms as fit; a cell without all of its first points has no values.
std::vector<TablePoint> TableBuilder::next() {
  std::vector<TablePoint> points;
  for (std::size_t number = 0; number < cells_.size() && !exhausted_; ++number) {  // halves follow at once
    decide(number);
    Cell& cell = cells_[number];
    const std::size_t left = target_.most_points - given_ - points.size();
    if (cell.wanted.size() + cell.wanted_checks.size() > left) {
      exhausted_ = true;
      cell.wanted.resize(cell.terms.empty() ? 0 : std::min(left, cell.wanted.size()));
      cell.wanted_checks.resize(
          cell.terms.empty() ? 0 : std::min(left - cell.wanted.size(), cell.wanted_checks.size()));
    }
    for (const TableDegrees& degrees : cell.wanted) points.push_back(point_of(cell, degrees));
    points.insert(points.end(), cell.wanted_checks.begin(), cell.wanted_checks.end());
  }
  given_ += points.size();
  return points;
}

void TableBuilder::add_term(Cell& cell, const TableDegrees& degrees, const std::vector<double>& value) {
  if (!all_finite(value)) cell.failed = true;
  if (cell.failed) return;
  const std::vector<double> before = sum_of_terms(cell, point_of(cell, degrees));
  Term term{value, value, 0.0, sum_of(degrees) < 2};
  double largest = 1.0;
  for (std::size_t i = 0; i < target_.inputs; ++i) largest *= basis().largest[degrees[i]];
  for (std::size_t r = 0; r < target_.results; ++r) {
    term.weight[r] -= before[r];
    term.surplus = std::max(term.surplus, std::abs(term.weight[r]) * largest);
  }
  cell.terms.emplace(degrees, std::move(term));
}

// The largest miss of the check points, and the largest surplus of a term at the edge of the set.
void TableBuilder::estimate_error(Cell& cell) const {
  cell.error.assign(target_.results, cell.failed ? kNoTableValue : target_.scatter);
  if (cell.failed) return;
  for (Check& check : cell.checks) {
    const std::vector<double> sum = sum_of_terms(cell, check.point);
    for (std::size_t r = 0; r < target_.results; ++r) {
      check.miss[r] = std::abs(check.value[r] - sum[r]);
      cell.error[r] = std::max(cell.error[r], kErrorOverMiss * check.miss[r]);
    }
  }
  for (const auto& [degrees, term] : cell.terms)
    for (std::size_t r = 0; r < target_.results && !term.accepted; ++r)
      cell.error[r] = std::max(cell.error[r], std::abs(term.weight[r]));
}

void TableBuilder::take(const std::vector<std::vector<double>>& values) {
  auto value = values.begin();
  for (Cell& cell : cells_) {
    if (cell.wanted.empty() && cell.wanted_checks.empty()) continue;
    for (const TableDegrees& degrees : std::exchange(cell.wanted, {})) add_term(cell, degrees, *value++);
    for (const TablePoint& point : std::exchange(cell.wanted_checks, {})) {
      if (!all_finite(*value)) cell.failed = true;
      cell.checks.push_back({point, *value, *value});
      ++value;
    }
    estimate_error(cell);
  }
}

int TableBuilder::add_cell(const Cell& cell, std::vector<TableCell>& cells) const {
  TableCell& added = cells.emplace_back(TableCell{cell.lower, cell.upper, {}, {}, cell.error});
  if (cell.failed) {  // its error marks a missing value
    added.terms.emplace_back();
    added.weights.assign(target_.results, 0.0);
  } else {
    for (const auto& [degrees, term] : cell.terms) added.terms.push_back(degrees);
    for (std::size_t r = 0; r < target_.results; ++r)
      for (const auto& [degrees, term] : cell.terms) added.weights.push_back(term.weight[r]);
  }
  return ~static_cast<int>(cells.size() - 1);
}

// A half without values of its own has those of the whole.
int TableBuilder::add_part(const Cell& cell, std::vector<TableSplit>& splits,
                           std::vector<TableCell>& cells) const {
  const auto has_values = [&](std::size_t half) { return !cells_[half].error.empty(); };
  if (cell.below == 0 || !(has_values(cell.below) || has_values(cell.below + 1)))
    return add_cell(cell, cells);
  const std::size_t split = splits.size();
  splits.push_back({cell.split_input, cells_[cell.below].upper[cell.split_input], 0, 0});
  const auto add_half = [&](std::size_t half) {
    return has_values(half) ? add_part(cells_[half], splits, cells) : add_cell(cell, cells);
  };
  const int below = add_half(cell.below), above = add_half(cell.below + 1);
  splits[split].below = below;
  splits[split].above = above;
  return static_cast<int>(split);
}

ResultTable TableBuilder::table() const {
  std::vector<TableSplit> splits;
  std::vector<TableCell> cells;
  add_part(cells_.front(), splits, cells);
  return {target_.inputs, target_.results, std::move(splits), std::move(cells)};
}

}  // namespace orbearing::analysis
