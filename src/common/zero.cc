#include "common/zero.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cstdint>

namespace vibroimpact {

double zero_between(const std::function<double(double)> &function, double low, double high) {
  std::uintmax_t most = 200;
  const auto [left, right] = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(), most);
  return (left + right) / 2;
}

} // namespace vibroimpact
