#include "output/vtu_writer.h"

#include "common/durable_file.h"
#include "common/signals.h"
#include "output/beam_curve.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <deal.II/base/data_out_base.h>
#include <deal.II/grid/reference_cell.h>
#include <fstream>
#include <tuple>
#include <utility>

namespace vibroimpact::output {

namespace {

using dealii::DataOutBase::Patch;
using reduction::Recovery;
using reduction::ReducedBody;

constexpr unsigned line_subdivisions = 4;
constexpr double mode_amplitude = 0.1; // of the body's size, or in rad

/// Three displacements, three rotations, the number of the body.
constexpr unsigned n_components = 7;
/// Behind them, where contacts touch a mesh: three of the force, the gap, the peak of the force.
constexpr unsigned n_contact_components = 5;
using ContactValues = Eigen::Matrix<float, n_contact_components, Eigen::Dynamic>;

std::string numbered(const std::string &format, std::size_t number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), format.c_str(), number);
  return text.data();
}

dealii::Point<3> to_point(const Vector3 &position) {
  return {position.x(), position.y(), position.z()};
}

void set_column(dealii::Table<2, float> &data, unsigned column, const Vector6 &motion,
                std::size_t body_number) {
  for (unsigned component = 0; component < 6; ++component)
    data(component, column) = static_cast<float>(motion[component]);
  data(6, column) = static_cast<float>(body_number);
}

/// A column for each node of a mesh; no columns at all without contacts on meshes.
void set_contact(dealii::Table<2, float> &data, unsigned column, const ContactValues &contact,
                 int node) {
  for (unsigned component = 0; component < n_contact_components && contact.cols() > 0; ++component)
    data(n_components + component, column) = contact(component, node);
}

unsigned components_with(const ContactValues &contact) {
  return n_components + (contact.cols() > 0 ? n_contact_components : 0);
}

/// One patch for each beam element; `motion` holds six values for each node.
void add_lines(const Recovery &recovery, const Vector &motion, std::size_t body_number,
               const ContactValues &contact, std::vector<Patch<1, 3>> &patches) {
  for (const auto &[a, b] : recovery.lines) {
    Patch<1, 3> patch;
    patch.vertices[0] = to_point(recovery.nodes.col(a));
    patch.vertices[1] = to_point(recovery.nodes.col(b));
    patch.reference_cell = dealii::ReferenceCells::Line;
    patch.n_subdivisions = line_subdivisions;
    patch.patch_index = static_cast<unsigned>(patches.size());
    patch.data.reinit(components_with(contact), line_subdivisions + 1);
    set_contact(patch.data, 0, contact, a);
    set_contact(patch.data, line_subdivisions, contact, b);
    for (unsigned i = 0; i <= line_subdivisions; ++i)
      set_column(patch.data, i,
                 beam_curve(recovery.nodes.col(a), recovery.nodes.col(b),
                            motion.segment<6>(Index{6} * a), motion.segment<6>(Index{6} * b),
                            static_cast<double>(i) / line_subdivisions),
                 body_number);
    patches.push_back(std::move(patch));
  }
}

/// One patch for each shell element.
void add_surfaces(const Recovery &recovery, const Vector &motion, std::size_t body_number,
                  const ContactValues &contact, std::vector<Patch<2, 3>> &patches) {
  for (const auto &nodes : recovery.surfaces) {
    const bool triangle = nodes[3] < 0;
    // deal.II numbers the corners of a quadrilateral line by line, not around it.
    const std::array<int, 4> order = {nodes[0], nodes[1], triangle ? nodes[2] : nodes[3], nodes[2]};
    Patch<2, 3> patch;
    patch.reference_cell =
        triangle ? dealii::ReferenceCells::Triangle : dealii::ReferenceCells::Quadrilateral;
    patch.patch_index = static_cast<unsigned>(patches.size());
    const unsigned corners = triangle ? 3 : 4;
    patch.data.reinit(components_with(contact), corners);
    for (unsigned i = 0; i < corners; ++i) {
      patch.vertices[i] = to_point(recovery.nodes.col(order[i]));
      set_column(patch.data, i, motion.segment<6>(Index{6} * order[i]), body_number);
      set_contact(patch.data, i, contact, order[i]);
    }
    patches.push_back(std::move(patch));
  }
}

void add_points(const ReducedBody &body, const Vector &coordinates, const Vector3 &base,
                std::size_t body_number, std::vector<Patch<0, 3>> &patches) {
  for (const reduction::BodyPoint &point : body.points) {
    Patch<0, 3> patch;
    patch.vertices[0] = to_point(point.position);
    patch.patch_index = static_cast<unsigned>(patches.size());
    patch.data.reinit(n_components, 1);
    Vector6 motion = point.rows * coordinates;
    motion.head<3>() += base;
    set_column(patch.data, 0, motion, body_number);
    patches.push_back(std::move(patch));
  }
}

template <int dimension>
void write_patches(const std::filesystem::path &file,
                   const std::vector<Patch<dimension, 3>> &patches) {
  using namespace dealii::DataComponentInterpretation;
  std::vector<std::string> names = {"displacement", "displacement", "displacement", "rotation",
                                    "rotation",     "rotation",     "body"};
  std::vector<std::tuple<unsigned, unsigned, std::string, DataComponentInterpretation>> vectors = {
      {0, 2, "displacement", component_is_part_of_vector},
      {3, 5, "rotation", component_is_part_of_vector}};
  if (patches.front().data.n_rows() > n_components) {
    names.insert(names.end(), {"contact_force", "contact_force", "contact_force", "contact_gap",
                               "peak_contact_force"});
    vectors.emplace_back(n_components, n_components + 2, "contact_force",
                         component_is_part_of_vector);
  }
  dealii::DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = false;
  flags.print_date_and_time = false; // the same result, the same file
  // The best compression was a third of all time of a large shell, for files 8 % smaller.
  flags.compression_level = dealii::DataOutBase::VtkFlags::best_speed;
  std::ofstream stream(file, std::ios::binary);
  dealii::DataOutBase::write_vtu(patches, names, vectors, flags, stream);
  stream.close();
  if (!stream)
    fail_with_reason(file, "write");
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

/// Lines to NAME.vtu, or to NAME-lines.vtu when there are surfaces, which then take NAME.vtu; the
/// names of the files.
std::vector<std::string> write_mesh(RunFolder &folder, const std::string &name,
                                    const std::vector<Patch<1, 3>> &lines,
                                    const std::vector<Patch<2, 3>> &surfaces) {
  std::vector<std::string> files;
  if (!surfaces.empty()) {
    files.push_back(name + ".vtu");
    write_patches(folder.claim(files.back()), surfaces);
  }
  if (!lines.empty()) {
    files.push_back(name + (surfaces.empty() ? ".vtu" : "-lines.vtu"));
    write_patches(folder.claim(files.back()), lines);
  }
  return files;
}

std::vector<std::string> write_shape(RunFolder &folder, const std::string &name,
                                     const Recovery &recovery, const Vector &motion,
                                     std::size_t body_number) {
  std::vector<Patch<1, 3>> lines;
  std::vector<Patch<2, 3>> surfaces;
  add_lines(recovery, motion, body_number, {}, lines);
  add_surfaces(recovery, motion, body_number, {}, surfaces);
  return write_mesh(folder, name, lines, surfaces);
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

Vector node_motion(const Recovery &recovery, const Vector &coordinates, const Vector3 &base) {
  Vector motion = recovery.shapes * coordinates;
  for (Index node = 0; node < recovery.nodes.cols(); ++node)
    motion.segment<3>(6 * node) += base;
  return motion;
}

bool touches_mesh(const Motion &motion) {
  return std::any_of(motion.contacts.begin(), motion.contacts.end(),
                     [](const ContactTrace &trace) { return !trace.nodes.empty(); });
}

/// What the contacts do to the nodes of a body. A node of several contacts has the sum of their
/// forces, the smallest of their gaps and the largest of their peaks.
ContactValues contact_values(const Motion &motion, std::size_t body, Index nodes,
                             std::size_t instant) {
  ContactValues values;
  if (!touches_mesh(motion))
    return values;
  values.setZero(n_contact_components, nodes);
  std::vector<bool> touched(static_cast<std::size_t>(nodes));
  for (const ContactTrace &trace : motion.contacts)
    for (const TouchedNode &at : trace.nodes) {
      if (at.body != body)
        continue;
      auto column = values.col(at.node);
      const auto gap = static_cast<float>(trace.gap[instant]);
      column.head<3>() += (trace.force[instant] * at.push).cast<float>();
      column[3] = touched[at.node] ? std::min(column[3], gap) : gap;
      column[4] = std::max(column[4], static_cast<float>(trace.peak_force[instant]));
      touched[at.node] = true;
    }
  return values;
}

Frame write_frame(RunFolder &folder, const std::string &name,
                  const std::vector<ReducedBody> &bodies, const Motion &motion,
                  std::size_t instant) {
  std::vector<Patch<1, 3>> lines;
  std::vector<Patch<2, 3>> surfaces;
  std::vector<Patch<0, 3>> points;
  const auto row = static_cast<Index>(instant);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Vector coordinates = motion.coordinates[b].row(row);
    const Vector3 base = motion.base_displacement[b].row(row);
    if (bodies[b].recovery.empty()) {
      add_points(bodies[b], coordinates, base, b + 1, points);
      continue;
    }
    const Vector moved = node_motion(bodies[b].recovery, coordinates, base);
    const ContactValues contact =
        contact_values(motion, b, bodies[b].recovery.nodes.cols(), instant);
    add_lines(bodies[b].recovery, moved, b + 1, contact, lines);
    add_surfaces(bodies[b].recovery, moved, b + 1, contact, surfaces);
  }
  Frame frame{motion.time[instant],
              write_mesh(folder, name + numbered("/frame-%05zu", instant + 1), lines, surfaces)};
  if (!points.empty()) {
    frame.files.push_back(name + numbered("/lumped-%05zu.vtu", instant + 1));
    write_patches(folder.claim(frame.files.back()), points);
  }
  return frame;
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
                        const std::vector<ReducedBody> &bodies, const Motion &motion) {
  std::vector<Frame> frames;
  for (std::size_t instant = 0; instant < motion.time.size() && !stop_requested(); ++instant)
    frames.push_back(write_frame(folder, name, bodies, motion, instant));
  if (!stop_requested())
    write_pvd(folder.claim(name + ".pvd"), frames);
}

std::string index_suffix(const std::vector<std::size_t> &index) {
  std::string suffix;
  for (const std::size_t position : index)
    suffix.append("-").append(std::to_string(position + 1));
  return suffix;
}

} // namespace vibroimpact::output
