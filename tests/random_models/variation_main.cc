// random_variations FOLDER FIRST NUMBER: judges the variation of models FIRST, FIRST + 1, ..., a
// line each, and sums up by law and kind of event. Exit code 1 when one is wrong, or too few could
// be judged to say anything. FOLDER takes the record.
#include "random_models/random_model.h"
#include "random_models/random_variation.h"

#include <slepcsys.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>

using namespace vibroimpact::testing;

namespace {

struct Summary {
  int models = 0;
  double by_state = 0, by_key = 0, determinant = 0;

  void add(const VariationVerdict &verdict) {
    ++models;
    by_state = std::max(by_state, verdict.by_state);
    by_key = std::max(by_key, verdict.by_key);
    determinant = std::max(determinant, verdict.determinant); // not of NaN
  }
};

std::string list_of(const std::set<std::string> &names) {
  std::string text;
  for (const std::string &name : names)
    text += (text.empty() ? "" : ", ") + name;
  return text;
}

void print(std::uint64_t seed, const VariationVerdict &verdict) {
  std::string detail = verdict.detail;
  std::replace(detail.begin(), detail.end(), '\n', ' ');
  std::cout << seed << '\t' << verdict.word << '\t' << verdict.by_state << '\t' << verdict.by_key
            << '\t' << verdict.determinant << '\t' << verdict.open << '\t' << verdict.cost << '\t'
            << verdict.events << '\t' << verdict.columns << '\t' << verdict.keys << '\t'
            << list_of(verdict.laws) << '\t' << list_of(verdict.kinds) << '\t' << detail
            << std::endl;
}

bool judge_all(const std::string &folder, std::uint64_t first, std::uint64_t number) {
  std::map<std::string, int> words;
  std::map<std::string, Summary> summaries;
  std::cout << "model\tverdict\tby state\tby key\tdeterminant\topen\tcost\tevents\tcolumns\tkeys\t"
               "laws\tkinds\tdetail"
            << std::endl;
  for (std::uint64_t seed = first; seed < first + number; ++seed) {
    const VariationVerdict verdict = judge_variation(seed, folder);
    print(seed, verdict);
    ++words[verdict.word];
    if (verdict.word != "agree")
      continue;
    summaries["all"].add(verdict);
    for (const std::string &law : verdict.laws)
      summaries[law].add(verdict);
    for (const std::string &kind : verdict.kinds)
      summaries["event: " + kind].add(verdict);
  }
  for (const auto &[word, count] : words)
    std::cout << count << " " << word << "\n";
  for (const auto &[name, summary] : summaries)
    std::cout << name << ": " << summary.models << " models, largest difference by state "
              << summary.by_state << ", by key " << summary.by_key << ", of ln determinant "
              << summary.determinant << "\n";
  return words["wrong"] == 0 && 2 * words["agree"] >= static_cast<int>(number);
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 4)
    return 1;
  const std::string folder = argv[1];
  char program[] = "random_variations";
  char skip[] = "-skip_petscrc";
  char *arguments[] = {program, skip, nullptr};
  int count = 2;
  char **private_arguments = arguments;
  if (SlepcInitialize(&count, &private_arguments, nullptr, nullptr) != 0)
    return 1;
  write_record(folder + "/" + record_name);
  const bool good =
      judge_all(folder, std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
  SlepcFinalize();
  return good ? 0 : 1;
}
