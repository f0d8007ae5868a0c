#include "app/results/motion_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace orbearing::app {

namespace {

constexpr double kPercent = 100.0;

// Prefixes of the columns of each set.
std::vector<std::string> prefixes_of(const std::vector<std::string>& sets) {
  std::vector<std::string> prefixes;
  for (const std::string& set : sets) prefixes.push_back("sets." + set + ".");
  if (prefixes.empty()) prefixes.emplace_back();
  return prefixes;
}

// "power_loss_inner_traction_W": "inner traction".
std::string cause_of(const std::string& column, const std::string& begin) {
  std::string cause = column.substr(begin.size(), column.size() - begin.size() - 2);
  std::ranges::replace(cause, '_', ' ');
  return cause;
}

// All columns of one set that begin so and have a value, the largest first.
std::vector<std::pair<double, std::string>> losses_of(const TableHead& head, const ResultRow& row,
                                                      const std::string& prefix) {
  const std::string begin = prefix + "power_loss_";
  std::vector<std::pair<double, std::string>> losses;
  for (const std::string& name : head.names)
    if (name.starts_with(begin) && name.size() > begin.size() + 2)
      if (const double value = value_of(head, row, name); value != 0.0 && std::isfinite(value))
        losses.emplace_back(value, cause_of(name, begin));
  std::ranges::stable_sort(losses, std::ranges::greater{},
                           [](const auto& one) { return std::abs(one.first); });
  return losses;
}

std::string slip_text(const TableHead& head, const ResultRow& row, const std::string& prefix) {
  std::vector<std::string> slips;
  for (const auto& [name, what] : {std::pair{"cage_slip", "cage"}, std::pair{"roller_slip", "rollers"}})
    if (const double slip = value_of(head, row, prefix + name); std::isfinite(slip))
      slips.push_back(fmt::format("{} {:.3g} %", what, kPercent * slip));
  return slips.empty() ? "" : fmt::format("slip: {}", fmt::join(slips, ", "));
}

std::string loss_text(const TableHead& head, const ResultRow& row, const std::string& prefix) {
  const double all = value_of(head, row, prefix + "power_loss_W");
  if (!std::isfinite(all)) return "";
  std::vector<std::string> causes;
  for (const auto& [loss, cause] : losses_of(head, row, prefix))
    causes.push_back(fmt::format("{} {:.3g}", cause, loss));
  return fmt::format("power loss of one bearing: {:.4g} W: {}", all, fmt::join(causes, ", "));
}

}  // namespace

std::optional<SkidRisk> skid_risk_of(const TableHead& head, const std::vector<std::string>& sets,
                                     const ResultRow& row, double minimum_load) {
  SkidRisk risk{std::numeric_limits<double>::infinity(), minimum_load};
  for (const std::string& prefix : prefixes_of(sets)) {
    const double ratio = value_of(head, row, prefix + "P_N") / value_of(head, row, prefix + "C_N");
    if (std::isnan(ratio)) return std::nullopt;
    risk.load_ratio = std::min(risk.load_ratio, ratio);
  }
  return risk;
}

void describe(described::Record& record, const SkidRisk& risk) {
  using described::dimension::ratio;
  record.value("skid_risk", "whether P/C is below the minimum load, so that rolling elements may skid",
               risk.present());
  record.value("P_over_C", ratio, "equivalent load over dynamic capacity, of the least loaded bearing",
               risk.load_ratio);
  record.value("minimum_load", ratio, "P/C below which rolling elements may skid", risk.minimum_load);
}

std::string motion_summary_text(const TableHead& head, const std::vector<std::string>& sets,
                                const ResultRow& row, const std::optional<SkidRisk>& risk) {
  if (!row.ok()) return "";
  std::string text;
  for (const std::string& prefix : prefixes_of(sets))
    for (const std::string& line : {slip_text(head, row, prefix), loss_text(head, row, prefix)})
      if (!line.empty()) text += fmt::format("{}{}\n", prefix.empty() ? "" : prefix + " ", line);
  if (risk)
    text += fmt::format("skid risk: {}: P/C {:.3g}, minimum load {:g}\n", risk->present() ? "yes" : "no",
                        risk->load_ratio, risk->minimum_load);
  return text;
}

}  // namespace orbearing::app
