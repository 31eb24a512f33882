// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/child.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

#include "reference/process/interruption.h"
#include "reference/process/pipe.h"

namespace stiction::reference {

namespace {

constexpr int kMeanwhile = 200;  // ms

// For poll, ms.
int wait(const Deadline& deadline, const ChildOptions& options) {
  const int left = deadline.wait();
  if (!options.meanwhile) return left;
  return left < 0 ? kMeanwhile : std::min(left, kMeanwhile);
}

// Reads until the child has closed both, or its time is over.
void drain(Pipe& output, Pipe& errors, const Deadline& deadline, const ChildOptions& options,
           Ended& ended) {
  const auto began = std::chrono::steady_clock::now();
  std::array<pollfd, 2> waiting = {pollfd{output.end(0), POLLIN, 0},
                                   pollfd{errors.end(0), POLLIN, 0}};
  const std::array<std::string*, 2> texts = {&ended.output, &ended.errors};
  std::array<char, 65536> buffer;
  while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
    if (deadline.passed()) {
      ended.timed_out = true;
      return;
    }
    if (options.meanwhile) {
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - began;
      options.meanwhile(seconds.count(), ended);
    }
    if (poll(waiting.data(), waiting.size(), wait(deadline, options)) < 0) {
      if (errno == EINTR) continue;
      return;
    }
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].fd < 0 || waiting[i].revents == 0) continue;
      const ssize_t count = read(waiting[i].fd, buffer.data(), buffer.size());
      if (count > 0) texts[i]->append(buffer.data(), static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR)) waiting[i].fd = -1;
    }
  }
}

// A child may have closed both pipes and go on.
void await(pid_t child, const Deadline& deadline, Ended& ended) {
  int status = 0;
  while (true) {
    if (ended.timed_out) kill(child, SIGKILL);
    const bool may_wait = deadline.wait() < 0 || ended.timed_out;
    const pid_t answer = waitpid(child, &status, may_wait ? 0 : WNOHANG);
    const int number = errno;
    if (answer == child || (answer < 0 && number != EINTR)) forget_child(child);
    if (answer == child) break;
    if (answer < 0 && number != EINTR) fail("a child process is lost", number);
    if (answer == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ended.timed_out = ended.timed_out || deadline.passed();
  }
  ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  ended.code = ended.signal == 0 ? WEXITSTATUS(status) : kSignalled + ended.signal;
}

}  // namespace

Ended run_child(const std::vector<std::string>& words, const ChildOptions& options) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::vector<char*> variables = environment_of_child();
  Pipe output, errors;
  Actions actions;
  if (!options.folder.empty()) {
    posix_spawn_file_actions_addchdir_np(actions.get(), options.folder.c_str());
  }
  posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(actions.get(), output.end(1), STDOUT_FILENO);
  if (!options.show_errors) {
    posix_spawn_file_actions_adddup2(actions.get(), errors.end(1), STDERR_FILENO);
  }
  const Deadline deadline(options.time_limit);
  pid_t child = 0;
  Attributes attributes;
  set_up_child(attributes.get());
  int wrong = 0;
  start_child([&] {
    wrong = posix_spawnp(&child, arguments[0], actions.get(), attributes.get(), arguments.data(),
                         variables.data());
    return wrong == 0 ? child : 0;
  });
  Ended ended;
  if (wrong == EAGAIN || wrong == ENOMEM) fail("no child process", wrong);
  if (wrong != 0) {
    ended.code = kNoSuchProgram;
    return ended;
  }
  output.close_end(1);
  errors.close_end(1);
  drain(output, errors, deadline, options, ended);
  await(child, deadline, ended);
  return ended;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  if (end == std::string::npos) return "";
  const std::size_t before = text.find_last_of('\n', end);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return text.substr(start, end + 1 - start);
}

std::filesystem::path folder_of_this_program() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
}

std::filesystem::path find_program(const std::string& name,
                                   const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path file = folder / name;
    std::error_code none;
    const bool there = !folder.empty() && std::filesystem::is_regular_file(file, none);
    if (there && access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

std::vector<std::filesystem::path> folders_of_path() {
  std::vector<std::filesystem::path> folders;
  const char* const path = std::getenv("PATH");
  std::istringstream stream(path != nullptr ? path : "");
  for (std::string folder; std::getline(stream, folder, ':');) folders.emplace_back(folder);
  return folders;
}

}  // namespace stiction::reference
