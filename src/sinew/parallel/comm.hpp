#pragma once
/// The processes ("ranks") that compute one case together. Started by mpiexec they talk through MPI; a process that was started alone does not touch MPI at all.
/// MPI is called by the main thread only.

#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace sinew {

/// Base of errors that all ranks have thrown together.
struct CommonError {
  virtual ~CommonError() = default;
};

/// A handle; copies mean the same ranks. Static members and those that return what a rank knows (rank() to handle()) aside, every call is collective: all ranks
/// make it, in the same order.
class Comm {
 public:
  /// This process alone.
  Comm() = default;
  /// All that mpiexec (or srun) has started; this process alone if none did. The first call starts MPI.
  static Comm world();
  /// Name and version of the MPI library.
  static std::string library();
  /// Whether mpiexec or srun started this process, be it as the only one.
  static bool launched();
  /// Ends MPI if it was started. To be called at the end of the program, by all ranks.
  static void finalize();
  /// Ends all ranks at once with an exit code. For what only one rank knows.
  [[noreturn]] static void abort(int exit_code);

  int rank() const;
  int size() const;
  bool alone() const { return size() == 1; }
  bool root() const { return rank() == 0; }
  int node_size() const;  ///< how many of the ranks share this machine
  /// The MPI communicator (MPI_Comm*), nullptr if alone. For parallel/ only.
  const void* handle() const;

  /// Elementwise over the ranks, in place.
  void maximum(std::span<double> values) const;
  void sum(std::span<long> values) const;
  double maximum(double value) const {
    maximum(std::span(&value, 1));
    return value;
  }
  long sum(long value) const {
    sum(std::span(&value, 1));
    return value;
  }
  /// Sum of whole numbers, modulo 2^64.
  std::uint64_t sum(std::uint64_t value) const;
  bool any(bool value) const { return sum(value ? 1L : 0L) > 0; }

  /// What all ranks bring, rank after rank.
  std::vector<double> gather_all(std::span<const double> values) const;
  std::vector<int> gather_all(std::span<const int> values) const;
  /// to[r] goes to rank r; returns what came from each.
  std::vector<std::vector<int>> exchange(const std::vector<std::vector<int>>& to) const;
  /// Rows of `width` doubles: those of all ranks on the root, rank after rank.
  std::vector<double> gather_rows(std::span<const double> rows, int width) const;
  /// send[r] of the rows go to rank r, receive[r] come from it; those that come, rank after rank.
  std::vector<double> exchange_rows(std::vector<double> rows, int width, const std::vector<int>& send,
                                    const std::vector<int>& receive) const;
  /// From one rank to all.
  void broadcast(std::string& text, int from = 0) const;
  void broadcast(std::vector<int>& values, int from = 0) const;
  void broadcast(std::vector<double>& values, int from = 0) const;

  /// Runs the action on every rank; if it throws on any, all throw the error of the first of these ranks. CaseError and SimulationError
  /// keep their kind, others become std::runtime_error; all are CommonError besides.
  template <class Action>
  void together(Action&& action) const {
    std::exception_ptr error;
    try {
      action();
    } catch (...) {
      error = std::current_exception();
    }
    agree(error);
  }
  /// The same for an action of the root alone.
  template <class Action>
  void on_root(Action&& action) const {
    together([&] {
      if (root()) action();
    });
  }

 private:
  struct Group;
  explicit Comm(std::shared_ptr<const Group> group) : group_(std::move(group)) {}
  void agree(const std::exception_ptr& error) const;

  std::shared_ptr<const Group> group_;
};

/// `width` numbers for each block, from the ranks that have the blocks with these numbers, in the order of the numbers, on all ranks. Collective.
std::vector<double> gather_over_blocks(const Comm& comm, std::span<const int> blocks, std::span<const double> partial, int width);

/// Sums that have the same bits however blocks are spread over ranks: `partial` has `width` numbers for each of the blocks of this
/// rank, whose numbers in the whole are `blocks`; they are added in the order of these numbers. Collective.
std::vector<double> sum_over_blocks(const Comm& comm, std::span<const int> blocks, std::span<const double> partial, int width);

}  // namespace sinew
