// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/palpation/tissue_contact.h"

#include "simulation/palpation/lean.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {
/// The tool's x in W, from its unit quaternion.
core::Vec3 xOf(const core::Quat& q) noexcept {
    return {1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()), 2.0 * (q.x() * q.y() + q.w() * q.z()),
            2.0 * (q.x() * q.z() - q.w() * q.y())};
}

/// Of P3's re-cast contact point, what counts: all of it down to 60° off the normal, nothing from 75° on, where a ray grazes.
double rayWeight(double cosine) noexcept { return smoothstep((cosine - 0.25) / 0.25); }
} // namespace

// Parts of one tick, inlined by order: handed over in memory, small vectors are read back before they are written.

[[gnu::always_inline]] inline TissueContact::Meeting TissueContact::meet(const core::ToolState& tool, const SurfaceFoot& foot) const noexcept {
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

[[gnu::always_inline]] inline StiffnessGain TissueContact::gainAt(const SurfaceFoot& foot, const core::Vec3& p_W) const noexcept {
    StiffnessGain sum;
    if (m_parameters.lumps != LumpLaw::secondSurface && m_lumpCount > 0) {
        const double lambda = m_parameters.sinkage;
        const double a = m_parameters.contactRadius_m;
        const SunkContact at{(1.0 - lambda) * foot.p_W + lambda * p_W, foot.normal, foot.follows, foot.depth_m, lambda,
                             5.0 / 3.0 * a * a, m_surface.flat()};
        for (int i = 0; i < m_lumpCount; ++i) {
            const PlacedLump& lump = m_lumps[static_cast<std::size_t>(i)];
            addLump(at, lump.centre_W, lump.strength_m4, sum);
        }
    }
    if (m_regionCount > 0) {
        double gain = 0.0;
        core::Vec2 slope = core::Vec2::Zero();
        for (std::size_t i = 0; i < m_regionCount; ++i)
            m_regions[i].add(foot.p_W.head<2>(), gain, slope);
        sum.gain += gain;
        sum.lateral_m2 += 0.5 * foot.depth_m * foot.depth_m * (foot.follows * core::Vec3(slope.x(), slope.y(), 0.0));
    }
    return sum;
}

[[gnu::always_inline]] inline TissueContact::Elastic TissueContact::pressOn(const Meeting& meeting, const core::Vec3& p_W) const noexcept {
    const SurfaceFoot& foot = meeting.foot;
    const double k = m_normalStiffness;
    StiffnessGain sum = gainAt(foot, p_W);
    if (m_parameters.lumps == LumpLaw::stiffnessTimesDepth) // as published: no lateral part, no potential
        sum.lateral_m2.setZero();
    Elastic out;
    out.stiffness_N_per_m = k * (1.0 + sum.gain);
    out.energy_J = 0.5 * out.stiffness_N_per_m * foot.depth_m * foot.depth_m;
    if (m_parameters.contact == TissueContactLaw::anchored) {
        out.force = (out.stiffness_N_per_m * foot.depth_m) * foot.normal - k * sum.lateral_m2;
    } else {
        // K acts on the spring to the re-cast point; what lies in the tissue adds to it by its own potential.
        const core::Vec3 stiffness(m_parameters.tangentAlong_N_per_m, m_parameters.tangentAcross_N_per_m, k);
        const core::Vec3 d = meeting.frame.to(meeting.spring_m);
        const core::Vec3 f = voigtForce(stiffness, d, core::Vec3::Zero(), core::Vec3::Zero());
        out.force = meeting.frame.from(f) + k * (sum.gain * foot.depth_m * foot.normal - sum.lateral_m2);
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

/// The clipped bristle of models.md §2.2 with K = diag(along, across): z ← z + Δx in the contact frame, ‖K z‖ ≤ μ f_n, f = −K z.
[[gnu::always_inline]] inline core::Vec3 TissueContact::bristle(const core::Vec3& p_W, const ContactFrame& frame, double normalForce_N, TissueTouch& touch,
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
    core::Vec2 pull(m_parameters.tangentAlong_N_per_m * touch.stretch_m.x(), m_parameters.tangentAcross_N_per_m * touch.stretch_m.y());
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

[[gnu::always_inline]] inline void TissueContact::show(const core::ToolState& tool, TissueResponse& out) const noexcept {
    const Lean lean = leanOf(out.force, out.normal, xOf(tool.q_WT));
    out.normalForce_N = lean.normalForce_N;
    out.lean_rad = lean.angle_rad;
    out.display = lean.display;
    out.leanSaturated = lean.saturated;
}

TissueResponse TissueContact::respond(const core::ToolState& tool, TissueTouch& touch) const noexcept {
    TissueResponse out;
    out.surfacePoint = tool.p_WT;
    if (!tool.p_WT.allFinite() || !tool.v_WT.allFinite()) {
        touch.release();
        return out;
    }
    const SurfaceFoot foot = m_surface.nearest(tool.p_WT, touch.touching ? touch.foot_m : core::Vec2(tool.p_WT.head<2>()));
    out.surfacePoint = foot.p_W;
    out.normal = foot.normal;
    if (!(foot.depth_m > 0.0)) {
        touch.release();
        return out;
    }
    const Meeting meeting = meet(tool, foot);
    const ContactFrame& frame = meeting.frame;
    const Elastic elastic = pressOn(meeting, tool.p_WT);
    out.inContact = true;
    out.surfacePoint = meeting.contact_W;
    out.normal = frame.z;
    out.depth_m = foot.depth_m;
    out.energy_J = elastic.energy_J;
    out.stiffness_N_per_m = std::max(elastic.stiffness_N_per_m, m_largestTangent);

    // F = K d + B v (eq. 1); the normal part never pulls, and a finger that leaves faster than the tissue follows drags nothing along.
    const core::Vec3& damping = m_parameters.damping_Ns_per_m;
    const double weight = smoothstep(foot.depth_m * m_perDampingDepth);
    const double pressed = elastic.force.dot(frame.z);
    const double normal = std::max(0.0, pressed - weight * damping.z() * tool.v_WT.dot(frame.z));
    const double dragging = normal < pressed ? weight * normal / pressed : weight;
    out.force = elastic.force + (normal - pressed) * frame.z -
                (dragging * damping.x() * tool.v_WT.dot(frame.x)) * frame.x - (dragging * damping.y() * tool.v_WT.dot(frame.y)) * frame.y;
    out.force += bristle(tool.p_WT, frame, normal, touch, out.energy_J);
    touch.foot_m = foot.p_W.head<2>();
    show(tool, out);
    return out;
}

} // namespace chiron::simulation
