#include "contact/pairing.h"

#include <Eigen/Geometry>
#include <algorithm>
#define BOOST_ALLOW_DEPRECATED_HEADERS // which Boost itself includes, and then complains
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <optional>

namespace vibroimpact::contact {

namespace {

namespace geometry = boost::geometry;
using TreePoint = geometry::model::point<double, 3, geometry::cs::cartesian>;
using TreeBox = geometry::model::box<TreePoint>;
using Entry = std::pair<TreePoint, std::size_t>;
using Tree = geometry::index::rtree<Entry, geometry::index::rstar<16>>;

constexpr double equally_near = 1e-9;

/// Coordinates of which the last runs along the direction.
std::vector<Vector3> turned(const std::vector<Vector3> &nodes, const Vector3 &direction) {
  const Vector3 across = direction.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes << across.transpose(), direction.cross(across).transpose(), direction.transpose();
  std::vector<Vector3> result;
  for (const Vector3 &node : nodes)
    result.emplace_back(axes * node);
  return result;
}

Tree tree_of(const std::vector<Vector3> &nodes) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    entries.emplace_back(TreePoint(nodes[i][0], nodes[i][1], nodes[i][2]), i);
  return Tree(entries);
}

bool within(const Vector3 &difference, const PairSearch &search) {
  if (search.joining)
    return difference.norm() <= search.radius;
  return difference.head<2>().norm() <= search.radius && std::abs(difference[2]) <= search.reach;
}

/// Those that the box around the search finds, ascending.
std::vector<std::size_t> candidates(const Tree &tree, const Vector3 &node,
                                    const PairSearch &search) {
  const Vector3 half(search.radius, search.radius, search.joining ? search.radius : search.reach);
  const Vector3 lower = node - half;
  const Vector3 upper = node + half;
  std::vector<Entry> found;
  tree.query(geometry::index::intersects(TreeBox(TreePoint(lower[0], lower[1], lower[2]),
                                                 TreePoint(upper[0], upper[1], upper[2]))),
             std::back_inserter(found));
  std::vector<std::size_t> numbers;
  for (const Entry &entry : found)
    numbers.push_back(entry.second);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// For each of `nodes` the nearest of `others`.
std::vector<std::optional<std::size_t>> nearest_of(const std::vector<Vector3> &nodes,
                                                   const std::vector<Vector3> &others,
                                                   const PairSearch &search) {
  const Tree tree = tree_of(others);
  std::vector<std::optional<std::size_t>> nearest(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t other : candidates(tree, nodes[i], search)) {
      const Vector3 difference = others[other] - nodes[i];
      const bool nearer = !nearest[i] || difference.norm() < (1 - equally_near) * least;
      if (within(difference, search) && nearer) {
        least = difference.norm();
        nearest[i] = other;
      }
    }
  }
  return nearest;
}

} // namespace

std::vector<NodePair> facing_pairs(const std::vector<Vector3> &first,
                                   const std::vector<Vector3> &second, const PairSearch &search) {
  const std::vector<Vector3> a = turned(first, search.direction);
  const std::vector<Vector3> b = turned(second, search.direction);
  const auto from_first = nearest_of(a, b, search);
  const auto from_second = nearest_of(b, a, search);
  std::vector<NodePair> pairs;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (from_first[i] && from_second[*from_first[i]] == i)
      pairs.push_back({i, *from_first[i]});
  return pairs;
}

} // namespace vibroimpact::contact
