// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/recording/frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include "reports/recording/test_recording.h"

namespace stiction {
namespace {

using ::testing::HasSubstr;

std::string message_of(const std::string& bytes) {
  try {
    decode_frames(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Frames, ReadBackWithinHalfAQuantum) {
  const Recording written = sliding_box();
  const Recording read = decode_frames(encode_frames(written));
  ASSERT_EQ(read.frames.size(), written.frames.size());
  EXPECT_EQ(read.title, written.title);
  ASSERT_EQ(read.bodies.size(), 1u);
  EXPECT_EQ(read.bodies[0].triangles, written.bodies[0].triangles);
  ASSERT_EQ(read.planes.size(), 1u);
  EXPECT_EQ(read.planes[0].normal, written.planes[0].normal);
  // The box moves in about 1.2 m, forces are up to 5 N; half a quantum and round-off.
  const double position_error = 0.5 * 1.2 / 65535.0 * 1.001;
  const double force_error = 0.5 * 5.0 / 32767.0 * 1.001;
  for (std::size_t f = 0; f < read.frames.size(); ++f) {
    EXPECT_EQ(read.frames[f].time, written.frames[f].time);
    EXPECT_EQ(read.frames[f].gravity, written.frames[f].gravity);
    ASSERT_EQ(read.frames[f].positions.size(), 8u);
    for (std::size_t v = 0; v < 8; ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(read.frames[f].positions[v][axis], written.frames[f].positions[v][axis],
                    position_error);
      }
    }
    ASSERT_EQ(read.frames[f].contacts.size(), 4u);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(read.frames[f].contacts[c].sticks, written.frames[f].contacts[c].sticks);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(read.frames[f].contacts[c].friction_force[axis],
                    written.frames[f].contacts[c].friction_force[axis], force_error);
      }
    }
  }
}

TEST(Frames, NothingMovesAndNoContactsReadBack) {
  Recording still;
  still.bodies.push_back({"point", 1, {}});
  still.frames.push_back({0.5, {}, {{1.0, 2.0, 3.0}}, {}});
  const Recording read = decode_frames(encode_frames(still));
  EXPECT_EQ(read.frames[0].positions[0], (Triple{1.0, 2.0, 3.0}));
}

TEST(Frames, AreRefusedWhenTheyCannotBeShown) {
  EXPECT_THROW(encode_frames({}), std::invalid_argument);
  Recording recording = sliding_box();
  recording.frames[3].positions.pop_back();
  EXPECT_THROW(encode_frames(recording), std::invalid_argument);
  recording = sliding_box();
  recording.frames[3].positions[2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(encode_frames(recording), std::invalid_argument);
  recording = sliding_box();
  recording.bodies[0].triangles[0][2] = 8;
  EXPECT_THROW(encode_frames(recording), std::invalid_argument);
}

TEST(Frames, BrokenBytesAreToldInWords) {
  const std::string bytes = encode_frames(sliding_box());
  EXPECT_THAT(message_of(""), HasSubstr("cut off"));
  EXPECT_THAT(message_of("{\"frames\": 1}"), HasSubstr("no frames file"));
  EXPECT_THAT(message_of(bytes + "x"), HasSubstr("longer"));
  std::string newer = bytes;
  newer[4] = 9;
  EXPECT_THAT(message_of(newer), HasSubstr("version 9"));
  std::string header = bytes;
  header[13] = '\xff';
  EXPECT_THAT(message_of(header), HasSubstr("header"));
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_NE(message_of(bytes.substr(0, length)), "accepted") << length;
  }
}

// The page's tests read this file: what it holds must not change without a new version.
TEST(Frames, AreTheBytesThatThePageIsTestedWith) {
  const std::filesystem::path file =
      std::filesystem::path(__FILE__).parent_path().parent_path() / "web/test/data/sliding-box.bin";
  if (std::getenv("STICTION_WRITE_GOLDEN")) write_frames(file, sliding_box());
  EXPECT_EQ(encode_frames(sliding_box()), file_text(file))
      << "STICTION_WRITE_GOLDEN=1 writes it anew";
}

TEST(Frames, FileIsWrittenWholeInAFolderOfItsOwn) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "stiction_frames_test";
  std::filesystem::remove_all(folder);
  write_frames(folder / "frames" / "box.bin", sliding_box());
  EXPECT_EQ(file_text(folder / "frames" / "box.bin"), encode_frames(sliding_box()));
  EXPECT_THROW(write_frames("/proc/none/box.bin", sliding_box()), std::runtime_error);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace stiction
