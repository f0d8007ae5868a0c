#include "app/results/manifest_header.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "app/errors.hpp"

namespace orbearing::app {

namespace {

constexpr std::size_t most_shards = 1'000'000;  // as many as a sweep may have points

bool is_number(const std::string& text, std::size_t& number) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end && !text.empty();
}

}  // namespace

std::string to_string(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.count);
}

std::string to_string(Direction direction) {
  return direction == Direction::up ? "up" : "down";
}

Direction parse_direction(const std::string& text) {
  if (text == "up") return Direction::up;
  if (text == "down") return Direction::down;
  throw std::invalid_argument(text);
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  const std::size_t stroke = text.find('/');
  if (stroke == std::string::npos || !is_number(text.substr(0, stroke), shard.index) ||
      !is_number(text.substr(stroke + 1), shard.count) || shard.index < 1 || shard.index > shard.count ||
      shard.count > most_shards)
    throw BadInput(
        fmt::format("--shard: '{}'; i/n with i from 1 to n, and n at most {}, is required, as in --shard 2/3",
                    text, most_shards));
  return shard;
}

std::size_t ManifestHeader::own_points() const {
  if (!shard) return points;
  return points / shard->count + (points % shard->count >= shard->index ? 1 : 0);
}

std::vector<std::string> differences(const ManifestHeader& found, const ManifestHeader& required) {
  std::vector<std::string> lines;
  const auto compare = [&](const char* what, const std::string& one, const std::string& other) {
    if (one != other) lines.push_back(fmt::format("{} '{}' was found; '{}' is required", what, one, other));
  };
  compare("case", found.case_name, required.case_name);
  compare("resolved case with hash", found.case_hash, required.case_hash);
  compare("program version", found.program_version, required.program_version);
  compare("instruction set", found.instruction_set, required.instruction_set);
  compare("fidelity", found.fidelity, required.fidelity);
  const auto way = [](const ManifestHeader& header) {
    return header.continued ? to_string(*header.continued) : "none";
  };
  compare("direction of --continue", way(found), way(required));
  const auto grid_or_peak = [](const ManifestHeader& header) { return header.refined ? "on" : "off"; };
  compare("refinement of the peak", grid_or_peak(found), grid_or_peak(required));
  compare("table", found.table, required.table);
  compare("number of points", std::to_string(found.points), std::to_string(required.points));
  return lines;
}

}  // namespace orbearing::app
