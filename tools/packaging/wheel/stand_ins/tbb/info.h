#pragma once

#include <sched.h>

namespace tbb::info {

/// Processors that this process may use.
inline int default_concurrency() {
  cpu_set_t allowed;
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
}

}  // namespace tbb::info
