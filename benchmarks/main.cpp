// orbearing_bench [--json] [--with FILE]...: all figures of benchmarks/README.md, those in the JSON files
// with them. Started by tools/bench. orbearing_bench --variants: what lanes of variants could save, as JSON.
#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/report.hpp"
#include "benchmarks/variants.hpp"

namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
  bool right = true;
  bool json = false;
  bool variants = false;
  std::vector<std::string> with;
};

Arguments arguments_of(int argc, char** argv) {
  Arguments found;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--json")
      found.json = true;
    else if (word == "--variants")
      found.variants = true;
    else if (word == "--with" && i + 1 < argc)
      found.with.emplace_back(argv[++i]);
    else
      found.right = false;
  }
  return found;
}

Json read(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  return Json::parse(in);
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = arguments_of(argc, argv);
  if (!arguments.right) {
    fmt::print(stderr, "usage: orbearing_bench [--json] [--with FILE]... | --variants\n");
    return 2;
  }
  try {
    if (arguments.variants) {
      fmt::print("{}\n", orbearing::bench::measure_variants().dump(2));
      return 0;
    }
    std::vector<Json> others;
    for (const std::string& file : arguments.with) others.push_back(read(file));
    Json figures = orbearing::bench::measure();
    for (const Json& other : others) figures.update(other, true);
    fmt::print("{}\n", arguments.json ? figures.dump(2) : orbearing::bench::table(figures));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "orbearing_bench: {}\n", error.what());
    return 1;
  }
}
