// SPDX-License-Identifier: BSD-3-Clause
#include "solver/contact/contact_order.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>

namespace stiction {

namespace {

// Of so many contacts, how many a chunk has: no more than whose records, 64 KiB of what a sweep reads, fit a
// second-level cache, and few enough that each thread has several of a colour.
std::size_t chunk_of(std::size_t contacts) {
  return std::clamp<std::size_t>(contacts / 32, 64, 512);
}

// Vertices of a contact as they lie in its record: its own in front of the four partners.
template <class Contact>
constexpr std::size_t kCorners = 4 + sizeof(Contact::vertex) / sizeof(std::int32_t);

template <class Contact>
const std::int32_t* corners_of(const Contact& contact) {
  static_assert(offsetof(Contact, partner) == offsetof(Contact, vertex) + sizeof(Contact::vertex));
  return reinterpret_cast<const std::int32_t*>(reinterpret_cast<const char*>(&contact) +
                                               offsetof(Contact, vertex));
}

ContactKey key_of(const PairContact& contact) { return contact.key(); }
ContactKey key_of(const EdgeContact& contact) { return contact.key; }

}  // namespace

void ContactOrder::in_one_chunk(std::size_t contacts) {
  contacts_ = contacts;
  of_ = 0;
  chunk_.assign(contacts > 0 ? 1 : 0, {0, contacts});
  colour_begin_.assign({0, chunk_.size()});
  corner_.clear();
  key_.clear();
  in_turn_.clear();
  contact_.clear();
}

template <class Contacts>
void ContactOrder::remember(const Contacts& contacts) {
  in_one_chunk(contacts.size());
  corners_ = kCorners<typename Contacts::value_type>;
  corner_.resize(corners_ * contacts.size());
  key_.resize(contacts.size());
  in_turn_.resize(contacts.size());
  std::iota(in_turn_.begin(), in_turn_.end(), 0);
  apart_ = false;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    std::memcpy(&corner_[corners_ * c], corners_of(contacts[c]), corners_ * sizeof(std::int32_t));
    key_[c] = key_of(contacts[c]);
  }
}

template <class Contacts>
bool ContactOrder::is_of(const Contacts& contacts, const Chunk& chunk) const {
  constexpr std::size_t kOfEach = kCorners<typename Contacts::value_type>;
  constexpr std::size_t kBytes = kOfEach * sizeof(std::int32_t);
  if (key_.size() != contacts.size() || corners_ != kOfEach) return false;
  for (const std::int32_t place : in_turn(chunk)) {
    const auto c = static_cast<std::size_t>(place);
    if (key_[c] != key_of(contacts[c]) ||
        std::memcmp(&corner_[corners_ * c], corners_of(contacts[c]), kBytes) != 0) {
      return false;
    }
  }
  return true;
}
template bool ContactOrder::is_of(const PairContacts&, const Chunk&) const;
template bool ContactOrder::is_of(const EdgeContacts&, const Chunk&) const;

template <class Contacts>
void ContactOrder::make_anew(const Contacts& contacts, std::span<const std::int32_t> places) {
  remember(contacts);
  if (contacts.size() >= kMany) {
    bring_together(places);
    colour(places.size());
  }
  contact_ = in_turn_;
}
template void ContactOrder::make_anew(const PairContacts&, std::span<const std::int32_t>);

void ContactOrder::make(const EdgeContacts& edges, std::span<const std::int32_t> places) {
  if (is_of(edges)) {
    put_apart(places.size());
  } else {
    make_anew(edges, places);
  }
}

// In the order of the parts of the curve where their first vertices are, then of their keys. A chunk has
// some four parts: with more of them records, which lie in the order of their keys, are fetched piecemeal
// (forces of 10⁵ contacts on plates took 15 % longer), with fewer chunks share more vertices.
void ContactOrder::bring_together(std::span<const std::int32_t> places) {
  const std::size_t parts = 4 * contacts_ / chunk_of(contacts_);
  const auto shift = static_cast<int>(std::bit_width(places.size() / parts));
  const auto part_of = [&](std::size_t c) {
    std::int32_t first = std::numeric_limits<std::int32_t>::max();
    for (std::size_t k = corners_ * c; k < corners_ * (c + 1); ++k) {
      first = std::min(first, places[static_cast<std::size_t>(corner_[k])]);
    }
    return static_cast<std::size_t>(first >> shift);
  };
  next_.assign((places.size() >> shift) + 2, 0);
  for (std::size_t c = 0; c < contacts_; ++c) ++next_[part_of(c) + 1];
  std::partial_sum(next_.begin(), next_.end(), next_.begin());
  for (std::size_t c = 0; c < contacts_; ++c) {
    in_turn_[static_cast<std::size_t>(next_[part_of(c)]++)] = static_cast<std::int32_t>(c);
  }
}

// If they don't stand apart already.
void ContactOrder::put_apart(std::size_t vertices) {
  if (apart_) return;
  // So many contacts are put apart among themselves. Far apart is best (friction of 1000 takes 21 ns a
  // contact in the order of their keys, 19 in windows of 16, 16 in those of 256), as long as records
  // wait in a cache near by; else the memory wants them one after the other (100 000: 36 ns, 35, 44).
  // Those of a round side by side, a contact a lane, was tried with the same bits: 24 ns each by eights where one at a
  // time takes 30, but on plates a round of the order of keys has some four, and friction took 0.94 of its time there,
  // 0.95 in piles, where nearly all go by eights, and no less at 10 000.
  const std::size_t window = lie_far_apart(contacts_) ? 16 : 256;
  round_.assign(vertices, 0);
  std::int32_t rounds = 0;
  for (const Chunk& chunk : chunk_) {
    for (std::size_t begin = chunk.begin; begin < chunk.end; begin += window) {
      rounds = put_apart_in({begin, std::min(begin + window, chunk.end)}, rounds);
    }
  }
  apart_ = true;
}

// Behind so many rounds of other windows; returns those with this one's.
std::int32_t ContactOrder::put_apart_in(const Chunk& window, std::int32_t before) {
  round_of_.resize(window.end - window.begin);
  round_begin_.assign(window.end - window.begin + 1, 0);
  std::int32_t last = before;
  for (std::size_t at = window.begin; at < window.end; ++at) {
    const std::int32_t* const vertex = &corner_[corners_ * static_cast<std::size_t>(in_turn_[at])];
    std::int32_t round = before;
    for (std::size_t k = 0; k < corners_; ++k) {
      round = std::max(round, round_[static_cast<std::size_t>(vertex[k])]);
    }
    ++round;
    for (std::size_t k = 0; k < corners_; ++k) round_[static_cast<std::size_t>(vertex[k])] = round;
    round_of_[at - window.begin] = round - before;
    ++round_begin_[static_cast<std::size_t>(round - before)];
    last = std::max(last, round);
  }
  // Round by round, each in the order that they had.
  std::partial_sum(round_begin_.begin(), round_begin_.end(), round_begin_.begin());
  for (std::size_t at = window.begin; at < window.end; ++at) {
    const auto round = static_cast<std::size_t>(round_of_[at - window.begin]);
    const auto place = static_cast<std::size_t>(round_begin_[round - 1]++);
    contact_[window.begin + place] = in_turn_[at];
  }
  return last;
}

void ContactOrder::colour(std::size_t vertices) {
  // Chunks that find no colour free, because nearly all touch the same vertices, are done one by one.
  constexpr std::size_t kColours = 64;
  taken_.resize(vertices, 0);
  std::vector<std::vector<Chunk>> of_colour(kColours);
  std::vector<Chunk> alone;
  const std::size_t size = chunk_of(contacts_);
  for (std::size_t begin = 0; begin < contacts_; begin += size) {
    const Chunk chunk{begin, std::min(begin + size, contacts_)};
    const auto for_each_taken = [&](const auto& work) {
      for (const std::int32_t c : in_turn(chunk)) {
        const std::int32_t* const corner = &corner_[corners_ * static_cast<std::size_t>(c)];
        for (std::size_t k = 0; k < corners_; ++k)
          work(taken_[static_cast<std::size_t>(corner[k])]);
      }
    };
    std::uint64_t unfit = 0;
    for_each_taken([&](std::uint64_t at) { unfit |= at; });
    if (unfit == std::numeric_limits<std::uint64_t>::max()) {
      alone.push_back(chunk);
      continue;
    }
    const int colour = std::countr_one(unfit);
    of_colour[static_cast<std::size_t>(colour)].push_back(chunk);
    for_each_taken([&](std::uint64_t& at) { at |= std::uint64_t{1} << colour; });
  }
  for (const std::int32_t v : corner_) taken_[static_cast<std::size_t>(v)] = 0;
  chunk_.clear();
  colour_begin_.assign(1, 0);
  const auto end_colour = [this] { colour_begin_.push_back(chunk_.size()); };
  for (const std::vector<Chunk>& chunks : of_colour) {
    if (chunks.empty()) break;
    chunk_.insert(chunk_.end(), chunks.begin(), chunks.end());
    end_colour();
  }
  for (const Chunk& chunk : alone) {
    chunk_.push_back(chunk);
    end_colour();
  }
}

void ContactOrder::make(const OneSidedContacts& contacts) {
  const std::size_t count = contacts.size();
  if (count < kMany) {
    in_one_chunk(count);
    return;
  }
  contacts_ = count;
  chunk_.clear();
  colour_begin_.assign(1, 0);
  for (std::size_t begin = 0, end; begin < count; begin = end) {
    // Contacts with one obstacle stand together, each with a vertex of its own.
    const auto other = std::upper_bound(contacts.obstacle.begin(), contacts.obstacle.end(),
                                        contacts.obstacle[begin]);
    const auto last = static_cast<std::size_t>(other - contacts.obstacle.begin());
    end = std::min(begin + chunk_of(count), last);
    chunk_.push_back({begin, end});
    if (end == last) colour_begin_.push_back(chunk_.size());
  }
}

}  // namespace stiction
