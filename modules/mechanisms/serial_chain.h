// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>

namespace chiron::mechanisms {

/// One link of a serial chain of revolute joints, with the joint that carries it. When every joint is at 0,
/// all link frames are parallel to the base frame, so that all lengths can be read from one drawing of the
/// arm.
struct ChainLink {
    /// Position of the joint from the joint before, in the frame of the link before (the base's for the
    /// first).
    core::Vec3 origin_m = core::Vec3::Zero();
    core::Vec3 axis = core::Vec3::UnitZ(); ///< unit vector, the same in both frames
    double mass_kg = 0.0;
    core::Vec3 centreOfMass_m = core::Vec3::Zero(); ///< from the joint, in the link's own frame
    core::Mat3 inertia_kgm2 = core::Mat3::Zero();   ///< about the centre of mass, in the link's own frame
};

/// Rigid-body kinematics and dynamics of N revolute joints in series on a fixed base:
///   M(q) q̈ + c(q, q̇) + g(q) = τ + Σ Jᵀ f.
/// Call place(q) first; all other functions refer to that pose. Inverse dynamics use the recursive
/// Newton–Euler algorithm (Luh, Walker & Paul 1980), the inertia composite bodies (Walker & Orin 1982); both
/// as in Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 5 and 6, written out in vectors.
/// Unit: SI.
/// Frame: B (base), for everything.
/// Thread: any; allocates nothing.
template <int N> class SerialChain {
public:
    using Vector = Eigen::Matrix<double, N, 1>;
    using Matrix = Eigen::Matrix<double, N, N>;
    using Jacobian = Eigen::Matrix<double, 6, N>; ///< rows: linear (m/s), then angular velocity (rad/s)
    using Links = std::array<ChainLink, static_cast<std::size_t>(N)>;

    explicit SerialChain(const Links& links) noexcept : m_links(links) { place(Vector::Zero()); }

    void place(const Vector& q) noexcept {
        core::Mat3 before = core::Mat3::Identity();
        core::Vec3 origin = core::Vec3::Zero();
        for (int i = 0; i < N; ++i) {
            const ChainLink& link = m_links[at(i)];
            Body& body = m_bodies[at(i)];
            origin += before * link.origin_m;
            body.origin = origin;
            body.axis = before * link.axis;
            body.turn = before * turnAbout(link.axis, q[i]);
            body.arm = body.turn * link.centreOfMass_m;
            body.inertia = body.turn * link.inertia_kgm2 * body.turn.transpose();
            before = body.turn;
        }
    }

    const core::Mat3& orientation(int link) const noexcept { return m_bodies[at(link)].turn; }
    const core::Vec3& joint(int link) const noexcept { return m_bodies[at(link)].origin; }
    const core::Vec3& axis(int link) const noexcept { return m_bodies[at(link)].axis; }
    /// Returns a point of a link that is given in the link's frame, m.
    core::Vec3 point(int link, const core::Vec3& fromJoint_m) const noexcept {
        return joint(link) + orientation(link) * fromJoint_m;
    }

    /// Jacobian of a point (in B) that belongs to a link; the columns of joints beyond that link are 0.
    Jacobian jacobian(int link, const core::Vec3& point_B) const noexcept {
        Jacobian j = Jacobian::Zero();
        for (int i = 0; i <= link; ++i) {
            j.template block<3, 1>(0, i) = axis(i).cross(point_B - joint(i));
            j.template block<3, 1>(3, i) = axis(i);
        }
        return j;
    }
    /// Returns Jᵀ f for a wrench on a link about a point of it: generalised efforts, N·m.
    Vector efforts(int link, const core::Vec3& point_B, const core::Wrench& wrench_B) const noexcept {
        Vector tau = Vector::Zero();
        for (int i = 0; i <= link; ++i)
            tau[i] = axis(i).cross(point_B - joint(i)).dot(wrench_B.force) + axis(i).dot(wrench_B.torque);
        return tau;
    }
    void velocity(int link, const core::Vec3& point_B, const Vector& rates, core::Vec3& v_B,
                  core::Vec3& w_B) const noexcept {
        v_B.setZero();
        w_B.setZero();
        for (int i = 0; i <= link; ++i) {
            v_B += rates[i] * axis(i).cross(point_B - joint(i));
            w_B += rates[i] * axis(i);
        }
    }

    /// Returns the efforts that give these accelerations, by recursive Newton–Euler. `down_m_per_s2`:
    /// gravity, along −z of B.
    Vector inverseDynamics(const Vector& rates, const Vector& accelerations,
                           double down_m_per_s2) const noexcept {
        std::array<core::Vec3, static_cast<std::size_t>(N)> force, moment;
        core::Vec3 w = core::Vec3::Zero(), dw = core::Vec3::Zero(), a(0.0, 0.0, down_m_per_s2),
                   at_m = core::Vec3::Zero();
        for (int i = 0; i < N; ++i) {
            const Body& body = m_bodies[at(i)];
            const core::Vec3 way = body.origin - at_m;
            at_m = body.origin;
            a += dw.cross(way) + w.cross(w.cross(way));
            const core::Vec3 spin = rates[i] * body.axis;
            dw += accelerations[i] * body.axis + w.cross(spin);
            w += spin;
            const core::Vec3 aCentre = a + dw.cross(body.arm) + w.cross(w.cross(body.arm));
            force[at(i)] = m_links[at(i)].mass_kg * aCentre;
            moment[at(i)] = body.inertia * dw + w.cross(body.inertia * w);
        }
        Vector tau;
        // On link i, by link i − 1, about its joint.
        core::Vec3 f = core::Vec3::Zero(), n = core::Vec3::Zero();
        for (int i = N - 1; i >= 0; --i) {
            const Body& body = m_bodies[at(i)];
            if (i + 1 < N)
                n += (m_bodies[at(i + 1)].origin - body.origin).cross(f);
            n += moment[at(i)] + body.arm.cross(force[at(i)]);
            f += force[at(i)];
            tau[i] = body.axis.dot(n);
        }
        return tau;
    }
    /// c: Coriolis and centrifugal terms.
    Vector bias(const Vector& rates) const noexcept { return inverseDynamics(rates, Vector::Zero(), 0.0); }
    /// g = ∂V/∂q.
    Vector gravity() const noexcept {
        return inverseDynamics(Vector::Zero(), Vector::Zero(), core::kStandardGravity);
    }

    /// M(q): symmetric, and positive definite as long as every joint carries some inertia.
    Matrix inertia() const noexcept {
        Matrix m;
        double mass = 0.0;
        core::Vec3 centre = core::Vec3::Zero(); // of all links from j on
        core::Mat3 about = core::Mat3::Zero();  // its inertia about that centre
        for (int j = N - 1; j >= 0; --j) {
            const Body& body = m_bodies[at(j)];
            const double own = m_links[at(j)].mass_kg;
            const core::Vec3 ownCentre = body.origin + body.arm;
            const double sum = mass + own;
            const core::Vec3 joined =
                sum > 0.0 ? core::Vec3((mass * centre + own * ownCentre) / sum) : ownCentre;
            about +=
                body.inertia + pointInertia(mass, centre - joined) + pointInertia(own, ownCentre - joined);
            mass = sum;
            centre = joined;
            const core::Vec3 push = mass * body.axis.cross(centre - body.origin);
            const core::Vec3 turn = about * body.axis;
            for (int i = 0; i <= j; ++i)
                m(i, j) = m(j, i) = axis(i).dot(turn + (centre - joint(i)).cross(push));
        }
        return m;
    }

    double potential_J() const noexcept { ///< of the weight; 0 at the height of B's origin
        double energy = 0.0;
        for (int i = 0; i < N; ++i)
            energy += m_links[at(i)].mass_kg * core::kStandardGravity *
                      (m_bodies[at(i)].origin.z() + m_bodies[at(i)].arm.z());
        return energy;
    }

    /// Solves M x = b for x, M symmetric and positive definite, by M = L D Lᵀ.
    static Vector solve(Matrix m, Vector b) noexcept {
        Vector pivot; // reciprocals of D; L grows in the lower half, L D in the upper
        for (int k = 0; k < N; ++k) {
            pivot[k] = 1.0 / m(k, k);
            for (int i = k + 1; i < N; ++i) {
                m(i, k) = m(k, i) * pivot[k];
                b[i] -= m(i, k) * b[k];
                for (int l = k + 1; l <= i; ++l)
                    m(l, i) -= m(i, k) * m(k, l);
            }
        }
        for (int k = N - 1; k >= 0; --k) {
            b[k] *= pivot[k];
            for (int i = k + 1; i < N; ++i)
                b[k] -= m(i, k) * b[i];
        }
        return b;
    }

private:
    struct Body {
        core::Vec3 origin = core::Vec3::Zero(); ///< of the joint
        core::Vec3 axis = core::Vec3::UnitZ();
        core::Mat3 turn = core::Mat3::Identity();
        core::Vec3 arm = core::Vec3::Zero(); ///< from the joint to the centre of mass
        core::Mat3 inertia = core::Mat3::Zero();
    };
    static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

    static core::Mat3 turnAbout(const core::Vec3& u, double angle) noexcept { // Rodrigues
        const double c = std::cos(angle), s = std::sin(angle), v = 1.0 - c;
        core::Mat3 r;
        r << c + v * u.x() * u.x(), v * u.x() * u.y() - s * u.z(), v * u.x() * u.z() + s * u.y(), //
            v * u.x() * u.y() + s * u.z(), c + v * u.y() * u.y(), v * u.y() * u.z() - s * u.x(),  //
            v * u.x() * u.z() - s * u.y(), v * u.y() * u.z() + s * u.x(), c + v * u.z() * u.z();
        return r;
    }
    static core::Mat3 pointInertia(double mass, const core::Vec3& r) noexcept {
        return mass * (r.squaredNorm() * core::Mat3::Identity() - r * r.transpose());
    }

    Links m_links;
    std::array<Body, static_cast<std::size_t>(N)> m_bodies{};
};

} // namespace chiron::mechanisms
