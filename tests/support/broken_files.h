// Parameter files with one mistake each, and what the message about it must say.
#pragma once

#include "support/simulation_files.h"

#include <gtest/gtest.h>

namespace vibroimpact::testing {

struct BrokenFile {
  const char *what;
  std::string from; ///< what the mistake replaces
  std::string to;
  std::vector<std::string> words; ///< of the message
};

/// `text` itself must be accepted, so that each mistake is the only one.
inline void expect_messages(const std::string &text, const std::vector<BrokenFile> &cases) {
  EXPECT_EQ(message_of(text), "");
  for (const BrokenFile &broken : cases) {
    const std::string message = message_of(changed(text, broken.from, broken.to));
    EXPECT_NE(message.find("test.prm"), std::string::npos) << broken.what << ": " << message;
    for (const std::string &word : broken.words)
      EXPECT_NE(message.find(word), std::string::npos)
          << broken.what << ": " << word << " is not in: " << message;
  }
}

} // namespace vibroimpact::testing
