#include "app/results/netcdf_library.hpp"

#ifdef ORBEARING_NETCDF_FILE
#include <dlfcn.h>
#include <fmt/format.h>
#endif

#include "app/errors.hpp"

namespace orbearing::app {

namespace {

#ifdef ORBEARING_NETCDF_FILE

// Stays loaded until the program ends.
void* loaded() {
  for (const char* file : {ORBEARING_NETCDF_FILE, ORBEARING_NETCDF_PATH})
    if (void* library = ::dlopen(file, RTLD_NOW | RTLD_LOCAL)) return library;
  throw ComputationFailed(fmt::format("the netCDF library cannot be loaded: {}", ::dlerror()));
}

template <class Function>
Function function_of(void* library, const char* name, Function) {
  void* const found = ::dlsym(library, name);
  if (found == nullptr)
    throw ComputationFailed(fmt::format("the netCDF library {} has no {}", ORBEARING_NETCDF_FILE, name));
  return reinterpret_cast<Function>(found);
}

#define ORBEARING_OF_NETCDF(name) function_of(library, #name, static_cast<decltype(&::name)>(nullptr))

#else  // it is a part of this program

void* loaded() {
  return nullptr;
}

#define ORBEARING_OF_NETCDF(name) &::name

#endif

NetcdfLibrary functions_of([[maybe_unused]] void* library) {
  return {.abort = ORBEARING_OF_NETCDF(nc_abort),
          .close = ORBEARING_OF_NETCDF(nc_close),
          .close_memio = ORBEARING_OF_NETCDF(nc_close_memio),
          .create_mem = ORBEARING_OF_NETCDF(nc_create_mem),
          .def_dim = ORBEARING_OF_NETCDF(nc_def_dim),
          .def_var = ORBEARING_OF_NETCDF(nc_def_var),
          .def_var_deflate = ORBEARING_OF_NETCDF(nc_def_var_deflate),
          .def_var_fill = ORBEARING_OF_NETCDF(nc_def_var_fill),
          .enddef = ORBEARING_OF_NETCDF(nc_enddef),
          .get_att_double = ORBEARING_OF_NETCDF(nc_get_att_double),
          .get_att_text = ORBEARING_OF_NETCDF(nc_get_att_text),
          .get_var_double = ORBEARING_OF_NETCDF(nc_get_var_double),
          .inq_attlen = ORBEARING_OF_NETCDF(nc_inq_attlen),
          .inq_dimlen = ORBEARING_OF_NETCDF(nc_inq_dimlen),
          .inq_nvars = ORBEARING_OF_NETCDF(nc_inq_nvars),
          .inq_vardimid = ORBEARING_OF_NETCDF(nc_inq_vardimid),
          .inq_varid = ORBEARING_OF_NETCDF(nc_inq_varid),
          .inq_varname = ORBEARING_OF_NETCDF(nc_inq_varname),
          .inq_varndims = ORBEARING_OF_NETCDF(nc_inq_varndims),
          .inq_vartype = ORBEARING_OF_NETCDF(nc_inq_vartype),
          .open = ORBEARING_OF_NETCDF(nc_open),
          .put_att_text = ORBEARING_OF_NETCDF(nc_put_att_text),
          .put_var_double = ORBEARING_OF_NETCDF(nc_put_var_double),
          .strerror = ORBEARING_OF_NETCDF(nc_strerror)};
}

}  // namespace

const NetcdfLibrary& netcdf() {
  static const NetcdfLibrary library = functions_of(loaded());
  return library;
}

}  // namespace orbearing::app
