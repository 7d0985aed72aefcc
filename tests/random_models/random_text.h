// Random numbers and parameter-file text made of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace vibroimpact::testing {

/// The same numbers from the same seed with every standard library.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : generator_(seed * 0x9e3779b97f4a7c15u + 1) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  /// 10^x with x uniform: a magnitude.
  double power(double low, double high) { return std::pow(10, uniform(low, high)); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  std::size_t below(std::size_t n) {
    return static_cast<std::size_t>(uniform(0, static_cast<double>(n)));
  }
  template <typename T> T of(std::initializer_list<T> list) {
    return *(list.begin() + static_cast<std::ptrdiff_t>(below(list.size())));
  }
  template <typename T> const T &of(const std::vector<T> &list) { return list[below(list.size())]; }

private:
  std::mt19937_64 generator_;
};

/// So many digits that a relative change of 1e-9 shows.
inline std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}

/// "  set KEY = VALUE", one line.
inline std::string set(const std::string &key, const std::string &value) {
  return "  set " + key + " = " + value + "\n";
}
inline std::string set(const std::string &key, double value, const std::string &unit = "") {
  return set(key, digits(value) + (unit.empty() ? "" : " " + unit));
}

inline std::string subsection(const std::string &name, const std::string &content) {
  return "subsection " + name + "\n" + content + "end\n";
}

/// Numbers from arguments like "3" and "5-17".
inline std::vector<std::uint64_t> seeds_of(const std::vector<std::string> &arguments) {
  std::vector<std::uint64_t> seeds;
  for (const std::string &argument : arguments) {
    const std::size_t dash = argument.find('-');
    const std::uint64_t first = std::stoull(argument);
    const std::uint64_t last =
        dash == std::string::npos ? first : std::stoull(argument.substr(dash + 1));
    for (std::uint64_t seed = first; seed <= last; ++seed)
      seeds.push_back(seed);
  }
  return seeds;
}

/// "a, b".
inline std::string joined(const std::set<std::string> &names) {
  std::string text;
  for (const std::string &name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

} // namespace vibroimpact::testing
