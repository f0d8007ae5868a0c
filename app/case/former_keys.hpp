// Keys that had another name once: who still gives the former one is read as if he gave the present one.
#pragma once

#include <string>

#include "app/case/yaml_tree.hpp"

namespace orbearing::app {

/// The same path with present names; behind "sweep.", "uncertain." and "assumed.", and in one of several
/// sets, too.
std::string present_path(const std::string& path);

/// Gives all keys of a case file their present names. Where both names stand, the former one stays and is an
/// unknown key.
void rename_former_keys(Entry& root);

}  // namespace orbearing::app
