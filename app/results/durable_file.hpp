// Files that are whole or absent: written aside, brought to the disk, renamed; or appended to, line by line.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/errors.hpp"

namespace orbearing::app {

/// Ending of files being written; a kill may leave them behind.
inline constexpr const char* aside_ending = ".tmp";

/// A file cannot be written. `cause` is the file and the reason, `remedy` the action required before the
/// command is given again.
struct WriteFailed : ComputationFailed {
  WriteFailed(const std::string& cause_text, const std::string& remedy_text)
      : ComputationFailed(cause_text + "; " + remedy_text + ", then give the command again"),
        cause(cause_text),
        remedy(remedy_text) {}
  std::string cause, remedy;
};

/// Remedy for a system failure with this `errno`: "make room" for a full disk.
std::string remedy_of(int error);

struct FileContent {
  std::filesystem::path file;
  std::string_view content;
};

/// Replaces each file by its content in one step. The contents are on the disk then; the names are after the
/// next `sync_folder`. Where one cannot be written WriteFailed is thrown and nothing is left aside. A device
/// or a pipe is written into.
void write_aside_and_rename(const std::vector<FileContent>& files);
void write_aside_and_rename(const std::filesystem::path& file, std::string_view content);

/// Throws BadInput unless a file can be made in `folder`; WriteFailed where the disk is full.
void require_writable(const std::filesystem::path& folder);

/// Brings the names in `folder` to the disk. Throws WriteFailed.
void sync_folder(const std::filesystem::path& folder);

/// Closes what it holds; `release` first where the result of closing matters.
struct Descriptor {
  int number = -1;

  Descriptor() = default;
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(Descriptor&& other) noexcept : number(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number, other.number);
    return *this;
  }
  ~Descriptor();
  int release() { return std::exchange(number, -1); }
};

/// Locks the folder as long as the object exists, and leaves no file behind. Throws BadInput where another
/// process holds the lock.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  Descriptor held_;
};

/// A file that only grows, locked against other programs that open it in this way.
class AppendOnlyFile {
 public:
  AppendOnlyFile() = default;
  /// Opens, creates where missing, locks. Throws BadInput where that is impossible or another holds it.
  explicit AppendOnlyFile(const std::filesystem::path& file);

  /// Content from the start.
  std::string content() const;
  /// Cuts everything after `length`. [bytes]
  void truncate(std::size_t length);
  /// Adds `text` and brings it to the disk. Where that fails the file is cut to its former length and
  /// WriteFailed thrown.
  void append(std::string_view text);
  /// Writes spaces over a part, which is damaged. [bytes]
  void blank(std::size_t begin, std::size_t length);

 private:
  std::filesystem::path file_;
  Descriptor opened_;
  std::size_t length_ = 0;  // [bytes]
};

}  // namespace orbearing::app
