// SPDX-License-Identifier: GPL-3.0-or-later
// Stands for the yardstick in track's own tests: the same interface; times, rest and state are those of the
// revision that it is built with.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "solver.h"  // kNanoseconds, kAtRest, kHash: of the step, by one thread in the widest registers

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--list") == 0) {
    std::printf("slab 100 0\nslab 1000 0\nwall 100 0\nwall 1000000 1\n");
    return 0;
  }
  if (argc == 2 && std::strcmp(argv[1], "--widths") == 0) {
    std::printf("2\n4\n8\n");
    return 0;
  }
  const double contacts = std::atof(argv[2]), threads = std::atof(argv[3]);
  const char* const width = std::getenv("STICTION_WIDTH");
  const double factor = width == nullptr ? 1.0 : 8.0 / std::atof(width);
  const double seconds = 1e-9 * kNanoseconds * contacts * factor / threads;
  const char* const calls = std::getenv("STICTION_TEST_CALLS");
  char line[100];
  while (std::fgets(line, sizeof line, stdin) != nullptr) {
    if (std::strcmp(line, "settle\n") == 0) {
      const char* const never = std::getenv("STICTION_TEST_NEVER");  // a family that never settles
      while (never != nullptr && std::strcmp(argv[1], never) == 0) pause();
      std::printf("{\"contacts\":%g,\"at_rest\":%s,\"error\":0.01}\n", contacts, kAtRest);
    } else if (std::strcmp(line, "steps\n") == 0) {
      if (std::FILE* const told = calls == nullptr ? nullptr : std::fopen(calls, "a")) {
        std::fprintf(told, "%g/%s/%g ", kNanoseconds, width == nullptr ? "8" : width, threads);
        std::fclose(told);
      }
      std::printf(
          "{\"cpu\":%g,\"wall\":%g,\"hash\":\"%s\",\"phases\":{\"forces\":%g,\"detect\":%g}}\n",
          seconds, seconds, width == nullptr ? "1" : kHash, 0.5 * seconds, 0.25 * seconds);
    } else {
      std::printf("{\"bandwidth\":%g,\"arithmetic\":%g}\n", 1e-8 * contacts, 2e-8 * contacts);
    }
    std::fflush(stdout);
  }
  return 0;
}
