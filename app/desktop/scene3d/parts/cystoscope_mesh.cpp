// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/cystoscope_mesh.h"

#include "desktop/scene3d/parts/loft.h"

namespace chiron::scene3d {

TriangleMesh cystoscopeMesh(double radius_mm) {
    constexpr double kSheath_mm = 220.0;
    constexpr int kSides = 28;
    const double r = radius_mm;
    TriangleMesh mesh;
    addTurned(mesh, {{0.0, 0.62 * r}, {0.02, 0.80 * r}, {0.8, 0.97 * r}, {1.6, r}, {kSheath_mm, r}}, 1.0,
              kSides);
    for (double mark = 50.0; mark < kSheath_mm; mark += 50.0) // depth marks
        addTurned(mesh, {{mark - 0.6, 1.012 * r}, {mark + 0.6, 1.012 * r}}, 0.0, kSides);
    addTurned(mesh,
              {{kSheath_mm, 1.7 * r},
               {kSheath_mm + 3.0, 2.3 * r},
               {kSheath_mm + 24.0, 2.3 * r},
               {kSheath_mm + 30.0, 1.5 * r},
               {kSheath_mm + 70.0, 1.5 * r},
               {kSheath_mm + 74.0, 4.2 * r},
               {kSheath_mm + 86.0, 4.4 * r}},
              0.0, kSides);
    return mesh;
}

} // namespace chiron::scene3d
