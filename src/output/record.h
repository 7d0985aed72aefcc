// What a journal holds: the headers of the analyses, the layouts of their points, and the points.
//
// The first byte of a record tells its kind. A layout ('l') stands before the first point that uses
// it and is numbered; a number given again, by a run that was resumed, replaces the older layout
// for the points behind it. A point ('p') begins with the number of its layout. Steps ('s') are
// those towards a point that may not have been reached.
#pragma once

#include "common/result_sink.h"
#include "derived/analysis_arrays.h"
#include "output/journal.h"
#include "output/point_bytes.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::output {

/// Steps towards a point, as the sink is given them.
struct StepBundle {
  std::vector<std::size_t> index; ///< of the point
  std::uint64_t first = 0;        ///< number of the first step
  std::vector<std::string> steps; ///< what they gave
};

/// Writes headers, points and steps to a journal.
class RecordWriter {
public:
  explicit RecordWriter(const std::filesystem::path &journal) : journal_(journal) {}

  void append(const AnalysisHeader &header);
  void append(const std::string &analysis, const PointResult &result);
  void append(const std::string &analysis, const StepBundle &bundle);
  void synchronise() { journal_.synchronise(); }

private:
  struct KnownLayout {
    std::string analysis;
    PointLayout layout;
  };

  std::uint32_t number_of_layout(const std::string &analysis, const PointResult &result);
  bool fits(const std::string &analysis, const PointResult &result, std::size_t number) const;

  JournalWriter journal_;
  std::string record_; ///< the newest
  std::vector<KnownLayout> layouts_;
  std::size_t latest_ = 0; ///< the layout of the point before
};

/// The points of an analysis as they lie in the journals: little more memory than their numbers.
class StoredPoints {
public:
  std::size_t size() const { return entries_.size(); }
  void visit(const std::function<void(const PointResult &)> &visit) const;
  derived::PointSequence sequence() const {
    return [this](const auto &visitor) { visit(visitor); };
  }
  /// The point at an index, or nullptr; valid until the next call.
  const PointResult *find(const std::vector<std::size_t> &index) const;

private:
  friend class RunReader;
  struct Entry {
    std::string_view bytes;
    const PointLayout *layout;
  };

  void sort();

  std::vector<Entry> entries_; ///< by index; of a point that is there twice, the first
  std::vector<std::shared_ptr<const JournalRecords>> journals_;
  std::vector<std::shared_ptr<const PointLayout>> layouts_;
  mutable PointReader found_;
};

struct StoredAnalysis {
  AnalysisHeader header;
  StoredPoints points;
};

/// Headers in the order the analyses were begun. A journal that another version of the program
/// wrote in another format is a std::runtime_error that names it.
std::vector<AnalysisHeader> read_headers(const std::vector<std::filesystem::path> &journals);
/// All points of one analysis.
StoredPoints read_points(const std::vector<std::filesystem::path> &journals,
                         const std::string &analysis);
/// Of points by their index, in the order they were taken.
using StoredSteps = std::map<std::vector<std::size_t>, std::vector<std::string>>;
/// All steps of one analysis.
StoredSteps read_steps(const std::vector<std::filesystem::path> &journals,
                       const std::string &analysis);
/// All analyses in the order they were begun.
std::vector<StoredAnalysis> read_run(const std::vector<std::filesystem::path> &journals);

} // namespace vibroimpact::output
