#include "derived/labelled_array.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::derived {

std::optional<std::size_t> LabelledArray::find(const std::string &dimension) const {
  const auto found = std::find(dimensions.begin(), dimensions.end(), dimension);
  if (found == dimensions.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - dimensions.begin());
}

LabelledArray DerivedArray::view() const {
  return {name, unit, description, dimensions, shape, values.data(), axis};
}

Frame::Frame(const std::vector<LabelledArray> &arrays) {
  for (const LabelledArray &array : arrays)
    for (std::size_t d = 0; d < array.dimensions.size(); ++d) {
      const auto known = std::find(dimensions_.begin(), dimensions_.end(), array.dimensions[d]);
      if (known == dimensions_.end()) {
        dimensions_.push_back(array.dimensions[d]);
        shape_.push_back(array.shape[d]);
      } else if (shape_[static_cast<std::size_t>(known - dimensions_.begin())] != array.shape[d]) {
        throw std::logic_error("dimension " + *known + " has two lengths");
      }
    }
}

std::size_t Frame::position(const std::string &dimension) const {
  const auto found = std::find(dimensions_.begin(), dimensions_.end(), dimension);
  if (found == dimensions_.end())
    throw std::logic_error("no dimension " + dimension);
  return static_cast<std::size_t>(found - dimensions_.begin());
}

Operand Frame::operand(const LabelledArray &array) const {
  Operand operand{array.values, std::vector<std::size_t>(dimensions_.size(), 0)};
  std::size_t stride = 1;
  for (std::size_t d = array.dimensions.size(); d-- > 0;) {
    operand.strides[position(array.dimensions[d])] = stride;
    stride *= array.shape[d];
  }
  return operand;
}

std::pair<std::vector<std::string>, Shape> Frame::without(std::size_t along) const {
  auto dimensions = dimensions_;
  Shape shape = shape_;
  dimensions.erase(dimensions.begin() + static_cast<std::ptrdiff_t>(along));
  shape.erase(shape.begin() + static_cast<std::ptrdiff_t>(along));
  return {dimensions, shape};
}

} // namespace vibroimpact::derived
