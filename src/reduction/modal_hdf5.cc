#include "common/hdf5_file.h"
#include "parameters/text.h"
#include "reduction/modal_data.h"
#include "structure/beam_definition.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::reduction {

namespace {

[[noreturn]] void fail(const std::string &key, const std::string &problem) {
  throw structure::DefinitionError("Modal data", "", key, problem);
}

/// The datasets of a body.
class StoredGroup {
public:
  StoredGroup(const Hdf5File &file, std::string path) : file_(file), path_(std::move(path) + "/") {}

  bool has(const std::string &name) const {
    return file_.contains(path_ + name) && !file_.is_group(path_ + name);
  }

  /// Row-major. `lengths` of the dimensions; negative: any length.
  std::vector<double> numbers(const std::string &name, const std::vector<Index> &lengths) const {
    require(name);
    const Shape shape = file_.shape(path_ + name);
    bool fits = shape.size() == lengths.size();
    for (std::size_t i = 0; fits && i < shape.size(); ++i)
      fits = lengths[i] < 0 || static_cast<std::size_t>(lengths[i]) == shape[i];
    if (!fits)
      fail("File", "must hold " + path_ + name + " with the dimensions " + described(lengths) +
                       ", but it has " + described({shape.begin(), shape.end()}));
    return file_.read_numbers(path_ + name);
  }

  /// The last dimension makes the columns, all others the rows.
  Matrix matrix(const std::string &name, const std::vector<Index> &lengths) const {
    const std::vector<double> values = numbers(name, lengths);
    const Index columns = static_cast<Index>(file_.shape(path_ + name).back());
    const Index rows = columns == 0 ? 0 : static_cast<Index>(values.size()) / columns;
    return Eigen::Map<const Matrix>(values.data(), columns, rows).transpose();
  }

  /// Finite ones.
  Vector vector(const std::string &name, Index length) const {
    Vector values = matrix(name, {length}).transpose();
    if (!values.allFinite())
      fail("File", "must hold finite numbers in " + path_ + name);
    return values;
  }

  std::vector<std::string> names(const std::string &name) const {
    require(name);
    return file_.read_strings(path_ + name);
  }

  std::string unit(const std::string &name) const {
    require(name);
    return file_.read_attribute(path_ + name, "unit");
  }

private:
  void require(const std::string &name) const {
    if (!has(name))
      fail("File", "must hold the dataset " + path_ + name);
  }

  static std::string described(const std::vector<Index> &lengths) {
    std::vector<std::string> parts;
    for (const Index length : lengths)
      parts.push_back(length < 0 ? "any" : std::to_string(length));
    return parts.empty() ? "of a single number" : parameters::join(parts, " x ");
  }

  const Hdf5File &file_;
  std::string path_;
};

std::string body_of(const Hdf5File &file, const ModalDefinition &definition,
                    const std::string &own_name) {
  if (!file.contains("/body") || !file.is_group("/body"))
    fail("File", "must hold a group /body with a group for each body");
  const std::vector<std::string> bodies = file.members("/body");
  const auto known = [&](const std::string &name) {
    return std::find(bodies.begin(), bodies.end(), name) != bodies.end();
  };
  if (!definition.group.empty() && !known(definition.group))
    fail("Body", "must be one of the bodies in the file: " + parameters::join(bodies, ", ") +
                     parameters::suggestion(definition.group, bodies));
  if (!definition.group.empty())
    return definition.group;
  if (known(own_name))
    return own_name;
  if (bodies.size() != 1)
    fail("Body", "must be set to one of the bodies in the file: " + parameters::join(bodies, ", "));
  return bodies.front();
}

std::vector<BodyPoint> read_points(const StoredGroup &group, Index n) {
  const std::vector<std::string> names = group.names("point");
  const auto count = static_cast<Index>(names.size());
  const Matrix rows = group.matrix("point_rows", {count, 6, n});
  Matrix positions = Matrix::Zero(count, 3);
  if (group.has("point_position"))
    positions = group.matrix("point_position", {count, 3});
  Matrix flexibility;
  if (group.has("point_flexibility"))
    flexibility = group.matrix("point_flexibility", {count, 3, 3});
  Matrix inverse_mass;
  if (group.has("point_inverse_mass"))
    inverse_mass = group.matrix("point_inverse_mass", {count, 3, 3});
  std::vector<BodyPoint> points;
  for (Index p = 0; p < count; ++p) {
    const std::string &name = names[static_cast<std::size_t>(p)];
    points.push_back({.name = name,
                      .position = positions.row(p).transpose(),
                      .rows = rows.middleRows(6 * p, 6),
                      .interface = interface_of(name)});
    // A block without any number stands for what is not known.
    if (flexibility.size() > 0 && !flexibility.middleRows(3 * p, 3).array().isNaN().all())
      points.back().flexibility = flexibility.middleRows(3 * p, 3);
    if (inverse_mass.size() > 0 && inverse_mass.middleRows(3 * p, 3).allFinite())
      points.back().inverse_mass = inverse_mass.middleRows(3 * p, 3);
  }
  return points;
}

int node_number(double value, Index nodes, const std::string &dataset, double least) {
  if (!(value >= least && value < static_cast<double>(nodes)))
    fail("File",
         "must hold numbers of nodes from 0 to " + std::to_string(nodes - 1) + " in " + dataset);
  return static_cast<int>(value);
}

Recovery read_recovery(const StoredGroup &group, Index n) {
  Recovery recovery;
  if (!group.has("nodes"))
    return recovery;
  recovery.nodes = group.matrix("nodes", {-1, 3}).transpose();
  const Index nodes = recovery.nodes.cols();
  recovery.shapes = group.matrix("shapes", {nodes, 6, n});
  const Matrix lines = group.has("lines") ? group.matrix("lines", {-1, 2}) : Matrix();
  for (const auto &row : lines.rowwise())
    recovery.lines.push_back(
        {node_number(row[0], nodes, "lines", 0), node_number(row[1], nodes, "lines", 0)});
  const Matrix surfaces = group.has("surfaces") ? group.matrix("surfaces", {-1, 4}) : Matrix();
  for (const auto &row : surfaces.rowwise()) {
    std::vector<int> corners;
    for (int i = 0; i < 4; ++i)
      if (const int node = node_number(row[i], nodes, "surfaces", i == 3 ? -1 : 0); node >= 0)
        corners.push_back(node);
    recovery.cells.push_back(structure::cell_of(
        corners.size() == 3 ? structure::CellShape::triangle : structure::CellShape::quadrilateral,
        corners));
  }
  return recovery;
}

/// The node at the place of each point, where contacts are drawn.
void find_nodes(ModalData &data) {
  for (BodyPoint &point : data.points)
    for (Index node = 0; node < data.recovery.nodes.cols() && point.node < 0; ++node)
      if (data.recovery.nodes.col(node) == point.position)
        point.node = static_cast<int>(node);
}

ModalData read_group(const StoredGroup &group, const ModalDefinition &definition) {
  const std::string unit = group.unit("frequency");
  if (unit != (definition.dimensionless ? "1" : "Hz"))
    fail("File", std::string("must hold frequencies in ") +
                     (definition.dimensionless ? "1 (angular, without unit)" : "Hz") +
                     ", but the unit of the dataset frequency is '" + unit + "'");
  ModalData data{.frequency = (definition.dimensionless ? 1 : 2 * std::numbers::pi) *
                              group.vector("frequency", -1)};
  const Index n = data.size();
  if (n == 0)
    fail("File", "must hold at least one mode");
  if (group.has("damping_ratio"))
    data.damping_ratio = group.vector("damping_ratio", n);
  if (group.has("damping"))
    data.damping = group.matrix("damping", {n, n});
  if (group.has("mass"))
    data.mass = group.vector("mass", n);
  if (group.has("stiffness") && group.has("mass"))
    data.stiffness = group.vector("stiffness", n);
  if (group.has("base_participation"))
    data.base_participation = group.matrix("base_participation", {n, 3});
  if (group.has("total_mass"))
    data.total_mass = group.matrix("total_mass", {3}).transpose();
  if (group.has("eigen_residual"))
    data.eigen_residual = group.matrix("eigen_residual", {n}).transpose();
  if (group.has("orthogonality_residual"))
    data.orthogonality_residual = group.numbers("orthogonality_residual", {}).front();
  data.points = read_points(group, n);
  data.recovery = read_recovery(group, n);
  find_nodes(data);
  return data;
}

} // namespace

ModalData read_modal_hdf5(const ModalDefinition &definition, const std::string &body_name) {
  try {
    const Hdf5File file = Hdf5File::open(definition.file);
    return read_group(StoredGroup(file, "/body/" + body_of(file, definition, body_name)),
                      definition);
  } catch (const InputError &) {
    throw;
  } catch (const std::runtime_error &error) {
    fail("File", std::string("must be an HDF5 file that can be read: ") + error.what());
  }
}

} // namespace vibroimpact::reduction
