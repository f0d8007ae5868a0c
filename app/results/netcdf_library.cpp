#include "app/results/netcdf_library.hpp"

#ifdef ORBEARING_NETCDF_FILE
#include "app/results/loaded_library.hpp"
#endif

namespace orbearing::app {

namespace {

#ifdef ORBEARING_NETCDF_FILE
#define ORBEARING_OF_NETCDF(name) library.function<decltype(&::name)>(#name)
#else  // it is a part of this program
#define ORBEARING_OF_NETCDF(name) &::name
#endif

NetcdfLibrary functions() {
#ifdef ORBEARING_NETCDF_FILE
  const LoadedLibrary library("the netCDF library", {ORBEARING_NETCDF_FILE, ORBEARING_NETCDF_PATH});
#endif
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
  static const NetcdfLibrary library = functions();
  return library;
}

}  // namespace orbearing::app
