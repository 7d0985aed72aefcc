#include "common/memory.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace memory_tests {

TEST(MemoryTest, WhatIsAvailableSuffices) {
  const double available = available_memory();
  EXPECT_GT(available, 1e6);
  EXPECT_LT(available, 1e16);
  EXPECT_EQ(lack_of_memory(0.5 * available), "");
  EXPECT_EQ(lack_of_memory(0), "");
}

TEST(MemoryTest, ALackSaysBothFigures) {
  const std::string lack = lack_of_memory(1.23e16);
  EXPECT_TRUE(lack.starts_with("about 12.3 PB of memory are needed, but ")) << lack;
  EXPECT_TRUE(lack.ends_with("B are available")) << lack;
  EXPECT_TRUE(lack_of_memory(1e18).starts_with("about 1000 PB of memory")) << lack_of_memory(1e18);
}

} // namespace memory_tests
} // namespace vibroimpact
