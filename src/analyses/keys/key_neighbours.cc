#include "analyses/keys/key_neighbours.h"

#include "common/error.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

// Of the value. Differences by it are exact to its fourth power, and what rounding leaves of them
// is divided by it.
constexpr double relative_step = 1e-3;

constexpr std::array<std::array<double, 4>, 3> sides = {
    {{-2, -1, 1, 2}, {1, 2, 3, 4}, {-4, -3, -2, -1}}};

} // namespace

std::vector<motion::KeyNeighbour> key_neighbours(const SweptParameter &key, double value,
                                                 const SystemSource &build) {
  const double step = relative_step * (value != 0 ? std::abs(value) : key.magnitude());
  for (std::size_t side = 0;; ++side) {
    try {
      std::vector<motion::KeyNeighbour> neighbours;
      for (const double place : sides[side]) {
        System system = build({key.at(value + place * step)});
        neighbours.push_back({.offset = place * step,
                              .model = std::move(system.model),
                              .contacts = std::move(system.contacts)});
      }
      return neighbours;
    } catch (const InputError &) {
      if (side + 1 == sides.size())
        throw;
    }
  }
}

std::vector<motion::KeyNeighbour> frequency_neighbours(const System &system, std::size_t source) {
  const double omega = 2 * std::numbers::pi / system.model.sources()[source].function->period();
  std::vector<motion::KeyNeighbour> neighbours;
  for (const double place : sides.front()) {
    motion::KeyNeighbour neighbour{.offset = place * relative_step * omega,
                                   .model = system.model,
                                   .contacts = system.contacts};
    neighbour.model.set_frequency(source, omega + neighbour.offset);
    neighbours.push_back(std::move(neighbour));
  }
  return neighbours;
}

} // namespace vibroimpact::analyses
