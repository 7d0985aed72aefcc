#include "analyses/identification/identify_pulses.h"

#include "model/record_file.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

/// Samples first ... last, which both have neighbours.
MeasuredPulse pulse(const model::Samples &samples, std::size_t first, std::size_t last) {
  MeasuredPulse pulse{.start = samples.time[first],
                      .duration = samples.time[last] - samples.time[first],
                      .samples = last - first + 1,
                      .figures = {}};
  for (std::size_t i = first; i <= last + 1; ++i)
    pulse.figures.impulse +=
        (samples.time[i] - samples.time[i - 1]) * (samples.value[i] + samples.value[i - 1]) / 2;
  pulse.figures.peak_force =
      *std::max_element(samples.value.begin() + static_cast<std::ptrdiff_t>(first),
                        samples.value.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  return pulse;
}

} // namespace

std::vector<MeasuredPulse> pulses_of(const MeasuredForce &force) {
  const std::vector<double> &value = force.samples.value;
  std::vector<MeasuredPulse> pulses;
  for (std::size_t first = 0; first < value.size();) {
    std::size_t behind = first;
    while (behind < value.size() && value[behind] > force.threshold)
      ++behind;
    if (behind > first && first > 0 && behind < value.size())
      pulses.push_back(pulse(force.samples, first, behind - 1));
    first = behind + 1;
  }
  return pulses;
}

PulseFigures figures_of(const std::vector<double> &time, const std::vector<double> &force,
                        double interval, const motion::Impact &impact) {
  const auto first = std::lower_bound(time.begin(), time.end(), impact.start_time);
  const auto last = std::upper_bound(first, time.end(), impact.start_time + impact.duration);
  PulseFigures figures;
  for (auto i = first - time.begin(); i < last - time.begin(); ++i) {
    figures.impulse += force[static_cast<std::size_t>(i)] * interval;
    figures.peak_force = std::max(figures.peak_force, force[static_cast<std::size_t>(i)]);
  }
  return figures;
}

void declare_measured_force(parameters::Section &section) {
  using namespace parameters;
  section
      .text("File", "",
            "Measured force record instead of a motion: text file, or HDF5 file by its suffix .h5 "
            "or .hdf5, relative to the folder of the parameter file. The model then only says what "
            "the contact is made of.")
      .text("Time column", "1",
            "Number or name of a column of the text, path of an HDF5 dataset: instants, "
            "increasing, not necessarily at equal intervals.")
      .text("Value column", "2", "The same for the contact force, > 0 where the sides push.")
      .choice("Separator", "comma", {"comma", "semicolon", "space"},
              "What stands between the columns; space is any number of blanks and tabs.")
      .text("Time unit", "", "Unit of the instants in the file; empty means s.")
      .text("Value unit", "", "Unit of the force in the file; empty means N.")
      .quantity("Threshold", "", dimension::force, range::positive, "",
                "Samples above it are a pulse; well above the noise of the record.")
      .required("File is given");
}

bool has_measured_force(const parameters::Values &section) { return section.has("File"); }

MeasuredForce read_measured_force(const parameters::Values &section) {
  section.require("Threshold");
  const parameters::Values root = section.parameters().root();
  MeasuredForce force{.samples = model::read_record(section, root.text("File folder"),
                                                    root.names("File checksums"),
                                                    {.time_column = section.text("Time column"),
                                                     .value_column = section.text("Value column"),
                                                     .separator = section.choice("Separator")}),
                      .threshold = section.quantity("Threshold")};
  const double second = model::file_unit(section, "Time unit", parameters::dimension::time);
  const double newton = model::file_unit(section, "Value unit", parameters::dimension::force);
  for (double &time : force.samples.time)
    time *= second;
  for (double &value : force.samples.value)
    value *= newton;
  if (pulses_of(force).empty())
    section.reject("Threshold", "must be less than some of the samples between the first and the "
                                "last one, none of which is a pulse otherwise");
  return force;
}

} // namespace vibroimpact::analyses
