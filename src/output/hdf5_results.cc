#include "output/hdf5_results.h"

#include "derived/dimensionless.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace vibroimpact::output {

using derived::AnalysisArrays;
using derived::AssembledField;
using derived::InnerDimension;
using reduction::Recovery;
using reduction::ReducedBody;

namespace {

/// A slash would open a group.
std::string link_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

void describe(Hdf5File &file, const std::string &path, const std::string &unit,
              const std::string &description) {
  file.set_attribute(path, "unit", unit);
  file.set_attribute(path, "description", description);
}

void write_index_scale(Hdf5File &file, const std::string &path, std::size_t length) {
  std::vector<std::int64_t> index(length);
  std::iota(index.begin(), index.end(), 1);
  file.write(path, {length}, index);
  describe(file, path, "1", "index from 1");
  file.make_scale(path);
}

void write_label_scale(Hdf5File &file, const std::string &path,
                       const std::vector<std::string> &labels, const std::string &description) {
  file.write(path, {labels.size()}, labels);
  describe(file, path, "1", description);
  file.make_scale(path);
}

void attach_scales(Hdf5File &file, const std::string &path,
                   const std::vector<std::string> &scales) {
  for (std::size_t dimension = 0; dimension < scales.size(); ++dimension)
    file.attach_scale(path, dimension, scales[dimension]);
}

void write_axis(Hdf5File &file, const std::string &path, const Axis &axis) {
  if (axis.labels.empty())
    file.write(path, {axis.size()}, axis.values);
  else
    file.write(path, {axis.size()}, axis.labels);
  describe(file, path, axis.labels.empty() ? axis.unit : "1", axis.description);
  file.make_scale(path);
}

/// Paths of the scales of the inner dimensions; those without a coordinate are written here.
std::map<std::string, std::string> inner_scales(Hdf5File &file, const std::string &group,
                                                const AnalysisArrays &arrays) {
  std::map<std::string, std::string> scales;
  for (const InnerDimension &dimension : arrays.dimensions) {
    const bool counted = dimension.coordinate.empty();
    // The index must not take the name of a field that is no coordinate.
    const auto taken = [&](const AssembledField &field) { return field.name() == dimension.name; };
    std::string name = counted ? link_name(dimension.name) : dimension.coordinate;
    if (counted && std::any_of(arrays.fields.begin(), arrays.fields.end(), taken))
      name += "_index";
    name.insert(0, group + "/");
    scales[dimension.name] = name;
    if (counted)
      write_index_scale(file, name, dimension.length);
  }
  return scales;
}

void write_field(Hdf5File &file, const std::string &path, const AssembledField &field,
                 const std::vector<std::string> &outer_scales,
                 const std::map<std::string, std::string> &inner_scales) {
  file.write(path, field.shape, field.values);
  describe(file, path, field.label.unit(), field.label.description());
  if (!field.over_axes) {
    file.make_scale(path);
    return;
  }
  std::vector<std::string> scales = outer_scales;
  for (const std::string &dimension : field.inner_dimensions())
    scales.push_back(inner_scales.at(dimension));
  attach_scales(file, path, scales);
}

using Scales = std::map<std::string, std::string>;

/// Dimensions of its own have the name of the quantity behind theirs, for they differ in length.
void write_own_dimensions(Hdf5File &file, const std::string &group,
                          const derived::DerivedArray &quantity, Scales &scales) {
  for (const Axis &axis : quantity.own_dimensions) {
    const std::string path = group + "/" + axis.name;
    if (!file.contains(path))
      write_axis(file, path, axis);
    scales[axis.name] = path;
  }
}

void write_derived(Hdf5File &file, const std::string &group, const derived::DerivedArray &quantity,
                   Scales scales) {
  write_own_dimensions(file, group, quantity, scales);
  const std::string path = group + "/" + quantity.name;
  file.write(path, quantity.shape, quantity.values);
  describe(file, path, quantity.unit, quantity.description);
  file.set_attribute(path, "operation", quantity.operation);
  if (!quantity.axis.empty())
    file.set_attribute(path, "axis", link_name(quantity.axis));
  if (!quantity.axes.empty())
    file.set_attribute(path, "axes",
                       link_name(quantity.axes[0]) + " " + link_name(quantity.axes[1]));
  for (std::size_t d = 0; d < quantity.dimensions.size(); ++d)
    file.attach_scale(path, d, scales.at(quantity.dimensions[d]));
}

void write_status(Hdf5File &file, const std::string &group, const Shape &shape,
                  const AnalysisArrays &arrays, const std::vector<std::string> &scales) {
  file.write(group + "/status", shape, arrays.status);
  describe(file, group + "/status", "1", "-1 missing, 0 finished, 1 failed");
  attach_scales(file, group + "/status", scales);
  file.write(group + "/reason", shape, arrays.reason);
  describe(file, group + "/reason", "1",
           "why a point failed, or what a finished one says in words");
  attach_scales(file, group + "/reason", scales);
}

/// Eigen keeps columns together, the file rows.
std::vector<double> row_major(const Matrix &matrix) {
  const Matrix transposed = matrix.transpose();
  return {transposed.data(), transposed.data() + transposed.size()};
}

/// One group of a body with its scales.
class BodyGroup {
public:
  BodyGroup(Hdf5File &file, const ReducedBody &body, bool dimensionless)
      : file_(file), dimensionless_(dimensionless), path_("/body/" + body.name) {
    file_.create_group(path_);
    file_.set_attribute(path_, "name", body.name);
    file_.set_attribute(path_, "type", body.type);
    lengths_["mode"] = static_cast<std::size_t>(body.size());
    write_index_scale(file_, path_ + "/mode", lengths_["mode"]);
    index("other_mode", lengths_["mode"]);
    labels("axis", {"x", "y", "z"}, "direction in space");
    labels("component", {"x", "y", "z", "rotation_x", "rotation_y", "rotation_z"},
           "displacement or rotation of a node or point");
  }

  void labels(const std::string &name, const std::vector<std::string> &values,
              const std::string &description) {
    lengths_[name] = values.size();
    write_label_scale(file_, path_ + "/" + name, values, description);
  }

  void index(const std::string &name, std::size_t length) {
    lengths_[name] = length;
    write_index_scale(file_, path_ + "/" + name, length);
  }

  template <class Value>
  void array(const std::string &name, const std::vector<std::string> &dimensions,
             const std::vector<Value> &values, const std::string &unit,
             const std::string &description) {
    Shape shape;
    std::vector<std::string> scales;
    for (const std::string &dimension : dimensions) {
      shape.push_back(lengths_.at(dimension));
      scales.push_back(path_ + "/" + dimension);
    }
    const std::string path = path_ + "/" + name;
    file_.write(path, shape, values);
    if (dimensionless_)
      describe(file_, path, "1", derived::plain_description(description));
    else
      describe(file_, path, unit, description);
    attach_scales(file_, path, scales);
  }

  bool dimensionless() const { return dimensionless_; }

private:
  Hdf5File &file_;
  bool dimensionless_;
  std::string path_;
  std::map<std::string, std::size_t> lengths_;
};

void write_modal_data(BodyGroup &group, const ReducedBody &body) {
  const std::vector<std::string> mode = {"mode"};
  const std::vector<std::string> mode_axis = {"mode", "axis"};
  const double unit = group.dimensionless() ? 1 : derived::plain_factor("Hz");
  group.array("frequency", mode, row_major(body.omega() / unit), "Hz",
              "undamped natural frequency of each coordinate by itself");
  group.array("damping_ratio", mode, row_major(body.damping_ratio()), "1",
              "fraction of critical damping");
  group.array("mass", mode, row_major(body.mass), "kg", "generalised mass");
  group.array("stiffness", mode, row_major(body.stiffness), "N/m", "generalised stiffness");
  group.array("effective_mass", mode_axis, row_major(body.effective_mass()), "kg",
              "effective modal mass for a base motion along an axis");
  group.array("base_participation", mode_axis, row_major(body.base_participation), "kg",
              "generalised inertia force of a unit base acceleration, sign reversed");
  group.array("total_mass", {"axis"}, row_major(body.total_mass), "kg",
              "mass that a base motion along an axis moves");
  group.array("damping", {"mode", "other_mode"}, row_major(body.damping), "N s/m",
              "generalised damping matrix");
  if (body.eigen_residual.size() == 0)
    return;
  group.array("eigen_residual", mode, row_major(body.eigen_residual), "1",
              "bound of the relative error of the squared frequency, from the residual in the norm "
              "of K^-1");
  group.array("orthogonality_residual", {}, std::vector<double>{body.orthogonality_residual}, "1",
              "largest entry of |Phi^T M Phi - I|");
}

void write_points(BodyGroup &group, const ReducedBody &body) {
  std::vector<std::string> names;
  std::vector<double> positions;
  std::vector<double> rows;
  for (const reduction::BodyPoint &point : body.points) {
    names.push_back(point.name);
    positions.insert(positions.end(), point.position.begin(), point.position.end());
    const std::vector<double> values = row_major(point.rows);
    rows.insert(rows.end(), values.begin(), values.end());
  }
  group.labels("point", names, "named place of the body");
  group.array("point_position", {"point", "axis"}, positions, "m", "undeformed position");
  group.array("point_rows", {"point", "component", "mode"}, rows, "1",
              "displacement [m] or rotation [rad] of a point per unit coordinate");
}

/// NaN for points of which it is not known; nothing where it is known of none.
void write_point_matrices(BodyGroup &group, const ReducedBody &body, const std::string &name,
                          Matrix reduction::BodyPoint::*matrix, const std::string &unit,
                          const std::string &description) {
  std::vector<double> values;
  bool known = false;
  for (const reduction::BodyPoint &point : body.points) {
    const Matrix &own = point.*matrix;
    known = known || own.size() > 0;
    const Matrix nothing = Matrix::Constant(3, 3, std::numeric_limits<double>::quiet_NaN());
    const std::vector<double> entries = row_major(own.size() > 0 ? own : nothing);
    values.insert(values.end(), entries.begin(), entries.end());
  }
  if (known)
    group.array(name, {"point", "axis", "other_axis"}, values, unit, description);
}

/// Of the body before reduction.
void write_point_responses(BodyGroup &group, const ReducedBody &body) {
  group.labels("other_axis", {"x", "y", "z"}, "direction in space of the cause");
  write_point_matrices(group, body, "point_flexibility", &reduction::BodyPoint::flexibility, "m/N",
                       "static displacement along an axis per unit force along another, of the "
                       "body before reduction; NaN where it is not known");
  write_point_matrices(group, body, "point_inverse_mass", &reduction::BodyPoint::inverse_mass,
                       "1/kg",
                       "velocity along an axis right after a unit impulse along another, of the "
                       "body before reduction; NaN where it is not known");
}

void write_lines(BodyGroup &group, const Recovery &recovery) {
  group.index("line", recovery.lines.size());
  group.labels("end", {"first", "second"}, "end of a line");
  std::vector<std::int64_t> ends;
  for (const auto &line : recovery.lines)
    ends.insert(ends.end(), {line[0], line[1]});
  group.array("lines", {"line", "end"}, ends, "1",
              "ends of a beam element, as positions in nodes from 0");
}

void write_surfaces(BodyGroup &group, const Recovery &recovery) {
  const std::vector<std::vector<int>> faces = structure::visible_faces(recovery.cells);
  group.index("surface", faces.size());
  group.index("corner", 4);
  std::vector<std::int64_t> corners;
  for (const std::vector<int> &face : faces)
    for (std::size_t i = 0; i < 4; ++i)
      corners.push_back(i < face.size() ? face[i] : -1);
  const bool solid = structure::cell_type(recovery.cells[0].shape).dimension == 3;
  group.array("surfaces", {"surface", "corner"}, corners, "1",
              std::string("corners around ") +
                  (solid ? "an outer face of solid elements" : "a shell element") +
                  ", as positions in nodes from 0; the last one of a triangle is -1");
}

void write_recovery(BodyGroup &group, const Recovery &recovery) {
  if (recovery.nodes.size() == 0)
    return;
  group.index("node", static_cast<std::size_t>(recovery.nodes.cols()));
  group.array("nodes", {"node", "axis"}, row_major(recovery.nodes.transpose()), "m",
              "undeformed position");
  if (!recovery.lines.empty())
    write_lines(group, recovery);
  if (!recovery.cells.empty())
    write_surfaces(group, recovery);
  group.array("shapes", {"node", "component", "mode"}, row_major(recovery.shapes), "1",
              "displacement [m] or rotation [rad] of a node per unit coordinate");
  if (recovery.static_displacement.size() > 0)
    group.array("static_displacement", {"node", "component"},
                std::vector<double>(recovery.static_displacement.begin(),
                                    recovery.static_displacement.end()),
                "1", "displacement [m] or rotation [rad] of a node under the loads of the body");
}

} // namespace

void write_information(Hdf5File &file, const RunInformation &information) {
  file.set_attribute("/", "version", information.version);
  file.set_attribute("/", "commit", information.commit);
  file.set_attribute("/", "parameters", information.parameters);
  file.set_attribute("/", "command_line", information.command_line);
  file.set_attribute("/", "libraries", information.libraries);
  file.set_attribute("/", "ranks", std::int64_t{information.ranks});
  file.set_attribute("/", "processor", information.processor);
}

void write_body(Hdf5File &file, const ReducedBody &body, bool dimensionless) {
  BodyGroup group(file, body, dimensionless);
  write_modal_data(group, body);
  write_points(group, body);
  write_point_responses(group, body);
  write_recovery(group, body.recovery);
}

void write_yield_stresses(Hdf5File &file, const YieldStresses &yield_stresses, bool dimensionless) {
  for (const auto &[body, stress] : yield_stresses) {
    const std::string path = "/body/" + body + "/yield_stress";
    file.write(path, {}, std::vector<double>{stress});
    describe(file, path, dimensionless ? "1" : "Pa", "Yield stress of the Material");
  }
}

void write_contacts(Hdf5File &file, const std::vector<contact::ContactFigures> &contacts,
                    bool dimensionless) {
  if (contacts.empty())
    return;
  std::vector<std::string> names;
  std::vector<double> clearances;
  std::vector<double> shares;
  std::vector<double> errors;
  std::vector<double> periods;
  for (const contact::ContactFigures &contact : contacts) {
    names.push_back(contact.name);
    clearances.push_back(contact.clearance);
    shares.push_back(contact.flexibility_share);
    errors.push_back(contact.impact_error);
    periods.push_back(contact.shortest_period);
  }
  file.create_group("/contact");
  write_label_scale(file, "/contact/contact", names, "contact of the model");
  const auto write = [&](const std::string &path, const std::vector<double> &values,
                         const std::string &unit, const std::string &description) {
    file.write(path, {values.size()}, values);
    describe(file, path, dimensionless ? "1" : unit, description);
    attach_scales(file, path, {"/contact/contact"});
  };
  write("/contact/clearance", clearances, "m", "gap of the undeformed model");
  write(
      "/contact/flexibility_share", shares, "1",
      "share of the static flexibility along the normal that the kept coordinates carry; NaN where "
      "it is not known");
  write("/contact/impact_error", errors, "1",
        "relative error of the peak force of a short impact, or of the impulse of rigid sides, by "
        "the modes left out; NaN where it is not known");
  write("/contact/shortest_period", periods, "s",
        "shortest period of the kept coordinates of the contact's sides, of the side where it is "
        "longer; 0 where no mesh takes part, NaN where it has no mass at the contact");
}

void write_analysis(Hdf5File &file, const AnalysisHeader &header, const AnalysisArrays &arrays,
                    const std::vector<derived::DerivedArray> &quantities) {
  const std::string group = "/analysis/" + header.name;
  file.create_group(group);
  file.set_attribute(group, "name", header.name);
  file.set_attribute(group, "type", header.type);
  if (!header.grid.empty())
    file.set_attribute(group, "grid", header.grid);
  std::vector<std::string> outer_scales;
  for (const Axis &axis : header.axes) {
    outer_scales.push_back(group + "/" + link_name(axis.name));
    write_axis(file, outer_scales.back(), axis);
  }
  write_status(file, group, derived::outer_shape(header), arrays, outer_scales);
  const std::map<std::string, std::string> scales = inner_scales(file, group, arrays);
  // Coordinates first: a scale must exist before it can be attached.
  for (const bool over_axes : {false, true})
    for (const AssembledField &field : arrays.fields)
      if (field.over_axes == over_axes)
        write_field(file, group + "/" + field.name(), field, outer_scales, scales);
  Scales all_scales = scales;
  for (std::size_t a = 0; a < header.axes.size(); ++a)
    all_scales[header.axes[a].name] = outer_scales[a];
  for (const derived::DerivedArray &quantity : quantities)
    write_derived(file, group + "/derived", quantity, all_scales);
}

} // namespace vibroimpact::output
