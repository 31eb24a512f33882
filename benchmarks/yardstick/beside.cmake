# SPDX-License-Identifier: GPL-3.0-or-later
# Adds the yardstick of this revision, with this one's workloads, to another revision that is being configured, once that
# one's libraries are known; no file of it is touched:
#   cmake -S ANOTHER -DCMAKE_PROJECT_stiction_INCLUDE=…/beside.cmake -DSTICTION_PRESENT_CATALOG=…/family_catalog.cpp
# A deferred call asks what a variable stands for when it is made, so those here have names of their own.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH present_benchmarks)
file(GLOB_RECURSE present_yardstick CONFIGURE_DEPENDS
     ${present_benchmarks}/yardstick/*.cpp ${present_benchmarks}/workloads/*.cpp)
list(APPEND present_yardstick ${STICTION_PRESENT_CATALOG})
# Workloads are found here before those of the other revision, all else there.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/present/benchmarks)
file(CREATE_LINK ${present_benchmarks}/workloads ${CMAKE_BINARY_DIR}/present/benchmarks/workloads SYMBOLIC)
cmake_language(DEFER CALL add_executable present_yardstick EXCLUDE_FROM_ALL ${present_yardstick})
cmake_language(DEFER CALL target_include_directories present_yardstick BEFORE PRIVATE ${CMAKE_BINARY_DIR}/present)
cmake_language(DEFER CALL target_link_libraries present_yardstick PRIVATE stiction_validation)
cmake_language(DEFER CALL set_target_properties
               present_yardstick PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})
