#include "page/opened.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <vector>

#include "orbearing/files.hpp"
#include "orbearing/quantity.hpp"
#include "orbearing/results.hpp"
#include "orbearing/templates.hpp"
#include "orbearing/text.hpp"
#include "orbearing/version.hpp"

namespace orbearing::page {

namespace {

namespace fs = std::filesystem;

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

Opened opened_folder(const fs::path& folder) {
  if (fs::exists(folder / manifest_name)) {
    Opened opened = opened_file(folder / resolved_case_name, "results");
    require_case_of_results(folder);
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

Json opened_json(const Opened& opened) {
  Json object{{"kind", opened.kind},
              {"name", opened.name},
              {"file", opened.file},
              {"text", opened.text},
              {"folder", opened.folder.string()},
              {"writable", !opened.folder.empty()},
              {"version", version()}};
  if (!opened.file.empty()) object["checksum"] = checksum(opened.text);
  if (!opened.fault.empty()) object["error"] = opened.fault;
  if (opened.kind == "results") try {
      object.update(Json::parse(results_json(opened.folder)));
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
  const ResultsInBrief found = results_in_brief(folder);
  return {{"name", folder.filename().string()},
          {"case", printable(found.case_name)},
          {"fidelity", found.fidelity},
          {"points", found.points},
          {"of", found.of}};
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
  write_file(place, text);
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
  try {
    // A conversion is exact to 15 digits.
    const std::string digits = fmt::format("{:.15g}", in_unit(value, unit));
    return {{"number", std::stod(digits)}, {"text", digits + " " + unit}};
  } catch (const BadInput& fault) {
    throw BadInput(std::string("request: value: ") + fault.what());
  }
}

}  // namespace orbearing::page
