// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/urethra_reference_forces.h"

#include <algorithm>
#include <cmath>

namespace chiron::testing {

using core::Vec3;

namespace {

constexpr double kPi = 3.141592653589793;

double smooth(double x) {
    x = std::min(1.0, std::max(0.0, x));
    return x * x * (3.0 - 2.0 * x);
}

double smoothSlope(double x) {
    return x <= 0.0 || x >= 1.0 ? 0.0 : 6.0 * x - 6.0 * x * x;
}

} // namespace

/// The foot on the centre-line: place, frame and how s changes with the point.
struct UrethraReferenceForces::Foot {
    double s = 0.0, psi = 0.0, kappa = 0.0, ex = 0.0, en = 0.0;
    Vec3 t, n, ds;
};

UrethraReferenceForces::UrethraReferenceForces(const simulation::UrethraAnatomy& anatomy,
                                               const simulation::Endoscope& endoscope,
                                               const simulation::UrethraForceSettings& settings,
                                               std::size_t springs)
    : m_anatomy(anatomy), m_scope(endoscope), m_settings(settings), m_length(arcLength(anatomy.zEnd_m)) {
    std::vector<std::array<double, 2>> places; // s, Δs
    if (settings.sections == simulation::ForceSections::fine) {
        double step = settings.maximumStep_m;
        for (std::size_t i = 0; i < anatomy.changeCount; ++i)
            step = std::min(step, anatomy.changes[i].edge_m / 3.2);
        const int count = static_cast<int>(std::ceil(m_length / step));
        for (int i = 0; i < count; ++i)
            places.push_back({(i + 0.5) * m_length / count, m_length / count});
    } else {
        const int w = settings.basicSections;
        for (int i = 0; i < w; ++i) {
            const double here = arcLength(anatomy.zEnd_m * i / (w - 1));
            const double before = i > 0 ? arcLength(anatomy.zEnd_m * (i - 1) / (w - 1)) : here;
            const double after = i < w - 1 ? arcLength(anatomy.zEnd_m * (i + 1) / (w - 1)) : here;
            places.push_back({here, 0.5 * (after - before)});
        }
    }
    for (const auto& [s, ds] : places) {
        const double r = radius(s);
        const double kappa = changed(
            anatomy.wallStiffness_N_per_m3, s,
            [](const simulation::UrethraLocalChange& c, double base) { return base * c.stiffnessFactor; });
        const double mu =
            changed(anatomy.friction, s, [](const simulation::UrethraLocalChange& c, double base) {
                return base * c.frictionFactor;
            });
        const double a =
            smooth((s - anatomy.freeLength_m + anatomy.freeBlend_m) / (2.0 * anatomy.freeBlend_m));
        m_sections.push_back({s, ds, kappa * 2.0 * kPi * r / static_cast<double>(springs) * ds,
                              endoscope.radius_m - r, mu, a});
    }
    for (std::size_t j = 0; j < springs; ++j) {
        m_cos.push_back(std::cos(2.0 * kPi * static_cast<double>(j) / static_cast<double>(springs)));
        m_sin.push_back(std::sin(2.0 * kPi * static_cast<double>(j) / static_cast<double>(springs)));
    }
}

double UrethraReferenceForces::arcLength(double z) const {
    const double c = m_anatomy.curvature_per_m, x = z - m_anatomy.straight_m;
    return x <= 0.0 ? z
                    : m_anatomy.straight_m + 0.5 * x * std::sqrt(1.0 + 4.0 * c * c * x * x) +
                          std::asinh(2.0 * c * x) / (4.0 * c);
}

double UrethraReferenceForces::radius(double s) const {
    return changed(m_anatomy.radius_m, s,
                   [](const simulation::UrethraLocalChange& c, double) { return c.radius_m; });
}

double UrethraReferenceForces::changed(double base, double s,
                                       double (*value)(const simulation::UrethraLocalChange&, double)) const {
    for (std::size_t i = 0; i < m_anatomy.changeCount; ++i) {
        const simulation::UrethraLocalChange& c = m_anatomy.changes[i];
        const double rise = smooth((s - c.centre_m + 0.5 * c.length_m) / c.edge_m + 0.5);
        const double fall = smooth((c.centre_m + 0.5 * c.length_m - s) / c.edge_m + 0.5);
        base += rise * fall * (value(c, base) - base);
    }
    return base;
}

UrethraReferenceForces::Foot UrethraReferenceForces::foot(const Vec3& p_A) const {
    const double c = m_anatomy.curvature_per_m, straight = m_anatomy.straight_m;
    const Vec3 p = p_A - Vec3(0, 0, straight); // from the parabola's vertex
    Foot f;
    f.ex = p.x();
    if (p.z() <= 0.0) { // straight, with the arc length's lead-in over 10 mm
        const double u = 1.0 + p.z() / 0.010;
        const double q = 1.0 - 2.0 * c * p.y() * smooth(u);
        f.s = straight + p.z() / q;
        f.en = p.y();
        f.t = Vec3(0, 0, 1);
        f.n = Vec3(0, 1, 0);
        f.ds = Vec3(0, p.z() / (q * q) * 2.0 * c * smooth(u),
                    1.0 / q + p.z() / (q * q) * 2.0 * c * p.y() * smoothSlope(u) / 0.010);
        return f;
    }
    // Newton from the right of the only root with z > 0 of 2c²z³ + (1 − 2c y) z − p_z
    const double b = 1.0 - 2.0 * c * p.y();
    double z = std::cbrt(p.z() / (2.0 * c * c)) + (b < 0.0 ? std::sqrt(-b / (2.0 * c * c)) : 0.0);
    for (int i = 0; i < 100; ++i) {
        const double next = z - (2.0 * c * c * z * z * z + b * z - p.z()) / (6.0 * c * c * z * z + b);
        if (!(std::abs(next - z) > 1e-16 * std::abs(z)))
            break;
        z = next;
    }
    f.s = arcLength(straight + z);
    f.psi = std::atan(2.0 * c * z);
    f.t = Vec3(0, std::sin(f.psi), std::cos(f.psi));
    f.n = Vec3(0, std::cos(f.psi), -std::sin(f.psi));
    f.kappa = 2.0 * c * std::pow(std::cos(f.psi), 3);
    f.en = (p - Vec3(0, c * z * z, z)).dot(f.n);
    f.ds = f.t / (1.0 - f.kappa * f.en);
    return f;
}

double UrethraReferenceForces::kPhi(double s, double& slope) const {
    const double w = m_anatomy.angularCorner_m;
    const double from = m_anatomy.freeLength_m;
    const double to = m_length - w;
    const double rate = m_anatomy.angularStiffness_Nm_per_rad / (to - from);
    slope = 0.0;
    if (s <= from - w)
        return 0.0;
    if (s < from + w) {
        slope = rate * (s - from + w) / (2.0 * w);
        return rate * (s - from + w) * (s - from + w) / (4.0 * w);
    }
    if (s <= to - w) {
        slope = rate;
        return rate * (s - from);
    }
    if (s < to + w) {
        slope = rate * (to + w - s) / (2.0 * w);
        return m_anatomy.angularStiffness_Nm_per_rad - rate * (to + w - s) * (to + w - s) / (4.0 * w);
    }
    return m_anatomy.angularStiffness_Nm_per_rad;
}

void UrethraReferenceForces::springs(const Foot& f, ReferenceResponse& r, double& muN, double& opened,
                                     double& slope, double& gx, double& gn) const {
    const double beta = m_anatomy.wallStiffening_per_m;
    const double l = m_scope.beak_m;
    const double lb = m_scope.behind_m;
    for (const Section& at : m_sections) {
        const double x = at.s - f.s;
        double W = 0.0, B = 0.0, dW = 0.0, dB = 0.0;
        if (x <= 0.0) {
            W = 1.0;
            B = x > -lb ? 0.5 * (1.0 + std::cos(kPi * x / lb)) : 0.0;
            dB = x > -lb ? 0.5 * kPi / lb * std::sin(kPi * x / lb) : 0.0;
        } else if (x < l) {
            W = B = 0.5 * (1.0 + std::cos(kPi * x / l));
            dW = dB = 0.5 * kPi / l * std::sin(kPi * x / l);
        }
        const double most = W * at.gap + at.a * B * std::sqrt(f.ex * f.ex + f.en * f.en);
        const double touching = std::min(1.0, std::max(0.0, most / 0.0005));
        opened += W * at.ds * touching;
        for (const double cosine : m_cos) // a ring that is pressed aside, as if all of it touched
            r.yielding += at.k * at.a * at.a * B * B * cosine * cosine *
                          (1.0 + 2.0 * beta * std::max(0.0, W * at.gap)) * touching;
        for (std::size_t j = 0; j < m_cos.size(); ++j) {
            const double eu = f.ex * m_cos[j] + f.en * m_sin[j];
            const double d = W * at.gap + at.a * B * eu;
            if (d <= 0.0)
                continue;
            const double force = at.k * d * (1.0 + beta * d);
            r.U += at.k * (0.5 * d * d + beta * d * d * d / 3.0);
            r.N += force;
            muN += at.mu * force;
            slope += force * (dW * at.gap + at.a * dB * eu);
            gx += force * at.a * B * m_cos[j];
            gn += force * at.a * B * m_sin[j];
        }
    }
}

void UrethraReferenceForces::bladder(const Vec3& p, ReferenceResponse& r, Vec3& force) const {
    const double past = m_anatomy.zEnd_m - m_anatomy.straight_m;
    const double psi = std::atan(2.0 * m_anatomy.curvature_per_m * past);
    const Vec3 t(0, std::sin(psi), std::cos(psi));
    const Vec3 neck(0, m_anatomy.curvature_per_m * past * past, m_anatomy.zEnd_m);
    const Vec3 x = p - (neck + m_anatomy.bladderRadius_m * t);
    const double d = std::max(0.0, x.norm() - (m_anatomy.bladderRadius_m - m_scope.radius_m));
    if (d == 0.0)
        return;
    const double sine = x.cross(t).norm() / x.norm();
    const double theta = std::atan2(sine, -x.dot(t) / x.norm());
    const double gAt = (theta - m_anatomy.bladderOpening_rad) / m_anatomy.bladderOpeningEdge_rad;
    const double qAt = (p - neck).dot(t) / 0.005;
    const double hAt = p.z() / 0.010;
    const double g = smooth(gAt), q = smooth(qAt), h = smooth(hAt);
    Vec3 dTheta = Vec3::Zero(); // −t turned towards x, over the distance
    if (smoothSlope(gAt) > 0.0)
        dTheta = (t - x * (x.dot(t) / x.squaredNorm())).normalized() / x.norm();
    const double k = m_anatomy.bladderStiffness_N_per_m;
    r.U += 0.5 * k * d * d * g * q * h;
    force = -k * d * g * q * h * x.normalized() -
            0.5 * k * d * d *
                (smoothSlope(gAt) / m_anatomy.bladderOpeningEdge_rad * q * h * dTheta +
                 g * smoothSlope(qAt) / 0.005 * h * t + g * q * smoothSlope(hAt) / 0.010 * Vec3(0, 0, 1));
}

ReferenceResponse UrethraReferenceForces::respond(const simulation::EndoscopeMotion& m) const {
    ReferenceResponse r;
    const Foot f = foot(m.p_A);
    r.s = f.s;
    r.ex = f.ex;
    r.en = f.en;
    double muN = 0.0, opened = 0.0, slope = 0.0, gx = 0.0, gn = 0.0;
    springs(f, r, muN, opened, slope, gx, gn);

    const Vec3& a = m.axis_A;
    r.phiX = f.psi - std::atan2(a.y(), a.z());
    r.phiY = std::asin(a.x());
    double k1 = 0.0;
    const double k = kPhi(f.s, k1);
    double c = 0.0,
           dc = 0.0; // the pelvic floor's lever: tilt that belongs to an offset of 1 m, and its derivative
    if (const double span = m_anatomy.pivotSpan_m; span > 0.0) {
        const double l = f.s - m_anatomy.freeLength_m, below = l * l + span * span;
        c = l / below;
        dc = 1.0 / below - 2.0 * l * l / (below * below);
    }
    const double turnX = r.phiX + c * f.en, turnY = r.phiY - c * f.ex;
    const double tilt = turnX * turnX + turnY * turnY;
    r.U += 0.5 * k * tilt;
    slope += 0.5 * k1 * tilt + k * turnX * (f.kappa + dc * f.en) - k * turnY * dc * f.ex;
    gn += k * turnX * c;
    gx -= k * turnY * c;
    r.Tx = -k * turnX;
    r.Ty = -k * turnY;

    const double off = std::sqrt(f.ex * f.ex + f.en * f.en) - 0.010; // what holds the free part
    if (off > 0.0 && m_anatomy.freeHold_N_per_m > 0.0) {
        const double hold = m_anatomy.freeHold_N_per_m, d = m_anatomy.freeBlend_m,
                     rise = m_scope.beak_m + m_anatomy.freeLength_m - d;
        const double in = (f.s + m_scope.beak_m) / rise, on = (f.s - m_anatomy.freeLength_m + d) / (2.0 * d);
        r.U += 0.5 * hold * off * off * smooth(in) * (1.0 - smooth(on));
        slope += 0.5 * hold * off * off *
                 (smoothSlope(in) / rise * (1.0 - smooth(on)) - smooth(in) * smoothSlope(on) / (2.0 * d));
        gx += hold * off * smooth(in) * (1.0 - smooth(on)) * f.ex / (off + 0.010);
        gn += hold * off * smooth(in) * (1.0 - smooth(on)) * f.en / (off + 0.010);
    }

    Vec3 wall = Vec3::Zero();
    bladder(m.p_A, r, wall);
    r.lateral = -gx * Vec3(1, 0, 0) - gn * f.n + wall;
    r.elastic = -slope * f.ds.dot(f.t);

    const double v = m.v_A.dot(a), w = m.w_A.dot(a), re = m_scope.radius_m;
    const double v0 = std::max({0.001, m_settings.count_m / 0.015, muN / m_settings.maximumDamping_Ns_per_m});
    const double root = std::sqrt(v * v + w * re * w * re + v0 * v0);
    r.F1 = -muN * v / root;
    r.F2 = -m_anatomy.viscosity_Ns_per_m2 * opened * v;
    r.Tz = -muN * re * w * re / root - m_anatomy.viscosity_Ns_per_m2 * opened * re * re * w;
    const Vec3 sideways = m.v_A - v * a;
    const double dashpot = std::min(m_anatomy.wallRetardation_s * r.yielding, m.mostDamping_Ns_per_m);
    r.wall = dashpot * sideways.norm();
    r.force = r.lateral - slope * f.ds + (r.F1 + r.F2) * a - dashpot * sideways;
    // virtual work: a turn by δ about the unit vector i moves the axis by i × a
    for (int i = 0; i < 3; ++i) {
        const Vec3 da = Vec3::Unit(i).cross(a);
        const double dPhiX = -(a.z() * da.y() - a.y() * da.z()) / (a.y() * a.y() + a.z() * a.z());
        const double dPhiY = da.x() / std::sqrt(1.0 - a.x() * a.x());
        r.torque[i] = r.Tx * dPhiX + r.Ty * dPhiY + r.Tz * a[i];
    }
    return r;
}

} // namespace chiron::testing
