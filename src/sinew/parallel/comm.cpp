#include <sinew/core/error.hpp>
#include <sinew/parallel/comm.hpp>

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

namespace sinew {

struct Comm::Group {
  MPI_Comm world = MPI_COMM_NULL;
  int rank = 0, size = 1, node_size = 1;
};

namespace {

template <class Error>
struct Common : Error, CommonError {
  using Error::Error;
};

/// Where the values of each rank begin, and their number at the end.
std::vector<int> first_of(const std::vector<int>& counts) {
  std::vector<int> first(counts.size() + 1, 0);
  std::partial_sum(counts.begin(), counts.end(), first.begin() + 1);
  return first;
}

std::vector<int> counts_of_all(MPI_Comm world, int size, std::size_t count) {
  const int own = static_cast<int>(count);
  std::vector<int> counts(size);
  MPI_Allgather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  return counts;
}

template <class T>
std::vector<T> gather_values(MPI_Comm world, int size, MPI_Datatype type, std::span<const T> values) {
  const std::vector<int> counts = counts_of_all(world, size, values.size()), first = first_of(counts);
  std::vector<T> all(first.back());
  MPI_Allgatherv(values.data(), static_cast<int>(values.size()), type, all.data(), counts.data(), first.data(), type, world);
  return all;
}

/// A row of doubles as one item, so that the numbers of items stay small.
class RowType {
 public:
  explicit RowType(int width) {
    MPI_Type_contiguous(width, MPI_DOUBLE, &type_);
    MPI_Type_commit(&type_);
  }
  ~RowType() { MPI_Type_free(&type_); }
  RowType(const RowType&) = delete;
  RowType& operator=(const RowType&) = delete;
  operator MPI_Datatype() const { return type_; }

 private:
  MPI_Datatype type_ = MPI_DATATYPE_NULL;
};

enum ErrorKind : int { case_error, simulation_error, other_error };

/// Kind and text of an error.
std::pair<int, std::string> describe(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const CaseError& e) {
    return {case_error, e.what()};
  } catch (const SimulationError& e) {
    return {simulation_error, e.what()};
  } catch (const std::exception& e) {
    return {other_error, e.what()};
  }
}

}  // namespace

std::string Comm::library() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string all(text, length);
  return all.substr(0, all.find(','));
}

bool Comm::launched() {
  constexpr std::array variables{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE"};  // Open MPI, PMIx, MPICH, Slurm
  return std::any_of(variables.begin(), variables.end(), [](const char* name) { return std::getenv(name) != nullptr; });
}

Comm Comm::world() {
  static const Comm everyone = [] {
    if (!launched()) return Comm();
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    Group group{MPI_COMM_WORLD};
    MPI_Comm_rank(group.world, &group.rank);
    MPI_Comm_size(group.world, &group.size);
    MPI_Comm node = MPI_COMM_NULL;
    MPI_Comm_split_type(group.world, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    MPI_Comm_size(node, &group.node_size);
    MPI_Comm_free(&node);
    return group.size > 1 ? Comm(std::make_shared<const Group>(group)) : Comm();
  }();
  return everyone;
}

void Comm::finalize() {
  int started = 0, ended = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&ended);
  if (started && !ended) MPI_Finalize();
}

void Comm::abort(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

int Comm::rank() const { return group_ ? group_->rank : 0; }
int Comm::size() const { return group_ ? group_->size : 1; }
int Comm::node_size() const { return group_ ? group_->node_size : 1; }
const void* Comm::handle() const { return group_ ? &group_->world : nullptr; }

void Comm::maximum(std::span<double> values) const {
  if (group_) MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, group_->world);
}

void Comm::sum(std::span<long> values) const {
  if (group_) MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_LONG, MPI_SUM, group_->world);
}

std::uint64_t Comm::sum(std::uint64_t value) const {
  if (group_) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_UINT64_T, MPI_SUM, group_->world);
  return value;
}

std::vector<double> Comm::gather_all(std::span<const double> values) const {
  if (!group_) return {values.begin(), values.end()};
  return gather_values(group_->world, group_->size, MPI_DOUBLE, values);
}

std::vector<int> Comm::gather_all(std::span<const int> values) const {
  if (!group_) return {values.begin(), values.end()};
  return gather_values(group_->world, group_->size, MPI_INT, values);
}

std::vector<std::vector<int>> Comm::exchange(const std::vector<std::vector<int>>& to) const {
  if (!group_) return to;
  const auto count_of = [](const std::vector<int>& part) { return static_cast<int>(part.size()); };
  std::vector<int> send_counts(to.size()), counts(to.size()), sent;
  std::transform(to.begin(), to.end(), send_counts.begin(), count_of);
  for (const std::vector<int>& part : to) sent.insert(sent.end(), part.begin(), part.end());
  MPI_Alltoall(send_counts.data(), 1, MPI_INT, counts.data(), 1, MPI_INT, group_->world);
  const std::vector<int> send_first = first_of(send_counts), first = first_of(counts);
  std::vector<int> received(first.back());
  MPI_Alltoallv(sent.data(), send_counts.data(), send_first.data(), MPI_INT, received.data(), counts.data(), first.data(),
                MPI_INT, group_->world);
  std::vector<std::vector<int>> from;
  for (std::size_t r = 0; r < counts.size(); ++r) from.emplace_back(received.begin() + first[r], received.begin() + first[r + 1]);
  return from;
}

std::vector<double> Comm::gather_rows(std::span<const double> rows, int width) const {
  if (!group_) return {rows.begin(), rows.end()};
  const std::size_t own = rows.size() / width;
  const std::vector<int> counts = counts_of_all(group_->world, group_->size, own), first = first_of(counts);
  std::vector<double> all(root() ? static_cast<std::size_t>(first.back()) * width : 0);
  const RowType row(width);
  MPI_Gatherv(rows.data(), static_cast<int>(own), row, all.data(), counts.data(), first.data(), row, 0, group_->world);
  return all;
}

std::vector<double> Comm::exchange_rows(std::vector<double> rows, int width, const std::vector<int>& send,
                                        const std::vector<int>& receive) const {
  if (!group_) return rows;
  const std::vector<int> send_first = first_of(send), first = first_of(receive);
  std::vector<double> come(static_cast<std::size_t>(first.back()) * width);
  const RowType row(width);
  MPI_Alltoallv(rows.data(), send.data(), send_first.data(), row, come.data(), receive.data(), first.data(), row, group_->world);
  return come;
}

void Comm::broadcast(std::string& text, int from) const {
  if (!group_) return;
  auto length = static_cast<unsigned long>(text.size());
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG, from, group_->world);
  text.resize(length);
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, from, group_->world);
}

namespace {
template <class T>
void broadcast_values(MPI_Comm world, MPI_Datatype type, std::vector<T>& values, int from) {
  auto length = static_cast<unsigned long>(values.size());
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG, from, world);
  values.resize(length);
  MPI_Bcast(values.data(), static_cast<int>(length), type, from, world);
}
}  // namespace

void Comm::broadcast(std::vector<int>& values, int from) const {
  if (group_) broadcast_values(group_->world, MPI_INT, values, from);
}

void Comm::broadcast(std::vector<double>& values, int from) const {
  if (group_) broadcast_values(group_->world, MPI_DOUBLE, values, from);
}

void Comm::agree(const std::exception_ptr& error) const {
  if (!group_) {
    if (error) std::rethrow_exception(error);
    return;
  }
  int first = error ? group_->rank : group_->size;
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, group_->world);
  if (first == group_->size) return;
  auto [kind, text] = first == group_->rank ? describe(error) : std::pair<int, std::string>{};
  MPI_Bcast(&kind, 1, MPI_INT, first, group_->world);
  broadcast(text, first);
  if (kind == case_error) throw Common<CaseError>(text);
  if (kind == simulation_error) throw Common<SimulationError>(text);
  throw Common<std::runtime_error>(text);
}

std::vector<double> gather_over_blocks(const Comm& comm, std::span<const int> blocks, std::span<const double> partial,
                                       int width) {
  if (comm.alone()) return {partial.begin(), partial.end()};
  const std::vector<int> numbers = comm.gather_all(blocks);
  const std::vector<double> values = comm.gather_all(partial);
  std::vector<double> ordered(values.size());
  for (std::size_t k = 0; k < numbers.size(); ++k)
    std::copy_n(values.begin() + k * width, width, ordered.begin() + static_cast<std::size_t>(numbers[k]) * width);
  return ordered;
}

std::vector<double> sum_over_blocks(const Comm& comm, std::span<const int> blocks, std::span<const double> partial, int width) {
  const std::vector<double> ordered = gather_over_blocks(comm, blocks, partial, width);
  std::vector<double> total(width, 0.0);
  for (std::size_t k = 0; k < ordered.size(); ++k) total[k % width] += ordered[k];
  return total;
}

}  // namespace sinew
