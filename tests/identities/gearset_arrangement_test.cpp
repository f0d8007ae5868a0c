// Random arrangements of up to four sets: solved or refused, never with numbers that are none; where solved,
// every equation holds, and where refused, an independent count of ranks confirms it.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <random>

#include "gearset/drivetrain/arrangement_checks.hpp"
#include "gearset/drivetrain/power_flow.hpp"

namespace orbearing::gearset::gearset_arrangement_test {
namespace {

// Condition numbers of these systems stay below 1e5.
constexpr double round_off = 1e-10;
constexpr int arrangements = 4000;

using Random = std::mt19937;

int between(Random& random, int least, int most) {
  return std::uniform_int_distribution<int>(least, most)(random);
}

ArrangedSet random_set(Random& random, std::size_t index) {
  const int sun = between(random, 12, 60);
  const int planet = between(random, 12, 50);
  return {"set" + std::to_string(index), sun, planet, sun + 2 * planet};
}

Arrangement random_arrangement(Random& random) {
  Arrangement arrangement;
  const int sets = between(random, 1, 4);
  for (int i = 0; i < sets; ++i) arrangement.sets.push_back(random_set(random, arrangement.sets.size()));
  const int shafts = std::max(3, between(random, sets + 1, sets + 4));
  for (int i = 0; i < shafts; ++i) arrangement.shafts.push_back({"shaft" + std::to_string(i), {}});
  for (std::size_t set = 0; set < arrangement.sets.size(); ++set)
    for (const Member member : {Member::sun, Member::ring, Member::carrier})
      arrangement.shafts[static_cast<std::size_t>(between(random, 0, shafts - 1))].members.push_back(
          {set, member});
  std::erase_if(arrangement.shafts, [](const Shaft& shaft) { return shaft.members.empty(); });
  const int last = static_cast<int>(arrangement.shafts.size()) - 1;
  arrangement.shafts[static_cast<std::size_t>(between(random, 0, last))].motor = true;
  arrangement.shafts[static_cast<std::size_t>(between(random, 0, last))].load = true;
  for (int i = 0; i <= last; ++i) {
    Shaft& shaft = arrangement.shafts[static_cast<std::size_t>(i)];
    if (!shaft.motor && !shaft.load) shaft.ground = between(random, 0, 2) == 0;
  }
  return arrangement;
}

// All equations as one system, written out apart from the code under test: speeds of members, then torques of
// members, then outer torques of shafts.
struct Whole {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

class WholeSystem {
 public:
  explicit WholeSystem(const Arrangement& arrangement)
      : members_(3 * static_cast<Eigen::Index>(arrangement.sets.size())),
        unknowns_(2 * members_ + static_cast<Eigen::Index>(arrangement.shafts.size())) {
    for (std::size_t set = 0; set < arrangement.sets.size(); ++set) add_set(arrangement.sets[set], set);
    for (std::size_t i = 0; i < arrangement.shafts.size(); ++i)
      add_shaft(arrangement.shafts[i], 2 * members_ + static_cast<Eigen::Index>(i));
  }

  Whole whole() const {
    Whole out{Eigen::MatrixXd(static_cast<Eigen::Index>(rows_.size()), unknowns_),
              Eigen::VectorXd(static_cast<Eigen::Index>(rows_.size()))};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      out.matrix.row(static_cast<Eigen::Index>(i)) = rows_[i];
      out.right(static_cast<Eigen::Index>(i)) = rights_[i];
    }
    return out;
  }

 private:
  using Terms = std::vector<std::pair<Eigen::Index, double>>;

  void add(const Terms& terms, double right = 0.0) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(unknowns_);
    for (const auto& [position, factor] : terms) row(position) += factor;
    rows_.push_back(row);
    rights_.push_back(right);
  }
  static Eigen::Index speed(const SetMember& member) {
    return 3 * static_cast<Eigen::Index>(member.set) + static_cast<Eigen::Index>(member.member);
  }
  Eigen::Index torque(const SetMember& member) const { return members_ + speed(member); }

  void add_set(const ArrangedSet& set, std::size_t index) {
    const SetMember s{index, Member::sun};
    const SetMember r{index, Member::ring};
    const SetMember c{index, Member::carrier};
    const double ratio = static_cast<double>(set.ring_teeth) / set.sun_teeth;
    add({{speed(s), 1.0}, {speed(r), ratio}, {speed(c), -1.0 - ratio}});
    add({{torque(r), 1.0}, {torque(s), -ratio}});
    add({{torque(s), 1.0}, {torque(r), 1.0}, {torque(c), 1.0}});
  }

  void add_shaft(const Shaft& shaft, Eigen::Index outer) {
    for (std::size_t i = 1; i < shaft.members.size(); ++i)
      add({{speed(shaft.members[0]), 1.0}, {speed(shaft.members[i]), -1.0}});
    Terms balance{{outer, -1.0}};
    for (const SetMember& member : shaft.members) balance.emplace_back(torque(member), 1.0);
    add(balance);
    if (shaft.ground) add({{speed(shaft.members[0]), 1.0}});
    if (shaft.motor) {
      add({{speed(shaft.members[0]), 1.0}}, 1.0);
      if (!shaft.load) add({{outer, 1.0}}, 1.0);
    }
    if (!shaft.ground && !shaft.motor && !shaft.load) add({{outer, 1.0}});
  }

  Eigen::Index members_;
  Eigen::Index unknowns_;
  std::vector<Eigen::RowVectorXd> rows_;
  std::vector<double> rights_;
};

Eigen::Index rank_of(const Eigen::MatrixXd& matrix) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(matrix);
  decomposition.setThreshold(1e-9);
  return decomposition.rank();
}

bool has_one_solution(const Whole& whole) {
  Eigen::MatrixXd joined(whole.matrix.rows(), whole.matrix.cols() + 1);
  joined << whole.matrix, whole.right;
  return rank_of(whole.matrix) == whole.matrix.cols() && rank_of(joined) == whole.matrix.cols();
}

void expect_balanced(const Arrangement& arrangement, const PowerFlow& flow) {
  double in_all = 0.0;
  double largest_torque = 0.0;
  for (const ShaftFlow& shaft : flow.shafts) {
    ASSERT_TRUE(std::isfinite(shaft.power));
    in_all += shaft.power;
    largest_torque = std::max(largest_torque, std::abs(shaft.torque));
  }
  const double scale = std::max(1.0, power_circulation(flow).largest_share);
  EXPECT_NEAR(in_all, 0.0, round_off * scale);
  for (std::size_t set = 0; set < arrangement.sets.size(); ++set) {
    double power = 0.0;
    double torque = 0.0;
    double largest = 0.0;
    for (std::size_t i = 3 * set; i < 3 * set + 3; ++i) {
      power += flow.members[i].power;
      torque += flow.members[i].torque;
      largest = std::max(largest, std::abs(flow.members[i].torque));
    }
    EXPECT_NEAR(power, 0.0, round_off * scale);
    EXPECT_NEAR(torque, 0.0, round_off * std::max(1.0, largest));
  }
  for (std::size_t i = 0; i < flow.shafts.size(); ++i) {
    const Shaft& shaft = arrangement.shafts[i];
    const double power = shaft.motor ? 1.0 : shaft.load ? -1.0 : 0.0;
    EXPECT_NEAR(flow.shafts[i].power, power, round_off * scale);
    const bool free = !shaft.motor && !shaft.load && !shaft.ground;
    const double fixed = shaft.ground ? flow.shafts[i].speed : free ? flow.shafts[i].torque : 0.0;
    EXPECT_NEAR(fixed, 0.0, round_off * std::max(1.0, largest_torque));
  }
}

TEST(ArrangementIdentities, RandomOnesAreSolvedOrRefusedWithMembersNamed) {
  Random random(20250901);
  int solved = 0;
  int refused_by_algebra = 0;
  for (int i = 0; i < arrangements; ++i) {
    const Arrangement arrangement = random_arrangement(random);
    const std::vector<ArrangementProblem> problems = arrangement_problems(arrangement);
    const bool motor_is_load = std::any_of(arrangement.shafts.begin(), arrangement.shafts.end(),
                                           [](const Shaft& shaft) { return shaft.motor && shaft.load; });
    if (motor_is_load) continue;  // what the motor gives and the load takes there cannot be distinguished
    EXPECT_EQ(problems.empty(), has_one_solution(WholeSystem(arrangement).whole())) << "arrangement " << i;
    for (const ArrangementProblem& problem : problems) EXPECT_FALSE(problem.members.empty());
    if (problems.empty()) expect_balanced(arrangement, power_flow(arrangement));
    ++(problems.empty() ? solved : refused_by_algebra);
  }
  // Both branches were taken often.
  EXPECT_GT(solved, 50);
  EXPECT_GT(refused_by_algebra, 500);
}

// The named members of a contradiction are all needed: freeing any shaft among the culprits removes it.
TEST(ArrangementIdentities, EachCulpritOfAContradictionIsNeeded) {
  Random random(7);
  int tried = 0;
  for (int i = 0; i < arrangements; ++i) {
    const Arrangement arrangement = random_arrangement(random);
    const std::vector<ArrangementProblem> problems = arrangement_problems(arrangement);
    if (problems.empty() || problems.front().found.find("contradict") == std::string::npos) continue;
    for (const std::size_t shaft : problems.front().shafts) {
      if (!arrangement.shafts[shaft].ground) continue;
      Arrangement freed = arrangement;
      freed.shafts[shaft].ground = false;
      freed.shafts[shaft].load = true;  // so that nothing floats
      const std::vector<ArrangementProblem> after = arrangement_problems(freed);
      const bool same = !after.empty() && after.front().found == problems.front().found;
      EXPECT_FALSE(same) << "arrangement " << i << ", shaft " << shaft;
      ++tried;
    }
  }
  EXPECT_GT(tried, 50);
}

}  // namespace
}  // namespace orbearing::gearset::gearset_arrangement_test
