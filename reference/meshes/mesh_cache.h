// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "reference/meshes/filled_surface.h"

/// Filled surfaces that were made before, so that a problem is meshed once. The same file, options and
/// mesher give the same bits, so that a mesh that is found is the mesh that would be made.
namespace stiction::reference {

/// What a mesh follows from.
struct MeshOrigin {
  std::string surface;  ///< the bytes of the file
  std::string format;   ///< its extension, which says how they are read
  std::string options;  ///< in words, one line
  std::string mesher;   ///< the bytes of the program
};

/// A folder of meshes, one a file, named by a hash of their origin. Each file holds its origin, as
/// another could have the same hash, and a check sum of all. Nothing here is an error: what cannot be
/// read is made anew, and what cannot be written is made again the next time.
class MeshCache {
 public:
  /// In `folder`, which is made when it is first written to; with an empty one nothing is found or
  /// kept.
  explicit MeshCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] std::optional<FilledSurface> find(const MeshOrigin& origin) const;

  /// In one step: who reads meanwhile finds the old file, or the new one. Of the files of the folder
  /// the newest kMostMeshes stay. Returns why it could not be kept, with the folder; else nothing.
  std::string keep(const MeshOrigin& origin, const FilledSurface& filled) const;

  static constexpr std::size_t kMostMeshes = 64;

 private:
  [[nodiscard]] std::filesystem::path file_of(const std::string& words) const;

  std::filesystem::path folder_;
};

/// The bytes of a file; none where it cannot be read.
std::string content_of(const std::filesystem::path& file);

/// stiction/meshes in XDG_CACHE_HOME, else in ~/.cache; empty without either.
std::filesystem::path mesh_cache_folder();

}  // namespace stiction::reference
