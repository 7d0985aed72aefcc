#include "common/memory.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <sys/resource.h>

namespace vibroimpact {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number behind "NAME:" in a file of the kernel, in its unit of kB; infinity without it.
double kilobytes_in(const char *file, const std::string &name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(name + ":"))
      return 1024 * std::strtod(line.c_str() + name.size() + 1, nullptr);
  return unlimited;
}

/// The number that is all a file holds; infinity where there is none, such as "max".
double number_in(const char *file) {
  std::ifstream stream(file);
  double number = 0;
  return stream >> number ? number : unlimited;
}

/// What is left of a limit.
double rest(double limit, double used) {
  return limit < unlimited && used < unlimited ? std::max(0.0, limit - used) : unlimited;
}

double left_of_address_space() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return unlimited;
  return rest(static_cast<double>(limit.rlim_cur), kilobytes_in("/proc/self/status", "VmSize"));
}

/// By version 2 or version 1 of the kernel's control groups.
double left_of_container() {
  return std::min(
      rest(number_in("/sys/fs/cgroup/memory.max"), number_in("/sys/fs/cgroup/memory.current")),
      rest(number_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"),
           number_in("/sys/fs/cgroup/memory/memory.usage_in_bytes")));
}

} // namespace

double available_memory() {
  return std::min({kilobytes_in("/proc/meminfo", "MemAvailable"), left_of_address_space(),
                   left_of_container()});
}

double peak_memory() {
  const double peak = kilobytes_in("/proc/self/status", "VmHWM");
  return peak < unlimited ? peak : 0;
}

std::string memory_text(double bytes) {
  constexpr std::array units{"B", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  for (; bytes >= 1000 && unit + 1 < units.size(); ++unit)
    bytes /= 1000;
  std::ostringstream text;
  text.precision(bytes < 1000 ? 3 : 6);
  text << bytes << " " << units[unit];
  return text.str();
}

std::string lack_of_memory(double bytes) {
  const double available = available_memory();
  if (bytes <= available)
    return "";
  return "about " + memory_text(bytes) + " of memory are needed, but " + memory_text(available) +
         " are available";
}

} // namespace vibroimpact
