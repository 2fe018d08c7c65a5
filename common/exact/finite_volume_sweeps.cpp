// The loops of a step. All are vectorised: `ivdep` tells the compiler that the columns do not overlap.
#include <cmath>

#include "common/exact/finite_volume.hpp"
#include "common/exact/finite_volume_frames.hpp"
#include "common/exact/finite_volume_steps.hpp"

namespace exact {
template <class InFrame>
void FiniteVolume::predict(const InFrame& frame, double dt) {
    const double *a = gas_.a.data(), *b = gas_.b.data(), *c = gas_.c.data();
    const double *width = width_.data(), *near_w = near_west_.data(), *near_e = near_east_.data();
    double *wa = west_.a.data(), *wb = west_.b.data(), *wc = west_.c.data();
    double *ea = east_.a.data(), *eb = east_.b.data(), *ec = east_.c.data();
    const double* order = order_.data();
#pragma GCC ivdep
    for (std::size_t i = 1; i < n_ + 2 * ghosts - 1; ++i) {
        const frames::Three q{a[i], b[i], c[i]};
        const frames::Three dq{
            order[i] * hllc::limited(a[i] - a[i - 1], a[i + 1] - a[i], near_w[i], near_e[i]),
            order[i] * hllc::limited(b[i] - b[i - 1], b[i + 1] - b[i], near_w[i], near_e[i]),
            order[i] * hllc::limited(c[i] - c[i - 1], c[i + 1] - c[i], near_w[i], near_e[i])};
        const frames::Three rate = frame.rates(q, dq);
        const double half = dt / 2 / width[i];
        const double a_mid = q.a + half * rate.a, b_mid = q.b + half * rate.b, c_mid = q.c + half * rate.c;
        const double lowest_a = a_mid - std::abs(dq.a) / 2, lowest_c = c_mid - std::abs(dq.c) / 2;
        const bool keep = hllc::both(lowest_a > steps::least * q.a, lowest_c > steps::least * q.c);
        wa[i] = keep ? a_mid - dq.a / 2 : q.a;
        wb[i] = keep ? b_mid - dq.b / 2 : q.b;
        wc[i] = keep ? c_mid - dq.c / 2 : q.c;
        ea[i] = keep ? a_mid + dq.a / 2 : q.a;
        eb[i] = keep ? b_mid + dq.b / 2 : q.b;
        ec[i] = keep ? c_mid + dq.c / 2 : q.c;
    }
}

template <class InFrame>
void FiniteVolume::solve_faces(const InFrame& frame) {
    const double *la = east_.a.data() + ghosts - 1, *lb = east_.b.data() + ghosts - 1,
                 *lc = east_.c.data() + ghosts - 1;
    const double *ra = west_.a.data() + ghosts, *rb = west_.b.data() + ghosts, *rc = west_.c.data() + ghosts;
    const double *width = width_.data() + ghosts - 1, *volume = gas_.a.data() + ghosts - 1;
    double *fa = flux_.a.data(), *fb = flux_.b.data(), *fc = flux_.c.data();
    double *velocity = face_velocity_.data(), *rate = face_rate_.data();
#pragma GCC ivdep
    for (std::size_t i = 0; i <= n_; ++i) {
        const hllc::Gas l = frame.state(la[i], lb[i], lc[i]), r = frame.state(ra[i], rb[i], rc[i]);
        const hllc::Fan waves = hllc::fan(l, r, frame.gamma);
        const frames::Three flux = frame.flux(l, r, waves);
        fa[i] = flux.a, fb[i] = flux.b, fc[i] = flux.c;
        velocity[i] = frame.face_velocity(waves);
        const double fastest = hllc::larger(waves.right - velocity[i], velocity[i] - waves.left);
        rate[i] =
            fastest / hllc::smaller(frame.dx(width[i], volume[i]), frame.dx(width[i + 1], volume[i + 1]));
    }
}

// A cell may lose half its width in a step, however slow the waves.
template <class InFrame>
void FiniteVolume::limit_shrinking(const InFrame& frame) {
    const double *width = width_.data() + ghosts, *volume = gas_.a.data() + ghosts;
    const double* velocity = face_velocity_.data();
    double* rate = face_rate_.data();
#pragma GCC ivdep
    for (std::size_t i = 0; i < n_; ++i) {
        const double shrinking = 2 * (velocity[i] - velocity[i + 1]) / frame.dx(width[i], volume[i]);
        rate[i] = hllc::larger(rate[i], shrinking);
    }
}

template <class InFrame>
void FiniteVolume::update(const InFrame& frame, double dt) {
    const double *ua = conserved_.a.data(), *ub = conserved_.b.data(), *uc = conserved_.c.data();
    const double *fa = flux_.a.data(), *fb = flux_.b.data(), *fc = flux_.c.data(), *width = width_.data();
    double *na = next_conserved_.a.data(), *nb = next_conserved_.b.data(), *nc = next_conserved_.c.data();
    double *a = next_gas_.a.data(), *b = next_gas_.b.data(), *c = next_gas_.c.data();
#pragma GCC ivdep
    for (std::size_t k = 0; k < n_; ++k) {
        const std::size_t i = k + ghosts;
        const double scale = dt / width[i];
        const frames::Three u{ua[i] - scale * (fa[k + 1] - fa[k]), ub[i] - scale * (fb[k + 1] - fb[k]),
                              uc[i] - scale * (fc[k + 1] - fc[k])};
        const frames::Three gas = frame.gas(u);
        na[i] = u.a, nb[i] = u.b, nc[i] = u.c;
        a[i] = gas.a, b[i] = gas.b, c[i] = gas.c;
    }
}

template <class InFrame>
bool FiniteVolume::attempt(const InFrame& frame, double dt) {
    predict(frame, dt);
    solve_faces(frame);
    if (InFrame::faces_move) limit_shrinking(frame);
    rate_ = hllc::largest(face_rate_.data(), n_ + 1);
    update(frame, dt);
    return hllc::all_positive(next_gas_.a.data() + ghosts, n_) &&
           hllc::all_positive(next_gas_.c.data() + ghosts, n_);
}

bool FiniteVolume::attempt(double dt) {
    return options_.frame == Frame::eulerian ? attempt(frames::Eulerian{options_.gamma}, dt)
                                             : attempt(frames::Lagrangian{options_.gamma}, dt);
}

}  // namespace exact
