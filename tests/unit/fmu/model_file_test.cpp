// Where an importer says the resources are.
#include "coupling/fmu/model_file.hpp"

#include <gtest/gtest.h>

#include "coupling/fmu/refused.hpp"

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

TEST(FmuResources, LocationsThatAreNone) {
  for (const char* location : {"", "http://example.org/a", "file://elsewhere/a", "file:///a%2", "file:///a%",
                               "file:///a%zz", "file:///a%00b", "file://"})
    EXPECT_THROW(resource_folder(location), Refused) << location;
  EXPECT_THROW(resource_folder(nullptr), Refused);
  EXPECT_THROW(read_model("/nowhere/at/all"), Refused);
}

}  // namespace
}  // namespace orbearing::fmu::model_file_test
