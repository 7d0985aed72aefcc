#include "output/figure_sections.h"

namespace vibroimpact::output {

namespace {

using parameters::Section;
using parameters::Values;
namespace dimension = parameters::dimension;
namespace range = parameters::range;

constexpr const char *axes[] = {"Horizontal", "Vertical", "Colour"};

void declare_axis(Section &axis) {
  axis.text("Quantity", "",
            "What runs along the axis: an axis of the analysis, the path of a field, or the name "
            "of a Derived of the same analysis; or a sum of such, with blanks around the signs. "
            "Along Vertical several of the same unit, separated by commas, make a curve each.");
  if (axis.name() != "Colour")
    axis.required();
  axis.quantity("Divide by", "", dimension::any, range::any, "",
                "Value that the quantity is divided by, with its unit; the axis then has no unit.")
      .text(
          "Divide by largest of", "",
          "Name of an analysis of the same file, such as one without contact: the quantity is "
          "divided by its largest value there; that of the figure itself divides each curve by its "
          "own.")
      .text("Label", "",
            "Name at the axis; symbols between dollar signs, as in TeX. Empty means a "
            "name that is made up.")
      .choice("Scale", "linear", {"linear", "logarithmic"}, "Of the axis.")
      .quantities("Range", "", dimension::none, range::any, "",
                  "Both ends of the axis, in the numbers that stand at it.", 0, 2)
      .text("Marks", "",
            "LABEL = NUMBER, several of them separated by commas: values along the axis that are "
            "marked by a line across, in the numbers that stand at the axis.");
}

void check_analysis(const Values &section, const std::string &key,
                    const std::vector<std::string> &known) {
  if (section.has(key))
    section.require_known(key, section.text(key), known);
}

void check_axis(const Values &axis, const std::vector<std::string> &analyses) {
  check_analysis(axis, "Divide by largest of", analyses);
  if (axis.has("Divide by") && axis.has("Divide by largest of"))
    axis.reject("Divide by", "must not be set when Divide by largest of is set");
  if (axis.has("Divide by") && axis.quantity("Divide by") == 0)
    axis.reject("Divide by", "must not be 0");
  const std::vector<double> ends = axis.quantities("Range");
  if (!ends.empty() && (ends.size() != 2 || ends[0] >= ends[1]))
    axis.reject("Range", "must be two numbers, the second greater than the first");
}

} // namespace

void declare_figures(Section &root) {
  Section &figure = root.named_subsection(
      "Figure", "A figure with chosen axes, which vibroimpact-plot draws from the results.");
  figure.text("From", "", "Name of the analysis.")
      .required()
      .text("Title", "", "Above the figure; empty means none.")
      .text("Where", "",
            "AXIS = COORDINATE, COORDINATE...; several of them separated by semicolons: only these "
            "points, for example lambda = 1, 10; direction = forward.")
      .text("Reference", "",
            "Name of an analysis of the same file, such as one without contact, whose curve of the "
            "same quantities is drawn in black.")
      .text("Reference label", "",
            "Name of this curve in the legend; empty means that of the "
            "analysis.")
      .text("Names", "",
            "Of several quantities along Vertical, in the legend, separated by commas; empty means "
            "names that are made up.")
      .boolean(
          "Joined", "true",
          "Are the points of a curve joined? Values of motions that do not repeat stand better "
          "by themselves.")
      .names("Curves", "",
             "Derived quantities that are drawn over a map, NAME or ANALYSIS:NAME; empty means all "
             "of the analysis that lie in its plane.");
  for (const char *axis : axes)
    declare_axis(figure.subsection(
        axis, std::string(axis) == "Colour"
                  ? "The quantity that the colours of a map show; without it the figure has curves."
                  : "An axis of the figure."));
}

void check_figures(const Values &root) {
  const std::vector<std::string> analyses = root.instances("Analysis");
  for (const std::string &name : root.instances("Figure")) {
    const Values figure = root.instance("Figure", name);
    figure.require("From");
    check_analysis(figure, "From", analyses);
    check_analysis(figure, "Reference", analyses);
    figure.subsection("Horizontal").require("Quantity");
    figure.subsection("Vertical").require("Quantity");
    for (const char *axis : axes)
      check_axis(figure.subsection(axis), analyses);
  }
}

} // namespace vibroimpact::output
