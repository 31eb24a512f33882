// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/contact/contacts.h"
#include "solver/contact/pair_contacts.h"
#include "solver/parallel/team.h"

namespace stiction {

/// The order in which forces of contacts go to their vertices. Few contacts have that of their keys.
/// Many are cut into chunks of neighbours, and chunks that share no vertex have the same colour:
/// colour by colour, the threads of a team do the chunks of one side by side, and each vertex gets
/// its forces in the same order for any number of threads. It follows from the contacts of the step
/// alone, so that a state that is restored goes on as it did.
class ContactOrder {
 public:
  /// Contacts [begin, end).
  struct Chunk {
    std::size_t begin = 0, end = 0;
  };

  /// Fewer contacts than this are one chunk: threads would gain nothing.
  static constexpr std::size_t kMany = 4096;

  /// So many contacts in the order of their keys.
  void in_one_chunk(std::size_t contacts);
  /// Of contacts between bodies; a scene has so many vertices.
  void make(const PairContacts& pairs, std::size_t vertices);
  /// Of contacts with obstacles, whose colour is the obstacle.
  void make(const OneSidedContacts& contacts);

  /// Whether it was made for so many contacts.
  bool is_for(std::size_t contacts) const {
    return !colour_begin_.empty() && contacts == contacts_;
  }

  std::size_t chunks() const { return chunk_.size(); }
  std::size_t colours() const { return colour_begin_.empty() ? 0 : colour_begin_.size() - 1; }
  /// Of a colour; that of `colours()` is `chunks()`.
  std::size_t first_chunk(std::size_t colour) const { return colour_begin_[colour]; }

  /// Calls work(k, chunk) for the k-th chunk of all, each once: colour after colour.
  template <class Work>
  void for_each_chunk(const Team* team, const Work& work) const {
    for (std::size_t colour = 0; colour + 1 < colour_begin_.size(); ++colour) {
      const std::size_t first = colour_begin_[colour];
      for_each(team, colour_begin_[colour + 1] - first,
               [&](std::size_t k) { work(first + k, chunk_[first + k]); });
    }
  }

  /// Calls work(c) for each contact.
  template <class Work>
  void for_each_contact(const Team* team, const Work& work) const {
    for_each_chunk(team, [&](std::size_t, const Chunk& chunk) {
      for (std::size_t c = chunk.begin; c < chunk.end; ++c) work(c);
    });
  }

 private:
  bool is_of(const PairContacts& pairs) const;
  void colour(const PairContacts& pairs, std::size_t vertices);

  std::size_t contacts_ = 0;
  std::vector<Chunk> chunk_;               // colour by colour
  std::vector<std::size_t> colour_begin_;  // in chunk_, and its size behind the last
  std::vector<std::int32_t> corner_;       // the vertices of the contacts that were coloured
};

}  // namespace stiction
