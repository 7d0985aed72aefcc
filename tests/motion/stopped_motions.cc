// A signal ends a single motion, however long it is and by whatever way it advances.
#include "common/signals.h"
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/hertz.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace vibroimpact::motion {
namespace stopped_motions_tests {

using namespace contact;
using testing::contact_along_x;
using testing::Events;
using testing::settings_of;
using testing::single_mass;

constexpr double for_ever = 1e12; // [s]

/// Asks the process to stop while the test's own thread computes.
class StopSoon {
public:
  StopSoon() {
    install_signal_handlers();
    thread_ = std::thread([] {
      std::this_thread::sleep_for(std::chrono::milliseconds(30));
      std::raise(SIGTERM);
    });
  }
  ~StopSoon() {
    thread_.join();
    install_signal_handlers(); // nothing is requested any more
  }
  StopSoon(const StopSoon &) = delete;
  StopSoon &operator=(const StopSoon &) = delete;

private:
  DeferSignals defer_;
  std::thread thread_;
};

struct Shaken {
  Shaken(double clearance, std::shared_ptr<const ContactLaw> law, const std::string &method)
      : model({single_mass("mass", 1, 1, 0.02)}), contacts(make_contacts(clearance, law)),
        trajectory(model, contacts, settings_of(method)) {
    trajectory.start(0, Vector::Zero(1), Vector::Zero(1));
  }
  ContactSet make_contacts(double clearance, const std::shared_ptr<const ContactLaw> &law) {
    model.add_base_motion(
        "ground", std::make_shared<model::Harmonic>(model::Given::acceleration, 0.3, 0.9, 0), {0},
        Vector3::UnitX());
    return ContactSet({contact_along_x(model, "mass.head", "", clearance, law)});
  }
  model::Model model;
  ContactSet contacts;
  Trajectory trajectory;
};

const std::shared_ptr<const ContactLaw> linear = std::make_shared<BilinearStop>(4, 0.3);
const std::shared_ptr<const ContactLaw> nonlinear =
    std::make_shared<Hertz>(HertzConstants{.stiffness = 10});

TEST(StoppedMotionsTest, WhileNothingChanges) {
  Shaken shaken(1e3, linear, "exact"); // out of reach: one exact propagation without end
  const StopSoon stop;
  EXPECT_THROW(shaken.trajectory.advance(for_ever), Interrupted);
}

TEST(StoppedMotionsTest, ByEveryMethod) {
  for (const char *method : {"exact", "rk", "bdf", "theta", "arkimex"})
    for (const auto &law : {linear, nonlinear, testing::newton(0.5)}) {
      Shaken unobserved(0.1, law, method);
      Shaken observed(0.1, law, method);
      Events events;
      {
        const StopSoon stop;
        EXPECT_THROW(unobserved.trajectory.advance(for_ever), Interrupted) << method;
      }
      const StopSoon stop;
      EXPECT_THROW(observed.trajectory.advance(for_ever, events), Interrupted) << method;
    }
}

} // namespace stopped_motions_tests
} // namespace vibroimpact::motion
