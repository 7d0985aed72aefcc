// The one way to put numbers into the result of a point: as fields, and as lines of its summary.
#pragma once

#include "common/result_sink.h"

#include <string>
#include <string_view>
#include <vector>

namespace vibroimpact::analyses {

/// Do single numbers stand in the summary as well?
enum class Listed : bool { no, yes };

class FieldWriter {
public:
  /// Keeps a reference. All names get `path` before them, which ends with a slash where it is not
  /// empty; in the summary slashes become dots.
  FieldWriter(PointResult &result, std::string path = "", Listed listed = Listed::no)
      : result_(&result), path_(std::move(path)), listed_(listed) {}
  /// Of the same result, one group deeper.
  FieldWriter below(const std::string &group) const { return {*result_, path_ + group, listed_}; }
  FieldWriter listed() const { return {*result_, path_, Listed::yes}; }

  const std::string &path() const { return path_; }

  /// Recorders of cheap points make their labels beforehand.
  void number(const Label &label, double value) const;
  void number(const std::string &name, double value, const std::string &unit,
              const std::string &description) const;
  /// Along one dimension.
  void series(const std::string &name, const std::string &dimension, std::vector<double> values,
              const std::string &unit, const std::string &description) const;
  /// Row-major, of as many lengths as the label has dimensions.
  void array(const Label &label, std::vector<std::size_t> shape, std::vector<double> values) const;
  /// One row after the other; a vector where the label has a single dimension.
  void array(const Label &label, const Matrix &values) const;
  /// Of the summary alone.
  void line(const std::string &name, double value, const std::string &unit) const;

private:
  PointResult *result_;
  std::string path_;
  Listed listed_;
};

/// The field of this name, or nullptr.
const Field *find(const PointResult &result, std::string_view name);
/// The field of this name. std::out_of_range where there is none.
const Field &field_of(const PointResult &result, std::string_view name);
/// The first number of a field; `otherwise` where there is no such field.
double number_of(const PointResult &result, std::string_view name, double otherwise);

} // namespace vibroimpact::analyses
