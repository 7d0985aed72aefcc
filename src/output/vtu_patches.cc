#include "output/vtu_patches.h"

#include "common/durable_file.h"

#include <deal.II/grid/reference_cell.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace vibroimpact::output {

namespace {

using dealii::DataOutBase::Patch;
using reduction::CellStress;
using reduction::Recovery;

constexpr unsigned line_subdivisions = 4;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

dealii::Point<3> to_point(const Vector3 &position) {
  return {position.x(), position.y(), position.z()};
}

/// Writes the data of one point, in the order of PointData.
class Column {
public:
  Column(dealii::Table<2, float> &data, unsigned column) : data_(data), column_(column) {}
  void add(double value) { data_(row_++, column_) = static_cast<float>(value); }
  template <class Values> void add_all(const Values &values) {
    for (const auto value : values)
      add(value);
  }

private:
  dealii::Table<2, float> &data_;
  unsigned column_;
  unsigned row_ = 0;
};

/// The rows of the places of one cell.
Vector places_of(const CellStress &places, const Vector &stress, std::size_t cell) {
  const Index first = places.first[cell];
  return stress.segment(places.components * first,
                        places.components * (places.first[cell + 1] - first));
}

double von_mises_along(const CellStress &places, const Vector &stress, std::size_t line, double t) {
  const Vector own = places_of(places, stress, line);
  const Index half = own.size() / 2;
  return half == 0
             ? not_known
             : largest_von_mises((1 - t) * own.head(half) + t * own.tail(half), places.components);
}

/// A middle of a line has no contact values but zeros.
Eigen::Matrix<float, 6, 1> contact_along(const BodyShape &shape, int a, int b, unsigned i) {
  if (i == 0)
    return shape.contact.col(a);
  if (i == line_subdivisions)
    return shape.contact.col(b);
  return Eigen::Matrix<float, 6, 1>::Zero();
}

/// Of a body given by its modes only displacements may be known, and its lines stay straight.
/// Without any shape nothing says so.
bool has_rotations(const Recovery &recovery) {
  if (recovery.shapes.cols() == 0)
    return true;
  for (Index node = 0; node < recovery.nodes.cols(); ++node)
    if (!recovery.shapes.middleRows(6 * node + 3, 3).isZero(0))
      return true;
  return false;
}

void fill_line_point(const BodyShape &shape, const PointData &data, std::size_t line, unsigned i,
                     bool curved, dealii::Table<2, float> &table) {
  const auto [a, b] = shape.recovery->lines[line];
  const double t = static_cast<double>(i) / line_subdivisions;
  const auto along = [&](const Vector &values) {
    if (!curved)
      return Vector6((1 - t) * values.segment<6>(Index{6} * a) +
                     t * values.segment<6>(Index{6} * b));
    return beam_curve(shape.recovery->nodes.col(a), shape.recovery->nodes.col(b),
                      values.segment<6>(Index{6} * a), values.segment<6>(Index{6} * b), t);
  };
  Column column(table, i);
  column.add_all(along(shape.motion));
  column.add(static_cast<double>(shape.number));
  if (data.velocity)
    column.add_all(Vector3(along(shape.velocity).head<3>()));
  if (data.contact)
    column.add_all(contact_along(shape, a, b, i));
  if (data.von_mises > 0)
    column.add(shape.line_stress.size() == 0
                   ? not_known
                   : von_mises_along(shape.recovery->line_stress, shape.line_stress, line, t));
}

/// `stress`: what stands behind the contact values.
void fill_corner(const BodyShape &shape, const PointData &data, int node, const Vector &stress,
                 unsigned corner, dealii::Table<2, float> &table) {
  Column column(table, corner);
  column.add_all(shape.motion.segment<6>(Index{6} * node));
  column.add(static_cast<double>(shape.number));
  if (data.velocity)
    column.add_all(shape.velocity.segment<3>(Index{6} * node));
  if (data.contact)
    column.add_all(shape.contact.col(node));
  column.add_all(stress);
}

/// As PointData says: the largest von Mises stress, those of both faces of a surface, the
/// components in a solid.
Vector stress_of_cell(const BodyShape &shape, const PointData &data, std::size_t cell) {
  Vector values =
      Vector::Constant(data.von_mises + static_cast<Index>(data.stress.size()), not_known);
  if (shape.cell_stress.size() == 0 || values.size() == 0)
    return values;
  const CellStress &places = shape.recovery->cell_stress;
  const Vector own = places_of(places, shape.cell_stress, cell);
  if (own.size() != (data.von_mises == 3 ? 2 : 1) * places.components)
    return values;
  values[0] = largest_von_mises(own, places.components);
  for (Index face = 0; data.von_mises == 3 && face < 2; ++face)
    values[1 + face] = largest_von_mises(own.segment(face * places.components, places.components),
                                         places.components);
  values.tail(static_cast<Index>(data.stress.size())) =
      own.head(static_cast<Index>(data.stress.size()));
  return values;
}

} // namespace

double largest_von_mises(const Eigen::Ref<const Vector> &stress, Index components) {
  double largest = 0;
  for (Index row = 0; row < stress.size(); row += components)
    largest = std::max(largest, reduction::squared_von_mises(stress.data() + row, components));
  return std::sqrt(largest);
}

PointData BodyShape::line_data() const {
  return {.velocity = velocity.size() > 0,
          .contact = contact.cols() > 0,
          .von_mises = line_stress.size() > 0 ? 1U : 0U};
}

PointData BodyShape::cell_data(int dimension) const {
  PointData data{.velocity = velocity.size() > 0, .contact = contact.cols() > 0};
  const auto is_one = [&](const structure::Cell &cell) {
    return structure::cell_type(cell.shape).dimension == dimension;
  };
  const auto cell = std::find_if(recovery->cells.begin(), recovery->cells.end(), is_one);
  if (cell_stress.size() == 0 || cell == recovery->cells.end())
    return data;
  data.von_mises = dimension == 2 ? 3 : 1;
  if (dimension == 3 && !largest_stress)
    data.stress = structure::cell_type(cell->shape).stress;
  return data;
}

void add_lines(const BodyShape &shape, const PointData &data, Patches<1> &patches) {
  const bool curved = has_rotations(*shape.recovery);
  for (std::size_t line = 0; line < shape.recovery->lines.size(); ++line) {
    const auto [a, b] = shape.recovery->lines[line];
    Patch<1, 3> patch;
    patch.vertices[0] = to_point(shape.recovery->nodes.col(a));
    patch.vertices[1] = to_point(shape.recovery->nodes.col(b));
    patch.reference_cell = dealii::ReferenceCells::Line;
    patch.n_subdivisions = line_subdivisions;
    patch.patch_index = static_cast<unsigned>(patches.size());
    patch.data.reinit(data.size(), line_subdivisions + 1);
    for (unsigned i = 0; i <= line_subdivisions; ++i)
      fill_line_point(shape, data, line, i, curved, patch.data);
    patches.push_back(std::move(patch));
  }
}

namespace {

/// Displacement and rotation of a place that a rotation r of the section moves by r x place.
Vector6 moved_with_section(const Vector6 &node, const Vector3 &place) {
  Vector6 moved = node;
  moved.head<3>() += node.tail<3>().cross(place);
  return moved;
}

void fill_section_point(const BodyShape &shape, const PointData &data, std::size_t line, int end,
                        const Vector3 &place, unsigned corner, dealii::Table<2, float> &table) {
  const Index row = Index{6} * shape.recovery->lines[line][static_cast<std::size_t>(end)];
  Column column(table, corner);
  column.add_all(moved_with_section(shape.motion.segment<6>(row), place));
  column.add(static_cast<double>(shape.number));
  if (data.velocity)
    column.add_all(Vector3(moved_with_section(shape.velocity.segment<6>(row), place).head<3>()));
  if (data.von_mises > 0)
    column.add(shape.line_stress.size() == 0
                   ? not_known
                   : von_mises_along(shape.recovery->line_stress, shape.line_stress, line, end));
}

/// Between two neighbouring places of the outline, a and b.
Patch<2, 3> section_side(const BodyShape &shape, const PointData &data, std::size_t line,
                         const Vector3 &a, const Vector3 &b) {
  Patch<2, 3> patch;
  patch.reference_cell = dealii::ReferenceCells::Quadrilateral;
  patch.data.reinit(data.size(), 4);
  for (unsigned corner = 0; corner < 4; ++corner) {
    const int end = corner < 2 ? 0 : 1;
    const Vector3 &place = corner % 2 == 0 ? a : b;
    const int node = shape.recovery->lines[line][static_cast<std::size_t>(end)];
    patch.vertices[corner] = to_point(shape.recovery->nodes.col(node) + place);
    fill_section_point(shape, data, line, end, place, corner, patch.data);
  }
  return patch;
}

} // namespace

void add_sections(const BodyShape &shape, const PointData &data, Patches<2> &patches) {
  for (std::size_t line = 0; line < shape.outlines.size(); ++line) {
    const Matrix &outline = shape.outlines[line];
    for (Index i = 0; i < outline.cols(); ++i) {
      patches.push_back(
          section_side(shape, data, line, outline.col(i), outline.col((i + 1) % outline.cols())));
      patches.back().patch_index = static_cast<unsigned>(patches.size() - 1);
    }
  }
}

namespace {

/// Of the type that has this number in VTK's files.
dealii::ReferenceCell reference_cell(int dimension, unsigned vtk) {
  for (const dealii::ReferenceCell cell :
       {dealii::ReferenceCells::Triangle, dealii::ReferenceCells::Quadrilateral,
        dealii::ReferenceCells::Tetrahedron, dealii::ReferenceCells::Pyramid,
        dealii::ReferenceCells::Wedge, dealii::ReferenceCells::Hexahedron})
    if (static_cast<int>(cell.get_dimension()) == dimension && cell.vtk_linear_type() == vtk)
      return cell;
  throw std::logic_error("no patch has the shape of a cell");
}

} // namespace

template <int dimension>
void add_cells(const BodyShape &shape, const PointData &data, Patches<dimension> &patches) {
  // deal.II numbers the corners of quadrilaterals and hexahedra line by line, cells go around.
  constexpr std::array<unsigned, 8> line_by_line = {0, 1, 3, 2, 4, 5, 7, 6};
  for (std::size_t number = 0; number < shape.recovery->cells.size(); ++number) {
    const structure::Cell &cell = shape.recovery->cells[number];
    if (structure::cell_type(cell.shape).dimension != dimension)
      continue;
    const Vector stress = stress_of_cell(shape, data, number);
    Patch<dimension, 3> patch;
    patch.reference_cell = reference_cell(dimension, static_cast<unsigned>(cell.shape));
    patch.patch_index = static_cast<unsigned>(patches.size());
    patch.data.reinit(data.size(), static_cast<unsigned>(cell.size));
    for (unsigned i = 0; i < static_cast<unsigned>(cell.size); ++i) {
      const unsigned corner = patch.reference_cell.is_hyper_cube() ? line_by_line[i] : i;
      const int node = cell.corners[i];
      patch.vertices[corner] = to_point(shape.recovery->nodes.col(node));
      fill_corner(shape, data, node, stress, corner, patch.data);
    }
    patches.push_back(std::move(patch));
  }
}

template void add_cells(const BodyShape &, const PointData &, Patches<2> &);
template void add_cells(const BodyShape &, const PointData &, Patches<3> &);

void add_point(const Vector3 &place, const Vector6 &motion, const Vector6 *velocity,
               std::size_t body_number, Patches<0> &patches) {
  Patch<0, 3> patch;
  patch.vertices[0] = to_point(place);
  patch.patch_index = static_cast<unsigned>(patches.size());
  patch.data.reinit(PointData{.velocity = velocity != nullptr}.size(), 1);
  Column column(patch.data, 0);
  column.add_all(motion);
  column.add(static_cast<double>(body_number));
  if (velocity != nullptr)
    column.add_all(velocity->head<3>());
  patches.push_back(std::move(patch));
}

void add_stop(const StopFace &face, double half_side, Patches<2> &patches) {
  const Vector3 across = half_side * face.normal.unitOrthogonal();
  const Vector3 other = face.normal.cross(across);
  Patch<2, 3> patch;
  patch.reference_cell = dealii::ReferenceCells::Quadrilateral;
  patch.patch_index = static_cast<unsigned>(patches.size());
  patch.data.reinit(PointData{.contact = true}.size(), 4);
  for (unsigned corner = 0; corner < 4; ++corner) {
    patch.vertices[corner] =
        to_point(face.place + (corner % 2 == 0 ? -1 : 1) * across + (corner < 2 ? -1 : 1) * other);
    Column column(patch.data, corner);
    column.add_all(face.displacement);
    column.add_all(Vector3::Zero().eval());
    column.add(0);
    column.add_all(face.contact);
  }
  patches.push_back(std::move(patch));
}

template <int dimension>
void write_patches(const std::filesystem::path &file, const PointData &data,
                   const Patches<dimension> &patches) {
  dealii::DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = false;
  flags.print_date_and_time = false; // the same result, the same file
  // The best compression was a third of all time of a large shell, for files 8 % smaller.
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  std::ofstream stream(file, std::ios::binary);
  dealii::DataOutBase::write_vtu(patches, data.names(), data.vectors(), flags, stream);
  stream.close();
  if (!stream)
    fail_with_reason(file, "write");
}

template void write_patches(const std::filesystem::path &, const PointData &, const Patches<0> &);
template void write_patches(const std::filesystem::path &, const PointData &, const Patches<1> &);
template void write_patches(const std::filesystem::path &, const PointData &, const Patches<2> &);
template void write_patches(const std::filesystem::path &, const PointData &, const Patches<3> &);

} // namespace vibroimpact::output
