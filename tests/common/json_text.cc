#include "common/json_text.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace vibroimpact {
namespace json_text_tests {

TEST(JsonText, WhatJsonCannotHoldLiterallyIsEscaped) {
  EXPECT_EQ(json_string("m/s²"), "\"m/s²\"");
  EXPECT_EQ(json_string("a \"b\"\\c"), "\"a \\\"b\\\"\\\\c\"");
  EXPECT_EQ(json_string("two\nlines\t"), "\"two\\u000alines\\u0009\"");
}

TEST(JsonText, NumbersComeBackExactly) {
  for (const double value :
       {2.0 / 3, -0.1, 1e-300, 123456789012345680.0, std::numeric_limits<double>::denorm_min(),
        -std::numeric_limits<double>::min(), std::numeric_limits<double>::max()})
    EXPECT_EQ(std::strtod(json_number(value).c_str(), nullptr), value);
  EXPECT_EQ(json_number(17), "17");
}

TEST(JsonText, NumbersThatAreNotFinite) {
  EXPECT_EQ(json_number(std::copysign(NAN, -1.0)), "null");
  EXPECT_EQ(json_number(INFINITY), "\"inf\"");
  EXPECT_EQ(json_number(-INFINITY), "\"-inf\"");
}

} // namespace json_text_tests
} // namespace vibroimpact
