// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_surface/library_guard.h"

#include <gtest/gtest.h>

#include <csignal>
#include <new>
#include <string>

namespace stiction::reference {
namespace {

const LibraryLimits kLimits = {.code = 18, .fallen = "it fell over", .late = "it took long"};

TEST(LibraryGuard, ACrashIsASentence) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    EXPECT_EXIT(
        {
          const LibraryGuard guard(kLimits);
          raise(signal);
        },
        testing::ExitedWithCode(18), "^it fell over\n$");
  }
}

TEST(LibraryGuard, SoIsWhatTakesTooLong) {
  EXPECT_EXIT(
      {
        LibraryLimits limits = kLimits;
        limits.seconds = 0.05;
        const LibraryGuard guard(limits);
        for (volatile int forever = 1; forever == 1;) {
        }
      },
      testing::ExitedWithCode(18), "^it took long\n$");
}

TEST(LibraryGuard, WithoutItNothingIsCaught) {
  EXPECT_EXIT(
      {
        { const LibraryGuard guard(kLimits); }
        raise(SIGFPE);
      },
      testing::KilledBySignal(SIGFPE), "");
}

}  // namespace
}  // namespace stiction::reference
