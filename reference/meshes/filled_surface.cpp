// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/meshes/filled_surface.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

namespace stiction::reference {

namespace {

using Eigen::Index;

template <class Number>
void append(std::string& text, Number number, char after) {
  std::array<char, 32> digits;
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), written.ptr);
  text += after;
}

/// Words and numbers, one after the other, whatever white space is between them.
class Words {
 public:
  explicit Words(std::string_view text) : left_(text) {}

  void expect(std::string_view word) {
    if (next() != word) throw std::invalid_argument("'" + std::string(word) + "' is missing");
  }

  template <class Number>
  Number number() {
    const std::string_view word = next();
    Number value{};
    const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || read.ec != std::errc{} || read.ptr != word.data() + word.size()) {
      throw std::invalid_argument("'" + std::string(word) + "' is no number");
    }
    return value;
  }

  double finite() {
    const double value = number<double>();
    if (!std::isfinite(value)) throw std::invalid_argument("a number is not finite");
    return value;
  }

  /// Of things of which each takes at least `characters`, so that no memory is asked for in vain.
  Index count(std::size_t characters) {
    const Index value = number<Index>();
    if (value < 0 || static_cast<std::size_t>(value) > left_.size() / characters) {
      throw std::invalid_argument("it is shorter than it says");
    }
    return value;
  }

 private:
  std::string_view next() {
    constexpr std::string_view kSpace = " \t\r\n\v\f";
    left_.remove_prefix(std::min(left_.find_first_not_of(kSpace), left_.size()));
    const std::string_view word = left_.substr(0, left_.find_first_of(kSpace));
    left_.remove_prefix(word.size());
    return word;
  }

  std::string_view left_;
};

}  // namespace

std::string to_text(const FilledSurface& filled) {
  const TetMesh& mesh = filled.mesh;
  std::string text = "stiction filled surface 1\ngiven ";
  append(text, filled.given_triangles, ' ');
  append(text, filled.given_volume, '\n');
  text += "vertices ";
  append(text, mesh.vertices.cols(), '\n');
  for (Index v = 0; v < mesh.vertices.cols(); ++v) {
    for (int k = 0; k < 3; ++k) append(text, mesh.vertices(k, v), k < 2 ? ' ' : '\n');
  }
  text += "tetrahedra ";
  append(text, mesh.tetrahedra.cols(), '\n');
  for (Index e = 0; e < mesh.tetrahedra.cols(); ++e) {
    for (int k = 0; k < 4; ++k) append(text, mesh.tetrahedra(k, e), k < 3 ? ' ' : '\n');
  }
  return text + "end\n";
}

FilledSurface filled_surface_from(std::string_view text) {
  Words words(text);
  for (const char* const word : {"stiction", "filled", "surface", "1"}) words.expect(word);
  FilledSurface filled;
  words.expect("given");
  filled.given_triangles = words.number<Index>();
  filled.given_volume = words.finite();
  words.expect("vertices");
  filled.mesh.vertices.resize(3, words.count(sizeof("0 0 0")));
  for (double& coordinate : filled.mesh.vertices.reshaped()) coordinate = words.finite();
  words.expect("tetrahedra");
  filled.mesh.tetrahedra.resize(4, words.count(sizeof("0 1 2 3")));
  for (int& corner : filled.mesh.tetrahedra.reshaped()) {
    corner = words.number<int>();
    if (corner < 0 || corner >= filled.mesh.vertices.cols()) {
      throw std::invalid_argument("a tetrahedron names no such vertex");
    }
  }
  words.expect("end");
  return filled;
}

}  // namespace stiction::reference
