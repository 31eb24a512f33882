// SPDX-License-Identifier: BSD-3-Clause
#include "solver/contact/contact_order.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace stiction {

namespace {

// Contacts of a chunk: their records, 64 KiB of what a sweep reads, fit a second-level cache, and a
// thread has some 10 µs to do.
constexpr std::size_t kChunk = 512;

constexpr std::size_t kCorners = 5;  // of a contact between bodies

std::int32_t corner(const PairContact& contact, std::size_t k) {
  return k == 0 ? contact.vertex : contact.partner[k - 1];
}

}  // namespace

void ContactOrder::in_one_chunk(std::size_t contacts) {
  contacts_ = contacts;
  chunk_.assign(contacts > 0 ? 1 : 0, {0, contacts});
  colour_begin_.assign({0, chunk_.size()});
  corner_.clear();
}

bool ContactOrder::is_of(const PairContacts& pairs) const {
  if (corner_.size() != kCorners * pairs.size()) return false;
  const std::int32_t* known = corner_.data();
  for (const PairContact& contact : pairs) {
    for (std::size_t k = 0; k < kCorners; ++k) {
      if (*known++ != corner(contact, k)) return false;
    }
  }
  return true;
}

void ContactOrder::make(const PairContacts& pairs, std::size_t vertices) {
  if (pairs.size() < kMany) {
    in_one_chunk(pairs.size());
  } else if (!is_of(pairs)) {
    colour(pairs, vertices);
  }
}

void ContactOrder::colour(const PairContacts& pairs, std::size_t vertices) {
  // Chunks that find no colour free, because nearly all touch the same vertices, are done one by one.
  constexpr std::size_t kColours = 64;
  std::vector<std::uint64_t> taken(vertices, 0);  // bit by bit: the colours at a vertex
  std::vector<std::vector<Chunk>> of_colour(kColours);
  std::vector<Chunk> alone;
  contacts_ = pairs.size();
  corner_.clear();
  corner_.reserve(kCorners * pairs.size());
  for (std::size_t begin = 0; begin < pairs.size(); begin += kChunk) {
    const Chunk chunk{begin, std::min(begin + kChunk, pairs.size())};
    std::uint64_t unfit = 0;
    for (std::size_t c = chunk.begin; c < chunk.end; ++c) {
      for (std::size_t k = 0; k < kCorners; ++k) {
        corner_.push_back(corner(pairs[c], k));
        unfit |= taken[static_cast<std::size_t>(corner_.back())];
      }
    }
    if (unfit == std::numeric_limits<std::uint64_t>::max()) {
      alone.push_back(chunk);
      continue;
    }
    const int colour = std::countr_one(unfit);
    of_colour[static_cast<std::size_t>(colour)].push_back(chunk);
    for (std::size_t k = kCorners * chunk.begin; k < kCorners * chunk.end; ++k) {
      taken[static_cast<std::size_t>(corner_[k])] |= std::uint64_t{1} << colour;
    }
  }
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
    end = std::min(begin + kChunk, last);
    chunk_.push_back({begin, end});
    if (end == last) colour_begin_.push_back(chunk_.size());
  }
}

}  // namespace stiction
