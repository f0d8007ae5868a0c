// Elliptic integrals of the standard, which libc++ lacks. Included before each source by the compiler, for
// builds with that library: in a browser and in a wheel.
#pragma once

#include <version>

#if !defined(__cpp_lib_math_special_functions)
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

namespace std {
inline double comp_ellint_1(double k) {
  return boost::math::ellint_1(k);
}
inline double comp_ellint_2(double k) {
  return boost::math::ellint_2(k);
}
}  // namespace std
#endif
