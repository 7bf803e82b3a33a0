// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/scene/tube_curve.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr int kSteps = 26;         // rings of a part between two grips
constexpr double kPinch = 0.80;    // factor of the radius between the jaws
constexpr double kPinch_m = 0.004; // length of the pinch to either side of the jaws
constexpr double kFlare_m = 0.004; // height over the floor up to which the base is wider
constexpr double kPaleAt = 0.55;   // stretch at which the tube is fully pale

core::Vec3 placeOf(const core::LaparoscopyCues& cues, int i) {
    const auto& p = cues.p_WGrip[static_cast<std::size_t>(i)];
    return {p[0], p[1], p[2]};
}

/// A part between two grips that are fixed, held or ends of the tube; its rest length is l.
struct Part {
    std::size_t first = 0; ///< indices of the two grips in the cues
    std::size_t last = 1;
    core::Vec3 from = core::Vec3::Zero();
    core::Vec3 to = core::Vec3::Zero();
    double rest_m = 0.0;
    double clear_m = 0.0; ///< lowest z of its centre-line
    double viaAt = 0.0;   ///< 0..1: position of a free grip between the two, shifted by `via`; 0: none
    core::Vec3 via = core::Vec3::Zero(); ///< offset of the free grip from the curve
    double stretch() const { return (to - from).norm() / std::max(1e-6, rest_m); }
};

/// A point of a slack part that sags by `sag_m`, downwards as far as the floor allows and sideways otherwise.
core::Vec3 sagged(const Part& part, double sag_m, double t) {
    const core::Vec3 way = part.to - part.from;
    const core::Vec3 line = part.from + t * way;
    const double middle_m = 0.5 * (part.from.z() + part.to.z());
    const double down = sag_m > 1e-9 ? std::clamp((middle_m - part.clear_m) / sag_m, 0.0, 1.0) : 1.0;
    // Sideways relative to the direction of the part; if the part is vertical, towards a fixed side.
    const double length_m = std::max(1e-6, way.norm());
    core::Vec3 side = core::Vec3(-way.y(), way.x(), 0.0) / length_m +
                      std::abs(way.z()) / length_m * core::Vec3(0.8, -0.6, 0.0);
    side = side.norm() > 1e-6 ? core::Vec3(side.normalized()) : core::Vec3(core::Vec3::UnitX());
    const double bow = 4.0 * sag_m * t * (1.0 - t);
    core::Vec3 p =
        line + bow * (std::sqrt(std::max(0.0, 1.0 - down * down)) * side - down * core::Vec3::UnitZ());
    p.z() = std::max(p.z(), std::min(part.clear_m, line.z()));
    return p;
}

/// The curve of a part, bent smoothly through a free grip on it, so that the grip is drawn where it can be
/// taken.
core::Vec3 curveOf(const Part& part, double sag_m, double t) {
    const core::Vec3 p = sagged(part, sag_m, t);
    if (part.viaAt <= 0.0)
        return p;
    const double near = t < part.viaAt ? t / part.viaAt : (1.0 - t) / (1.0 - part.viaAt);
    return p + near * near * (3.0 - 2.0 * near) * part.via;
}

double lengthAt(const Part& part, double sag_m) {
    double length_m = 0.0;
    core::Vec3 before = part.from;
    for (int i = 1; i <= kSteps; ++i) {
        const core::Vec3 p = sagged(part, sag_m, static_cast<double>(i) / kSteps);
        length_m += (p - before).norm();
        before = p;
    }
    return length_m;
}

/// The sag for which the part has its rest length.
double sagOf(const Part& part) {
    if (part.stretch() >= 1.0)
        return 0.0;
    double low = 0.0;
    double high = part.rest_m;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (lengthAt(part, middle) < part.rest_m ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The loose end of a torn tube: from the floor it rises and bends over, from the jaws it hangs down.
core::Vec3 limp(const core::Vec3& from, const core::Vec3& away, bool anchored, double length_m,
                double clear_m, double t) {
    const double along_m = t * length_m;
    if (anchored)
        return from + away * (0.72 * along_m) +
               core::Vec3::UnitZ() * (0.42 * length_m * std::sin(0.85 * core::kPi * t));
    const double room_m = std::max(0.0, from.z() - clear_m);
    const double down_m = std::min(along_m, room_m);
    return from + away * (0.12 * down_m + (along_m - down_m)) - core::Vec3::UnitZ() * down_m;
}

class Maker {
public:
    Maker(const core::LaparoscopyCues& cues, double radius_m, double floor_m)
        : m_cues(cues), m_radius_m(radius_m), m_clear_m(floor_m + radius_m) {
        for (int i = 0; i + 1 < cues.grips;) {
            int next = i + 1;
            while (next + 1 < cues.grips && isFree(next))
                ++next;
            m_parts.push_back(partOf(i, next));
            i = next;
        }
    }

    TubeCurve make() {
        if (!m_cues.tube || m_parts.empty() || !(m_cues.restLength_m > 0.0))
            return {};
        const std::size_t tears = m_cues.torn ? tautest() : m_parts.size();
        TubePiece piece;
        piece.first = m_cues.gripAnchored[0] ? SweepEnd::open : SweepEnd::round;
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            if (i != tears) {
                addPart(piece, i);
                continue;
            }
            addHalf(piece, i, true);
            piece.last = SweepEnd::ragged;
            finish(piece);
            piece = {};
            piece.first = SweepEnd::ragged;
            addHalf(piece, i, false);
        }
        finish(piece);
        return std::move(m_curve);
    }

private:
    bool isFree(int i) const {
        const auto k = static_cast<std::size_t>(i);
        return m_cues.gripHeldBy[k] == 0 && !m_cues.gripAnchored[k];
    }

    Part partOf(int from, int to) const {
        Part part;
        part.first = static_cast<std::size_t>(from);
        part.last = static_cast<std::size_t>(to);
        part.from = placeOf(m_cues, from);
        part.to = placeOf(m_cues, to);
        const double share = m_cues.gripAt[part.last] - m_cues.gripAt[part.first];
        part.rest_m = std::max(1e-4, share * m_cues.restLength_m);
        part.clear_m = m_clear_m;
        if (to == from + 1)
            return part;
        part.viaAt = std::clamp(
            (m_cues.gripAt[part.first + 1] - m_cues.gripAt[part.first]) / std::max(1e-6, share), 0.05, 0.95);
        part.via = placeOf(m_cues, from + 1) - sagged(part, sagOf(part), part.viaAt);
        return part;
    }

    std::size_t tautest() const {
        std::size_t most = 0;
        for (std::size_t i = 1; i < m_parts.size(); ++i)
            if (m_parts[i].stretch() > m_parts[most].stretch())
                most = i;
        return most;
    }

    void addRing(TubePiece& piece, std::size_t i, const core::Vec3& p_W, double t) const {
        const double stretch = m_cues.torn ? 1.0 : std::max(1.0, m_parts[i].stretch());
        TubeRing ring;
        ring.p_W = p_W;
        ring.radius_m = m_radius_m / std::sqrt(stretch);
        const Part& part = m_parts[i];
        ring.share = m_cues.gripAt[part.first] + t * (m_cues.gripAt[part.last] - m_cues.gripAt[part.first]);
        ring.pale = std::clamp((stretch - 1.0) / kPaleAt, 0.0, 1.0);
        piece.rings.push_back(ring);
    }

    void addPart(TubePiece& piece, std::size_t i) const {
        const double sag_m = sagOf(m_parts[i]);
        for (int k = piece.rings.empty() ? 0 : 1; k <= kSteps; ++k) {
            const double t = static_cast<double>(k) / kSteps;
            addRing(piece, i, curveOf(m_parts[i], sag_m, t), t);
        }
    }

    /// Adds one half of the torn part.
    void addHalf(TubePiece& piece, std::size_t i, bool first) const {
        const Part& part = m_parts[i];
        const std::size_t place = first ? part.first : part.last;
        core::Vec3 away = first ? part.from - part.to : part.to - part.from;
        away.z() = 0.0;
        away = away.norm() > 1e-6 ? core::Vec3(away.normalized()) : core::Vec3(0.8, -0.6, 0.0);
        constexpr int kHalf = kSteps / 2;
        for (int k = 0; k <= kHalf; ++k) {
            const double t = static_cast<double>(first ? k : kHalf - k) / kHalf; // counted from the held grip
            addRing(piece, i,
                    limp(first ? part.from : part.to, away, m_cues.gripAnchored[place], 0.5 * part.rest_m,
                         m_clear_m, t),
                    first ? 0.5 * t : 1.0 - 0.5 * t);
        }
    }

    /// Smooths changes of thickness and adds the pinch under the jaws and the foot of the base.
    void finish(TubePiece& piece) {
        std::vector<TubeRing>& rings = piece.rings;
        for (int pass = 0; pass < 3; ++pass) {
            const std::vector<TubeRing> was = rings;
            for (std::size_t k = 1; k + 1 < rings.size(); ++k) {
                rings[k].radius_m =
                    0.25 * was[k - 1].radius_m + 0.5 * was[k].radius_m + 0.25 * was[k + 1].radius_m;
                rings[k].pale = 0.25 * was[k - 1].pale + 0.5 * was[k].pale + 0.25 * was[k + 1].pale;
            }
        }
        for (TubeRing& ring : rings)
            for (int i = 0; i < m_cues.grips; ++i) {
                const auto k = static_cast<std::size_t>(i);
                const double off_m = (ring.p_W - placeOf(m_cues, i)).norm();
                const double near =
                    std::max(0.0, 1.0 - off_m / (m_cues.gripAnchored[k] ? kFlare_m : kPinch_m));
                if (m_cues.gripAnchored[k])
                    ring.radius_m += 0.9 * m_radius_m * near * near;
                else if (m_cues.gripHeldBy[k] != 0)
                    ring.radius_m *= 1.0 - (1.0 - kPinch) * near;
            }
        m_curve.pieces.push_back(std::move(piece));
    }

    const core::LaparoscopyCues& m_cues;
    double m_radius_m;
    double m_clear_m;
    std::vector<Part> m_parts;
    TubeCurve m_curve;
};

} // namespace

TubeCurve TubeCurve::of(const core::LaparoscopyCues& cues, double radius_m, double floor_m) {
    return Maker(cues, radius_m, floor_m).make();
}

std::optional<TubeRing> TubeCurve::at(double share) const {
    const TubeRing* best = nullptr;
    for (const TubePiece& piece : pieces)
        for (const TubeRing& ring : piece.rings)
            if (!best || std::abs(ring.share - share) < std::abs(best->share - share))
                best = &ring;
    return best ? std::optional<TubeRing>(*best) : std::nullopt;
}

double TubeCurve::length_m() const {
    double length_m = 0.0;
    for (const TubePiece& piece : pieces)
        for (std::size_t k = 1; k < piece.rings.size(); ++k)
            length_m += (piece.rings[k].p_W - piece.rings[k - 1].p_W).norm();
    return length_m;
}

} // namespace chiron::scene3d
