// A folder of results: who may write into it, and how a finished point gets there whole or not at all.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/results/durable_file.hpp"
#include "app/results/manifest.hpp"

namespace orbearing::app {

enum class OpenMode { fresh, resume };

/// A point ready to be kept.
struct FinishedPoint {
  std::size_t index = 0;
  std::string content;  // bytes of its netCDF file; empty: it has none
  SweepRow row;
  std::map<std::string, std::string> others{};  // further files in the folder: check sums by name
};

/// Fault of the files of a finished point, "FILE: is missing", "FILE: is empty", "FILE: differs from what its
/// sweep wrote"; empty for sound ones.
std::string fault_of_point(const std::filesystem::path& folder, const ManifestEntry& entry);

/// An open result folder, locked against a second writer for as long as the object lives.
///
/// Opening leaves a folder untouched unless it may be used: it is missing (made, parents too), empty, or -
/// in resume mode - holds results of the same header. Everything else throws BadInput.
/// A kill at any instant leaves a folder that resume mode accepts, with every point that `keep` returned
/// from. A fresh folder that cannot be begun is left empty.
class ResultFolder {
 public:
  ResultFolder(std::filesystem::path folder, const ManifestHeader& header, const std::string& resolved_case,
               OpenMode mode);

  /// No folder: rows are kept in memory, and nothing is written.
  explicit ResultFolder(const ManifestHeader& header) : header_(header) {}

  /// Finished points whose files are complete in the folder, by number.
  const std::map<std::size_t, ManifestEntry>& finished() const { return finished_; }

  /// Files of finished points and lines of the manifest that were found missing or damaged, one line each;
  /// their points are not among `finished`.
  const std::vector<std::string>& damaged() const { return damaged_; }

  /// Writes the files of `points`, then their manifest lines; all on the disk when it returns.
  /// Throws ComputationFailed where the disk does not take them; what was kept before stays sound.
  void keep(std::vector<FinishedPoint> points);

  /// Writes sweep.csv from the finished points, `rows_in_table_order`, and spectrum.csv where the case states
  /// a spectrum whose points are all there.
  void write_table() const;

  /// Discards all files of the folder. For a fresh one only; nothing may be kept afterwards.
  void discard();

  const ManifestHeader& header() const { return header_; }
  const std::filesystem::path& path() const { return folder_; }

 private:
  bool in_memory() const { return folder_.empty(); }
  void begin(const ManifestHeader& header, const std::string& resolved_case);

  std::filesystem::path folder_;
  ManifestHeader header_;
  AppendOnlyFile manifest_;
  std::map<std::size_t, ManifestEntry> finished_;
  std::vector<std::string> damaged_;
};

/// Opens `folder`, fresh or to be resumed, or memory alone where `folder` is empty. Files found missing or
/// damaged are reported on standard error unless `quiet`.
ResultFolder open_results(const std::filesystem::path& folder, const ManifestHeader& header,
                          const std::string& resolved_case, bool resume, bool quiet);

/// Check sums of files in `folder`, by name.
std::map<std::string, std::string> checksums_of(const std::filesystem::path& folder,
                                                const std::vector<std::string>& names);

/// Reads the manifest of a result folder without changing anything. Throws BadInput where it holds none.
Manifest read_results(const std::filesystem::path& folder);

/// "FILE: differs from what its run wrote" where the resolved case in the folder is not that of the results;
/// empty where it is.
std::string fault_of_case(const std::filesystem::path& folder, const ManifestHeader& header);

/// Throws BadInput with `faults` and what to do, where there are any.
void require_undamaged(std::vector<std::string> faults);

}  // namespace orbearing::app
