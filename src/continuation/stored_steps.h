// What the outcomes of steps along a branch or locus consist of (common/bytes.h).
#pragma once

#include "common/recorded_step.h"
#include "continuation/locus_system.h"
#include "continuation/node.h"

namespace vibroimpact::continuation {

void members(auto &visit, As<Graze> auto &graze) {
  visit(graze.guard, graze.position, graze.ignored, graze.kind, graze.name);
}
void members(auto &visit, As<Point> auto &point) { visit(point.state, point.keys, point.chart); }
void members(auto &visit, As<Start> auto &start) {
  visit(start.point, start.direction, start.forward);
}
void members(auto &visit, As<BranchPoint> auto &point) {
  visit(point.point, point.tangent, point.residual, point.pattern, point.multipliers,
        point.unstable, point.arclength);
}
void members(auto &visit, As<SpecialPoint> auto &special) {
  visit(special.kind, special.at, special.after, special.vector, special.slope, special.angle,
        special.width, special.graze, special.unstable_before, special.unstable_after);
}
void members(auto &visit, As<Linearisation> auto &at) {
  visit(at.residual, at.slope, at.pattern, at.chart_margin);
}
void members(auto &visit, As<Tests> auto &tests) {
  visit(tests.fold, tests.branch, tests.flip, tests.pair, tests.complex_pair);
}
/// Without the slope, of which everything that a walk needs later is in the tests.
void members(auto &visit, As<Node> auto &node) {
  visit(node.u, node.chart, node.tangent, node.at.residual, node.at.pattern, node.at.chart_margin,
        node.tests, node.multipliers, node.unstable, node.arclength, node.iterations);
}
void members(auto &visit, As<Augmented> auto &at) {
  visit(static_cast<std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(at)>>,
                                       const Linearisation, Linearisation> &>(at),
        at.value, at.gradient, at.cusp, at.angle, at.side);
}
void members(auto &visit, As<LocusNode> auto &node) {
  visit(node.u, node.chart, node.tangent, node.at, node.iterations, node.arclength);
}
void members(auto &visit, As<LocusPoint> auto &point) {
  visit(point.point, point.tangent, point.residual, point.defect, point.by_state, point.pattern,
        point.angle, point.side, point.arclength);
}
void members(auto &visit, As<SpecialLocusPoint> auto &special) {
  visit(special.kind, special.at, special.after);
}

} // namespace vibroimpact::continuation
