// A record of steps for tests, that can be cut where a run is meant to have been killed.
#pragma once

#include "common/step_record.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vibroimpact::testing {

class StepsInMemory : public StepRecord {
public:
  StepsInMemory() = default;
  explicit StepsInMemory(std::vector<std::string> known) : known_(std::move(known)) {}

  std::optional<std::string_view> next() override {
    if (taken_ == known_.size())
      return std::nullopt;
    return known_[taken_++];
  }
  void keep(std::string_view bytes) override {
    fresh.emplace_back(bytes);
    if (kept)
      kept();
  }
  /// Those of the earlier run have all been asked for.
  bool spent() const { return taken_ == known_.size(); }

  std::vector<std::string> fresh;
  std::function<void()> kept; ///< called behind each step that is kept

private:
  std::vector<std::string> known_;
  std::size_t taken_ = 0;
};

/// Leaves what it has been given to keep.
class HandedSteps : public StepsInMemory {
public:
  /// Keeps a reference to `into`.
  HandedSteps(std::vector<std::string> known, std::vector<std::string> &into)
      : StepsInMemory(std::move(known)), into_(into) {}
  ~HandedSteps() override { into_ = std::move(fresh); }

private:
  std::vector<std::string> &into_;
};

inline std::vector<std::string> first_of(const std::vector<std::string> &steps, std::size_t count) {
  return {steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(count)};
}

} // namespace vibroimpact::testing
