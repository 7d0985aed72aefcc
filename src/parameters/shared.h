// A value that its copies share until one of them changes it.
//
// The trees of the many systems of a sweep differ in a few values; everything else is there once.
#pragma once

#include <memory>
#include <utility>

namespace vibroimpact::parameters {

template <class T> class Shared {
public:
  explicit Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}

  const T &get() const { return *value_; }
  operator const T &() const { return *value_; }
  /// For changes; a copy of its own where others share the value. The owner of this must not be
  /// shared itself. Not for several threads.
  T &own() {
    if (value_.use_count() > 1)
      value_ = std::make_shared<T>(*value_);
    return *value_;
  }

private:
  std::shared_ptr<T> value_;
};

} // namespace vibroimpact::parameters
