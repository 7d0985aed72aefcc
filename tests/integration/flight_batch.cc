// Motions side by side are what they are one after the other, to the last bit.
#include "integration/flight_batch.h"

#include "common/error.h"
#include "contact/laws/piecewise_stop.h"
#include "contact/laws/relaxing_stop.h"
#include "integration/trajectory.h"
#include "support/lumped_models.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <stdexcept>

namespace vibroimpact::integration {
namespace {

using namespace contact;
using namespace model;

// A mass between two stops on a shaken base.
struct Bumped {
  explicit Bumped(int number)
      : frequency(0.4 + 0.07 * (number % 23)), model(model_of(number, frequency)),
        contacts(contacts_of(number, model)), trajectory(model, contacts, {}) {
    trajectory.start(0, Vector::Zero(model.size()), Vector::Zero(model.size()));
  }
  Bumped(const Bumped &) = delete;

  static Model model_of(int number, double frequency) {
    std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies = {
        testing::single_mass("mass", 1, 1, 0.2)};
    if (number % 3 == 0)
      bodies.push_back(testing::single_mass("other", 0.5, 2, 0.1));
    Model model(bodies);
    std::vector<std::size_t> moved(bodies.size());
    for (std::size_t b = 0; b < moved.size(); ++b)
      moved[b] = b;
    model.add_base_motion("ground",
                          std::make_shared<Harmonic>(Given::acceleration, 0.3, frequency, 0), moved,
                          Vector3::UnitX());
    return model;
  }

  static ContactSet contacts_of(int number, const Model &model) {
    std::shared_ptr<const ContactLaw> law =
        std::make_shared<RelaxingStop>(0.5 + 3 * (number % 7), 1);
    if (number % 4 == 1)
      law = std::make_shared<PiecewiseStop>(4, 0.3);
    const std::string opposite = number % 3 == 0 ? "other.head" : "";
    ContactPair right = testing::contact_along_x(model, "mass.head", opposite, 0.25, law);
    ContactPair left = testing::contact_along_x(model, "mass.head", "", 0.3, law);
    left.gap.row *= -1;
    for (double &carrier : left.gap.carrier)
      carrier *= -1;
    return ContactSet({right, left});
  }

  void advance(int from, int to) {
    for (int k = from; k <= to; ++k)
      trajectory.advance(k * 2 * std::numbers::pi / frequency);
  }

  double frequency;
  Model model;
  ContactSet contacts;
  Trajectory trajectory;
};

void expect_same(const Bumped &a, const Bumped &b) {
  const Vector &one = a.trajectory.state();
  const Vector &other = b.trajectory.state();
  ASSERT_EQ(one.size(), other.size());
  EXPECT_EQ(std::memcmp(one.data(), other.data(), sizeof(double) * one.size()), 0);
  EXPECT_EQ(a.trajectory.accuracy().events, b.trajectory.accuracy().events);
  EXPECT_EQ(a.trajectory.accuracy().steps, b.trajectory.accuracy().steps);
}

constexpr int n_motions = 60, n_periods = 40;

TEST(FlightBatchTest, LikeOneAfterTheOther) {
  for (const std::size_t at_once : {2, 7, 16, 40}) {
    int next = 0;
    long events = 0;
    run_batch(at_once, [&] {
      while (next < n_motions) {
        const int own = next++;
        Bumped together(own);
        together.advance(1, n_periods);
        Bumped alone(own);
        alone.advance(1, n_periods); // in other company
        expect_same(together, alone);
        events += together.trajectory.accuracy().events;
      }
    });
    EXPECT_EQ(next, n_motions);
    EXPECT_GT(events, n_motions * n_periods);
  }
}

TEST(FlightBatchTest, LikeWithoutBatch) {
  std::vector<std::unique_ptr<Bumped>> together;
  for (int i = 0; i < n_motions; ++i)
    together.push_back(std::make_unique<Bumped>(i));
  int next = 0;
  run_batch(16, [&] {
    while (next < n_motions)
      together[static_cast<std::size_t>(next++)]->advance(1, n_periods);
  });
  for (int i = 0; i < n_motions; ++i) {
    Bumped alone(i);
    alone.advance(1, n_periods);
    expect_same(*together[static_cast<std::size_t>(i)], alone);
  }
}

// An error that a work deals with itself leaves the others alone.
TEST(FlightBatchTest, AFailureStaysWithItsOwner) {
  int next = 0;
  int failures = 0;
  run_batch(8, [&] {
    while (next < 30) {
      const int own = next++;
      Bumped motion(own);
      try {
        motion.advance(1, 5);
        if (own % 5 == 2)
          throw NumericalError("by itself");
        motion.advance(6, 10);
      } catch (const NumericalError &) {
        ++failures;
        motion.advance(6, 10); // while an error is being dealt with
      }
      Bumped alone(own);
      alone.advance(1, 10);
      expect_same(motion, alone);
    }
  });
  EXPECT_EQ(failures, 6);
}

// One that nobody deals with ends all of them, stacks unwound.
TEST(FlightBatchTest, AnExceptionEndsAll) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "there are no fibers under this sanitizer";
#endif
  struct Counted {
    explicit Counted(int &count) : alive(count) { ++alive; }
    Counted(const Counted &) = delete;
    ~Counted() { --alive; }
    int &alive;
  };
  int alive = 0;
  int finished = 0;
  int next = 0;
  EXPECT_THROW(run_batch(12,
                         [&] {
                           const Counted counted(alive);
                           const int own = next++;
                           Bumped motion(own);
                           motion.advance(1, own == 6 ? 3 : 1000);
                           if (own == 6)
                             throw std::runtime_error("the end");
                           ++finished;
                         }),
               std::runtime_error);
  EXPECT_EQ(alive, 0);
  EXPECT_EQ(finished, 0);
  // And the next batch is not impaired.
  std::vector<std::unique_ptr<Bumped>> motions;
  run_batch(3, [&] {
    motions.push_back(std::make_unique<Bumped>(static_cast<int>(motions.size())));
    motions.back()->advance(1, 2);
  });
}

} // namespace
} // namespace vibroimpact::integration
