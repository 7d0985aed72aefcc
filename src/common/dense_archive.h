// How dense vectors and matrices, and values that may be missing, are serialised by Boost.
#pragma once

#include "common/linear_algebra.h"

#include <boost/serialization/array_wrapper.hpp>
#include <boost/serialization/split_free.hpp>

#include <optional>

namespace boost::serialization {

template <class Archive, class Scalar, int Rows, int Columns, int Options>
void serialize(Archive &archive, Eigen::Matrix<Scalar, Rows, Columns, Options> &matrix, unsigned) {
  vibroimpact::Index rows = matrix.rows();
  vibroimpact::Index columns = matrix.cols();
  archive &rows &columns;
  matrix.resize(rows, columns); // keeps the values of the right size, so it serves both ways
  archive &make_array(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

template <class Archive, class Value>
void save(Archive &archive, const std::optional<Value> &optional, unsigned) {
  const bool there = optional.has_value();
  archive << there;
  if (there)
    archive << *optional;
}

template <class Archive, class Value>
void load(Archive &archive, std::optional<Value> &optional, unsigned) {
  bool there = false;
  archive >> there;
  optional.reset();
  if (there)
    archive >> optional.emplace();
}

template <class Archive, class Value>
void serialize(Archive &archive, std::optional<Value> &optional, unsigned version) {
  split_free(archive, optional, version);
}

} // namespace boost::serialization
