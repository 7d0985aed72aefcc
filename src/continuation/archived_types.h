// How the outcomes of steps along a branch or locus are serialised by Boost.
#pragma once

#include "common/recorded_step.h"
#include "continuation/locus_end.h"
#include "continuation/walk.h"

#include <boost/serialization/complex.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

namespace boost::serialization {

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::Graze &graze, unsigned) {
  archive &graze.guard &graze.position &graze.ignored &graze.name;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::Point &point, unsigned) {
  archive &point.state &point.keys &point.chart;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::Start &start, unsigned) {
  archive &start.point &start.direction &start.forward;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::BranchPoint &point, unsigned) {
  archive &point.point &point.tangent &point.residual &point.pattern &point.multipliers;
  archive &point.unstable &point.arclength;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::SpecialPoint &special, unsigned) {
  archive &special.kind &special.at &special.after &special.vector &special.slope &special.angle;
  archive &special.width &special.graze &special.unstable_before &special.unstable_after;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::Linearisation &at, unsigned) {
  archive &at.residual &at.slope &at.pattern &at.chart_margin;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::Tests &tests, unsigned) {
  archive &tests.fold &tests.branch &tests.flip &tests.pair &tests.complex_pair;
}

/// Without the slope, of which everything that a walk needs later is in the tests.
template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::Node &node, unsigned) {
  archive &node.u &node.chart &node.tangent;
  archive &node.at.residual &node.at.pattern &node.at.chart_margin;
  archive &node.tests &node.multipliers &node.unstable &node.arclength &node.iterations;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::Augmented &at, unsigned) {
  archive &at.at &at.value &at.gradient &at.cusp &at.angle &at.side;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::LocusNode &node, unsigned) {
  archive &node.u &node.chart &node.tangent &node.at &node.iterations &node.arclength;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::continuation::GrazeEnd &end, unsigned) {
  archive &end.u &end.at &end.graze;
}

} // namespace boost::serialization
