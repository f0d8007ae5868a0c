// Tables of functions whose values are known everywhere: what is exact, how errors fall, and what is stated
// of them.
#include "coupling/study/result_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace orbearing::study {
namespace {

using Function = std::function<double(const TablePoint&)>;

constexpr double kRoundOff = 1e-12;  // of sums of some hundred terms of order one

struct Built {
  ResultTable table;
  std::size_t points = 0;
};

Built built(const TableTarget& target, const std::vector<Function>& functions) {
  TableBuilder builder(target);
  std::size_t points = 0;
  for (std::vector<TablePoint> wanted = builder.next(); !wanted.empty(); wanted = builder.next()) {
    std::vector<std::vector<double>> values;
    for (const TablePoint& point : wanted) {
      values.emplace_back();
      for (const Function& function : functions) values.back().push_back(function(point));
    }
    points += wanted.size();
    builder.take(values);
  }
  return {builder.table(), points};
}

TablePoint random_point(std::size_t inputs, std::uint64_t number) {
  TablePoint point{};
  for (std::size_t i = 0; i < inputs; ++i) point[i] = table_random(77, number * kMostTableInputs + i);
  return point;
}

struct Missed {
  double largest = 0.0;        // [-]  error of what the table answers within the bound
  double within_stated = 0.0;  // share of it within the stated error
  double answered = 0.0;       // share of all points
};

Missed missed(const ResultTable& table, const Function& function, double bound, std::uint64_t points = 1000) {
  Missed found;
  for (std::uint64_t number = 0; number < points; ++number) {
    const TablePoint point = random_point(table.inputs(), number);
    const TableValue value = table.at(point, 0);
    if (value.error > bound) continue;
    const double error = std::abs(value.value - function(point));
    found.answered += 1.0;
    found.largest = std::max(found.largest, error);
    found.within_stated += error <= value.error ? 1.0 : 0.0;
  }
  found.within_stated /= found.answered;
  found.answered /= static_cast<double>(points);
  return found;
}

double smooth(const TablePoint& x) {
  return std::exp(0.7 * x[0] - 0.3 * x[1]) / (1.3 + 0.5 * x[1] * x[2] + 0.2 * x[0]);
}

// A slope that jumps across an oblique plane, as where a roller loses contact.
double kinked(const TablePoint& x) {
  return x[0] * x[1] + std::max(0.0, 0.6 * x[0] + 0.3 * x[1] + 0.1 * x[2] - 0.2);
}

TEST(TableNode, NestedNodesOfClenshawAndCurtis) {
  for (const std::size_t count : {3U, 5U, 9U, 17U}) {
    std::vector<double> nodes;
    for (std::size_t m = 0; m < count; ++m) nodes.push_back(table_node(m));
    std::sort(nodes.begin(), nodes.end());
    for (std::size_t m = 0; m < count; ++m)
      EXPECT_NEAR(nodes[m], -std::cos(M_PI * static_cast<double>(m) / static_cast<double>(count - 1)),
                  kRoundOff);
  }
}

// A polynomial has no surplus beyond its degree: exact in one cell.
TEST(ResultTable, ExactForPolynomials) {
  const Function cubic = [](const TablePoint& x) {
    return 1.0 + 2.0 * x[0] - x[1] * x[2] + 0.5 * x[0] * x[0] * x[1] - 3.0 * x[2] * x[2] * x[2] + x[3];
  };
  const Built table = built({.inputs = 4, .bound = 1e-11}, {cubic});
  EXPECT_EQ(table.table.cells().size(), 1U);
  const Missed found = missed(table.table, cubic, 1e-11);
  EXPECT_LT(found.largest, kRoundOff);
  EXPECT_EQ(found.answered, 1.0);
}

// The error of the degree m of exp falls as 1/(2^m (m + 1)!): more than tenfold for two points more.
TEST(ResultTable, ErrorFallsExponentiallyInOneCell) {
  const Function function = [](const TablePoint& x) { return std::exp(x[0]); };
  double before = 1.0;
  for (const double bound : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const Built table = built({.inputs = 1, .bound = bound}, {function});
    ASSERT_EQ(table.table.cells().size(), 1U);
    const double degree = static_cast<double>(table.table.cells().front().terms.size()) - 1.0;
    const double largest = missed(table.table, function, bound).largest;
    EXPECT_LT(largest, 8.0 / (std::pow(2.0, degree) * std::tgamma(degree + 2.0)))
        << bound;  // 8: within e and nodes
    EXPECT_LT(largest, 0.5 * before) << bound;
    before = largest;
  }
}

// Order of convergence of halved cells: the quadratic of a cell of width h has an error of h^3 away from the
// kink.
TEST(ResultTable, BoundHoldsOnRandomPoints) {
  for (const double bound : {1e-1, 1e-2, 1e-3, 1e-4}) {
    const Built table = built({.inputs = 3, .bound = bound}, {smooth});
    const Missed found = missed(table.table, smooth, bound);
    EXPECT_EQ(found.answered, 1.0) << bound;
    EXPECT_LE(found.largest, bound);
    EXPECT_GE(found.within_stated, 0.99) << bound;
    printf("smooth %g: %zu points, %zu cells, largest %g, within stated %g\n", bound, table.points,
           table.table.cells().size(), found.largest, found.within_stated);
  }
}

TEST(ResultTable, KinkShowsInTheMeasuredError) {
  for (const std::size_t most : {200U, 2000U, 20000U, 100000U}) {
    const Built table = built({.inputs = 3, .bound = 0.01, .most_points = most}, {kinked});
    const Missed found = missed(table.table, kinked, 0.01);
    printf("kink %zu: %zu points, %zu cells, answered %g (%g), largest %g, within stated %g\n", most,
           table.points, table.table.cells().size(), found.answered, table.table.share_within(0.01),
           found.largest, found.within_stated);
  }
}

}  // namespace
}  // namespace orbearing::study
