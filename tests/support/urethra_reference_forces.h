// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"

#include <array>
#include <vector>

namespace chiron::testing {

/// What the reference computes, in A and SI, with the signs of simulation::UrethraResponse.
struct ReferenceResponse {
    double s = 0.0, ex = 0.0, en = 0.0;
    double phiX = 0.0, phiY = 0.0;
    double N = 0.0, F1 = 0.0, F2 = 0.0, elastic = 0.0;
    double Tx = 0.0, Ty = 0.0, Tz = 0.0;
    double U = 0.0;
    double yielding = 0.0, wall = 0.0; ///< N/m, N
    core::Vec3 lateral = core::Vec3::Zero();
    core::Vec3 force = core::Vec3::Zero();
    core::Vec3 torque = core::Vec3::Zero();
};

/// P1's forces straight from the equations of models.md §1, plain and slow: every section, every spring,
/// every time. Shares plain data with the product and none of its code. `springs` is n′, 16 in the product.
/// The torque vector is made from the virtual work of T_x and T_y.
class UrethraReferenceForces {
public:
    UrethraReferenceForces(const simulation::UrethraAnatomy& anatomy, const simulation::Endoscope& endoscope,
                           const simulation::UrethraForceSettings& settings = {}, std::size_t springs = 16);
    ReferenceResponse respond(const simulation::EndoscopeMotion& motion) const;

private:
    struct Section {
        double s, ds, k, gap, mu, a;
    };
    struct Foot;
    Foot foot(const core::Vec3& p) const;
    void springs(const Foot& foot, ReferenceResponse& r, double& muN, double& opened, double& slope,
                 double& gx, double& gn) const;
    void bladder(const core::Vec3& p, ReferenceResponse& r, core::Vec3& force) const;
    double arcLength(double z) const;
    double radius(double s) const;
    double changed(double base, double s,
                   double (*value)(const simulation::UrethraLocalChange&, double)) const;
    double kPhi(double s, double& slope) const;

    simulation::UrethraAnatomy m_anatomy;
    simulation::Endoscope m_scope;
    simulation::UrethraForceSettings m_settings;
    double m_length = 0.0;
    std::vector<Section> m_sections;
    std::vector<double> m_cos, m_sin; ///< of n′ springs
};

} // namespace chiron::testing
