// One set of recorders serves all points of a sweep: what it saw of one must not show in the next.
#include "analyses/recorders/recorders.h"
#include "contact/laws/linear_penalty.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

namespace vibroimpact::analyses {
namespace recorder_reuse_tests {

using namespace contact;

constexpr double two_pi = 2 * std::numbers::pi;

// A block on a shaken base between two stops, with a connection to the base.
System between_stops() {
  model::Model model = testing::linked_block();
  ContactPair right = testing::contact_along_x(model, "block.head", "", 0.005,
                                               std::make_shared<LinearPenalty>(500));
  right.name = "right";
  ContactPair left = right;
  left.name = "left";
  left.gap.row *= -1;
  return testing::system_of(std::move(model), ContactSet({right, left}));
}

WindowRecording all_recorders(const System &system) {
  auto root = std::make_shared<parameters::Section>("file", "A file.");
  declare_recorders(*root);
  const std::string text = R"(
set Record = extreme values, statistics, impacts, energy, forces, quasi static, history, section, \
             regime, lyapunov, spectrum, wavelet, spectrogram
subsection Section
  set Contact onsets = all
  set Gap extrema    = all
  set Extrema        = true
end
subsection Wavelet
  set Lowest frequency  = 0.5 Hz
  set Highest frequency = 5 Hz
  set Frequencies       = 5
  set Sampling interval = 0.02 s
  set Instants          = 10
end
subsection Spectrogram
  set Interval          = 1 s
  set Highest frequency = 5 Hz
  set Sampling interval = 0.02 s
  set Instants          = 10
end
)";
  const auto set = parameters::ParameterSet::parse(root, text, "test.prm", false);
  return {read_recorders(set->root(), {}), system};
}

// Four periods after some that nobody watches.
PointResult recorded(WindowRecording &recording, const System &system, double start_position,
                     double period, long cycles) {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start({.time = 0, .physical = Vector::Unit(2, 0) * start_position});
  trajectory.advance(3 * period);
  recording.run(cycles > 0 ? periods_window(3 * period, period, cycles)
                           : Window{.start = 3 * period, .end = 7 * period},
                trajectory);
  PointResult result;
  recording.add_fields(result);
  return result;
}

bool same_bytes(const std::vector<double> &one, const std::vector<double> &other) {
  return one.size() == other.size() &&
         std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) == 0;
}

void expect_same(const PointResult &again, const PointResult &fresh) {
  ASSERT_EQ(again.fields.size(), fresh.fields.size());
  for (std::size_t f = 0; f < fresh.fields.size(); ++f) {
    EXPECT_EQ(again.fields[f].label, fresh.fields[f].label) << fresh.fields[f].name();
    EXPECT_EQ(again.fields[f].shape, fresh.fields[f].shape) << fresh.fields[f].name();
    EXPECT_TRUE(same_bytes(again.fields[f].values, fresh.fields[f].values))
        << fresh.fields[f].name();
  }
  EXPECT_EQ(again.summary.size(), fresh.summary.size());
}

TEST(RecorderReuseTest, TheNextWindowKnowsNothingOfTheOneBefore) {
  const System system = between_stops();
  const double period = two_pi / 8;
  WindowRecording recording = all_recorders(system);
  recorded(recording, system, 0.02, period, 20);
  for (const long cycles : {5L, 0L, 12L}) {
    WindowRecording fresh = all_recorders(system);
    expect_same(recorded(recording, system, 0.001, period, cycles),
                recorded(fresh, system, 0.001, period, cycles));
  }
}

} // namespace recorder_reuse_tests
} // namespace vibroimpact::analyses
