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

Use Use::used_too(unsigned analyses, std::vector<Condition> all) const {
  Use more = *this;
  if (analyses == 0) return more;
  more.ways.push_back({analyses, std::move(all)});
  return more;
}

Use Use::used_too(unsigned analyses, Condition condition) const {
  return used_too(analyses, std::vector<Condition>{std::move(condition)});
}

Use Use::used_only(unsigned analyses, std::vector<Condition> all) const {
  Use more = used_too(analyses & by, std::move(all));
  more.by &= ~analyses;
  more.not_modelled_by |= by & analyses;
  return more;
}

Use Use::limited(unsigned analyses, const std::vector<Condition>& either) const {
  Use more = *this;
  more.by &= ~analyses;
  more.not_modelled_by |= by & analyses;
  more.ways.clear();
  std::vector<Way> limited = ways;
  if ((by & analyses) != 0) limited.push_back({by & analyses, {}});
  for (const Way& way : limited) {
    if ((way.by & ~analyses) != 0) more.ways.push_back({way.by & ~analyses, way.conditions});
    if ((way.by & analyses) == 0) continue;
    for (const Condition& condition : either) {
      more.ways.push_back({way.by & analyses, way.conditions});
      more.ways.back().conditions.push_back(condition);
    }
  }
  return more;
}

}  // namespace orbearing::app
