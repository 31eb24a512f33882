// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

namespace stiction::track {

namespace {

constexpr int kNotFound = 127;

// Both ends are closed at exec, so that no child keeps another's pipe open.
class Pipe {
 public:
  Pipe() {
    if (pipe2(end_.data(), O_CLOEXEC) != 0) {
      throw TrackError(std::string("no pipe to a child process: ") + std::strerror(errno));
    }
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int end(std::size_t which) const { return end_[which]; }
  void close_end(std::size_t which) {
    if (end_[which] >= 0) close(end_[which]);
    end_[which] = -1;
  }

 private:
  std::array<int, 2> end_{-1, -1};
};

[[noreturn]] void become(char* const* words, const char* folder, int output, int errors) {
  if (*folder != '\0' && chdir(folder) != 0) _exit(kNotFound);
  // The caller of this program does not ask for what its children write.
  unsetenv("STICTION_RUN_FILE");
  const int input = open("/dev/null", O_RDONLY);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  execvp(words[0], words);
  _exit(kNotFound);
}

void drain(Pipe& output, Pipe& errors, Ended& ended) {
  std::array<pollfd, 2> waiting = {pollfd{output.end(0), POLLIN, 0},
                                   pollfd{errors.end(0), POLLIN, 0}};
  const std::array<std::string*, 2> texts = {&ended.output, &ended.errors};
  std::array<char, 65536> buffer;
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    if (poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) return;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].fd < 0 || waiting[i].revents == 0) continue;
      const ssize_t count = read(waiting[i].fd, buffer.data(), buffer.size());
      if (count > 0) texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR)) waiting[i].fd = -1;
    }
  }
}

}  // namespace

Ended run(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Pipe output, errors;
  const pid_t child = fork();
  if (child < 0) throw TrackError(std::string("no child process: ") + std::strerror(errno));
  if (child == 0) become(arguments.data(), folder.c_str(), output.end(1), errors.end(1));
  output.close_end(1);
  errors.close_end(1);
  Ended ended;
  drain(output, errors, ended);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
}

std::string demand_run(const std::string& what, const std::vector<std::string>& words,
                       const std::filesystem::path& folder) {
  const Ended ended = run(words, folder);
  if (ended.code == 0) return ended.output;
  std::string reason = last_line(ended.errors);
  if (reason.empty()) reason = last_line(ended.output);
  if (reason.empty()) reason = words.front() + " ended with code " + std::to_string(ended.code);
  throw TrackError(what + ": " + reason);
}

bool has_program(const std::string& name) { return run({name, "--version"}).code == 0; }

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  if (end == std::string::npos) return "";
  const std::size_t before = text.find_last_of('\n', end);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return text.substr(start, end + 1 - start);
}

}  // namespace stiction::track
