// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/mesh_surface/declared_counts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string_view>

namespace stiction::reference {

namespace {

// The fewest bytes that a thing takes, of all ways to write it.
constexpr double kOffVertex = sizeof("0 0 0") - 1, kOffFace = sizeof("3 0 1 2") - 1;
constexpr double kPlyElement = 1;                     // a list of no bytes
constexpr double kPlyVertex = 3, kPlyFace = 4;        // of single bytes
constexpr double kStlHeader = 84, kStlTriangle = 50;  // binary
constexpr int kLongestHeader = 10000;                 // lines
constexpr std::size_t kLongestCount = 24;             // signs

std::string too_much(const std::string& count, const std::string& what, std::uint64_t bytes) {
  const bool is_told = count.size() <= kLongestCount &&
                       std::all_of(count.begin(), count.end(), [](unsigned char sign) {
                         return std::isalnum(sign) || sign == '.' || sign == '+';
                       });
  return "it says that it has " + (is_told ? count : std::string("more")) + " " + what +
         ", which its " + std::to_string(bytes) + " bytes cannot hold";
}

// Of a count as it stands there; 0 for what is no number, or too long for one.
double number(const std::string& word) {
  std::istringstream stream(word);
  double value = 0.0;
  return stream >> value ? value : 0.0;
}

// "OFF", or a variant of it such as "COFF", then vertices, faces and edges; '#' begins a comment.
std::string off_claims(std::istream& file, std::uint64_t bytes) {
  std::array<std::string, 3> words;  // the name, vertices, faces
  std::size_t found = 0;
  std::string line;
  for (int k = 0; k < kLongestHeader && found < words.size() && std::getline(file, line); ++k) {
    std::istringstream text(line.substr(0, line.find('#')));
    for (std::string word; found < words.size() && text >> word;) {
      if (word == "BINARY") return "it is binary; of OFF files only text can be read";
      words[found++] = word;
    }
  }
  const double vertices = number(words[1]), faces = number(words[2]);
  const auto room = static_cast<double>(bytes);
  if (vertices * kOffVertex > room) return too_much(words[1], "vertices", bytes);
  if (faces * kOffFace > room) return too_much(words[2], "faces", bytes);
  return "";
}

std::string ply_claims(std::istream& file, std::uint64_t bytes) {
  std::string line;
  for (int k = 0; k < kLongestHeader && std::getline(file, line); ++k) {
    std::istringstream text(line);
    std::string word, what, count;
    text >> word >> what >> count;
    if (word == "end_header") break;
    if (word != "element") continue;
    const double least = what == "vertex" ? kPlyVertex : what == "face" ? kPlyFace : kPlyElement;
    if (number(count) * least <= static_cast<double>(bytes)) continue;
    const bool known = what == "vertex" || what == "face";
    return too_much(count, known ? (what == "vertex" ? "vertices" : "faces") : "elements", bytes);
  }
  return "";
}

// A text begins with "solid"; so do some binary files, whose size then tells them.
std::string stl_claims(std::istream& file, std::uint64_t bytes) {
  std::array<char, static_cast<std::size_t>(kStlHeader)> header{};
  if (!file.read(header.data(), header.size())) return "";
  if (std::string_view(header.data(), 5) == "solid") return "";
  std::uint32_t triangles = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    triangles |= std::uint32_t{static_cast<unsigned char>(header[80 + k])} << (8 * k);
  }
  if (kStlHeader + triangles * kStlTriangle <= static_cast<double>(bytes)) return "";
  return too_much(std::to_string(triangles), "triangles", bytes);
}

}  // namespace

std::string claims_too_much(std::istream& file, const std::string& format, std::uint64_t bytes) {
  if (format == "off") return off_claims(file, bytes);
  if (format == "ply") return ply_claims(file, bytes);
  if (format == "stl") return stl_claims(file, bytes);
  return "";
}

}  // namespace stiction::reference
