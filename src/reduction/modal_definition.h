// What a parameter file says about a body that is given by its modes, in SI units.
#pragma once

#include "common/linear_algebra.h"
#include "reduction/attachment.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::reduction {

/// What is known of a point besides the mode shapes.
struct ModalPoint {
  std::string name;
  std::optional<Vector3> position{}; ///< [m]; that of the file without it
  /// Force along each axis per displacement along it; 0 where it is not known [N/m].
  std::optional<Vector3> static_stiffness{};
  /// Static displacement along each axis per force along it that the modes lack [m/N].
  std::optional<Vector3> residual_flexibility{};
};

struct ModalDefinition {
  enum class Normalisation {
    modal_mass,       ///< any; the file gives the modal masses
    unit_mass,        ///< all modal masses are 1 kg
    largest_component ///< the largest displacement is 1; the file gives the modal masses
  };
  std::string file;                ///< where it is
  std::string separator = "comma"; ///< of a text file
  std::string group{};        ///< body in an HDF5 file; empty: the only one, or that of its name
  bool dimensionless = false; ///< frequencies of the file are angular
  Normalisation normalisation = Normalisation::modal_mass;
  int number = 0;                        ///< of modes that are taken, the first ones; 0 for all
  std::vector<double> damping_ratios{};  ///< for a file without any; the last one repeats
  std::vector<Attachment> attachments{}; ///< where what the modes lack is added
  std::optional<double> residual_frequency{};     ///< of these [rad/s]
  std::optional<double> residual_damping_ratio{}; ///< the last one of the modes without it
  std::vector<ModalPoint> points{};
  std::vector<std::array<std::string, 2>> lines{}; ///< ends of what is drawn, names of points
};

} // namespace vibroimpact::reduction
