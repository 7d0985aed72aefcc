#include "output/vtu_writer.h"

#include "common/durable_file.h"
#include "common/signals.h"
#include "output/vtu_patches.h"
#include "reduction/stress_envelope.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace vibroimpact::output {

namespace {

using reduction::Recovery;
using reduction::ReducedBody;

constexpr double mode_amplitude = 0.1;  // of the body's size, or in rad
constexpr double stop_half_side = 0.01; // of the body's size

std::string numbered(const std::string &format, std::size_t number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), format.c_str(), number);
  return text.data();
}

struct Frame {
  double time;
  std::vector<std::string> files; ///< relative to the PVD file, one for each part
};

void write_pvd(const std::filesystem::path &file, const std::vector<Frame> &frames) {
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                     "  <Collection>\n";
  for (const Frame &frame : frames)
    for (std::size_t part = 0; part < frame.files.size(); ++part) {
      std::array<char, 32> time;
      std::snprintf(time.data(), time.size(), "%.12g", frame.time);
      text += std::string("    <DataSet timestep=\"") + time.data() + "\" part=\"" +
              std::to_string(part) + "\" file=\"" + frame.files[part] + "\"/>\n";
    }
  replace_file(file, text + "  </Collection>\n</VTKFile>\n");
}

double size_of(const Matrix &nodes) {
  return (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).norm();
}

/// The largest length of a displacement (offset 0) or rotation (offset 3) over the nodes.
double largest(const Vector &motion, Index offset) {
  const Eigen::Map<const Matrix> nodes(motion.data(), 6, motion.size() / 6);
  return nodes.middleRows(offset, 3).colwise().norm().maxCoeff();
}

double mode_scale(const Vector &mode, double body_size) {
  const double displacement = largest(mode, 0);
  const double rotation = largest(mode, 3);
  // A twist of a straight body leaves its axis in place but for round-off.
  const bool only_twists = displacement < 1e-6 * body_size * rotation;
  return only_twists ? mode_amplitude / rotation : mode_amplitude * body_size / displacement;
}

/// Lines, surfaces and solids of the bodies at an instant.
struct Meshes {
  Patches<1> lines;
  Patches<2> surfaces;
  Patches<2> sections; ///< the sides of beams
  Patches<3> solids;
  PointData line_data, surface_data, section_data, solid_data;
};

PointData both(PointData a, const PointData &b) {
  a.velocity = a.velocity || b.velocity;
  a.contact = a.contact || b.contact;
  a.von_mises = std::max(a.von_mises, b.von_mises);
  a.stress = a.stress.empty() ? b.stress : a.stress;
  return a;
}

Meshes meshes_of(const std::vector<BodyShape> &shapes) {
  Meshes meshes;
  for (const BodyShape &shape : shapes) {
    meshes.line_data = both(meshes.line_data, shape.line_data());
    meshes.surface_data = both(meshes.surface_data, shape.cell_data(2));
    meshes.solid_data = both(meshes.solid_data, shape.cell_data(3));
  }
  meshes.section_data = meshes.line_data;
  meshes.section_data.contact = false;
  for (const BodyShape &shape : shapes) {
    add_lines(shape, meshes.line_data, meshes.lines);
    add_cells(shape, meshes.surface_data, meshes.surfaces);
    add_cells(shape, meshes.solid_data, meshes.solids);
    add_sections(shape, meshes.section_data, meshes.sections);
  }
  return meshes;
}

/// Solids, surfaces and lines: the first of these that there are to NAME.vtu, surfaces and lines
/// behind them to NAME-surfaces.vtu and NAME-lines.vtu; the names of the files.
std::vector<std::string> write_mesh(RunFolder &folder, const std::string &name,
                                    const Meshes &meshes) {
  std::vector<std::string> files;
  const auto write = [&](const std::string &kind, const PointData &data, const auto &patches) {
    if (patches.empty())
      return;
    files.push_back(name + (files.empty() ? "" : kind) + ".vtu");
    write_patches(folder.claim(files.back()), data, patches);
  };
  write("", meshes.solid_data, meshes.solids);
  write("-surfaces", meshes.surface_data, meshes.surfaces);
  write("-lines", meshes.line_data, meshes.lines);
  return files;
}

std::vector<std::string> write_shape(RunFolder &folder, const std::string &name,
                                     const Recovery &recovery, const Vector &motion,
                                     std::size_t body_number) {
  return write_mesh(
      folder, name,
      meshes_of({BodyShape{.recovery = &recovery, .number = body_number, .motion = motion}}));
}

void write_modes_of(RunFolder &folder, const ReducedBody &body, std::size_t body_number,
                    std::vector<Frame> &frames) {
  constexpr double two_pi = 6.283185307179586476925;
  const double size = size_of(body.recovery.nodes);
  for (Index j = 0; j < body.size(); ++j) {
    const std::string name =
        "modes/" + body.name + numbered("-mode-%03zu", static_cast<std::size_t>(j) + 1);
    const Vector mode = body.recovery.shapes.col(j);
    frames.push_back(
        {body.omega()[j] / two_pi,
         write_shape(folder, name, body.recovery, mode_scale(mode, size) * mode, body_number)});
  }
}

void write_static_files(RunFolder &folder, const std::vector<ReducedBody> &bodies) {
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (const Recovery &recovery = bodies[b].recovery; recovery.static_displacement.size() > 0)
      write_shape(folder, "static/" + bodies[b].name, recovery, recovery.static_displacement,
                  b + 1);
}

/// Two bodies with the same frequency are two parts of one instant.
std::vector<Frame> merged_by_time(std::vector<Frame> frames) {
  std::stable_sort(frames.begin(), frames.end(),
                   [](const Frame &a, const Frame &b) { return a.time < b.time; });
  std::vector<Frame> merged;
  for (Frame &frame : frames)
    if (!merged.empty() && merged.back().time == frame.time)
      merged.back().files.insert(merged.back().files.end(), frame.files.begin(), frame.files.end());
    else
      merged.push_back(std::move(frame));
  return merged;
}

/// Shapes times coordinates, moved with the base.
Vector node_motion(const Recovery &recovery, const Vector &coordinates, const Vector3 &base) {
  Vector motion = recovery.shapes * coordinates;
  for (Index node = 0; node < recovery.nodes.cols(); ++node)
    motion.segment<3>(6 * node) += base;
  return motion;
}

/// A motion at one instant.
class Instant {
public:
  Instant(const std::vector<ReducedBody> &bodies, const Outlines &outlines, const Motion &motion,
          std::size_t number)
      : bodies_(bodies), outlines_(outlines), motion_(motion), number_(number),
        row_(static_cast<Index>(number)) {}

  double time() const { return motion_.time[number_]; }

  std::vector<BodyShape> shapes() const {
    std::vector<BodyShape> shapes;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (!bodies_[b].recovery.empty())
        shapes.push_back(shape(b));
    return shapes;
  }

  Patches<0> lumped_points() const {
    Patches<0> points;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (bodies_[b].recovery.empty())
        for (const reduction::BodyPoint &point : bodies_[b].points) {
          const Vector6 moved = point_motion(point, motion_.coordinates[b], base(b));
          const Vector6 velocity =
              has_velocity() ? point_motion(point, motion_.velocities[b], base_velocity(b))
                             : Vector6(Vector6::Zero());
          add_point(point.position, moved, has_velocity() ? &velocity : nullptr, b + 1, points);
        }
    return points;
  }

  /// Nodes of meshes that the shapes leave in place: the ground moves as they do.
  Patches<0> supports() const {
    Patches<0> points;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const Recovery &recovery = bodies_[b].recovery;
      Vector6 moved = Vector6::Zero();
      moved.head<3>() = base(b);
      for (Index node = 0; node < recovery.nodes.cols(); ++node)
        if (recovery.shapes.middleRows(6 * node, 3).isZero(0))
          add_point(recovery.nodes.col(node), moved, nullptr, b + 1, points);
    }
    return points;
  }

  Patches<2> stops(const std::vector<BodyShape> &shapes) const {
    std::vector<Vector> moved(bodies_.size());
    double size = 0;
    for (const BodyShape &shape : shapes) {
      moved[shape.number - 1] = shape.motion;
      size = std::max(size, size_of(shape.recovery->nodes));
    }
    Patches<2> faces;
    for (const StopFace &face : stop_faces(bodies_, motion_, moved, number_))
      add_stop(face, stop_half_side * size, faces);
    return faces;
  }

private:
  bool has_velocity() const { return !motion_.velocities.empty(); }
  Vector3 base(std::size_t body) const { return motion_.base_displacement[body].row(row_); }
  Vector3 base_velocity(std::size_t body) const { return motion_.base_velocity[body].row(row_); }

  Vector6 point_motion(const reduction::BodyPoint &point, const Matrix &coordinates,
                       const Vector3 &base) const {
    Vector6 motion = point.rows * coordinates.row(row_).transpose();
    motion.head<3>() += base;
    return motion;
  }

  BodyShape shape(std::size_t body) const {
    const Recovery &recovery = bodies_[body].recovery;
    const Vector coordinates = motion_.coordinates[body].row(row_);
    BodyShape shape{.recovery = &recovery,
                    .number = body + 1,
                    .motion = node_motion(recovery, coordinates, base(body))};
    if (has_velocity())
      shape.velocity =
          node_motion(recovery, motion_.velocities[body].row(row_), base_velocity(body));
    if (!outlines_.empty())
      shape.outlines = outlines_[body];
    shape.contact = contact_fields(motion_, body, recovery.nodes.cols(), number_);
    if (!recovery.line_stress.empty())
      shape.line_stress = recovery.line_stress.rows * coordinates;
    if (!recovery.cell_stress.empty())
      shape.cell_stress = recovery.cell_stress.rows * coordinates;
    return shape;
  }

  const std::vector<ReducedBody> &bodies_;
  const Outlines &outlines_;
  const Motion &motion_;
  std::size_t number_;
  Index row_;
};

template <int dimension>
void add_part(RunFolder &folder, const std::string &file, const PointData &data,
              const Patches<dimension> &patches, Frame &frame) {
  if (patches.empty())
    return;
  write_patches(folder.claim(file), data, patches);
  frame.files.push_back(file);
}

Frame write_frame(RunFolder &folder, const std::string &name, const Instant &instant,
                  std::size_t number, bool has_velocity) {
  const std::vector<BodyShape> shapes = instant.shapes();
  const Meshes meshes = meshes_of(shapes);
  Frame frame{instant.time(), write_mesh(folder, name + numbered("/frame-%05zu", number), meshes)};
  add_part(folder, name + numbered("/sections-%05zu.vtu", number), meshes.section_data,
           meshes.sections, frame);
  add_part(folder, name + numbered("/lumped-%05zu.vtu", number), {.velocity = has_velocity},
           instant.lumped_points(), frame);
  add_part(folder, name + numbered("/stops-%05zu.vtu", number), {.contact = true},
           instant.stops(shapes), frame);
  add_part(folder, name + numbered("/supports-%05zu.vtu", number), {}, instant.supports(), frame);
  return frame;
}

/// The undeformed bodies with the largest stresses over time, and the instant of the largest of
/// all.
struct StressOverTime {
  std::vector<BodyShape> shapes;
  double maximum = -1; ///< [Pa]
  Index instant = 0;

  /// The stress of places of the body that was added last.
  Vector add(const reduction::CellStress &places, const Matrix &coordinates) {
    const reduction::StressEnvelope envelope = reduction::stress_envelope(places, coordinates);
    if (envelope.place >= 0 && envelope.maximum() > maximum) {
      maximum = envelope.maximum();
      instant = envelope.instant;
    }
    return envelope.as_stress(places.components);
  }
};

StressOverTime stress_over_time(const std::vector<ReducedBody> &bodies, const Motion &motion) {
  StressOverTime stress;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (const Recovery &recovery = bodies[b].recovery; !recovery.empty()) {
      BodyShape shape{.recovery = &recovery,
                      .number = b + 1,
                      .motion = Vector::Zero(6 * recovery.nodes.cols()),
                      .largest_stress = true};
      shape.line_stress = stress.add(recovery.line_stress, motion.coordinates[b]);
      shape.cell_stress = stress.add(recovery.cell_stress, motion.coordinates[b]);
      stress.shapes.push_back(std::move(shape));
    }
  return stress;
}

} // namespace

void write_mode_files(RunFolder &folder, const std::vector<ReducedBody> &bodies) {
  std::vector<Frame> frames;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (!bodies[b].recovery.empty())
      write_modes_of(folder, bodies[b], b + 1, frames);
  if (!frames.empty())
    write_pvd(folder.claim("modes.pvd"), merged_by_time(std::move(frames)));
  write_static_files(folder, bodies);
}

void write_motion_files(RunFolder &folder, const std::string &name,
                        const std::vector<ReducedBody> &bodies, const Outlines &outlines,
                        const Motion &motion) {
  std::vector<Frame> frames;
  for (std::size_t instant = 0; instant < motion.time.size() && !stop_requested(); ++instant)
    frames.push_back(write_frame(folder, name, Instant(bodies, outlines, motion, instant),
                                 instant + 1, !motion.velocities.empty()));
  if (!stop_requested())
    write_pvd(folder.claim(name + ".pvd"), frames);
}

void write_stress_files(RunFolder &folder, const std::string &name,
                        const std::vector<ReducedBody> &bodies, const Outlines &outlines,
                        const Motion &motion) {
  const StressOverTime stress = stress_over_time(bodies, motion);
  write_mesh(folder, name + "/stress-envelope", meshes_of(stress.shapes));
  const Instant instant(bodies, outlines, motion, static_cast<std::size_t>(stress.instant));
  const Meshes meshes = meshes_of(instant.shapes());
  write_mesh(folder, name + "/stress-maximum", meshes);
  Frame unused{};
  add_part(folder, name + "/stress-maximum-sections.vtu", meshes.section_data, meshes.sections,
           unused);
}

std::string index_suffix(const std::vector<std::size_t> &index) {
  std::string suffix;
  for (const std::size_t position : index)
    suffix.append("-").append(std::to_string(position + 1));
  return suffix;
}

} // namespace vibroimpact::output
