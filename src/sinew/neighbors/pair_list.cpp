#include <sinew/core/error.hpp>
#include <sinew/neighbors/body_search.hpp>
#include <sinew/neighbors/pair_list.hpp>
#include <sinew/neighbors/store.hpp>
#include <sinew/neighbors/threads.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace sinew {

namespace {

/// A piece of a body that one thread does, and the neighbors in the form in which they are found: eights, that is, eight sorted
/// places in a row that hold some of them.
template <int D>
struct Piece {
  const BodySearch<D>* search;
  int begin, end;                       ///< slots
  const int* eights = nullptr;          ///< how many each particle has
  const int* place = nullptr;           ///< of each eight, the first of the places
  const std::uint8_t* which = nullptr;  ///< of each eight, bit k: place + k holds a neighbor
};

constexpr int piece_slots = 32 * lanes;  // enough for its overhead, little enough for the caches

template <int D>
std::vector<BodySearch<D>> make_searches(const Arrangement<D>& particles) {
  std::vector<BodySearch<D>> searches;
  searches.reserve(particles.bodies.size());
  for (const BodyRange& body : particles.bodies) searches.emplace_back(particles, body);
  return searches;
}

/// Pieces in which wanted(begin, end).
template <int D, class Wanted>
std::vector<Piece<D>> make_pieces(const std::vector<BodySearch<D>>& searches, const Wanted& wanted) {
  std::vector<Piece<D>> pieces;
  for (const BodySearch<D>& search : searches)
    for (int begin = search.body().begin; begin < search.body().end; begin += piece_slots) {
      const int end = std::min(begin + piece_slots, search.body().end);
      if (wanted(begin, end)) pieces.push_back({&search, begin, end});
    }
  return pieces;
}

/// Finds the neighbors of the particles of a piece, and counts them. One for each thread; it keeps its memory.
template <int D>
class alignas(64) NeighborFinder {
 public:
  void find(Piece<D>& piece, const std::vector<double>& radius, int* count) {
    used_ = 0;
    eights_.clear();
    for (int slot = piece.begin; slot < piece.end; slot += lanes) {
      piece.search->find_rows(slot, radius.data() + slot, rows_);
      for (int k = 0; k < piece.search->particles_in(slot); ++k) {
        const std::size_t before = used_;
        count[slot + k] = find(*piece.search, slot + k, radius[slot + k]);
        eights_.push_back(static_cast<int>(used_ - before));
      }
    }
    piece.eights = store_.keep(eights_, eights_.size());
    piece.place = store_.keep(place_, used_);
    piece.which = store_.keep(which_, used_);
  }

 private:
  int find(const BodySearch<D>& search, int slot, double radius) {
    const Pack limit(radius * radius);
    int* place = place_.data();
    std::uint8_t* which = which_.data();
    std::size_t used = used_, room = place_.size();
    int count = 0;
    search.for_each_eight(slot, radius, rows_, [&](int first, const Pack& distance2, unsigned others) {
      if (used == room) {
        room = 2 * room + 4096;
        place_.resize(room);
        which_.resize(room);
        place = place_.data();
        which = which_.data();
      }
      const unsigned bits = lane_bits::bits_of(distance2 < limit) & others;
      place[used] = first;
      which[used] = static_cast<std::uint8_t>(bits);
      used += static_cast<std::size_t>(bits != 0U);
      count += std::popcount(bits);
    });
    used_ = used;
    return count;
  }

  std::vector<NearRow> rows_;
  std::vector<int> eights_, place_;
  std::vector<std::uint8_t> which_;
  std::size_t used_ = 0;  ///< of the last two
  Store store_;
};

/// Writes the entries of a piece into the list. One for each thread; it keeps its memory.
template <int D>
class EntryWriter {
 public:
  void write(const Piece<D>& piece, PairList& list) {
    const int* eights = piece.eights;
    const int* place = piece.place;
    const std::uint8_t* which = piece.which;
    for (int slot = piece.begin; slot < piece.end; slot += lanes) {
      const std::size_t first = list.first_entry[slot / lanes], longest = list.first_entry[slot / lanes + 1] - first;
      if (row_.size() < longest + lanes) row_.resize(longest + lanes);  // a whole register is written for the last neighbors
      int* out = list.neighbor.data() + lanes * first;
      for (int k = 0; k < lanes; ++k) {
        const int count = list.neighbor_count[slot + k];
        if (k < piece.search->particles_in(slot)) {
          expand(*piece.search, {place, which, *eights}, count);
          place += *eights;
          which += *eights++;
        }
        for (int n = 0; n < count; ++n) out[lanes * n + k] = row_[n];
        for (std::size_t n = count; n < longest; ++n) out[lanes * n + k] = slot + k;
      }
    }
  }

 private:
  struct Eights {
    const int* place;
    const std::uint8_t* which;
    int count;
  };

  /// The neighbors of one particle as ascending slots.
  void expand(const BodySearch<D>& search, const Eights& eights, int count) {
    const int begin = search.body().begin;
    int* next = row_.data();
    for (int e = 0; e < eights.count; ++e) {
      const std::array<int, lanes>& bits = lane_bits::set_bits.of[eights.which[e]];
      for (int k = 0; k < lanes; ++k) next[k] = begin + eights.place[e] + bits[k];
      next += std::popcount(eights.which[e]);
    }
    if (search.cells().keeps_order()) return;
    std::transform(row_.data(), next, row_.data(), [&](int place) { return begin + search.cells().number(place - begin); });
    std::sort(row_.data(), row_.data() + count);
  }

  std::vector<int> row_;
};

/// Finds the radii of a piece. One for each thread; it keeps its memory.
template <int D>
class RadiusFinder {
 public:
  explicit RadiusFinder(int neighbors) : wanted_(neighbors) {}

  void find(const Piece<D>& piece, std::vector<double>& radius) {
    // a little more than the mean volume per particle asks for. Any guess gives the same radii
    const double first_guess = piece.search->body().spacing * (D == 3 ? std::cbrt(0.3 * wanted_) : std::sqrt(0.4 * wanted_));
    double guess = first_guess;
    for (int slot = piece.begin; slot < piece.end; slot += lanes)
      guess = std::max(0.1 * first_guess, 1.03 * find(*piece.search, slot, guess, radius.data() + slot));
  }

 private:
  /// Returns the largest distance of a particle that is just out.
  double find(const BodySearch<D>& search, int slot, double guess, double* radius) {
    double farthest2 = 0.0, reach[lanes];
    std::fill(reach, reach + lanes, guess);
    unsigned open = (1U << search.particles_in(slot)) - 1U;
    while (open != 0U) {
      search.find_rows(slot, reach, rows_);
      for (int k = 0; k < lanes; ++k) {
        if ((open >> k & 1U) == 0U) continue;
        const std::ptrdiff_t count = distances(search, slot + k, reach[k]);
        if (count <= wanted_) {
          reach[k] *= 1.25;
          continue;
        }
        open &= ~(1U << k);
        std::nth_element(distance2_.begin(), distance2_.begin() + wanted_, distance2_.begin() + count);
        const double outside = distance2_[wanted_];
        const double inside = *std::max_element(distance2_.begin(), distance2_.begin() + wanted_);
        radius[k] = std::pow(0.5 * (std::pow(inside, 0.5 * D) + std::pow(outside, 0.5 * D)), 1.0 / D);
        farthest2 = std::max(farthest2, outside);
      }
    }
    return std::sqrt(farthest2);
  }

  /// Collects the squared distances of all that are closer than `reach`, and returns how many.
  std::ptrdiff_t distances(const BodySearch<D>& search, int slot, double reach) {
    std::size_t count = 0;
    search.for_each_eight(slot, reach, rows_, [&](int, const Pack& r2, unsigned others) {
      const unsigned bits = lane_bits::bits_of(r2 < Pack(reach * reach)) & others;
      alignas(64) double distance2[lanes];
      r2.store(distance2);
      if (distance2_.size() < count + lanes) distance2_.resize(2 * count + 64);
      for (int k = 0; k < lanes; ++k) distance2_[count + k] = distance2[lane_bits::set_bits.of[bits][k]];
      count += std::popcount(bits);
    });
    return static_cast<std::ptrdiff_t>(count);
  }

  int wanted_;
  std::vector<NearRow> rows_;
  std::vector<double> distance2_;
};

void count_entries(PairList& list) {
  const std::size_t slices = list.neighbor_count.size() / lanes;
  list.first_entry.assign(slices + 1, 0);
  for (std::size_t s = 0; s < slices; ++s) {
    const int* counts = list.neighbor_count.data() + lanes * s;
    list.first_entry[s + 1] = list.first_entry[s] + *std::max_element(counts, counts + lanes);
    for (int k = 0; k < lanes; ++k) list.pairs += counts[k];
  }
}

}  // namespace

template <int D>
PairList build_pair_list(const Arrangement<D>& particles, const std::vector<double>& support_radius) {
  const std::vector<BodySearch<D>> searches = make_searches(particles);
  const auto some_see = [&](int begin, int end) {
    return std::any_of(support_radius.begin() + begin, support_radius.begin() + end, [](double r) { return r > 0.0; });
  };
  std::vector<Piece<D>> pieces = make_pieces(searches, some_see);
  const int count = static_cast<int>(pieces.size());
  PairList list;
  list.neighbor_count.assign(particles.slots, 0);
  std::vector<NeighborFinder<D>> finders(most_threads());
#pragma omp parallel for schedule(dynamic, 1) if (particles.slots >= fewest_for_threads)
  for (int b = 0; b < count; ++b) finders[this_thread()].find(pieces[b], support_radius, list.neighbor_count.data());
  count_entries(list);
  list.neighbor = AlignedArray<int>(list.entries() * lanes);
#pragma omp parallel if (particles.slots >= fewest_for_threads)
  {
    EntryWriter<D> writer;
#pragma omp for schedule(dynamic, 1)
    for (int b = 0; b < count; ++b) writer.write(pieces[b], list);
  }
  return list;
}

template <int D>
std::vector<double> radius_of_neighbors(const Arrangement<D>& particles, double neighbors, const std::vector<int>& blocks) {
  const int wanted = static_cast<int>(std::lround(neighbors));
  for (const BodyRange& body : particles.bodies)
    if (body.count < wanted + 2)
      throw CaseError("body \"" + body.name + "\" has " + std::to_string(body.count) + " particles, too few for neighbors = " +
                      std::to_string(wanted) + " around each. Make its spacing smaller or ask for fewer neighbors.");
  const std::vector<BodySearch<D>> searches = make_searches(particles);
  const auto ends_before = [&](int number, int slot) { return particles.blocks[number].end <= slot; };
  const auto in_blocks = [&](int begin, int end) {
    const auto next = std::lower_bound(blocks.begin(), blocks.end(), begin, ends_before);
    return next != blocks.end() && particles.blocks[*next].begin < end;
  };
  const std::vector<Piece<D>> pieces = make_pieces(searches, in_blocks);
  const int count = static_cast<int>(pieces.size());
  std::vector<double> radius(particles.slots, 0.0);
#pragma omp parallel if (particles.slots >= fewest_for_threads)
  {
    RadiusFinder<D> finder(wanted);
#pragma omp for schedule(dynamic, 1)
    for (int b = 0; b < count; ++b) finder.find(pieces[b], radius);
  }
  return radius;
}

template PairList build_pair_list<2>(const Arrangement<2>&, const std::vector<double>&);
template PairList build_pair_list<3>(const Arrangement<3>&, const std::vector<double>&);
template std::vector<double> radius_of_neighbors<2>(const Arrangement<2>&, double, const std::vector<int>&);
template std::vector<double> radius_of_neighbors<3>(const Arrangement<3>&, double, const std::vector<int>&);

}  // namespace sinew
