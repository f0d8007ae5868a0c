#include "coupling/fmu/import/unpacked_fmu.hpp"

#include <stdlib.h>
#include <zip.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>

#include "coupling/fmu/import/errors.hpp"

namespace orbearing::fmu {
namespace {

constexpr std::uint64_t most_bytes = 2ULL << 30;
constexpr zip_int64_t most_entries = 100'000;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Close {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Entry = std::unique_ptr<zip_file_t, Close>;

Archive open(const std::filesystem::path& file) {
  int code = 0;
  Archive archive{zip_open(file.c_str(), ZIP_RDONLY, &code)};
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw ForeignFmuError("cannot be opened as an FMU (a zip archive): " + reason);
  }
  return archive;
}

bool needed(const std::string& name) {
  constexpr std::array<const char*, 4> places = {"modelDescription.xml", "resources/", "binaries/linux64/",
                                                 "binaries/x86_64-linux/"};
  for (const char* place : places) {
    if (name.rfind(place, 0) == 0) return true;
  }
  return false;
}

void unpack_entry(zip_t* archive, zip_uint64_t index, const std::filesystem::path& target,
                  std::uint64_t& left) {
  const Entry entry{zip_fopen_index(archive, index, 0)};
  if (!entry) throw ForeignFmuError(std::string("an entry cannot be read: ") + zip_strerror(archive));
  std::filesystem::create_directories(target.parent_path());
  std::ofstream out{target, std::ios::binary};
  std::array<char, 65536> block;
  zip_int64_t count = 0;
  while ((count = zip_fread(entry.get(), block.data(), block.size())) > 0) {
    const auto bytes = static_cast<std::uint64_t>(count);
    if (bytes > left) throw ForeignFmuError("unpacks to more than 2 GiB, at most 2 GiB are unpacked");
    left -= bytes;
    out.write(block.data(), count);
  }
  if (count < 0) throw ForeignFmuError(target.filename().string() + " is damaged in the archive");
  out.close();
  if (!out) throw ForeignFmuError("cannot be unpacked to " + target.string());
}

void unpack(zip_t* archive, const std::filesystem::path& folder) {
  const zip_int64_t entries = zip_get_num_entries(archive, 0);
  if (entries > most_entries) throw ForeignFmuError("holds more than 100000 entries");
  std::uint64_t left = most_bytes;
  for (zip_uint64_t index = 0; index < static_cast<zip_uint64_t>(entries); ++index) {
    const char* text = zip_get_name(archive, index, 0);
    const std::string name = text != nullptr ? text : "";
    const std::filesystem::path place = place_of_entry(name);  // refuses bad names of all entries
    if (name.back() == '/' || !needed(name)) continue;
    unpack_entry(archive, index, folder / place, left);
  }
}

std::filesystem::path make_folder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "orbearing-fmu-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw ForeignFmuError("no temporary folder " + pattern + ": " + std::strerror(errno));
  }
  return pattern;
}

}  // namespace

std::filesystem::path place_of_entry(const std::string& name) {
  const std::filesystem::path path{name};
  bool leaves = name.empty() || path.is_absolute() || name.find('\\') != std::string::npos ||
                (name.size() > 1 && name[1] == ':');
  for (const auto& part : path) leaves = leaves || part == "..";
  if (leaves) {
    throw ForeignFmuError("holds an entry named '" + name +
                          "'; required are relative names with '/' that stay inside the archive");
  }
  return path;
}

UnpackedFmu::UnpackedFmu(const std::filesystem::path& file) {
  const Archive archive = open(file);
  folder_ = make_folder();
  try {
    unpack(archive.get(), folder_);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
    throw;
  }
}

UnpackedFmu::~UnpackedFmu() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

}  // namespace orbearing::fmu
