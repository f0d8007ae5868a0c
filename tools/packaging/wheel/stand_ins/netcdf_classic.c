/* What netCDF 4.9.0 takes from its part for HDF5 even where that is left out. */
#include <stddef.h>

#include "nc4internal.h"
#include "ncrc.h"

NCglobalstate* NC_getglobalstate(void) {
  static NCRCinfo no_files = {.ignore = 1};
  static NCglobalstate state = {.rcinfo = &no_files};
  return &state;
}

void NC_freeglobalstate(void) {}

/* As all types of the classic format. */
int NC4_inq_type_fixed_size(int file, nc_type type, int* fixed) {
  (void)file, (void)type;
  *fixed = 1;
  return NC_NOERR;
}
