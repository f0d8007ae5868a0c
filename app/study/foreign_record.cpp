// Files of other programs that are named for what they are.
#include <fmt/format.h>

#include <array>
#include <fstream>

#include "app/study/record_file.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

/// By the bytes with which the content begins.
struct Signature {
  std::string_view bytes;
  const char* kind;
  const char* remedy;
};

constexpr const char* kByToolbox =
    "write it as CSV with names and units, for example by openfast_toolbox in Python: "
    "openfast_toolbox.io.read(FILE).toDataFrame().to_csv('record.csv', index=False)";

using namespace std::string_view_literals;
constexpr std::array<Signature, 12> kSignatures{{
    {"PK\x03\x04"sv, "a ZIP file, as an Excel workbook (.xlsx) is one", "save the sheet as CSV"},
    {"\xd0\xcf\x11\xe0"sv, "an Excel workbook (.xls)", "save the sheet as CSV"},
    {"PAR1"sv, "a Parquet file",
     "write it as CSV, for example by pandas in Python: pandas.read_parquet(FILE).to_csv('record.csv', "
     "index=False)"},
    {"ARROW1"sv, "a Feather file",
     "write it as CSV, for example by pandas in Python: pandas.read_feather(FILE).to_csv('record.csv', "
     "index=False)"},
    {"TDSm"sv, "a TDMS file of LabVIEW",
     "write it as CSV, for example by npTDMS in Python: "
     "nptdms.TdmsFile.read(FILE).as_dataframe(time_index=True).to_csv('record.csv')"},
    {"MATLAB 5.0 MAT-file"sv, "a MAT-file of MATLAB",
     "write it as CSV: writetable(TABLE, 'record.csv') in MATLAB"},
    {"MDF "sv, "a measurement file MDF (.mf4, .mdf)",
     "write it as CSV, for example by asammdf in Python: asammdf.MDF(FILE).export('csv', 'record.csv')"},
    {"\x1f\x8b"sv, "a compressed file (gzip)", "unpack it"},
    {"BZh"sv, "a compressed file (bzip2)", "unpack it"},
    {"7z\xbc\xaf\x27\x1c"sv, "a compressed file (7z)", "unpack it"},
    {"\xfd"
     "7zXZ"sv,
     "a compressed file (xz)", "unpack it"},
    {"Rar!"sv, "a compressed file (rar)", "unpack it"},
}};

std::string beginning_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string begin(4096, '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(stream.gcount()));
  return begin;
}

bool has(std::string_view text, std::string_view words) {
  return text.find(words) != std::string_view::npos;
}

// HAWC2 and BHAWC: "NAME.sel" has the names of the data "NAME.dat".
std::string program_of_sel(std::string_view text) {
  if (has(text, "BHawC") || has(text, "BHAWC")) return "BHAWC";
  return has(text, "HAWC2") || has(text, "Scans    Channels") ? "HAWC2" : "";
}

}  // namespace

ForeignRecord foreign_record(const fs::path& file) {
  const std::string begin = beginning_of(file), extension = file.extension().string();
  for (const Signature& one : kSignatures)
    if (begin.starts_with(one.bytes)) return {one.kind, one.remedy};
  if (const std::string program = extension == ".sel" ? program_of_sel(begin) : ""; !program.empty())
    return {
        fmt::format("names of channels of {} (.sel), whose data are in the .dat file of that name", program),
        kByToolbox};
  if (extension == ".dat") {
    const fs::path names = fs::path(file).replace_extension(".sel");
    std::error_code ignored;
    if (const std::string program = fs::exists(names, ignored) ? program_of_sel(beginning_of(names)) : "";
        !program.empty())
      return {fmt::format("data of {} without names, which are in {}", program, names.filename().string()),
              kByToolbox};
  }
  const bool binary = has(begin, "\0"sv);
  if (binary && (extension == ".res" || extension == ".int"))
    return {fmt::format("binary data ({}), as FLEX writes them", extension), kByToolbox};
  return {};
}

}  // namespace orbearing::app
