// random_variations FOLDER SEEDS...: judges the variation of models, of single ones or as 3-17, a
// line each, and sums up by law and kind of event. Exit code 1 when one is wrong or cannot be
// judged, or too few agree to say anything. FOLDER takes the record.
#include "random_models/random_model.h"
#include "random_models/random_text.h"
#include "random_models/random_variation.h"
#include "support/slepc_session.h"

#include <algorithm>
#include <iostream>
#include <map>

using namespace vibroimpact::testing;

namespace {

struct Summary {
  int models = 0;
  double column = 0, determinant = 0, multipliers = 0;

  void add(const VariationVerdict &verdict) {
    ++models;
    column = std::max(column, verdict.largest());
    determinant = std::max(determinant, verdict.determinant); // not of NaN
    if (verdict.multipliers.word == "equal")
      multipliers = std::max(multipliers, verdict.multipliers.apart);
  }
};

void print(std::uint64_t seed, const VariationVerdict &verdict) {
  std::string detail = verdict.detail;
  std::replace(detail.begin(), detail.end(), '\n', ' ');
  const SpectraVerdict &spectra = verdict.multipliers;
  std::cout << seed << '\t' << verdict.word << '\t' << verdict.largest() << '\t'
            << verdict.found.size() << '\t' << verdict.determinant << '\t' << spectra.word << '\t'
            << spectra.apart << '\t' << spectra.polynomial << '\t' << spectra.bound << '\t'
            << verdict.cost << '\t' << verdict.window << '\t' << verdict.events << '\t'
            << joined(verdict.laws) << '\t' << joined(verdict.kinds) << '\t' << detail << std::endl;
}

bool judge_all(const std::string &folder, const std::vector<std::uint64_t> &seeds) {
  std::map<std::string, int> words, spectra;
  std::map<std::string, Summary> summaries;
  std::cout << "model\tverdict\tlargest\tcolumns\tdeterminant\tmultipliers\tapart\tpolynomial\t"
               "bound\tcost\twindow\tevents\tlaws\tkinds\tdetail"
            << std::endl;
  for (const std::uint64_t seed : seeds) {
    const VariationVerdict verdict = judge_variation(seed, folder);
    print(seed, verdict);
    ++words[verdict.word];
    if (!verdict.multipliers.word.empty())
      ++spectra["multipliers " + verdict.multipliers.word];
    if (verdict.word != "agree")
      continue;
    summaries["all"].add(verdict);
    for (const std::string &law : verdict.laws)
      summaries[law].add(verdict);
    for (const std::string &kind : verdict.kinds)
      summaries["event: " + kind].add(verdict);
  }
  for (const auto &counts : {words, spectra})
    for (const auto &[word, count] : counts)
      std::cout << count << " " << word << "\n";
  for (const auto &[name, summary] : summaries)
    std::cout << name << ": " << summary.models << " models, largest difference of a column "
              << summary.column << ", of ln determinant " << summary.determinant
              << ", of multipliers that are equal one by one " << summary.multipliers << "\n";
  const int agree = words["agree"] + words["agree but for rounding"];
  const auto judged = static_cast<std::size_t>(agree + words["no derivative"] + words["refused"]);
  return judged == seeds.size() && 2 * words["agree"] >= static_cast<int>(seeds.size());
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 3)
    return 1;
  const std::string folder = argv[1];
  const std::vector<std::uint64_t> seeds = seeds_of({argv + 2, argv + argc});
  const SlepcSession session("random_variations");
  write_record(folder + "/" + record_name);
  return judge_all(folder, seeds) ? 0 : 1;
}
