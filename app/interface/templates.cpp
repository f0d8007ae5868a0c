#include "orbearing/templates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "app/resources.hpp"

namespace orbearing {

namespace {

// Without what a terminal would take as a command.
std::string escaped(const std::string& text) {
  const std::string quoted = fmt::format("{:?}", text);
  return quoted.substr(1, quoted.size() - 2);
}

}  // namespace

const std::vector<std::string>& template_names() {
  static const std::vector<std::string> names{"wind-stage",   "e-drive", "industrial", "roller-bearing",
                                              "ball-bearing", "duplex",  "defect"};
  return names;
}

CaseTemplate case_template(const std::string& name) {
  const std::vector<std::string>& names = template_names();
  if (std::ranges::find(names, name) == names.end())
    throw BadInput(
        fmt::format("TEMPLATE: found '{}'; required: one of {}", escaped(name), fmt::join(names, ", ")));
  const std::filesystem::path file = app::shipped_cases() / "templates" / (name + ".yaml");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t colon = text.find(": "), end = text.find('\n');
  if (!text.starts_with("# ") || colon >= end)
    throw ComputationFailed(file.string() + ": cannot be read as a template; install Orbearing again");
  return {name, text.substr(2, colon - 2), text.substr(colon + 2, end - colon - 2), std::move(text)};
}

}  // namespace orbearing
