// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/vtk.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "reports/record/whole_file.h"

namespace stiction {
namespace {

constexpr std::string_view kOpening =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n";
constexpr std::string_view kClosing = "</Piece>\n</PolyData>\n</VTKFile>\n";

std::string piece(std::size_t points, std::size_t vertices, std::size_t polygons) {
  return fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
      points, vertices, polygons);
}

// `values` are separated by spaces or line breaks.
std::string array(std::string_view type, std::string_view name, int components,
                  const std::string& values) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}"
      "</DataArray>\n",
      type, name, components, values);
}

std::string line(const Triple& triple) {
  return fmt::format("{:.9g} {:.9g} {:.9g}\n", triple[0], triple[1], triple[2]);
}

// Thousands of them may be written, which can be made again from the recording.
void write_file(const std::filesystem::path& file, const std::string& text) {
  write_whole(file, text, Wait::kNo);
}

}  // namespace

std::string vtp_bodies(const Recording& recording, const Frame& frame) {
  std::string points;
  for (const Triple& position : frame.positions) points += line(position);
  std::string corners;
  std::string offsets;
  std::string bodies;
  std::size_t first = 0;
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < recording.bodies.size(); ++i) {
    for (const auto& triangle : recording.bodies[i].triangles) {
      corners +=
          fmt::format("{} {} {}\n", first + triangle[0], first + triangle[1], first + triangle[2]);
      offsets += fmt::format("{}\n", 3 * ++triangles);
      bodies += fmt::format("{}\n", i);
    }
    first += recording.bodies[i].vertices;
  }
  return fmt::format(
      "{}{}<Points>\n{}</Points>\n<Polys>\n{}{}</Polys>\n<CellData>\n{}</CellData>\n{}", kOpening,
      piece(frame.positions.size(), 0, triangles), array("Float32", "Points", 3, points),
      array("Int64", "connectivity", 1, corners), array("Int64", "offsets", 1, offsets),
      array("Int32", "body", 1, bodies), kClosing);
}

std::string vtp_contacts(const Frame& frame) {
  std::string points;
  std::string vertices;
  std::string offsets;
  std::string normal_forces;
  std::string friction_forces;
  std::string sticks;
  for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
    const FrameContact& contact = frame.contacts[i];
    points += line(contact.position);
    vertices += fmt::format("{}\n", i);
    offsets += fmt::format("{}\n", i + 1);
    normal_forces += line(contact.normal_force);
    friction_forces += line(contact.friction_force);
    sticks += contact.sticks ? "1\n" : "0\n";
  }
  return fmt::format(
      "{}{}<Points>\n{}</Points>\n<Verts>\n{}{}</Verts>\n<PointData>\n{}{}{}</PointData>\n{}",
      kOpening, piece(frame.contacts.size(), frame.contacts.size(), 0),
      array("Float32", "Points", 3, points), array("Int64", "connectivity", 1, vertices),
      array("Int64", "offsets", 1, offsets), array("Float32", "normal_force", 3, normal_forces),
      array("Float32", "friction_force", 3, friction_forces), array("UInt8", "sticks", 1, sticks),
      kClosing);
}

void write_vtk(const std::filesystem::path& folder, const std::string& name,
               const Recording& recording) {
  // The name stands in XML too.
  if (name.empty() || name.find_first_of("/<>&\"") != std::string::npos || name.front() == '.') {
    throw std::invalid_argument(fmt::format("'{}' is no plain file name", name));
  }
  std::error_code error;
  std::filesystem::create_directories(folder / name, error);
  if (error) {
    throw std::runtime_error(
        fmt::format("cannot make {}: {}", (folder / name).string(), error.message()));
  }
  std::string frames;
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    const Frame& frame = recording.frames[i];
    const std::string bodies_file = fmt::format("{}/bodies_{:04}.vtp", name, i);
    const std::string contacts_file = fmt::format("{}/contacts_{:04}.vtp", name, i);
    write_file(folder / bodies_file, vtp_bodies(recording, frame));
    write_file(folder / contacts_file, vtp_contacts(frame));
    frames += fmt::format(
        "<DataSet timestep=\"{0:.9g}\" part=\"0\" file=\"{1}\"/>\n"
        "<DataSet timestep=\"{0:.9g}\" part=\"1\" file=\"{2}\"/>\n",
        frame.time, bodies_file, contacts_file);
  }
  write_file(folder / (name + ".pvd"),
             fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                         "<Collection>\n{}</Collection>\n</VTKFile>\n",
                         frames));
}

}  // namespace stiction
