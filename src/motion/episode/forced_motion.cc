#include "motion/episode/forced_motion.h"

namespace vibroimpact::motion {

ForcedMotion::ForcedMotion(const ForcedOutput &only) : n_(1), outputs_{&only, nullptr} {}

ForcedMotion::ForcedMotion(const ForcedOutput &first, const ForcedOutput &second)
    : n_(2), outputs_{&first, &second} {}

void ForcedMotion::turn_to(const TouchFrame &frame) {
  frame_ = frame;
  const std::array<std::array<double, 2>, 2> acts = {frame.normal, frame.tangent()};
  const std::array<std::array<double, 2>, 2> seen = {
      std::array<double, 2>{-frame.normal[0], -frame.normal[1]}, frame.tangent()};
  const Vector &r00 = outputs_[0]->responses(0), &r01 = outputs_[0]->responses(1);
  const Vector &r10 = outputs_[1]->responses(0), &r11 = outputs_[1]->responses(1);
  for (std::size_t of = 0; of < 2; ++of)
    for (std::size_t by = 0; by < 2; ++by) {
      const auto &a = seen[of];
      const auto &b = acts[by];
      for (int k = 0; k < most_terms; ++k)
        turned_[2 * of + by][static_cast<std::size_t>(k)] =
            a[0] * (r00[k] * b[0] + r01[k] * b[1]) + a[1] * (r10[k] * b[0] + r11[k] * b[1]);
    }
}

void ForcedMotion::free_motion(const double *x, int terms,
                               std::array<Coefficients, most_axes> &coefficients) const {
  for (int d = 0; d < n_; ++d)
    outputs_[static_cast<std::size_t>(d)]->free_motion(
        x, terms, coefficients[static_cast<std::size_t>(d)].data());
  if (n_ == 1)
    return;
  const auto [n1, n2] = frame_.normal;
  for (std::size_t k = 0; k < static_cast<std::size_t>(terms); ++k) {
    const double first = coefficients[0][k];
    const double second = coefficients[1][k];
    coefficients[0][k] = -(n1 * first + n2 * second);
    coefficients[1][k] = n1 * second - n2 * first;
  }
  coefficients[0][0] -= frame_.touching;
}

} // namespace vibroimpact::motion
