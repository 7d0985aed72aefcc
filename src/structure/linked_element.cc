#include "structure/linked_element.h"

#include <algorithm>

namespace vibroimpact::structure {

LinkedElement::LinkedElement(std::shared_ptr<const Element> element, const Elimination &elimination)
    : element_(std::move(element)), stiffness_(element_->stiffness()) {
  const std::span<const int> own = element_->nodes();
  const Index components = element_->components();
  const auto count = static_cast<Index>(own.size());
  motion_ = NodalMatrix::Zero(components * count, 6 * count);
  std::size_t linked = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto found = elimination.nodes.find(own[i]);
    const LinkedNode node =
        found == elimination.nodes.end() ? LinkedNode{.master = own[i]} : found->second;
    nodes_.push_back(node.master);
    linked += found != elimination.nodes.end();
    const auto at = static_cast<Index>(i);
    motion_.block(components * at, 6 * at, components, 6) = node.motion.topRows(components);
  }
  rigid_ = own.size() > 1 && linked == own.size() &&
           std::all_of(nodes_.begin(), nodes_.end(), [&](int node) { return node == nodes_[0]; });
}

NodalMatrix LinkedElement::in_masters(const NodalMatrix &matrix) const {
  const NodalMatrix moved = motion_.transpose() * matrix * motion_;
  return (moved + moved.transpose()) / 2;
}

NodalMatrix LinkedElement::stiffness() const {
  if (rigid_)
    return NodalMatrix::Zero(motion_.cols(), motion_.cols());
  return in_masters(stiffness_);
}

NodalMatrix LinkedElement::mass() const { return in_masters(element_->mass()); }

NodalMatrix LinkedElement::force(const Eigen::Ref<const Matrix> & /*stiffness*/,
                                 const NodalMatrix &u) const {
  if (rigid_)
    return NodalMatrix::Zero(u.rows(), u.cols());
  return motion_.transpose() * element_->force(stiffness_, motion_ * u);
}

Matrix LinkedElement::stress(int node) const {
  const Matrix own = element_->stress(node);
  if (own.rows() == 0)
    return own;
  return own * motion_;
}

} // namespace vibroimpact::structure
