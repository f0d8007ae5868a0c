// Libraries that are loaded at their first use: they bring others with them, and loading those takes longer
// than most commands.
#pragma once

#include <string>
#include <vector>

namespace orbearing::app {

/// A shared library with functions of C. It stays loaded until the program ends.
class LoadedLibrary {
 public:
  /// The first of these files that can be loaded: a name that the loader searches for, or a path. `title` is
  /// for messages. Throws ComputationFailed where there is none.
  LoadedLibrary(std::string title, const std::vector<std::string>& files);

  /// The function of that name. Throws ComputationFailed where the library has none.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  std::string title_;
  void* handle_ = nullptr;
};

}  // namespace orbearing::app
