#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/fmu/import/errors.hpp"
#include "coupling/fmu/import/foreign_instance.hpp"
#include "coupling/fmu/import/state_keeper.hpp"
#include "coupling/fmu/import/unpacked_fmu.hpp"
#include "tests/foreign/archive.hpp"

namespace orbearing::fmu::archive_test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(UnpackedFmu, HoldsWhatRunningNeedsAndGoesWithTheObject) {
  const tests::Folder folder;
  const auto file = folder.path / "a.fmu";
  tests::write_archive(file, {{"modelDescription.xml", "<a/>"},
                              {"resources/deep/table.txt", "1 2 3"},
                              {"binaries/win64/a.dll", "MZ"},
                              {"binaries/linux64/a.so", "ELF"}});
  std::filesystem::path place;
  {
    const UnpackedFmu unpacked{file};
    place = unpacked.folder();
    EXPECT_EQ(tests::content_of(place / "resources/deep/table.txt"), "1 2 3");
    EXPECT_EQ(tests::content_of(place / "binaries/linux64/a.so"), "ELF");
    EXPECT_FALSE(exists(place / "binaries/win64"));
    EXPECT_EQ(status(place).permissions(), std::filesystem::perms::owner_all) << "others may look inside";
  }
  EXPECT_FALSE(exists(place));
}

TEST(UnpackedFmu, RefusesNamesThatLeaveTheFolder) {
  for (const char* name :
       {"", "/etc/passwd", "../a", "resources/../../a", "..", "resources/..", "C:/a", "a\\b"}) {
    EXPECT_THROW(place_of_entry(name), ForeignFmuError) << name;
  }
  for (const char* name : {"a", "resources/a..b", "resources/...", "resources/a/"}) {
    EXPECT_EQ(place_of_entry(name), std::filesystem::path(name)) << name;
  }
}

TEST(UnpackedFmu, WritesNothingBesideItsFolder) {
  const tests::Folder folder;
  const auto file = folder.path / "a.fmu";
  const std::string escaped = folder.path.filename().string() + "-escaped.txt";  // no other run's
  tests::write_archive(file, {{"modelDescription.xml", "<a/>"}, {"resources/../../" + escaped, "1"}});
  EXPECT_THAT([&] { const UnpackedFmu unpacked{file}; },
              ThrowsMessage<ForeignFmuError>(HasSubstr(escaped + "'; required are relative")));
  EXPECT_FALSE(exists(std::filesystem::temp_directory_path() / escaped));
}

TEST(UnpackedFmu, RefusesWhatIsNoArchive) {
  const tests::Folder folder;
  std::ofstream{folder.path / "a.fmu"} << "no archive";
  EXPECT_THAT([&] { const UnpackedFmu unpacked{folder.path / "a.fmu"}; },
              ThrowsMessage<ForeignFmuError>(HasSubstr("(a zip archive): Not a zip archive")));
  EXPECT_THAT([&] { const UnpackedFmu unpacked{folder.path / "b.fmu"}; },
              ThrowsMessage<ForeignFmuError>(HasSubstr("No such file")));
}

TEST(FileUri, EncodesAllButPlainCharacters) {
  EXPECT_EQ(file_uri("/tmp/a b/ü%"), "file:///tmp/a%20b/%C3%BC%25");
}

TEST(StatesAsNumbers, BytesComeBack) {
  for (std::size_t size : {0U, 1U, 5U, 6U, 7U, 300U}) {
    std::vector<unsigned char> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<unsigned char>(255U - i % 256U);
    std::vector<double> numbers = {-1.0};
    append_bytes(bytes, numbers);
    EXPECT_EQ(bytes_of(numbers, 1), bytes);
    numbers.push_back(0.0);
    EXPECT_THROW(bytes_of(numbers, 1), ForeignFmuError) << "one number too many";
    numbers.resize(numbers.size() - 2);
    EXPECT_THROW(bytes_of(numbers, 1), ForeignFmuError) << "cut short";
  }
  for (const double damaged : {-1.0, 0.5, 0x1p48, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(bytes_of({6.0, damaged}, 0), ForeignFmuError) << damaged;
    EXPECT_THROW(bytes_of({damaged, 1.0}, 0), ForeignFmuError) << damaged;
  }
}

}  // namespace
}  // namespace orbearing::fmu::archive_test
