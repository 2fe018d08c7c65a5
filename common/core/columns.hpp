#pragma once
#include <string_view>

#include "common/core/vec.hpp"

/// What particles carry. A column is a type: it names a quantity (for messages) and, as In<T, d>, holds it
/// for T = a column of numbers (all particles), a number (one particle) or a tile (eight neighbours), under
/// one and the same symbol of the README's table. What is a Vec changes sign in a mirror. A chapter declares
/// the columns that only it needs where it needs them; none is stored that a scene does not list.
///
/// A column may say
///     positive   a value <= 0 has no meaning, and a simulation stops there;
///     held       what forces change: particles that are not free (groups.hpp) keep it;
///     maximum    where it is summed, the largest term counts.
namespace sph {

struct Position {
    static constexpr std::string_view name = "position";
    template <class T, int d>
    struct In {
        Vec<T, d> x{};
    };
};
struct Velocity {
    static constexpr std::string_view name = "velocity";
    static constexpr bool held = true;
    template <class T, int d>
    struct In {
        Vec<T, d> v{};
    };
};
struct Acceleration {
    static constexpr std::string_view name = "acceleration";
    template <class T, int d>
    struct In {
        Vec<T, d> dv_dt{};
    };
};
struct Mass {
    static constexpr std::string_view name = "mass";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T m{};
    };
};
struct Density {
    static constexpr std::string_view name = "density";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T rho{};
    };
};
struct DensityRate {
    static constexpr std::string_view name = "rate of density";
    template <class T, int>
    struct In {
        T drho_dt{};
    };
};
struct Pressure {
    static constexpr std::string_view name = "pressure";
    template <class T, int>
    struct In {
        T p{};
    };
};
struct SoundSpeed {
    static constexpr std::string_view name = "speed of sound";
    template <class T, int>
    struct In {
        T c_s{};
    };
};
/// Specific internal energy.
struct ThermalEnergy {
    static constexpr std::string_view name = "thermal energy";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T u{};
    };
};
struct Heating {
    static constexpr std::string_view name = "heating";
    template <class T, int>
    struct In {
        T du_dt{};
    };
};
struct SmoothingLength {
    static constexpr std::string_view name = "smoothing length";
    static constexpr bool positive = true;
    template <class T, int>
    struct In {
        T h{};
    };
};

}  // namespace sph
