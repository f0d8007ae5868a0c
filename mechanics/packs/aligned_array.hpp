// An array for packs, without the standard containers, which files compiled for special instruction sets must
// not instantiate.
#pragma once

#include <new>

#include "mechanics/packs/pack.hpp"

namespace orbearing::mechanics::ORBEARING_PACKS {

/// Array on the boundary of a register.
template <class T>
class AlignedArray {
 public:
  explicit AlignedArray(int size) : data_(new (std::align_val_t{64}) T[static_cast<unsigned>(size)]()) {}
  ~AlignedArray() { operator delete[](data_, std::align_val_t{64}); }
  AlignedArray(const AlignedArray&) = delete;
  AlignedArray& operator=(const AlignedArray&) = delete;
  T& operator[](int i) { return data_[i]; }
  const T& operator[](int i) const { return data_[i]; }

 private:
  T* data_;
};

}  // namespace orbearing::mechanics::ORBEARING_PACKS
