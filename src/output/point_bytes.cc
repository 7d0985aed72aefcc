#include "output/point_bytes.h"

#include "common/stored_results.h"

#include <algorithm>

namespace vibroimpact::output {

namespace {

void take_index(Cursor &cursor, std::vector<std::size_t> &index) {
  index.resize(cursor.take<std::uint8_t>());
  for (std::size_t &position : index)
    position = cursor.take<std::uint32_t>();
}

void take_field(Cursor &cursor, Field &field) {
  std::size_t size = 1;
  for (std::size_t &length : field.shape) {
    length = cursor.take<std::uint64_t>();
    size *= length;
  }
  cursor.numbers(field.values, size);
}

bool same_labels(const auto &labelled, const std::vector<Label> &labels) {
  return std::equal(labelled.begin(), labelled.end(), labels.begin(), labels.end(),
                    [](const auto &one, const Label &label) { return one.label == label; });
}

} // namespace

PointLayout layout_of(const PointResult &result) {
  PointLayout layout;
  for (const Field &field : result.fields)
    layout.fields.push_back(field.label);
  for (const SummaryLine &line : result.summary)
    layout.summary.push_back(line.label);
  return layout;
}

bool has_layout(const PointResult &result, const PointLayout &layout) {
  return same_labels(result.fields, layout.fields) && same_labels(result.summary, layout.summary);
}

void append_point(const PointResult &result, std::string &bytes) {
  Bytes put(bytes);
  put(static_cast<std::uint8_t>(result.index.size()));
  for (const std::size_t position : result.index)
    put(static_cast<std::uint32_t>(position));
  put(result.status, static_cast<std::uint32_t>(result.reason.size()));
  bytes += result.reason;
  for (const Field &field : result.fields) {
    put.numbers(field.shape.data(), field.shape.size());
    put.numbers(field.values.data(), field.values.size());
  }
  for (const SummaryLine &line : result.summary)
    put(line.value);
  if (!result.motion.empty())
    put(result.motion);
}

std::vector<std::size_t> index_of_point(std::string_view bytes) {
  Cursor cursor(bytes);
  std::vector<std::size_t> index;
  take_index(cursor, index);
  return index;
}

int compare_index(std::string_view one, std::string_view other) {
  const auto positions = [](std::string_view bytes) {
    Cursor cursor(bytes);
    const std::size_t axes = cursor.take<std::uint8_t>();
    return cursor.take(axes * sizeof(std::uint32_t));
  };
  const std::string_view first = positions(one);
  const std::string_view second = positions(other);
  if (first.size() != second.size())
    return first.size() < second.size() ? -1 : 1;
  for (std::size_t at = 0; at < first.size(); at += sizeof(std::uint32_t)) {
    std::uint32_t here = 0;
    std::uint32_t there = 0;
    std::memcpy(&here, first.data() + at, sizeof here);
    std::memcpy(&there, second.data() + at, sizeof there);
    if (here != there)
      return here < there ? -1 : 1;
  }
  return 0;
}

const PointResult &PointReader::read(std::string_view bytes, const PointLayout &layout) {
  if (layout_ != &layout) {
    point_ = {};
    for (const Label &label : layout.fields)
      point_.fields.push_back(
          {.label = label, .shape = std::vector<std::size_t>(label.dimensions().size())});
    for (const Label &label : layout.summary)
      point_.summary.push_back({.label = label});
    layout_ = &layout;
  }
  Cursor cursor(bytes);
  take_index(cursor, point_.index);
  cursor(point_.status);
  point_.reason = cursor.take(cursor.take<std::uint32_t>());
  for (Field &field : point_.fields)
    take_field(cursor, field);
  for (SummaryLine &line : point_.summary)
    cursor(line.value);
  point_.motion.clear();
  if (!cursor.rest().empty())
    unpack(cursor.rest(), point_.motion);
  return point_;
}

} // namespace vibroimpact::output
