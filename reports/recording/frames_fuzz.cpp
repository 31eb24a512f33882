// SPDX-License-Identifier: GPL-3.0-or-later
// A recording: a value or one sentence; what was read can be written, and reads the same to the
// precision that the format promises.
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "fuzz/property.h"
#include "reports/recording/frames.h"

using namespace stiction;

namespace {

// Of positions along one axis, or of forces.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  // Half a quantum, and the round-off of numbers of this size.
  double error(double quanta) const {
    return 0.5 * (high - low) / quanta + 4e-16 * std::max(std::abs(low), std::abs(high));
  }
};

bool same_names(const Recording& a, const Recording& b) {
  if (a.bodies.size() != b.bodies.size() || a.planes.size() != b.planes.size()) return false;
  for (std::size_t k = 0; k < a.bodies.size(); ++k) {
    if (a.bodies[k].vertices != b.bodies[k].vertices) return false;
    if (a.bodies[k].triangles != b.bodies[k].triangles) return false;
  }
  for (std::size_t k = 0; k < a.planes.size(); ++k) {
    if (a.planes[k].point != b.planes[k].point) return false;
    if (a.planes[k].normal != b.planes[k].normal) return false;
  }
  return true;
}

void hold_same_positions(const Recording& a, const Recording& b) {
  Extent extent[3];
  for (const Frame& frame : a.frames) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      for (const Triple& x : frame.positions) extent[axis].include(x[k]);
      for (const FrameContact& contact : frame.contacts) extent[axis].include(contact.position[k]);
    }
  }
  for (std::size_t f = 0; f < a.frames.size(); ++f) {
    fuzz::hold(a.frames[f].time == b.frames[f].time, "times read as they were written");
    fuzz::hold(a.frames[f].gravity == b.frames[f].gravity, "gravity reads as it was written");
    fuzz::hold(a.frames[f].contacts.size() == b.frames[f].contacts.size(), "so do contacts");
    fuzz::hold(a.frames[f].positions.size() == b.frames[f].positions.size(), "so do vertices");
    for (std::size_t v = 0; v < a.frames[f].positions.size(); ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double apart =
            std::abs(a.frames[f].positions[v][axis] - b.frames[f].positions[v][axis]);
        fuzz::hold(apart <= extent[axis].error(65535.0), "positions read to half a quantum");
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto recording =
      fuzz::value_or_sentence<std::runtime_error>([&] { return decode_frames(bytes); });
  if (!recording) return 0;
  const Recording again = decode_frames(encode_frames(*recording));
  fuzz::hold(same_names(*recording, again), "bodies and planes read as they were written");
  fuzz::hold(recording->frames.size() == again.frames.size(), "frames read as they were written");
  hold_same_positions(*recording, again);
  return 0;
}
