// orbearing_bench [--json]: all figures of benchmarks/README.md. Started by tools/bench.
#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <string_view>

#include "benchmarks/report.hpp"

int main(int argc, char** argv) {
  const bool json = argc == 2 && std::string_view(argv[1]) == "--json";
  if (argc > 1 && !json) {
    fmt::print(stderr, "usage: orbearing_bench [--json]\n");
    return 2;
  }
  try {
    const nlohmann::ordered_json figures = orbearing::bench::measure();
    fmt::print("{}\n", json ? figures.dump(2) : orbearing::bench::table(figures));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "orbearing_bench: {}\n", error.what());
    return 1;
  }
}
