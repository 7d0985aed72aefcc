#include "output/vtu_point_data.h"

namespace vibroimpact::output {

namespace {

struct Named {
  std::string name;
  unsigned components;
};

std::vector<Named> all_of(const PointData &data) {
  std::vector<Named> all = {{"displacement", 3}, {"rotation", 3}, {"body", 1}};
  if (data.velocity)
    all.push_back({"velocity", 3});
  if (data.contact)
    all.insert(all.end(), {{"contact_force", 3},
                           {"contact_gap", 1},
                           {"peak_contact_force", 1},
                           {"contact_state", 1}});
  const std::vector<std::string> stresses = {"von_mises_stress", "von_mises_stress_first_face",
                                             "von_mises_stress_second_face"};
  for (unsigned i = 0; i < data.von_mises; ++i)
    all.push_back({stresses[i], 1});
  for (const char *component : data.stress)
    all.push_back({std::string("stress_") + component, 1});
  return all;
}

} // namespace

std::vector<std::string> PointData::names() const {
  std::vector<std::string> names;
  for (const Named &each : all_of(*this))
    names.insert(names.end(), each.components, each.name);
  return names;
}

PointData::Vectors PointData::vectors() const {
  Vectors vectors;
  unsigned first = 0;
  for (const Named &each : all_of(*this)) {
    if (each.components == 3)
      vectors.emplace_back(first, first + 2, each.name,
                           dealii::DataComponentInterpretation::component_is_part_of_vector);
    first += each.components;
  }
  return vectors;
}

} // namespace vibroimpact::output
