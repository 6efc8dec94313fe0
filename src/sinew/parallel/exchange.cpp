#include <sinew/core/timer.hpp>
#include <sinew/parallel/exchange.hpp>

#include <mpi.h>

#include <algorithm>
#include <set>

namespace sinew {

std::size_t Parcel::places() const {
  std::size_t places = 0;
  for (const Stretch& s : stretches) places += s.length;
  return places;
}

/// What MPI has to be told each time.
struct Exchange::Plan {
  MPI_Comm graph = MPI_COMM_NULL;
  MPI_Request request = MPI_REQUEST_NULL;
  std::vector<int> send_counts, receive_counts;  ///< 1, or 0 where nothing travels
  std::vector<MPI_Aint> displacements;           ///< 0
  std::vector<MPI_Datatype> send_types, receive_types;
  std::size_t bytes = 0;
  double seconds = 0.0;

  Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan() {
    int ended = 0;
    MPI_Finalized(&ended);
    if (ended) return;
    for (auto* types : {&send_types, &receive_types})
      for (MPI_Datatype& type : *types)
        if (type != MPI_DOUBLE) MPI_Type_free(&type);
    if (graph != MPI_COMM_NULL) MPI_Comm_free(&graph);
  }
};

namespace {

const Parcel* parcel_of(const std::vector<Parcel>& parcels, int rank) {
  const auto at = std::find_if(parcels.begin(), parcels.end(), [rank](const Parcel& p) { return p.rank == rank; });
  return at != parcels.end() && at->places() > 0 ? &*at : nullptr;
}

/// All components of some places of a field.
MPI_Datatype type_of(const Parcel& parcel, int components, std::size_t stride) {
  std::vector<int> lengths;
  std::vector<MPI_Aint> begins;
  for (int c = 0; c < components; ++c)
    for (const Stretch& s : parcel.stretches) {
      lengths.push_back(s.length);
      begins.push_back(static_cast<MPI_Aint>(sizeof(double) * (c * stride + s.begin)));
    }
  MPI_Datatype type = MPI_DATATYPE_NULL;
  MPI_Type_create_hindexed(static_cast<int>(lengths.size()), lengths.data(), begins.data(), MPI_DOUBLE, &type);
  MPI_Type_commit(&type);
  return type;
}

}  // namespace

Exchange::Exchange(const Comm& comm, int components, std::size_t stride, const std::vector<Parcel>& send,
                   const std::vector<Parcel>& receive)
    : plan_(comm.alone() ? nullptr : std::make_shared<Plan>()) {
  if (!plan_) return;
  std::set<int> ranks;
  for (const auto* parcels : {&send, &receive})
    for (const Parcel& parcel : *parcels) ranks.insert(parcel.rank);
  const std::vector<int> neighbors(ranks.begin(), ranks.end());
  const auto add = [&](const Parcel* parcel, std::vector<int>& counts, std::vector<MPI_Datatype>& types) {
    counts.push_back(parcel ? 1 : 0);
    types.push_back(parcel ? type_of(*parcel, components, stride) : MPI_DOUBLE);
  };
  for (const int rank : neighbors) {
    const Parcel* to = parcel_of(send, rank);
    add(to, plan_->send_counts, plan_->send_types);
    add(parcel_of(receive, rank), plan_->receive_counts, plan_->receive_types);
    if (to) plan_->bytes += to->places() * components * sizeof(double);
  }
  plan_->displacements.assign(neighbors.size(), 0);
  const int degree = static_cast<int>(neighbors.size());
  MPI_Dist_graph_create_adjacent(*static_cast<const MPI_Comm*>(comm.handle()), degree, neighbors.data(), MPI_UNWEIGHTED, degree,
                                 neighbors.data(), MPI_UNWEIGHTED, MPI_INFO_NULL, 0, &plan_->graph);
}

void Exchange::start(double* first) {
  if (!plan_) return;
  const Stopwatch watch;
  Plan& p = *plan_;
  MPI_Ineighbor_alltoallw(first, p.send_counts.data(), p.displacements.data(), p.send_types.data(), first,
                          p.receive_counts.data(), p.displacements.data(), p.receive_types.data(), p.graph, &p.request);
  p.seconds += watch.seconds();
}

void Exchange::progress() {
  if (!plan_ || plan_->request == MPI_REQUEST_NULL) return;
  int done = 0;
  MPI_Test(&plan_->request, &done, MPI_STATUS_IGNORE);
}

void Exchange::finish() {
  if (!plan_) return;
  const Stopwatch watch;
  MPI_Wait(&plan_->request, MPI_STATUS_IGNORE);
  plan_->seconds += watch.seconds();
}

int Exchange::messages() const {
  return plan_ ? static_cast<int>(std::count(plan_->send_counts.begin(), plan_->send_counts.end(), 1)) : 0;
}

std::size_t Exchange::bytes() const { return plan_ ? plan_->bytes : 0; }

double Exchange::seconds_waited() const { return plan_ ? plan_->seconds : 0.0; }

}  // namespace sinew
