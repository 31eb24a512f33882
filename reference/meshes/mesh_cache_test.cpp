// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_cache.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace stiction::reference {
namespace {

namespace fs = std::filesystem;

FilledSurface filled(double volume) {
  FilledSurface one;
  one.given_triangles = 4;
  one.given_volume = volume;
  one.mesh.vertices = Eigen::Matrix3Xd::Random(3, 4);
  one.mesh.tetrahedra = Eigen::Vector4i(0, 1, 2, 3);
  return one;
}

class MeshCacheTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "mesh_cache_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = fs::path(name) / "not/yet";
  }
  void TearDown() override { fs::remove_all(folder_.parent_path().parent_path()); }

  fs::path only_file() const {
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
    return fs::directory_iterator(folder_)->path();
  }

  fs::path folder_;
  const MeshOrigin origin_{"OFF\n1\n", "off", "cell-size 0.1",
                           std::string("\x7f"
                                       "ELF\0",
                                       5)};
};

TEST_F(MeshCacheTest, FindsTheSameBitsAgain) {
  const MeshCache cache(folder_);
  EXPECT_FALSE(cache.find(origin_));
  const FilledSurface made = filled(0.1);
  cache.keep(origin_, made);
  const auto found = cache.find(origin_);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->given_triangles, 4);
  EXPECT_EQ(found->given_volume, 0.1);
  EXPECT_TRUE(found->mesh.vertices == made.mesh.vertices);
  EXPECT_TRUE(found->mesh.tetrahedra == made.mesh.tetrahedra);
}

TEST_F(MeshCacheTest, AnythingElseIsAnotherMesh) {
  const MeshCache cache(folder_);
  cache.keep(origin_, filled(0.1));
  for (std::string MeshOrigin::*part :
       {&MeshOrigin::surface, &MeshOrigin::format, &MeshOrigin::options, &MeshOrigin::mesher}) {
    MeshOrigin other = origin_;
    (other.*part) += "1";
    EXPECT_FALSE(cache.find(other));
  }
}

// Cut off, changed anywhere, empty, or of another origin under the same name: it is made anew.
TEST_F(MeshCacheTest, ADamagedFileIsNotUsedAndIsReplaced) {
  const MeshCache cache(folder_);
  cache.keep(origin_, filled(0.1));
  const fs::path file = only_file();
  std::ifstream stream(file, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  const auto write = [&](const std::string& content) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
  };
  for (std::size_t k = 0; k < whole.size(); ++k) {
    write(whole.substr(0, k));
    EXPECT_FALSE(cache.find(origin_)) << "cut off at " << k;
    std::string changed = whole;
    changed[k] = static_cast<char>(changed[k] ^ 1);
    write(changed);
    EXPECT_FALSE(cache.find(origin_)) << "changed at " << k;
  }
  write(whole + "more");
  EXPECT_FALSE(cache.find(origin_));
  cache.keep(origin_, filled(0.2));
  ASSERT_TRUE(cache.find(origin_));
  EXPECT_EQ(cache.find(origin_)->given_volume, 0.2);
  only_file();
}

TEST_F(MeshCacheTest, ManyAtOnceLeaveOneWholeFile) {
  const MeshCache cache(folder_);
  const FilledSurface made = filled(0.1);
  std::vector<std::thread> writers;
  for (int k = 0; k < 8; ++k) {
    writers.emplace_back([&] {
      for (int round = 0; round < 20; ++round) {
        cache.keep(origin_, made);
        EXPECT_TRUE(cache.find(origin_));
      }
    });
  }
  for (std::thread& one : writers) one.join();
  only_file();
}

TEST_F(MeshCacheTest, KeepsTheNewestOnly) {
  const MeshCache cache(folder_);
  MeshOrigin origin = origin_;
  for (std::size_t k = 0; k < MeshCache::kMostMeshes + 3; ++k) {
    origin.options = std::to_string(k);
    cache.keep(origin, filled(0.1));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}),
            static_cast<std::ptrdiff_t>(MeshCache::kMostMeshes));
  EXPECT_TRUE(cache.find(origin));
}

TEST_F(MeshCacheTest, WhereNothingCanBeKeptNothingHappens) {
  for (const char* const folder : {"", "/dev/null/meshes", "/proc/meshes"}) {
    const MeshCache cache(folder);
    cache.keep(origin_, filled(0.1));
    EXPECT_FALSE(cache.find(origin_)) << folder;
  }
}

TEST_F(MeshCacheTest, TheFolderIsTheUsersCache) {
  const char* const before = getenv("XDG_CACHE_HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("XDG_CACHE_HOME", "/there", 1);
  EXPECT_EQ(mesh_cache_folder(), "/there/stiction/meshes");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_NE(mesh_cache_folder(), "relative/stiction/meshes") << "which the standard forbids";
  if (before != nullptr) {
    setenv("XDG_CACHE_HOME", kept.c_str(), 1);
  } else {
    unsetenv("XDG_CACHE_HOME");
  }
}

}  // namespace
}  // namespace stiction::reference
