// Functions of C libraries newer than 2.28 that the sources use. Included before each source by the compiler.
#pragma once

#include <dirent.h>
#include <features.h>
#include <spawn.h>

#include <cstdlib>

#if !__GLIBC_PREREQ(2, 34)
/// Closes those that are open now: a child closes nothing that another thread opens meanwhile.
inline int posix_spawn_file_actions_addclosefrom_np(posix_spawn_file_actions_t* actions, int first) {
  DIR* const open_ones = opendir("/proc/self/fd");
  if (open_ones == nullptr) return 0;
  while (const dirent* const entry = readdir(open_ones))
    if (const int number = std::atoi(entry->d_name); number >= first && number != dirfd(open_ones))
      posix_spawn_file_actions_addclose(actions, number);
  return closedir(open_ones);
}
#endif
