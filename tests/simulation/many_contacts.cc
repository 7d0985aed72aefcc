// Contacts found by a pairing on meshes: the same as single ones, and right when there are many.
#include "analyses/run/system.h"
#include "motion/path/trajectory.h"
#include "reduction/reduce_body.h"
#include "support/simulation_files.h"

#include <gtest/gtest.h>
#include <set>

namespace vibroimpact {
namespace many_contacts_tests {

using namespace contact;
using namespace motion;
using analyses::System;
using reduction::ReducedBody;
using testing::changed;

const std::string plate = R"(
subsection Body plate
  set Type = shell
  subsection Geometry
    set Plate = 0 m, 0 m, 0 m -> 0.6 m, 0 m, 0 m -> 0 m, 0.4 m, 0 m
    set Divisions = 6, 4
  end
  subsection Material
    set Young modulus = 200 GPa
    set Density = 7800 kg/m^3
  end
  subsection Shell sheet
    set Thickness = 3 mm
  end
  subsection Support plane
    set At = all
    set Fix = x, y, rz
  end
  subsection Support edges
    set At = edges
    set Fix = z
  end
  PLACE
  subsection Modes
    set Number = 5
    set Damping ratio = 0.01
    set Attachments = stops.z
    set Attachment damping ratio = 0.05
  end
end
subsection Contact stops
  set Between = plate.stops, base
  PAIRING
  set Direction = -z
  set Clearance = 0.2 mm
  set Law = kelvin-voigt
  subsection Kelvin-Voigt
    set Stiffness = 1 MN/m
    set Damping constant = 40 N s/m
  end
end
subsection Excitation table
  set Type = base acceleration
  set Direction = z
  set Amplitude = 20 m/s^2
  set Frequency = 60 Hz
end
subsection Analysis rattle
  set Type = transient
  subsection Transient
    set Duration = 0.1 s
  end
end
)";

std::string file(const std::string &place, const std::string &pairing) {
  return changed(changed(plate, "PLACE", place), "PAIRING", pairing);
}

const std::string grid = "subsection Interface stops\n"
                         "set Grid = 0.1 m, 0.1 m, 0 m -> 0.5 m, 0.1 m, 0 m -> 0.1 m, 0.3 m, 0 m\n"
                         "set Grid points = 5, 3\nend";

System system_of(const std::string &text, MPI_Comm communicator = MPI_COMM_SELF) {
  const auto set = parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false);
  const parameters::Values root = set->root();
  std::vector<std::shared_ptr<const ReducedBody>> bodies;
  for (const std::string &name : root.instances("Body"))
    bodies.push_back(std::make_shared<ReducedBody>(
        reduction::reduce_body(root.instance("Body", name), name, ".", communicator)));
  return analyses::build_system(root, root.instance("Analysis", "rattle"), bodies);
}

struct Ended {
  Vector state;
  Accuracy accuracy;
  std::set<std::size_t> touched;
};

class Touches : public Observer {
public:
  void event(const ContactEvent &event) override {
    if (event.onset)
      contacts.insert(event.contact);
  }
  std::set<std::size_t> contacts;
};

Ended motion_of(const System &system, double end = 0.1) {
  Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  Touches touches;
  trajectory.advance(end, touches);
  return {
      .state = trajectory.state(), .accuracy = trajectory.accuracy(), .touched = touches.contacts};
}

TEST(ManyContactsTest, OneStopIsASingleContact) {
  const System one = system_of(
      file("subsection Interface stops\nset Near = 0.3 m, 0.2 m, 0 m\nend", "set Pairing = stops"));
  const System single =
      system_of(file("subsection Point stops\nset Position = 0.3 m, 0.2 m, 0 m\nend", ""));
  ASSERT_EQ(one.contacts.size(), 1U);
  EXPECT_EQ(one.contacts.pairs()[0].name, "stops.1");
  EXPECT_EQ(one.contacts.pairs()[0].gap.row, single.contacts.pairs()[0].gap.row);
  EXPECT_EQ(one.contacts.pairs()[0].clearance, single.contacts.pairs()[0].clearance);
  const Ended group = motion_of(one);
  EXPECT_FALSE(group.touched.empty());
  EXPECT_EQ(group.state, motion_of(single).state) << "to the last bit";
}

TEST(ManyContactsTest, TheEnergyBalanceCloses) {
  const System system = system_of(file(grid, "set Pairing = stops"));
  ASSERT_EQ(system.contacts.size(), 15U);
  const Ended ended = motion_of(system);
  EXPECT_GE(ended.touched.size(), 5U);
  EXPECT_LT(ended.accuracy.energy_residual, 1e-12);
  EXPECT_TRUE(ended.accuracy.balanced());
}

// Behind displacements and velocities the state holds what only its own method keeps.
double difference(const System &system, const Ended &one, const Ended &other) {
  const Index size = 2 * system.model.size();
  return (one.state.head(size) - other.state.head(size)).norm() / one.state.head(size).norm();
}

TEST(ManyContactsTest, BothMethodsAgree) {
  const System system = system_of(file(grid, "set Pairing = stops"));
  const Ended flight = motion_of(system, 0.04);
  EXPECT_GE(flight.touched.size(), 3U);
  std::vector<double> errors;
  for (const double step : {8e-6, 2e-6}) {
    System stepping = system;
    stepping.integration.method = "rk";
    stepping.integration.maximum_step = step;
    const Ended stepped = motion_of(stepping, 0.04);
    EXPECT_EQ(flight.touched, stepped.touched);
    errors.push_back(difference(system, flight, stepped));
  }
  // The stepped motion finds its contact changes on polynomials of degree 5 between the steps.
  EXPECT_LT(errors[1], errors[0] / 50);
  EXPECT_LT(errors[1], 1e-10);
}

TEST(ManyContactsTest, AttachmentsCarryTheWholeFlexibility) {
  const System with = system_of(file(grid, "set Pairing = stops"));
  for (const ContactFigures &contact : contact_figures(with.contacts, with.model))
    EXPECT_NEAR(contact.flexibility_share, 1, 1e-12) << contact.name;
  const System without =
      system_of(changed(file(grid, "set Pairing = stops"), "    set Attachments = stops.z\n", ""));
  const auto figures = contact_figures(without.contacts, without.model);
  for (const ContactFigures &contact : figures) {
    EXPECT_LT(contact.flexibility_share, 0.99) << contact.name;
    EXPECT_GT(contact.flexibility_share, 0.05) << contact.name;
  }
  EXPECT_NE(flexibility_warning(figures).find("stops.1 ("), std::string::npos);
}

Matrix gap_rows(const System &system) {
  Matrix rows(static_cast<Index>(system.contacts.size()), system.model.size());
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    rows.row(static_cast<Index>(c)) = system.contacts.pairs()[c].gap.row;
  return rows;
}

// Close modes may be solved for as another basis of the same space. That space itself is known to
// the error of the static answers over what the kept modes leave of them, some 1e-11 over 1e-4.
TEST(ManyContactsTest, TheSameOnEveryNumberOfRanks) {
  const System together = system_of(file(grid, "set Pairing = stops"), MPI_COMM_WORLD);
  const System alone = system_of(file(grid, "set Pairing = stops"), MPI_COMM_SELF);
  ASSERT_EQ(together.contacts.size(), alone.contacts.size());
  for (std::size_t c = 0; c < alone.contacts.size(); ++c)
    EXPECT_EQ(together.contacts.pairs()[c].side_a, alone.contacts.pairs()[c].side_a);
  const Matrix rows = gap_rows(together);
  const Matrix expected_rows = gap_rows(alone);
  const Matrix response = expected_rows * expected_rows.transpose();
  EXPECT_LT((rows * rows.transpose() - response).norm(), 3e-7 * response.norm());
  const Ended ended = motion_of(together, 0.04);
  const Ended expected = motion_of(alone, 0.04);
  EXPECT_EQ(ended.touched, expected.touched);
  const Vector gaps = expected_rows * expected.state.head(alone.model.size());
  EXPECT_LT((rows * ended.state.head(together.model.size()) - gaps).norm(), 1e-9 * gaps.norm());
}

/// Two plates above each other; the pairs face each other along z.
TEST(ManyContactsTest, ARotatedPairOfPlatesHasTheSameContacts) {
  const auto file_of = [](const std::string &lower, const std::string &upper,
                          const std::string &direction) {
    const auto body = [](const std::string &name, const std::string &geometry) {
      return "subsection Body " + name +
             "\nset Type = shell\nsubsection Geometry\nset Plate = " + geometry +
             "\nset Divisions = 4, 3\nend\nsubsection Material\nset Young modulus = 200 GPa\n"
             "set Density = 7800 kg/m^3\nend\nsubsection Shell sheet\nset Thickness = 4 mm\nend\n"
             "subsection Support left\nset At = left\nset Fix = all\nend\n"
             "subsection Interface face\nend\nsubsection Modes\nset Number = 3\nend\nend\n";
    };
    return body("lower", lower) + body("upper", upper) +
           "subsection Contact faces\nset Between = lower.face, upper.face\n"
           "set Pairing = proximity\nset Search radius = 1 cm\nset Offset = 4 mm\n"
           "set Direction = " +
           direction +
           "\nset Stiffness fraction = 4\nend\n"
           "subsection Analysis rattle\nset Type = transient\nsubsection Transient\n"
           "set Duration = 1 s\nend\nend\n";
  };
  // The second pair stands upright: x -> z, y -> x, z -> y.
  const System flat =
      system_of(file_of("0 m, 0 m, 0 m -> 0.4 m, 0 m, 0 m -> 0 m, 0.3 m, 0 m",
                        "0 m, 0 m, 6 mm -> 0.4 m, 0 m, 6 mm -> 0 m, 0.3 m, 6 mm", "z"));
  const System upright =
      system_of(file_of("0 m, 0 m, 0 m -> 0 m, 0 m, 0.4 m -> 0.3 m, 0 m, 0 m",
                        "0 m, 6 mm, 0 m -> 0 m, 6 mm, 0.4 m -> 0.3 m, 6 mm, 0 m", "y"));
  ASSERT_EQ(flat.contacts.size(), 16U) << "the clamped edges are left out";
  EXPECT_EQ(flat.contacts.groups()[0].held, 4U);
  ASSERT_EQ(upright.contacts.size(), 16U);
  const auto places = [](const System &system, const Vector3 &order) {
    std::set<std::vector<long>> set;
    for (const ContactPair &pair : system.contacts.pairs()) {
      model::PointReference a;
      system.model.find_point(pair.side_a, a);
      const Vector3 &x = system.model.bodies()[a.body]->points[a.point].position;
      std::vector<long> place;
      for (int axis = 0; axis < 3; ++axis)
        place.push_back(std::lround(1e6 * x[static_cast<Index>(order[axis])]));
      place.push_back(std::lround(1e9 * pair.clearance));
      set.insert(place);
    }
    return set;
  };
  EXPECT_EQ(places(flat, {0, 1, 2}), places(upright, {2, 0, 1}));
  EXPECT_NEAR(flat.contacts.pairs()[0].clearance, 0.002, 1e-12);
}

} // namespace many_contacts_tests
} // namespace vibroimpact
