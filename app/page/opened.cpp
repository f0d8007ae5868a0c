#include "app/page/opened.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <vector>

#include "app/case/case_file.hpp"
#include "app/case/printable.hpp"
#include "app/case/units.hpp"
#include "app/checksum.hpp"
#include "app/commands/presentation.hpp"
#include "app/errors.hpp"
#include "app/resources.hpp"
#include "app/results/durable_file.hpp"
#include "app/results/result_folder.hpp"
#include "app/study/analysis.hpp"
#include "app/study/crown/crown_study.hpp"
#include "app/study/fidelity.hpp"
#include "app/study/report_data.hpp"
#include "app/version.hpp"

namespace orbearing::app::page {

namespace {

namespace fs = std::filesystem;

constexpr const char* resolved_name = "case.resolved.yaml";
constexpr const char* manifest_name = "manifest.jsonl";
constexpr std::uintmax_t largest_case = 4U << 20U;  // [byte]

Opened opened_file(const fs::path& file, const char* kind) {
  std::error_code ignored;
  if (fs::file_size(file, ignored) > largest_case)
    throw BadInput(file.string() + ": found more than 4 MiB; required: a case file");
  std::string text = read_file(file);
  if (const std::size_t byte = first_byte_not_utf8(text); byte != text.size())
    throw BadInput(fmt::format("{}: found a byte {} that is not UTF-8; required: a case file in UTF-8",
                               file.string(), byte + 1));
  fs::path folder = fs::absolute(file).parent_path();
  return {kind, file.filename().string(), std::move(text), file.filename().string(), std::move(folder)};
}

// Fault of a folder of results whose case has changed since its sweep began; else empty.
std::string fault_of_results(const fs::path& folder) {
  const fs::path file = folder / manifest_name;
  const Manifest manifest = parse_manifest(read_file(file), file.string());
  return manifest.header ? fault_of_case(folder, *manifest.header) : "";
}

Opened opened_folder(const fs::path& folder) {
  if (fs::exists(folder / manifest_name)) {
    Opened opened = opened_file(folder / resolved_name, "results");
    require_undamaged({fault_of_results(folder)});
    opened.name = fs::canonical(folder).filename().string();
    return opened;
  }
  if (fs::is_regular_file(folder / "case.yaml")) return opened_file(folder / "case.yaml", "case");
  throw BadInput(printable(folder.string()) +
                 ": found neither manifest.jsonl nor case.yaml; required: a folder of results, or "
                 "one with a case");
}

}  // namespace

Opened opened_as(const std::string& what) {
  if (what.empty()) return {"start", "", "", "", {}};
  std::error_code ignored;
  if (fs::is_directory(what, ignored)) return opened_folder(what);
  if (fs::exists(what, ignored)) return opened_file(what, "case");
  const std::vector<std::string>& names = template_names();
  if (std::ranges::find(names, what) != names.end())
    return {"template", what, case_template(what).text, "", {}};
  throw BadInput(fmt::format(
      "{}: found no such file, folder or template; required: a case file, a folder of results, or one of {}",
      quote(what), fmt::join(names, ", ")));
}

Opened read_again(const Opened& opened) {
  Opened now = opened;
  now.fault.clear();
  if (!opened.file.empty()) try {
      now.text = opened_file(opened.folder / opened.file, opened.kind.c_str()).text;
    } catch (const std::exception& error) {
      now.fault = printable(error.what());
    }
  return now;
}

namespace {

bool is_sweep(const Manifest& manifest) {
  const std::vector<std::string>& names = fidelity_names();
  return std::ranges::find(names, manifest.header->fidelity) != names.end();
}

// As --json printed it, where the folder holds it.
Json printed_result(const Opened& opened, const ResolvedCase& resolved) {
  if (holds_crown(opened.folder)) return read_crown(opened.folder).object;
  const Analysis* analysis = analysis_of(resolved);
  if (analysis == nullptr || analysis->names.json_file == nullptr) return nullptr;
  const fs::path file = opened.folder / analysis->names.json_file;
  return fs::exists(file) ? Json::parse(read_file(file)) : Json();
}

// Options by which `sweep --resume` continues.
Json options_of(const ManifestHeader& header) {
  Json options{{"fidelity", header.fidelity}, {"grid_only", !header.refined}};
  if (header.continued) options["continue"] = to_string(*header.continued);
  return options;
}

Json results_json(const Opened& opened) {
  const Manifest manifest = read_results(opened.folder);
  require_undamaged({fault_of_case(opened.folder, *manifest.header)});
  const ResolvedCase resolved = parse_case(opened.text, resolved_name);
  Json object{{"fidelity", manifest.header->fidelity}};
  if (!is_sweep(manifest)) {
    object["finished"] = !manifest.entries.empty();
    object["result"] = printed_result(opened, resolved);
    return object;
  }
  const SweepOutcome outcome = outcome_of(*manifest.header, manifest.entries);
  Json points = Json::array();
  for (const SweepRow& row : outcome.rows) points.push_back(row_json(outcome.header, row));
  const MissingPoints missing = missing_points(resolved, manifest);
  object["finished"] = missing.none();
  object["missing"] = missing_json(missing, manifest);
  object["points"] = std::move(points);
  Record form;
  if (missing.none())
    object["result"] = sweep_object(resolved, outcome, form);
  else if (!manifest.header->shard)
    object["options"] = options_of(*manifest.header);
  return object;
}

}  // namespace

Json opened_json(const Opened& opened) {
  Json object{{"kind", opened.kind},
              {"name", opened.name},
              {"file", opened.file},
              {"text", opened.text},
              {"folder", opened.folder.string()},
              {"writable", !opened.folder.empty()},
              {"version", program_version}};
  if (!opened.file.empty()) object["checksum"] = checksum(opened.text);
  if (!opened.fault.empty()) object["error"] = opened.fault;
  if (opened.kind == "results") try {
      object.update(results_json(opened));
    } catch (const std::exception& error) {
      object["error"] = printable(error.what());
    }
  return object;
}

namespace {

bool is_plain_name(const std::string& name) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  };
  return !name.empty() && name.front() != '.' && name.size() <= 100 && std::ranges::all_of(name, is_plain);
}

fs::path parent_of_results(const Opened& opened) {
  return opened.folder.empty() ? fs::current_path() : opened.folder;
}

// No link, which could lead elsewhere.
bool holds_results(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(folder, ignored)) &&
         fs::is_regular_file(fs::symlink_status(folder / manifest_name, ignored));
}

Json line_of_folder(const fs::path& folder) try {
  const Manifest manifest = read_results(folder);
  return {{"name", folder.filename().string()},
          {"case", printable(manifest.header->case_name)},
          {"fidelity", manifest.header->fidelity},
          {"points", manifest.entries.size()},
          {"of", std::max(manifest.header->own_points(), manifest.entries.size())}};
} catch (const std::exception&) {
  return nullptr;  // nothing to continue
}

}  // namespace

Json result_folders_json(const Opened& opened) {
  constexpr std::size_t most = 40;
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent_of_results(opened), ignored))
    if (is_plain_name(entry.path().filename().string()) && holds_results(entry.path()))
      found.emplace_back(fs::last_write_time(entry.path() / manifest_name, ignored), entry.path());
  std::ranges::sort(found, std::greater{});
  Json list = Json::array();
  for (const auto& [time, folder] : found)
    if (Json line = line_of_folder(folder); !line.is_null() && list.size() < most)
      list.push_back(std::move(line));
  return list;
}

Opened results_within(const Opened& opened, const std::string& name) {
  if (name.empty() && opened.kind == "results") return opened;
  const fs::path folder = parent_of_results(opened) / name;
  if (!is_plain_name(name) || !holds_results(folder))
    throw BadInput(fmt::format(
        "request: results: found {}; required: the name of a folder of results in the one that was opened",
        quote(name)));
  return opened_folder(folder);
}

Json templates_json() {
  Json list = Json::array();
  for (const std::string& name : template_names()) {
    const CaseTemplate one = case_template(name);
    list.push_back({{"name", one.name}, {"title", one.title}, {"purpose", one.purpose}, {"text", one.text}});
  }
  return list;
}

namespace {

// Throws OtherVersion where saving would overwrite a changed file; a file with the same text is no such case.
void require_version(const fs::path& file, const std::string& text, const std::string& began_with) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return;
  const std::string now = read_file(file);
  if (now != text && checksum(now) != began_with) throw OtherVersion{checksum(now)};
}

}  // namespace

void save(const Opened& opened, const std::string& file, const std::string& text,
          const std::string& began_with) {
  const std::string ending = fs::path(file).extension().string();
  const std::vector<std::string> endings{".yaml", ".yml", ".csv", ".json", ".html", ".txt"};
  if (!is_plain_name(file) || std::ranges::find(endings, ending) == endings.end())
    throw BadInput(fmt::format(
        "request: file: found {}; required: a plain name of letters, digits, '_', '-' and '.' that ends "
        "in one of {}",
        quote(file), fmt::join(endings, ", ")));
  const fs::path place = opened.folder / file;
  if (fs::exists(opened.folder / manifest_name) && fs::exists(fs::symlink_status(place)))
    throw BadInput(fmt::format(
        "request: file: found {}, which the folder of results holds; required: another name", quote(file)));
  require_no_link(place);
  require_version(place, text, began_with);
  write_aside_and_rename(place, text);
}

namespace {

std::string html(std::string_view text) {
  constexpr std::string_view signs = "&<>\"'";
  std::string escaped;
  for (const char c : printable(text))
    escaped += signs.find(c) == std::string_view::npos ? std::string(1, c) : fmt::format("&#{};", int{c});
  return escaped;
}

struct NamedLife {
  const char* key;
  const char* meaning;
};

constexpr NamedLife lives[] = {{"L10h", "one bearing, ISO 281: load rating and equivalent load"},
                               {"L10rh", "one bearing, ISO/TS 16281: load of each rolling element"},
                               {"L10mh", "one bearing, ISO 281 with a_ISO: oil and its cleanliness"},
                               {"L10mrh", "one bearing, ISO/TS 16281 with a_ISO"},
                               {"life_h", "one bearing, Lundberg and Palmgren"},
                               {"system_L10h", "all bearings together, ISO 281"},
                               {"system_L10rh", "all bearings together, ISO/TS 16281"},
                               {"system_L10mh", "all bearings together, ISO 281 with a_ISO"},
                               {"system_L10mrh", "all bearings together, ISO/TS 16281 with a_ISO"},
                               {"system_life_h", "all bearings together, Lundberg and Palmgren"}};

}  // namespace

std::string lives_table(const Opened& opened, const Json& result) {
  const Json points = result.value("points", Json::array());
  const Json& point = points.size() == 1 ? points.front() : result;
  std::string rows;
  for (const NamedLife& life : lives)
    if (const Json value = point.value(life.key, Json()); value.is_number())
      rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{:.0f} h</td></tr>\n", life.key,
                          life.meaning, std::round(value.get<double>()));
  if (rows.empty()) return no_lives("this analysis gives no life in hours");
  return fmt::format(
      "<table id=\"lives\">\n<caption>Lives of {} as opened, "
      "quasi-static</caption>\n<thead><tr><th>key</th><th>life "
      "of</th><th>hours</th></tr></thead>\n<tbody>\n{}</tbody>\n</table>\n",
      html(opened.name), rows);
}

std::string no_lives(const std::string& reason) {
  return fmt::format("<p id=\"lives\">No lives as opened: {}</p>\n", html(reason));
}

Json converted(const Json& request) {
  const auto text_at = [&](const char* key) {
    if (!request.is_object() || !request.contains(key) || !request[key].is_string())
      throw BadInput(fmt::format("request: {}: found no text; required: one", key));
    return request[key].get<std::string>();
  };
  const std::string value = text_at("value"), unit = text_at("unit");
  const Reading<WrittenQuantity> written = split_quantity(value);
  if (!written.value)
    throw BadInput(fmt::format("request: value: {}; required: a number with its unit", written.fault));
  const Reading<double> number = convert(written.value->value, written.value->unit, unit);
  if (!number.value)
    throw BadInput(fmt::format("request: value: {}; required: a unit of the same dimension as {}",
                               number.fault, quote(unit)));
  // A conversion is exact to 15 digits.
  const std::string digits = fmt::format("{:.15g}", *number.value);
  return {{"number", std::stod(digits)}, {"text", digits + " " + unit}};
}

}  // namespace orbearing::app::page
