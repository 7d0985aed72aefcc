#include "integration/flight_batch.h"

#include "common/signals.h"

#include <boost/context/fiber.hpp>
#include <boost/context/protected_fixedsize_stack.hpp>

#include <deque>
#include <exception>
#include <utility>
#include <vector>

namespace vibroimpact::integration {

namespace {

// The address sanitizer knows nothing of these fibers.
#ifdef __SANITIZE_ADDRESS__
constexpr bool fibers_can_be_used = false;
#else
constexpr bool fibers_can_be_used = true;
#endif

// As much as a program usually has; what is not used takes no memory.
constexpr std::size_t stack_size = 8UL << 20;

class Batch {
public:
  Batch(std::size_t count, const std::function<void()> &work) {
    for (std::size_t i = 0; i < count; ++i)
      fibers_.push_back(
          {.context = boost::context::fiber(std::allocator_arg,
                                            boost::context::protected_fixedsize_stack(stack_size),
                                            [this, i, &work](boost::context::fiber &&caller) {
                                              fibers_[i].caller = std::move(caller);
                                              attempt(work);
                                              return std::move(fibers_[i].caller);
                                            })});
  }
  Batch(const Batch &) = delete;
  Batch &operator=(const Batch &) = delete;

  void run() {
    for (std::size_t i = 0; i < fibers_.size(); ++i)
      resume(i);
    while (!waiting_.empty() || !lanes_.empty())
      if (failure_)
        end_the_waiting();
      else if (stop_requested())
        failure_ = std::make_exception_ptr(Interrupted{});
      else
        serve();
    if (failure_)
      std::rethrow_exception(failure_);
  }

  FlightKernel::End fly(FlightKernel &kernel, double limit) {
    const std::size_t own = present_;
    Fiber &fiber = fibers_[own];
    fiber.kernel = &kernel;
    fiber.limit = limit;
    waiting_.push_back(own);
    fiber.caller = std::move(fiber.caller).resume();
    if (failure_)
      throw BatchBrokenOff{};
    return fiber.end;
  }

private:
  struct Fiber {
    boost::context::fiber context, caller{};
    FlightKernel *kernel = nullptr; ///< where it waits for
    double limit = 0;
    FlightKernel::End end = FlightKernel::End::limit;
  };

  // No exception may leave a fiber.
  void attempt(const std::function<void()> &work) {
    try {
      if (!failure_)
        work();
    } catch (const BatchBrokenOff &) {
    } catch (...) {
      failure_ = std::current_exception();
    }
  }

  void resume(std::size_t i) {
    present_ = i;
    fibers_[i].context = std::move(fibers_[i].context).resume();
  }

  void serve() {
    while (!waiting_.empty() && !lanes_.full()) {
      const std::size_t i = waiting_.front();
      waiting_.pop_front();
      if (const auto end = lanes_.add(*fibers_[i].kernel, fibers_[i].limit, i))
        land(i, *end);
    }
    if (lanes_.empty())
      return;
    for (const FlightLanes::Landing &landing : lanes_.fly())
      land(landing.owner, landing.end);
  }

  void land(std::size_t i, FlightKernel::End end) {
    fibers_[i].end = end;
    resume(i);
  }

  void end_the_waiting() {
    for (const std::size_t owner : lanes_.clear())
      waiting_.push_back(owner);
    while (!waiting_.empty()) {
      const std::size_t i = waiting_.front();
      waiting_.pop_front();
      resume(i);
    }
  }

  FlightLanes lanes_;
  std::vector<Fiber> fibers_;
  std::deque<std::size_t> waiting_;
  std::size_t present_ = 0;
  std::exception_ptr failure_;
};

Batch *present_batch = nullptr;

} // namespace

void run_batch(std::size_t count, const std::function<void()> &work) {
  if (!fibers_can_be_used || count < 2 || present_batch) {
    work();
    return;
  }
  Batch batch(count, work);
  present_batch = &batch;
  struct Leave {
    ~Leave() { present_batch = nullptr; }
  } leave;
  batch.run();
}

// What the runtime library knows of an exception that is being handled belongs to the thread, not
// to the fiber: none may wait then.
FlightKernel::End fly_in_batch(FlightKernel &kernel, double limit) {
  if (!present_batch || std::uncaught_exceptions() > 0 || std::current_exception())
    return kernel.fly(limit);
  return present_batch->fly(kernel, limit);
}

} // namespace vibroimpact::integration
