// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/recording/frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/record/whole_file.h"

namespace stiction {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kMagic = "STFR";
constexpr std::uint32_t kVersion = 1;
constexpr double kPositionQuanta = 65535.0;
constexpr double kForceQuanta = 32767.0;
constexpr std::size_t kContactBytes = 20;
constexpr std::uint64_t kMost = 0xffffffff;  // of anything that is counted

bool finite(const Triple& triple) {
  return std::all_of(triple.begin(), triple.end(), [](double x) { return std::isfinite(x); });
}

std::size_t vertex_count(const Recording& recording) {
  std::size_t count = 0;
  for (const FrameBody& body : recording.bodies) count += body.vertices;
  return count;
}

// What is wrong with it, in words; empty: nothing.
std::string fault_of(const Recording& recording) {
  if (recording.frames.empty()) return "needs a frame";
  for (const FrameBody& body : recording.bodies) {
    for (const auto& triangle : body.triangles) {
      if (std::any_of(triangle.begin(), triangle.end(),
                      [&](std::uint32_t corner) { return corner >= body.vertices; })) {
        return "has a triangle with a corner that is not there";
      }
    }
  }
  for (const FramePlane& plane : recording.planes) {
    if (!finite(plane.point) || !finite(plane.normal)) return "has a plane that is not finite";
  }
  const std::size_t vertices = vertex_count(recording);
  for (const Frame& frame : recording.frames) {
    if (frame.positions.size() != vertices) return "has a frame with another vertex count";
    if (!std::isfinite(frame.time) ||
        !std::all_of(frame.positions.begin(), frame.positions.end(), finite)) {
      return "has a position or time that is not finite";
    }
    if (!finite(frame.gravity)) return "has gravity that is not finite";
    for (const FrameContact& contact : frame.contacts) {
      if (!finite(contact.position) || !finite(contact.normal_force) ||
          !finite(contact.friction_force)) {
        return "has a contact that is not finite";
      }
    }
  }
  return {};
}

// What positions and forces are quantised by.
struct Scales {
  Triple low{};
  Triple high{};
  double force = 0.0;

  std::uint16_t position(double x, std::size_t axis) const {
    const double extent = high[axis] - low[axis];
    return extent > 0.0
               ? static_cast<std::uint16_t>(std::lround((x - low[axis]) / extent * kPositionQuanta))
               : std::uint16_t{0};
  }
  double position(std::uint16_t quantum, std::size_t axis) const {
    return low[axis] + quantum * (high[axis] - low[axis]) / kPositionQuanta;
  }
  std::int16_t component(double f) const {
    return force > 0.0 ? static_cast<std::int16_t>(std::lround(f / force * kForceQuanta))
                       : std::int16_t{0};
  }
  double component(std::int16_t quantum) const { return quantum * force / kForceQuanta; }
};

Scales scales_of(const Recording& recording) {
  Scales scales;
  scales.low.fill(std::numeric_limits<double>::infinity());
  scales.high.fill(-std::numeric_limits<double>::infinity());
  const auto include = [&](const Triple& position) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scales.low[axis] = std::min(scales.low[axis], position[axis]);
      scales.high[axis] = std::max(scales.high[axis], position[axis]);
    }
  };
  for (const Frame& frame : recording.frames) {
    for (const Triple& position : frame.positions) include(position);
    for (const FrameContact& contact : frame.contacts) {
      include(contact.position);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        scales.force = std::max({scales.force, std::abs(contact.normal_force[axis]),
                                 std::abs(contact.friction_force[axis])});
      }
    }
  }
  // Nothing at all to show: any box will do.
  if (!finite(scales.low)) scales.low = scales.high = Triple{};
  return scales;
}

template <typename Integer>
void put(std::string& bytes, Integer value) {
  auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
  for (std::size_t i = 0; i < sizeof(Integer); ++i) {
    bytes += static_cast<char>((bits >> (8 * i)) & 0xff);
  }
}

std::string header_of(const Recording& recording, const Scales& scales) {
  OrderedJson header{{"title", recording.title},
                     {"bodies", OrderedJson::array()},
                     {"planes", OrderedJson::array()},
                     {"low", scales.low},
                     {"high", scales.high},
                     {"force", scales.force},
                     {"times", OrderedJson::array()},
                     {"gravity", OrderedJson::array()},
                     {"contacts", OrderedJson::array()}};
  for (const FrameBody& body : recording.bodies) {
    header["bodies"].push_back(
        {{"name", body.name}, {"vertices", body.vertices}, {"triangles", body.triangles.size()}});
  }
  for (const FramePlane& plane : recording.planes) {
    header["planes"].push_back(
        {{"name", plane.name}, {"point", plane.point}, {"normal", plane.normal}});
  }
  for (const Frame& frame : recording.frames) {
    header["times"].push_back(frame.time);
    header["gravity"].push_back(frame.gravity);
    header["contacts"].push_back(frame.contacts.size());
  }
  std::string text = header.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  text.append((4 - text.size() % 4) % 4, ' ');
  return text;
}

void put_contact(std::string& bytes, const FrameContact& contact, const Scales& scales) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(bytes, scales.position(contact.position[axis], axis));
  }
  for (const double f : contact.normal_force) put(bytes, scales.component(f));
  for (const double f : contact.friction_force) put(bytes, scales.component(f));
  put(bytes, static_cast<std::uint16_t>(contact.sticks ? 1 : 0));
}

// Takes integers from the front of bytes.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) throw std::runtime_error("the frames file is cut off");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }

  template <typename Integer>
  Integer integer() {
    std::make_unsigned_t<Integer> bits = 0;
    const std::string_view taken = take(sizeof(Integer));
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      bits = static_cast<std::make_unsigned_t<Integer>>(
          bits | (static_cast<std::make_unsigned_t<Integer>>(static_cast<unsigned char>(taken[i]))
                  << (8 * i)));
    }
    return static_cast<Integer>(bits);
  }

  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

// nlohmann's own conversion takes -1 and 1e300 as well.
std::size_t count_of(const OrderedJson& value) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMost) {
    throw std::runtime_error("the header of the frames file has a count that is none");
  }
  return value.get<std::size_t>();
}

FrameContact take_contact(Reader& reader, const Scales& scales) {
  FrameContact contact;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    contact.position[axis] = scales.position(reader.integer<std::uint16_t>(), axis);
  }
  for (double& f : contact.normal_force) f = scales.component(reader.integer<std::int16_t>());
  for (double& f : contact.friction_force) f = scales.component(reader.integer<std::int16_t>());
  contact.sticks = reader.integer<std::uint16_t>() == 1;
  return contact;
}

}  // namespace

std::string encode_frames(const Recording& recording) {
  if (const std::string fault = fault_of(recording); !fault.empty()) {
    throw std::invalid_argument("a recording " + fault);
  }
  const Scales scales = scales_of(recording);
  const std::string header = header_of(recording, scales);
  std::string bytes(kMagic);
  put(bytes, kVersion);
  put(bytes, static_cast<std::uint32_t>(header.size()));
  bytes += header;
  for (const FrameBody& body : recording.bodies) {
    for (const auto& triangle : body.triangles) {
      for (const std::uint32_t corner : triangle) put(bytes, corner);
    }
  }
  std::vector<std::uint16_t> before(3 * vertex_count(recording), 0);
  for (const Frame& frame : recording.frames) {
    for (std::size_t i = 0; i < before.size(); ++i) {
      const std::uint16_t now = scales.position(frame.positions[i / 3][i % 3], i % 3);
      put(bytes, static_cast<std::uint16_t>(now - before[i]));
      before[i] = now;
    }
    for (const FrameContact& contact : frame.contacts) put_contact(bytes, contact, scales);
  }
  return bytes;
}

Recording decode_frames(std::string_view bytes) {
  Reader reader(bytes);
  if (reader.take(kMagic.size()) != kMagic) throw std::runtime_error("this is no frames file");
  const auto version = reader.integer<std::uint32_t>();
  if (version > kVersion) {
    throw std::runtime_error(fmt::format(
        "the frames file has version {}, this program reads up to {}", version, kVersion));
  }
  Recording recording;
  Scales scales;
  std::vector<std::size_t> triangles;
  std::vector<std::size_t> contacts;
  try {
    const OrderedJson header = OrderedJson::parse(reader.take(reader.integer<std::uint32_t>()));
    recording.title = header.at("title").get<std::string>();
    scales.low = header.at("low").get<Triple>();
    scales.high = header.at("high").get<Triple>();
    scales.force = header.at("force").get<double>();
    for (const OrderedJson& body : header.at("bodies")) {
      recording.bodies.push_back(
          {body.at("name").get<std::string>(), count_of(body.at("vertices")), {}});
      triangles.push_back(count_of(body.at("triangles")));
    }
    for (const OrderedJson& plane : header.at("planes")) {
      recording.planes.push_back({plane.at("name").get<std::string>(),
                                  plane.at("point").get<Triple>(),
                                  plane.at("normal").get<Triple>()});
    }
    const auto times = header.at("times").get<std::vector<double>>();
    const auto gravity = header.at("gravity").get<std::vector<Triple>>();
    if (gravity.size() != times.size()) throw std::runtime_error("the frames file is cut off");
    for (std::size_t i = 0; i < times.size(); ++i) {
      recording.frames.push_back({times[i], gravity[i], {}, {}});
    }
    for (const OrderedJson& count : header.at("contacts")) contacts.push_back(count_of(count));
  } catch (const OrderedJson::exception& error) {
    throw std::runtime_error(
        fmt::format("the header of the frames file is broken: {}", error.what()));
  }
  const std::size_t vertices = vertex_count(recording);
  if (recording.frames.empty()) throw std::runtime_error("the frames file has no frame");
  // Before anything is allocated by sizes that a broken header may give.
  if (contacts.size() != recording.frames.size() ||
      (vertices > 0 && recording.frames.size() > reader.left() / (6 * vertices))) {
    throw std::runtime_error("the frames file is cut off");
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] > reader.left() / 12) throw std::runtime_error("the frames file is cut off");
    recording.bodies[i].triangles.resize(triangles[i]);
    for (auto& triangle : recording.bodies[i].triangles) {
      for (std::uint32_t& corner : triangle) corner = reader.integer<std::uint32_t>();
    }
  }
  std::vector<std::uint16_t> quanta(3 * vertices, 0);
  for (std::size_t frame = 0; frame < recording.frames.size(); ++frame) {
    recording.frames[frame].positions.resize(vertices);
    for (std::size_t i = 0; i < quanta.size(); ++i) {
      quanta[i] = static_cast<std::uint16_t>(quanta[i] + reader.integer<std::uint16_t>());
      recording.frames[frame].positions[i / 3][i % 3] = scales.position(quanta[i], i % 3);
    }
    if (contacts[frame] > reader.left() / kContactBytes) {
      throw std::runtime_error("the frames file is cut off");
    }
    for (std::size_t i = 0; i < contacts[frame]; ++i) {
      recording.frames[frame].contacts.push_back(take_contact(reader, scales));
    }
  }
  if (reader.left() > 0) throw std::runtime_error("the frames file is longer than its header says");
  if (const std::string fault = fault_of(recording); !fault.empty()) {
    throw std::runtime_error("the frames file " + fault);
  }
  return recording;
}

void write_frames(const std::filesystem::path& file, const Recording& recording) {
  const std::string bytes = encode_frames(recording);
  std::error_code none;  // what is wrong shows when the file is written
  std::filesystem::create_directories(file.parent_path(), none);
  write_whole(file, bytes);
}

}  // namespace stiction
