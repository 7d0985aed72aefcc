#include "model/recorded_history.h"

#include "common/linear_algebra.h"
#include "model/piecewise_function.h"
#include "model/record_file.h"
#include "reduction/named_file.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <numbers>

namespace vibroimpact::model {

namespace {

// Slopes d_i at the samples. The second derivative is continuous when at every inner
// sample  d_{i-1}/h_{i-1} + 2 (1/h_{i-1} + 1/h_i) d_i + d_{i+1}/h_i
//         = 3 (s_{i-1}/h_{i-1} + s_i/h_i)   with the slopes s_i of the chords.
Vector spline_slopes(const Samples &samples) {
  const auto n = static_cast<Index>(samples.time.size());
  Vector slopes = Vector::Zero(n);
  if (n < 3)
    return slopes;
  std::vector<Eigen::Triplet<double>> entries;
  Vector right = Vector::Zero(n - 2);
  for (Index i = 0; i + 1 < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double inverse = 1 / (samples.time[k + 1] - samples.time[k]);
    const double chord = (samples.value[k + 1] - samples.value[k]) * inverse;
    for (const Index row : {i - 1, i})
      if (row >= 0 && row < n - 2) {
        entries.emplace_back(row, row, 2 * inverse);
        right[row] += 3 * chord * inverse;
      }
    if (i > 0 && i < n - 2) {
      entries.emplace_back(i - 1, i, inverse);
      entries.emplace_back(i, i - 1, inverse);
    }
  }
  Eigen::SparseMatrix<double> matrix(n - 2, n - 2);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower,
                              Eigen::NaturalOrdering<int>>
      solver(matrix);
  slopes.segment(1, n - 2) = solver.solve(right);
  return slopes;
}

std::vector<double> cubic(double length, double rise, double begin, double first_slope,
                          double last_slope) {
  const double chord = rise / length;
  return {begin, first_slope, (3 * chord - 2 * first_slope - last_slope) / length,
          (first_slope + last_slope - 2 * chord) / (length * length)};
}

Pieces record_pieces(const Samples &samples, Interpolation interpolation, OutsideRecord outside) {
  const auto &[time, value] = samples;
  const bool held = outside == OutsideRecord::held;
  const Vector slopes =
      interpolation == Interpolation::cubic_spline ? spline_slopes(samples) : Vector();
  Pieces pieces{.breaks = time, .forms = {}};
  pieces.forms.reserve(time.size() + 1);
  pieces.forms.push_back(
      {.origin = time.front(), .terms = {}, .polynomial = {held ? value.front() : 0}});
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {
    const double length = time[i + 1] - time[i];
    const double rise = value[i + 1] - value[i];
    const auto k = static_cast<Index>(i);
    pieces.forms.push_back(
        {.origin = time[i],
         .terms = {},
         .polynomial = slopes.size() > 0 ? cubic(length, rise, value[i], slopes[k], slopes[k + 1])
                                         : std::vector<double>{value[i], rise / length}});
  }
  pieces.forms.push_back(
      {.origin = time.back(), .terms = {}, .polynomial = {held ? value.back() : 0}});
  return pieces;
}

double shortest_interval(const std::vector<double> &time) {
  double shortest = time[1] - time[0];
  for (std::size_t i = 1; i + 1 < time.size(); ++i)
    shortest = std::min(shortest, time[i + 1] - time[i]);
  return shortest;
}

} // namespace

std::shared_ptr<const TimeFunction> make_recorded(Given given, const Samples &samples,
                                                  Interpolation interpolation,
                                                  OutsideRecord outside) {
  return std::make_shared<PiecewiseFunction>(given, record_pieces(samples, interpolation, outside),
                                             std::numbers::pi / shortest_interval(samples.time));
}

void declare_recorded(parameters::Section &excitation) {
  using namespace parameters;
  excitation
      .subsection("Recorded",
                  "The given quantity through the samples of a file. Outside the record a force "
                  "is zero; a base goes on without acceleration (a given displacement rests).")
      .text("File", "",
            "Text file, or HDF5 file by its suffix .h5 or .hdf5, relative to the folder of the "
            "parameter file. In a text empty lines and lines from # or % on do not count; its "
            "first line may hold the names of the columns.")
      .required("History = recorded")
      .text("Time column", "1", "Number or name of a column of the text; path of an HDF5 dataset.")
      .text("Value column", "2", "The same for the given quantity.")
      .choice("Separator", "comma", {"comma", "semicolon", "space"},
              "What stands between the columns; space is any number of blanks and tabs.")
      .text("Time unit", "", "Unit of the time in the file; empty means s.")
      .text("Unit", "", "Unit of the given quantity in the file; empty means SI.")
      .quantity("Scale factor", "1", dimension::none, range::any, "",
                "Multiplies the values of the file.")
      .quantity("Time offset", "0 s", dimension::time, range::any, "",
                "Added to the times of the file.")
      .choice("Interpolation", "linear", {"linear", "cubic spline"},
              "Straight lines between the samples, or a curve with continuous second derivative "
              "that begins and ends with slope zero. A base displacement needs the latter.");
}

namespace {

using parameters::Values;

RecordLayout read_layout(const Values &recorded) {
  return {.time_column = recorded.text("Time column"),
          .value_column = recorded.text("Value column"),
          .separator = recorded.choice("Separator")};
}

} // namespace

TimeFunctionPointer create_recorded(const Values &excitation, const HistoryContext &context) {
  const Values recorded = excitation.subsection("Recorded");
  recorded.require("File");
  const bool displaces = context.moves_base && context.given == Given::displacement;
  const auto interpolation = recorded.choice("Interpolation") == "linear"
                                 ? Interpolation::linear
                                 : Interpolation::cubic_spline;
  if (displaces && interpolation == Interpolation::linear)
    recorded.reject("Interpolation",
                    "straight lines of a base displacement have infinite accelerations at the "
                    "samples; use cubic spline, or give a velocity or acceleration");
  Samples samples =
      read_record(recorded, context.file_folder, context.file_checksums, read_layout(recorded));
  const double time_unit = file_unit(recorded, "Time unit", parameters::dimension::time);
  const double scale =
      recorded.quantity("Scale factor") * file_unit(recorded, "Unit", context.dimension);
  for (double &time : samples.time)
    time = time * time_unit + recorded.quantity("Time offset");
  for (double &value : samples.value)
    value *= scale;
  const bool held = context.moves_base && context.given != Given::acceleration;
  return make_recorded(context.given, samples, interpolation,
                       held ? OutsideRecord::held : OutsideRecord::zero);
}

std::string record_checksum(const Values &excitation, const std::string &file_folder) {
  const Values recorded = excitation.subsection("Recorded");
  return excitation.choice("History") == "recorded"
             ? reduction::file_checksum(recorded, file_folder)
             : "";
}

} // namespace vibroimpact::model
