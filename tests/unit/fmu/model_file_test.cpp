// Location of the resources as an importer states it.
#include "coupling/fmu/model_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/messages.hpp"

namespace orbearing::fmu::model_file_test {
namespace {

TEST(FmuResources, LocationsOfAllForms) {
  EXPECT_EQ(resource_folder("file:///tmp/a/resources"), "/tmp/a/resources");
  EXPECT_EQ(resource_folder("file:/tmp/a/resources"), "/tmp/a/resources");
  EXPECT_EQ(resource_folder("file://localhost/tmp/a"), "/tmp/a");
  EXPECT_EQ(resource_folder("file:///tmp/a%20b/%C3%A4%25"), "/tmp/a b/\xC3\xA4%");
  EXPECT_EQ(resource_folder("file:///C:/Temp/a%20b"), "C:/Temp/a b");
  EXPECT_EQ(resource_folder("/tmp/a%20b/resources/"), "/tmp/a%20b/resources/");  // a path is not encoded
  EXPECT_EQ(resource_folder("C:\\Temp\\resources\\"), "C:\\Temp\\resources\\");
}

// A file of its own, or a folder where a file is required.
struct Position {
  explicit Position(const std::string& name)
      : folder(std::filesystem::path(testing::TempDir()) / (name + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder);
  }
  ~Position() { std::filesystem::remove_all(folder); }
  std::string refusal() const {
    std::string text = messages::refusal<Refused>([&] { read_model(folder.string()); });
    return text.replace(text.find(folder.string()), folder.string().size(), "FOLDER");
  }
  std::filesystem::path folder;
};

TEST(FmuResources, ModelsThatAreNone) {
  const Position none("no_model"), inside("folder_for_model"), large("large_model");
  EXPECT_SAID("no model", none.refusal());
  std::filesystem::create_directory(inside.folder / kModelFile);
  EXPECT_SAID("model is a folder", inside.refusal());
  std::ofstream(large.folder / kModelFile) << "orbearing";
  std::filesystem::resize_file(large.folder / kModelFile, 200'000'001);
  EXPECT_SAID("large model", large.refusal());
}

TEST(FmuResources, LocationsThatAreNone) {
  for (const char* location : {"", "http://example.org/a", "file://elsewhere/a", "file:///a%2", "file:///a%",
                               "file:///a%zz", "file:///a%00b", "file://"})
    EXPECT_REFUSED(Refused, "locations", resource_folder(location));
}

}  // namespace
}  // namespace orbearing::fmu::model_file_test
