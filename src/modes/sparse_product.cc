#include "modes/sparse_product.h"

#include <algorithm>
#include <array>

namespace vibroimpact::modes {

using structure::petsc::check;

namespace {

constexpr Index most_together = 8;

/// out += A in for `width` columns, the entries of a row side by side.
template <int width>
void add_rows(Index rows, const PetscInt *begins, const PetscInt *columns, const double *values,
              const double *in, double *out) {
  for (Index row = 0; row < rows; ++row, out += width) {
    std::array<double, width> sum{};
    for (PetscInt k = begins[row]; k < begins[row + 1]; ++k) {
      const double *x = in + Index{width} * columns[k];
      for (int j = 0; j < width; ++j)
        sum[j] += values[k] * x[j];
    }
    for (int j = 0; j < width; ++j)
      out[j] += sum[j];
  }
}

using Kernel = void (*)(Index, const PetscInt *, const PetscInt *, const double *, const double *,
                        double *);
constexpr std::array<Kernel, most_together> kernels{&add_rows<1>, &add_rows<2>, &add_rows<3>,
                                                    &add_rows<4>, &add_rows<5>, &add_rows<6>,
                                                    &add_rows<7>, &add_rows<8>};

void add_product(Mat matrix, const PetscInt *begins, const PetscInt *columns, Index rows,
                 Index width, const std::vector<double> &in, std::vector<double> &out) {
  const double *values = nullptr;
  check(MatSeqAIJGetArrayRead(matrix, &values), "Multiplying with a matrix");
  kernels[width - 1](rows, begins, columns, values, in.data(), out.data());
  check(MatSeqAIJRestoreArrayRead(matrix, &values), "Multiplying with a matrix");
}

} // namespace

SparseProduct::SparseProduct(Mat matrix) : layout_(matrix) {
  PetscBool distributed = PETSC_FALSE;
  check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(matrix), MATMPIAIJ, &distributed),
        "Reading a matrix");
  if (distributed == PETSC_FALSE) {
    own_ = part(matrix);
    return;
  }
  Mat inside = nullptr;
  Mat outside = nullptr;
  const PetscInt *columns = nullptr;
  check(MatMPIAIJGetSeqAIJ(matrix, &inside, &outside, &columns), "Reading a matrix");
  own_ = part(inside);
  outside_ = part(outside);
  find_ghosts(outside, columns);
}

SparseProduct::Part SparseProduct::part(Mat matrix) {
  Part part{.matrix = matrix};
  PetscInt rows = 0;
  PetscBool done = PETSC_FALSE;
  check(MatGetRowIJ(matrix, 0, PETSC_FALSE, PETSC_FALSE, &rows, &part.row_begins, &part.columns,
                    &done),
        "Reading a matrix");
  return part;
}

void SparseProduct::find_ghosts(Mat matrix, const PetscInt *columns) {
  PetscInt count = 0;
  check(MatGetSize(matrix, nullptr, &count), "Reading a matrix");
  ghost_count_ = count;
  structure::petsc::IndexSet from;
  check(ISCreateGeneral(PETSC_COMM_SELF, count, columns, PETSC_COPY_VALUES, from.address()),
        "Numbering the entries of other ranks");
  check(VecCreateMPIWithArray(layout_.communicator, 1, layout_.own, layout_.size, nullptr,
                              distributed_.address()),
        "Making a vector");
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, count, nullptr, ghosts_.address()),
        "Making a vector");
  check(
      VecScatterCreate(distributed_.get(), from.get(), ghosts_.get(), nullptr, scatter_.address()),
      "Making a scatter");
}

void SparseProduct::fetch_ghosts(const Block &x, Index first, Index count,
                                 std::vector<double> &packed) const {
  packed.resize(ghost_count_ * count);
  Vector column(ghost_count_);
  for (Index j = 0; j < count; ++j) {
    check(VecPlaceArray(distributed_.get(), x.col(first + j).data()), "Sharing vectors");
    check(VecPlaceArray(ghosts_.get(), column.data()), "Sharing vectors");
    check(VecScatterBegin(scatter_.get(), distributed_.get(), ghosts_.get(), INSERT_VALUES,
                          SCATTER_FORWARD),
          "Sharing vectors");
    check(VecScatterEnd(scatter_.get(), distributed_.get(), ghosts_.get(), INSERT_VALUES,
                        SCATTER_FORWARD),
          "Sharing vectors");
    check(VecResetArray(distributed_.get()), "Sharing vectors");
    check(VecResetArray(ghosts_.get()), "Sharing vectors");
    for (Index i = 0; i < ghost_count_; ++i)
      packed[i * count + j] = column[i];
  }
}

Block SparseProduct::operator()(const Block &x) const {
  Block y(x.rows(), x.cols());
  std::vector<double> in;
  std::vector<double> out;
  for (Index first = 0; first < x.cols(); first += most_together) {
    const Index count = std::min(most_together, x.cols() - first);
    in.resize(x.rows() * count);
    out.assign(x.rows() * count, 0.0);
    for (Index j = 0; j < count; ++j)
      for (Index i = 0; i < x.rows(); ++i)
        in[i * count + j] = x(i, first + j);
    add_product(own_.matrix, own_.row_begins, own_.columns, x.rows(), count, in, out);
    if (outside_.matrix != nullptr) {
      fetch_ghosts(x, first, count, in);
      add_product(outside_.matrix, outside_.row_begins, outside_.columns, x.rows(), count, in, out);
    }
    for (Index j = 0; j < count; ++j)
      for (Index i = 0; i < x.rows(); ++i)
        y(i, first + j) = out[i * count + j];
  }
  return y;
}

} // namespace vibroimpact::modes
