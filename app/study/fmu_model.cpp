#include "app/study/fmu_model.hpp"

#include <fmt/core.h>
#include <array>
#include <cstdio>
#include <optional>

#include "app/case/unused_inputs.hpp"
#include "app/errors.hpp"
#include "app/license.hpp"
#include "app/resources.hpp"
#include "app/results/archive.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/progress.hpp"
#include "app/standard_error.hpp"
#include "app/study/gear_case.hpp"
#include "app/study/planetary_case.hpp"
#include "coupling/analysis/driven_setups.hpp"
#include "coupling/fmu/export/description.hpp"
#include "coupling/fmu/model.hpp"
#include "coupling/fmu/model_file.hpp"
#include "coupling/system/driven_bearing.hpp"
#include "orbearing/files.hpp"

namespace orbearing::app {

namespace {

void require(bool good, const ResolvedCase& in, const std::string& key, const std::string& found,
             const std::string& required) {
  if (!good) throw BadInput(in.file() + ": " + key + ": found " + found + "; required: " + required);
}

void require_drivable_set(const ResolvedCase& in) {
  require(in.model() == planetary_drivetrain, in, "model", in.choice("model"),
          "planetary-drivetrain, which has driven parts");
  require(!in.shape().several, in, "sets", "several sets", "one set, as gearset at the top of a case");
}

system::DrivenBearingSetup bearing_setup(const ResolvedCase& in) {
  const analysis::PlanetaryDrivetrain drivetrain = drivetrain_of(in);
  const analysis::DrivetrainGeometry geometry = analysis::derive(drivetrain);
  const analysis::BearingDuty duty = analysis::bearing_duty(drivetrain, geometry);
  system::DrivenBearingSetup setup = analysis::driven_bearing_setup(drivetrain, geometry);
  setup.planet_speed = duty.point.outer_speed;
  setup.carrier_speed = duty.point.carrier.speed;
  setup.start_load = duty.point.bore_load;
  return setup;
}

// Gears without roller bearings have no drivetrain that could be computed as a whole.
system::DrivenGearsSetup gears_setup(const ResolvedCase& in) {
  const gearset::dynamics::SetModel set = moving_gears_of(in);
  if (in.shape().bearing) {
    system::DrivenGearsSetup setup = analysis::driven_gears_setup(drivetrain_of(in));
    setup.operation.run_up = set.operation.run_up;
    return setup;
  }
  system::DrivenGearsSetup setup{.set = set.parameters, .operation = set.operation};
  setup.set.planet.coupled_bearing = true;
  return setup;
}

// The forces of linear bearings in the static state, so that an unconnected set begins at rest.
std::vector<double> start_forces(const system::DrivenGearsSetup& setup) {
  system::DrivenGears gears(setup);
  gears.initialize(0.0);
  std::vector<double> forces;
  for (const system::PlanetMotion& planet : gears.output().planets) {
    const Eigen::Vector2d force = -setup.set.planet.bearing_stiffness * planet.displacement;
    forces.insert(forces.end(), {force.x(), force.y(), 0.0});
  }
  return forces;
}

}  // namespace

fmu::NumberTable bearing_numbers(const ResolvedCase& in) {
  require_used(in, AnalysisId::fmu_bearing);
  require_drivable_set(in);
  require(in.shape().bearing, in, "bearing", "no bearing", "a planet bearing, or --model gearset");
  system::DrivenBearingSetup setup = bearing_setup(in);
  try {
    const system::DrivenBearing driven(setup);
    setup.start_displacement = driven.position_under(
        setup.start_load, {.speed = setup.planet_speed, .carrier_speed = setup.carrier_speed});
  } catch (const std::invalid_argument& unfit) {
    throw BadInput(in.file() + ": " + unfit.what());
  }
  return fmu::numbers_of(setup);
}

fmu::NumberTable gear_numbers(const ResolvedCase& in) {
  require_used(in, AnalysisId::fmu_gearset);
  require_drivable_set(in);
  require(in.shape().teeth, in, "gearset", "no teeth", "tooth numbers, from which loads and speeds follow");
  system::DrivenGearsSetup setup = gears_setup(in);
  setup.start_force = start_forces(setup);
  return fmu::numbers_of(setup);
}

namespace {

namespace fs = std::filesystem;

// "build/release/bin/orbearing" or "<prefix>/bin/orbearing": in both, the libraries are in a folder next to
// bin.
fs::path libraries_folder() {
  return resources().folder / "lib" / "orbearing" / "fmu";
}

struct Platform {
  const char* folder;  // beside the program, and in FMI 2.0
  const char* fmi3;    // in FMI 3.0
  const char* ending;
  const char* remedy;
  bool on_request;  // by --windows
};

constexpr Platform kPlatforms[] = {
    {"linux64", "x86_64-linux", ".so", "build the target orbearing_fmu_linux64", false},
    {"win64", "x86_64-windows", ".dll", "a build with ORBEARING_BUILD_WIN64=ON", true}};

std::string quoted_for_shell(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

struct Ended {
  bool well = false;
  std::string last_line;
};

// Steps done and steps in all of "[12/340] Building ..."; none in other lines.
std::optional<std::pair<std::size_t, std::size_t>> steps_in(const std::string& line) {
  std::size_t done = 0, all = 0;
  if (std::sscanf(line.c_str(), "[%zu/%zu]", &done, &all) != 2 || all == 0) return std::nullopt;
  return std::pair{done, all};
}

Ended run_program(const fs::path& program, const std::string& doing, bool quiet) {
  FILE* output = popen((quoted_for_shell(program.string()) + " 2>&1").c_str(), "r");
  if (output == nullptr) return {false, "it could not be started"};
  Ended ended;
  std::array<char, 4096> line;
  std::optional<Progress> progress;
  while (fgets(line.data(), line.size(), output) != nullptr) {
    ended.last_line = line.data();
    const auto steps = steps_in(ended.last_line);
    if (!steps) continue;
    if (!progress) progress.emplace(std::size_t{0}, steps->second, !quiet, doing);
    progress->show(steps->first);
  }
  ended.well = pclose(output) == 0;
  while (ended.last_line.ends_with('\n')) ended.last_line.pop_back();
  return ended;
}

// Builds a missing library where its build program is available. Returns the reason where there is none.
std::string build_missing(const Platform& platform, const fs::path& library, bool quiet) {
  const fs::path recipe = libraries_folder() / (std::string("build_") + platform.folder);
  if (!fs::exists(recipe))
    return fmt::format("found no file {}; required: {}", library.string(), platform.remedy);
  if (!quiet)
    print_to_standard_error("fmu: building the library for {}, this once (5 to 20 minutes) ...\n",
                            platform.folder);
  const Ended ended = run_program(recipe, fmt::format("library for {}: ", platform.folder), quiet);
  if (!ended.well) return ended.last_line;
  return fs::exists(library) ? "" : "found no file " + library.string() + " after its build";
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else
      out += c;
  return out;
}

constexpr const char* kPage = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{0}</title></head><body>
<h1>{0}</h1>
<p>{1}. Made by Orbearing {2} for co-simulation.</p>
{4}<p>Axes x and y turn with the carrier: x outward, y in the sense of carrier rotation. Forces and moments are those
on the planet; reverse them on the carrier. The planet's inertia is not in the bearing, pin ring and pin support
are. All communication steps greater than 0 are legal; inside a step a displacement goes on with the velocity given
beside it, unless its own derivative by time was set, and it stands there afterwards until it is set again. A step
over which the inputs leave what the model can follow is discarded; the log then says &quot;step too long&quot; and which
length would be accepted. The library for Linux requires glibc 2.29 or newer (2019).</p>
<table><tr><th>name</th><th>unit</th><th>meaning</th></tr>
{3}</table></body></html>
)";

constexpr const char* kStart =
    R"(<p>The bearing begins in balance under <code>start_load</code>, the load of the planet
on it, by default that of the case at its operating point: until somebody sets <code>planet.displacement</code>, it is the place
where the bearing carries that load, and the outputs <code>planet.start_displacement</code> say where that is under the parameters
and speeds that were set. Begin with the planet there, and nothing has to settle but the rollers.</p>
)";

std::string page(const fmu::NumberTable& numbers, const std::string& name) {
  const fmu::ModelFacts facts = fmu::facts_of(numbers);
  std::string rows;
  for (const fmu::Variable& one : fmu::variables_of(facts))
    rows +=
        fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", one.name, one.unit, escaped(one.meaning));
  return fmt::format(fmt::runtime(kPage), escaped(name), facts.meaning, fmu::program_version(), rows,
                     numbers.model == "bearing" ? kStart : "");
}

}  // namespace

std::vector<FmuLibrary> fmu_libraries(const fmu::NumberTable& numbers, fmu::Interface interface, bool windows,
                                      bool quiet) {
  std::vector<FmuLibrary> libraries;
  for (const Platform& platform : kPlatforms) {
    if (platform.on_request && !windows) continue;
    const fs::path file = libraries_folder() / platform.folder / (std::string("orbearing") + platform.ending);
    const std::string missing = fs::exists(file) ? "" : build_missing(platform, file, quiet);
    if (!missing.empty())
      throw ComputationFailed(
          fmt::format("fmu: no library for {}: {}{}", platform.folder, missing,
                      platform.on_request ? ". Without --windows the FMU is for Linux" : ""));
    libraries.push_back({interface == fmu::Interface::fmi3 ? platform.fmi3 : platform.folder,
                         fmu::model_identifier(numbers) + platform.ending, read_file(file)});
  }
  return libraries;
}

std::string fmu_content(const fmu::NumberTable& numbers, const fmu::DescriptionOptions& options,
                        const std::vector<FmuLibrary>& libraries) {
  std::vector<ArchiveFile> files{{"modelDescription.xml", fmu::model_description(numbers, options)},
                                      {std::string("resources/") + fmu::kModelFile, fmu::text_of(numbers)},
                                      {"documentation/index.html", page(numbers, options.name)},
                                      {"documentation/licenses/license.txt", license_text}};
  for (const FmuLibrary& library : libraries)
    files.push_back({"binaries/" + library.platform + "/" + library.file, library.content});
  return archive_of(files);
}

}  // namespace orbearing::app
