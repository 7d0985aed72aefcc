#include "common/zero.h"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cstdint>

namespace vibroimpact {

double zero_between(const std::function<double(double)> &function, double low, double high,
                    int bits) {
  std::uintmax_t most = 200;
  const auto [left, right] = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(bits), most);
  return (left + right) / 2;
}

Minimum minimum_between(const std::function<double(double)> &function, double low, double high) {
  const auto [place, value] = boost::math::tools::brent_find_minima(
      function, low, high, std::numeric_limits<double>::digits / 2);
  return {.place = place, .value = value};
}

} // namespace vibroimpact
