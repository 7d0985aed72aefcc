// Random flights within a ring, half of them made to graze it, against a dense search in extended
// precision: none is missed and none invented beyond rounding.
#include "support/circular_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace vibroimpact::motion {
namespace circular_flights_tests {

using namespace model;
using contact::ContactSet;
using testing::settings_of;

constexpr double stiffness[] = {1, 2.3}, damping[] = {0.02, 0.06}, duration = 25;

/// The closed form of one coordinate of mass 1.
class Oscillation {
public:
  Oscillation(int axis, long double place, long double speed)
      : decay_(damping[axis] / 2.0L), frequency_(std::sqrt(stiffness[axis] - decay_ * decay_)),
        cosine_(place), sine_((speed + decay_ * place) / frequency_) {}
  long double operator()(long double time) const {
    return std::exp(-decay_ * time) *
           (cosine_ * std::cos(frequency_ * time) + sine_ * std::sin(frequency_ * time));
  }

private:
  long double decay_, frequency_, cosine_, sine_;
};

struct Flight {
  long double start[4];
  long double squared_distance(long double time) const {
    const long double x = Oscillation(0, start[0], start[2])(time);
    const long double y = Oscillation(1, start[1], start[3])(time);
    return x * x + y * y;
  }
};

struct Highest {
  long double time = 0, value = 0;
};

// By parabolas through three values, ever closer.
Highest refined(const Flight &flight, long double time, long double h) {
  for (int i = 0; i < 12 && h > 1e-7L; ++i, h /= 8) {
    const long double a = flight.squared_distance(time - h);
    const long double b = flight.squared_distance(time);
    const long double c = flight.squared_distance(time + h);
    const long double bend = a - 2 * b + c;
    if (!(bend < 0))
      break;
    time += h * (a - c) / (2 * bend);
  }
  return {time, flight.squared_distance(time)};
}

// Of all samples that are higher than their neighbours those near the highest one.
Highest highest(const Flight &flight) {
  constexpr int samples = 300;
  constexpr long double apart = static_cast<long double>(duration) / samples;
  std::array<long double, samples + 1> values{};
  for (std::size_t i = 0; i <= samples; ++i)
    values[i] = flight.squared_distance(apart * static_cast<long double>(i));
  const long double top = *std::max_element(values.begin(), values.end());
  Highest best{.time = values.front() == top ? 0 : duration, .value = 0};
  for (std::size_t i = 1; i < samples; ++i)
    if (values[i] > 0.95L * top && values[i] >= values[i - 1] && values[i] >= values[i + 1])
      if (const Highest found = refined(flight, apart * static_cast<long double>(i), apart);
          found.value > best.value)
        best = found;
  return best;
}

TEST(CircularFlights, NoneMissedAndNoneInvented) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto body = std::make_shared<reduction::ReducedBody>(*testing::particle("ball", 1));
  for (Index j = 0; j < 2; ++j) {
    body->stiffness[j] = stiffness[j];
    body->damping(j, j) = damping[j];
  }
  const Model model({body});
  const ContactSet contacts({testing::ring_about_z(model, "ball.head", "", 1,
                                                   std::make_shared<contact::LinearPenalty>(50))});
  Trajectory trajectory(model, contacts, settings_of("exact"));
  int grazes = 0;
  for (int number = 0; number < 4000; ++number) {
    Flight flight{};
    for (long double &value : flight.start)
      value = uniform(random);
    const Highest natural = highest(flight);
    const bool graze = number % 2 == 0;
    const double beyond =
        graze ? std::copysign(std::pow(10, -7.5 + 6.5 * uniform(random)), uniform(random))
              : 0.5 * uniform(random);
    const long double factor = std::sqrt((1 + static_cast<long double>(beyond)) / natural.value);
    Vector from(4);
    for (Index i = 0; i < 4; ++i) {
      from[i] = static_cast<double>(factor * flight.start[i]);
      flight.start[i] = from[i];
    }
    const Highest top = highest(flight);
    if (top.time < 0.1 || top.time > duration - 0.1 || top.value == 0 ||
        flight.squared_distance(0) > 0.99 || std::abs(top.value - 1) < 1e-12L)
      continue;
    grazes += std::abs(beyond) < 1e-6 ? 1 : 0;
    testing::Changes changes(contacts);
    trajectory.start(0, from.head(2), from.tail(2));
    trajectory.advance(duration, changes);
    ASSERT_EQ(!changes.list.empty(), top.value > 1)
        << number << ": " << static_cast<double>(top.value - 1);
    if (changes.list.empty())
      continue;
    const auto at = static_cast<long double>(changes.list.front().time);
    const double rate = std::sqrt(std::abs(static_cast<double>(top.value - 1)));
    ASSERT_LT(std::abs(static_cast<double>(flight.squared_distance(at) - 1)),
              1e-12 * (1 + 1e-3 / rate))
        << number;
  }
  EXPECT_GT(grazes, 500);
}

} // namespace circular_flights_tests
} // namespace vibroimpact::motion
