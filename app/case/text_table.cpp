#include "app/case/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/locale/encoding_utf.hpp>
#include <cctype>
#include <iterator>
#include <string_view>

#include "app/case/text_parts.hpp"
#include "app/case/units.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

constexpr const char* kNotText = "a text file in UTF-8";
constexpr std::size_t kMostLinesBefore = 60;  // the names of the columns: descriptions of a simulation
constexpr std::size_t kMostShownHeads = 40;

std::vector<TableCell> split_at_blanks(const std::string& line) {
  std::vector<TableCell> cells;
  for (std::size_t begin = 0; (begin = line.find_first_not_of(" \t\r", begin)) != std::string::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
    cells.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
    begin = end;
  }
  return cells;
}

bool is_bracketed(const std::string& text) {
  return text.size() >= 2 &&
         ((text.front() == '(' && text.back() == ')') || (text.front() == '[' && text.back() == ']'));
}

std::string without_brackets(const std::string& text) {
  return is_bracketed(text) ? trimmed(text.substr(1, text.size() - 2)) : text;
}

/// Separator of the columns, found in the line of names.
char separator_of(const std::string& line) {
  bool quoted = false;
  std::string found;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted) found += c;
  }
  for (const char separator : {';', '\t', ','})
    if (found.find(separator) != std::string::npos) return separator;
  return split_at_blanks(line).size() > 1 && found.find_first_of("[(\"") == std::string::npos ? ' ' : ',';
}

// With a point or a comma for the decimals.
bool is_number(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  return read_number(text).value.has_value();
}

// Whether programs write this text instead of a missing value: it is no unit.
bool is_missing_value(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::array<std::string_view, 11> words{"nan",  "nat", "na",   "n/a",  "#n/a",   "null",
                                                   "none", "inf", "-inf", "+inf", "missing"};
  return std::find(words.begin(), words.end(), text) != words.end();
}

// "s", "rpm", "kN-m", "[1/min]": no number, nor one with a unit, nor the word for a missing one.
bool may_be_unit(const std::string& cell) {
  const std::string text = without_brackets(cell);
  if (is_missing_value(text)) return false;
  const bool digit =
      !text.empty() && std::string_view("0123456789").find(text.front()) != std::string_view::npos;
  return !is_number(text) && (!digit || text.starts_with("1/"));
}

bool are_bracketed_units(const std::vector<TableCell>& cells) {
  return cells.size() >= 2 && std::all_of(cells.begin(), cells.end(),
                                          [](const TableCell& cell) { return is_bracketed(cell.text); });
}

bool are_units(const std::vector<TableCell>& cells) {
  const auto is_empty = [](const TableCell& cell) { return cell.text.empty(); };
  return cells.size() >= 2 && !std::all_of(cells.begin(), cells.end(), is_empty) &&
         std::all_of(cells.begin(), cells.end(),
                     [](const TableCell& cell) { return may_be_unit(cell.text); });
}

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// "1500" and "5" of "1500,5": whole numbers, the second without a sign.
bool are_halves(std::string_view whole, std::string_view decimals) {
  whole.remove_prefix(whole.starts_with('-') || whole.starts_with('+') ? 1 : 0);
  return all_digits(whole) && all_digits(decimals.substr(0, decimals.find_first_of("eE")));
}

// "1.500" and "12,500", in which three digits can follow a mark of thousands; not "0.500", "1500.000",
// "1.5e3".
bool may_be_grouped(std::string_view text, char mark) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t at = text.find(mark);
  const std::string_view whole = text.substr(0, at), rest = text.substr(at + 1);
  const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  const bool exponent = digits < rest.size() && (rest[digits] == 'e' || rest[digits] == 'E');
  return all_digits(whole) && whole.size() <= 3 && whole.front() != '0' && digits == 3 && !exponent;
}

std::string utf8_of_utf16(const std::string& bytes, bool big_endian) {
  std::u16string units;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto low = static_cast<unsigned char>(bytes[i + (big_endian ? 1 : 0)]);
    const auto high = static_cast<unsigned char>(bytes[i + (big_endian ? 0 : 1)]);
    units += static_cast<char16_t>(high << 8U | low);
  }
  try {
    if (bytes.size() % 2 != 0) throw boost::locale::conv::conversion_error();
    return boost::locale::conv::utf_to_utf<char>(units, boost::locale::conv::stop);
  } catch (const boost::locale::conv::conversion_error&) {
    fail(1, 1, "a file in UTF-16 with a character that is not whole", "an undamaged file, or one in UTF-8");
  }
}

// The bytes 0x80 to 0x9f differ between the codes that are called so: they become a mark of what is unknown.
std::string utf8_of_latin1(const std::string& line) {
  std::u32string characters;
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    characters += byte >= 0x80U && byte < 0xa0U ? U'\ufffd' : static_cast<char32_t>(byte);
  }
  return boost::locale::conv::utf_to_utf<char>(characters);
}

std::size_t first_beyond_ascii(const std::string& line) {
  return static_cast<std::size_t>(
      std::find_if(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80U; }) -
      line.begin());
}

}  // namespace

std::vector<TableCell> split_cells(const std::string& line, char separator) {
  if (separator == ' ') return split_at_blanks(line);
  std::vector<TableCell> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t first =
        std::min(line.find_first_not_of(separator == '\t' ? " " : " \t", begin), line.size());
    const bool quoted = first < line.size() && line[first] == '"';
    const std::size_t closing = quoted ? line.find('"', first + 1) : first;
    const std::size_t end = line.find(separator, std::min(closing, line.size()));
    std::string cell = trimmed(line.substr(begin, end == std::string::npos ? end : end - begin));
    if (quoted && cell.size() > 1 && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back({std::move(cell), static_cast<int>(first) + 1});
    if (end == std::string::npos) return cells;
    begin = end + 1;
  }
}

bool splits_decimal_commas(const std::vector<TableCell>& cells, std::size_t columns) {
  if (cells.size() <= columns) return false;
  std::size_t halves = 0;
  for (std::size_t i = 0; i + 1 < cells.size(); ++i)
    if (are_halves(cells[i].text, cells[i + 1].text)) {
      ++halves;
      ++i;
    }
  // If one value has a decimal point, no comma is a decimal comma.
  const bool points = std::any_of(cells.begin(), cells.end(), [](const TableCell& cell) {
    return cell.text.find('.') != std::string::npos;
  });
  return !points && halves >= cells.size() - columns;
}

TextTable::TextTable(std::istream& stream) : stream_(&stream) {
  std::string mark(2, '\0');
  stream.read(mark.data(), 2);
  is_utf16_ = stream.gcount() == 2 && (mark == "\xff\xfe" || mark == "\xfe\xff");
  if (is_utf16_) {
    const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    utf16_ = utf8_of_utf16(bytes, mark.front() == '\xfe');
  } else {
    stream.clear();
    stream.seekg(0);
  }
  find_head();
}

// The next line of the file that holds something, decoded.
bool TextTable::read_line(Line& line) {
  for (;; ++read_) {
    line.number = read_ + 1;
    if (is_utf16_) {
      if (utf16_position_ >= utf16_.size()) return false;
      const std::size_t end = std::min(utf16_.find('\n', utf16_position_), utf16_.size());
      line.text = utf16_.substr(utf16_position_, end - utf16_position_);
      utf16_position_ = end + 1;
    } else if (!std::getline(*stream_, line.text)) {
      return false;
    }
    if (line.number == 1 && line.text.starts_with("\xef\xbb\xbf")) line.text.erase(0, 3);
    const std::size_t first = line.text.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    if (line.text[first] == '#') {
      if (ahead_.empty() && heads_.empty())
        comments_.push_back({trimmed(line.text.substr(first + 1)), line.number});
      if (comments_.size() > 2) comments_.pop_front();
      continue;
    }
    ++read_;
    decode(line);
    return true;
  }
}

void TextTable::decode(Line& line) {
  if (const std::size_t zero = line.text.find('\0'); zero != std::string::npos)
    fail(line.number, static_cast<int>(zero) + 1, "a zero byte, which no text holds", kNotText);
  const std::size_t beyond = first_beyond_ascii(line.text);
  if (beyond == line.text.size()) return;
  const std::size_t byte = first_byte_not_utf8(line.text);
  const bool utf8 = byte == line.text.size();
  (utf8 ? utf8_line_ : latin1_line_) = line.number;
  // If the file has both encodings, one of them is damaged.
  if (utf8_line_ > 0 && (latin1_line_ > 0 || beyond < byte) && !utf8)
    fail(line.number, static_cast<int>(byte) + 1,
         fmt::format("a byte that is not UTF-8 in a file whose line {} holds UTF-8", utf8_line_), kNotText);
  if (utf8 && latin1_line_ > 0)
    fail(line.number, static_cast<int>(beyond) + 1,
         fmt::format("UTF-8 in a file whose line {} holds bytes that are not", latin1_line_), kNotText);
  if (!utf8) line.text = utf8_of_latin1(line.text);
}

bool TextTable::look_ahead(std::size_t lines) {
  Line line;
  while (ahead_.size() < lines && read_line(line)) ahead_.push_back(line);
  return ahead_.size() >= lines;
}

bool TextTable::take_line(Line& line) {
  if (!look_ahead(1)) return false;
  line = std::move(ahead_.front());
  ahead_.pop_front();
  return true;
}

void TextTable::find_head() {
  Line line;
  if (!look_ahead(1)) return;
  std::optional<char> stated;
  if (ahead_.front().text.starts_with("sep=") && ahead_.front().text.size() >= 5) {  // of spreadsheets
    stated = ahead_.front().text[4];
    ahead_.pop_front();
  }
  const auto cells_of = [&](const std::string& text, const std::string& names) {
    return split_cells(text, stated.value_or(separator_of(names)));
  };
  for (std::size_t i = 1; i < kMostLinesBefore && look_ahead(i + 1); ++i) {
    const std::string& names = ahead_[i - 1].text;
    const std::vector<TableCell> units = cells_of(ahead_[i].text, names);
    if (!are_bracketed_units(units) || units.size() != cells_of(names, names).size()) continue;
    ahead_.erase(ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(i - 1));
    break;
  }
  if (!take_line(line)) return;
  separator_ = stated.value_or(separator_of(line.text));
  head_line_ = line_ = line.number;
  if (take_names_of_comment(split_cells(line.text, separator_), stated)) {
    ahead_.push_front(std::move(line));
    return;
  }
  for (TableCell& cell : split_cells(line.text, separator_))
    heads_.push_back({cell.text, "", head_line_, cell.column});
  take_units();
}

// Rows without a line of names: a comment directly above them has as many names, perhaps with a line of units
// below.
bool TextTable::take_names_of_comment(const std::vector<TableCell>& cells, std::optional<char> stated) {
  const auto holds_number = [](const TableCell& cell) { return is_number(cell.text); };
  if (cells.size() < 2 || !std::all_of(cells.begin(), cells.end(), holds_number)) return false;
  if (comments_.empty()) return false;
  const auto cells_of = [&](const Line& comment, const Line& names) {
    return split_cells(comment.text, stated.value_or(separator_of(names.text)));
  };
  std::vector<TableCell> stated_units;
  if (comments_.size() == 2) stated_units = cells_of(comments_[1], comments_[0]);
  const bool units = are_bracketed_units(stated_units) && stated_units.size() == cells.size();
  const Line& names = units ? comments_.front() : comments_.back();
  const std::vector<TableCell> found = cells_of(names, names);
  if (found.size() != cells.size() || std::any_of(found.begin(), found.end(), holds_number)) return false;
  head_line_ = names.number;
  for (const TableCell& cell : found) heads_.push_back({cell.text, "", names.number, cell.column});
  for (std::size_t i = 0; units && i < heads_.size(); ++i)
    heads_[i].unit = without_brackets(stated_units[i].text);
  return true;
}

void TextTable::take_units() {
  if (!look_ahead(1)) return;
  const std::vector<TableCell> cells = split_cells(ahead_.front().text, separator_);
  if (cells.size() != heads_.size() || !are_units(cells)) return;
  for (std::size_t i = 0; i < cells.size(); ++i) heads_[i].unit = without_brackets(cells[i].text);
  line_ = ahead_.front().number;
  ahead_.pop_front();
}

bool TextTable::next(std::vector<TableCell>& cells) {
  Line line;
  if (!take_line(line)) {
    line_ = read_ + 1;
    return false;
  }
  line_ = line.number;
  cells = split_cells(line.text, separator_);
  if (separator_ == '\t' && cells.size() == heads_.size() + 1 && cells.back().text.empty()) cells.pop_back();
  if (cells.size() == heads_.size()) return true;
  TableFault fault{line_,
                   1,
                   {fmt::format("{} values", cells.size()),
                    fmt::format("a row of {} values as in line {}", heads_.size(), head_line_)}};
  if (cells.size() > heads_.size()) fault.column = cells[heads_.size()].column;
  if (separator_ == ',' && splits_decimal_commas(cells, heads_.size()))
    fault.message.found +=
        " (a decimal comma splits a number in two: commas separate values here, decimals follow a point)";
  throw fault;
}

std::string TextTable::number_text(const TableCell& cell) {
  const std::size_t end = std::min(cell.text.find_first_not_of("+-0123456789.,"), cell.text.size());
  std::string number = cell.text.substr(0, end);
  const auto points = std::count(number.begin(), number.end(), '.');
  const auto commas = std::count(number.begin(), number.end(), ',');
  if (points + commas == 0) return cell.text;
  if (points + commas > 1)
    fail(line_, cell.column,
         fmt::format("{} with {} marks between its digits", quote(cell.text), points + commas),
         "numbers without marks of thousands");
  Marks& own = commas > 0 ? commas_ : points_;
  const Marks& other = commas > 0 ? points_ : commas_;
  if (own.line == 0) own = {line_, cell.column, cell.text, false};
  if (other.line > 0)
    fail(line_, cell.column,
         fmt::format("{}, and {} in line {}: both a comma and a point", quote(cell.text), quote(other.text),
                     other.line),
         "one of them for decimals in all of the file, and no marks of thousands");
  const char mark = commas > 0 ? ',' : '.';
  own.sure = own.sure || !may_be_grouped(cell.text, mark) || (mark == '.' && separator_ == ',');
  std::replace(number.begin(), number.end(), ',', '.');
  return number + cell.text.substr(end);
}

void TextTable::require_plain_decimals() const {
  for (const Marks* marks : {&points_, &commas_})
    if (marks->line > 0 && !marks->sure)
      fail(marks->line, marks->column,
           fmt::format("{}, whose mark can be of decimals or of thousands, as in all of the file",
                       quote(marks->text)),
           "numbers without marks of thousands, one of them with decimals that show the mark (0.5)");
}

std::string TextTable::shown_heads() {
  if (heads_.size() < 2 || !look_ahead(1)) return "";
  const std::vector<TableCell> cells = split_cells(ahead_.front().text, separator_);
  const auto holds_number = [](const TableCell& cell) { return is_number(cell.text); };
  if (cells.size() < heads_.size() || std::none_of(cells.begin(), cells.end(), holds_number)) return "";
  return columns_text(heads_);
}

std::vector<std::string> TextTable::warnings() const {
  if (latin1_line_ == 0) return {};
  return {fmt::format("line {} is not UTF-8; it was read as Latin-1 (ISO 8859-1), which changes no number",
                      latin1_line_)};
}

std::string columns_text(const std::vector<ColumnHead>& heads) {
  std::string text;
  for (std::size_t i = 0; i < std::min(heads.size(), kMostShownHeads); ++i) {
    text += (i == 0 ? "" : ", ") + shortened(heads[i].name);
    if (!heads[i].unit.empty()) text += " [" + shortened(heads[i].unit) + "]";
  }
  if (heads.size() > kMostShownHeads) text += fmt::format(", ... ({} in all)", heads.size());
  return text;
}

}  // namespace orbearing::app
