#include "app/case/field_use.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace orbearing::app {

Condition where(std::string path, std::vector<std::string> values) {
  return {.paths = {std::move(path)}, .values = std::move(values)};
}

Condition where_given(std::vector<std::string> paths) {
  return {.paths = std::move(paths)};
}

Condition where_absent(std::string path) {
  return {.paths = {std::move(path)}, .absent = true};
}

Condition where_true(bool (*holds)(const ResolvedCase&, std::string_view), std::string text) {
  return {.paths = {}, .holds = holds, .text = std::move(text)};
}

Use Use::when(Condition condition) const {
  Use more = *this;
  for (Way& way : more.ways) way.conditions.push_back(condition);
  more.conditions.push_back(std::move(condition));
  return more;
}

Use Use::used_too(AnalysisSet analyses, std::vector<Condition> all) const {
  Use more = *this;
  if (analyses.is_empty()) return more;
  more.ways.push_back({analyses, std::move(all)});
  return more;
}

Use Use::used_too(AnalysisSet analyses, Condition condition) const {
  return used_too(analyses, std::vector<Condition>{std::move(condition)});
}

Use Use::used_only(AnalysisSet analyses, std::vector<Condition> all) const {
  Use more = used_too(analyses & by, std::move(all));
  more.by = more.by.without(analyses);
  more.not_modelled_by |= by & analyses;
  return more;
}

Use Use::limited(AnalysisSet analyses, const std::vector<Condition>& either) const {
  Use more = *this;
  more.by = more.by.without(analyses);
  more.not_modelled_by |= by & analyses;
  more.ways.clear();
  std::vector<Way> limited = ways;
  if (by.has_some_of(analyses)) limited.push_back({by & analyses, {}});
  for (const Way& way : limited) {
    if (const AnalysisSet others = way.by.without(analyses); !others.is_empty())
      more.ways.push_back({others, way.conditions});
    if (!way.by.has_some_of(analyses)) continue;
    for (const Condition& condition : either) {
      more.ways.push_back({way.by & analyses, way.conditions});
      more.ways.back().conditions.push_back(condition);
    }
  }
  return more;
}

}  // namespace orbearing::app
