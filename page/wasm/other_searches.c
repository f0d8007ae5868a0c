/* Searches of NLopt that the program does not call. NLopt's table of methods names them; without them the engine is a quarter
   of a megabyte smaller. */
#define NOT_CALLED(name) \
  int name(void) {       \
    return -2;           \
  }
NOT_CALLED(auglag_minimize)
NOT_CALLED(bobyqa)
NOT_CALLED(ccsa_quadratic_minimize)
NOT_CALLED(cdirect)
NOT_CALLED(cdirect_unscaled)
NOT_CALLED(chevolutionarystrategy)
NOT_CALLED(cobyla_minimize)
NOT_CALLED(crs_minimize)
NOT_CALLED(direct_optimize)
NOT_CALLED(isres_minimize)
NOT_CALLED(luksan_plip)
NOT_CALLED(luksan_plis)
NOT_CALLED(luksan_pnet)
NOT_CALLED(mlsl_minimize)
NOT_CALLED(mma_minimize)
NOT_CALLED(newuoa)
NOT_CALLED(praxis_)
