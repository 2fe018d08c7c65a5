#include "chapters/06_finite_particle_method/scenes/burgers.hpp"

#include <stdexcept>

#include "chapters/06_finite_particle_method/keeping_apart.hpp"
#include "chapters/06_finite_particle_method/scenes/differences.hpp"
#include "chapters/06_finite_particle_method/scenes/estimators.hpp"
#include "common/core/arrangement.hpp"
#include "common/core/unstable.hpp"
#include "common/exact/burgers.hpp"

namespace sph::fpm {
namespace {

constexpr double largest_u = 1;  // at t = 0

bool is_moving(const BurgersScene& scene) {
    return scene.moving != Moving::still;
}
bool is_remeshed(const BurgersScene& scene) {
    return scene.moving == Moving::remeshed_by_fit || scene.moving == Moving::remeshed_by_sharing;
}

/// Still particles, and frozen ends, stand at i dx with one on either end; others in the middle of cells.
bool has_particles_at_ends(const BurgersScene& scene) {
    return scene.ends != Ends::free && (!is_moving(scene) || scene.ends != Ends::mirror);
}

/// Particles beyond either end: enough for the kernel to see none of their outer edges at first.
std::size_t extra(const BurgersScene& scene) {
    return scene.ends == Ends::free ? scene.n / 5 : 0;
}

/// Images behind both ends, if they are mirrors.
Images<1> images_of(const BurgersScene& scene) {
    return scene.ends == Ends::mirror ? mirror_images(0, scene.length) : Images<1>{};
}

/// Estimates between particles as they are now.
class FittedRows final : public RowSource {
  public:
    explicit FittedRows(const BurgersScene& scene)
        : estimates_{estimator<1>(scene.estimate, scene.order), AnyKernel<1>{scene.kernel},
                     images_of(scene)} {}
    const Rows<1>& at(const BurgersParticles& p) override { return estimates_.at_particles(p.x, p.m, p.h); }
    bool twice() const override { return !estimates_.estimator().has_second(); }
    Enlarged enlarged() const override { return estimates_.enlarged(); }

  private:
    Estimates<1> estimates_;
};

std::unique_ptr<RowSource> rows_of(const BurgersScene& scene) {
    if (scene.estimate != "fdm") return std::make_unique<FittedRows>(scene);
    if (is_moving(scene)) throw std::invalid_argument{"differences need points that stand still"};
    return std::make_unique<Differences>(scene.n, scene.order);
}

std::unique_ptr<Frame> frame_of(const BurgersScene& scene) {
    const bool needs_mirrors = is_remeshed(scene) || scene.moving == Moving::to_wanted_places;
    if (needs_mirrors && (scene.ends != Ends::mirror || scene.length != 1))
        throw std::invalid_argument{"this method needs mirrors at 0 and 1"};
    if (scene.moving == Moving::still) return std::make_unique<Still>();
    if (scene.moving == Moving::with_smoothed_u) return std::make_unique<SmoothedVelocity>(0.5);
    const double dx = scene.dx(), h = scene.h_over_dx * dx;
    if (scene.moving == Moving::shifted)
        return std::make_unique<Shifted>(AnyKernel<1>{scene.kernel}, h, dx, largest_u, images_of(scene));
    if (scene.moving == Moving::repelled)
        return std::make_unique<Repelled>(AnyKernel<1>{scene.kernel}, h, dx, largest_u, images_of(scene));
    constexpr double relaxation = 0.05;  // a twentieth of the time in which the wave crosses the line
    if (scene.moving == Moving::to_wanted_places)
        return std::make_unique<Equidistributing>(Monitor{}, scene.h_over_dx, relaxation);
    return std::make_unique<Lagrangian>();
}

/// A line under way, with what is watched after each step.
class Watched {
  public:
    Watched(const BurgersScene& scene, BurgersRun& run)
        : scene_{&scene},
          run_{&run},
          exact_{scene.viscosity},
          line_{scene.n + 2 * extra(scene), scene.viscosity, rows_of(scene), frame_of(scene)},
          remesher_{estimator<1>("mls"), AnyKernel<1>{scene.kernel}, mirror_images(0, 1)} {
        place();
        line_.limit_steps([this] { return longest_step(); });
        first_ = line_.totals();
    }

    void march_to(double end, double& t) {
        const long steps = scene_->steps == 0
                               ? 0
                               : std::lround(static_cast<double>(scene_->steps) * (end - t) / scene_->time);
        const StepControl control{.end = end, .steps = steps, .progress = scene_->progress};
        const Marched done = march(line_, t, control, [&](double now) {
            look(now);
            return !is_over();
        });
        run_->steps += done.steps, run_->seconds += done.seconds;
        measure(t);
    }
    bool is_over() const { return scene_->stops_at_crossing && run_->first_crossing >= 0; }
    void evaluate() { line_.rates(0); }
    double bytes_of_rows() const { return line_.rows().bytes(); }
    void finish() {
        run_->x = labelled(line_.particles.x[0]);
        run_->u = labelled(line_.particles.v[0]);
        for (const double x : run_->x) run_->exact.push_back(exact_.velocity(x, scene_->time));
        run_->enlarged = line_.enlarged();
        run_->evaluations = line_.evaluations();
        run_->relative = relative();
    }

  private:
    Column labelled(const Column& all) const {
        const auto first = all.begin() + static_cast<long>(extra(*scene_));
        return {first, first + static_cast<long>(scene_->n)};
    }

    void place() {
        BurgersParticles& p = line_.particles;
        Uniform uniform{scene_->seed};
        const double dx = scene_->dx(), offset = has_particles_at_ends(*scene_) ? 0 : 0.5;
        const auto shift = static_cast<double>(extra(*scene_));
        for (std::size_t i = 0; i < p.size(); ++i) {
            double x = (static_cast<double>(i) - shift + offset) * dx;
            if (i > 0 && i + 1 < p.size()) x += scene_->jitter * (2 * uniform() - 1) * dx;
            const double r = scene_->perturbation * (2 * uniform() - 1), s = 2 * uniform() - 1;
            p.x[0][i] = x + r * dx;
            p.v[0][i] = std::sin(pi * p.x[0][i]) + 0.1 * scene_->perturbation * s;
            p.m[i] = p.carried[i] = dx, p.h[i] = scene_->h_over_dx * dx;
        }
        const bool tells_ends = scene_->ends == Ends::mirror || scene_->ends == Ends::frozen;
        if (!has_particles_at_ends(*scene_) || !tells_ends) return;
        p.v[0].front() = p.v[0].back() = 0;
        line_.pin({0, p.size() - 1});
    }

    /// What diffusion and motion allow: Runge and Kutta's method is stable to 0.69 (order 2) or 0.52 (order
    /// 4) of dx^2/gamma, and to 2 dx/|u|.
    double longest_step() const {
        constexpr double diffusion = 0.5, motion = 0.4, with_u = 0.2;
        const BurgersParticles& p = line_.particles;
        const double dx = scene_->dx();
        double least = dx, rate = 1e-9;  // of the space, and of crossing it
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double space = scene_->moving == Moving::to_wanted_places ? space_of(p.x[0], i) : dx;
            least = std::min(least, space), rate = std::max(rate, std::abs(p.v[0][i]) / space);
        }
        const bool carried = is_moving(*scene_) && scene_->moving != Moving::to_wanted_places;
        const double longest =
            std::min(diffusion * least * least / scene_->viscosity, (carried ? with_u : motion) / rate);
        return scene_->step_factor * std::min(longest, repulsion_allows());
    }
    /// Of the oscillation of near pairs, whose frequency is sqrt(20) (U/r) (dx/r)^2 at most, RK4 takes 2.8
    /// over it. Particles nearer than a fifth of dx are not followed any more: their force is as good as
    /// infinite.
    double repulsion_allows() const {
        if (scene_->moving != Moving::repelled) return scene_->time;
        const double dx = scene_->dx(), r = std::max(least_gap(), 0.2 * dx);
        return 0.5 * r / largest_u * square(std::min(r / dx, 1.0));
    }

    void look(double t) {
        BurgersParticles& p = line_.particles;
        if (!is_moving(*scene_)) return line_.require_bounded(t);
        count_crossings(t);
        if (scene_->keeps_paths) {
            run_->path_t.push_back(t);
            run_->path_x.push_back(labelled(p.x[0])), run_->path_u.push_back(labelled(p.v[0]));
        }
        if (is_remeshed(*scene_) && least_gap() < 0.7 * scene_->dx()) remesh();
    }
    double least_gap() const {
        double least = 1;
        for (std::size_t k = 0; k <= scene_->n; ++k) least = std::min(least, gap(line_.particles.x[0], k));
        return least;
    }
    void count_crossings(double t) {
        const Column x = labelled(line_.particles.x[0]);
        std::size_t crossed = 0;
        const bool walls = scene_->ends != Ends::free;
        for (std::size_t i = 0; i + 1 < x.size(); ++i) crossed += x[i + 1] < x[i] ? 1 : 0;
        for (std::size_t i = 0; walls && i < x.size(); ++i)
            crossed += x[i] < 0 || x[i] > scene_->length ? 1 : 0;
        run_->crossed = crossed;
        run_->most_crossed = std::max(run_->most_crossed, crossed);
        if (crossed > 0 && run_->first_crossing < 0) run_->first_crossing = t;
    }
    void remesh() {
        const Totals<1> before = line_.totals();
        if (scene_->moving == Moving::remeshed_by_fit)
            remesh_by_fit(line_.particles, remesher_);
        else
            remesh_by_sharing(line_.particles);
        const Totals<1> after = line_.totals();
        run_->mass_change += (after.mass - before.mass) / first_.mass;
        run_->momentum_change += (after.momentum[0] - before.momentum[0]) / first_.momentum[0];
        ++run_->remeshings;
        line_.restart();
    }

    void measure(double t) {
        const Column x = labelled(line_.particles.x[0]), u = labelled(line_.particles.v[0]);
        double error = 0, size = 0, largest = 0, height = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double wanted = exact_.velocity(x[i], t), off = std::abs(u[i] - wanted);
            error += off, size += std::abs(wanted);
            largest = std::max(largest, off), height = std::max(height, std::abs(wanted));
        }
        run_->errors.push_back({t, error / size, largest / height});
        run_->worst_l1 = std::max(run_->worst_l1, error / size);
        run_->worst_linf = std::max(run_->worst_linf, largest / height);
    }
    /// P at 0.05, 0.2, ..., 0.95: places of particles where the spacing is 1/20, 1/40, ...
    double relative() const {
        const Column &x = run_->x, &u = run_->u;
        double sum = 0;
        for (int k = 0; k < 7; ++k) {
            const double place = 0.05 + 0.15 * k;
            const auto i = static_cast<std::size_t>(std::lround(place * static_cast<double>(scene_->n - 1)));
            if (i >= x.size() || std::abs(x[i] - place) > 1e-9) return std::nan("");
            const double wanted = exact_.velocity(place, scene_->time);
            sum += std::abs(u[i] - wanted) / std::abs(wanted);
        }
        return sum / 7;
    }

    const BurgersScene* scene_;
    BurgersRun* run_;
    exact::Burgers exact_;
    BurgersLine line_;
    Estimates<1> remesher_;
    Totals<1> first_;
};

void march_through(const BurgersScene& scene, Watched& line) {
    double t = 0;
    for (const double look : scene.looks) {
        if (look < scene.time && !line.is_over()) line.march_to(look, t);
    }
    if (!line.is_over()) line.march_to(scene.time, t);
}

}  // namespace

double BurgersScene::dx() const {
    return length / static_cast<double>(has_particles_at_ends(*this) ? n - 1 : n);
}

BurgersRun run_burgers(const BurgersScene& scene) {
    BurgersRun run;
    Watched line{scene, run};
    march_through(scene, line);
    line.finish();
    return run;
}

BurgersRun try_burgers(const BurgersScene& scene) {
    BurgersRun run;
    Watched line{scene, run};
    try {
        march_through(scene, line);
    } catch (const Unstable& failure) {
        run.stopped = failure.time;
    }
    line.finish();
    return run;
}

namespace {

struct Held {
    BurgersScene scene;
    BurgersRun run;
    Watched line;
    explicit Held(const BurgersScene& s) : scene{s}, line{scene, run} {}
};
/// As for particles that move, unless there are only differences.
std::shared_ptr<Held> held(BurgersScene scene) {
    if (scene.estimate != "fdm" && !is_moving(scene)) scene.moving = Moving::with_u;
    return std::make_shared<Held>(scene);
}

}  // namespace

std::function<void()> rates_of(const BurgersScene& scene) {
    return [line = held(scene)] { line->line.evaluate(); };
}

double bytes_of_rows(const BurgersScene& scene) {
    const auto line = held(scene);
    line->line.evaluate();
    return line->line.bytes_of_rows();
}

}  // namespace sph::fpm
