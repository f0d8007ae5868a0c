#include "app/case/uncertain_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>

#include "app/case/catalogue_quantities.hpp"
#include "app/case/drivetrain_analyses.hpp"
#include "app/case/field_table.hpp"
#include "app/case/input_keys.hpp"
#include "app/case/resolved_writer.hpp"
#include "app/case/settings.hpp"
#include "app/case/sweep_axes.hpp"
#include "app/case/unused_inputs.hpp"
#include "orbearing/text.hpp"

namespace orbearing::app {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
// A normal distribution may not leave the range of its field this far from its mean: it does so once in 10^9.
constexpr double kSurelyWithin = 6.0;  // [standard deviations]
constexpr double kNormallyWithin = 3.0;

// Words of a distribution, and which numbers it takes.
struct DistributionWords {
  std::string_view kind;
  std::array<std::string_view, 5> numbers;
  std::size_t required_first;  // of the numbers, how many must be given
};

constexpr const char* kDeviation = "standard_deviation";
constexpr const char* kRelativeDeviation = "relative_standard_deviation";  // [-]  of the mean's magnitude

constexpr std::array<DistributionWords, 3> kDistributions{
    {{"normal",
      {kDeviation, kRelativeDeviation, "mean", "from", "to"},
      0},  // one of the first two, see below
     {"uniform", {"from", "to"}, 2},
     {"triangular", {"from", "peak", "to"}, 3}}};

constexpr const char* required_distribution =
    "one of {normal: {standard_deviation: ..., mean: ..., from: ..., to: ...}}, {uniform: {from: ..., to: "
    "...}}, {triangular: {from: ..., peak: ..., to: ...}} or, for a radial clearance, {class: CN} is "
    "required. For normal, mean, from and to are optional, and the number relative_standard_deviation can "
    "replace standard_deviation. A reason is optional";

// The field of one number: of a list, that of its elements.
Field field_of_number(const Field& field) {
  Field one = field;
  if (field.kind == Kind::list) one.kind = field.element;
  return one;
}

bool is_list(const Field& field) {
  return field.kind == Kind::list;
}

// Reads the distribution of one key.
class UncertainReader {
 public:
  UncertainReader(const Field& field, const Member& member, std::vector<Mistake>& mistakes)
      : field_(field_of_number(field)),
        path_("uncertain." + member.key),
        entry_(member.value),
        mistakes_(mistakes) {
    stated_.path = member.key;
    stated_.location = member.location;
  }

  StatedUncertain read() {
    if (entry_.shape != Entry::Shape::block)
      add_error(entry_.location, path_, describe(entry_) + " found", required_distribution);
    else
      read_members();
    if (!parts_.empty()) stated_.written = fmt::format("{{{}}}", fmt::join(parts_, ", "));
    return std::move(stated_);
  }

 private:
  void add_error(Location location, const std::string& path, std::string found, std::string required) {
    mistakes_.push_back({location, path, {std::move(found), std::move(required)}});
  }

  void read_members() {
    read_each_once(entry_, path_, mistakes_, [&](const Member& member) {
      const std::string path = path_ + "." + member.key;
      if (member.key == "reason")
        read_reason(member, path);
      else
        read_distribution(member, path);
    });
    if (kinds_ != 1)
      add_error(entry_.location, path_, fmt::format("{} distributions", kinds_ == 0 ? "no" : "several"),
                required_distribution);
  }

  void read_reason(const Member& member, const std::string& path) {
    const bool text = member.value.shape == Entry::Shape::scalar &&
                      member.value.text.find_first_not_of(" \t\r\n") != std::string::npos;
    if (!text) {
      add_error(member.value.location, path, describe(member.value) + " found", "a text is required");
      return;
    }
    stated_.reason = member.value.text;
    parts_.push_back("reason: " + nlohmann::json(stated_.reason).dump());
  }

  void read_distribution(const Member& member, const std::string& path) {
    const auto words = std::find_if(kDistributions.begin(), kDistributions.end(),
                                    [&](const DistributionWords& one) { return one.kind == member.key; });
    if (words == kDistributions.end() && member.key != "class") {
      add_error(member.location, path, "unknown key", required_distribution);
      return;
    }
    ++kinds_;
    stated_.kind = member.key;
    if (member.key == "class")
      read_class(member, path);
    else if (member.value.shape != Entry::Shape::block)
      add_error(member.value.location, path, describe(member.value) + " found", required_distribution);
    else
      read_numbers(*words, member.value, path);
  }

  void read_class(const Member& member, const std::string& path) {
    if (field_.path != keys().radial_clearance) {
      add_error(member.location, path, "a clearance class of what is no clearance",
                "one of normal, uniform, triangular is required");
      return;
    }
    const FieldReading reading = read_field(*find_field(keys().clearance_class), member.value);
    if (!reading.good) {
      mistakes_.push_back({member.value.location, path, reading.message});
      return;
    }
    stated_.clearance_class = reading.value.given;
    parts_.push_back("class: " + stated_.clearance_class);
  }

  void read_numbers(const DistributionWords& words, const Entry& block, const std::string& path) {
    const std::size_t before = mistakes_.size();
    std::vector<std::string> written;
    read_each_once(block, path, mistakes_, [&](const Member& member) {
      const std::string at = path + "." + member.key;
      const bool known =
          !member.key.empty() && std::ranges::find(words.numbers, member.key) != words.numbers.end();
      if (!known)
        add_error(member.location, at, "unknown key", required_distribution);
      else if (const auto number = read_one(member, at))
        written.push_back(fmt::format("{}: {}", member.key, *number));
    });
    const auto has = [&](std::string_view key) { return find_member(block, key) != nullptr; };
    for (std::size_t i = 0; i < words.required_first; ++i)
      if (!has(words.numbers[i]))
        add_error(block.location, fmt::format("{}.{}", path, words.numbers[i]), "missing",
                  required_distribution);
    if (words.kind == "normal" && has(kDeviation) == has(kRelativeDeviation))
      add_error(block.location, fmt::format("{}.{}", path, kDeviation),
                has(kDeviation) ? fmt::format("found together with {}", kRelativeDeviation) : "missing",
                required_distribution);
    if (mistakes_.size() == before) check_order(words, block.location, path);
    parts_.push_back(fmt::format("{}: {{{}}}", words.kind, fmt::join(written, ", ")));
  }

  // A standard deviation is a difference, of any size above 0.
  std::optional<std::string> read_one(const Member& member, const std::string& path) {
    Field field = field_;
    if (member.key == kDeviation) field.range = described::positive();
    if (member.key == kRelativeDeviation) {
      field.kind = Kind::number;
      field.dimension = {};
      field.range = described::positive();
    }
    FieldReading reading = read_field(field, member.value);
    if (!reading.good) {
      mistakes_.push_back({member.value.location, path, reading.message});
      return std::nullopt;
    }
    stated_.numbers[member.key] = reading.value.number;
    return write_scalar(reading.value.given);
  }

  void check_order(const DistributionWords& words, Location location, const std::string& path) {
    const auto of = [&](const char* key) {
      const auto found = stated_.numbers.find(key);
      return found == stated_.numbers.end() ? std::optional<double>() : found->second;
    };
    const std::optional<double> from = of("from"), to = of("to"), peak = of("peak");
    if (from && to && !(*from < *to))
      add_error(location, path, "'from' is not less than 'to'", "a range is required");
    else if (words.kind == "triangular" && !(*from <= *peak && *peak <= *to))
      add_error(location, path, "a peak outside 'from' and 'to'", "one between them is required");
  }

  Field field_;
  std::string path_;
  const Entry& entry_;
  std::vector<Mistake>& mistakes_;
  StatedUncertain stated_;
  std::vector<std::string> parts_;
  int kinds_ = 0;
};

constexpr FieldsByPath uncertain_fields{.block = kUncertain,
                                        .takes = can_be_uncertain,
                                        .kind = "a real number or of a list of them",
                                        .wrong_kind = "a field that is no real number"};

constexpr const char* required_correlations =
    "{of: [PATH, ...], matrix: [[1, ...], ...]} with a row for each path is required";

// Numbers of one row; empty where something is wrong.
std::vector<double> read_matrix_row(const Entry& row, std::size_t size, std::vector<Mistake>& mistakes) {
  std::vector<double> numbers;
  const auto add_error = [&](const Entry& entry, std::string required) {
    mistakes.push_back(
        {entry.location, "uncertain.correlations.matrix", {describe(entry) + " found", std::move(required)}});
    numbers.clear();
  };
  if (row.shape != Entry::Shape::list || row.items.size() != size) {
    add_error(row, fmt::format("a row of {} numbers is required", size));
    return numbers;
  }
  for (const Entry& item : row.items) {
    const Reading<double> number = read_number(item.text);
    if (item.shape != Entry::Shape::scalar || item.quoted || !number.value || std::abs(*number.value) > 1.0) {
      add_error(item, "a number from -1 to 1 is required");
      return numbers;
    }
    numbers.push_back(*number.value);
  }
  return numbers;
}

std::string written_correlations(const StatedCorrelations& stated) {
  std::vector<std::string> rows;
  for (const std::vector<double>& row : stated.matrix)
    rows.push_back(fmt::format("[{}]", fmt::join(row, ", ")));
  std::vector<std::string> paths;
  for (const std::string& path : stated.of) paths.push_back(nlohmann::json(path).dump());
  return fmt::format("{{of: [{}], matrix: [{}]}}", fmt::join(paths, ", "), fmt::join(rows, ", "));
}

StatedCorrelations read_correlations(const Member& member, std::vector<Mistake>& mistakes) {
  StatedCorrelations stated;
  stated.location = member.location;
  const std::size_t before = mistakes.size();
  const Member* of = find_member(member.value, "of");
  const Member* matrix = find_member(member.value, "matrix");
  const bool lists = of != nullptr && matrix != nullptr && member.value.members.size() == 2 &&
                     of->value.shape == Entry::Shape::list && matrix->value.shape == Entry::Shape::list &&
                     of->value.items.size() == matrix->value.items.size() && !of->value.items.empty();
  if (!lists) {
    mistakes.push_back({member.value.location,
                        "uncertain.correlations",
                        {describe(member.value) + " found", required_correlations}});
    return stated;
  }
  for (const Entry& path : of->value.items) stated.of.push_back(path.text);
  for (const Entry& row : matrix->value.items)
    stated.matrix.push_back(read_matrix_row(row, stated.of.size(), mistakes));
  if (mistakes.size() == before) stated.written = written_correlations(stated);
  return stated;
}

// The case, or the set of the path, as a case of one set.
ResolvedCase set_of_path(const ResolvedCase& in, const std::string& path) {
  const std::size_t prefix = set_prefix_length(path);
  if (prefix == 0) return in;
  constexpr std::size_t block = std::string_view("sets.").size();
  return in.of_set(path.substr(block, prefix - block - 1));
}

double number_of(const StatedUncertain& stated, const char* key, double otherwise) {
  const auto found = stated.numbers.find(key);
  return found == stated.numbers.end() ? otherwise : found->second;
}

// `value` is the case's own.
UncertainInput input_of(const ResolvedCase& in, const StatedUncertain& stated, double value) {
  UncertainInput one;
  one.path = stated.path;
  one.distribution = stated.kind;
  one.value = value;
  one.mean = stated.kind == "normal" ? number_of(stated, "mean", value) : none;
  one.standard_deviation =
      number_of(stated, kDeviation, number_of(stated, kRelativeDeviation, none) * std::abs(one.mean));
  one.from = number_of(stated, "from", none);
  one.peak = number_of(stated, "peak", none);
  one.to = number_of(stated, "to", none);
  if (stated.kind == "normal" && !(std::isnan(one.from) && std::isnan(one.to)))
    one.distribution = "truncated-normal";
  if (stated.kind == "class") {
    const auto range = clearance_range_of(set_of_path(in, stated.path), stated.clearance_class);
    one.distribution = "uniform";
    one.from = range.least;
    one.to = range.most;
  }
  const Field& field = *find_field(stated.path);
  one.si_unit = field.dimension.si.empty() ? "1" : std::string(field.dimension.si);
  one.unit = field.dimension.si.empty() ? "1" : std::string(field.dimension.customary);
  if (one.unit != one.si_unit) one.units_per_si = *convert(1.0, one.si_unit, one.unit).value;
  one.written = stated.written;
  one.reason = stated.reason;
  return one;
}

std::vector<UncertainInput> inputs_of_key(const ResolvedCase& in, const StatedUncertain& stated) {
  if (!is_list(*find_field(stated.path))) return {input_of(in, stated, in.value(stated.path).number)};
  std::vector<UncertainInput> elements;
  for (const double value : in.list(stated.path)) {
    elements.push_back(input_of(in, stated, value));
    elements.back().path += fmt::format("[{}]", elements.size() - 1);
  }
  return elements;
}

class UncertainCheck {
 public:
  UncertainCheck(const ResolvedCase& in, std::vector<Mistake>& mistakes) : in_(in), mistakes_(mistakes) {}

  void check(const StatedUncertain& stated) {
    if (!stands(stated)) return;
    const std::vector<UncertainInput> inputs = inputs_of_key(in_, stated);
    if (!check_deviations(stated, inputs)) return;
    for (const UncertainInput& one : inputs) {
      if (!check_range(stated, one)) return;
      check_ends(stated, one);
      if (is_list(*find_field(stated.path))) return;  // its other elements have the same
    }
  }

 private:
  void add_error(const StatedUncertain& stated, std::string found, std::string required) {
    mistakes_.push_back(
        {stated.location, "uncertain." + stated.path, {std::move(found), std::move(required)}});
  }

  // Whether there is a value whose place a sample can take.
  bool stands(const StatedUncertain& stated) {
    if (!in_.has(stated.path)) {
      add_error(stated, "a number that the case does not have",
                stated.path + ", the expected value, is required as well");
      return false;
    }
    if (in_.is_replaced(stated.path) || is_given_by_another(stated.path)) {
      add_error(stated, "a number that another input replaces",
                "a case without it is required: only the input that gives it can be uncertain");
      return false;
    }
    return stated.kind != "class" || stands_as_class(stated);
  }

  // As the clearance by its class: a number without a default that is not stated, and would have no effect.
  bool is_given_by_another(const std::string& path) const {
    const Input input{path, find_field(path)};
    return in_.assumed().contains(path) && input.field->default_text.empty() &&
           use_status_in_row(in_, input, AnalysisId::quasi_static) == UseStatus::used &&
           !is_used(in_, input, AnalysisId::quasi_static);
  }

  bool stands_as_class(const StatedUncertain& stated) {
    const ResolvedCase set = set_of_path(in_, stated.path);
    if (!set.has(keys().clearance_state) || set.choice(keys().clearance_state) != "unmounted") {
      add_error(stated, "a clearance class of a clearance that is not unmounted",
                "bearing.clearance_state: unmounted, with its fits, is required");
      return false;
    }
    try {
      (void)clearance_range_of(set, stated.clearance_class);
      return true;
    } catch (const std::invalid_argument& error) {
      add_error(stated, "class " + stated.clearance_class, error.what());
      return false;
    }
  }

  // A share of a mean of 0 is no deviation. Where a setting made the mean 0, the command that samples reports
  // it.
  bool check_deviations(const StatedUncertain& stated, const std::vector<UncertainInput>& inputs) {
    if (in_.location(stated.path).option && !stated.location.option) return true;
    const bool sound =
        stated.kind != "normal" || std::all_of(inputs.begin(), inputs.end(),
                                               [](const auto& one) { return one.standard_deviation > 0.0; });
    if (!sound)
      add_error(stated,
                stated.numbers.contains(kRelativeDeviation) ? "a relative_standard_deviation of a mean of 0"
                                                            : "a standard deviation of 0",
                "a standard_deviation above 0, with its unit, is required");
    return sound;
  }

  // As stated, or so many standard deviations from the mean.
  static std::pair<double, double> ends_of(const UncertainInput& one, double deviations) {
    const double reach = deviations * one.standard_deviation;
    return {std::isnan(one.from) ? one.mean - reach : one.from,
            std::isnan(one.to) ? one.mean + reach : one.to};
  }

  bool check_range(const StatedUncertain& stated, const UncertainInput& one) {
    if (stated.kind != "normal") return true;
    const auto [low, high] = ends_of(one, kSurelyWithin);
    const bool within = in_range(stated, low) && in_range(stated, high);
    if (!within)
      add_error(stated, "a normal distribution beyond the range of its number",
                requirement(*find_field(stated.path)) +
                    " is required within six standard deviations. Limit the distribution by from or to");
    else if (one.mean < low || one.mean > high)
      add_error(stated, "a mean outside 'from' and 'to'", "one between them is required");
    return within && one.mean >= low && one.mean <= high;
  }

  // As users read it.
  std::string customary_text(double value, const Field& field) const {
    if (field.kind != Kind::quantity) return fmt::format("{}", value);
    const Dimension& dimension = field.dimension;
    return fmt::format("{:.6g} {}", *convert(value, dimension.si, dimension.customary).value,
                       dimension.customary);
  }

  bool in_range(const StatedUncertain& stated, double value) const {
    return read_field_number(field_of_number(*find_field(stated.path)), value).good;
  }

  // Mistakes of the case at a value near either end of the distribution.
  void check_ends(const StatedUncertain& stated, const UncertainInput& one) {
    auto [low, high] = ends_of(one, kNormallyWithin);
    if (stated.kind == "normal") {
      low = std::max(low, one.mean - kNormallyWithin * one.standard_deviation);
      high = std::min(high, one.mean + kNormallyWithin * one.standard_deviation);
    }
    for (const double end : {low, high}) {
      std::vector<Mistake> found;
      const std::string path = stated.path + (is_list(*find_field(stated.path)) ? "[0]" : "");
      (void)in_.without_sweep().with({{path, "", end}}, found);
      if (found.empty()) continue;
      const Field field = field_of_number(*find_field(stated.path));
      add_error(stated,
                fmt::format("'{}' contradicts {}: {}", customary_text(end, field), found.front().path,
                            found.front().message.found),
                found.front().message.required);
      return;
    }
  }

  const ResolvedCase& in_;
  std::vector<Mistake>& mistakes_;
};

void check_correlations(const ResolvedCase& in, std::vector<Mistake>& mistakes) {
  const StatedCorrelations& stated = in.uncertain().correlations;
  if (stated.written.empty()) return;
  const auto add_error = [&](std::string found, std::string required) {
    mistakes.push_back({stated.location, "uncertain.correlations", {std::move(found), std::move(required)}});
  };
  std::set<std::string> known, seen;
  for (const UncertainInput& one : uncertain_inputs(in).inputs) known.insert(one.path);
  for (const std::string& path : stated.of) {
    if (!known.contains(path))
      add_error(
          quote(path) + " as a path",
          fmt::format("paths of uncertain numbers, elements of lists by their index from 0, are required: {}",
                      fmt::join(known, ", ")));
    if (!seen.insert(path).second) add_error(quote(path) + " is listed twice", "each path once is required");
  }
  const auto size = static_cast<Eigen::Index>(stated.of.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      matrix(i, j) = stated.matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  if (matrix != matrix.transpose() || !(matrix.diagonal().array() == 1.0).all())
    add_error("a matrix that is not symmetric with ones on its diagonal",
              "a matrix of correlations is required");
  else if (matrix.llt().info() != Eigen::Success)
    add_error("a matrix that is not positive definite",
              "correlations that all can hold at once, none of them 1 or -1, are required");
}

std::vector<std::vector<double>> all_correlations(const StatedCorrelations& stated,
                                                  const std::vector<UncertainInput>& inputs) {
  std::vector<std::vector<double>> matrix(inputs.size(), std::vector<double>(inputs.size(), 0.0));
  const auto index_of = [&](const std::string& path) {
    return static_cast<std::size_t>(std::find(stated.of.begin(), stated.of.end(), path) - stated.of.begin());
  };
  for (std::size_t i = 0; i < inputs.size(); ++i)
    for (std::size_t j = 0; j < inputs.size(); ++j) {
      const std::size_t row = index_of(inputs[i].path), column = index_of(inputs[j].path);
      const bool stands = row < stated.of.size() && column < stated.of.size();
      matrix[i][j] = i == j ? 1.0 : stands ? stated.matrix[row][column] : 0.0;
    }
  return matrix;
}

}  // namespace

bool can_be_uncertain(const Field& field) {
  if (is_limit(field)) return false;
  if (field.kind == Kind::list)
    return field.columns.empty() && (field.element == Kind::quantity || field.element == Kind::number);
  return field.kind == Kind::quantity || field.kind == Kind::number;
}

StatedUncertainty read_uncertain(const Entry& block, unsigned model, const CaseShape& shape,
                                 std::vector<Mistake>& mistakes) {
  StatedUncertainty stated;
  read_each_once(block, "uncertain", mistakes, [&](const Member& member) {
    if (member.key == kCorrelations)
      stated.correlations = read_correlations(member, mistakes);
    else if (const Field* field = field_by_path(uncertain_fields, member, model, shape, mistakes))
      stated.inputs.push_back(UncertainReader(*field, member, mistakes).read());
  });
  return stated;
}

void check_uncertain(const ResolvedCase& resolved, std::vector<Mistake>& mistakes) {
  if (!mistakes.empty() || resolved.model() == no_model) return;  // ends are tried on a sound case
  UncertainCheck check(resolved, mistakes);
  for (const StatedUncertain& stated : resolved.uncertain().inputs) check.check(stated);
  if (mistakes.empty()) check_correlations(resolved, mistakes);
}

UncertainInputs uncertain_inputs(const ResolvedCase& resolved) {
  UncertainInputs found;
  for (const StatedUncertain& stated : resolved.uncertain().inputs)
    for (UncertainInput& one : inputs_of_key(resolved, stated)) found.inputs.push_back(std::move(one));
  found.correlations = all_correlations(resolved.uncertain().correlations, found.inputs);
  return found;
}

// Values that are not finite are written as null.
nlohmann::json uncertain_json(const ResolvedCase& resolved) {
  const UncertainInputs found = uncertain_inputs(resolved);
  nlohmann::json inputs = nlohmann::json::array();
  for (const UncertainInput& one : found.inputs)
    inputs.push_back({{"path", one.path},
                      {"distribution", one.distribution},
                      {"value", one.value},
                      {"mean", one.mean},
                      {"standard_deviation", one.standard_deviation},
                      {"from", one.from},
                      {"peak", one.peak},
                      {"to", one.to},
                      {"si_unit", one.si_unit},
                      {"unit", one.unit},
                      {"units_per_si", one.units_per_si},
                      {"given", one.written},
                      {"reason", one.reason}});
  return {{"inputs", inputs}, {"correlations", found.correlations}};
}

std::vector<std::string> uncertain_warnings(const ResolvedCase& resolved) {
  std::vector<std::string> warnings;
  if (resolved.model() != planetary_drivetrain) return warnings;
  for (const StatedUncertain& stated : resolved.uncertain().inputs) {
    const Input input{stated.path, find_field(stated.path)};
    if (use_status_in_row(resolved, input, AnalysisId::quasi_static) != UseStatus::used)
      warnings.push_back("uncertain." + stated.path + ": not modelled by " +
                         analysis_name(AnalysisId::quasi_static) + ", on which lives are sampled");
  }
  return warnings;
}

}  // namespace orbearing::app
