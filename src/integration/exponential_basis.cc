#include "integration/exponential_basis.h"

namespace vibroimpact::integration {

void ExponentialBasis::take_inputs(const ExponentialBasis &other) {
  for (std::size_t j = n_modes(); j < groups.size(); ++j)
    groups[j].exponent = other.groups[j].exponent;
  inputs = other.inputs;
  const Index first = mode_columns();
  for (Index column = first; column < columns.cols(); ++column)
    columns.col(column) = other.columns.col(column);
}

// c Re(a) + d Im(a) = Re((c - i d) a).
Complex seen_of_group(const Matrix &rows, Index row, const ExponentialBasis &basis,
                      const ExponentialBasis::Group &group) {
  double of_real = 0;
  double of_imaginary = 0;
  const Index next = group.is_pair ? group.column + 1 : group.column;
  for (Index i = 0; i < rows.cols(); ++i) {
    of_real += rows(row, i) * basis.columns(i, group.column);
    of_imaginary += rows(row, i) * basis.columns(i, next);
  }
  return {of_real, group.is_pair ? -of_imaginary : 0.0};
}

} // namespace vibroimpact::integration
