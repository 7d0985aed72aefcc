#include "analyses/kept_rows.h"

#include "common/recorded_step.h"

#include <boost/serialization/vector.hpp>

namespace vibroimpact::analyses {

namespace {

struct KeptLabel {
  std::string name, unit, description;
  std::vector<std::string> dimensions;

  template <class Archive> void serialize(Archive &archive, unsigned) {
    archive &name &unit &description &dimensions;
  }
};

struct KeptRow {
  bool same_labels = false;
  std::vector<KeptLabel> labels; ///< none where they are the same
  std::vector<std::vector<std::size_t>> shapes;
  std::vector<std::vector<double>> values;
  std::string reason;

  template <class Archive> void serialize(Archive &archive, unsigned) {
    archive &same_labels &labels &shapes &values &reason;
  }
};

KeptRow kept(PointResult row, const std::vector<Label> &before) {
  const auto same = [](const Field &field, const Label &label) { return field.label == label; };
  KeptRow result;
  result.reason = std::move(row.reason);
  result.same_labels =
      std::equal(row.fields.begin(), row.fields.end(), before.begin(), before.end(), same);
  for (Field &field : row.fields) {
    if (!result.same_labels)
      result.labels.push_back(
          {field.name(), field.unit(), field.description(), field.dimensions()});
    result.shapes.push_back(std::move(field.shape));
    result.values.push_back(std::move(field.values));
  }
  return result;
}

} // namespace

PointResult KeptRows::operator()(const std::function<PointResult()> &compute) {
  if (steps_ == nullptr)
    return compute();
  KeptRow row = recorded(steps_, "row", [&] { return kept(compute(), labels_); });
  if (!row.same_labels) {
    labels_.clear();
    for (const KeptLabel &label : row.labels)
      labels_.emplace_back(label.name, label.unit, label.description, label.dimensions);
  }
  PointResult result;
  result.reason = std::move(row.reason);
  for (std::size_t i = 0; i < labels_.size(); ++i)
    result.fields.push_back({.label = labels_[i],
                             .shape = std::move(row.shapes[i]),
                             .values = std::move(row.values[i])});
  return result;
}

} // namespace vibroimpact::analyses
