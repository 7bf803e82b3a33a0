// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/urethra_reference_geometry.h"

#include <algorithm>
#include <cmath>

namespace chiron::testing {

using core::Vec3;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNudge = 1e-6;

double smooth(double u) {
    if (u <= 0.0)
        return 0.0;
    return u >= 1.0 ? 1.0 : 3.0 * u * u - 2.0 * u * u * u;
}

double clamp01(double u) {
    return std::min(1.0, std::max(0.0, u));
}

Vec3 mix(const Vec3& a, const Vec3& b, double t) {
    return (1.0 - t) * a + t * b;
}

Vec3 casteljau(Vec3 a, Vec3 b, Vec3 c, Vec3 d, double t) {
    const Vec3 ab = mix(a, b, t), bc = mix(b, c, t), cd = mix(c, d, t);
    return mix(mix(ab, bc, t), mix(bc, cd, t), t);
}

Vec3 catmullRom(const Vec3& before, const Vec3& here, const Vec3& after) {
    const double d0 = (here - before).norm();
    const double d1 = (after - here).norm();
    return (d1 * (here - before) / d0 + d0 * (after - here) / d1) / (d0 + d1);
}

} // namespace

UrethraReferenceGeometry::UrethraReferenceGeometry(const simulation::UrethraAnatomy& anatomy,
                                                   const simulation::Endoscope& endoscope,
                                                   const simulation::UrethraMeshSettings& mesh)
    : m_anatomy(anatomy), m_scope(endoscope), m_mesh(mesh), m_length(arcLength(anatomy.zEnd_m)) {
    for (int i = 0; i < mesh.w; ++i)
        m_rest.push_back(circle(arcLength(anatomy.zEnd_m * i / (mesh.w - 1)), false));
}

double UrethraReferenceGeometry::arcLength(double z) const {
    const double c = m_anatomy.curvature_per_m, x = z - m_anatomy.straight_m;
    if (x <= 0.0)
        return z;
    const double root = std::sqrt(1.0 + 4.0 * c * c * x * x);
    return m_anatomy.straight_m + x * root / 2.0 + std::log(2.0 * c * x + root) / (4.0 * c);
}

UrethraReferenceGeometry::Frame UrethraReferenceGeometry::frame(double s) const {
    double low = 0.0;
    double high = s;
    for (int i = 0; i < 200; ++i) {
        const double z = (low + high) / 2.0;
        (arcLength(z) < s ? low : high) = z;
    }
    const double z = (low + high) / 2.0, x = std::max(0.0, z - m_anatomy.straight_m);
    const double psi = std::atan(2.0 * m_anatomy.curvature_per_m * x);
    return {Vec3(0.0, m_anatomy.curvature_per_m * x * x, z), Vec3(0.0, std::cos(psi), -std::sin(psi))};
}

double UrethraReferenceGeometry::baseRadius(double s) const {
    double radius = m_anatomy.radius_m;
    for (std::size_t i = 0; i < m_anatomy.changeCount; ++i) {
        const auto& change = m_anatomy.changes[i];
        const double w = smooth((s - change.centre_m + change.length_m / 2) / change.edge_m + 0.5) *
                         smooth((change.centre_m + change.length_m / 2 - s) / change.edge_m + 0.5);
        radius += w * (change.radius_m - m_anatomy.radius_m);
    }
    return radius;
}

Vec3 UrethraReferenceGeometry::tube(double s, double angle, bool withScope) const {
    double radius = baseRadius(s);
    double ex = 0.0;
    double en = 0.0;
    if (withScope) {
        const double ahead = 0.5 * (1.0 + std::cos(kPi * clamp01((s - m_now.tip_s_m) / m_scope.beak_m)));
        const double behind = 0.5 * (1.0 + std::cos(kPi * clamp01((m_now.tip_s_m - s) / m_scope.behind_m)));
        const double b = s > m_now.tip_s_m ? ahead : behind;
        const double e = std::sqrt(m_now.ex_m * m_now.ex_m + m_now.en_m * m_now.en_m);
        const double pressed = std::max(0.0, b * e - ahead * std::max(0.0, radius - m_scope.radius_m));
        if (e > 0.0) {
            ex = m_now.ex_m * pressed / e;
            en = m_now.en_m * pressed / e;
        }
        radius = std::max(radius, radius + (m_scope.radius_m - radius) * ahead);
    }
    const Frame f = frame(s);
    return f.p + (ex + radius * std::cos(angle)) * Vec3::UnitX() + (en + radius * std::sin(angle)) * f.n;
}

Vec3 UrethraReferenceGeometry::exactAt(double s, double angle) const {
    return tube(s, angle, m_now.inside);
}

UrethraReferenceGeometry::Section UrethraReferenceGeometry::circle(double s, bool withScope) const {
    Section section;
    section.s = s;
    for (int j = 0; j < m_mesh.n - 1; ++j)
        section.points.push_back(tube(s, 2.0 * kPi * j / (m_mesh.n - 1), withScope));
    return section;
}

// The deformation ends on the resting surface, with the slopes that the resting curves have there.
UrethraReferenceGeometry::Section UrethraReferenceGeometry::endOnRest(double s) const {
    Section section;
    section.s = s;
    section.onRest = true;
    std::size_t span = 0;
    while (m_rest[span + 1].s <= s)
        ++span;
    const double u = (s - m_rest[span].s) / (m_rest[span + 1].s - m_rest[span].s);
    for (std::size_t j = 0; j < m_rest[0].points.size(); ++j) {
        section.points.push_back(along(m_rest, span, j, u));
        const double chord = (m_rest[span + 1].points[j] - m_rest[span].points[j]).norm();
        const Vec3 a = m_rest[span].points[j];
        const Vec3 d = m_rest[span + 1].points[j];
        const Vec3 b = a + slopeAt(m_rest, span, j) * chord / 3.0;
        const Vec3 c = d - slopeAt(m_rest, span + 1, j) * chord / 3.0;
        const Vec3 slope = 3.0 * ((1 - u) * (1 - u) * (b - a) + 2 * u * (1 - u) * (c - b) + u * u * (d - c));
        section.restSlopes.push_back(slope / chord);
    }
    return section;
}

double UrethraReferenceGeometry::nudged(double s) const {
    for (const Section& basic : m_rest)
        if (std::abs(basic.s - s) < kNudge)
            return s < basic.s ? basic.s - kNudge : basic.s + kNudge;
    return s;
}

void UrethraReferenceGeometry::deform(const simulation::UrethraDeformation& deformation) {
    m_now = deformation;
    m_deformed.clear();
    double end = deformation.tip_s_m + m_scope.beak_m;
    if (!deformation.inside || end <= 0.0)
        return;
    const bool toTheNeck = end >= m_length;
    for (const Section& basic : m_rest)
        if (!toTheNeck && std::abs(basic.s - end) < kNudge)
            end = end < basic.s ? basic.s - kNudge : basic.s;
    for (const Section& basic : m_rest)
        if (toTheNeck || basic.s < end)
            m_deformed.push_back(circle(basic.s, true));
    double last = 0.0;
    for (int i = 0; i < m_mesh.movingSections - (toTheNeck ? 0 : 1); ++i) {
        const double wanted = deformation.tip_s_m + m_scope.beak_m * i / (m_mesh.movingSections - 1);
        const double s = nudged(std::min(std::max(wanted, kNudge), m_length - kNudge)); // held in the canal …
        if (s < last + 0.99 * kNudge || (!toTheNeck && s > end - 0.99 * kNudge))
            continue; // … where those from outside are one
        last = s;
        m_deformed.push_back(circle(s, true));
    }
    std::sort(m_deformed.begin(), m_deformed.end(),
              [](const Section& a, const Section& b) { return a.s < b.s; });
    if (!toTheNeck)
        m_deformed.push_back(endOnRest(end));
}

Vec3 UrethraReferenceGeometry::slopeAt(const Sections& sections, std::size_t section,
                                       std::size_t column) const {
    const auto p = [&](std::size_t i) { return sections[i].points[column]; };
    const std::size_t last = sections.size() - 1;
    if (section == last && sections[last].onRest)
        return sections[last].restSlopes[column];
    if (section == 0)
        return 2.0 * (p(1) - p(0)) / (p(1) - p(0)).norm() - slopeAt(sections, 1, column);
    if (section == last)
        return 2.0 * (p(last) - p(last - 1)) / (p(last) - p(last - 1)).norm() -
               slopeAt(sections, last - 1, column);
    return catmullRom(p(section - 1), p(section), p(section + 1));
}

Vec3 UrethraReferenceGeometry::along(const Sections& sections, std::size_t span, std::size_t column,
                                     double u) const {
    const Vec3 a = sections[span].points[column];
    const Vec3 d = sections[span + 1].points[column];
    const double chord = (d - a).norm();
    return casteljau(a, a + slopeAt(sections, span, column) * chord / 3.0,
                     d - slopeAt(sections, span + 1, column) * chord / 3.0, d, u);
}

Vec3 UrethraReferenceGeometry::around(const Section& section, std::size_t column, double v) const {
    const std::size_t count = section.points.size();
    if (section.onRest)
        return coons(m_rest, section.s,
                     2.0 * kPi * (static_cast<double>(column) + v) / static_cast<double>(count));
    const auto p = [&](std::size_t offset) { return section.points[(column + count + offset - 1) % count]; };
    const double chord = (p(2) - p(1)).norm();
    return casteljau(p(1), p(1) + catmullRom(p(0), p(1), p(2)) * chord / 3.0,
                     p(2) - catmullRom(p(1), p(2), p(3)) * chord / 3.0, p(2), v);
}

Vec3 UrethraReferenceGeometry::coons(const Sections& sections, double s, double angle) const {
    const std::size_t count = sections[0].points.size();
    std::size_t span = 0;
    while (span + 2 < sections.size() && sections[span + 1].s <= s)
        ++span;
    const double u = (s - sections[span].s) / (sections[span + 1].s - sections[span].s);
    const double place = angle / (2.0 * kPi) * static_cast<double>(count);
    const auto column = std::min(static_cast<std::size_t>(place), count - 1);
    const double v = place - static_cast<double>(column);
    const std::size_t next = (column + 1) % count;
    const Vec3 ruledAlong = mix(along(sections, span, column, u), along(sections, span, next, u), v);
    const Vec3 ruledAround = mix(around(sections[span], column, v), around(sections[span + 1], column, v), u);
    const Vec3 corners = mix(mix(sections[span].points[column], sections[span].points[next], v),
                             mix(sections[span + 1].points[column], sections[span + 1].points[next], v), u);
    return ruledAlong + ruledAround - corners;
}

Vec3 UrethraReferenceGeometry::at(double s, double angle) const {
    if (m_deformed.size() > 1 && (s < m_deformed.back().s || !m_deformed.back().onRest))
        return coons(m_deformed, s, angle);
    return coons(m_rest, s, angle);
}

} // namespace chiron::testing
