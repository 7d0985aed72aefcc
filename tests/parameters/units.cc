#include <gtest/gtest.h>
TEST(Units, x) {}
