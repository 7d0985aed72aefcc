// Arrays whose dimensions have names: two of them are combined by name, whatever their order.
#pragma once

#include "common/hdf5_file.h"
#include "common/result_sink.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vibroimpact::derived {

/// Looks at values that belong to somebody else.
struct LabelledArray {
  std::string name;
  std::string unit;
  std::string description;
  std::vector<std::string> dimensions;
  Shape shape;
  const double *values = nullptr; ///< row-major
  std::string axis{};             ///< the dimension whose coordinate the values are; may be empty

  /// Position of a dimension, nothing when the array does not go over it.
  std::optional<std::size_t> find(const std::string &dimension) const;
};

/// All that quantities of one analysis are derived from.
struct Source {
  std::vector<Axis> dimensions; ///< of all arrays; those without coordinate are counted from 1
  std::vector<LabelledArray> arrays;
};

/// A derived quantity with its values.
struct DerivedArray {
  std::string name;
  std::string unit;
  std::string description;
  std::string operation{};
  std::string axis{};              ///< the dimension whose coordinate the values are; may be empty
  std::vector<std::string> axes{}; ///< of a contour: the dimensions of its first columns
  std::vector<std::string> dimensions{};
  Shape shape{};
  std::vector<double> values{};
  std::vector<Axis> own_dimensions{}; ///< those that the analysis does not have

  LabelledArray view() const;
};

/// One array seen along the dimensions of a Frame: it may lack some of them.
struct Operand {
  const double *values;
  std::vector<std::size_t> strides;
};

/// The dimensions that some arrays have together, those of the first one first.
class Frame {
public:
  /// Throws std::logic_error when a dimension has two lengths.
  explicit Frame(const std::vector<LabelledArray> &arrays);

  const std::vector<std::string> &dimensions() const { return dimensions_; }
  const Shape &shape() const { return shape_; }
  std::size_t position(const std::string &dimension) const;
  Operand operand(const LabelledArray &array) const;
  /// What is left without dimension `along`.
  std::pair<std::vector<std::string>, Shape> without(std::size_t along) const;

private:
  std::vector<std::string> dimensions_;
  Shape shape_;
};

/// The values of an array along one dimension.
class Line {
public:
  Line(const double *first, std::size_t stride) : first_(first), stride_(stride) {}
  double operator[](std::size_t i) const { return first_[i * stride_]; }

private:
  const double *first_;
  std::size_t stride_;
};

/// Calls `visit(k, lines)` for every position k (row-major) along the other dimensions, with the
/// line of each operand.
template <class Visit>
void for_each_line(const Frame &frame, std::size_t along, const std::vector<Operand> &operands,
                   Visit visit) {
  const Shape shape = frame.without(along).second;
  std::vector<Line> lines;
  for (std::size_t k = 0; k < number_of_values(shape); ++k) {
    lines.clear();
    for (const Operand &operand : operands) {
      std::size_t offset = 0;
      std::size_t rest = k;
      for (std::size_t d = frame.shape().size(); d-- > 0;)
        if (d != along) {
          offset += rest % frame.shape()[d] * operand.strides[d];
          rest /= frame.shape()[d];
        }
      lines.emplace_back(operand.values + offset, operand.strides[along]);
    }
    visit(k, lines);
  }
}

} // namespace vibroimpact::derived
