// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"

namespace chiron::simulation {

/// A point of the centre-line with its frame in A. x̂ = (1,0,0) is normal to the plane of symmetry, n = (0,
/// cos ψ, −sin ψ) points to the concave side, and t = (0, sin ψ, cos ψ), with ψ = atan(2c(z − z_B)), 0 before
/// B. (x̂, n, t) is right-handed.
struct CentrelinePoint {
    double s_m = 0.0;
    double z_m = 0.0;
    core::Vec3 p_A = core::Vec3::Zero();
    core::Vec3 n_A = core::Vec3::UnitY();
    core::Vec3 t_A = core::Vec3::UnitZ();
    double psi_rad = 0.0;
    double curvature_per_m = 0.0; ///< κ_c = 2c cos³ψ; 0 before B
    double bending_per_m2 = 0.0;  ///< dκ_c/ds = −12c² cos⁵ψ sin ψ
};

/// The position of a point relative to the centre-line.
struct CentrelineFoot {
    CentrelinePoint at;
    double ex_m = 0.0; ///< offset along x̂
    double en_m = 0.0; ///< offset along n, positive to the concave side
    /// ∇s in A: ds = gradient · dp. On the parabola t/(1 − κ_c e_n).
    core::Vec3 gradientOfS_A = core::Vec3::UnitZ();
    double bendOfS_per_m = 0.0; ///< bound on the norm of s's second derivative
};

/// Centre-line of the urethra, in A (models.md §1.1 and §8). From the vertex B on it is y = c ζ²,
/// ζ = z − z_B, and the same parabola continues beyond the bladder neck C. Before B it is straight: the canal
/// from the entrance A, where s = z = 0, to B, and the line outside along −z. s = z_B + ½ ζ
/// √(1+4c²ζ²) + asinh(2cζ)/(4c), s = z before B. With z_B = 0 the vertex is at A. Pure.
///
/// For p_z > z_B, foot() is the nearest point of the parabola (the one root with ζ > 0 of 2c²ζ³ + (1−2c p_y)
/// ζ − (p_z − z_B) = 0). At B the curvature jumps from 0 to 2c, and every force along t on a tool beside the
/// line would jump with it. Over the last kLeadIn_m before B the arc length of an off-line point is therefore
/// blended: s = z_B + ζ/(1 − 2c e_n g), g = smoothstep(1 + ζ/kLeadIn), whose gradient is continuous at B (the
/// denominator is held ≥ ¼). The line itself stays straight. On the parabola the gradient's denominator is
/// held ≥ ¼ too: farther than ¾ of the radius of curvature from the line (28.8 mm with P1's c at B) the
/// gradient is bounded instead of exact. Beyond the centre of curvature at B, 1/(2c) above it, the nearest
/// point jumps as p_z passes z_B; a tool that came in through A is never drawn or felt there.
///
/// Thread: haptic.
class UrethraCentreline {
public:
    static constexpr double kLeadIn_m = 0.010;

    /// c > 0, zEnd > straight ≥ 0.
    UrethraCentreline(double curvature_per_m, double zEnd_m, double straight_m = 0.0) noexcept;
    explicit UrethraCentreline(const UrethraAnatomy& anatomy) noexcept
        : UrethraCentreline(anatomy.curvature_per_m, anatomy.zEnd_m, anatomy.straight_m) {}

    double length_m() const noexcept { return m_length_m; } ///< L = s(zEnd)
    double arcLengthAt(double z_m) const noexcept;
    double zAt(double s_m) const noexcept; ///< inverse, to a few ulp (Newton); s itself before B
    CentrelinePoint at(double s_m) const noexcept;
    CentrelinePoint atZ(double z_m) const noexcept;
    CentrelineFoot foot(const core::Vec3& p_A) const noexcept;

private:
    CentrelineFoot footOnParabola(const core::Vec3& p_A) const noexcept;
    CentrelineFoot footBeforeVertex(const core::Vec3& p_A) const noexcept;

    double m_c;
    double m_straight_m;
    double m_length_m;
};

} // namespace chiron::simulation
