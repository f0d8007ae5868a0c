// Two strips that carry semi-elliptic pressure across: mean displacement of one under the other.
//
// Let p = 2q/(pi b) sqrt(1 - y^2/b^2) on both and s = (y - y')/b. With <> the mean over both pressures, that
// of 1/r between cross-sections at a distance x is m(x/b)/b, m(xi) = <1/sqrt(xi^2 + s^2)>. Elements of finite
// length need its second antiderivative.
#pragma once

namespace orbearing::bearing::half_space {

/// Functions of xi = |x|/b.
struct StripKernel {
  double potential = 0.0;  // [-]  <xi arsinh(xi/s) - sqrt(xi^2 + s^2)>: second derivative is m
  double spread = 0.0;     // [-]  <sqrt(xi^2 + s^2)>: minus d[b potential(x/b)]/db
};

/// From a table for small distances (absolute error below 1e-9), from its expansion beyond. `distance` >= 0
/// [-].
StripKernel strip_kernel(double distance);

/// The same by quadrature, which the table is made from.
StripKernel strip_kernel_by_quadrature(double distance);

/// Beyond this distance [-] between cross-sections the expansion holds to 1e-9.
inline constexpr double kStripKernelFar = 10.0;

/// Far field between elements that do not touch, where terms linear in x cancel:
/// b potential = x ln x + b^2 second/x + b^4 fourth/x^3 + b^6 sixth/x^5 + b^8 eighth/x^7.
struct StripFarField {
  static constexpr double second = -1.0 / 8.0;
  static constexpr double fourth = 5.0 / 256.0;
  static constexpr double sixth = -35.0 / 3072.0;
  static constexpr double eighth = 735.0 / 65536.0;
  static constexpr double from = 6.0;  // [-]  |x|/b, from where the influence errs by less than 1e-7
};

}  // namespace orbearing::bearing::half_space
