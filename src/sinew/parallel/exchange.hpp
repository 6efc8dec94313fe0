#pragma once
/// Moves values of particles between ranks, the same ones in every step.

#include <memory>
#include <sinew/parallel/comm.hpp>
#include <sinew/particles/vector_field.hpp>
#include <vector>

namespace sinew {

/// Places [begin, begin + length) of a field.
struct Stretch {
  int begin, length;
};
/// What goes to one rank, or comes from it.
struct Parcel {
  int rank;
  std::vector<Stretch> stretches;
  std::size_t places() const;
};

/// One neighborhood collective of MPI (MPI_Ineighbor_alltoallw) on a graph of the ranks that share something. Which places travel is known to MPI as
/// data types, so nothing is packed here.
class Exchange {
 public:
  /// No other ranks.
  Exchange() = default;
  /// The same number of places, in the same order, at both ends. `components` of a field lie `stride` apart. Collective.
  Exchange(const Comm& comm, int components, std::size_t stride, const std::vector<Parcel>& send,
           const std::vector<Parcel>& receive);

  /// Begins to send and to receive places of the field that begins at `first`; until finish() those that travel must not be touched.
  void start(double* first);
  template <int D>
  void start(VectorField<D>& field) {
    start(field.component(0));
  }
  /// Lets MPI move what is on its way. It does so in its own calls only.
  void progress();
  void finish();

  int messages() const;           ///< that this rank sends each time
  std::size_t bytes() const;      ///< in them
  double seconds_waited() const;  ///< in start and finish, since the beginning

 private:
  struct Plan;
  std::shared_ptr<Plan> plan_;
};

}  // namespace sinew
