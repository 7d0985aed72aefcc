#include "parameters/origin.h"

#include "common/error.h"
#include "parameters/text.h"

namespace vibroimpact::parameters {

namespace {

constexpr std::size_t longest_place = 600;
constexpr std::size_t longest_value = 300;
constexpr std::size_t longest_problem = 1200;

std::string message(const std::string &headline, const std::string &problem) {
  const bool ended = problem.ends_with('.') || problem.ends_with('?');
  return headline + "\n  " + shortened(problem, longest_problem) + (ended ? "" : ".");
}

} // namespace

std::string place(const Origin &origin, const std::vector<std::string> &path) {
  if (origin.kind == Origin::Kind::override)
    return origin.source;
  std::string file = origin.source;
  if (origin.line > 0)
    file += ":" + std::to_string(origin.line);
  if (path.empty())
    return file;
  if (origin.kind == Origin::Kind::json)
    return file + ": \"" + join(path, "\"/\"") + "\"";
  return file + ": " + join(path, " / ");
}

void refuse_value(const Origin &origin, const std::vector<std::string> &path,
                  const std::string &value, const std::string &problem) {
  const char *equals = origin.kind == Origin::Kind::override ? "=" : " = ";
  throw InputError(message(shortened(place(origin, path), longest_place) + equals +
                               shortened(value, longest_value),
                           problem));
}

void refuse_place(const Origin &origin, const std::vector<std::string> &path,
                  const std::string &problem) {
  throw InputError(message(shortened(place(origin, path), longest_place), problem));
}

} // namespace vibroimpact::parameters
