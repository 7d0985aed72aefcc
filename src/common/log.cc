#include "common/log.h"

#include <fstream>
#include <iostream>

namespace vibroimpact::log {

namespace {

int this_rank = 0;
std::ofstream log_file;

void print(const std::string &line) {
  if (this_rank != 0)
    return;
  std::cout << line << std::endl;
  if (log_file.is_open())
    log_file << line << std::endl;
}

} // namespace

void set_rank(int rank) { this_rank = rank; }

void open_file(const std::string &file) {
  if (this_rank != 0)
    return;
  log_file.close();
  if (!file.empty())
    log_file.open(file, std::ios::app);
}

void info(const std::string &message) { print(message); }

void warning(const std::string &message) { print("warning: " + message); }

} // namespace vibroimpact::log
