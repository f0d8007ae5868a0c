// Loads the library of an FMU as an importer does, steps an instance of each version of FMI and prints
// outputs.
//
//   loader LIBRARY RESOURCES TOKEN STEPS STEP_SIZE REFERENCE=VALUE... REFERENCE...
//
// RESOURCES: folder. The inputs are set once, before initialization; outputs are printed with all digits, one
// line for each version. Runs on Linux and, built by MinGW, on Windows.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "coupling/fmu/fmi2.hpp"
#include "coupling/fmu/fmi3.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "loader: %s\n", what.c_str());
  std::exit(1);
}

#ifdef _WIN32
void* load(const char* library) {
  return reinterpret_cast<void*>(LoadLibraryA(library));
}
void* symbol(void* library, const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(reinterpret_cast<HMODULE>(library), name));
}
#else
void* load(const char* library) {
  return dlopen(library, RTLD_NOW | RTLD_LOCAL);
}
void* symbol(void* library, const char* name) {
  return dlsym(library, name);
}
#endif

template <class Function>
Function* function(void* library, const char* name) {
  void* const found = symbol(library, name);
  if (found == nullptr) fail(std::string("no function ") + name);
  Function* typed = nullptr;
  std::memcpy(&typed, &found, sizeof typed);
  return typed;
}
#define ORBEARING_CALL(name) function<name##TYPE>(library, #name)

struct Run {
  std::string resources, token;
  int steps = 0;
  double step = 0.0;  // [s]
  std::vector<unsigned> inputs, outputs;
  std::vector<double> values;
};

void check(int status, const char* what) {
  if (status != 0) fail(std::string(what) + ": status " + std::to_string(status));
}

void print(const char* version, const std::vector<double>& values) {
  std::printf("%s", version);
  for (const double value : values) std::printf(" %.17g", value);
  std::printf("\n");
}

void print_message(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String text, ...) {
  std::fprintf(stderr, "%s\n", text);
}
void print_message3(fmi3InstanceEnvironment, fmi3Status, fmi3String, fmi3String text) {
  std::fprintf(stderr, "%s\n", text);
}

void run_fmi2(void* library, const Run& run) {
  const fmi2CallbackFunctions callbacks{&print_message, nullptr, nullptr, nullptr, nullptr};
  const std::string location = (run.resources[0] == '/' ? "file://" : "file:///") + run.resources;
  const fmi2Component it = ORBEARING_CALL(fmi2Instantiate)(
      "loaded", fmi2CoSimulation, run.token.c_str(), location.c_str(), &callbacks, fmi2False, fmi2False);
  if (it == nullptr) fail("no instance of FMI 2.0");
  check(ORBEARING_CALL(fmi2SetReal)(it, run.inputs.data(), run.inputs.size(), run.values.data()), "set");
  check(ORBEARING_CALL(fmi2SetupExperiment)(it, fmi2False, 0.0, 0.0, fmi2False, 0.0), "experiment");
  check(ORBEARING_CALL(fmi2EnterInitializationMode)(it), "enter");
  check(ORBEARING_CALL(fmi2ExitInitializationMode)(it), "exit");
  for (int i = 0; i < run.steps; ++i)
    check(ORBEARING_CALL(fmi2DoStep)(it, i * run.step, run.step, fmi2True), "step");
  std::vector<double> out(run.outputs.size());
  check(ORBEARING_CALL(fmi2GetReal)(it, run.outputs.data(), out.size(), out.data()), "get");
  print("fmi2", out);
  check(ORBEARING_CALL(fmi2Terminate)(it), "terminate");
  ORBEARING_CALL(fmi2FreeInstance)(it);
}

void run_fmi3(void* library, const Run& run) {
  const fmi3Instance it = ORBEARING_CALL(fmi3InstantiateCoSimulation)(
      "loaded", run.token.c_str(), (run.resources + "/").c_str(), false, false, false, false, nullptr, 0,
      nullptr, &print_message3, nullptr);
  if (it == nullptr) fail("no instance of FMI 3.0");
  check(ORBEARING_CALL(fmi3SetFloat64)(it, run.inputs.data(), run.inputs.size(), run.values.data(),
                                       run.values.size()),
        "set");
  check(ORBEARING_CALL(fmi3EnterInitializationMode)(it, false, 0.0, 0.0, false, 0.0), "enter");
  check(ORBEARING_CALL(fmi3ExitInitializationMode)(it), "exit");
  bool flags[3];
  double last = 0.0;
  for (int i = 0; i < run.steps; ++i)
    check(ORBEARING_CALL(fmi3DoStep)(it, i * run.step, run.step, true, flags, flags + 1, flags + 2, &last),
          "step");
  std::vector<double> out(run.outputs.size());
  check(ORBEARING_CALL(fmi3GetFloat64)(it, run.outputs.data(), out.size(), out.data(), out.size()), "get");
  print("fmi3", out);
  check(ORBEARING_CALL(fmi3Terminate)(it), "terminate");
  ORBEARING_CALL(fmi3FreeInstance)(it);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6) fail("LIBRARY RESOURCES TOKEN STEPS STEP_SIZE REFERENCE=VALUE... REFERENCE...");
  Run run{argv[2], argv[3], std::atoi(argv[4]), std::atof(argv[5]), {}, {}, {}};
  for (int i = 6; i < argc; ++i) {
    const auto reference = static_cast<unsigned>(std::atoi(argv[i]));
    const char* equals = std::strchr(argv[i], '=');
    (equals == nullptr ? run.outputs : run.inputs).push_back(reference);
    if (equals != nullptr) run.values.push_back(std::atof(equals + 1));
  }
  void* const library = load(argv[1]);
  if (library == nullptr) fail(std::string("cannot load ") + argv[1]);
  run_fmi2(library, run);
  run_fmi3(library, run);
  return 0;
}
