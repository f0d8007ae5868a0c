#include "app/study/expected_file.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/study/fidelity.hpp"
#include "app/version.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

Evidence evidence_of(const YAML::Node& node) {
  const auto name = node["evidence"].as<std::string>("published");
  if (name == "published") return Evidence::published;
  if (name == "recomputed") return Evidence::recomputed;
  throw YAML::Exception(node["evidence"].Mark(), "evidence: found " + name);
}

PublishedValue published_value(const YAML::Node& node) {
  PublishedValue row{.source = node["source"].as<std::string>(),
                     .quantity = node["quantity"].as<std::string>(),
                     .meaning = node["meaning"].as<std::string>(),
                     .tolerance = node["tolerance"].as<double>(),
                     .trend = node["trend"].as<bool>(false),
                     .evidence = evidence_of(node)};
  if (node["settings"]) row.settings = node["settings"].as<std::vector<std::string>>();
  if (!node["value"].IsNull()) row.value = node["value"].as<double>();
  return row;
}

NamedChange alternative(const YAML::Node& node) {
  return {node["reading"].as<std::string>(), node["assumption"].as<std::string>(),
          node["settings"].as<std::vector<std::string>>()};
}

MotionPlan motion_plan(const YAML::Node& node) {
  MotionPlan plan{.fidelity = node["fidelity"].as<std::string>(),
                  .speed_rpm = node["speeds_rpm"].as<std::vector<double>>()};
  const std::vector<std::string>& names = fidelity_names();
  if (std::find(names.begin(), names.end(), plan.fidelity) == names.end())
    throw YAML::Exception(node["fidelity"].Mark(), "motion.fidelity: found " + plan.fidelity);
  if (plan.speed_rpm.empty()) throw YAML::Exception(node.Mark(), "motion.speeds_rpm: found none");
  for (const YAML::Node& entry : node["alternatives"]) plan.alternatives.push_back(alternative(entry));
  return plan;
}

// The folder of cases: of a wheel or of the source tree this program was built from, or beside an installed program.
fs::path shipped_cases() {
  const fs::path own = resources().folder / "share" / "orbearing" / "cases";
  const fs::path in_tree = fs::path(source_folder) / "cases";
  return !fs::is_directory(own) && fs::is_directory(in_tree) ? in_tree : own;
}

}  // namespace

ExpectedFile read_expected(const std::string& file) {
  if (!fs::exists(file)) return {};
  try {
    const YAML::Node root = YAML::LoadFile(file);
    ExpectedFile expected;
    for (const YAML::Node& node : root["published"]) expected.published.push_back(published_value(node));
    for (const YAML::Node& node : root["alternatives"]) expected.alternatives.push_back(alternative(node));
    if (root["motion"]) expected.motion = motion_plan(root["motion"]);
    return expected;
  } catch (const YAML::Exception& error) {
    throw BadInput(
        fmt::format("{}:{}:{}: {}; required: published numbers (evidence: published or recomputed) and "
                    "alternatives as in the shipped cases",
                    file, error.mark.line + 1, error.mark.column + 1, error.msg));
  }
}

std::vector<std::string> case_files(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names)
    files.push_back(fs::is_directory(name) ? (fs::path(name) / "case.yaml").string() : name);
  if (!names.empty()) return files;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(shipped_cases(), ignored))
    if (fs::exists(entry.path() / "expected.yaml")) files.push_back((entry.path() / "case.yaml").string());
  if (files.empty())
    throw BadInput(
        fmt::format("{}: holds no cases with published numbers; name a case file", shipped_cases().string()));
  std::sort(files.begin(), files.end());
  return files;
}

std::string shipped_expected(const std::string& name) {
  return (shipped_cases() / name / "expected.yaml").string();
}

std::string expected_beside(const std::string& case_file) {
  return (fs::path(case_file).parent_path() / "expected.yaml").string();
}

}  // namespace orbearing::app
