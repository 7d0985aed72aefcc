// Rows of values along curves whose number of points is known only in the end, until all are there
// and become arrays: those of points along `CURVE_point`, of special points along `special_point`,
// of ends along `CURVE_end`.
#pragma once

#include "analyses/results/field_writer.h"
#include "analyses/results/stacked_points.h"

#include <array>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

class CurveTable {
public:
  enum class Part { point, special, end };

  /// `curve`: "branch"; `numbering`: what its number means; `keys`: those that the curves run over.
  CurveTable(const std::string &curve, const std::string &numbering, std::vector<Label> keys);

  /// What follows is a part of curve `number`; `sign`: -1 where the arclength falls.
  void begin(long number, double sign);
  /// With the fields of the curve, arclength (ends have none) and keys before those given.
  void add(Part part, const Vector &keys, double arclength, PointResult values);
  /// Forgets all of a curve.
  void drop(long number);

  /// "KEY = value unit", for remarks.
  std::string at(const Vector &keys) const;
  /// Why something is missing or ends early.
  void remark(const std::string &why) { remarks_.push_back(why); }
  /// The first five.
  std::string remarks() const;

  /// Arrays of everything; in the summary the number of points and these fields of each special
  /// point.
  void add_fields(const FieldWriter &result, const std::vector<std::string> &summarised) const;

  const std::vector<Label> &keys() const { return keys_; }

private:
  struct Row {
    long curve = 0;
    double arclength = 0;
    PointResult values{};
  };
  std::vector<PointResult> in_order(Part part) const;

  std::string name_;
  Label curve_, arclength_;
  std::vector<Label> keys_;
  long number_ = 0;
  double sign_ = 1;
  std::array<std::vector<Row>, 3> rows_; ///< by part
  std::vector<std::string> remarks_;
};

} // namespace vibroimpact::analyses
