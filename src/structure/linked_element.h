// An element some of whose nodes belong to rigid bodies: the same element in terms of the
// coordinates of their masters.
#pragma once

#include "structure/rigid_links.h"

namespace vibroimpact::structure {

class LinkedElement : public Element {
public:
  LinkedElement(std::shared_ptr<const Element> element, const Elimination &elimination);

  /// The masters of linked nodes; one may stand there more than once.
  std::span<const int> nodes() const override { return nodes_; }
  /// Exactly zero where all nodes belong to one rigid body.
  NodalMatrix stiffness() const override;
  NodalMatrix mass() const override;
  NodalMatrix force(const Eigen::Ref<const Matrix> &stiffness, const NodalMatrix &u) const override;
  Matrix stress(int node) const override;
  Matrix outline() const override { return element_->outline(); }
  double total_mass() const override { return element_->total_mass(); }

private:
  NodalMatrix in_masters(const NodalMatrix &matrix) const;

  std::shared_ptr<const Element> element_;
  std::vector<int> nodes_;
  NodalMatrix motion_;    ///< of the components of the element's own nodes
  NodalMatrix stiffness_; ///< in terms of these
  bool rigid_;
};

} // namespace vibroimpact::structure
