#include "app/study/expected_file.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/case/units.hpp"
#include "app/case/yaml_tree.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/results/durable_file.hpp"
#include "app/study/fidelity.hpp"
#include "app/version.hpp"
#include "orbearing/files.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

constexpr std::array kRowKeys{"source",  "kind",     "of",      "quantity", "meaning", "value",  "tolerance",
                              "scatter", "settings", "against", "fidelity", "why",     "memory", "fitted"};

EvidenceKind kind_of(const YAML::Node& node) {
  const auto name = node["kind"].as<std::string>("");
  for (const auto& kind : names_of(EvidenceKind{}))
    if (name == kind.text) return kind.value;
  throw YAML::Exception(node["kind"] ? node["kind"].Mark() : node.Mark(), "kind: found '" + name + "'");
}

void require_known_keys(const YAML::Node& node) {
  for (const auto& member : node) {
    const auto key = member.first.as<std::string>();
    if (std::find(kRowKeys.begin(), kRowKeys.end(), key) == kRowKeys.end())
      throw YAML::Exception(member.first.Mark(), "unknown key " + key);
  }
}

std::string text_of(const YAML::Node& node, const char* key) {
  if (!node[key]) throw YAML::Exception(node.Mark(), std::string(key) + ": missing");
  return printable(node[key].as<std::string>());
}

// A finite number, by the decimal point whatever the locale; yaml-cpp reads by a stream.
double number_of(const YAML::Node& node, const char* key) {
  const Reading<double> number = read_number(node.IsScalar() ? node.Scalar() : "");
  if (!number.value)
    throw YAML::Exception(node.Mark(),
                          fmt::format("{}: found {}, {}", key,
                                      node.IsScalar() ? quote(node.Scalar()) : "no number", number.fault));
  return *number.value;
}

double positive_number(const YAML::Node& node, const char* key) {
  const double number = number_of(node, key);
  if (!(number >= 0.0)) throw YAML::Exception(node.Mark(), std::string(key) + ": found a number below zero");
  return number;
}

// yaml-cpp's nodes take the first of two members with one key and drop the other.
void require_each_key_once(const Entry& entry, const std::string& file, std::vector<std::string>& mistakes) {
  std::set<std::string> seen;
  for (const Entry& item : entry.items) require_each_key_once(item, file, mistakes);
  for (const Member& member : entry.members) {
    if (!seen.insert(member.key).second)
      mistakes.push_back(fmt::format("{}:{}:{}: {}: found twice; required: once", file, member.location.line,
                                     member.location.column, member.key));
    require_each_key_once(member.value, file, mistakes);
  }
}

// The text of a file in which no key is twice and, what yaml-cpp repairs in silence, all is UTF-8.
std::string sound_text(const std::string& file) {
  std::string text = read_file(file);
  std::vector<std::string> mistakes;
  try {
    require_each_key_once(read_yaml(text), file, mistakes);
  } catch (const YamlFault& fault) {
    throw BadInput(fmt::format("{}:{}:{}: {}; {}", file, fault.location.line, fault.location.column,
                               fault.message.found, fault.message.required));
  }
  if (!mistakes.empty()) throw BadInput(mistakes);
  return text;
}

std::string fidelity_at(const YAML::Node& node, const char* key) {
  const auto name = node.as<std::string>();
  if (std::ranges::find(fidelity_names(), name) == fidelity_names().end())
    throw YAML::Exception(node.Mark(), std::string(key) + ": found " + name);
  return name;
}

// A key of rows whose quantity a command gives.
void require_command(const YAML::Node& node, const char* key, const std::string& quantity) {
  if (node[key] && !result_pointer(quantity))
    throw YAML::Exception(node[key].Mark(),
                          std::string(key) + ": found together with a quantity that no command gives");
}

PublishedValue published_value(const YAML::Node& node) {
  require_known_keys(node);
  PublishedValue row{.source = text_of(node, "source"),
                     .kind = kind_of(node),
                     .of = text_of(node, "of"),
                     .quantity = text_of(node, "quantity"),
                     .meaning = text_of(node, "meaning"),
                     .tolerance = node["tolerance"]
                                      ? positive_number(node["tolerance"], "tolerance")
                                      : throw YAML::Exception(node.Mark(), "tolerance: missing"),
                     .why = node["why"].as<std::string>(""),
                     .memory = node["memory"].as<bool>(false),
                     .fitted = node["fitted"].as<bool>(false)};
  if (node["fidelity"]) row.fidelity = fidelity_at(node["fidelity"], "fidelity");
  require_command(node, "fidelity", row.quantity);
  if (node["settings"]) row.settings = node["settings"].as<std::vector<std::string>>();
  require_command(node, "against", row.quantity);
  if (node["against"]) row.against = node["against"].as<std::vector<std::string>>();
  if (!node["value"]) throw YAML::Exception(node.Mark(), "value: missing");
  if (!node["value"].IsNull()) row.value = number_of(node["value"], "value");
  if (node["scatter"]) row.scatter = positive_number(node["scatter"], "scatter");
  return row;
}

NamedChange alternative(const YAML::Node& node) {
  return {node["reading"].as<std::string>(), node["assumption"].as<std::string>(),
          node["settings"].as<std::vector<std::string>>()};
}

MotionPlan motion_plan(const YAML::Node& node) {
  MotionPlan plan{.fidelity = fidelity_at(node["fidelity"], "motion.fidelity"), .speed_rpm = {}};
  for (const YAML::Node& speed : node["speeds_rpm"])
    plan.speed_rpm.push_back(positive_number(speed, "motion.speeds_rpm"));
  if (plan.speed_rpm.empty()) throw YAML::Exception(node.Mark(), "motion.speeds_rpm: found none");
  for (const YAML::Node& entry : node["alternatives"]) plan.alternatives.push_back(alternative(entry));
  return plan;
}

// The shipped cases, and the folder of cases that exist only for the comparison with a source.
std::array<fs::path, 2> folders_of_cases() {
  const fs::path shipped = shipped_cases();
  return {shipped, shipped / "validation"};
}

}  // namespace

bool counts(EvidenceKind kind) {
  return kind != EvidenceKind::closed_form && kind != EvidenceKind::recomputed;
}

std::optional<ResultPointer> result_pointer(const std::string& quantity) {
  const std::size_t colon = quantity.find(":/");
  if (colon == std::string::npos) return std::nullopt;
  return ResultPointer{quantity.substr(0, colon), quantity.substr(colon + 1)};
}

ExpectedFile read_expected(const std::string& file) {
  if (!fs::exists(file)) return {};
  const std::string text = sound_text(file);
  try {
    const YAML::Node root = YAML::Load(text);
    ExpectedFile expected;
    for (const YAML::Node& node : root["published"]) expected.published.push_back(published_value(node));
    for (const YAML::Node& node : root["alternatives"]) expected.alternatives.push_back(alternative(node));
    if (root["motion"]) expected.motion = motion_plan(root["motion"]);
    return expected;
  } catch (const YAML::Exception& error) {
    throw BadInput(fmt::format(
        "{}:{}:{}: {}; required: published numbers with source, kind (measurement, program, worked-example, "
        "closed-form or recomputed), of, quantity, meaning, value and tolerance, perhaps scatter, settings, "
        "against, fidelity, why, memory and fitted; and alternatives as in the shipped cases",
        file, error.mark.line + 1, error.mark.column + 1, error.msg));
  }
}

std::vector<std::string> case_files(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names)
    files.push_back(fs::is_directory(name) ? (fs::path(name) / "case.yaml").string() : name);
  if (!names.empty()) return files;
  std::error_code ignored;
  for (const fs::path& folder : folders_of_cases())
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
      if (fs::exists(entry.path() / "expected.yaml")) files.push_back((entry.path() / "case.yaml").string());
  if (files.empty())
    throw BadInput(
        fmt::format("{}: holds no cases with published numbers; name a case file", shipped_cases().string()));
  std::sort(files.begin(), files.end());
  return files;
}

std::string shipped_expected(const std::string& name) {
  const auto [shipped, validation] = folders_of_cases();
  const fs::path own = shipped / name;
  return ((fs::is_directory(own) ? own : validation / name) / "expected.yaml").string();
}

std::string expected_beside(const std::string& case_file) {
  return (fs::path(case_file).parent_path() / "expected.yaml").string();
}

}  // namespace orbearing::app
