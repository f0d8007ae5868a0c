#include "orbearing/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace orbearing {

namespace {

constexpr std::size_t kLongestQuote = 60;  // [byte] enough to recognise the place

std::size_t length_by_lead(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

/// Code point of a whole character.
unsigned code_point(std::string_view character) {
  constexpr unsigned lead_bits[] = {0x7F, 0x1F, 0x0F, 0x07};
  unsigned code = static_cast<unsigned char>(character[0]) & lead_bits[character.size() - 1];
  for (const char c : character.substr(1)) code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  return code;
}

/// Written in as few bytes as it takes, no half of a pair of UTF-16, and within Unicode.
bool is_code_point(unsigned code, std::size_t length) {
  constexpr unsigned least[] = {0x0, 0x80, 0x800, 0x10000};
  return code >= least[length - 1] && !(code >= 0xD800 && code < 0xE000) && code < 0x110000;
}

/// Moves the cursor, ends the line, or changes the order in which others are shown.
bool is_control(unsigned code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

std::string escape(unsigned code) {
  if (code == '\n') return "\\n";
  if (code == '\t') return "\\t";
  if (code == '\r') return "\\r";
  return code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
}

}  // namespace

std::size_t utf8_character(std::string_view text, std::size_t at) {
  const std::size_t length = length_by_lead(static_cast<unsigned char>(text[at]));
  if (length == 0 || at + length > text.size()) return 0;
  const std::string_view rest = text.substr(at + 1, length - 1);
  const bool whole = std::all_of(rest.begin(), rest.end(),
                                 [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; });
  return whole && is_code_point(code_point(text.substr(at, length)), length) ? length : 0;
}

std::size_t first_byte_not_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_character(text, i);
    if (length == 0) return i;
    i += length;
  }
  return text.size();
}

std::size_t first_control_character(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(utf8_character(text, i), 1);
    const unsigned code = code_point(text.substr(i, length));
    const bool blank = code == '\t' || code == '\n' || code == '\r';
    if ((code < 0x20 && !blank) || (code >= 0x7F && code < 0xA0 && length > 1) || code == 0x7F) return i;
    i += length;
  }
  return text.size();
}

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_character(text, i);
    const std::string_view character = text.substr(i, std::max<std::size_t>(length, 1));
    if (length == 0)
      shown += escape(static_cast<unsigned char>(character[0]));
    else if (const unsigned code = code_point(character); is_control(code))
      shown += escape(code);
    else
      shown += character;
    i += character.size();
  }
  return shown;
}

std::string shortened(std::string_view text) {
  if (text.size() <= kLongestQuote) return printable(text);
  std::size_t end = 0;
  for (std::size_t next = 0; next <= kLongestQuote;
       next += std::max<std::size_t>(utf8_character(text, next), 1))
    end = next;
  return printable(text.substr(0, end)) + "...";
}

std::string quote(std::string_view text) {
  return "'" + shortened(text) + "'";
}

}  // namespace orbearing
