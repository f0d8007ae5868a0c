#include "app/study/derivatives_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/results/row_text.hpp"

namespace orbearing::app {

namespace {

std::string side_text(int side) {
  if (side == 0) return "";
  return side > 0 ? "to larger values alone" : "to smaller values alone";
}

std::string number_or_nothing(const std::optional<double>& value) {
  return value ? fmt::format("{:.12g}", *value) : "";
}

// The unit of the result before or behind other text; that of another one than a life is in its key.
std::string unit_with(const Derivatives& d, const std::string& before, const std::string& behind) {
  return d.unit.empty() ? "" : before + d.unit + behind;
}

std::string derivatives_heading(const Derivatives& d) {
  std::string text = fmt::format("{} = {:.6g}{}", d.quantity, d.value, unit_with(d, " ", ""));
  return d.of_set.empty() ? text : text + " of the bearings of " + d.of_set + ", the shortest-lived";
}

}  // namespace

nlohmann::ordered_json derivatives_json(const Derivatives& d) {
  using nlohmann::ordered_json;
  ordered_json inputs = ordered_json::array(), without = ordered_json::array();
  for (const Derivative& one : d.inputs) {
    ordered_json row{{"path", one.path},
                     {"value", one.value},
                     {"unit", one.unit},
                     {"standing", one.standing},
                     {"derivative", one.derivative},
                     {"error", one.error},
                     {"elasticity", one.elasticity ? ordered_json(*one.elasticity) : ordered_json(nullptr)},
                     {"step", one.step},
                     {"change", one.change}};
    if (one.side != 0) row["remark"] = side_text(one.side);
    inputs.push_back(std::move(row));
  }
  for (const NoDerivative& one : d.not_differentiable)
    without.push_back({{"path", one.path}, {"given", one.given}, {"reason", one.reason}});
  ordered_json object{{"quantity", d.quantity}, {d.quantity, d.value}, {"unit", d.unit}};
  if (!d.of_set.empty()) object["of_set"] = d.of_set;
  object["inputs"] = std::move(inputs);
  object["not_differentiable"] = std::move(without);
  object["without_effect"] = d.without_effect;
  return object;
}

std::string derivatives_text(const Derivatives& d) {
  std::size_t width = 5;
  for (const Derivative& one : d.inputs) width = std::max(width, one.path.size());
  for (const NoDerivative& one : d.not_differentiable) width = std::max(width, one.path.size());
  std::string text = derivatives_heading(d) + "\n\n" +
                     fmt::format("{:<{}}  {:>12} {:<9} {:>14} {:>10} {:>11}  {:>9} {:>13}\n", "input", width,
                                 "value", "unit", unit_with(d, "", "/unit"), "+-", "elasticity", "step",
                                 "change" + unit_with(d, " [", "]"));
  for (const Derivative& one : d.inputs) {
    text += fmt::format("{:<{}}  {:>12.6g} {:<9} {:>+14.6g} {:>10.2g} {:>11}  {:>9} {:>+13.5g}", one.path,
                        width, one.value, one.unit, one.derivative, one.error,
                        one.elasticity ? fmt::format("{:+.5f}", *one.elasticity) : std::string("-"), one.step,
                        one.change);
    text += one.side == 0 ? "\n" : "  " + side_text(one.side) + "\n";
  }
  if (!d.not_differentiable.empty()) text += "\nwithout a derivative:\n";
  for (const NoDerivative& one : d.not_differentiable)
    text += fmt::format("{:<{}}  {:>12}  {}\n", one.path, width, one.given, one.reason);
  if (!d.without_effect.empty())
    text += fmt::format("\n{} does not follow: {}\n", d.quantity, fmt::join(d.without_effect, ", "));
  return text;
}

std::string derivatives_csv(const Derivatives& d) {
  std::string text = fmt::format(
      "input,value,unit,standing,derivative_{0}per_unit,error_{0}per_unit,elasticity,step,change{1},remark\n",
      unit_with(d, "", "_"), unit_with(d, "_", ""));
  for (const Derivative& one : d.inputs)
    text += fmt::format("{},{:.12g},{},{},{:.12g},{:.3g},{},{},{:.12g},{}\n", one.path, one.value, one.unit,
                        one.standing, one.derivative, one.error, number_or_nothing(one.elasticity), one.step,
                        one.change, side_text(one.side));
  for (const NoDerivative& one : d.not_differentiable)
    text += fmt::format("{},{},,,,,,,,{}\n", one.path, csv_field(one.given), csv_field(one.reason));
  for (const std::string& path : d.without_effect) text += fmt::format("{},,,,0,,,,0,without effect\n", path);
  return text;
}

PointContent derivatives_content(const Derivatives& d) {
  std::vector<std::string> paths;
  for (const Derivative& one : d.inputs) paths.push_back(one.path + " [" + one.unit + "]");
  PointContent content;
  content.add_dimension("input", d.inputs.size());
  content.add_each("derivative", {"input"}, "1",
                   fmt::format("{} per customary unit of the input, in the order {}",
                               d.unit.empty() ? d.quantity : d.unit, fmt::join(paths, ", ")),
                   d.inputs, &Derivative::derivative);
  content.add_each("error", {"input"}, "1", "estimated, of the derivative", d.inputs, &Derivative::error);
  content.add_each("elasticity", {"input"}, "1", "d ln(result)/d ln(input)", d.inputs,
                   [](const Derivative& one) {
                     return one.elasticity.value_or(std::numeric_limits<double>::quiet_NaN());
                   });
  std::string name = d.quantity;
  std::replace(name.begin(), name.end(), '/', '_');
  content.add(name, d.unit == "h" ? "hour" : d.unit == "Mrev" ? "1e6" : "1", "the result itself", d.value);
  return content;
}

}  // namespace orbearing::app
