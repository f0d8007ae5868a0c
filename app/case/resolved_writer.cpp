#include "app/case/resolved_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "app/case/catalogue_fields.hpp"
#include "app/case/catalogue_quantities.hpp"
#include "app/case/field_table.hpp"
#include "orbearing/files.hpp"

namespace orbearing::app {

namespace {

std::string write_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> written;
  for (const std::string& text : texts) written.push_back(write_scalar(text));
  return fmt::format("[{}]", fmt::join(written, ", "));
}

std::string write_value(const Field& field, const std::string& given) {
  if (field.kind == Kind::text) return quoted_scalar(given);
  if (field.kind == Kind::list) return given;
  return write_scalar(given);
}

// Opens the blocks that `path` lies in and the previous path did not, and returns the indented key.
std::string open_blocks(const std::string& path, const std::string& previous) {
  std::string text;
  std::size_t begin = 0;
  std::size_t depth = 0;
  for (auto dot = path.find('.'); dot != std::string::npos; dot = path.find('.', begin), ++depth) {
    if (!previous.starts_with(path.substr(0, dot + 1)))
      text += fmt::format("{:{}}{}:\n", "", 2 * depth, path.substr(begin, dot - begin));
    begin = dot + 1;
  }
  return text + fmt::format("{:{}}{}: ", "", 2 * depth, path.substr(begin));
}

std::string write_uncertain(const StatedUncertainty& uncertain) {
  if (uncertain.inputs.empty()) return {};
  std::string text = "uncertain:\n";
  for (const StatedUncertain& one : uncertain.inputs)
    text += fmt::format("  {}: {}\n", one.path, one.written);
  const std::string& correlations = uncertain.correlations.written;
  return correlations.empty() ? text : text + fmt::format("  correlations: {}\n", correlations);
}

}  // namespace

std::string write_scalar(const std::string& text) {
  const auto is_safe = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view(" ./^*+-").find(c) != std::string::npos;
  };
  const bool begins_well =
      !text.empty() && (std::isalnum(static_cast<unsigned char>(text.front())) != 0 ||
                        (text.size() > 1 && std::isdigit(static_cast<unsigned char>(text[1])) != 0));
  const bool ends_well = !text.empty() && text.back() != ' ';
  return begins_well && ends_well && std::all_of(text.begin(), text.end(), is_safe) ? text
                                                                                    : quoted_scalar(text);
}

std::string write_resolved(const ResolvedCase& resolved) {
  std::string text;
  std::string previous;
  for (const auto& [path, field] : resolved.inputs()) {
    if (!resolved.has(path)) continue;
    const bool of_catalogue = field->path == catalogue_keys::kCatalogue;
    const std::optional<std::string> table = of_catalogue ? table_in_use(resolved, path) : std::nullopt;
    if (of_catalogue && !table) continue;
    const bool texts = field->kind == Kind::list && field->element == Kind::text;
    text += open_blocks(path, previous) +
            (texts ? write_texts(resolved.texts(path))
                   : write_value(*field, table ? *table : resolved.given(path))) +
            "\n";
    previous = path;
  }
  if (!resolved.axes().empty()) text += "sweep:\n";
  for (const SweepAxis& axis : resolved.axes()) text += fmt::format("  {}: {}\n", axis.path, axis.written);
  text += write_uncertain(resolved.uncertain());
  if (!resolved.assumed().empty()) text += "assumed:\n";
  for (const auto& [path, reason] : resolved.assumed())
    text += fmt::format("  {}: {}\n", path, quoted_scalar(reason));
  return text;
}

std::string case_hash(const ResolvedCase& resolved) {
  return checksum(write_resolved(resolved));
}

}  // namespace orbearing::app
