// Messages of calls that no command makes, in the words and numbers of tests/messages.txt.
#pragma once

#include <gtest/gtest.h>

#include <exception>
#include <fstream>
#include <set>
#include <string>

namespace orbearing::messages {

/// Message of the `Error` that `call` throws.
template <class Error, class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("another kind of exception: ") + error.what();
  }
  return "nothing was refused";
}

/// Whether the table has `text` under `id`: one text, or one for each turn of a loop.
inline bool is_expected(const std::string& id, const std::string& text) {
  std::ifstream table(ORBEARING_SOURCE_DIR "/tests/messages.txt");
  std::string one_line = text;
  for (char& letter : one_line)
    if (letter == '\n') letter = '|';
  bool here = false;
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with("["))
      here = line == "[" + id + "]";
    else if (here && line == one_line)
      return true;
  }
  return false;
}

}  // namespace orbearing::messages

/// Fails unless `text` is listed under `id` in tests/messages.txt.
#define EXPECT_SAID(id, text) EXPECT_PRED2(::orbearing::messages::is_expected, std::string(id), std::string(text))

/// Fails unless the call throws an `Error` with the text that is listed under `id` in tests/messages.txt.
#define EXPECT_REFUSED(Error, id, ...) \
  EXPECT_SAID(id, ::orbearing::messages::refusal<Error>([&] { __VA_ARGS__; }))
