// Mode shapes and recorded motion as VTU files for ParaView, with a PVD file that lists them.
// Beam elements are drawn with their cubic bending shape, shell elements by their corners.
#pragma once

#include "common/result_sink.h"
#include "output/run_folder.h"
#include "reduction/reduced_body.h"

#include <string>
#include <vector>

namespace vibroimpact::output {

/// Rank 0. modes/BODY-mode-001.vtu ... of all modal bodies, and modes.pvd, in which the time of a
/// mode is its frequency [Hz]. Point data "displacement" and "rotation"; each mode is scaled so
/// that its largest displacement is a tenth of the body's size (the diagonal of its bounding box),
/// ready for Warp By Vector with factor 1. A mode that only twists is scaled to a rotation of 0.1
/// rad. The stiffeners of a shell are in BODY-mode-001-lines.vtu. static/BODY.vtu holds the static
/// displacement [m] of bodies with loads, not scaled. Nothing is written when there is no modal
/// body. Throws std::runtime_error.
void write_mode_files(RunFolder &folder, const std::vector<reduction::ReducedBody> &bodies);

/// Of each body what reduction::beam_outlines() gives; empty: the sides of beams are not written.
using Outlines = std::vector<std::vector<Matrix>>;

/// Rank 0. NAME.pvd lists the instants of `motion`, each of which has up to six files:
/// - NAME/frame-00001.vtu (and frame-00001-lines.vtu beside shells): all bodies with a mesh, base
///   motion included. Displacement [m], rotation [rad], velocity [m/s] and the number of the body
///   ("body", from 1). Von Mises stress of the motion [Pa], that of static loads not included: of
///   shells in the middle of each element, the larger of both faces and each of them; of beams the
///   largest of the extreme fibres; of solids in the middle of each element, with the components
///   "stress_xx" to "stress_zx". Where contacts touch a mesh, the force on each node
///   ("contact_force", [N]), the gap ("contact_gap", [m]; 0 at nodes without a contact), the
///   largest force up to then ("peak_contact_force", [N]), and "contact_state": 0 at nodes without
///   a contact, 1 while no force acts, 2 while one does.
/// - NAME/sections-00001.vtu: the sides of the beam elements around their cross-sections; of
/// sections
///   given by their constants those of the rectangle with the same radii of gyration.
/// - NAME/lumped-00001.vtu: a point for each point of a lumped body.
/// - NAME/stops-00001.vtu: a square for each node that can meet something other than a mesh; its
///   displacement includes the clearance (see StopFace).
/// - NAME/supports-00001.vtu: the nodes that no motion of their body displaces.
/// A run that is to stop leaves the rest and NAME.pvd to the one that goes on.
void write_motion_files(RunFolder &folder, const std::string &name,
                        const std::vector<reduction::ReducedBody> &bodies, const Outlines &outlines,
                        const Motion &motion);

/// Of a motion at the instants at which its stress is looked at:
///
/// - NAME/stress-envelope.vtu: the undeformed meshes with the largest von Mises stress over time at
///   each place ("von_mises_stress" [Pa], for shells that of both faces too), each at its own time.
/// - NAME/stress-maximum.vtu: the meshes as in a frame, at the instant of the largest of all; and
///   NAME/stress-maximum-sections.vtu, the sides of beams then.
///
/// With solids, surfaces are in files whose names end in -surfaces.vtu; with either, lines in those
/// that end in -lines.vtu.
void write_stress_files(RunFolder &folder, const std::string &name,
                        const std::vector<reduction::ReducedBody> &bodies, const Outlines &outlines,
                        const Motion &motion);

/// "-2-1-17" for the position of a point along the outer axes, counted from 1.
std::string index_suffix(const std::vector<std::size_t> &index);

} // namespace vibroimpact::output
