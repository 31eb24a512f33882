// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/conversation.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>
#include <thread>
#include <utility>

#include "reference/process/interruption.h"

namespace stiction::reference {

namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 28;  // bytes
constexpr std::size_t kSaidKept = 4096;                     // bytes of stderr
constexpr std::size_t kQuoted = 80;                         // bytes of what it said
constexpr double kToEndByItself = 0.5;                      // s

// Writing to a program that has ended raises SIGPIPE in this thread; here it is an error to read off
// errno.
class WithoutSigpipe {
 public:
  WithoutSigpipe() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutSigpipe() {
    const timespec at_once{};
    while (sigtimedwait(&pipe_, nullptr, &at_once) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutSigpipe(const WithoutSigpipe&) = delete;
  WithoutSigpipe& operator=(const WithoutSigpipe&) = delete;

 private:
  sigset_t pipe_, before_;
};

// A group of its own, so that what it starts ends with it, and signals as a program expects them.
void set_up_engine(posix_spawnattr_t* attributes) {
  sigset_t all, none;
  sigfillset(&all);
  sigemptyset(&none);
  posix_spawnattr_setsigdefault(attributes, &all);
  posix_spawnattr_setsigmask(attributes, &none);
  posix_spawnattr_setpgroup(attributes, 0);
  posix_spawnattr_setflags(attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
}

void set_nonblocking(int end) { fcntl(end, F_SETFL, fcntl(end, F_GETFL) | O_NONBLOCK); }

std::string quoted(std::string text) {
  if (text.size() > kQuoted) text = text.substr(0, kQuoted) + "…";
  for (char& sign : text) {
    if (static_cast<unsigned char>(sign) < 32) sign = ' ';
  }
  return "'" + text + "'";
}

}  // namespace

Conversation::Conversation(std::vector<std::string> words, const ConversationLimits& limits)
    : limits_(limits) {
  if (words.empty()) throw ChildError("no program was named");
  start(words);
}

void Conversation::start(std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::vector<char*> variables = environment_of_child();
  Actions actions;
  posix_spawn_file_actions_adddup2(actions.get(), input_.end(0), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(actions.get(), output_.end(1), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(actions.get(), errors_.end(1), STDERR_FILENO);
  Attributes attributes;
  set_up_engine(attributes.get());
  int wrong = 0;
  start_child([&] {
    wrong = posix_spawnp(&child_, arguments[0], actions.get(), attributes.get(), arguments.data(),
                         variables.data());
    return wrong == 0 ? child_ : 0;
  });
  if (wrong != 0) {
    child_ = -1;
    fail(fmt::format("'{}' cannot be started", words[0]), wrong);
  }
  if (limits_.memory_bytes > 0) {
    const rlimit most{limits_.memory_bytes, limits_.memory_bytes};
    prlimit(child_, RLIMIT_DATA, &most, nullptr);
  }
  input_.close_end(0);
  output_.close_end(1);
  errors_.close_end(1);
  for (const int end : {input_.end(1), output_.end(0), errors_.end(0)}) set_nonblocking(end);
}

Conversation::~Conversation() {
  if (child_ < 0) return;
  input_.close_end(1);
  const Deadline deadline(kToEndByItself);
  while (reap(false) < 0 && child_ > 0 && !deadline.passed()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (child_ > 0) reap(true);
}

// Its wait status once it has ended, else −1; `at_once`: it is killed first, and what it started.
int Conversation::reap(bool at_once) {
  if (at_once) kill(-child_, SIGKILL);
  int status = 0;
  pid_t answer = 0;
  do {
    answer = waitpid(child_, &status, at_once ? 0 : WNOHANG);
  } while (answer < 0 && errno == EINTR);
  if (answer == 0) return -1;
  forget_child(child_);
  if (!at_once) kill(-child_, SIGKILL);  // what it has left behind
  child_ = -1;
  return answer < 0 ? 0 : status;
}

std::string Conversation::ask(const std::string& line) {
  if (child_ < 0) throw ChildError("the program has ended");
  read_some(1);
  if (!heard_.empty()) refuse("said " + quoted(heard_) + " without being asked");
  const Deadline deadline(limits_.reply_seconds);
  const WithoutSigpipe quietly;
  std::string rest = line + "\n", answer;
  while (!take_line(answer)) {
    if (deadline.passed()) {
      refuse(fmt::format("gave no answer within {:.3g} s", limits_.reply_seconds));
    }
    std::array<pollfd, 3> waiting = {pollfd{output_.end(0), POLLIN, 0},
                                     pollfd{errors_.end(0), POLLIN, 0},
                                     pollfd{rest.empty() ? -1 : input_.end(1), POLLOUT, 0}};
    if (poll(waiting.data(), waiting.size(), deadline.wait()) < 0 && errno != EINTR) {
      refuse(std::string("cannot be listened to: ") + std::strerror(errno));
    }
    if (waiting[1].revents != 0) read_some(2);
    if (waiting[0].revents != 0) read_some(1);
    if (waiting[2].revents != 0) write_some(rest);
    if (output_.end(0) < 0 && heard_.empty()) ended();
    if (output_.end(0) < 0 && heard_.find('\n') == std::string::npos) {
      refuse("ended in the middle of the line " + quoted(heard_));
    }
  }
  return answer;
}

void Conversation::write_some(std::string& rest) {
  const ssize_t count = write(input_.end(1), rest.data(), rest.size());
  if (count > 0) rest.erase(0, static_cast<std::size_t>(count));
  // It no longer listens: what it has said, or its end, tells more than this.
  if (count < 0 && errno != EAGAIN && errno != EINTR) rest.clear();
}

// stdout or stderr, what is there now.
void Conversation::read_some(int which) {
  Pipe& pipe = which == 1 ? output_ : errors_;
  std::string& text = which == 1 ? heard_ : said_;
  std::array<char, 65536> buffer;
  while (pipe.end(0) >= 0) {
    const ssize_t count = read(pipe.end(0), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return;
    if (count <= 0) {
      pipe.close_end(0);
      return;
    }
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (which == 2 && text.size() > kSaidKept) text.erase(0, text.size() - kSaidKept);
    if (which == 1 && text.size() > kLongestLine) {
      refuse(fmt::format("said more than {} MiB in one answer", kLongestLine >> 20));
    }
    if (which == 1 && text.find('\n') != std::string::npos) return;
  }
}

bool Conversation::take_line(std::string& line) {
  const std::size_t end = heard_.find('\n');
  if (end == std::string::npos) return false;
  line = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return true;
}

// It has closed its stdout.
void Conversation::ended() {
  const Deadline deadline(kToEndByItself);
  int status = -1;
  while ((status = reap(false)) < 0 && child_ > 0 && !deadline.passed()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  read_some(2);
  if (child_ > 0) refuse("closed its output and went on");
  if (WIFSIGNALED(status)) {
    refuse(
        fmt::format("was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status))));
  }
  refuse(fmt::format("ended with exit code {}", WEXITSTATUS(status)));
}

void Conversation::refuse(const std::string& what) {
  if (child_ > 0) reap(true);
  read_some(2);
  const std::string last = last_line(said_);
  throw ChildError(last.empty() ? what : what + "; its last words: " + quoted(last));
}

double Conversation::cpu_seconds() const {
  clockid_t clock{};
  timespec now{};
  if (child_ < 0 || clock_getcpuclockid(child_, &clock) != 0 || clock_gettime(clock, &now) != 0) {
    return 0.0;
  }
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::optional<std::int64_t> Conversation::resident_memory() const {
  if (child_ < 0) return std::nullopt;
  std::ifstream told(fmt::format("/proc/{}/statm", child_));
  std::int64_t size = 0, resident = 0;  // pages
  if (!(told >> size >> resident)) return std::nullopt;
  return resident * sysconf(_SC_PAGESIZE);
}

}  // namespace stiction::reference
