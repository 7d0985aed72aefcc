// Modal analysis: what the reduction kept of each body, what the contacts see of it, and the modes
// of all bodies together with their connections, contacts open or tied.
#pragma once

#include "analyses/analysis.h"
#include "analyses/sweeps/tied_contacts.h"

namespace vibroimpact::analyses {

class Modal : public Analysis {
public:
  explicit Modal(TiedContacts tied) : tied_(std::move(tied)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "modal"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  PointResult compute(const System &system) const;

  TiedContacts tied_;
};

} // namespace vibroimpact::analyses
