// Two symbols that GCC's C++ library takes from newer C libraries (2.32 and 2.34) than an FMU shall need.
// They are local to the FMU's library.
#include <sched.h>

extern "C" {

// "May be false though there is one thread only": atomic operations are never left out then.
char __libc_single_threaded = 0;  // NOLINT(bugprone-reserved-identifier)

int pthread_once(int* control, void (*routine)());

/// Runs `routine` once; `control` is 0 before, 1 meanwhile, 2 after.
int pthread_once(int* control, void (*routine)()) {
  constexpr int kBefore = 0, kMeanwhile = 1, kAfter = 2;
  int found = kBefore;
  if (__atomic_compare_exchange_n(control, &found, kMeanwhile, false, __ATOMIC_ACQUIRE, __ATOMIC_ACQUIRE)) {
    try {
      routine();
    } catch (...) {
      __atomic_store_n(control, kBefore, __ATOMIC_RELEASE);
      throw;
    }
    __atomic_store_n(control, kAfter, __ATOMIC_RELEASE);
    return 0;
  }
  while (__atomic_load_n(control, __ATOMIC_ACQUIRE) == kMeanwhile) sched_yield();
  return 0;
}
}
