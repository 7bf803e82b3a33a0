// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/palpation/layered_stiffness.h"
#include "simulation/palpation/tissue_contact.h"

#include <algorithm>
#include <limits>

namespace chiron::simulation {

namespace {
constexpr double kNever_m = std::numeric_limits<double>::infinity();
/// Shares of the smallest radius of curvature. A foot moves 1/(1 − share) times as fast as its tool, without
/// bound towards 1 and 5 times at the first value.
constexpr double kUprightFrom = 0.80;
constexpr double kUprightTo = 0.98;

/// k of a flat punch of radius a (Johnson, Contact Mechanics, §3.5): 2 a E/(1 − ν²), with the effective
/// modulus of the layers.
double punchStiffness(const TissueParameters& p) {
    const std::size_t count = std::min(p.layers.size(), TissueParameters::kMaxLayers);
    const double modulus_Pa =
        count == 0 ? TissueLayer{}.modulus_Pa
                   : layeredModulus_Pa(std::span(p.layers).first(count), p.contactRadius_m, p.poisson);
    return 2.0 * p.contactRadius_m * modulus_Pa / (1.0 - p.poisson * p.poisson);
}
} // namespace

TissueContact::TissueContact(const TissueParameters& parameters)
    : m_parameters(parameters), m_surface(parameters.shape),
      m_normalStiffness(parameters.stiffness_N_per_m > 0.0 ? parameters.stiffness_N_per_m
                                                           : punchStiffness(parameters)),
      m_perDampingDepth(1.0 / std::max(parameters.dampingDepth_m, 1e-9)),
      m_flatFrame(ContactFrame::on(core::Vec3::UnitZ(), parameters.fibreDirection)), m_sunkDepth_m(kNever_m),
      m_uprightFrom_m(kUprightFrom * m_surface.deepestUnique_m()),
      m_uprightTo_m(kUprightTo * m_surface.deepestUnique_m()) {
    if (parameters.friction > 0.0 || parameters.contact == TissueContactLaw::p3Recast)
        m_largestTangent = std::max(parameters.tangentAlong_N_per_m, parameters.tangentAcross_N_per_m);
    for (const StiffRegion& region : parameters.regions) {
        if (m_regionCount == m_regions.size())
            break;
        const double radius_m = region.radii_m.minCoeff();
        // (1 − t²)³ bends most in its middle, by 6
        m_regionBend_per_m2[m_regionCount] = 6.0 * std::abs(region.gain) / (radius_m * radius_m);
        m_regions[m_regionCount++] =
            SmoothPatch::over(region.centre_m, region.radii_m, region.turn_rad, region.gain);
    }
}

void TissueContact::setLumps(std::span<const Lump> lumps) noexcept {
    m_lumpCount = static_cast<int>(std::min(lumps.size(), m_lumps.size()));
    m_sunkDepth_m = kNever_m;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_lumpCount); ++i) {
        const Lump& lump = lumps[i];
        if (m_parameters.sinkage > 0.0)
            m_sunkDepth_m = std::min(m_sunkDepth_m, std::max(1e-6, lump.depth_m - lump.radius_m) /
                                                        (2.0 * m_parameters.sinkage));
        m_lumps[i].centre_W =
            m_surface.pointAt(lump.place_m) - lump.depth_m * m_surface.normalAt(lump.place_m);
        m_lumps[i].radius_m = lump.radius_m;
        m_lumps[i].strength_m4 = lumpStrength(m_parameters.contactRadius_m, lump.radius_m, lump.ratio);
    }
}

core::Vec3 TissueContact::lumpCentre_W(int lump) const noexcept {
    return lump >= 0 && lump < m_lumpCount ? m_lumps[static_cast<std::size_t>(lump)].centre_W
                                           : core::Vec3(core::Vec3::Zero());
}

} // namespace chiron::simulation
