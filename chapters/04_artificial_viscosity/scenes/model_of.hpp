#pragma once
#include "chapters/04_artificial_viscosity/dissipative_gas.hpp"
#include "chapters/04_artificial_viscosity/scenes/model.hpp"

namespace sph {

/// A model made of types.
template <class Kernel, class Scheme>
class ModelOf : public Model<Kernel::dimension> {
  public:
    static constexpr int d = Kernel::dimension;

    ModelOf(std::size_t n, double h_over_dx, double gamma, Scheme scheme, const Box<d>& box, int threads)
        : rule_{h_over_dx}, gas_{n, ConsistentH<Kernel>{rule_, close}, {gamma}, scheme, box, threads} {
        if constexpr (requires { gas_.particles.alpha; })
            gas_.particles.alpha.assign(n, alpha_0);  // the ambient value of 8.27
    }

    void set(std::size_t i, const Vector<d>& x, const Vector<d>& v, double m, double rho, double u) override {
        auto& p = gas_.particles;
        for (std::size_t a = 0; a < d; ++a) p.x[a][i] = x[a], p.v[a][i] = v[a];
        p.m[i] = m, p.rho[i] = rho, p.u[i] = u, p.h[i] = rule_.h(m, rho, d);
    }
    void fix_from(std::size_t first) override { gas_.particles.fix_from(first); }
    void resolve(double t) override { gas_.resolve(t); }
    void advance(double& t, double end, double courant,
                 const std::function<void(double)>& after_step) override {
        gas_.advance(t, end, courant, after_step);
    }
    std::size_t size() const override { return gas_.particles.size(); }
    std::size_t moving() const override { return gas_.particles.moving(); }
    const Columns<d>& x() const override { return gas_.particles.x; }
    const Columns<d>& v() const override { return gas_.particles.v; }
    const Column& m() const override { return gas_.particles.m; }
    const Column& rho() const override { return gas_.particles.rho; }
    const Column& p() const override { return gas_.particles.p; }
    const Column& u() const override { return gas_.particles.u; }
    double energy() const override { return gas_.energy(); }
    Vector<d> momentum() const override { return gas_.momentum(); }
    Counters& counters() override { return gas_.counters(); }

  private:
    // Energy hangs on the work of pairs, not on h: one Newton step after 1e-4 leaves 1e-8.
    static constexpr double close = 1e-4;
    static constexpr double alpha_0 = 0.1;

    HRule rule_;
    DissipativeGas<ConsistentH<Kernel>, Scheme, Box<d>> gas_;
};

}  // namespace sph
