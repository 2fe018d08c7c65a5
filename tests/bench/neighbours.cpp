#include "common/core/neighbours.hpp"

#include "tests/bench/benches.hpp"
#include "tests/bench/gas.hpp"
#include "tests/bench/race.hpp"

/// What finding neighbours costs: sorting into cells, listing, and the plain way to list.
namespace bench {
namespace {

/// Linked lists of particles in cells as wide as the reach, and a vector of neighbours for each particle.
template <int d>
class PlainLists {
  public:
    explicit PlainLists(const Gas<d>& gas) : reach_{gas.smoothing.reach()} {
        for (std::size_t k = 0; k < gas.neighbours.sources(); ++k) {
            x_.push_back(gas.neighbours.source_position(k));
            is_ghost_.push_back(gas.neighbours.ghost(k) != nullptr);
        }
        cells_ = static_cast<int>(1 / reach_) + 3;
    }
    std::size_t list() {
        std::size_t all = 1;
        for (int a = 0; a < d; ++a) all *= static_cast<std::size_t>(cells_);
        first_.assign(all, -1);
        next_.resize(x_.size());
        neighbours_.resize(x_.size());
        for (std::size_t i = 0; i < x_.size(); ++i) {
            next_[i] = first_[cell_of(x_[i])];
            first_[cell_of(x_[i])] = static_cast<int>(i);
        }
        std::size_t pairs = 0;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            if (is_ghost_[i]) continue;
            neighbours_[i].clear();
            for_each_cell_around(i, [&](std::size_t cell) {
                for (int j = first_[cell]; j >= 0; j = next_[static_cast<std::size_t>(j)]) {
                    const auto x_ij = x_[i] - x_[static_cast<std::size_t>(j)];
                    if (dot(x_ij, x_ij) < reach_ * reach_)
                        neighbours_[i].push_back(static_cast<std::uint32_t>(j));
                }
            });
            pairs += neighbours_[i].size();
        }
        return pairs;
    }

  private:
    std::size_t cell_of(const sph::Vector<d>& x) const {
        std::size_t index = 0;
        for (std::size_t a = d; a-- > 0;) {
            const int c = std::clamp(static_cast<int>(std::floor(x[a] / reach_)) + 1, 0, cells_ - 1);
            index = index * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(c);
        }
        return index;
    }
    template <class Visit>
    void for_each_cell_around(std::size_t i, Visit&& visit) const {
        const auto n = static_cast<std::ptrdiff_t>(cells_);
        const auto centre = static_cast<std::ptrdiff_t>(cell_of(x_[i]));
        for (std::ptrdiff_t k = d > 2 ? -1 : 0; k <= (d > 2 ? 1 : 0); ++k) {
            for (std::ptrdiff_t j = d > 1 ? -1 : 0; j <= (d > 1 ? 1 : 0); ++j) {
                for (std::ptrdiff_t c = -1; c <= 1; ++c)
                    visit(static_cast<std::size_t>(centre + (k * n + j) * n + c));
            }
        }
    }

    double reach_;
    int cells_;
    std::vector<sph::Vector<d>> x_;
    std::vector<bool> is_ghost_;
    std::vector<int> first_, next_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
};

struct Measured {
    plot::Values ours, plain;
};

template <int d>
void measure(report::Run& run, report::Table& table, Measured& measured, std::size_t per_side,
             double h_over_dx) {
    Gas<d> gas{per_side, h_over_dx};
    gas.find();
    const double pairs = static_cast<double>(gas.neighbours.pairs());
    const auto n = static_cast<double>(gas.particles.size());
    std::size_t candidates = 0;
    for (const auto& receiver : gas.neighbours.receivers())
        candidates += gas.neighbours.cells().candidates(receiver.x, receiver.reach, sph::Support::gather);
    PlainLists<d> plain{gas};
    if (static_cast<double>(plain.list()) != pairs)
        throw std::runtime_error{"neighbours: the plain lists differ"};
    const std::vector<Lap> laps = race(run, {{"sort", [&] { gas.find(sph::Keep::nothing); }},
                                             {"list", [&] { gas.find(); }},
                                             {"plain", [&] { plain.list(); }}});
    const double sort = 1e9 * laps[0].median / n, list = 1e9 * (laps[1].median - laps[0].median) / pairs;
    const double all = 1e9 * laps[1].median / pairs, other = 1e9 * laps[2].median / pairs;
    const std::string name = std::to_string(d) + "D " + report::fixed(pairs / n, 0) + " neighbours";
    table.row({name, report::timing(sort), report::timing(list),
               report::fixed(static_cast<double>(candidates) / pairs, 1), report::timing(all),
               report::timing(other), report::timing(other / all)});
    run.result(name, static_cast<long>(n), "sort_ns_per_particle", sort, "ns");
    run.result(name, static_cast<long>(n), "list_ns_per_neighbour", list, "ns");
    run.result(name, static_cast<long>(n), "find_ns_per_neighbour", all, "ns");
    run.result(name, static_cast<long>(n), "plain_ns_per_neighbour", other, "ns");
    measured.ours.push_back(all);
    measured.plain.push_back(other);
}

}  // namespace

void neighbours(report::Run& run) {
    report::Table table{{"particles", "sorting [ns a particle]", "listing [ns a neighbour]",
                         "candidates a neighbour", "both [ns a neighbour]", "linked lists [ns a neighbour]",
                         "gain"}};
    Measured measured;
    const bool quick = run.quick();
    measure<1>(run, table, measured, quick ? 2000 : 100000, 1.2);
    measure<2>(run, table, measured, quick ? 45 : 316, 1.2);
    measure<2>(run, table, measured, quick ? 45 : 316, 2.13);
    measure<3>(run, table, measured, quick ? 13 : 46, 1.185);
    plot::Figure figure{"neighbours"};
    plot::Panel& panel = figure.panel().titled("10^{5} particles, one core").log_y();
    panel.labels("dimension, neighbours", "CPU time a neighbour [ns]");
    const plot::Values place{1, 2, 3, 4};
    panel.points(place, measured.plain,
                 {.label = "linked lists, a vector a particle",
                  .colour = plot::cycle(1),
                  .marker = plot::Marker::square});
    panel.points(place, measured.ours, {.label = "sorted cells, one list", .marker = plot::Marker::circle});
    panel.x.ticks = place;
    panel.x.tick_names = {"1D: 5", "2D: 20", "2D: 58", "3D: 58"};
    panel.x_range(0.5, 4.5).y_range(1, 100);
    run.save(figure);
    run.fill("bench-neighbours", table.markdown());
}

}  // namespace bench
