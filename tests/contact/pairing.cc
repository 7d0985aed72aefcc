// Pairs found with the tree against all pairs looked at one by one.
#include "contact/pairing.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <optional>
#include <random>

namespace vibroimpact::contact {
namespace pairing_tests {

using Cloud = std::vector<Vector3>;

Cloud cloud(std::size_t size, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Cloud nodes;
  for (std::size_t i = 0; i < size; ++i)
    nodes.emplace_back(coordinate(engine), coordinate(engine), coordinate(engine));
  return nodes;
}

bool inside(const Vector3 &apart, const PairSearch &search) {
  if (search.joining)
    return apart.norm() <= search.radius;
  const double along = apart.dot(search.direction);
  return (apart - along * search.direction).norm() <= search.radius &&
         std::abs(along) <= search.reach;
}

std::optional<std::size_t> nearest(const Vector3 &node, const Cloud &others,
                                   const PairSearch &search) {
  std::optional<std::size_t> best;
  for (std::size_t j = 0; j < others.size(); ++j)
    if (inside(others[j] - node, search) &&
        (!best || (others[j] - node).norm() < (others[*best] - node).norm()))
      best = j;
  return best;
}

std::vector<NodePair> one_by_one(const Cloud &first, const Cloud &second,
                                 const PairSearch &search) {
  std::vector<NodePair> pairs;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (const auto j = nearest(first[i], second, search);
        j && nearest(second[*j], first, search) == i)
      pairs.push_back({i, *j});
  return pairs;
}

std::vector<PairSearch> searches() {
  const Vector3 oblique = Vector3(1, -2, 0.5).normalized();
  return {{.direction = Vector3::UnitX(), .radius = 0.1},
          {.direction = oblique, .radius = 0.15},
          {.direction = oblique, .radius = 0.3, .reach = 0.2},
          {.direction = -Vector3::UnitZ(), .radius = 0.05, .reach = 0.05},
          {.radius = 0.2, .joining = true}};
}

TEST(PairingTest, AgreesWithAllPairsOnRandomClouds) {
  for (const PairSearch &search : searches()) {
    std::size_t found = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Cloud first = cloud(40 + 10 * seed, seed);
      const Cloud second = cloud(240 - 10 * seed, 1000 + seed);
      const std::vector<NodePair> pairs = facing_pairs(first, second, search);
      EXPECT_EQ(pairs, one_by_one(first, second, search)) << "seed " << seed;
      found += pairs.size();
    }
    EXPECT_GT(found, 20U);
  }
}

TEST(PairingTest, ARotatedCloudHasTheSamePairs) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vector3(0.3, -0.7, 0.2).normalized()).toRotationMatrix();
  const auto turned = [&](Cloud nodes) {
    for (Vector3 &node : nodes)
      node = turn * node + Vector3(3, -5, 2);
    return nodes;
  };
  const Cloud first = cloud(150, 7);
  const Cloud second = cloud(120, 8);
  for (PairSearch search : searches()) {
    const std::vector<NodePair> pairs = facing_pairs(first, second, search);
    search.direction = turn * search.direction;
    EXPECT_EQ(facing_pairs(turned(first), turned(second), search), pairs);
  }
}

TEST(PairingTest, ARenumberedCloudHasTheSamePairs) {
  const Cloud first = cloud(150, 9);
  const Cloud second = cloud(120, 10);
  const Cloud backwards(second.rbegin(), second.rend());
  for (const PairSearch &search : searches()) {
    std::vector<NodePair> pairs = facing_pairs(first, backwards, search);
    for (NodePair &pair : pairs)
      pair[1] = second.size() - 1 - pair[1];
    EXPECT_EQ(pairs, facing_pairs(first, second, search));
  }
}

TEST(PairingTest, SidesCanBeExchanged) {
  const Cloud first = cloud(90, 11);
  const Cloud second = cloud(140, 12);
  for (PairSearch search : searches()) {
    std::vector<NodePair> pairs = facing_pairs(first, second, search);
    std::sort(pairs.begin(), pairs.end(),
              [](const NodePair &a, const NodePair &b) { return a[1] < b[1]; });
    search.direction *= -1;
    std::vector<NodePair> exchanged = facing_pairs(second, first, search);
    for (NodePair &pair : exchanged)
      std::swap(pair[0], pair[1]);
    EXPECT_EQ(exchanged, pairs);
  }
}

TEST(PairingTest, TheFirstOfEquallyNearNodesCounts) {
  const Cloud first = {{0, 0, 0}};
  const Cloud second = {{1, 0.1, 0}, {1, -0.1, 0}};
  EXPECT_EQ(facing_pairs(first, second, {.radius = 0.2}), (std::vector<NodePair>{{0, 0}}));
  EXPECT_TRUE(facing_pairs(first, second, {.radius = 0.05}).empty());
  EXPECT_TRUE(facing_pairs(first, second, {.radius = 0.2, .reach = 0.5}).empty());
  EXPECT_TRUE(facing_pairs({}, second, {.radius = 0.2}).empty());
}

} // namespace pairing_tests
} // namespace vibroimpact::contact
