// Several flight kernels side by side in vector lanes, each with its own phase, limit and length of
// pieces. What comes out is what FlightKernel::fly() gives, to the last bit.
#pragma once

#include "integration/flight_kernel.h"
#include "integration/lane_arrays.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace vibroimpact::integration {

/// In the order of their speed.
enum class VectorUnit { none, sse2, avx2, avx512 };

/// The fastest one that this machine has.
VectorUnit best_vector_unit();

class FlightLanes {
public:
  struct Landing {
    std::size_t owner = 0;
    FlightKernel::End end = FlightKernel::End::limit;
  };

  explicit FlightLanes(VectorUnit unit = best_vector_unit());

  bool full() const { return n_busy_ == n_lanes; }
  bool empty() const { return n_busy_ == 0; }

  /// Lets a kernel fly to `limit`; it must be left alone until it lands. Not when full(). An end
  /// that needs no flight comes back at once. `owner` is for the caller.
  std::optional<FlightKernel::End> add(FlightKernel &kernel, double limit, std::size_t owner);
  /// Flies until at least one kernel has landed, or the run is to stop. Not when empty(). Valid
  /// until the next call.
  const std::vector<Landing> &fly();
  /// Gives all flights up and tells whose they were.
  std::vector<std::size_t> clear();

private:
  struct FreeArray {
    void operator()(double *array) const;
  };

  void reserve(std::size_t n_groups, std::size_t n_guards);
  void allocate();
  void load(std::size_t lane);
  void load_sums(std::size_t lane, const GuardSums &sums);
  void unload(std::size_t lane);
  void leave(std::size_t lane);
  void read(const double *const (&from)[3], std::size_t lane, Amplitudes &to) const;
  void show_pieces();
  void land(std::size_t lane);

  FlyLanes fly_;
  std::unique_ptr<double, FreeArray> storage_;
  LaneArrays arrays_{};
  std::array<FlightKernel *, n_lanes> kernels_{}; ///< none: the lane is idle
  std::array<std::size_t, n_lanes> owners_{};
  std::size_t n_busy_ = 0;
  std::vector<Landing> landings_;
};

} // namespace vibroimpact::integration
