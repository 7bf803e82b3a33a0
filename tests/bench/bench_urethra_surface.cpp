// SPDX-License-Identifier: GPL-3.0-or-later
// Positions and normals of P1's urethra surface (n = 17, w = 26, 8 × 8 a patch: 25,728 vertices) beside
// writing as many bytes (memset) and beside OpenSubdiv's limit stencils over the same points; and what a
// moving tip costs. Each in turn.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "bench/limit_stencils.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"
#include "simulation/geometry/urethra/urethra_patch_kernel.h"
#include "simulation/geometry/urethra/urethra_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace chiron;
using namespace chiron::bench;

namespace {

constexpr int kRepeats = 301;
constexpr int kColumns = 16;
constexpr int kSections = 26;
constexpr int kPerPatch = 8;
constexpr std::size_t kRing = kColumns * kPerPatch;
constexpr std::size_t kVertices = ((kSections - 1) * kPerPatch + 1) * kRing;
constexpr double kMostMemsets = 7.0;
constexpr double kLeastStencils = 30.0;

/// The resting surface's own rings and nothing else: handles are made anew, then every patch is tessellated.
class Whole {
public:
    Whole() : m_kernel(kColumns, kPerPatch), m_out(6 * kVertices) {
        const simulation::UrethraAnatomy anatomy;
        const simulation::UrethraCentreline line(anatomy);
        for (int i = 0; i < kSections; ++i) {
            m_at.push_back(line.atZ(anatomy.zEnd_m * i / (kSections - 1)));
            m_sections.push_back({m_at.back().s_m, anatomy.radius_m, 0.0, 0.0, -1, 0.0});
        }
        m_curves.setSections(kSections);
    }

    void make() {
        for (int i = 0; i < kSections; ++i)
            m_curves.placeCircle(i, m_sections[static_cast<std::size_t>(i)],
                                 m_at[static_cast<std::size_t>(i)]);
        m_curves.fitAlong(0, false);
        tessellate();
    }

    void tessellate() {
        m_kernel.forget();
        std::size_t ring = 0;
        for (int span = 0; span + 1 < kSections; ++span) {
            m_kernel.load(m_curves, span);
            m_kernel.firstRing(span > 0, planes(ring++));
            for (int q = 1; q < kPerPatch; ++q)
                m_kernel.innerRing(static_cast<double>(q) / kPerPatch, planes(ring++));
            m_kernel.keepEnd();
        }
        m_kernel.lastRing(planes(ring));
    }

    const std::vector<float>& out() const { return m_out; }

    std::vector<float> controlPoints() const {
        std::vector<float> points;
        for (int i = 0; i < kSections; ++i)
            for (int j = 0; j < kColumns; ++j)
                for (const double x : m_curves.vector(i, simulation::UrethraCurves::kPoint, j))
                    points.push_back(static_cast<float>(x));
        return points;
    }

private:
    simulation::RingPlanes planes(std::size_t ring) {
        simulation::RingPlanes planes{};
        for (std::size_t i = 0; i < planes.size(); ++i)
            planes[i] = m_out.data() + i * kVertices + ring * kRing;
        return planes;
    }

    simulation::UrethraCurves m_curves{kColumns, kSections};
    simulation::UrethraPatchKernel m_kernel;
    std::vector<simulation::CentrelinePoint> m_at;
    std::vector<simulation::UrethraSection> m_sections;
    std::vector<float> m_out;
};

/// Largest distance of points from the exact tube.
template <class Point> double tubeError(std::size_t count, Point&& point) {
    const simulation::UrethraAnatomy anatomy;
    const simulation::UrethraCentreline line(anatomy);
    double worst = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto foot = line.foot(point(i));
        worst = std::max(worst, std::abs(std::hypot(foot.ex_m, foot.en_m) - anatomy.radius_m));
    }
    return worst;
}

BenchRow row(const char* work, const char* peer, const std::vector<double>& peers,
             const std::vector<double>& ours) {
    BenchRow made;
    made.work = work;
    made.peer = peer;
    made.unit = "us";
    if (!peers.empty())
        made.peerMedian = median(peers) * 1e6;
    made.oursMedian = median(ours) * 1e6;
    made.p99 = percentile(ours, 0.99) * 1e6;
    return made;
}

void addWhole(std::vector<BenchRow>& rows) {
    Whole whole;
    whole.make();
    LimitStencils stencils(kSections, kColumns, kPerPatch);
    const std::vector<float> control = whole.controlPoints();
    std::vector<float> target(6 * kVertices);
    std::vector<double> set, patches, all, peer;
    for (int i = 0; i < kRepeats; ++i) {
        set.push_back(cpuSeconds([&] {
            std::memset(target.data(), i, target.size() * sizeof(float));
            asm volatile("" ::"r"(target.data()) : "memory");
        }));
        patches.push_back(cpuSeconds([&] { whole.tessellate(); }));
        all.push_back(cpuSeconds([&] { whole.make(); }));
        if (LimitStencils::available() && i % 10 == 0)
            peer.push_back(cpuSeconds([&] { stencils.evaluate(control); }));
    }
    const auto& out = whole.out();
    const double error = tubeError(kVertices, [&](std::size_t i) {
        return core::Vec3(out[i], out[kVertices + i], out[2 * kVertices + i]);
    });
    rows.push_back(row("25,728 vertices, sections and handles included", "memset of the output", set, all));
    rows.back().goal = "at most 7 times memset";
    rows.back().reached = verdict(median(all) <= kMostMemsets * median(set));
    rows.push_back(row("the same, patches alone", "memset of the output", set, patches));
    rows.push_back(
        row("25,728 vertices, sections and handles included", "OpenSubdiv limit stencils", peer, all));
    rows.back().goal = ">= 30";
    if (LimitStencils::available()) {
        const auto points = stencils.points();
        const double theirs = tubeError(points.size() / 3, [&](std::size_t i) {
            return core::Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
        });
        rows.back().agreement =
            text("from the tube: ours %.1f um, theirs %.0f um", error * 1e6, theirs * 1e6);
        rows.back().reached = verdict(median(peer) >= kLeastStencils * median(all));
    } else {
        rows.back().reached = verdict(std::nullopt);
    }
}

void addMovingTip(std::vector<BenchRow>& rows, const char* work, double offset_m) {
    simulation::UrethraSurface surface({}, {}, {});
    std::vector<double> updates, rebuilds;
    std::size_t vertices = 0;
    for (int i = 0; i < kRepeats; ++i) {
        const simulation::UrethraDeformation tip{true, 0.040 + 1e-4 * i, offset_m * std::sin(0.1 * i),
                                                 offset_m * std::cos(0.1 * i)};
        updates.push_back(cpuSeconds([&] {
            for (const simulation::VertexRange& range : surface.update(tip))
                vertices += range.count;
        }));
        rebuilds.push_back(cpuSeconds([&] { surface.rebuild(tip); }));
        surface.update(tip);
    }
    rows.push_back(row(work, "the whole surface anew", rebuilds, updates));
    rows.back().agreement =
        text("bit for bit; %zu of %zu vertices", vertices / kRepeats, surface.vertexCount());
}

} // namespace

int main() {
    printHeading("urethra surface");
    std::vector<BenchRow> rows;
    addWhole(rows);
    addMovingTip(rows, "tip moves 0.1 mm along the canal", 0.0);
    addMovingTip(rows, "tip moves, 1 mm off the centre-line", 0.001);
    printTable(rows);
    return 0;
}
