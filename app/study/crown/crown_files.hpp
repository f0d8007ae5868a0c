// crown.json in the folder of a crowning study: its result, kept for --resume and for the report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace orbearing::app {

inline constexpr const char* crown_file_name = "crown.json";

/// What the command prints, either way.
struct CrownResult {
  nlohmann::ordered_json object;
  std::string text;
  int failed = 0;  // points without balance
};

void write_crown(const std::filesystem::path& folder, const CrownResult& result);

/// Throws BadInput where the file is missing or is not what this program writes.
CrownResult read_crown(const std::filesystem::path& folder);

/// Whether `folder` holds a crowning study.
bool holds_crown(const std::filesystem::path& folder);

}  // namespace orbearing::app
