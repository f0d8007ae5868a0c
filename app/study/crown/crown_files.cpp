#include "app/study/crown/crown_files.hpp"

#include <nlohmann/json.hpp>

#include "app/errors.hpp"
#include "app/results/durable_file.hpp"

namespace orbearing::app {

namespace fs = std::filesystem;

void write_crown(const fs::path& folder, const CrownResult& result) {
  const nlohmann::ordered_json file{
      {"result", result.object}, {"text", result.text}, {"failed", result.failed}};
  write_aside_and_rename(folder / crown_file_name, file.dump(1) + "\n");
  sync_folder(folder);
}

CrownResult read_crown(const fs::path& folder) {
  const fs::path path = folder / crown_file_name;
  try {
    const auto file = nlohmann::ordered_json::parse(read_file(path));
    return {file.at("result"), file.at("text"), file.at("failed")};
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(path.string() + ": is not a crowning study of this program (" + error.what() +
                   "); required: an untouched one. Run crown again into another folder");
  }
}

bool holds_crown(const fs::path& folder) {
  return fs::exists(folder / crown_file_name);
}

}  // namespace orbearing::app
