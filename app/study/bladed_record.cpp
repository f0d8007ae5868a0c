// Output of Bladed: a header "NAME.%04" of keys and values and the data "NAME.$04" beside it, as text or
// binary.
//
//     FORMAT   R*4                          R*8: binary numbers of 8 bytes, R*4: of 4
//     FORM     F                            F: text, U: binary
//     NDIMENS  2                            a value for each variable and step; more dimensions: stations of
//     a blade DIMENS   9  200                       variables, steps VARIAB   'Measured shaft power' ...
//     VARUNIT  P A/T FL ...                 P: W, A/T: rad/s, FL: N m, T: s, ...; Bladed writes SI
//     AXIUNIT  T
//     MIN  0.0
//     STEP 0.05
#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <map>
#include <sstream>

#include "app/case/text_parts.hpp"
#include "app/case/units.hpp"
#include "app/study/record_file.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little);

constexpr const char* kHeader =
    "a header of Bladed with NDIMENS, DIMENS, FORM, VARIAB, VARUNIT, MIN and STEP";

fs::path with_mark(const fs::path& file, char mark) {
  std::string extension = file.extension().string();
  extension[1] = mark;
  return fs::path(file).replace_extension(extension);
}

/// Values of the header by key; of a key that occurs twice the first.
class BladedHeader {
 public:
  explicit BladedHeader(const fs::path& file) : file_(file.string()) {
    std::ifstream stream(file, std::ios::binary);
    for (std::string line; std::getline(stream, line);) {
      std::istringstream words(line);
      std::string key;
      words >> key;
      values_.try_emplace(key, trimmed(line.substr(std::min(line.size(), line.find(key) + key.size()))));
    }
  }

  const std::string& text(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) refuse_record(file_, "no " + key, kHeader);
    return found->second;
  }

  /// Words, or texts in quotes.
  std::vector<std::string> words(const std::string& key) const {
    std::vector<std::string> words;
    const std::string& line = text(key);
    for (std::size_t at = line.find_first_not_of(" \t"); at < line.size();
         at = line.find_first_not_of(" \t", at)) {
      const bool quoted = line[at] == '\'';
      const std::size_t begin = quoted ? at + 1 : at;
      const std::size_t end = std::min(line.find_first_of(quoted ? "'" : " \t", begin), line.size());
      words.push_back(line.substr(begin, end - begin));
      at = std::min(line.size(), end + (quoted ? 1 : 0));
    }
    return words;
  }

  double number(const std::string& key) const {
    const Reading<double> number = read_number(text(key));
    if (!number.value) refuse_record(file_, fmt::format("{} as {}", quote(text(key)), key), "a number");
    return *number.value;
  }

  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::map<std::string, std::string> values_;
};

// Those of loads and motion; other quantities have none that is read.
std::string unit_of_code(const std::string& code) {
  static const std::map<std::string, std::string> units{{"T", "s"},   {"P", "W"},    {"A/T", "rad/s"},
                                                        {"A", "rad"}, {"FL", "N.m"}, {"F", "N"},
                                                        {"L", "m"},   {"L/T", "m/s"}};
  const auto found = units.find(code);
  return found == units.end() ? "" : found->second;
}

std::vector<ColumnHead> heads_of(const BladedHeader& header) {
  const std::vector<std::string> names = header.words("VARIAB"), codes = header.words("VARUNIT");
  if (names.size() != codes.size())
    refuse_record(header.file(), fmt::format("{} names and {} units", names.size(), codes.size()),
                  "as many of both");
  std::vector<ColumnHead> heads{{"time", "s"}};
  for (std::size_t i = 0; i < names.size(); ++i) heads.push_back({names[i], unit_of_code(codes[i])});
  return heads;
}

/// Rows of as many numbers as there are variables.
class BladedData {
 public:
  BladedData(const fs::path& file, const BladedHeader& header, std::size_t variables)
      : file_(file.string()), stream_(file, std::ios::binary), row_(variables) {
    text_ = header.text("FORM").starts_with('F');
    doubles_ = header.text("FORMAT") == "R*8";
    if (!text_ && !doubles_ && header.text("FORMAT") != "R*4")
      refuse_record(header.file(), fmt::format("the format {}", quote(header.text("FORMAT"))), "R*4 or R*8");
    if (!stream_) refuse_record(file_, "no file", "the data beside the header");
  }

  const std::vector<double>& next() {
    for (double& value : row_)
      if (text_)
        stream_ >> value;
      else
        value = doubles_ ? binary<double>() : static_cast<double>(binary<float>());
    if (!stream_)
      refuse_record(file_, "an end within its data, or no number", "as many numbers as DIMENS states");
    return row_;
  }

 private:
  template <class Number>
  Number binary() {
    Number number{};
    stream_.read(reinterpret_cast<char*>(&number), sizeof number);
    return number;
  }

  std::string file_;
  std::ifstream stream_;
  std::vector<double> row_;
  bool text_ = true;
  bool doubles_ = false;
};

}  // namespace

RecordTable record_of_bladed(const fs::path& file, const RecordColumns& wanted) {
  const fs::path header_file = with_mark(file, '%'), data_file = with_mark(file, '$');
  std::error_code ignored;
  if (!fs::is_regular_file(header_file, ignored))
    refuse_record(file.string(), "data of Bladed without the header " + header_file.filename().string(),
                  "both files in one folder");
  const BladedHeader header(header_file);
  const std::vector<ColumnHead> heads = heads_of(header);
  const std::vector<std::string> sizes = header.words("DIMENS");
  if (header.number("NDIMENS") != 2.0 || sizes.size() != 2 || header.text("AXIUNIT") != "T")
    refuse_record(header.file(), fmt::format("{} dimensions", header.text("NDIMENS")),
                  "output over time alone, of 2 dimensions");
  const double variables = read_number(sizes[0]).value.value_or(0.0),
               samples = read_number(sizes[1]).value.value_or(0.0);
  if (variables != static_cast<double>(heads.size() - 1) || !(samples >= 1.0))
    refuse_record(header.file(), fmt::format("{} variables and {} names", sizes[0], heads.size() - 1),
                  "as many of both, and steps");
  const auto place = [&](const ColumnHead& head) { return fmt::format("{}: {}", header.file(), head.name); };
  const std::vector<ChosenColumn> columns =
      chosen_columns({heads, header.file(), columns_text(heads), place, true}, wanted);
  BladedData data(data_file, header, heads.size() - 1);
  const double first = header.number("MIN"), step = header.number("STEP");
  RecordTable record;
  for (double sample = 0.0; sample < samples; sample += 1.0) {
    const std::vector<double>& row = data.next();
    for (const ChosenColumn& column : columns)
      record.take(column, column.position == 0 ? first + sample * step : row[column.position - 1]);
  }
  return record;
}

}  // namespace orbearing::app
