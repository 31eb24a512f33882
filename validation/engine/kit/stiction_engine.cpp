// SPDX-License-Identifier: BSD-3-Clause
#include "validation/engine/kit/stiction_engine.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "validation/engine/kit/session.h"

namespace stiction::kit {

namespace {

// Without one of its standard streams the engine behind would be given its number for the first file
// that it opens, and answers would go there.
void make_sure_of_standard_streams() {
  const int modes[] = {O_RDONLY, O_RDONLY, O_WRONLY};
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", modes[stream]));
  }
}

// What the engine behind prints must not come between the lines of the protocol.
FILE* answers_alone() {
  const int own = dup(STDOUT_FILENO);
  if (own < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return nullptr;
  return fdopen(own, "w");
}

bool read_line(std::string& line) {
  char* text = nullptr;
  std::size_t room = 0;
  const ssize_t length = getline(&text, &room, stdin);
  if (length > 0) line.assign(text, static_cast<std::size_t>(length));
  std::free(text);
  return length > 0;
}

int serve(const stiction_engine& engine) {
  FILE* const out = answers_alone();
  if (!out) return 2;
  Session session(engine);
  for (std::string line; !session.over() && read_line(line);) {
    const std::string text = session.reply(line) + "\n";
    if (std::fwrite(text.data(), 1, text.size(), out) != text.size() || std::fflush(out) != 0) {
      std::fprintf(stderr, "the answer could not be written to the standard output\n");
      return 2;
    }
  }
  return 0;
}

}  // namespace

}  // namespace stiction::kit

int stiction_engine_main(const stiction_engine* engine, int argc, char** argv) {
  stiction::kit::make_sure_of_standard_streams();
  std::signal(SIGPIPE, [](int) {});  // that nobody listens is an error of the write
  const struct {
    const char* name;
    bool is_there;
  } required[] = {{"name", engine->name != nullptr},
                  {"load", engine->load != nullptr},
                  {"time_step", engine->time_step != nullptr},
                  {"advance", engine->advance != nullptr},
                  {"body", engine->body != nullptr}};
  for (const auto& one : required) {
    if (one.is_there) continue;
    std::fprintf(stderr, "stiction_engine.%s is NULL: it is required\n", one.name);
    return 2;
  }
  if (argc > 1) {
    std::fprintf(stderr,
                 "%s: this program speaks the engine protocol of stiction on its standard input; "
                 "try: stiction engine check %s\n",
                 argv[0], argv[0]);
    return 2;
  }
  return stiction::kit::serve(*engine);
}
