#include "app/case/case_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include "app/case/case_resolver.hpp"
#include "app/case/consistency.hpp"
#include "app/case/former_keys.hpp"
#include "app/case/settings.hpp"
#include "app/case/uncertain_case.hpp"

namespace orbearing::app {

namespace {

constexpr std::size_t largest_file =
    1U << 20U;  // [byte] a hundred times the largest case, small enough to check at once

constexpr const char* file_path = "(file)";

[[noreturn]] void refuse_file(const std::string& file, std::string found) {
  throw_mistakes(file, {{Location{}, file_path, {std::move(found), "a readable case file is required"}}});
}

std::string read_file(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (std::filesystem::is_directory(status)) refuse_file(file, "a folder");
  // Opening a pipe would wait for its other end.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    refuse_file(file, "a pipe, a device or a socket");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file(file, std::string("cannot be opened (") + std::strerror(errno) + ")");
  std::string text(largest_file + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) refuse_file(file, "cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > largest_file) refuse_file(file, "more than 1 MiB");
  return text;
}

std::optional<Entry> read_root(std::string_view text, std::vector<Mistake>& mistakes) {
  try {
    Entry root = read_yaml(text);
    if (root.shape == Entry::Shape::block) return root;
    const bool nothing = root.shape == Entry::Shape::nothing;
    mistakes.push_back({root.location,
                        file_path,
                        {nothing ? "an empty file" : describe(root) + " found",
                         "keys and values, beginning with 'name: ...', are required"}});
  } catch (const YamlFault& fault) {
    mistakes.push_back({fault.location, file_path, fault.message});
  }
  return std::nullopt;
}

struct Outcome {
  std::optional<ResolvedCase> resolved;  // none where the text is no YAML
  std::vector<Mistake> mistakes;
};

Outcome resolve_all(std::string_view text, const std::string& name,
                    const std::vector<std::string>& settings) {
  Outcome outcome;
  std::optional<Entry> root = read_root(text, outcome.mistakes);
  Entry unread;
  if (root) rename_former_keys(*root);
  apply_settings(root ? *root : unread, settings, outcome.mistakes);
  if (!root) return outcome;
  outcome.resolved.emplace(resolve(*root, name, outcome.mistakes));
  // What must fit together follows from the model.
  if (outcome.resolved->model() == no_model) return outcome;
  check_consistency(*outcome.resolved, outcome.mistakes);
  check_sweep_consistency(*outcome.resolved, outcome.mistakes);
  check_uncertain(*outcome.resolved, outcome.mistakes);
  return outcome;
}

// What stands in the file and is a mistake only with the settings is theirs: a key that a replaced block
// lacks, a bore that no longer fits.
void blame_settings(std::vector<Mistake>& mistakes, const std::vector<Mistake>& of_file_alone,
                    std::size_t settings) {
  const auto is_of_file = [&](const Mistake& mistake) {
    return std::any_of(of_file_alone.begin(), of_file_alone.end(), [&](const Mistake& other) {
      return other.path == mistake.path && other.message.found == mistake.message.found;
    });
  };
  for (Mistake& mistake : mistakes)
    if (!mistake.location.option && mistake.location.file.empty() && !is_of_file(mistake))
      mistake.location = {true, static_cast<int>(settings), 1};
}

}  // namespace

ResolvedCase read_case(const std::string& file, const std::vector<std::string>& settings) {
  return parse_case(read_file(file), file, settings);
}

ResolvedCase read_point(const std::string& file, const std::vector<std::string>& settings) {
  const ResolvedCase resolved = read_case(file, settings);
  std::vector<Mistake> mistakes;
  for (const SweepAxis& axis : resolved.axes())
    if (axis.location.option)
      mistakes.push_back({axis.location,
                          "sweep." + axis.path,
                          {"a sweep for a command that computes one operating point",
                           "one value, as in --set " + axis.path +
                               "=..., is required; sweeps are those of "
                               "orbearing sweep"}});
  if (!mistakes.empty()) throw_mistakes(file, std::move(mistakes));
  return resolved.without_sweep();
}

ResolvedCase parse_case(std::string_view text, const std::string& name,
                        const std::vector<std::string>& settings) {
  Outcome outcome = resolve_all(text, name, settings);
  if (outcome.mistakes.empty()) return std::move(*outcome.resolved);
  if (!settings.empty())
    blame_settings(outcome.mistakes, resolve_all(text, name, {}).mistakes, settings.size());
  throw_mistakes(name, std::move(outcome.mistakes));
}

}  // namespace orbearing::app
