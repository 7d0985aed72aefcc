// random_models FOLDER FIRST NUMBER: judges models FIRST, FIRST + 1, ..., a line each as soon as it
// is known; random_models FOLDER FIRST NUMBER FILES... the parameter files of these places in the
// list; random_models FOLDER --print SEED prints a model as a parameter file. FOLDER takes the
// record.
#include "random_models/judge_model.h"
#include "support/slepc_session.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

using namespace vibroimpact::testing;

namespace {

std::string text_of(const std::string &file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void judge_all(const std::string &folder, std::uint64_t first, std::uint64_t number,
               const std::vector<std::string> &files) {
  for (std::uint64_t seed = first; seed < first + number; ++seed) {
    Verdict verdict =
        files.empty() ? judge_model(seed, folder) : judge_text(text_of(files.at(seed)), folder);
    std::replace(verdict.detail.begin(), verdict.detail.end(), '\n', ' ');
    std::cout << seed << '\t' << verdict.word << '\t' << verdict.seconds << '\t'
              << verdict.energy_residual << '\t' << verdict.detail << std::endl;
  }
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 4)
    return 1;
  const std::string folder = argv[1];
  if (std::strcmp(argv[2], "--print") == 0) {
    std::cout << random_model({.seed = std::strtoull(argv[3], nullptr, 10)});
    return 0;
  }
  const SlepcSession session("random_models");
  write_record(folder + "/" + record_name);
  judge_all(folder, std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10),
            {argv + 4, argv + argc});
  return 0;
}
