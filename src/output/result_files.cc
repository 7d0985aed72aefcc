#include "output/result_files.h"

#include "common/durable_file.h"
#include "common/error.h"
#include "common/log.h"
#include "common/signals.h"
#include "derived/dimensionless.h"
#include "output/collective.h"
#include "output/derived_results.h"
#include "output/summary.h"
#include "output/vtu_writer.h"
#include "reduction/body_file.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vibroimpact::output {

using reduction::ReducedBody;

namespace {

bool same_axes(const AnalysisHeader &one, const AnalysisHeader &other) {
  const auto same = [](const Axis &a, const Axis &b) {
    return a.name == b.name && a.values == b.values && a.labels == b.labels && a.unit == b.unit;
  };
  return one.type == other.type && one.grid == other.grid &&
         std::equal(one.axes.begin(), one.axes.end(), other.axes.begin(), other.axes.end(), same);
}

} // namespace

FileSink::FileSink(MPI_Comm communicator, RunFolder &folder, RunInformation information,
                   std::vector<ReducedBody> bodies, std::chrono::duration<double> rebuild_interval,
                   derived::DerivedQuantities derived,
                   std::vector<contact::ContactFigures> contacts, Outlines outlines,
                   YieldStresses yield_stresses)
    : communicator_(communicator), folder_(folder), information_(std::move(information)),
      bodies_(std::move(bodies)), derived_(std::move(derived)), contacts_(std::move(contacts)),
      outlines_(std::move(outlines)), yield_stresses_(std::move(yield_stresses)),
      rebuild_interval_(rebuild_interval),
      next_rebuild_(Clock::now() + std::chrono::duration_cast<Clock::duration>(rebuild_interval)) {
  run_on_all_ranks(communicator_, [this] {
    record_writer_ = std::make_unique<RecordWriter>(folder_.journal_file(rank_in(communicator_)));
  });
}

void FileSink::begin(const AnalysisHeader &header) {
  if (!begun_.insert(header.name).second)
    throw std::logic_error("analysis " + header.name + " was begun twice");
  header_ = header;
  run_on_first_rank(communicator_, [&] { register_header(header); });
  stored_ = {};
  steps_ = {};
  if (folder_.resumed())
    run_on_all_ranks(communicator_, [&] {
      stored_ = read_points(folder_.journal_files(), header.name);
      steps_ = read_steps(folder_.journal_files(), header.name);
    });
}

void FileSink::register_header(const AnalysisHeader &header) {
  const std::vector<AnalysisHeader> headers = read_headers(folder_.journal_files());
  const auto known = std::find_if(headers.begin(), headers.end(), [&](const AnalysisHeader &other) {
    return other.name == header.name;
  });
  if (known == headers.end())
    record_writer_->append(header);
  else if (!same_axes(*known, header))
    throw InputError("cannot resume " + folder_.path().string() + ": analysis " + header.name +
                     " has other axes there; it was written by another version of the program");
}

const PointResult *FileSink::find(const std::vector<std::size_t> &index) const {
  return stored_.find(index);
}

void FileSink::store(const PointResult &result) {
  derived::check_point(header_, result);
  record_writer_->append(header_.name, result);
  if (rank_in(communicator_) == 0 && Clock::now() >= next_rebuild_)
    try_to_write([this] { replace_files(); });
}

std::vector<std::string> FileSink::find_steps(const std::vector<std::size_t> &index) const {
  const auto found = steps_.find(index);
  return found == steps_.end() ? std::vector<std::string>() : found->second;
}

void FileSink::store_steps(const std::vector<std::size_t> &index, std::size_t first,
                           const std::vector<std::string> &steps) {
  record_writer_->append(header_.name, {.index = index, .first = first, .steps = steps});
}

void FileSink::end() {
  // The first call is also the barrier behind which all journals are complete.
  stored_ = {};
  steps_ = {};
  run_on_all_ranks(communicator_, [this] { record_writer_->synchronise(); });
  run_on_first_rank(communicator_, [this] {
    try_to_write([this] {
      for (const auto &[header, points] : replace_files())
        if (header.name == header_.name && totals_.has_motion() && !stop_requested())
          write_motion(points);
    });
    tell_totals();
  });
}

// Hours of other points must not be lost because a file cannot be written now.
void FileSink::try_to_write(const std::function<void()> &write) {
  try {
    folder_.restore();
    write();
    unwritten_.clear();
  } catch (const std::exception &error) {
    next_rebuild_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(rebuild_interval_);
    if (unwritten_ != error.what())
      log::warning(std::string("the results cannot be written now: ") + error.what() +
                   "; the journal keeps every point");
    unwritten_ = error.what();
  }
}

void FileSink::check_written() const {
  run_on_first_rank(communicator_, [this] {
    if (!unwritten_.empty())
      throw std::runtime_error("the results could not be written: " + unwritten_);
  });
}

void FileSink::tell_totals() const {
  const std::string prefix = "analysis " + header_.name + ": ";
  if (const std::string failures = totals_.failures(); !failures.empty())
    log::warning(prefix + failures);
  if (const std::string elsewhere = totals_.settled_elsewhere(); !elsewhere.empty())
    log::warning(prefix + elsewhere);
  if (const std::string unsettled = totals_.unsettled(); !unsettled.empty())
    log::info(prefix + unsettled);
  for (const std::string &excess : totals_.yield().warnings())
    log::warning(prefix + excess);
}

std::vector<StoredAnalysis> FileSink::replace_files() {
  const Clock::time_point start = Clock::now();
  std::vector<StoredAnalysis> analyses = read_run(folder_.journal_files());
  std::vector<SummaryList> derived;
  replace_file(folder_.results_file(),
               [&](const std::filesystem::path &file) { derived = write_results(file, analyses); });
  const SummaryList list = summary(analyses, derived);
  replace_file(folder_.summary_file(), list.text());
  replace_file(folder_.summary_json_file(), list.json());
  // A large file must not keep rank 0 from computing: at most a twentieth of its time goes here.
  const std::chrono::duration<double> took = Clock::now() - start;
  next_rebuild_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::max(rebuild_interval_, 20 * took));
  return analyses;
}

std::vector<SummaryList> FileSink::write_results(const std::filesystem::path &file,
                                                 const std::vector<StoredAnalysis> &analyses) {
  std::vector<SummaryList> derived;
  Hdf5File results = Hdf5File::create(file);
  write_information(results, information_);
  for (const ReducedBody &body : bodies_)
    write_body(results, body, information_.dimensionless);
  write_yield_stresses(results, yield_stresses_, information_.dimensionless);
  write_contacts(results, contacts_, information_.dimensionless);
  for (const auto &[stored, points] : analyses) {
    AnalysisHeader header = stored;
    derived::AnalysisArrays arrays = derived::assemble(header, points.sequence());
    if (information_.dimensionless) {
      derived::remove_units(header);
      derived::remove_units(arrays);
    }
    const auto [quantities, problems] =
        derived_.evaluate(header.name, derived::derivation_source(header, arrays));
    note_problems(problems);
    write_analysis(results, header, arrays, quantities);
    derived.push_back(derived_summary(header, quantities));
  }
  results.close();
  return derived;
}

void FileSink::note_problems(const std::vector<std::string> &problems) {
  for (const std::string &problem : problems)
    if (std::find(problems_.begin(), problems_.end(), problem) == problems_.end()) {
      problems_.push_back(problem);
      log::warning("a derived quantity is left out: " + problem);
    }
}

std::string FileSink::missing_derived() const {
  std::string message;
  for (const std::string &problem : problems_)
    message += problem + "\n";
  return reduction::broadcast(message.empty() ? message : message + "Everything else was written.",
                              communicator_);
}

SummaryList FileSink::summary(const std::vector<StoredAnalysis> &analyses,
                              const std::vector<SummaryList> &derived) {
  SummaryList list;
  for (const ReducedBody &body : bodies_)
    list.append(body_summary(body));
  list.append(contact_summary(contacts_));
  for (std::size_t a = 0; a < analyses.size(); ++a) {
    PointTotals totals(yield_stresses_);
    list.append(analysis_summary(analyses[a].header, analyses[a].points.sequence(), totals));
    list.append(derived[a]);
    if (analyses[a].header.name == header_.name)
      totals_ = totals;
  }
  if (information_.dimensionless)
    list.remove_units();
  return list;
}

void FileSink::write_motion(const StoredPoints &points) {
  points.visit([this](const PointResult &point) {
    // The modes of the bodies are in modes.pvd, and a modal analysis is often called modes too.
    const std::string name =
        header_.name + (header_.type == "modal" ? "-system" : "") + index_suffix(point.index);
    if (!point.motion.empty() && !point.motion[0].time.empty())
      write_motion_files(folder_, name, bodies_, outlines_, point.motion[0]);
    if (point.motion.size() > 1)
      write_stress_files(folder_, name, bodies_, outlines_, point.motion[1]);
  });
}

} // namespace vibroimpact::output
