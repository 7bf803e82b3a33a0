// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::mechanisms {

/// Parameters of one axis's friction; rotary axes in N·m and rad, linear ones in N and m. With coulomb = 0
/// only the viscous part remains.
struct LugreParameters {
    double coulomb = 0.0;          ///< F_c
    double bristleStiffness = 0.0; ///< σ0
    double bristleDamping = 0.0;   ///< σ1
    double viscous = 0.0;          ///< σ2
};

/// LuGre friction without Stribeck effect (stiction = Coulomb): ż = v − σ0|v|z/F_c, F = σ0 z + σ1 ż + σ2 v.
/// The bristle is integrated implicitly, z⁺ = (z + v dt)/(1 + σ0|v|dt/F_c), so that |z| never exceeds F_c/σ0
/// at any step. Source: devices.md §5 (Canudas de Wit et al. 1995).
class LugreFriction {
public:
    /// Returns the bristle force −(σ0 z + σ1 ż) over one step at rate v; the integrator adds the viscous part
    /// (implicit).
    double advance(const LugreParameters& p, double v, double dt_s) noexcept {
        if (!(p.coulomb > 0.0))
            return 0.0;
        const double speed = v < 0.0 ? -v : v;
        const double before = m_z;
        m_z = (m_z + v * dt_s) / (1.0 + p.bristleStiffness * speed * dt_s / p.coulomb);
        return -(p.bristleStiffness * m_z + p.bristleDamping * (m_z - before) / dt_s);
    }
    double bristle() const noexcept { return m_z; }
    /// Energy stored in the bristle, ½ σ0 z².
    double energy_J(const LugreParameters& p) const noexcept { return 0.5 * p.bristleStiffness * m_z * m_z; }
    void reset() noexcept { m_z = 0.0; }

private:
    double m_z = 0.0;
};

} // namespace chiron::mechanisms
