#pragma once
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/lesson/rules/lesson.hpp"

/// A small lesson that breaks no rule, and ways to break one.
namespace sample {

inline const std::string folder = "04_artificial_viscosity";

inline const std::string text = R"(# 4. Artificial viscosity

**The question.** What lets a shock pass? Reading: about three hours. Running: two minutes.

![Particles of a tube](../../renders/04_artificial_viscosity/particles.png)

*Figure 4.1, a drawing.* Particles of a tube before and after the wall is taken away: those at the left are denser.
`./tutorial run 04 --only particles`, [data](../../renders/04_artificial_viscosity/particles.csv).

After this chapter you can

- say why a shock needs a viscosity,
- write one as an effect
  of pairs,
- choose its strength.

## What goes wrong

The force (4.1) alone, with $`\Pi_{ij} = 0`$:

```math
a_i = -\sum_j m_j \Pi_{ij} \nabla_i W_{ij} \tag{4.1}
```

<!-- code chapters/04_artificial_viscosity/dissipation.hpp force -->
```cpp
sum.dv_dt -= j.m * Pi * pair.grad_W;
```

> **Problem: Sod's tube.** Two states at rest; N = 180 particles, quadratic kernel, t = 0.2.
> The error is summed over |x| < 0.5.

![Sod's tube](../../renders/04_artificial_viscosity/sod.png)

*Figure 4.2.* Density in Sod's tube with and without a viscosity: without it the particles behind the shock
jostle. `./tutorial run 04 --only sod --particles 180`, [data](../../renders/04_artificial_viscosity/sod.csv).

| method | error |
|---|---:|
| none | 0.2 |
| signal | 0.01 |

## A viscosity

<!-- code chapters/04_artificial_viscosity/viscosities.hpp signal -->
```cpp
double signal = c_i + c_j - beta * w;
```

<!-- code chapters/04_artificial_viscosity/scenes/tube.hpp type -->
```cpp
using Tube = Gas<SignalViscosity>;
```

<!-- code chapters/04_artificial_viscosity/scenes/tube.cpp loop -->
```cpp
march(gas, end);
```

### Its strength

The same problem as in Figure 4.2, with (4.1) and the strength of (4.2):

![Strengths](../../renders/04_artificial_viscosity/strength.webp)

*Figure 4.3.* The error of the density against the strength: below one half particles jostle, above two it smears.
`./tutorial run 04 --only strength`, [data](../../renders/04_artificial_viscosity/strength.csv).

```math
\Pi_{ij} = -\frac{K v_{sig} w}{\bar\rho_{ij}} \tag{4.2}
```

## Try next

### 1. No viscosity

```
./tutorial run 04 --scene tube --method none --out /tmp/none   # exits with status 3
```

You should see that it stops.

<details><summary>Why</summary>

Particles cross.

</details>

### 2. A wider kernel

```
./tutorial run 04 --scene tube --h-over-dx 2
```

You should
see a wider shock.

<details>
<summary>Why</summary>
A jump is as wide as its kernel.
</details>

### 3. The exact tube

```
./tutorial exact riemann --points 101
```

You should see five states.

<details><summary>Why</summary>Three waves.</details>

## Appendix

### Where the equations are

| equation | function | file |
|---|---|---|
| (4.1) | `ViscousForce` | [dissipation.hpp](dissipation.hpp) |
| (4.2) | `SignalViscosity` | [viscosities.hpp](viscosities.hpp) |
)";

/// The sample with the first `from` replaced.
inline std::string with(const std::string& from, const std::string& to, const std::string& whole = text) {
    const auto first = whole.find(from);
    INFO(from);
    REQUIRE(first != std::string::npos);
    return whole.substr(0, first) + to + whole.substr(first + from.size());
}
/// The sample with something behind the first `here`.
inline std::string after(const std::string& here, const std::string& more) {
    return with(here, here + more);
}
inline std::string repeated(const std::string& part, int times) {
    std::string all;
    for (int k = 0; k < times; ++k) all += part;
    return all;
}

inline void keeps(const std::string& whole) {
    const auto found = ::lesson::breaches(whole, folder);
    CAPTURE(found);
    CHECK(found.empty());
}
/// Just one rule is broken, and the breach says so.
inline void breaks(const std::string& whole, const std::string& what) {
    const auto found = ::lesson::breaches(whole, folder);
    CAPTURE(what, found);
    REQUIRE(found.size() == 1);
    CHECK(found[0].find(what) != std::string::npos);
}

}  // namespace sample
