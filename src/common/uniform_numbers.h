// Random numbers that are the same with every library.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>

namespace vibroimpact {

class UniformNumbers {
public:
  /// Equal seeds give equal numbers.
  UniformNumbers(std::initializer_list<std::uint64_t> seeds) {
    std::seed_seq sequence(seeds.begin(), seeds.end());
    generator_.seed(sequence);
  }
  /// In [0, 1): the 53 bits of a double.
  double next() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  /// 0 ... size - 1.
  std::size_t below(std::size_t size) {
    return static_cast<std::size_t>(next() * static_cast<double>(size));
  }

private:
  std::mt19937_64 generator_;
};

} // namespace vibroimpact
