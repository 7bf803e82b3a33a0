// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/finger_mesh.h"

#include "desktop/scene3d/parts/sweep.h"

#include <array>

namespace chiron::scene3d {

namespace {

const std::array kLine{SweepRing{{0.0, 5.0, 7.4}, 6.0, 1.0},     SweepRing{{0.0, 2.0, 7.7}, 7.3, 1.0},
                       SweepRing{{0.0, -3.0, 8.6}, 8.1, 1.0},    SweepRing{{0.0, -11.0, 11.2}, 8.3, 1.0},
                       SweepRing{{0.0, -18.0, 14.2}, 8.2, 0.96}, SweepRing{{0.0, -22.0, 16.3}, 8.7, 0.84},
                       SweepRing{{0.0, -26.0, 18.8}, 8.5, 0.97}, SweepRing{{0.0, -34.0, 24.6}, 8.6, 1.0},
                       SweepRing{{0.0, -43.0, 31.8}, 9.1, 0.95}, SweepRing{{0.0, -53.0, 38.4}, 9.6, 1.0},
                       SweepRing{{0.0, -65.0, 44.6}, 10.2, 1.0}, SweepRing{{0.0, -76.0, 47.5}, 10.4, 0.9}};

/// The finger's centre-line at this y (mm), piecewise linear.
SweepRing atY(double y_mm) {
    for (std::size_t i = 0; i + 1 < kLine.size(); ++i) {
        const SweepRing& a = kLine[i];
        const SweepRing& b = kLine[i + 1];
        if (y_mm > a.p_mm.y() || y_mm < b.p_mm.y())
            continue;
        const double t = (a.p_mm.y() - y_mm) / (a.p_mm.y() - b.p_mm.y());
        return {a.p_mm + t * (b.p_mm - a.p_mm), a.radius_mm + t * (b.radius_mm - a.radius_mm), 1.0};
    }
    return kLine.back();
}

void addBand(TriangleMesh& mesh, double fromY_mm, double toY_mm, double proud_mm) {
    std::vector<SweepRing> rings;
    constexpr int kRows = 4;
    for (int i = 0; i <= kRows; ++i) {
        SweepRing ring = atY(fromY_mm + (toY_mm - fromY_mm) * i / kRows);
        ring.radius_mm += i == 0 || i == kRows ? -0.3 : proud_mm;
        rings.push_back(ring);
    }
    addSweep(mesh, rings, SweepEnd::open, SweepEnd::open, 24);
}

} // namespace

TriangleMesh fingerMesh() {
    TriangleMesh mesh;
    addSweep(mesh, {kLine.begin(), kLine.end()}, SweepEnd::round, SweepEnd::round, 24);
    return mesh;
}

TriangleMesh fingerBands(int count) {
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i)
        addBand(mesh, -10.5 - 4.5 * i, -13.0 - 4.5 * i, 0.45);
    return mesh;
}

TriangleMesh fingerCollar() {
    TriangleMesh mesh;
    addBand(mesh, -30.5, -33.5, 1.6);
    return mesh;
}

} // namespace chiron::scene3d
