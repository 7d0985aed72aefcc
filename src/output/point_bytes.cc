#include "output/point_bytes.h"

#include "output/archived_types.h"

#include <algorithm>
#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace vibroimpact::output {

namespace {

template <class Number> void append(Number number, std::string &bytes) {
  bytes.append(reinterpret_cast<const char *>(&number), sizeof number);
}

/// Takes values off the front of some bytes.
class Cursor {
public:
  explicit Cursor(std::string_view bytes) : left_(bytes) {}

  template <class Number> Number take() {
    Number number;
    copy(&number, sizeof number);
    return number;
  }

  std::string_view take(std::size_t size) {
    if (size > left_.size())
      throw std::runtime_error("a stored point does not fit its layout");
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }

  void take_numbers(std::size_t size, std::vector<double> &numbers) {
    const std::string_view taken = take(size * sizeof(double));
    numbers.resize(size);
    if (size > 0)
      std::memcpy(numbers.data(), taken.data(), taken.size());
  }

  std::string_view rest() const { return left_; }

private:
  void copy(void *target, std::size_t size) { std::memcpy(target, take(size).data(), size); }

  std::string_view left_;
};

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
  cursor.take_numbers(size, field.values);
}

void append_motion(const std::vector<Motion> &motion, std::string &bytes) {
  if (motion.empty())
    return;
  std::ostringstream stream(std::ios::binary);
  boost::archive::binary_oarchive archive(stream);
  archive << motion;
  bytes += stream.str();
}

std::vector<Motion> read_motion(std::string_view bytes) {
  std::vector<Motion> motion;
  if (bytes.empty())
    return motion;
  std::istringstream stream(std::string(bytes), std::ios::binary);
  boost::archive::binary_iarchive archive(stream);
  archive >> motion;
  return motion;
}

template <class Labelled> bool same_label(const Labelled &one, const Labelled &other) {
  return one.label == other.label;
}

} // namespace

PointLayout layout_of(const PointResult &result) {
  PointLayout layout;
  for (const Field &field : result.fields)
    layout.fields.push_back({.label = field.label});
  for (const SummaryLine &line : result.summary)
    layout.summary.push_back({.label = line.label});
  return layout;
}

bool has_layout(const PointResult &result, const PointLayout &layout) {
  const auto &fields = layout.fields;
  const auto &summary = layout.summary;
  return std::equal(result.fields.begin(), result.fields.end(), fields.begin(), fields.end(),
                    same_label<Field>) &&
         std::equal(result.summary.begin(), result.summary.end(), summary.begin(), summary.end(),
                    same_label<SummaryLine>);
}

void append_point(const PointResult &result, std::string &bytes) {
  append(static_cast<std::uint8_t>(result.index.size()), bytes);
  for (const std::size_t position : result.index)
    append(static_cast<std::uint32_t>(position), bytes);
  append(result.status, bytes);
  append(static_cast<std::uint32_t>(result.reason.size()), bytes);
  bytes += result.reason;
  for (const Field &field : result.fields) {
    for (const std::size_t length : field.shape)
      append(static_cast<std::uint64_t>(length), bytes);
    bytes.append(reinterpret_cast<const char *>(field.values.data()),
                 field.values.size() * sizeof(double));
  }
  for (const SummaryLine &line : result.summary)
    append(line.value, bytes);
  append_motion(result.motion, bytes);
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
    point_.fields = layout.fields;
    point_.summary = layout.summary;
    for (Field &field : point_.fields)
      field.shape.resize(field.dimensions().size());
    layout_ = &layout;
  }
  Cursor cursor(bytes);
  take_index(cursor, point_.index);
  point_.status = cursor.take<Status>();
  point_.reason = cursor.take(cursor.take<std::uint32_t>());
  for (Field &field : point_.fields)
    take_field(cursor, field);
  for (SummaryLine &line : point_.summary)
    line.value = cursor.take<double>();
  point_.motion = read_motion(cursor.rest());
  return point_;
}

} // namespace vibroimpact::output
