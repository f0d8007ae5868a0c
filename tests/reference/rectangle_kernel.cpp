#include "tests/reference/rectangle_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace orbearing::bearing::half_space {

namespace {

/// Beyond this many of the greatest side the expansion errs by less than 1e-6, and the closed form would
/// lose as much by cancellation.
constexpr double kFar = 16.0;

/// a arsinh(b/a), zero at a = 0.
double a_arsinh(double a, double b) {
  return a > 0.0 ? a * std::asinh(b / a) : 0.0;
}

/// F with d^2/dx^2 d^2/dy^2 F = 1/r, even in both.
double fourth_integral(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  const double r = std::hypot(x, y);
  return 0.5 * x * y * (a_arsinh(x, y) + a_arsinh(y, x)) - r * r * r / 6.0;
}

/// G with d/dx d/dy G = 1/r, odd in both.
double second_integral(double x, double y) {
  const double magnitude = a_arsinh(std::abs(x), std::abs(y)) + a_arsinh(std::abs(y), std::abs(x));
  return std::signbit(x) == std::signbit(y) ? magnitude : -magnitude;
}

double closed_form(const RectanglePair& pair) {
  const double sum = 0.5 * (pair.length + pair.receiver_length);
  const double difference = 0.5 * (pair.length - pair.receiver_length);
  const auto across = [&](double x) {
    return fourth_integral(x, pair.across + pair.width) - 2.0 * fourth_integral(x, pair.across) +
           fourth_integral(x, pair.across - pair.width);
  };
  return (across(pair.along + sum) - across(pair.along + difference)) -
         (across(pair.along - difference) - across(pair.along - sum));
}

/// Mean of 1/r by the second moments of both rectangles.
double expansion(const RectanglePair& pair, double r) {
  const double along = (pair.length * pair.length + pair.receiver_length * pair.receiver_length) / 12.0;
  const double across = pair.width * pair.width / 6.0;
  const double x = pair.along / r, y = pair.across / r;
  const double second = 0.5 * (along * (3.0 * x * x - 1.0) + across * (3.0 * y * y - 1.0)) / (r * r);
  return pair.length * pair.receiver_length * pair.width * pair.width * (1.0 + second) / r;
}

}  // namespace

double love_integral(const RectanglePair& pair) {
  const double left = pair.along - 0.5 * pair.length, right = pair.along + 0.5 * pair.length;
  const double low = pair.across - 0.5 * pair.width, high = pair.across + 0.5 * pair.width;
  return second_integral(right, high) - second_integral(left, high) - second_integral(right, low) +
         second_integral(left, low);
}

double mutual_integral(const RectanglePair& pair) {
  const double r = std::hypot(pair.along, pair.across);
  return r > kFar * std::max({pair.length, pair.receiver_length, pair.width}) ? expansion(pair, r)
                                                                              : closed_form(pair);
}

}  // namespace orbearing::bearing::half_space
