#include "app/results/archive.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "app/errors.hpp"
#ifdef ORBEARING_ZIP_FILE
#include "app/results/loaded_library.hpp"
#endif

namespace orbearing::app {

namespace {

// The least effort would make files a tenth larger than the most; this makes them 3 % larger, in a ninth of
// the time.
constexpr zip_uint32_t kCompression = 4;
constexpr zip_uint16_t kFirstDay = 0x21;  // 1 January 1980, so that no clock gets into the archive

// Functions of libzip by their names without "zip_". It brings a library of encryption with it.
struct ZipLibrary {
  decltype(&::zip_close) close = nullptr;
  decltype(&::zip_discard) discard = nullptr;
  decltype(&::zip_error_init) error_init = nullptr;
  decltype(&::zip_error_strerror) error_strerror = nullptr;
  decltype(&::zip_file_add) file_add = nullptr;
  decltype(&::zip_file_set_dostime) file_set_dostime = nullptr;
  decltype(&::zip_open_from_source) open_from_source = nullptr;
  decltype(&::zip_set_file_compression) set_file_compression = nullptr;
  decltype(&::zip_source_buffer) source_buffer = nullptr;
  decltype(&::zip_source_buffer_create) source_buffer_create = nullptr;
  decltype(&::zip_source_close) source_close = nullptr;
  decltype(&::zip_source_error) source_error = nullptr;
  decltype(&::zip_source_free) source_free = nullptr;
  decltype(&::zip_source_keep) source_keep = nullptr;
  decltype(&::zip_source_open) source_open = nullptr;
  decltype(&::zip_source_read) source_read = nullptr;
  decltype(&::zip_strerror) strerror = nullptr;
};

#ifdef ORBEARING_ZIP_FILE
#define ORBEARING_OF_ZIP(name) library.function<decltype(&::name)>(#name)
#else  // it is a part of this program
#define ORBEARING_OF_ZIP(name) &::name
#endif

ZipLibrary functions() {
#ifdef ORBEARING_ZIP_FILE
  const LoadedLibrary library("the zip library", {ORBEARING_ZIP_FILE, ORBEARING_ZIP_PATH});
#endif
  return {.close = ORBEARING_OF_ZIP(zip_close),
          .discard = ORBEARING_OF_ZIP(zip_discard),
          .error_init = ORBEARING_OF_ZIP(zip_error_init),
          .error_strerror = ORBEARING_OF_ZIP(zip_error_strerror),
          .file_add = ORBEARING_OF_ZIP(zip_file_add),
          .file_set_dostime = ORBEARING_OF_ZIP(zip_file_set_dostime),
          .open_from_source = ORBEARING_OF_ZIP(zip_open_from_source),
          .set_file_compression = ORBEARING_OF_ZIP(zip_set_file_compression),
          .source_buffer = ORBEARING_OF_ZIP(zip_source_buffer),
          .source_buffer_create = ORBEARING_OF_ZIP(zip_source_buffer_create),
          .source_close = ORBEARING_OF_ZIP(zip_source_close),
          .source_error = ORBEARING_OF_ZIP(zip_source_error),
          .source_free = ORBEARING_OF_ZIP(zip_source_free),
          .source_keep = ORBEARING_OF_ZIP(zip_source_keep),
          .source_open = ORBEARING_OF_ZIP(zip_source_open),
          .source_read = ORBEARING_OF_ZIP(zip_source_read),
          .strerror = ORBEARING_OF_ZIP(zip_strerror)};
}

const ZipLibrary& zip() {
  static const ZipLibrary library = functions();
  return library;
}

[[noreturn]] void fail(const std::string& what, const char* reason) {
  throw ComputationFailed(fmt::format("zip archive: {}: {}", what, reason));
}

struct Closer {
  void operator()(zip_t* archive) const { zip().discard(archive); }
  void operator()(zip_source_t* source) const { zip().source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, Closer>;
using Archive = std::unique_ptr<zip_t, Closer>;

void add(zip_t* archive, const ArchiveFile& file) {
  zip_source_t* source = zip().source_buffer(archive, file.content.data(), file.content.size(), 0);
  if (source == nullptr) fail(file.path, zip().strerror(archive));
  const zip_int64_t index = zip().file_add(archive, file.path.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip().source_free(source);
    fail(file.path, zip().strerror(archive));
  }
  const auto position = static_cast<zip_uint64_t>(index);
  if (zip().file_set_dostime(archive, position, 0, kFirstDay, 0) != 0 ||
      zip().set_file_compression(archive, position, ZIP_CM_DEFLATE, kCompression) != 0)
    fail(file.path, zip().strerror(archive));
}

std::string content_of(zip_source_t* source) {
  const auto reason = [&] { return zip().error_strerror(zip().source_error(source)); };
  if (zip().source_open(source) != 0) fail("reading back", reason());
  std::string bytes;
  char block[65536];
  zip_int64_t count = 0;
  while ((count = zip().source_read(source, block, sizeof block)) > 0)
    bytes.append(block, static_cast<std::size_t>(count));
  zip().source_close(source);
  if (count < 0) fail("reading back", reason());
  return bytes;
}

}  // namespace

std::string archive_of(const std::vector<ArchiveFile>& files) {
  zip_error_t error;
  zip().error_init(&error);
  const Source memory(zip().source_buffer_create(nullptr, 0, 0, &error));
  if (!memory) fail("begin", zip().error_strerror(&error));
  Archive archive(zip().open_from_source(memory.get(), ZIP_TRUNCATE, &error));
  if (!archive) fail("begin", zip().error_strerror(&error));
  zip().source_keep(memory.get());
  for (const ArchiveFile& file : files) add(archive.get(), file);
  if (zip().close(archive.get()) != 0) fail("end", zip().strerror(archive.get()));
  static_cast<void>(archive.release());  // closed
  return content_of(memory.get());
}

}  // namespace orbearing::app
