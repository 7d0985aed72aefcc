// Runs the program many times without loading its libraries anew: a process that has loaded them,
// but started none, forks for each command line. Requests are lines of JSON on the standard input,
//
//   {"arguments": ["beams.prm", "--check"], "folder": "/tmp/here", "stdout": "out", "stderr":
//   "err",
//    "seconds": 20, "megabytes": 4000, "file_bytes": 0}
//
// with the arguments behind the program's name, the folder to run in, the files that take what is
// printed, and limits of processor time, of address space and of the size of a file (0: none). The
// answer is a line as well,
//
//   {"code": 0, "signal": 0, "timed_out": 0, "seconds": 0.21, "peak_megabytes": 63.5}
//
// code -1 with the signal that ended it. A run that reaches the limit of time, or ten times that by
// the clock, gets SIGTERM, and SIGKILL if it is still there five seconds later.
// support/fork_server.py speaks this.
#include "program.h"

#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <iostream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

struct Request {
  std::vector<std::string> arguments{"vibroimpact"};
  std::string folder, standard_output, standard_error;
  double seconds = 0;
  double megabytes = 0;
  double file_bytes = 0;
};

struct Answer {
  int status = 0;
  bool timed_out = false;
  double seconds = 0;
  double peak_megabytes = 0;
};

Request read_request(const std::string &line) {
  boost::property_tree::ptree tree;
  std::istringstream stream(line);
  boost::property_tree::read_json(stream, tree);
  Request request{.folder = tree.get<std::string>("folder"),
                  .standard_output = tree.get<std::string>("stdout"),
                  .standard_error = tree.get<std::string>("stderr"),
                  .seconds = tree.get<double>("seconds"),
                  .megabytes = tree.get<double>("megabytes"),
                  .file_bytes = tree.get<double>("file_bytes")};
  for (const auto &argument : tree.get_child("arguments"))
    request.arguments.push_back(argument.second.data());
  return request;
}

void expect(bool done, const char *what) {
  if (done)
    return;
  std::perror(what);
  std::_Exit(125);
}

void redirect(int descriptor, const char *file, int how) {
  const int opened = open(file, how, 0644);
  expect(opened >= 0 && dup2(opened, descriptor) >= 0 && close(opened) == 0, file);
}

void limit(decltype(RLIMIT_AS) what, double bytes) {
  const auto most = static_cast<rlim_t>(bytes);
  const rlimit limit{.rlim_cur = most, .rlim_max = most};
  expect(bytes == 0 || setrlimit(what, &limit) == 0, "setrlimit");
}

/// In the child: never returns.
[[noreturn]] void run(Request request) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  setpgid(0, 0);
  expect(chdir(request.folder.c_str()) == 0, request.folder.c_str());
  redirect(0, "/dev/null", O_RDONLY);
  redirect(1, request.standard_output.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  redirect(2, request.standard_error.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  limit(RLIMIT_AS, request.megabytes * 1e6);
  limit(RLIMIT_FSIZE, request.file_bytes);
  signal(SIGXFSZ, SIG_IGN); // a write beyond it fails, as on a full disk
  std::vector<char *> arguments;
  for (std::string &argument : request.arguments)
    arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  std::exit(vibroimpact::run_program(static_cast<int>(request.arguments.size()), arguments.data()));
}

/// Waits for the child's end, at most so long (0: for ever); false when it runs on.
bool ends_within(double seconds) {
  sigset_t child;
  sigemptyset(&child);
  sigaddset(&child, SIGCHLD);
  const timespec limit{.tv_sec = static_cast<time_t>(seconds),
                       .tv_nsec = static_cast<long>(1e9 * (seconds - std::floor(seconds)))};
  return (seconds > 0 ? sigtimedwait(&child, nullptr, &limit) : sigwaitinfo(&child, nullptr)) > 0;
}

double processor_time(pid_t child) {
  clockid_t clock{};
  timespec used{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &used) != 0)
    return 0; // it has just ended
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

/// The same, of processor time: how much else the machine does decides nothing.
bool ends_within_processor_time(pid_t child, double seconds) {
  constexpr double look = 0.25; // [s]
  const int most_looks = static_cast<int>(10 * seconds / look);
  for (int looks = 0; seconds == 0 || looks <= most_looks; ++looks) {
    if (ends_within(seconds > 0 ? look : 0))
      return true;
    if (seconds > 0 && processor_time(child) > seconds)
      return false;
  }
  return false;
}

Answer performed(const Request &request) {
  const pid_t child = fork();
  expect(child >= 0, "fork");
  if (child == 0)
    run(request);
  setpgid(child, child); // whoever comes first, child or parent
  Answer answer{.timed_out = !ends_within_processor_time(child, request.seconds)};
  if (answer.timed_out) {
    kill(-child, SIGTERM);
    if (!ends_within(5)) {
      kill(-child, SIGKILL);
      ends_within(0);
    }
  }
  rusage usage{};
  expect(wait4(child, &answer.status, 0, &usage) == child, "wait4");
  for (const timeval &used : {usage.ru_utime, usage.ru_stime})
    answer.seconds += static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_usec);
  answer.peak_megabytes = static_cast<double>(usage.ru_maxrss) * 1024e-6;
  return answer;
}

void print(const Answer &answer) {
  const bool exited = WIFEXITED(answer.status);
  std::cout << R"({"code": )" << (exited ? WEXITSTATUS(answer.status) : -1) << R"(, "signal": )"
            << (exited ? 0 : WTERMSIG(answer.status)) << R"(, "timed_out": )" << answer.timed_out
            << R"(, "seconds": )" << answer.seconds << R"(, "peak_megabytes": )"
            << answer.peak_megabytes << "}" << std::endl;
}

} // namespace

int main() {
  // A process that mpirun did not start would first start a daemon of Open MPI, 0.4 s, and look for
  // networks, 0.2 s. Processes that start and end at the same time take a folder from each other.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
  setenv("OMPI_MCA_btl", "self", 0);
  setenv("OMPI_MCA_mtl", "^ofi", 0);
  setenv("OMPI_MCA_osc", "^ucx", 0);
  sigset_t child;
  sigemptyset(&child);
  sigaddset(&child, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child, nullptr);
  for (std::string line; std::getline(std::cin, line);)
    print(performed(read_request(line)));
  return 0;
}
