// How much memory there is, for requests that could never be met.
#pragma once

#include <cstddef>
#include <string>

namespace vibroimpact {

/// What this process may still take [B]: the least of what the machine has available and of the
/// limits on the process and on the container it runs in.
double available_memory();

/// The most that this process has held so far [B].
double peak_memory();

/// Of the entries of vectors and matrices together.
template <class... Arrays> std::size_t bytes_of(const Arrays &...arrays) {
  return (std::size_t{0} + ... +
          (static_cast<std::size_t>(arrays.size()) * sizeof(*arrays.data())));
}

/// "1.2 kB", "24 GB"
std::string memory_text(double bytes);

/// Empty when `bytes` are available; otherwise "about 12 TB of memory are needed, but 20 GB are
/// available".
std::string lack_of_memory(double bytes);

} // namespace vibroimpact
