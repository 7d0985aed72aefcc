// random_orbits FOLDER LEAST SEEDS...: judges the multipliers of the orbits of random models,
// single ones or as 3-17, a line each. Exit code 1 when some differ, when the motion along an orbit
// that the analysis has found fails, or when fewer than LEAST can be compared. FOLDER takes the
// record.
#include "random_models/random_model.h"
#include "random_models/random_orbit.h"
#include "random_models/random_text.h"
#include "support/slepc_session.h"

#include <algorithm>
#include <iostream>
#include <map>

using namespace vibroimpact::testing;

namespace {

bool is_equal(const std::string &word) { return word.starts_with("equal"); }

bool judge_all(const std::string &folder, int least, const std::vector<std::uint64_t> &seeds) {
  std::map<std::string, int> words, laws;
  double largest = 0;
  std::cout
      << "model\tverdict\tapart\tpolynomial\tbound\topen\tstable\tsymmetric\tperiods\tevents\t"
         "laws\tdetail"
      << std::endl;
  for (const std::uint64_t seed : seeds) {
    const OrbitVerdict verdict = judge_orbit(seed, folder);
    std::string detail = verdict.detail;
    std::replace(detail.begin(), detail.end(), '\n', ' ');
    std::cout << seed << '\t' << verdict.word << '\t' << verdict.spectra.apart << '\t'
              << verdict.spectra.polynomial << '\t' << verdict.spectra.bound << '\t' << verdict.open
              << '\t' << verdict.stable << '\t' << verdict.symmetric << '\t' << verdict.multiple
              << '\t' << verdict.events << '\t' << joined(verdict.laws) << '\t' << detail
              << std::endl;
    ++words[verdict.word];
    if (verdict.word == "equal")
      largest = std::max(largest, verdict.spectra.apart);
    if (is_equal(verdict.word))
      for (const std::string &law : verdict.laws)
        ++laws[law];
  }
  int equal = 0;
  for (const auto &[word, count] : words) {
    std::cout << count << " " << word << "\n";
    equal += is_equal(word) ? count : 0;
  }
  std::cout << "largest difference one by one: " << largest << "\n";
  for (const auto &[law, count] : laws)
    std::cout << count << " of " << law << "\n";
  return words["different"] == 0 && words["failed"] == 0 && equal >= least;
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 4)
    return 1;
  const std::string folder = argv[1];
  const std::vector<std::uint64_t> seeds = seeds_of({argv + 3, argv + argc});
  const SlepcSession session("random_orbits");
  write_record(folder + "/" + record_name);
  return judge_all(folder, std::stoi(argv[2]), seeds) ? 0 : 1;
}
