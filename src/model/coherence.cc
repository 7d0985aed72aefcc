#include "model/coherence.h"

#include "model/direction.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::model {

namespace {

using parameters::Values;

struct CoherenceLaw {
  const char *name;
  double (*value)(double argument);
};

// Davenport 1961, Luco and Wong 1986
const std::vector<CoherenceLaw> &coherence_laws() {
  static const std::vector<CoherenceLaw> list = {
      {"exponential", [](double x) { return std::exp(-x); }},
      {"gaussian", [](double x) { return std::exp(-x * x); }},
  };
  return list;
}

/// The last row of the lower factor of a matrix with ones on its diagonal, which may be singular.
Vector last_row_of_factor(const Matrix &matrix) {
  constexpr double rounding = 1e-14; // of a pivot that is zero
  const Index n = matrix.rows();
  Matrix factor = Matrix::Zero(n, n);
  for (Index j = 0; j < n; ++j) {
    const double pivot = matrix(j, j) - factor.row(j).head(j).squaredNorm();
    if (pivot <= rounding)
      continue;
    factor(j, j) = std::sqrt(pivot);
    for (Index i = j + 1; i < n; ++i)
      factor(i, j) =
          (matrix(i, j) - factor.row(i).head(j).dot(factor.row(j).head(j))) / factor(j, j);
  }
  return factor.row(n - 1).transpose();
}

Vector3 read_place(const Values &random) {
  random.require("Place");
  const std::vector<double> place = random.quantities("Place");
  return {place[0], place[1], place[2]};
}

std::string stream_of(const Values &random, const std::string &excitation) {
  return random.text("Stream").empty() ? excitation : random.text("Stream");
}

/// Lines of two histories are the same frequencies, and their streams belong to one ensemble.
void require_same_lines(const Values &random, const Values &other, const std::string &name) {
  const auto check = [&](const char *key, bool same) {
    if (!same)
      random.reject(key, "must be that of Excitation " + name + ", which has the same Coherence");
  };
  for (const char *key : {"Highest frequency", "Duration"}) {
    random.require(key);
    other.require(key);
    check(key, random.quantity(key) == other.quantity(key));
  }
  check("Samples per period",
        random.quantity("Samples per period") == other.quantity("Samples per period"));
  for (const char *key : {"Seed", "Member"})
    check(key, random.integer(key) == other.integer(key));
}

void read_law(const Values &coherence, CoherentPlaces &places) {
  for (const char *key : {"Decay", "Speed"})
    coherence.require(key);
  for (const CoherenceLaw &law : coherence_laws())
    if (coherence.choice("Law") == law.name)
      places.law = law.value;
  places.decay_per_speed = coherence.quantity("Decay") / coherence.quantity("Speed");
  if (coherence.has("Wave velocity"))
    places.slowness =
        read_direction(coherence, "Wave direction") / coherence.quantity("Wave velocity");
  else if (coherence.given("Wave direction"))
    coherence.reject("Wave direction", "must not be set without Wave velocity");
}

Values random_of(const Values &root, const std::string &excitation) {
  return root.instance("Excitation", excitation).subsection("Random");
}

} // namespace

std::vector<std::complex<double>> CoherentPlaces::shares(double omega) const {
  const auto n = static_cast<Index>(places.size());
  Matrix matrix(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      matrix(i, j) =
          law(decay_per_speed * omega *
              (places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)]).norm());
  const Vector row = last_row_of_factor(matrix);
  const std::complex<double> later = std::polar(1.0, omega * places.back().dot(slowness));
  std::vector<std::complex<double>> shares;
  for (const double entry : row)
    shares.push_back(entry * later);
  return shares;
}

void declare_coherence(parameters::Section &root) {
  using namespace parameters;
  std::vector<std::string> names;
  for (const CoherenceLaw &law : coherence_laws())
    names.emplace_back(law.name);
  root.named_subsection(
          "Coherence",
          "How random excitations at several places belong together, those whose section Random "
          "names it: the square root of their coherence, and a wave that passes the places.")
      .choice("Law", "exponential", names,
              "With x = Decay omega distance / Speed, omega = 2 pi f. exponential: exp(-x), wind "
              "and turbulence; gaussian: exp(-x^2), ground motion.")
      .quantity("Decay", "", dimension::none, range::non_negative, "\\alpha",
                "Of wind about 1.2 to 1.6, with the mean speed: 7 to 10 for x in terms of f. Of "
                "ground motion about 0.1 to 0.3, with the speed of shear waves.")
      .required()
      .quantity("Speed", "", dimension::velocity, range::positive, "v", "That x refers to.")
      .required()
      .quantity("Wave velocity", "", dimension::velocity, range::positive, "c",
                "At which the motion goes from place to place along Wave direction; without it all "
                "places move at once.")
      .text("Wave direction", "x", "Direction of the wave: x, -y or three numbers.");
}

void declare_coherent_place(parameters::Section &random) {
  using namespace parameters;
  random
      .text("Coherence", "",
            "Section Coherence of the excitations at several places that this one belongs to.")
      .quantities("Place", "", dimension::length, range::any, "x",
                  "Where it acts, for Coherence alone.", 3, 3)
      .required("Coherence is given");
}

CoherentPlaces read_coherence(const Values &root, const std::string &excitation) {
  CoherentPlaces places;
  const Values random = random_of(root, excitation);
  if (root.instance("Excitation", excitation).choice("History") != "random")
    return places;
  const std::string name = random.text("Coherence");
  if (name.empty()) {
    if (random.given("Place"))
      random.reject("Place", "must not be set without Coherence");
    return places;
  }
  random.require_known("Coherence", name, root.instances("Coherence"));
  if (random.given("Common share"))
    random.reject("Common share", "must not be set with Coherence");
  read_law(root.instance("Coherence", name), places);
  for (const std::string &other : root.instances("Excitation")) {
    const Values of_other = random_of(root, other);
    if (root.instance("Excitation", other).choice("History") != "random" ||
        of_other.text("Coherence") != name)
      continue;
    const std::string stream = stream_of(of_other, other);
    require_same_lines(random, of_other, other);
    if (std::find(places.streams.begin(), places.streams.end(), stream) != places.streams.end())
      random.reject("Stream",
                    "must differ from those of the other excitations of Coherence " + name);
    places.streams.push_back(stream);
    places.places.push_back(read_place(of_other));
    if (other == excitation)
      return places;
  }
  return places;
}

} // namespace vibroimpact::model
