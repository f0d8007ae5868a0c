// Binary output of OpenFAST, .outb. All numbers are little-endian:
//
//   int16 form      1 packed with times, 2 packed at equal steps, 3 doubles at equal steps, 4 as 2 with long
//   names int16 length    of a name and of a unit; form 4 alone, else 10 int32 channels, without time; int32
//   samples double scale, offset of the times (form 1); first time, step (others) float scale[channels],
//   offset[channels], not in form 3 int32 length, char description[length] char name[channels + 1][length],
//   unit[channels + 1][length], time first int32 time[samples], form 1 alone samples x channels of int16, in
//   form 3 of double, sample by sample
//
// value = (packed - offset)/scale, of times too.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>

#include "app/study/record_file.hpp"

namespace orbearing::app {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little);

enum class Form : std::int16_t { with_time = 1, without_time = 2, doubles = 3, long_names = 4 };

class OpenfastFile {
 public:
  explicit OpenfastFile(const fs::path& file)
      : file_(file), stream_(file, std::ios::binary), size_(fs::file_size(file)) {
    form_ = static_cast<Form>(number<std::int16_t>());
    const int length = form_ == Form::long_names ? number<std::int16_t>() : 10;
    channels_ = number<std::int32_t>();
    samples_ = number<std::int32_t>();
    if (length < 1 || channels_ < 1 || samples_ < 1)
      refuse_damaged(
          fmt::format("{} channels, {} samples and names of {} characters", channels_, samples_, length));
    time_first_ = number<double>();
    time_second_ = number<double>();
    if (form_ != Form::doubles) {
      scales_ = numbers<float>(channels_);
      offsets_ = numbers<float>(channels_);
    }
    text(number<std::int32_t>());
    read_heads(length);
    require_whole();
  }

  const std::vector<ColumnHead>& heads() const { return heads_; }

  RecordTable read(const std::vector<ChosenColumn>& columns) {
    RecordTable record{.warnings = warnings_};
    const std::vector<double> times = read_times();
    for (int sample = 0; sample < samples_; ++sample) {
      const std::vector<double> row = read_row();
      for (const ChosenColumn& column : columns)
        record.take(column, column.position == 0 ? times[static_cast<std::size_t>(sample)]
                                                 : row[column.position - 1]);
    }
    return record;
  }

 private:
  [[noreturn]] void refuse_damaged(const std::string& found) const {
    refuse_record(file_.string(), found, "an undamaged binary file of OpenFAST (.outb)");
  }

  std::uintmax_t bytes_left() { return size_ - static_cast<std::uintmax_t>(stream_.tellg()); }

  template <class Number>
  std::vector<Number> numbers(int count) {
    // A damaged count requests more than there is.
    const std::uintmax_t size = static_cast<std::uintmax_t>(count) * sizeof(Number);
    if (!stream_ || size > bytes_left()) refuse_damaged("an end within its data");
    std::vector<Number> values(static_cast<std::size_t>(count));
    stream_.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(size));
    return values;
  }

  template <class Number>
  Number number() {
    return numbers<Number>(1).front();
  }

  std::string text(int length) {
    if (length < 0) refuse_damaged(fmt::format("a text of {} characters", length));
    const std::vector<char> characters = numbers<char>(length);
    const std::string all(characters.begin(), characters.end());
    const std::size_t end = all.find_last_not_of(std::string_view(" \0", 2));
    return end == std::string::npos ? "" : all.substr(0, end + 1);
  }

  void read_heads(int length) {
    for (int i = 0; i <= channels_; ++i) heads_.push_back({text(length), ""});
    for (ColumnHead& head : heads_) {
      head.unit = text(length);
      const bool bracketed = head.unit.size() > 2 && head.unit.front() == '(' && head.unit.back() == ')';
      if (bracketed) head.unit = head.unit.substr(1, head.unit.size() - 2);
    }
  }

  std::uintmax_t bytes_of_sample() const {
    const std::size_t size = form_ == Form::doubles ? sizeof(double) : sizeof(std::int16_t);
    return static_cast<std::uintmax_t>(channels_) * size +
           (form_ == Form::with_time ? sizeof(std::int32_t) : 0);
  }

  void require_whole() {
    const std::uintmax_t found = bytes_left();
    const std::uintmax_t required = bytes_of_sample() * static_cast<std::uintmax_t>(samples_);
    if (found < required)
      refuse_damaged(fmt::format("{} bytes of {} samples, which take {}", found, samples_, required));
    if (found > required)
      warnings_.push_back(fmt::format("{}: {} bytes after its {} samples were not read", file_.string(),
                                      found - required, samples_));
  }

  std::vector<double> read_times() {
    std::vector<double> times(static_cast<std::size_t>(samples_));
    if (form_ == Form::with_time) {
      const std::vector<std::int32_t> packed = numbers<std::int32_t>(samples_);
      for (std::size_t i = 0; i < times.size(); ++i) times[i] = (packed[i] - time_second_) / time_first_;
    } else {
      for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = time_first_ + static_cast<double>(i) * time_second_;
    }
    return times;
  }

  std::vector<double> read_row() {
    if (form_ == Form::doubles) return numbers<double>(channels_);
    const std::vector<std::int16_t> packed = numbers<std::int16_t>(channels_);
    std::vector<double> row(packed.size());
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = (static_cast<double>(packed[i]) - static_cast<double>(offsets_[i])) /
               static_cast<double>(scales_[i]);
    return row;
  }

  fs::path file_;
  std::ifstream stream_;
  std::uintmax_t size_ = 0;  // [byte]
  Form form_ = Form::without_time;
  int channels_ = 0;
  int samples_ = 0;
  double time_first_ = 0.0;   // scale of the times of form 1, else the first time [unit of time]
  double time_second_ = 0.0;  // their offset, else the step
  std::vector<float> scales_;
  std::vector<float> offsets_;
  std::vector<ColumnHead> heads_;
  std::vector<std::string> warnings_;
};

}  // namespace

RecordTable record_of_openfast(const fs::path& path, const RecordColumns& wanted) {
  OpenfastFile file(path);
  const auto place = [&](const ColumnHead& head) { return fmt::format("{}: {}", path.string(), head.name); };
  const RecordHeads offered{file.heads(), path.string(), columns_text(file.heads()), place, true};
  return file.read(chosen_columns(offered, wanted));
}

}  // namespace orbearing::app
