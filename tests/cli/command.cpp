#include "tests/cli/command.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace wedgesim::cli {
namespace {

constexpr const char* kProgram = WEDGESIM_BINARY_DIR "/cli/wedgesim";

[[noreturn]] void become(const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(kProgram)};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execv(kProgram, words.data());
  _exit(127);
}

int exit_code(pid_t child) {
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// A pipe's or terminal's bytes until its other end closes.
std::string read_all(int file) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = read(file, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  close(file);
  return text;
}

// A nameless file that a child writes to.
class Capture {
 public:
  Capture() : file_(std::tmpfile()) { EXPECT_NE(file_, nullptr); }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;
  ~Capture() { std::fclose(file_); }
  int file() const { return fileno(file_); }
  std::string text() const {
    const int copy = dup(file());
    lseek(copy, 0, SEEK_SET);
    return read_all(copy);
  }

 private:
  std::FILE* file_;
};

std::string joined(const std::vector<std::string>& arguments) {
  std::string text = "wedgesim";
  for (const std::string& argument : arguments) text += ' ' + argument;
  return text;
}

}  // namespace

Outcome run_command(const std::vector<std::string>& arguments) {
  const Capture out;
  const Capture err;
  const pid_t child = fork();
  if (child == 0) {
    dup2(out.file(), STDOUT_FILENO);
    dup2(err.file(), STDERR_FILENO);
    become(arguments);
  }
  Outcome outcome;
  outcome.command = joined(arguments);
  outcome.code = exit_code(child);
  outcome.out = out.text();
  outcome.err = err.text();
  return outcome;
}

Outcome run_on_terminal(const std::vector<std::string>& arguments) {
  int master = -1;
  int terminal = -1;
  EXPECT_EQ(openpty(&master, &terminal, nullptr, nullptr, nullptr), 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(terminal, STDERR_FILENO);
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    become(arguments);
  }
  close(terminal);
  Outcome outcome;
  outcome.command = joined(arguments);
  outcome.err = read_all(master);
  outcome.code = exit_code(child);
  return outcome;
}

Outcome run_into(const std::filesystem::path& out, const std::vector<std::string>& arguments) {
  const Capture err;
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(out.c_str(), O_WRONLY), STDOUT_FILENO);
    dup2(err.file(), STDERR_FILENO);
    become(arguments);
  }
  Outcome outcome;
  outcome.command = joined(arguments);
  outcome.code = exit_code(child);
  outcome.err = err.text();
  return outcome;
}

Outcome interrupt_command(const std::filesystem::path& folder, int signal,
                          const std::vector<std::string>& arguments) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("TMPDIR", folder.c_str(), 1);
    become(arguments);
  }
  for (int i = 0; i < 3000 && std::filesystem::is_empty(folder); ++i) usleep(10000);
  EXPECT_FALSE(std::filesystem::is_empty(folder));
  kill(child, signal);
  Outcome outcome;
  outcome.command = joined(arguments);
  outcome.code = exit_code(child);
  return outcome;
}

Outcome kill_command(unsigned milliseconds, int signal, const std::vector<std::string>& arguments) {
  const Capture err;
  const pid_t child = fork();
  if (child == 0) {
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    dup2(err.file(), STDERR_FILENO);
    become(arguments);
  }
  usleep(1000 * milliseconds);
  kill(child, signal);
  Outcome outcome;
  outcome.command = joined(arguments);
  outcome.code = exit_code(child);
  outcome.err = err.text();
  return outcome;
}

void expect_bad_input(const Outcome& outcome, const std::vector<std::string>& words) {
  SCOPED_TRACE(outcome.command);
  EXPECT_EQ(outcome.code, 2) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with('\n')) << outcome.err;
  for (const std::string& word : words) {
    EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " is not in: " << outcome.err;
  }
}

void expect_good(const Outcome& outcome) {
  SCOPED_TRACE(outcome.command);
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  EXPECT_TRUE(out) << path;
}

std::filesystem::path make_trace(const TemporaryFolder& folder, const std::string& scene,
                                 const std::vector<std::string>& options) {
  std::filesystem::path file = folder / (scene + ".wtrace");
  std::vector<std::string> arguments{"trace", scene, "-o", file.string(), "--size", "96x64"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  expect_good(run_command(arguments));
  return file;
}

}  // namespace wedgesim::cli
