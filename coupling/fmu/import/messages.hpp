// What an FMU logs, kept for the error that may follow.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>
#include <string>

namespace orbearing::fmu {

/// The last messages since the last call of take(). May be written by threads of the FMU.
class Messages {
 public:
  void add(const char* category, const char* text);
  /// "; it says: ..." and forgets them, or nothing where there are none.
  std::string take();

 private:
  static constexpr std::size_t most = 20;
  std::mutex mutex_;
  std::deque<std::string> lines_;
};

}  // namespace orbearing::fmu
