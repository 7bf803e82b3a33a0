// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/palpation/tissue_contact.h"

#include "simulation/palpation/lean.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {
/// The tool's x axis in W, from its unit quaternion.
core::Vec3 xOf(const core::Quat& q) noexcept {
    return {1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()), 2.0 * (q.x() * q.y() + q.w() * q.z()),
            2.0 * (q.x() * q.z() - q.w() * q.y())};
}

/// Weight of P3's re-cast contact point: 1 up to 60° off the normal, 0 from 75° on, where a ray grazes the
/// surface.
double rayWeight(double cosine) noexcept {
    return smoothstep((cosine - 0.25) / 0.25);
}
} // namespace

// Parts of one tick. They are always inlined: small vectors that are passed in memory would be read back
// before their writes complete.

[[gnu::always_inline]] inline TissueContact::Meeting
TissueContact::meet(const core::ToolState& tool, const SurfaceFoot& foot) const noexcept {
    Meeting out{foot, foot.p_W, foot.depth_m * foot.normal, m_flatFrame};
    if (m_parameters.contact == TissueContactLaw::p3Recast) {
        const core::Vec3 ray = tool.q_WT * -core::Vec3::UnitZ();
        const double weight = rayWeight(-ray.dot(foot.normal));
        core::Vec3 hit;
        if (weight > 0.0 && m_surface.meets(tool.p_WT, ray, hit)) {
            const core::Vec2 xy = foot.p_W.head<2>() + weight * (hit - foot.p_W).head<2>();
            out.contact_W = m_surface.pointAt(xy);
            out.spring_m = out.contact_W - tool.p_WT;
            out.frame = ContactFrame::on(m_surface.normalAt(xy), m_parameters.fibreDirection);
            return out;
        }
    }
    if (!m_surface.flat())
        out.frame = ContactFrame::on(foot.normal, m_parameters.fibreDirection);
    return out;
}

/// Beyond the depth to which the lumps' law is valid, the contact smoothly approaches the lumps by at most
/// another quarter of that depth. Otherwise it would pass through the lump, and the force would reverse.
[[gnu::always_inline]] inline SunkContact TissueContact::sunk(const SurfaceFoot& foot,
                                                              const core::Vec3& p_W) const noexcept {
    const double a = m_parameters.contactRadius_m;
    double lambda = m_parameters.sinkage;
    double slope = 0.0;
    const double d = foot.depth_m;
    if (d > m_sunkDepth_m) {
        const double further = 0.25 * m_sunkDepth_m + 1e-6;
        const double left = std::exp(-(d - m_sunkDepth_m) / further);
        const double counted = m_sunkDepth_m + further * (1.0 - left);
        slope = lambda * (left * d - counted) / (d * d);
        lambda *= counted / d;
    }
    return {(1.0 - lambda) * foot.p_W + lambda * p_W,
            foot.normal,
            foot.follows,
            d,
            lambda,
            5.0 / 3.0 * a * a,
            m_surface.flat(),
            slope};
}

/// From m_uprightFrom_m on, the energy changes over to one that has no centre of curvature: U = (1 − w) U + w
/// U₂, with w a smoothstep of the depth. U₂ = ½ k (δ² − g² σ), δ = z(x, y) − z_p, σ = ‖∇z‖²/(1 + ‖∇z‖²). At
/// first g = δ, and U₂ belongs to the distance to the tangent plane straight above; g ends at twice
/// m_uprightTo_m, because otherwise the lateral force would become steeper without bound. f = −∇U, with ∇d =
/// −n and ∇σ = 2 H ∇z/(1 + ‖∇z‖²)², H the second derivatives of z. The contact frame changes over in the same
/// way.
void TissueContact::turnUpright(Meeting& meeting, const core::Vec3& p_W, Elastic& elastic) const noexcept {
    const SurfaceFoot& foot = meeting.foot;
    const double span = m_uprightTo_m - m_uprightFrom_m;
    const double x = std::min(1.0, (foot.depth_m - m_uprightFrom_m) / span);
    const double w = x * x * (3.0 - 2.0 * x);
    const SurfaceHeight over = m_surface.heightAt(p_W.head<2>());
    const double down_m = std::max(0.0, over.z_m - p_W.z());
    double counted_m = down_m;
    double countedSlope = 1.0;
    if (down_m > m_uprightTo_m) {
        countedSlope = std::exp(1.0 - down_m / m_uprightTo_m);
        counted_m = m_uprightTo_m * (2.0 - countedSlope);
    }
    const double slope2 = over.slope.squaredNorm();
    const double sigma = slope2 / (1.0 + slope2);
    const double k = m_normalStiffness;
    const double upwards_m = down_m - counted_m * countedSlope * sigma;
    const core::Vec2 sideways =
        upwards_m * over.slope -
        (counted_m * counted_m / ((1.0 + slope2) * (1.0 + slope2))) * (over.curvature_per_m * over.slope);
    const core::Vec3 upright = k * core::Vec3(-sideways.x(), -sideways.y(), upwards_m);
    const double energy_J = 0.5 * k * (down_m * down_m - counted_m * counted_m * sigma);
    // Bounds of the second derivatives of U₂ and of the blend: with D = δ, H and h = ‖∇z‖, ∂²U₂ ≤ k (1 + h² +
    // D H + 4 g h H + 4 g² H²).
    const double bent = over.curvature_per_m.norm(), steep = std::sqrt(slope2);
    // The contribution of the change of H is taken as half of the terms with H: an assumption
    // (test_tissue_reach).
    double steepest =
        k *
        (1.0 + slope2 +
         1.5 * (down_m * bent + 4.0 * counted_m * steep * bent + 4.0 * counted_m * counted_m * bent * bent));
    if (w < 1.0) {
        const double slope_per_m = 6.0 * x * (1.0 - x) / span;
        steepest = std::max(steepest, elastic.stiffness_N_per_m) +
                   6.0 / (span * span) * std::abs(energy_J - elastic.energy_J) +
                   2.0 * slope_per_m * (upright - elastic.force).norm();
        elastic.force = (1.0 - w) * elastic.force + w * upright +
                        ((energy_J - elastic.energy_J) * slope_per_m) * foot.normal;
        elastic.energy_J += w * (energy_J - elastic.energy_J);
    } else {
        elastic.force = upright;
        elastic.energy_J = energy_J;
    }
    elastic.stiffness_N_per_m = std::max(elastic.stiffness_N_per_m, steepest);
    const core::Vec3 above = core::Vec3(-over.slope.x(), -over.slope.y(), 1.0).normalized();
    meeting.frame =
        ContactFrame::on(((1.0 - w) * foot.normal + w * above).normalized(), m_parameters.fibreDirection);
}

[[gnu::always_inline]] inline StiffnessGain TissueContact::gainAt(const SurfaceFoot& foot,
                                                                  const core::Vec3& p_W) const noexcept {
    StiffnessGain sum;
    if (m_parameters.lumps != LumpLaw::secondSurface && m_lumpCount > 0) {
        const SunkContact at = sunk(foot, p_W);
        for (int i = 0; i < m_lumpCount; ++i) {
            const PlacedLump& lump = m_lumps[static_cast<std::size_t>(i)];
            addLump(at, lump.centre_W, lump.strength_m4, sum);
        }
    }
    if (m_regionCount > 0) {
        double gain = 0.0;
        core::Vec2 slope = core::Vec2::Zero();
        for (std::size_t i = 0; i < m_regionCount; ++i) {
            const double before = gain;
            m_regions[i].add(foot.p_W.head<2>(), gain, slope);
            if (gain != before)
                sum.bent_per_m2 += m_regionBend_per_m2[i];
        }
        sum.gain += gain;
        sum.lateral_m2 +=
            0.5 * foot.depth_m * foot.depth_m * (foot.follows * core::Vec3(slope.x(), slope.y(), 0.0));
    }
    return sum;
}

[[gnu::always_inline]] inline TissueContact::Elastic
TissueContact::pressOn(const Meeting& meeting, const core::Vec3& p_W) const noexcept {
    const SurfaceFoot& foot = meeting.foot;
    const double k = m_normalStiffness;
    StiffnessGain sum = gainAt(foot, p_W);
    // Lumps and regions count with a depth g(d) that ends at twice the depth to which the lumps' law is
    // valid. Otherwise their lateral force, which grows with g², would become steeper without bound. U = ½ k
    // d² + ½ k g² gain; the normal force still grows while the gains add up to less than 2.
    double counted_m = foot.depth_m;
    double countedSlope = 1.0;
    if (foot.depth_m > m_sunkDepth_m) {
        countedSlope = std::exp(1.0 - foot.depth_m / m_sunkDepth_m);
        counted_m = m_sunkDepth_m * (2.0 - countedSlope);
        const double share = counted_m / foot.depth_m;
        sum.lateral_m2 *= share * share;
    }
    const double gainDepth_m = counted_m * countedSlope;    // ½ d(g²)/dd
    if (m_parameters.lumps == LumpLaw::stiffnessTimesDepth) // as published: no lateral part, no potential
        sum.lateral_m2.setZero();
    Elastic out;
    // The force turns with the normal of the nearest point, which moves `follow` times as fast as the tool.
    // Lumps and regions add lateral stiffness by the slope and curvature of their gain, and this counts once
    // more times `follow` where the surface's own curvature changes over the region (an assumption;
    // test_tissue_reach).
    const double follow = m_surface.flat() ? 1.0 : foot.follows.cwiseAbs().rowwise().sum().maxCoeff();
    out.stiffness_N_per_m = k * (1.0 + sum.gain) * std::max(1.0, follow - 1.0) +
                            k * std::max(1.0, follow) *
                                (4.0 * sum.lateral_m2.norm() / std::max(counted_m, 1e-9) +
                                 0.5 * counted_m * counted_m * follow * follow * sum.bent_per_m2);
    out.energy_J = 0.5 * k * (foot.depth_m * foot.depth_m + sum.gain * counted_m * counted_m);
    if (m_parameters.contact == TissueContactLaw::anchored) {
        out.force = (k * (foot.depth_m + sum.gain * gainDepth_m)) * foot.normal - k * sum.lateral_m2;
    } else {
        // K acts on the spring to the re-cast point; lumps and regions add their own potential.
        const core::Vec3 stiffness(m_parameters.tangentAlong_N_per_m, m_parameters.tangentAcross_N_per_m, k);
        const core::Vec3 d = meeting.frame.to(meeting.spring_m);
        const core::Vec3 f = voigtForce(stiffness, d, core::Vec3::Zero(), core::Vec3::Zero());
        out.force = meeting.frame.from(f) + k * (sum.gain * gainDepth_m * foot.normal - sum.lateral_m2);
        out.energy_J += 0.5 * (f.dot(d) - k * foot.depth_m * foot.depth_m);
    }
    if (m_parameters.lumps == LumpLaw::secondSurface)
        addBalls(p_W, out);
    return out;
}

void TissueContact::addBalls(const core::Vec3& p_W, Elastic& elastic) const noexcept {
    for (int i = 0; i < m_lumpCount; ++i) {
        const PlacedLump& lump = m_lumps[static_cast<std::size_t>(i)];
        const core::Vec3 out = p_W - lump.centre_W;
        const double distance2 = out.squaredNorm();
        if (distance2 >= lump.radius_m * lump.radius_m || !(distance2 > 0.0))
            continue;
        const double distance = std::sqrt(distance2);
        const BallContact ball = ballContact(distance, lump.radius_m, m_parameters.secondStiffness_N_per_m);
        elastic.force += (ball.force_N / distance) * out;
        elastic.energy_J += ball.energy_J;
        elastic.stiffness_N_per_m += m_parameters.secondStiffness_N_per_m;
    }
}

/// The clipped bristle of models.md §2.2 with K = diag(along, across): z ← z + Δx in the contact frame, ‖K z‖
/// ≤ μ f_n, f = −K z.
[[gnu::always_inline]] inline core::Vec3 TissueContact::bristle(const core::Vec3& p_W,
                                                                const ContactFrame& frame,
                                                                double normalForce_N, TissueTouch& touch,
                                                                double& energy_J) const noexcept {
    if (touch.touching) {
        const core::Vec3 moved = p_W - touch.previous_W;
        touch.stretch_m += core::Vec2(moved.dot(frame.x), moved.dot(frame.y));
    }
    touch.touching = true;
    touch.previous_W = p_W;
    if (!(m_parameters.friction > 0.0) || m_parameters.contact == TissueContactLaw::p3Recast) {
        touch.stretch_m.setZero();
        return core::Vec3::Zero();
    }
    core::Vec2 pull(m_parameters.tangentAlong_N_per_m * touch.stretch_m.x(),
                    m_parameters.tangentAcross_N_per_m * touch.stretch_m.y());
    const double limit = m_parameters.friction * normalForce_N;
    const double pull2 = pull.squaredNorm();
    if (pull2 > limit * limit) {
        const double kept = limit / std::sqrt(pull2);
        touch.stretch_m *= kept;
        pull *= kept;
    }
    energy_J += 0.5 * pull.dot(touch.stretch_m);
    return -pull.x() * frame.x - pull.y() * frame.y;
}

[[gnu::always_inline]] inline void TissueContact::show(const core::ToolState& tool,
                                                       TissueResponse& out) const noexcept {
    const Lean lean = leanOf(out.force, out.normal, xOf(tool.q_WT));
    out.normalForce_N = lean.normalForce_N;
    out.lean_rad = lean.angle_rad;
    out.display = lean.display;
    out.leanSaturated = lean.saturated;
}

TissueResponse TissueContact::respond(const core::ToolState& tool, TissueTouch& touch,
                                      double mostDamping_Ns_per_m) const noexcept {
    TissueResponse out;
    out.surfacePoint = tool.p_WT;
    if (!tool.p_WT.allFinite() || !tool.v_WT.allFinite()) {
        touch.release();
        return out;
    }
    const SurfaceFoot foot =
        m_surface.nearest(tool.p_WT, touch.touching ? touch.foot_m : core::Vec2(tool.p_WT.head<2>()));
    out.surfacePoint = foot.p_W;
    out.normal = foot.normal;
    if (!(foot.depth_m > 0.0)) {
        touch.release();
        return out;
    }
    Meeting meeting = meet(tool, foot);
    Elastic elastic = pressOn(meeting, tool.p_WT);
    if (foot.depth_m > m_uprightFrom_m)
        turnUpright(meeting, tool.p_WT, elastic);
    const ContactFrame& frame = meeting.frame;
    out.inContact = true;
    out.beyondChecked = foot.depth_m > std::min(m_sunkDepth_m, m_uprightFrom_m);
    out.surfacePoint = meeting.contact_W;
    out.normal = frame.z;
    out.depth_m = foot.depth_m;
    out.energy_J = elastic.energy_J;
    out.stiffness_N_per_m = std::max(elastic.stiffness_N_per_m, m_largestTangent);

    // F = K d + B v (eq. 1). The normal part never pulls, and a finger that leaves faster than the tissue
    // follows is not damped sideways either.
    const core::Vec3& damping = m_parameters.damping_Ns_per_m;
    const double largest = damping.maxCoeff();
    const double weight =
        smoothstep(foot.depth_m * m_perDampingDepth) * DampingBudget::share(largest, mostDamping_Ns_per_m);
    out.damping_Ns_per_m = weight * largest;
    const double pressed = elastic.force.dot(frame.z);
    const double normal = std::max(0.0, pressed - weight * damping.z() * tool.v_WT.dot(frame.z));
    const double dragging = normal < pressed ? weight * normal / pressed : weight;
    out.force = elastic.force + (normal - pressed) * frame.z -
                (dragging * damping.x() * tool.v_WT.dot(frame.x)) * frame.x -
                (dragging * damping.y() * tool.v_WT.dot(frame.y)) * frame.y;
    out.force += bristle(tool.p_WT, frame, normal, touch, out.energy_J);
    touch.foot_m = foot.p_W.head<2>();
    show(tool, out);
    return out;
}

void TissueContact::addLumpsAcross(const core::Vec3& face_W, const core::Vec3& across,
                                   LumpsAcross& sum) const noexcept {
    const double spread2 = 5.0 / 3.0 * m_parameters.contactRadius_m * m_parameters.contactRadius_m;
    for (int i = 0; i < m_lumpCount; ++i) {
        const PlacedLump& lump = m_lumps[static_cast<std::size_t>(i)];
        const core::Vec3 r = face_W - lump.centre_W;
        const double along = r.dot(across);
        const double inverse = 1.0 / (r.squaredNorm() + spread2); // 1/S
        const double base = lump.strength_m4 * inverse * inverse * inverse;
        sum.gain += base * (along * along + spread2);
        sum.slope_per_m += 8.0 * std::abs(base) * r.norm(); // ‖2 (r·t) t/S³ − 6 H² r/S⁴‖, H² ≤ S
        sum.beyondChecked = sum.beyondChecked || r.squaredNorm() * 0.5625 < lump.radius_m * lump.radius_m;
    }
}

} // namespace chiron::simulation
