// Text of any source made fit to be shown: names of files and keys of others may hold what a terminal or a
// page takes as a command.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace orbearing {

/// Length [byte] of the UTF-8 character that begins at `at`; 0 where none does.
std::size_t utf8_character(std::string_view text, std::size_t at);

/// Position of the first byte that is not UTF-8, and of the first control character other than tab and end of
/// line; the size of the text where there is none.
std::size_t first_byte_not_utf8(std::string_view text);
std::size_t first_control_character(std::string_view text);

/// Control characters, marks that turn the direction of writing, and bytes that are not UTF-8 become
/// escapes ("\x1b", "\u202e"); all else stays. Applying it twice changes nothing more.
std::string printable(std::string_view text);

/// The same, cut to bearable length; "..." shows the cut.
std::string shortened(std::string_view text);

/// The same in quotes.
std::string quote(std::string_view text);

}  // namespace orbearing
