#include "bearing/film/reynolds/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbearing::bearing::film {

namespace {

double corner(double x, double y) {
  return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}

}  // namespace

double rectangle_potential(double x, double y, double width, double height) {
  const double right = x + 0.5 * width, left = x - 0.5 * width;
  const double above = y + 0.5 * height, below = y - 0.5 * height;
  return corner(right, above) - corner(left, above) - corner(right, below) + corner(left, below);
}

HalfSpacePotential::HalfSpacePotential(Eigen::Index cells_x, Eigen::Index cells_y, double step_x,
                                       double step_y)
    : nx_(cells_x),
      ny_(cells_y),
      near_(cells_x + 1, cells_y + 1),
      re_(nx_ + 1, 2 * ny_),
      im_(nx_ + 1, 2 * ny_) {
  for (Eigen::Index j = 0; j <= ny_; ++j)
    for (Eigen::Index i = 0; i <= nx_; ++i)
      near_(i, j) = rectangle_potential(static_cast<double>(i) * step_x, static_cast<double>(j) * step_y,
                                        step_x, step_y);
  const Eigen::Index most = 2 * std::max(nx_, ny_);
  cosine_.resize(static_cast<std::size_t>(most));
  sine_.resize(static_cast<std::size_t>(most));
  for (Eigen::Index k = 0; k < most; ++k) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(most);
    cosine_[static_cast<std::size_t>(k)] = std::cos(angle);
    sine_[static_cast<std::size_t>(k)] = -std::sin(angle);
  }
  const std::size_t room = static_cast<std::size_t>(most * kBatch);
  for (Batch* batch : {&batch_, &spare_}) {
    batch->re.resize(room);
    batch->im.resize(room);
  }
  // The kernel is even: its spectrum is real and even.
  Field half(nx_ + 1, ny_ + 1);  // transformed along x
  for (Eigen::Index first = 0; first <= ny_; first += kBatch) {
    for (Eigen::Index i = 0; i < 2 * nx_; ++i)
      for (Eigen::Index b = 0; b < kBatch; ++b) {
        const std::size_t at = static_cast<std::size_t>(i * kBatch + b);
        batch_.re[at] = first + b <= ny_ ? near_(std::min(i, 2 * nx_ - i), first + b) : 0.0;
        batch_.im[at] = 0.0;
      }
    transform(batch_, spare_, 2 * nx_, false);
    for (Eigen::Index b = 0; b < kBatch && first + b <= ny_; ++b)
      for (Eigen::Index i = 0; i <= nx_; ++i)
        half(i, first + b) = batch_.re[static_cast<std::size_t>(i * kBatch + b)];
  }
  spectrum_.resize(nx_ + 1, ny_ + 1);
  const double scale = 1.0 / (4.0 * static_cast<double>(nx_) * static_cast<double>(ny_));
  for (Eigen::Index first = 0; first <= nx_; first += kBatch) {
    for (Eigen::Index j = 0; j < 2 * ny_; ++j)
      for (Eigen::Index b = 0; b < kBatch; ++b) {
        const std::size_t at = static_cast<std::size_t>(j * kBatch + b);
        batch_.re[at] = first + b <= nx_ ? half(first + b, std::min(j, 2 * ny_ - j)) : 0.0;
        batch_.im[at] = 0.0;
      }
    transform(batch_, spare_, 2 * ny_, false);
    for (Eigen::Index b = 0; b < kBatch && first + b <= nx_; ++b)
      for (Eigen::Index j = 0; j <= ny_; ++j)
        spectrum_(first + b, j) = scale * batch_.re[static_cast<std::size_t>(j * kBatch + b)];
  }
}

// Stockham's transform of radix 2: kBatch of them side by side, the innermost loop over neighbours in memory.
void HalfSpacePotential::transform(Batch& batch, Batch& spare, Eigen::Index length, bool back) const {
  const std::size_t most = cosine_.size();
  Batch *from = &batch, *to = &spare;
  std::size_t stride = kBatch;
  for (std::size_t n = static_cast<std::size_t>(length); n > 1; n /= 2, stride *= 2) {
    const std::size_t half = n / 2;
    for (std::size_t p = 0; p < half; ++p) {
      const double c = cosine_[p * (most / n)], s = back ? -sine_[p * (most / n)] : sine_[p * (most / n)];
      const double* __restrict ar = from->re.data() + stride * p;
      const double* __restrict ai = from->im.data() + stride * p;
      const double* __restrict br = ar + stride * half;
      const double* __restrict bi = ai + stride * half;
      double* __restrict sum_r = to->re.data() + stride * 2 * p;
      double* __restrict sum_i = to->im.data() + stride * 2 * p;
      double* __restrict dif_r = sum_r + stride;
      double* __restrict dif_i = sum_i + stride;
      for (std::size_t q = 0; q < stride; ++q) {
        const double dr = ar[q] - br[q], di = ai[q] - bi[q];
        sum_r[q] = ar[q] + br[q];
        sum_i[q] = ai[q] + bi[q];
        dif_r[q] = c * dr - s * di;
        dif_i[q] = c * di + s * dr;
      }
    }
    std::swap(from, to);
  }
  if (from != &batch) std::swap(batch, spare);
}

void HalfSpacePotential::operator()(const Field& pressure, Field& potential) const {
  const Eigen::Index length_x = 2 * nx_, length_y = 2 * ny_;
  const auto at = [](Eigen::Index i, Eigen::Index b) { return static_cast<std::size_t>(i * kBatch + b); };
  // Along x: rows of pressure by twos, as real and imaginary part.
  for (Eigen::Index first = 1; first < ny_; first += 2 * kBatch) {
    std::fill_n(batch_.re.begin(), length_x * kBatch, 0.0);
    std::fill_n(batch_.im.begin(), length_x * kBatch, 0.0);
    for (Eigen::Index b = 0; b < kBatch; ++b) {
      const Eigen::Index j = first + 2 * b;
      for (Eigen::Index i = 1; i < nx_; ++i) {
        if (j < ny_) batch_.re[at(i, b)] = pressure(i, j);
        if (j + 1 < ny_) batch_.im[at(i, b)] = pressure(i, j + 1);
      }
    }
    transform(batch_, spare_, length_x, false);
    for (Eigen::Index b = 0; b < kBatch; ++b) {
      const Eigen::Index j = first + 2 * b;
      if (j >= ny_) break;
      for (Eigen::Index i = 0; i <= nx_; ++i) {
        const std::size_t one = at(i, b), other = at(i == 0 ? 0 : length_x - i, b);
        re_(i, j) = 0.5 * (batch_.re[one] + batch_.re[other]);
        im_(i, j) = 0.5 * (batch_.im[one] - batch_.im[other]);
        if (j + 1 < ny_) {
          re_(i, j + 1) = 0.5 * (batch_.im[one] + batch_.im[other]);
          im_(i, j + 1) = 0.5 * (batch_.re[other] - batch_.re[one]);
        }
      }
    }
  }
  // Along y and back, times the kernel's spectrum.
  for (Eigen::Index first = 0; first <= nx_; first += kBatch) {
    const Eigen::Index width = std::min(kBatch, nx_ + 1 - first);
    std::fill_n(batch_.re.begin(), length_y * kBatch, 0.0);
    std::fill_n(batch_.im.begin(), length_y * kBatch, 0.0);
    for (Eigen::Index j = 1; j < ny_; ++j)
      for (Eigen::Index b = 0; b < width; ++b) {
        batch_.re[at(j, b)] = re_(first + b, j);
        batch_.im[at(j, b)] = im_(first + b, j);
      }
    transform(batch_, spare_, length_y, false);
    for (Eigen::Index j = 0; j < length_y; ++j)
      for (Eigen::Index b = 0; b < width; ++b) {
        const double factor = spectrum_(first + b, std::min(j, length_y - j));
        batch_.re[at(j, b)] *= factor;
        batch_.im[at(j, b)] *= factor;
      }
    transform(batch_, spare_, length_y, true);
    for (Eigen::Index j = 0; j <= ny_; ++j)
      for (Eigen::Index b = 0; b < width; ++b) {
        re_(first + b, j) = batch_.re[at(j, b)];
        im_(first + b, j) = batch_.im[at(j, b)];
      }
  }
  // Back along x: two real rows at once.
  potential.resize(nx_ + 1, ny_ + 1);
  for (Eigen::Index first = 0; first <= ny_; first += 2 * kBatch) {
    for (Eigen::Index b = 0; b < kBatch; ++b) {
      const Eigen::Index j = std::min(first + 2 * b, ny_), next = std::min(j + 1, ny_);
      for (Eigen::Index i = 0; i <= nx_; ++i) {
        batch_.re[at(i, b)] = re_(i, j) - im_(i, next);
        batch_.im[at(i, b)] = im_(i, j) + re_(i, next);
        if (i == 0 || i == nx_) continue;
        batch_.re[at(length_x - i, b)] = re_(i, j) + im_(i, next);
        batch_.im[at(length_x - i, b)] = re_(i, next) - im_(i, j);
      }
    }
    transform(batch_, spare_, length_x, true);
    for (Eigen::Index b = 0; b < kBatch; ++b) {
      const Eigen::Index j = first + 2 * b;
      if (j > ny_) break;
      for (Eigen::Index i = 0; i <= nx_; ++i) {
        potential(i, j) = batch_.re[at(i, b)];
        if (j < ny_) potential(i, j + 1) = batch_.im[at(i, b)];
      }
    }
  }
}

}  // namespace orbearing::bearing::film
