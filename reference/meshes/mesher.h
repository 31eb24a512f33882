// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

/// The program mesh_surface, which is compiled when it is first called for, as CGAL's mesher takes a
/// minute and 4 GB.
namespace stiction::reference {

/// The mesher is not there, or didn't do its work: nothing is known of the surface.
class MesherError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct MesherPlaces {
  std::filesystem::path program{};             ///< the mesher itself; empty: look for it
  std::vector<std::filesystem::path> folders;  ///< to look in, in order
  /// Run with the one argument "mesher" when it is in none of them, builds it in the first; may be
  /// empty.
  std::filesystem::path builder{};
};

/// STICTION_MESHER; the folder of the running program, then those of PATH; STICTION_SCRIPT, which
/// ./stiction sets to itself.
MesherPlaces mesher_places();

/// The program to run, built if need be. Throws MesherError, which says how to build it.
std::filesystem::path find_mesher(const MesherPlaces& places);

}  // namespace stiction::reference
