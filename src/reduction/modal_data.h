// Modes of a body as a file holds them: of a modal test, of another program, or of a result file.
#pragma once

#include "reduction/modal_definition.h"
#include "reduction/reduced_body.h"

#include <limits>
#include <string>

namespace vibroimpact::reduction {

struct ModalData {
  Vector frequency; ///< n, undamped, angular [rad/s]; 0 for rigid modes
  /// n, generalised, in all digits [N/m]; empty where the frequencies say it.
  Vector stiffness{};
  Vector damping_ratio{};      ///< n; empty when the file has none
  Matrix damping{};            ///< n x n, generalised; empty where the ratios say it all
  Vector mass{};               ///< n, modal masses [kg]; empty when the file has none
  Matrix base_participation{}; ///< n x 3 [kg]; empty when the file has none
  /// [kg]; NaN when the file has none.
  Vector3 total_mass = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<BodyPoint> points{}; ///< with rows, and as much else as the file has
  Recovery recovery{};             ///< empty without a mesh
  Vector eigen_residual{};         ///< n; empty when the file has none
  double orthogonality_residual = 0;

  Index size() const { return frequency.size(); }
};

/// From the text of a table: a line for each mode, a column for each quantity. The first line names
/// the columns: "frequency" [Hz], "damping ratio", "modal mass" [kg], "participation.x" [kg] (y,
/// z), and POINT.x (y, z, rx, ry, rz) for the mode shapes; "mode" counts. Throws DefinitionError
/// with the number of the line.
ModalData read_modal_text(const std::string &content, const ModalDefinition &definition);

/// From the group /body/NAME of an HDF5 file with the layout of results.h5; what a run does not
/// need may be missing. Throws DefinitionError with the path of the dataset.
ModalData read_modal_hdf5(const ModalDefinition &definition, const std::string &body_name);

/// "pads" for a point "pads.12" of the interface pads; "" for others.
std::string interface_of(const std::string &point);

} // namespace vibroimpact::reduction
