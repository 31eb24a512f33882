# SPDX-License-Identifier: GPL-3.0-or-later
# Run at every build: writes OUTPUT only when the revision has changed, so that nothing is rebuilt
# for nothing. Needs SOURCE, OUTPUT, FLAGS.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} describe --always --abbrev=12 --exclude=*
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
# A run's results in the tree are no change of the program, a new source is one.
execute_process(COMMAND git -C ${SOURCE} status --porcelain --
                        CMakeLists.txt benchmarks fuzz reference reports solver validation
                OUTPUT_VARIABLE changes ERROR_QUIET)
if(NOT revision)
  set(revision "unknown")
elseif(changes)
  string(APPEND revision "+")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT
"#pragma once
inline constexpr char kRevision[] = \"@revision@\";
inline constexpr char kBuildFlags[] = \"@FLAGS@\";
")
