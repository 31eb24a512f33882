// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/contact/contacts.h"
#include "solver/contact/edge_contacts.h"
#include "solver/contact/pair_contacts.h"
#include "solver/parallel/team.h"
#include "solver/prefetch.h"

namespace stiction {

/// The order in which forces of contacts go to their vertices. Few contacts have that of their keys.
/// Many come in that of the first of their vertices along a curve through the scene, so that those
/// stand together that lie together, whichever of two bodies a vertex is of, and are cut into chunks;
/// chunks that share no vertex have the same colour: colour by colour, the threads of a team do the
/// chunks of one side by side, and each vertex gets its forces in the same order for any number of
/// threads. It follows from the scene and the contacts of the step alone, so that a state that is
/// restored goes on as it did.
///
/// Contacts that share no vertex can change places without changing a bit. Where contacts have lasted
/// for a step, those that share one are put apart: each comes in the first round after those of all
/// contacts before it with which it shares a vertex (level scheduling, as of sparse triangular
/// solves), so that the processor has several to do at once, none of which waits for the last.
class ContactOrder {
 public:
  /// Places [begin, end). Contacts with obstacles have those of their own numbers, others those that
  /// `sequence` says.
  struct Chunk {
    std::size_t begin = 0, end = 0;
  };

  /// Fewer contacts than this are one chunk: in chunks fewer stand apart, which takes one thread some 5 %
  /// longer (friction of 10⁴), and each thread would have a microsecond or two to do of a colour.
  static constexpr std::size_t kMany = 1536;

  /// So many contacts in the order of their keys.
  void in_one_chunk(std::size_t contacts);
  /// Of contacts between bodies; `places` are those of the scene's vertices along the curve
  /// (Topology::vertex_place). Calls work(chunk) for each chunk, as by `for_each_chunk`: while it is found
  /// out whether these are the contacts that the order was made of before, so that each record is fetched
  /// once for both. `restart()` comes first, and again where they are not and all chunks are others.
  template <class Restart, class Work>
  void make(const PairContacts& pairs, std::span<const std::int32_t> places, const Team* team,
            const Restart& restart, const Work& work) {
    restart();
    if (is_for(pairs.size())) {
      const bool known = pairs.same_order != 0 && pairs.same_order == of_;
      std::atomic<bool> lasts = true;
      for_each_chunk(team, [&](std::size_t, const Chunk& chunk) {
        if (!known && !is_of(pairs, chunk)) lasts = false;
        work(chunk);
      });
      if (lasts) {
        of_ = pairs.same_order;
        return put_apart(places.size());
      }
      restart();
    }
    make_anew(pairs, places);
    of_ = pairs.same_order;
    for_each_chunk(team, [&](std::size_t, const Chunk& chunk) { work(chunk); });
  }
  void make(const PairContacts& pairs, std::span<const std::int32_t> places) {
    make(
        pairs, places, nullptr, [] {}, [](const Chunk&) {});
  }
  /// Of edges.
  void make(const EdgeContacts& edges, std::span<const std::int32_t> places);
  /// Of contacts with obstacles, whose colour is the obstacle.
  void make(const OneSidedContacts& contacts);

  /// Whether it was made of contacts, between bodies or of edges, with the same keys and vertices.
  template <class Contacts>
  bool is_of(const Contacts& contacts) const {
    return is_for(contacts.size()) && is_of(contacts, {0, contacts.size()});
  }
  /// The keys of those that it was made of.
  const std::vector<ContactKey>& keys() const { return key_; }
  /// Whether it was made for so many contacts.
  bool is_for(std::size_t contacts) const {
    return !colour_begin_.empty() && contacts == contacts_;
  }

  /// Which contacts stand at the places.
  class Sequence {
   public:
    std::size_t contact(std::size_t place) const {
      return static_cast<std::size_t>(contact_[place]);
    }
    /// For what a sweep will read of contacts at places after this one, and of what there is of each of their
    /// vertices, where it doesn't stay in the nearer caches: out of its order the processor doesn't ask by itself.
    template <class... OfVertex>
    void ask_ahead(const PairContact* contacts, std::size_t place,
                   const OfVertex*... of_vertex) const {
      if (place >= asks_until_) return;
      const auto* const far =
          reinterpret_cast<const char*>(&contacts[contact(place + kAskedAhead)]);
      ask_for(far);
      ask_for(far + alignof(PairContact));
      if (!far_apart_) return;
      const PairContact& near = contacts[contact(place + kAskedAhead / 2)];
      (ask_for_vertices(near, of_vertex), ...);
    }

   private:
    friend class ContactOrder;

    // Of three partners, which are all that a triangle has.
    template <class OfVertex>
    static void ask_for_vertices(const PairContact& contact, const OfVertex* of_vertex) {
      ask_for(of_vertex + contact.vertex);
      for (int k = 0; k < 3; ++k) ask_for(of_vertex + contact.partner[k]);
    }

    const std::int32_t* contact_ = nullptr;
    std::size_t asks_until_ = 0;
    bool far_apart_ = false;
  };
  Sequence sequence() const {
    Sequence sequence;
    sequence.contact_ = contact_.data();
    sequence.asks_until_ = asks_until(contact_.size());
    sequence.far_apart_ = lie_far_apart(contact_.size());
    return sequence;
  }

  /// The contacts of a chunk as they stood before they were put apart.
  std::span<const std::int32_t> in_turn(const Chunk& chunk) const {
    return {in_turn_.data() + chunk.begin, chunk.end - chunk.begin};
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

 private:
  template <class Contacts>
  bool is_of(const Contacts& contacts, const Chunk& chunk) const;
  template <class Contacts>
  void remember(const Contacts& contacts);
  template <class Contacts>
  void make_anew(const Contacts& contacts, std::span<const std::int32_t> places);
  void bring_together(std::span<const std::int32_t> places);
  void colour(std::size_t vertices);
  void put_apart(std::size_t vertices);
  std::int32_t put_apart_in(const Chunk& window, std::int32_t before);

  std::size_t contacts_ = 0;
  std::uint64_t of_ = 0;                   // PairContacts::same_order of those it was made of
  std::vector<Chunk> chunk_;               // colour by colour
  std::vector<std::size_t> colour_begin_;  // in chunk_, and its size behind the last

  // Of contacts between bodies or of edges.
  std::size_t corners_ = 0;            // vertices that each has
  std::vector<std::int32_t> corner_;   // these, one contact after the other
  std::vector<ContactKey> key_;        // of each
  std::vector<std::int32_t> in_turn_;  // the contact of each place before they were put apart,
  std::vector<std::int32_t> contact_;  // and now
  bool apart_ = false;                 // whether neighbours stand apart
  std::vector<std::int32_t> round_;    // scratch: per vertex, the last round that has it
  std::vector<std::int32_t> next_;  // scratch: per part of the curve, where its next contact comes
  std::vector<std::uint64_t> taken_;  // scratch: per vertex, its colours bit by bit; 0 between uses
  std::vector<std::int32_t> round_of_, round_begin_;  // scratch: per contact; per round
};

}  // namespace stiction
