// The bytes a stored point takes: its numbers alone. Names, units and descriptions are the same
// for most points of an analysis and stand once in the layout they share.
#pragma once

#include "common/result_sink.h"

#include <string>
#include <string_view>
#include <vector>

namespace vibroimpact::output {

/// What a point holds besides its numbers.
struct PointLayout {
  std::vector<Label> fields, summary;
};

PointLayout layout_of(const PointResult &result);
bool has_layout(const PointResult &result, const PointLayout &layout);

/// Appends index, status, reason, the lengths of the inner dimensions, all values, and the motion.
/// Numbers in the byte order of the machine.
void append_point(const PointResult &result, std::string &bytes);

/// Position along the outer axes of a point given by its bytes.
std::vector<std::size_t> index_of_point(std::string_view bytes);
/// The order of two such positions: negative, zero or positive.
int compare_index(std::string_view one, std::string_view other);

/// Turns bytes back into points. One point is filled again and again, so that going through many
/// points of the same layout takes no memory anew.
class PointReader {
public:
  /// The result is valid until the next call. BytesError when the bytes do not fit the layout.
  const PointResult &read(std::string_view bytes, const PointLayout &layout);

private:
  PointResult point_;
  const PointLayout *layout_ = nullptr;
};

} // namespace vibroimpact::output
