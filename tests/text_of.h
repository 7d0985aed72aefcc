// Files and errors as text, for comparison.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace vibroimpact::testing {

inline std::string text_of(const std::filesystem::path &file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void write_text(const std::filesystem::path &file, const std::string &text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// The message of the Error that `action` throws; "no error" when it throws none.
template <class Error, class Action> std::string thrown_message(Action action) {
  try {
    action();
  } catch (const Error &error) {
    return error.what();
  }
  return "no error";
}

} // namespace vibroimpact::testing
