#include "app/results/durable_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

#include "orbearing/files.hpp"

namespace orbearing::app {
namespace {

[[noreturn]] void fail_to_write(const std::filesystem::path& file, int error) {
  throw WriteFailed(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(error)),
                    remedy_of(error));
}

/// Something there already that is neither a file nor a link, as /dev/stdout leads to.
bool is_device(const std::filesystem::path& file) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  return std::filesystem::is_character_file(status) || std::filesystem::is_fifo(status);
}

/// Writes all of `text`; errno of the first failure, else 0.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

std::filesystem::path aside_of(const std::filesystem::path& file) {
  if (is_device(file)) return file;
  return fmt::format("{}.{}{}", file.string(), ::getpid(), aside_ending);
}

/// Writes the content beside its file and waits until the disk has it; errno of the first failure, else 0.
int write_aside(const FileContent& file) {
  Descriptor opened(::open(aside_of(file.file).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (opened.number < 0) return errno;
  const int error = write_all(opened.number, file.content);
  if (error != 0) return error;
  // A device or a pipe has nothing to bring to a disk.
  if (::fsync(opened.number) != 0 && errno != EINVAL) return errno;
  return ::close(opened.release()) != 0 ? errno : 0;
}

/// One after the other each file waits for the disk's own flush; together they share it, which is some
/// thirty times faster.
void bring_to_disk(const std::vector<FileContent>& files, std::vector<int>& errors) {
  constexpr std::size_t most_writers = 8;
  const std::size_t writers = std::min(most_writers, files.size());
  std::vector<std::jthread> others;
  const auto write_share = [&](std::size_t first) {
    for (std::size_t i = first; i < files.size(); i += writers) errors[i] = write_aside(files[i]);
  };
  for (std::size_t first = 1; first < writers; ++first) others.emplace_back(write_share, first);
  write_share(0);
}

void remove_aside(const std::vector<FileContent>& files) {
  for (const FileContent& file : files)
    if (!is_device(file.file)) ::unlink(aside_of(file.file).c_str());
}

}  // namespace

std::string remedy_of(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "make room on the disk";
    case EFBIG:
      return "raise the limit of the size of files (ulimit -f)";
    case EMFILE:
    case ENFILE:
      return "raise the number of open files (ulimit -n)";
    case EACCES:
    case EPERM:
    case EROFS:
      return "make it a writable path";
    default:
      return "mend the cause";
  }
}

void write_aside_and_rename(const std::vector<FileContent>& files) {
  std::vector<int> errors(files.size(), 0);
  bring_to_disk(files, errors);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (errors[i] == 0) continue;
    remove_aside(files);
    fail_to_write(files[i].file, errors[i]);
  }
  for (const FileContent& file : files) {
    if (is_device(file.file) || ::rename(aside_of(file.file).c_str(), file.file.c_str()) == 0) continue;
    const int error = errno;
    remove_aside(files);
    fail_to_write(file.file, error);
  }
}

void write_aside_and_rename(const std::filesystem::path& file, std::string_view content) {
  write_aside_and_rename({{file, content}});
}

void require_writable(const std::filesystem::path& folder) {
  std::string probe = (folder / ".orbearing_XXXXXX").string() + aside_ending;
  const Descriptor made(::mkstemps(probe.data(), static_cast<int>(std::strlen(aside_ending))));
  if (made.number >= 0) {
    ::unlink(probe.c_str());
  } else if (errno == ENOSPC || errno == EDQUOT || errno == EMFILE || errno == ENFILE) {
    fail_to_write(folder, errno);
  } else {
    throw BadInput(fmt::format("{}: cannot be written to: {}; a folder that may be written to is required",
                               folder.string(), std::strerror(errno)));
  }
}

void sync_folder(const std::filesystem::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number < 0) fail_to_write(folder, errno);
  // Some network file systems cannot do this for folders and report EINVAL.
  if (::fsync(opened.number) != 0 && errno != EINVAL) fail_to_write(folder, errno);
}

Descriptor::~Descriptor() {
  if (number >= 0) ::close(number);
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : held_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (held_.number < 0) fail_to_write(folder, errno);
  if (::flock(held_.number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw BadInput(fmt::format("{}: another command is writing here; wait for its end", folder.string()));
}

AppendOnlyFile::AppendOnlyFile(const std::filesystem::path& file) : file_(file) {
  require_no_link(file);
  opened_ = Descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (opened_.number < 0 && (errno == EMFILE || errno == ENFILE)) fail_to_write(file, errno);
  if (opened_.number < 0)
    throw BadInput(fmt::format("{}: cannot be written: {}; a folder that may be written to is required",
                               file.string(), std::strerror(errno)));
  // A file system without locks is no reason to refuse; only a lock that another holds is.
  if (::flock(opened_.number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw BadInput(fmt::format("{}: another sweep is writing here; wait for its end, or use another folder",
                               file.string()));
  struct stat status {};
  if (::fstat(opened_.number, &status) == 0) length_ = static_cast<std::size_t>(status.st_size);
}

std::string AppendOnlyFile::content() const {
  return read_file(file_);
}

void AppendOnlyFile::truncate(std::size_t length) {
  if (length == length_) return;
  if (::ftruncate(opened_.number, static_cast<off_t>(length)) != 0) fail_to_write(file_, errno);
  length_ = length;
}

void AppendOnlyFile::blank(std::size_t begin, std::size_t length) {
  // A descriptor that appends writes at the end, whatever position is set.
  const Descriptor opened(::open(file_.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW));
  if (opened.number < 0 || ::lseek(opened.number, static_cast<off_t>(begin), SEEK_SET) < 0)
    fail_to_write(file_, errno);
  const int error = write_all(opened.number, std::string(length, ' '));
  if (error != 0) fail_to_write(file_, error);
  if (::fsync(opened.number) != 0) fail_to_write(file_, errno);
}

void AppendOnlyFile::append(std::string_view text) {
  int error = write_all(opened_.number, text);
  if (error == 0 && ::fsync(opened_.number) != 0) error = errno;
  if (error == 0) {
    length_ += text.size();
    return;
  }
  // Should the cut fail too, the torn line is recognised when the sweep is resumed.
  if (::ftruncate(opened_.number, static_cast<off_t>(length_)) != 0) error = errno;
  fail_to_write(file_, error);
}

}  // namespace orbearing::app
