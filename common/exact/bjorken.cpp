#include "common/exact/bjorken.hpp"

#include <cmath>

#include "common/exact/require.hpp"

namespace exact {

BjorkenFlow::State BjorkenFlow::at(double tau) const {
    constexpr const char* problem = "Bjorken flow";
    require(tau0 > 0 && std::isfinite(tau0), problem, "tau0", tau0, "the finite numbers above 0");
    require(c2 >= 0 && c2 <= 1, problem, "sound speed squared", c2, "0..1");
    require(tau > 0 && std::isfinite(tau), problem, "tau", tau, "the finite numbers above 0");
    const double entropy = tau0 / tau, temperature = std::pow(entropy, c2);
    return {temperature, entropy * temperature, entropy};
}

}  // namespace exact
