// What an analysis hands over, and where: plain labelled arrays, one PointResult for each
// independent case. The sink makes them durable and turns them into files; analyses never write.
#pragma once

#include "common/label.h"
#include "common/linear_algebra.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vibroimpact {

/// One outer dimension of an analysis (frequency, direction, a swept key, ...).
struct Axis {
  std::string name;                ///< HDF5 dimension name, e.g. "frequency"
  std::vector<double> values;      ///< coordinates in SI; empty when labels are used
  std::vector<std::string> labels; ///< coordinates as text; empty when values are used
  std::string unit;                ///< SI unit of the values, "1" when dimensionless
  std::string description;

  std::size_t size() const { return labels.empty() ? values.size() : labels.size(); }
};

/// One labelled array of a point. Its dimensions are named: two fields of an analysis that share a
/// dimension name share its length, and a field of the same name as one of its single dimension is
/// that dimension's coordinate ("time" along "time"). The array is stored row-major, last dimension
/// fastest. Lengths may differ between points; the file pads shorter ones with NaN.
struct Field {
  Label label; ///< its name is a path below the analysis, "contact/heads/impact/peak_force"
  std::vector<std::size_t> shape{}; ///< lengths of the inner dimensions
  std::vector<double> values{};

  const std::string &name() const { return label.name(); }
  const std::string &unit() const { return label.unit(); } ///< SI, "1" when dimensionless
  const std::string &description() const { return label.description(); }
  /// Names of the inner dimensions; empty for a scalar.
  const std::vector<std::string> &dimensions() const { return label.dimensions(); }
};

/// One line of summary.txt: `name = value [unit]`. The name is relative to the analysis
/// ("contact.heads.impact[1].time"); the sink puts "analysis.NAME." (and the outer indices) before
/// it, unless the name is absolute (begins with '/').
struct SummaryLine {
  Label label; ///< name and unit count
  double value = 0;

  const std::string &name() const { return label.name(); }
  const std::string &unit() const { return label.unit(); }
};

/// A node that takes the force of a contact.
struct TouchedNode {
  std::size_t body = 0;           ///< position among the bodies
  int node = -1;                  ///< of its mesh
  Vector3 push = Vector3::Zero(); ///< direction in which a positive force pushes it
};

/// A contact at the instants of a motion.
struct ContactTrace {
  std::vector<TouchedNode> nodes; ///< none for points of bodies without a mesh
  std::vector<double> gap;        ///< [m]
  std::vector<double> force;      ///< [N]
  std::vector<double> peak_force; ///< largest up to then [N]
};

/// The motion of all bodies at some instants, for the expansion to the mesh.
struct Motion {
  std::vector<double> time;              ///< [s]
  std::vector<Matrix> coordinates;       ///< per body: time x coordinate
  std::vector<Matrix> base_displacement; ///< per body: time x 3 [m]
  std::vector<Matrix> velocities{};      ///< per body: time x coordinate, rates of the coordinates
  std::vector<Matrix> base_velocity{};   ///< per body: time x 3 [m/s]
  std::vector<ContactTrace> contacts{};
};

enum class Status : std::int8_t { missing = -1, finished = 0, failed = 1 };

/// Everything one case of an analysis produced.
struct PointResult {
  std::vector<std::size_t> index; ///< position along the outer axes; empty without axes
  Status status = Status::finished;
  std::string reason{}; ///< why it failed; empty otherwise
  std::vector<Field> fields{};
  std::vector<SummaryLine> summary{};
  std::vector<Motion> motion{}; ///< none or one
};

/// What a sink must know before the first point of an analysis.
struct AnalysisHeader {
  std::string name; ///< as in the parameter file
  std::string type; ///< e.g. "stepped sweep"
  std::vector<Axis> axes;
  /// The keys of a parameter grid around the analysis; their axes come first, in this order.
  std::vector<std::string> grid = {};
};

/// Takes points in any order, from any rank. A stored point outlives the program.
class ResultSink {
public:
  virtual ~ResultSink() = default;

  /// Collective. Opens an analysis; afterwards find() knows the points of an earlier, resumed run.
  virtual void begin(const AnalysisHeader &header) = 0;

  /// The point of an earlier run, or nullptr if there is none; valid until the next call. Local.
  virtual const PointResult *find(const std::vector<std::size_t> &index) const = 0;

  /// Local: called by the rank that computed the point.
  virtual void store(const PointResult &result) = 0;

  /// What the first steps towards a point (step_record.h) gave in an earlier run that did not get
  /// to it. Local.
  virtual std::vector<std::string> find_steps(const std::vector<std::size_t> & /*index*/) const {
    return {};
  }

  /// What further steps gave, the first of them being number `first` from 0. Local. They outlive
  /// the program, all or none.
  virtual void store_steps(const std::vector<std::size_t> & /*index*/, std::size_t /*first*/,
                           const std::vector<std::string> & /*steps*/) {}

  /// Collective. The result file holds all points of the analysis when it returns.
  virtual void end() = 0;
};

} // namespace vibroimpact
