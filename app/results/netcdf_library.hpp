// The netCDF library, loaded when a file of its own is first read or written: it brings some forty libraries
// with it.
#pragma once

#include <netcdf.h>
#include <netcdf_mem.h>

namespace orbearing::app {

/// Its functions by their names without "nc_".
struct NetcdfLibrary {
  decltype(&::nc_abort) abort = nullptr;
  decltype(&::nc_close) close = nullptr;
  decltype(&::nc_close_memio) close_memio = nullptr;
  decltype(&::nc_create_mem) create_mem = nullptr;
  decltype(&::nc_def_dim) def_dim = nullptr;
  decltype(&::nc_def_var) def_var = nullptr;
  decltype(&::nc_def_var_deflate) def_var_deflate = nullptr;
  decltype(&::nc_def_var_fill) def_var_fill = nullptr;
  decltype(&::nc_enddef) enddef = nullptr;
  decltype(&::nc_get_att_double) get_att_double = nullptr;
  decltype(&::nc_get_att_text) get_att_text = nullptr;
  decltype(&::nc_get_var_double) get_var_double = nullptr;
  decltype(&::nc_inq_attlen) inq_attlen = nullptr;
  decltype(&::nc_inq_dimlen) inq_dimlen = nullptr;
  decltype(&::nc_inq_nvars) inq_nvars = nullptr;
  decltype(&::nc_inq_vardimid) inq_vardimid = nullptr;
  decltype(&::nc_inq_varid) inq_varid = nullptr;
  decltype(&::nc_inq_varname) inq_varname = nullptr;
  decltype(&::nc_inq_varndims) inq_varndims = nullptr;
  decltype(&::nc_inq_vartype) inq_vartype = nullptr;
  decltype(&::nc_open) open = nullptr;
  decltype(&::nc_put_att_text) put_att_text = nullptr;
  decltype(&::nc_put_var_double) put_var_double = nullptr;
  decltype(&::nc_strerror) strerror = nullptr;
};

/// Throws ComputationFailed where it cannot be loaded. May be called from several threads; the library itself
/// takes one at a time.
const NetcdfLibrary& netcdf();

}  // namespace orbearing::app
