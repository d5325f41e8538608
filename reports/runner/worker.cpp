#include "reports/runner/worker.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace wedgesim::reports {
namespace {

bool write_line(int file, const std::string& text) {
  const std::string line = text + '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t n = write(file, line.data() + done, line.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

// Whole lines of what can be read at once; false at the end of the file.
bool read_lines(int file, std::string& text, std::vector<Json>& lines) {
  std::array<char, 65536> buffer;
  const ssize_t n = read(file, buffer.data(), buffer.size());
  if (n < 0 && errno == EINTR) return true;
  if (n <= 0) return false;
  text.append(buffer.data(), static_cast<std::size_t>(n));
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    lines.push_back(Json::parse(std::string_view(text).substr(begin, end - begin)));
  }
  text.erase(0, begin);
  return true;
}

[[noreturn]] void serve_jobs(int jobs, int answers, const Worker::Serve& serve) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Worker::Answer answer = [answers](const Json& json) {
    if (!write_line(answers, json.dump())) _exit(0);
  };
  std::string text;
  std::vector<Json> lines;
  while (read_lines(jobs, text, lines)) {
    for (const Json& job : lines) serve(job, answer);
    lines.clear();
  }
  _exit(0);
}

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a worker");
    read = ends[0];
    write = ends[1];
  }
};

}  // namespace

Worker::Worker(const Serve& serve) {
  const Pipe jobs;
  const Pipe answers;
  const pid_t parent = getpid();
  std::fflush(nullptr);
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("no process for a worker");
  if (process_ == 0) {
    // With the parent: as by a signal that lets temporary files be removed.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(0);
    close(jobs.write);
    close(answers.read);
    try {
      serve_jobs(jobs.read, answers.write, serve);
    } catch (const std::exception& error) {
      fmt::print(stderr, "internal error in a worker: {}\n", error.what());
      _exit(1);
    }
  }
  close(jobs.read);
  close(answers.write);
  jobs_ = jobs.write;
  answers_ = answers.read;
}

Worker::~Worker() {
  end();
  close(jobs_);
  close(answers_);
}

void Worker::send(const Json& job) {
  // A worker that is gone shows as the end of its answers.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  write_line(jobs_, job.dump());
  std::signal(SIGPIPE, before);
}

std::vector<Json> Worker::answers() {
  std::vector<Json> lines;
  if (!read_lines(answers_, text_, lines)) ended_ = true;
  return lines;
}

std::string Worker::end() {
  if (process_ < 0) return {};
  if (!ended_) kill(process_, SIGKILL);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (WIFSIGNALED(status)) {
    return fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return fmt::format("exit code {}", WEXITSTATUS(status));
}

}  // namespace wedgesim::reports
