
#include "chapters/01_kernel_interpolation/figures/figures.hpp"
#include "chapters/01_kernel_interpolation/interpolation.hpp"
#include "chapters/01_kernel_interpolation/scenes/naive.hpp"
#include "tests/bench/benches.hpp"
#include "tests/bench/measure.hpp"

/// The cost of a kernel: nanoseconds a pair for W and F together, in 3D, from distances that lie in the
/// first-level cache and in random order, as the neighbours of particles come.
namespace bench {
namespace {

constexpr std::size_t pairs = 1024;

struct Buffers {
    double h = 1.1;  // known at run time only
    std::vector<double> r = std::vector<double>(pairs), W = std::vector<double>(pairs),
                        F = std::vector<double>(pairs);
    explicit Buffers(double support) {
        sph::Uniform uniform{1};
        for (double& distance : r) distance = support * h * std::cbrt(uniform());
        benchmark_keep(&h);
    }
};

/// Whole tiles: how this project evaluates kernels.
template <class K>
void in_tiles(Buffers& b) {
    const double h = b.h;
    for (std::size_t j = 0; j < pairs; j += sph::tile_width) {
        const sph::Tile r = sph::Tile::load(b.r.data() + j);
        K::W(r, h).store(b.W.data() + j);
        K::F(r, h).store(b.F.data() + j);
    }
    benchmark_keep(b.W.data());
    benchmark_keep(b.F.data());
}

/// One pair after the other, W(r, h) and F(r, h) called out of line, as from a loop that does more than this.
template <class K>
[[gnu::noinline]] void one_pair(double r, double h, double& W, double& F) {
    W = K::W(r, h);
    F = K::F(r, h);
}
template <class K>
void pair_by_pair(Buffers& b) {
    for (std::size_t j = 0; j < pairs; ++j) one_pair<K>(b.r[j], b.h, b.W[j], b.F[j]);
    benchmark_keep(b.W.data());
}

/// A plain loop of nothing else, which the compiler may vectorise if it can.
template <class K>
void plain_loop(Buffers& b) {
    const double h = b.h;
    for (std::size_t j = 0; j < pairs; ++j) b.W[j] = K::W(b.r[j], h);
    for (std::size_t j = 0; j < pairs; ++j) b.F[j] = K::F(b.r[j], h);
    benchmark_keep(b.W.data());
}

/// Linear interpolation in a table of 1024 intervals: the classic way to avoid the formula.
class Table {
  public:
    template <class K>
    explicit Table(K) : scale_{intervals / K::support} {
        for (std::size_t k = 0; k <= intervals + 1; ++k) {
            W_.push_back(K::W(double(k) / scale_, 1.0));
            F_.push_back(K::F(double(k) / scale_, 1.0));
        }
    }
    void look_up(Buffers& b) const {
        for (std::size_t j = 0; j < pairs; ++j) {
            const double place = b.r[j] * scale_;
            const auto k = static_cast<std::size_t>(place);
            const double rest = place - double(k);
            b.W[j] = W_[k] + rest * (W_[k + 1] - W_[k]);
            b.F[j] = F_[k] + rest * (F_[k + 1] - F_[k]);
        }
        benchmark_keep(b.W.data());
    }

  private:
    static constexpr std::size_t intervals = 1024;
    double scale_;
    std::vector<double> W_, F_;
};

}  // namespace

void kernels(report::Run& run) {
    report::Table table{{"kernel", "form", "ns a pair, W and F", "faster than piecewise ifs by"}};
    plot::Figure figure{"kernels"};
    plot::Panel& panel = figure.panel().titled("$W$ and $F$ together, 3D, one core").log_x();
    panel.labels("CPU time a pair [ns]", "").y_range(0, 15).x_range(0.1, 10);
    figure.panel_width = 520;
    double naive = 0, row = 14;
    const auto add = [&](const std::string& kernel, const std::string& form,
                         const std::function<void()>& work) {
        const Speed speed =
            measure(kernel + "/" + form, pairs, work, run.checking() ? 1 : 9, run.checking() ? 0.0001 : 0.02);
        if (naive == 0) naive = speed.median_ns;
        run.result(kernel + " " + form, static_cast<long>(pairs), "ns_per_pair", speed.median_ns, "ns");
        run.result(kernel + " " + form, static_cast<long>(pairs), "best_ns_per_pair", speed.best_ns, "ns");
        table.row({kernel, form, report::timing(speed.median_ns), report::timing(naive / speed.median_ns)});
        panel.points({speed.median_ns}, {row},
                     {.colour = plot::cycle(form == "tiles" ? 0 : 1), .marker = plot::Marker::circle});
        panel.y.ticks.push_back(row);
        panel.y.tick_names.push_back(kernel + ", " + form);
        row -= 1;
    };
    using Cubic = sph::CubicSpline<3>;
    using Naive = sph::interpolation::PiecewiseCubic<3>;
    Buffers cubic{Cubic::support};
    add("cubic", "piecewise ifs", [&] { pair_by_pair<Naive>(cubic); });
    add("cubic", "piecewise ifs in a plain loop", [&] { plain_loop<Naive>(cubic); });
    const Table look_up{Cubic{}};
    add("cubic", "table", [&] { look_up.look_up(cubic); });
    add("cubic", "branch-free", [&] { pair_by_pair<Cubic>(cubic); });
    add("cubic", "branch-free in a plain loop", [&] { plain_loop<Cubic>(cubic); });
    sph::for_each_kernel<3>([&](auto kernel) {
        using K = decltype(kernel);
        Buffers buffers{K::support};
        add(std::string{K::name}, "tiles", [&] { in_tiles<K>(buffers); });
    });
    run.save(figure);
    run.fill("bench-kernels", table.markdown());
}

}  // namespace bench
