// The cells of meshes, lumped points, stops and supports as patches of deal.II's VTU writer.
#pragma once

#include "output/beam_curve.h"
#include "output/contact_fields.h"
#include "output/vtu_point_data.h"

#include <deal.II/base/data_out_base.h>

#include <filesystem>

namespace vibroimpact::output {

template <int dimension> using Patches = std::vector<dealii::DataOutBase::Patch<dimension, 3>>;

/// A body at an instant.
struct BodyShape {
  const reduction::Recovery *recovery = nullptr;
  std::size_t number = 1; ///< from 1
  Vector motion;          ///< 6N: displacements [m] and rotations [rad]
  Vector velocity{};      ///< 6N [m/s, rad/s]; empty when not known
  /// Around the cross-section of each of its lines, from the line [m]; empty: not drawn.
  std::vector<Matrix> outlines{};
  ContactFields contact{};     ///< no columns when no contact touches a mesh
  Vector line_stress{};        ///< [Pa], rows as in Recovery::line_stress; empty when not known
  Vector cell_stress{};        ///< as in Recovery::cell_stress
  bool largest_stress = false; ///< they only have the von Mises stress of StressEnvelope::as_stress

  PointData line_data() const;
  /// Of its cells of this dimension.
  PointData cell_data(int dimension) const;
};

/// Beam elements with their cubic bending shape. Stress is linear between the nodes of an element
/// and NaN in elements where it is not known.
void add_lines(const BodyShape &shape, const PointData &data, Patches<1> &patches);

/// The sides of beam elements between the outlines of their ends, which stay plane: straight from
/// node to node. Points have no contact values.
void add_sections(const BodyShape &shape, const PointData &data, Patches<2> &patches);

/// Cells of this dimension by their corners, with one stress for an element: of surfaces the von
/// Mises stress of both faces, of solids all components too.
template <int dimension>
void add_cells(const BodyShape &shape, const PointData &data, Patches<dimension> &patches);

/// A point with its displacement and rotation, without other data.
void add_point(const Vector3 &place, const Vector6 &motion, const Vector6 *velocity,
               std::size_t body_number, Patches<0> &patches);

/// A square across the normal with sides of twice `half_side` [m].
void add_stop(const StopFace &face, double half_side, Patches<2> &patches);

/// Of places of so many components each [Pa].
double largest_von_mises(const Eigen::Ref<const Vector> &stress, Index components = 3);

/// Throws std::runtime_error. There must be a patch.
template <int dimension>
void write_patches(const std::filesystem::path &file, const PointData &data,
                   const Patches<dimension> &patches);

} // namespace vibroimpact::output
