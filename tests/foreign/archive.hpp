// Archives for the tests of the import of FMUs.
#pragma once

#include <zip.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

namespace orbearing::tests {

/// A folder of its own, which goes with the object.
struct Folder {
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "orbearing-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path = pattern;
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path path;
};

/// Name of an entry and what it holds.
using Entries = std::map<std::string, std::string>;

inline void write_archive(const std::filesystem::path& file, const Entries& entries) {
  zip_t* archive = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  for (const auto& [name, content] : entries) {
    zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    if (zip_file_add(archive, name.c_str(), source, ZIP_FL_OVERWRITE) < 0) {
      throw std::runtime_error(zip_strerror(archive));
    }
  }
  if (zip_close(archive) != 0) throw std::runtime_error("the archive cannot be written");
}

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What the model of tests/foreign/spring_mass.cpp says about itself.
struct SpringMassOptions {
  int version = 2;
  std::string token = "the token";
  bool keeps_state = true;
  bool serialises = true;
  bool interpolates = true;
  bool variable_step = true;
  std::string more_abilities;  // further attributes of CoSimulation
};

inline std::string spring_mass_variables(int version) {
  struct Variable {
    unsigned reference;
    const char *type, *name, *causality, *unit;
  };
  const Variable variables[] = {{0, "Real", "mass", "parameter", "kg"},
                                {1, "Real", "stiffness", "parameter", "N/m"},
                                {2, "Real", "damping", "parameter", "N.s/m"},
                                {3, "Real", "force", "input", "N"},
                                {4, "Real", "displacement", "output", "mm"},
                                {5, "Real", "velocity", "output", ""},
                                {6, "Real", "spring.displacement", "input", ""},
                                {7, "Real", "spring.velocity", "input", ""},
                                {8, "Real", "spring.force", "output", "N"},
                                {9, "Real", "spring.stiffness", "parameter", "N/m"},
                                {10, "Real", "spring.damping", "parameter", "N.s/m"},
                                {11, "Real", "longest_step", "parameter", "s"},
                                {20, "Integer", "fault", "parameter", ""},
                                {21, "String", "label", "parameter", ""},
                                {22, "Boolean", "strict", "parameter", ""}};
  const std::map<std::string, std::string> third = {
      {"Real", "Float64"}, {"Integer", "Int32"}, {"String", "String"}, {"Boolean", "Boolean"}};
  std::string text;
  for (const Variable& v : variables) {
    const std::string head = " name=\"" + std::string(v.name) + "\" valueReference=\"" +
                             std::to_string(v.reference) + "\" causality=\"" + v.causality + "\"";
    const std::string unit = *v.unit != '\0' ? " unit=\"" + std::string(v.unit) + "\"" : "";
    text += version == 2 ? "<ScalarVariable" + head + "><" + v.type + unit + "/></ScalarVariable>\n"
                         : "<" + third.at(v.type) + head + unit + "/>\n";
  }
  return text;
}

inline std::string spring_mass_description(const SpringMassOptions& options = {}) {
  const bool second = options.version == 2;
  const auto flag = [](const std::string& name, bool value) {
    return " " + name + "=\"" + (value ? "true" : "false") + "\"";
  };
  const std::string state = second ? "FMUstate" : "FMUState";
  return std::string("<?xml version=\"1.0\"?>\n<fmiModelDescription fmiVersion=\"") +
         (second ? "2.0" : "3.0") + "\" modelName=\"spring mass\" " +
         (second ? "guid" : "instantiationToken") + "=\"" + options.token +
         "\">\n<CoSimulation modelIdentifier=\"spring_mass\"" +
         flag("canGetAndSet" + state, options.keeps_state) +
         flag("canSerialize" + state, options.serialises) +
         flag("canInterpolateInputs", options.interpolates) +
         flag("canHandleVariableCommunicationStepSize", options.variable_step) + " " +
         options.more_abilities +
         "/>\n<UnitDefinitions><Unit name=\"mm\"><BaseUnit m=\"1\" factor=\"0.001\"/></Unit>"
         "<Unit name=\"N\"><BaseUnit kg=\"1\" m=\"1\" "
         "s=\"-2\"/></Unit></UnitDefinitions>\n<ModelVariables>\n" +
         spring_mass_variables(options.version) +
         "</ModelVariables><ModelStructure/></fmiModelDescription>\n";
}

/// The model as an FMU.
inline std::filesystem::path spring_mass_fmu(const Folder& folder, const SpringMassOptions& options = {}) {
  const std::string place = options.version == 2 ? "binaries/linux64/" : "binaries/x86_64-linux/";
  const auto file = folder.path / ("spring_mass_" + std::to_string(options.version) + ".fmu");
  write_archive(file, {{"modelDescription.xml", spring_mass_description(options)},
                       {place + "spring_mass.so", content_of(ORBEARING_FOREIGN_MODEL)}});
  return file;
}

}  // namespace orbearing::tests
