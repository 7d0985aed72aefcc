// Motions with friction by each method, for tests.
#pragma once

#include "support/friction_models.h"

#include <gtest/gtest.h>

#include <string>

namespace vibroimpact::testing {

/// By "exact" and "rk". Errors of the steps grow from contact change to contact change.
class FrictionByMethod : public ::testing::TestWithParam<const char *> {
protected:
  bool exact() const { return std::string(GetParam()) == "exact"; }
  double error(double of_exact_path) const { return exact() ? of_exact_path : 1e-8; }
  motion::Settings settings() const {
    motion::Settings settings = settings_of(GetParam());
    settings.absolute_tolerance = exact() ? settings.absolute_tolerance : 0;
    return settings;
  }
};

} // namespace vibroimpact::testing
