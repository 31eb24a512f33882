// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/property.h"
#include "reference/meshes/mesh_surface/surface_soup.h"

/// What the targets of surface files do. CGAL's readers fall over some files, so that they run in a
/// child, as in the mesher; its coverage is counted all the same. What they read is checked here:
///
/// 1. What is refused is refused in one short line, whatever was read.
/// 2. What is accepted is finite, closed and oriented, each triangle of three points that are there.
/// 3. Written in its format it is accepted again, with the same corners.
extern "C" {
// Clang's counters of edges; absent in other builds.
extern std::uint8_t __start___sancov_cntrs[] __attribute__((weak));
extern std::uint8_t __stop___sancov_cntrs[] __attribute__((weak));
// A fuzzer's, which would keep the input of a child that dies.
void __sanitizer_set_death_callback(void (*)()) __attribute__((weak));
}

namespace stiction::fuzz {

inline constexpr std::size_t kSharedBytes = 16 << 20;
inline constexpr std::size_t kMostWords = 400;  // bytes of a refusal
inline constexpr double kReadingSeconds = 2.0;

template <class Value = char>
Value* shared_memory(void* at, std::size_t bytes) {
  void* const memory = mmap(at, bytes, PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS | (at != nullptr ? MAP_FIXED : 0), -1, 0);
  hold(memory != MAP_FAILED, "there is memory to share");
  return static_cast<Value*>(memory);
}

/// Whole pages of the counters are the child's too from now on.
inline bool share_counters() {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto first = (reinterpret_cast<std::uintptr_t>(__start___sancov_cntrs) + page - 1) / page;
  const auto last = reinterpret_cast<std::uintptr_t>(__stop___sancov_cntrs) / page;
  if (__start___sancov_cntrs == nullptr || first >= last) return false;
  char* const start = reinterpret_cast<char*>(first * page);
  const std::vector<char> kept(start, start + (last - first) * page);
  std::memcpy(shared_memory(start, kept.size()), kept.data(), kept.size());
  return true;
}

/// Numbers one after the other; nothing more fits once it is full.
class SharedNumbers {
 public:
  SharedNumbers() : memory_(shared_memory(nullptr, kSharedBytes)) {}

  void rewind() { at_ = 0; }
  bool overrun() const { return at_ > kSharedBytes; }

  template <class Number>
  void put(Number number) {
    if (at_ + sizeof number <= kSharedBytes) std::memcpy(memory_ + at_, &number, sizeof number);
    at_ += sizeof number;
  }
  template <class Number>
  Number take() {
    Number number{};
    if (at_ + sizeof number <= kSharedBytes) std::memcpy(&number, memory_ + at_, sizeof number);
    at_ += sizeof number;
    return number;
  }

 private:
  char* memory_;
  std::size_t at_ = 0;
};

inline void put(const reference::SurfaceSoup& soup, SharedNumbers& numbers) {
  numbers.put(soup.points.size());
  for (const Eigen::Vector3d& p : soup.points) {
    for (const double x : p) numbers.put(x);
  }
  numbers.put(soup.faces.size());
  for (const std::vector<std::size_t>& face : soup.faces) {
    numbers.put(face.size());
    for (const std::size_t corner : face) numbers.put(corner);
  }
}

inline reference::SurfaceSoup take_soup(SharedNumbers& numbers) {
  reference::SurfaceSoup soup;
  soup.points.resize(numbers.take<std::size_t>());
  for (Eigen::Vector3d& p : soup.points) {
    for (double& x : p) x = numbers.take<double>();
  }
  soup.faces.resize(numbers.take<std::size_t>());
  for (std::vector<std::size_t>& face : soup.faces) {
    face.resize(numbers.take<std::size_t>());
    for (std::size_t& corner : face) corner = numbers.take<std::size_t>();
  }
  return soup;
}

/// As the mesher's guard does, beside what the sanitizers have taken for themselves.
inline void limit_memory_of_child() {
  constexpr rlim_t kRoom = 64 << 20;  // bytes
  std::ifstream told("/proc/self/statm");
  rlim_t pages = 0;
  told >> pages;
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + kRoom;
  setrlimit(RLIMIT_AS, &limit);
}

enum ReaderExit { kRead = 0, kNotRead = 1, kTooLarge = 2 };

/// What CGAL's reader makes of a file; nothing where it refuses it, falls over it or takes too long.
inline std::optional<reference::SurfaceSoup> read_in_child(const std::filesystem::path& file) {
  [[maybe_unused]] static const bool shared = share_counters();
  static SharedNumbers numbers;
  numbers.rewind();
  const pid_t child = fork();
  hold(child >= 0, "there is a process to read in");
  if (child == 0) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM}) {
      std::signal(signal, SIG_DFL);
    }
    if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(nullptr);
    close(STDERR_FILENO);
    limit_memory_of_child();
    itimerval once{};
    once.it_value.tv_sec = static_cast<time_t>(kReadingSeconds);
    setitimer(ITIMER_REAL, &once, nullptr);
    int code = kNotRead;
    try {
      reference::SurfaceSoup soup;
      if (reference::read_surface_soup(file, soup)) {
        put(soup, numbers);
        code = numbers.overrun() ? kTooLarge : kRead;
      }
    } catch (const std::exception&) {
      code = kNotRead;
    }
    _exit(code);
  }
  int ended = 0;
  while (waitpid(child, &ended, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(ended) || WEXITSTATUS(ended) != kRead) return std::nullopt;
  return take_soup(numbers);
}

inline void hold_closed(const reference::SurfaceSoup& soup) {
  for (const Eigen::Vector3d& p : soup.points) hold(p.allFinite(), "a vertex is finite");
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const std::vector<std::size_t>& face : soup.faces) {
    hold(face.size() == 3, "a face is a triangle");
    for (std::size_t k = 0; k < 3; ++k) {
      hold(face[k] < soup.points.size(), "a triangle's vertices are there");
      ++edges[{face[k], face[(k + 1) % 3]}];
    }
  }
  hold(edges.size() >= 12, "a closed surface has four triangles or more");
  for (const auto& [edge, times] : edges) {
    hold(times == 1 && edges.contains({edge.second, edge.first}), "a surface is closed");
  }
}

inline std::string written(const reference::SurfaceSoup& soup, const std::string& format) {
  std::ostringstream text;
  text.precision(17);
  const std::size_t points = soup.points.size(), faces = soup.faces.size();
  if (format == "off") text << "OFF\n" << points << ' ' << faces << " 0\n";
  if (format == "ply") {
    text << "ply\nformat ascii 1.0\nelement vertex " << points
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << faces
         << "\nproperty list uchar int vertex_indices\nend_header\n";
  }
  if (format == "stl") {
    text << "solid body\n";
    for (const std::vector<std::size_t>& face : soup.faces) {
      text << "facet normal 0 0 0\nouter loop\n";
      for (const std::size_t k : face) text << "vertex " << soup.points[k].transpose() << '\n';
      text << "endloop\nendfacet\n";
    }
    text << "endsolid body\n";
    return text.str();
  }
  const bool obj = format == "obj";
  for (const Eigen::Vector3d& p : soup.points) text << (obj ? "v " : "") << p.transpose() << '\n';
  for (const std::vector<std::size_t>& face : soup.faces) {
    text << (obj ? "f" : "3");
    for (const std::size_t k : face) text << ' ' << k + (obj ? 1 : 0);
    text << '\n';
  }
  return text.str();
}

inline std::vector<Eigen::Vector3d> corners_of(const reference::SurfaceSoup& soup) {
  std::vector<Eigen::Vector3d> corners;
  for (const std::vector<std::size_t>& face : soup.faces) {
    for (const std::size_t k : face) corners.push_back(soup.points[k]);
  }
  return corners;
}

/// Its surface; nothing where it is refused.
inline std::optional<reference::SurfaceSoup> surface_of(const std::filesystem::path& file,
                                                        std::string_view bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
  const auto short_sentence = [](auto read) {
    return value_or_sentence<reference::SurfaceError>([&] {
      try {
        return read();
      } catch (const reference::SurfaceError& error) {
        hold(std::strlen(error.what()) < kMostWords, "a refusal is short");
        throw;
      }
    });
  };
  if (!short_sentence([&] { return reference::surface_format(file); })) return std::nullopt;
  std::optional<reference::SurfaceSoup> soup = read_in_child(file);
  if (!soup) return std::nullopt;
  const auto good = short_sentence([&] {
    reference::check_surface_soup(*soup, file.string());
    return true;
  });
  return good ? soup : std::nullopt;
}

inline int fuzz_surface(const std::string& format, std::string_view bytes) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      ("stiction_fuzz_" + std::to_string(getpid()) + "." + format);
  struct Removed {
    ~Removed() { std::filesystem::remove(file); }
  } const removed;
  const std::optional<reference::SurfaceSoup> soup = surface_of(file, bytes);
  if (!soup) return 0;
  hold_closed(*soup);
  const std::optional<reference::SurfaceSoup> again = surface_of(file, written(*soup, format));
  hold(again.has_value(), "what was accepted is accepted as it is written");
  hold(corners_of(*again) == corners_of(*soup), "it reads as it was written");
  return 0;
}

}  // namespace stiction::fuzz
