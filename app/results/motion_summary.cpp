#include "app/results/motion_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "app/results/sweep_row.hpp"

namespace orbearing::app {

namespace {

constexpr double kPercent = 100.0;

constexpr std::string_view kLossOf = "power_loss_";

// "power_loss_inner_traction_W": "inner traction".
std::string cause_of(std::string_view column) {
  std::string cause(column.substr(kLossOf.size(), column.size() - kLossOf.size() - 2));
  std::ranges::replace(cause, '_', ' ');
  return cause;
}

// Power losses by cause [W], the largest first.
std::vector<std::pair<double, std::string>> losses_of(analysis::PointRow point) {
  std::vector<std::pair<double, std::string>> losses;
  described::Columns columns([&](std::string_view name, const described::Dimension&, double& value) {
    if (name.starts_with(kLossOf) && name != "power_loss_W" && value != 0.0 && std::isfinite(value))
      losses.emplace_back(value, cause_of(name));
  });
  list(columns, point);
  std::ranges::stable_sort(losses, std::ranges::greater{},
                           [](const auto& one) { return std::abs(one.first); });
  return losses;
}

std::string slip_text(const analysis::PointRow& point) {
  const double rollers = point.motion ? point.motion->roller_slip : analysis::PointRow::kNone;
  std::vector<std::string> slips;
  for (const auto& [slip, what] : {std::pair{point.cage_slip, "cage"}, std::pair{rollers, "rollers"}})
    if (std::isfinite(slip)) slips.push_back(fmt::format("{} {:.3g} %", what, kPercent * slip));
  return slips.empty() ? "" : fmt::format("slip: {}\n", fmt::join(slips, ", "));
}

std::string loss_text(const analysis::PointRow& point) {
  if (!std::isfinite(point.power_loss)) return "";
  std::vector<std::string> causes;
  for (const auto& [loss, cause] : losses_of(point)) causes.push_back(fmt::format("{} {:.3g}", cause, loss));
  return fmt::format("power loss of one bearing: {:.4g} W: {}\n", point.power_loss, fmt::join(causes, ", "));
}

}  // namespace

std::optional<SkidRisk> skid_risk_of(const analysis::PointNumbers& point, double minimum_load) {
  SkidRisk risk{std::numeric_limits<double>::infinity(), minimum_load};
  const auto take = [&](const bearing::rating::RatingLives& lives) {
    risk.load_ratio = std::min(risk.load_ratio, lives.dynamic_load / lives.dynamic_capacity);
    return !std::isnan(lives.dynamic_load / lives.dynamic_capacity);
  };
  if (point.sets.empty() && !take(point.rating.lives)) return std::nullopt;
  for (const analysis::SetResult& set : point.sets)
    if (!take(set.rating.lives)) return std::nullopt;
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

std::string motion_summary_text(const analysis::PointRow& point, const std::optional<SkidRisk>& risk) {
  if (!is_computed(point.status)) return "";
  std::string text = point.sets.empty() ? slip_text(point) + loss_text(point) : "";
  if (risk)
    text += fmt::format("skid risk: {}: P/C {:.3g}, minimum load {:g}\n", risk->present() ? "yes" : "no",
                        risk->load_ratio, risk->minimum_load);
  return text;
}

}  // namespace orbearing::app
