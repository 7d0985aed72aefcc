#include "analyses/excursions.h"

#include "analyses/fields.h"
#include "integration/impact_log.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact {

namespace {

void add_scalar(PointResult &result, const std::string &group, const std::string &name,
                double value, const std::string &unit, const std::string &description) {
  result.fields.push_back(scalar_field(group + "/" + name, value, unit, description));
}

void add_extent(PointResult &result, const std::string &group, const Extent &extent,
                const std::string &unit) {
  add_scalar(result, group, "peak_to_peak_excursion", extent.peak_to_peak(), unit,
             "largest minus smallest value in the recorded window");
  add_scalar(result, group, "peak_excursion", extent.peak(), unit,
             "largest absolute value in the recorded window");
}

} // namespace

void Extent::include(double value) {
  minimum = std::min(minimum, value);
  maximum = std::max(maximum, value);
}

void Extent::include(const Bernstein &polynomial) {
  minimum = std::min(minimum, polynomial.minimum());
  maximum = std::max(maximum, polynomial.maximum());
}

double Extent::peak_to_peak() const { return maximum >= minimum ? maximum - minimum : 0; }

double Extent::peak() const {
  return maximum >= minimum ? std::max(std::abs(minimum), std::abs(maximum)) : 0;
}

Excursions::Excursions(const System &system)
    : contacts_(system.contacts), channels_(observed_channels(system.model)),
      channel_extents_(channels_.size()), contact_extents_(system.contacts.size()) {}

void Excursions::step(const StepView &view) {
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    const Bernstein displacement = view.displacement(channels_[k].relative);
    channel_extents_[k].displacement.include(displacement);
    if (channels_[k].carried())
      channel_extents_[k].absolute.include(view.displacement(channels_[k].absolute));
    channel_extents_[k].velocity.include(view.velocity(channels_[k].relative));
    channel_extents_[k].acceleration.include(view.acceleration(channels_[k].absolute));
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    contact_extents_[c].gap.include(view.gap(c));
    const auto mode = static_cast<std::size_t>(view.equations().modes()[c]);
    contact_extents_[c].force.include(
        contacts_.pairs()[c].law->modes()[mode].in_contact ? peak_force(view, c) : 0);
  }
}

void Excursions::add_fields(PointResult &result) const {
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    const std::string base = "point/" + channels_[k].point + "/";
    const std::string axis(1, channels_[k].axis);
    add_extent(result, base + "displacement_" + axis, channel_extents_[k].displacement, "m");
    if (channels_[k].carried())
      add_extent(result, base + "absolute_displacement_" + axis, channel_extents_[k].absolute, "m");
    add_extent(result, base + "velocity_" + axis, channel_extents_[k].velocity, "m/s");
    add_extent(result, base + "acceleration_" + axis, channel_extents_[k].acceleration, "m/s^2");
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const std::string base = "contact/" + contacts_.pairs()[c].name + "/";
    add_scalar(result, base + "normal_force", "maximum", contact_extents_[c].force.maximum, "N",
               "largest normal force in the recorded window");
    add_scalar(result, base + "gap", "minimum", contact_extents_[c].gap.minimum, "m",
               "smallest gap in the recorded window");
    add_scalar(result, base + "gap", "maximum", contact_extents_[c].gap.maximum, "m",
               "largest gap in the recorded window");
  }
}

} // namespace vibroimpact
