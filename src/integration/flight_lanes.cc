#include "integration/flight_lanes.h"

#include "common/signals.h"

#include <algorithm>
#include <new>
#include <stdexcept>

namespace vibroimpact::integration {

namespace {

constexpr std::align_val_t alignment{64};
/// The value of a guard that a kernel does not have.
constexpr double no_guard = 1e300;

FlyLanes function_of(VectorUnit unit) {
#ifdef __x86_64__
  switch (unit) {
  case VectorUnit::none:
    return fly_lanes_plain;
  case VectorUnit::sse2:
    return fly_lanes_sse2;
  case VectorUnit::avx2:
    return fly_lanes_avx2;
  case VectorUnit::avx512:
    return fly_lanes_avx512;
  }
#endif
  return fly_lanes_plain;
}

// One lane of an array.
class Lane {
public:
  Lane(double *array, std::size_t lane) : array_(array + lane) {}
  double &operator[](std::size_t entry) const { return array_[entry * n_lanes]; }

private:
  double *array_;
};

} // namespace

VectorUnit best_vector_unit() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f"))
    return VectorUnit::avx512;
  return __builtin_cpu_supports("avx2") ? VectorUnit::avx2 : VectorUnit::sse2;
#else
  return VectorUnit::none;
#endif
}

void FlightLanes::FreeArray::operator()(double *array) const {
  operator delete[](array, alignment);
}

FlightLanes::FlightLanes(VectorUnit unit) : fly_(function_of(unit)) {
  if (unit > best_vector_unit())
    throw std::logic_error("this machine does not have that vector unit");
  arrays_.n_groups = 4;
  arrays_.n_guards = 4;
  allocate();
  landings_.reserve(n_lanes);
}

// All lanes idle.
void FlightLanes::allocate() {
  LaneArrays &a = arrays_;
  const std::size_t both = a.n_groups * a.n_guards;
  struct Part {
    double *&array;
    std::size_t entries;
  };
  const Part parts[] = {{a.rate, a.n_groups},
                        {a.frequency, a.n_groups},
                        {a.start_real, a.n_groups},
                        {a.start_imaginary, a.n_groups},
                        {a.start_size, a.n_groups},
                        {a.end_real, a.n_groups},
                        {a.end_imaginary, a.n_groups},
                        {a.end_size, a.n_groups},
                        {a.constant, a.n_guards},
                        {a.bound, a.n_guards},
                        {a.margin, a.n_guards},
                        {a.zero, a.n_guards},
                        {a.start_value, a.n_guards},
                        {a.start_slope, a.n_guards},
                        {a.end_value, a.n_guards},
                        {a.end_slope, a.n_guards},
                        {a.real, both},
                        {a.imaginary, both},
                        {a.fourth, both},
                        {a.size, both},
                        {a.fastest, 1},
                        {a.limit, 1},
                        {a.shortest, 1},
                        {a.least, 1},
                        {a.stage, 1},
                        {a.end, 1},
                        {a.flown, 1},
                        {a.h, 1},
                        {a.tries, 1},
                        {a.low, 1},
                        {a.high, 1},
                        {a.falling, 1},
                        {a.time_to_guard, 1},
                        {a.residual, 1},
                        {a.pieces, 1},
                        {a.accepted, 1},
                        {a.watched, 1},
                        {a.passed, 1}};
  std::size_t total = 0;
  for (const Part &part : parts)
    total += part.entries * n_lanes;
  storage_.reset(static_cast<double *>(operator new[](total * sizeof(double), alignment)));
  std::fill_n(storage_.get(), total, 0.0);
  double *next = storage_.get();
  for (const Part &part : parts) {
    part.array = next;
    next += part.entries * n_lanes;
  }
}

// The kernels in flight keep what the lanes know of them meanwhile, but for the numbers of one
// entry.
void FlightLanes::reserve(std::size_t n_groups, std::size_t n_guards) {
  if (n_groups <= arrays_.n_groups && n_guards <= arrays_.n_guards)
    return;
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    if (kernels_[lane])
      unload(lane);
  const LaneArrays before = arrays_;
  const std::unique_ptr<double, FreeArray> old = std::move(storage_);
  arrays_.n_groups = std::max(arrays_.n_groups, n_groups);
  arrays_.n_guards = std::max(arrays_.n_guards, n_guards);
  allocate();
  const double *end_of_old = before.passed + n_lanes;
  std::copy(static_cast<const double *>(before.fastest), end_of_old, arrays_.fastest);
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    if (kernels_[lane])
      load(lane);
}

// Aligned at the last group, so that the groups of the inputs are side by side.
void FlightLanes::load_sums(std::size_t lane, const GuardSums &sums) {
  const std::size_t n_groups = sums.n_groups();
  const std::size_t empty = arrays_.n_groups - n_groups;
  const Lane rate(arrays_.rate, lane), frequency(arrays_.frequency, lane);
  for (std::size_t j = 0; j < empty; ++j)
    rate[j] = frequency[j] = 0;
  for (std::size_t j = 0; j < n_groups; ++j) {
    rate[empty + j] = sums.rate[j];
    frequency[empty + j] = sums.frequency[j];
  }
  const Lane constant(arrays_.constant, lane);
  const Lane real(arrays_.real, lane), imaginary(arrays_.imaginary, lane);
  const Lane fourth(arrays_.fourth, lane), size(arrays_.size, lane);
  for (std::size_t g = 0; g < arrays_.n_guards; ++g) {
    const bool present = g < sums.n_guards();
    constant[g] = present ? sums.constant[g] : no_guard;
    const std::size_t row = g * arrays_.n_groups;
    const std::size_t filled = present ? empty : arrays_.n_groups;
    for (std::size_t j = 0; j < filled; ++j)
      real[row + j] = imaginary[row + j] = fourth[row + j] = size[row + j] = 0;
    for (std::size_t j = filled; j < arrays_.n_groups; ++j) {
      const std::size_t from = g * n_groups + j - empty;
      real[row + j] = sums.real[from];
      imaginary[row + j] = sums.imaginary[from];
      fourth[row + j] = sums.fourth[from];
      size[row + j] = sums.size[from];
    }
  }
  Lane(arrays_.fastest, lane)[0] = sums.fastest;
}

void FlightLanes::load(std::size_t lane) {
  const FlightKernel &kernel = *kernels_[lane];
  load_sums(lane, *kernel.sums_);
  const std::size_t empty = arrays_.n_groups - kernel.n_groups_;
  const Lane real(arrays_.start_real, lane), imaginary(arrays_.start_imaginary, lane);
  const Lane size(arrays_.start_size, lane);
  for (std::size_t j = 0; j < empty; ++j)
    real[j] = imaginary[j] = size[j] = 0;
  for (std::size_t j = 0; j < kernel.n_groups_; ++j) {
    real[empty + j] = kernel.start_.real[j];
    imaginary[empty + j] = kernel.start_.imaginary[j];
    size[empty + j] = kernel.start_.size[j];
  }
  const Lane value(arrays_.start_value, lane), slope(arrays_.start_slope, lane);
  const Lane bound(arrays_.bound, lane), margin(arrays_.margin, lane), zero(arrays_.zero, lane);
  for (std::size_t g = 0; g < arrays_.n_guards; ++g) {
    const bool present = g < kernel.n_guards_;
    value[g] = present ? kernel.starts_[g].value : no_guard;
    slope[g] = present ? kernel.starts_[g].slope : 0.0;
    bound[g] = present ? kernel.bounds_[g] : 0.0;
    margin[g] = present ? kernel.margins_[g] : 0.0;
    zero[g] = present ? kernel.zero_[g] : 0.0;
  }
  arrays_.flown[lane] = kernel.flown_;
}

std::optional<FlightKernel::End> FlightLanes::add(FlightKernel &kernel, double limit,
                                                  std::size_t owner) {
  if (!(kernel.flown_ < limit))
    return FlightKernel::End::limit;
  const double h = kernel.first_trial(limit - kernel.flown_);
  if (!(h > 0))
    return FlightKernel::End::unclear;
  reserve(kernel.n_groups_, kernel.n_guards_);
  const auto lane = static_cast<std::size_t>(std::find(kernels_.begin(), kernels_.end(), nullptr) -
                                             kernels_.begin());
  kernels_.at(lane) = &kernel;
  owners_[lane] = owner;
  ++n_busy_;
  load(lane);
  arrays_.limit[lane] = limit;
  arrays_.shortest[lane] = kernel.shortest(limit);
  arrays_.least[lane] = kernel.least_;
  arrays_.h[lane] = h;
  arrays_.tries[lane] = arrays_.pieces[lane] = arrays_.accepted[lane] = 0;
  arrays_.watched[lane] = kernel.watched_ ? 1 : 0;
  arrays_.stage[lane] = LaneArrays::trying;
  return std::nullopt;
}

// Real parts, imaginary parts and sizes.
void FlightLanes::read(const double *const (&from)[3], std::size_t lane, Amplitudes &to) const {
  const std::size_t count = to.real.size();
  const std::size_t first = (arrays_.n_groups - count) * n_lanes + lane;
  for (std::size_t j = 0; j < count; ++j) {
    to.real[j] = from[0][first + j * n_lanes];
    to.imaginary[j] = from[1][first + j * n_lanes];
    to.size[j] = from[2][first + j * n_lanes];
  }
}

void FlightLanes::unload(std::size_t lane) {
  FlightKernel &kernel = *kernels_[lane];
  if (arrays_.accepted[lane] > 0)
    read({arrays_.start_real, arrays_.start_imaginary, arrays_.start_size}, lane, kernel.start_);
  read({arrays_.end_real, arrays_.end_imaginary, arrays_.end_size}, lane, kernel.end_);
  for (std::size_t g = 0; g < kernel.n_guards_; ++g) {
    kernel.starts_[g] = {Lane(arrays_.start_value, lane)[g], Lane(arrays_.start_slope, lane)[g]};
    kernel.ends_[g] = {Lane(arrays_.end_value, lane)[g], Lane(arrays_.end_slope, lane)[g]};
    kernel.bounds_[g] = Lane(arrays_.bound, lane)[g];
    kernel.margins_[g] = Lane(arrays_.margin, lane)[g];
    kernel.zero_[g] = Lane(arrays_.zero, lane)[g] > 0 ? 1 : 0;
  }
  kernel.flown_ = arrays_.flown[lane];
}

void FlightLanes::leave(std::size_t lane) {
  arrays_.stage[lane] = LaneArrays::idle;
  arrays_.end[lane] = LaneArrays::none;
  arrays_.passed[lane] = 0;
  kernels_[lane] = nullptr;
  --n_busy_;
}

std::vector<std::size_t> FlightLanes::clear() {
  std::vector<std::size_t> owners;
  for (std::size_t lane = 0; lane < n_lanes; ++lane)
    if (kernels_[lane]) {
      owners.push_back(owners_[lane]);
      leave(lane);
    }
  return owners;
}

// After an accepted piece the end is where the lane starts now, and the start where it ended.
void FlightLanes::show_pieces() {
  for (std::size_t lane = 0; lane < n_lanes; ++lane) {
    if (!kernels_[lane] || !(arrays_.passed[lane] > 0))
      continue;
    FlightKernel &kernel = *kernels_[lane];
    read({arrays_.end_real, arrays_.end_imaginary, arrays_.end_size}, lane, kernel.start_);
    read({arrays_.start_real, arrays_.start_imaginary, arrays_.start_size}, lane, kernel.end_);
    kernel.watched_->include(kernel.start_, kernel.end_, arrays_.passed[lane]);
  }
}

void FlightLanes::land(std::size_t lane) {
  FlightKernel &kernel = *kernels_[lane];
  unload(lane);
  kernel.falling_ = static_cast<std::size_t>(arrays_.falling[lane]);
  kernel.time_to_guard_ = arrays_.time_to_guard[lane];
  kernel.residual_ = arrays_.residual[lane];
  kernel.pieces_ += static_cast<long>(arrays_.pieces[lane]);
  FlightKernel::End end = FlightKernel::End::unclear;
  if (arrays_.end[lane] == LaneArrays::at_limit)
    end = FlightKernel::End::limit;
  else if (arrays_.end[lane] == LaneArrays::at_guard)
    end = FlightKernel::End::guard;
  if (end == FlightKernel::End::guard && kernel.watched_)
    kernel.watched_->include(kernel.start_, kernel.end_, kernel.time_to_guard_);
  landings_.push_back({.owner = owners_[lane], .end = end});
  leave(lane);
}

const std::vector<FlightLanes::Landing> &FlightLanes::fly() {
  landings_.clear();
  while (landings_.empty() && !stop_requested()) {
    fly_(arrays_);
    show_pieces();
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      if (kernels_[lane] && arrays_.end[lane] != LaneArrays::none)
        land(lane);
  }
  return landings_;
}

} // namespace vibroimpact::integration
