// Arrays that begin where a cache line does.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace vibroimpact::motion {

template <class T> struct AlignedAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  AlignedAllocator() = default;
  template <class U> explicit AlignedAllocator(const AlignedAllocator<U> &) {}

  T *allocate(std::size_t count) {
    return static_cast<T *>(::operator new(count * sizeof(T), alignment));
  }
  void deallocate(T *place, std::size_t) { ::operator delete(place, alignment); }
  template <class U> bool operator==(const AlignedAllocator<U> &) const { return true; }
};

using AlignedArray = std::vector<double, AlignedAllocator<double>>;

} // namespace vibroimpact::motion
