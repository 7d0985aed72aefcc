#include "output/record.h"

#include "common/stored_results.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace vibroimpact::output {

void members(auto &visit, As<PointLayout> auto &layout) { visit(layout.fields, layout.summary); }
void members(auto &visit, As<StepBundle> auto &bundle) {
  visit(bundle.index, bundle.first, bundle.steps);
}

namespace {

constexpr char header_kind = 'h';
constexpr char layout_kind = 'l';
constexpr char point_kind = 'p';
constexpr char steps_kind = 's';

// The number stands behind the kind of every record but those of points, which have a layout.
constexpr std::uint32_t format = 1;

template <class... Contents> void extract(std::string_view bytes, Contents &...contents) {
  Cursor cursor(bytes);
  if (const auto found = cursor.take<std::uint32_t>(); found != format)
    throw BytesError("a record of format " + std::to_string(found) + " instead of " +
                     std::to_string(format));
  unpack(cursor.rest(), contents...);
}

} // namespace

void RecordWriter::append(const AnalysisHeader &header) {
  journal_.append(packed(header_kind, format, header));
  journal_.synchronise(); // points in other journals are of no use without it
}

void RecordWriter::append(const std::string &analysis, const PointResult &result) {
  const std::uint32_t layout = number_of_layout(analysis, result);
  record_.clear();
  Bytes{record_}(point_kind, layout);
  append_point(result, record_);
  journal_.append(record_);
}

void RecordWriter::append(const std::string &analysis, const StepBundle &bundle) {
  journal_.append(packed(steps_kind, format, analysis, bundle));
}

bool RecordWriter::fits(const std::string &analysis, const PointResult &result,
                        std::size_t number) const {
  return layouts_[number].analysis == analysis && has_layout(result, layouts_[number].layout);
}

std::uint32_t RecordWriter::number_of_layout(const std::string &analysis,
                                             const PointResult &result) {
  if (latest_ < layouts_.size() && fits(analysis, result, latest_))
    return static_cast<std::uint32_t>(latest_);
  std::size_t number = 0;
  while (number < layouts_.size() && !fits(analysis, result, number))
    ++number;
  if (number == layouts_.size()) {
    KnownLayout known{.analysis = analysis, .layout = layout_of(result)};
    journal_.append(packed(layout_kind, format, static_cast<std::uint32_t>(number), known.analysis,
                           known.layout));
    layouts_.push_back(std::move(known));
  }
  latest_ = number;
  return static_cast<std::uint32_t>(number);
}

void StoredPoints::visit(const std::function<void(const PointResult &)> &visit) const {
  PointReader reader;
  for (const Entry &entry : entries_)
    visit(reader.read(entry.bytes, *entry.layout));
}

const PointResult *StoredPoints::find(const std::vector<std::size_t> &index) const {
  const auto found = std::lower_bound(
      entries_.begin(), entries_.end(), index,
      [](const Entry &entry, const auto &wanted) { return index_of_point(entry.bytes) < wanted; });
  return found == entries_.end() || index_of_point(found->bytes) != index
             ? nullptr
             : &found_.read(found->bytes, *found->layout);
}

void StoredPoints::sort() {
  std::stable_sort(entries_.begin(), entries_.end(), [](const Entry &one, const Entry &other) {
    return compare_index(one.bytes, other.bytes) < 0;
  });
  const auto same = [](const Entry &one, const Entry &other) {
    return compare_index(one.bytes, other.bytes) == 0;
  };
  entries_.erase(std::unique(entries_.begin(), entries_.end(), same), entries_.end());
}

/// Goes through journals and shares out their points to the analyses.
class RunReader {
public:
  void read(const std::filesystem::path &journal) try {
    records_ = std::make_shared<const JournalRecords>(journal);
    layouts_.clear();
    records_->visit([this](std::string_view record) { take(record); });
  } catch (const BytesError &error) {
    fail(journal, error.what());
  } catch (const std::out_of_range &) {
    fail(journal, "a record of unknown kind");
  }

  std::vector<AnalysisHeader> headers;

  /// Whose steps are read; those of the others are passed over.
  std::string stepping;

  /// Without those that follow a gap.
  StoredSteps steps() {
    std::stable_sort(bundles_.begin(), bundles_.end(),
                     [](const auto &one, const auto &other) { return one.first < other.first; });
    StoredSteps steps;
    for (StepBundle &bundle : bundles_) {
      std::vector<std::string> &known = steps[bundle.index];
      for (std::uint64_t i = 0; i < bundle.steps.size(); ++i)
        if (bundle.first + i == known.size())
          known.push_back(std::move(bundle.steps[i]));
    }
    return steps;
  }

  StoredPoints points_of(const std::string &analysis) {
    StoredPoints points = std::move(points_[analysis]);
    points.sort();
    return points;
  }

private:
  struct Layout {
    StoredPoints *points;
    std::shared_ptr<const PointLayout> layout;
  };

  [[noreturn]] static void fail(const std::filesystem::path &journal, const std::string &reason) {
    throw std::runtime_error(journal.string() + ": cannot read the journal, another version of " +
                             "the program may have written it (" + reason + ")");
  }

  void take(std::string_view record) {
    const char kind = record.at(0);
    record.remove_prefix(1);
    if (kind == header_kind)
      extract(record, headers.emplace_back());
    else if (kind == layout_kind)
      take_layout(record);
    else if (kind == point_kind)
      take_point(record);
    else if (kind == steps_kind)
      take_steps(record);
    else
      throw std::out_of_range("kind");
  }

  void take_layout(std::string_view record) {
    std::uint32_t number = 0;
    std::string analysis;
    auto layout = std::make_shared<PointLayout>();
    extract(record, number, analysis, *layout);
    StoredPoints &points = points_[analysis];
    points.layouts_.push_back(layout);
    if (points.journals_.empty() || points.journals_.back() != records_)
      points.journals_.push_back(records_);
    layouts_.insert_or_assign(number, Layout{.points = &points, .layout = std::move(layout)});
  }

  void take_point(std::string_view record) {
    Cursor cursor(record);
    const Layout &layout = layouts_.at(cursor.take<std::uint32_t>());
    layout.points->entries_.push_back({.bytes = cursor.rest(), .layout = layout.layout.get()});
  }

  void take_steps(std::string_view record) {
    if (stepping.empty())
      return;
    std::string analysis;
    StepBundle bundle;
    extract(record, analysis, bundle);
    if (analysis == stepping)
      bundles_.push_back(std::move(bundle));
  }

  std::shared_ptr<const JournalRecords> records_; ///< of the journal at hand
  std::vector<StepBundle> bundles_;
  std::map<std::uint32_t, Layout> layouts_; ///< of the same
  std::map<std::string, StoredPoints> points_;
};

std::vector<AnalysisHeader> read_headers(const std::vector<std::filesystem::path> &journals) {
  RunReader reader;
  for (const auto &journal : journals)
    reader.read(journal);
  return reader.headers;
}

StoredPoints read_points(const std::vector<std::filesystem::path> &journals,
                         const std::string &analysis) {
  RunReader reader;
  for (const auto &journal : journals)
    reader.read(journal);
  return reader.points_of(analysis);
}

StoredSteps read_steps(const std::vector<std::filesystem::path> &journals,
                       const std::string &analysis) {
  RunReader reader;
  reader.stepping = analysis;
  for (const auto &journal : journals)
    reader.read(journal);
  return reader.steps();
}

std::vector<StoredAnalysis> read_run(const std::vector<std::filesystem::path> &journals) {
  RunReader reader;
  for (const auto &journal : journals)
    reader.read(journal);
  std::vector<StoredAnalysis> analyses;
  for (const AnalysisHeader &header : reader.headers)
    analyses.push_back({.header = header, .points = reader.points_of(header.name)});
  return analyses;
}

} // namespace vibroimpact::output
