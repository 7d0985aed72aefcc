// How the parts of a result are serialised by Boost.
#pragma once

#include "common/dense_archive.h"
#include "common/result_sink.h"

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <boost/serialization/version.hpp>

namespace boost::serialization {

template <class Archive> void serialize(Archive &archive, vibroimpact::Axis &axis, unsigned) {
  archive &axis.name &axis.values &axis.labels &axis.unit &axis.description;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::AnalysisHeader &header, unsigned) {
  archive &header.name &header.type &header.axes &header.grid;
}

template <class Archive> void save(Archive &archive, const vibroimpact::Field &field, unsigned) {
  archive << field.name() << field.unit() << field.description() << field.dimensions()
          << field.shape << field.values;
}

template <class Archive> void load(Archive &archive, vibroimpact::Field &field, unsigned) {
  std::string name, unit, description;
  std::vector<std::string> dimensions;
  archive >> name >> unit >> description >> dimensions >> field.shape >> field.values;
  field.label = vibroimpact::Label(name, unit, description, dimensions);
}

template <class Archive>
void save(Archive &archive, const vibroimpact::SummaryLine &line, unsigned) {
  archive << line.name() << line.value << line.unit();
}

template <class Archive> void load(Archive &archive, vibroimpact::SummaryLine &line, unsigned) {
  std::string name, unit;
  archive >> name >> line.value >> unit;
  line.label = vibroimpact::Label(name, unit, "");
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::TouchedNode &touched, unsigned) {
  archive &touched.body &touched.node;
  archive &make_array(touched.push.data(), 3);
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::ContactTrace &trace, unsigned) {
  archive &trace.nodes &trace.gap &trace.force &trace.peak_force;
}

template <class Archive>
void serialize(Archive &archive, vibroimpact::Motion &motion, unsigned version) {
  archive &motion.time &motion.coordinates &motion.base_displacement;
  if (version > 0) // earlier journals have none
    archive &motion.contacts;
  if (version > 1)
    archive &motion.velocities &motion.base_velocity;
}

} // namespace boost::serialization

BOOST_CLASS_VERSION(vibroimpact::Motion, 2)
BOOST_SERIALIZATION_SPLIT_FREE(vibroimpact::Field)
BOOST_SERIALIZATION_SPLIT_FREE(vibroimpact::SummaryLine)
