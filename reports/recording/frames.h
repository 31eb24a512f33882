// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stiction {

using Triple = std::array<double, 3>;  ///< x, y, z in the world frame

/// A surface that moves. Its vertices follow those of the bodies before it in Frame::positions.
struct FrameBody {
  std::string name{};
  std::size_t vertices = 0;
  std::vector<std::array<std::uint32_t, 3>> triangles{};  ///< into the body's own vertices, from 0
};

/// A fixed half-space; the normal points out of it.
struct FramePlane {
  std::string name{};
  Triple point{};   ///< m
  Triple normal{};  ///< unit length
};

/// A contact at an instant. Forces act on the body that slides or rests.
struct FrameContact {
  Triple position{};        ///< m
  Triple normal_force{};    ///< N
  Triple friction_force{};  ///< N
  bool sticks = false;      ///< otherwise it slips
};

struct Frame {
  double time = 0.0;                ///< s
  Triple gravity{};                 ///< m/s²; the player turns it downwards. Zero: z is up
  std::vector<Triple> positions{};  ///< m; as many as all bodies have vertices
  std::vector<FrameContact> contacts{};
};

/// What a player shows: surfaces once, positions and contacts for each frame.
struct Recording {
  std::string title{};
  std::vector<FrameBody> bodies{};
  std::vector<FramePlane> planes{};
  std::vector<Frame> frames{};  ///< at least one, in order of time
};

/// A recording as bytes, all numbers little-endian:
///
///   "STFR", u32 version (1), u32 size of the header: a multiple of 4
///   header, JSON filled up with spaces: title, bodies [{name, vertices, triangles}],
///     planes [{name, point, normal}], low and high (m, the box around all positions), force (N,
///     the largest component of any force), times (s), gravity (m/s²) and contacts (their number)
///     of each frame
///   for each body, for each triangle: 3 × u32
///   for each frame:
///     for each vertex: 3 × u16, the quantised position minus that of the frame before, modulo 2¹⁶
///     for each contact: 3 × u16 position, 3 × i16 normal force, 3 × i16 friction force, u16 sticks
///
/// A position q means low + q (high − low) / 65535, a force f means f · force / 32767: errors of at
/// most (high − low) / 131070 and force / 65534. Differences are small, so that gzip, which the
/// report page applies, makes a moving mesh several times smaller.
///
/// Throws std::invalid_argument when the recording has no frame, a number that is not finite, a
/// frame with another count of positions, or a triangle's corner that is not there.
std::string encode_frames(const Recording& recording);

/// Throws std::runtime_error with one sentence when the bytes are no such recording.
Recording decode_frames(std::string_view bytes);

/// Writes encode_frames() to a file, whose folder is made where it is missing: completely or not at
/// all. Throws std::runtime_error when the system fails.
void write_frames(const std::filesystem::path& file, const Recording& recording);

}  // namespace stiction
