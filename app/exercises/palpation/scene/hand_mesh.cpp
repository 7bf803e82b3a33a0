// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/hand_mesh.h"

#include "core/units.h"
#include "desktop/scene3d/parts/loft.h"
#include "desktop/scene3d/parts/sweep.h"

#include <array>
#include <cmath>
#include <utility>

namespace chiron::scene3d {

namespace {

/// A cross-section of hand and wrist: its distance from the knuckles towards the elbow, its lateral offset,
/// half its width and half its thickness.
struct HandSection {
    double along_mm, across_mm, wide_mm, thick_mm;
};
constexpr std::array kHand{HandSection{-9.0, 28.0, 30.0, 3.0},   HandSection{-6.0, 28.0, 37.0, 8.0},
                           HandSection{2.0, 28.0, 41.0, 11.0},   HandSection{22.0, 27.0, 42.0, 13.5},
                           HandSection{50.0, 26.0, 41.0, 15.0},  HandSection{76.0, 25.0, 34.0, 16.0},
                           HandSection{94.0, 24.0, 28.0, 17.5},  HandSection{116.0, 24.0, 28.5, 20.0},
                           HandSection{150.0, 24.0, 33.0, 25.0}, HandSection{154.0, 24.0, 34.5, 26.5},
                           HandSection{158.0, 24.0, 34.5, 26.5}, HandSection{162.0, 24.0, 32.0, 24.0}};
constexpr double kSlope_rad = 22.0 * core::kPi / 180.0; ///< the hand rises towards the wrist
constexpr double kKnuckleY_mm = -72.0;                  ///< of the index finger, where the finger of
                                                        ///< finger_mesh.cpp ends
constexpr double kKnuckleZ_mm = 46.0;
constexpr int kSides = 36;

/// A hand's outline is flatter than an ellipse.
Section outline(const HandSection& at) {
    Section section;
    for (int i = 0; i < kSides; ++i) {
        const double angle = 2.0 * core::kPi * i / kSides;
        const auto squared = [](double v) { return std::copysign(std::pow(std::abs(v), 0.8), v); };
        section.push_back({at.across_mm + at.wide_mm * squared(std::cos(angle)),
                           at.thick_mm * squared(std::sin(angle)), at.along_mm});
    }
    return section;
}

/// Rotates a body that stands on its knuckles (z towards the elbow) into the finger's frame.
void layDown(TriangleMesh& mesh, std::size_t first) {
    const double s = std::sin(kSlope_rad), c = std::cos(kSlope_rad);
    const auto turn = [&](float(&v)[3], double y0, double z0) {
        const double y = v[1], z = v[2];
        v[1] = static_cast<float>(y0 + s * y - c * z);
        v[2] = static_cast<float>(z0 + c * y + s * z);
    };
    for (std::size_t i = first; i < mesh.vertices.size(); ++i) {
        turn(mesh.vertices[i].position_mm, kKnuckleY_mm, kKnuckleZ_mm);
        turn(mesh.vertices[i].normal, 0.0, 0.0);
        mesh.vertices[i].texture[0] = mesh.vertices[i].texture[1] = 0.0F;
    }
}

/// Adds an unused finger, folded so that it clears the tissue.
void addFolded(TriangleMesh& mesh, double x_mm, double knuckleY_mm, double size) {
    const auto at = [&](double y_mm, double z_mm, double radius_mm) {
        return SweepRing{
            {x_mm, knuckleY_mm + size * y_mm, kKnuckleZ_mm + size * z_mm}, size * radius_mm, 1.0};
    };
    addSweep(mesh,
             {at(-6.0, 2.0, 10.0), at(5.0, 0.0, 9.8), at(19.0, -6.0, 9.0), at(29.0, -14.0, 8.6),
              at(34.0, -24.0, 7.8)},
             SweepEnd::round, SweepEnd::round, 20);
}

void addThumb(TriangleMesh& mesh) {
    addSweep(mesh,
             {SweepRing{{8.0, -128.0, 60.0}, 13.0, 1.0}, SweepRing{{-8.0, -108.0, 48.0}, 13.0, 1.0},
              SweepRing{{-20.0, -86.0, 38.0}, 10.5, 1.0}, SweepRing{{-25.0, -68.0, 32.0}, 9.6, 1.0},
              SweepRing{{-24.0, -52.0, 29.0}, 9.2, 1.0}, SweepRing{{-20.0, -38.0, 27.0}, 8.2, 1.0}},
             SweepEnd::round, SweepEnd::round, 20);
}

void mirror(TriangleMesh& mesh) {
    for (MeshVertex& vertex : mesh.vertices) {
        vertex.position_mm[0] = -vertex.position_mm[0];
        vertex.normal[0] = -vertex.normal[0];
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        // Mirroring reversed the orientation of the triangles; this restores it.
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
}

} // namespace

TriangleMesh handMesh(int used, bool left) {
    TriangleMesh mesh;
    std::vector<Section> sections;
    for (const HandSection& at : kHand)
        sections.push_back(outline(at));
    addLoft(mesh, sections, 0.0);
    layDown(mesh, 0);
    struct Folded {
        double x_mm, y_mm, size;
    };
    constexpr std::array<Folded, 3> kFolded{{{19.5, -72.0, 1.0}, {38.5, -76.0, 0.95}, {56.0, -83.0, 0.82}}};
    for (std::size_t i = static_cast<std::size_t>(used > 1 ? 1 : 0); i < kFolded.size(); ++i)
        addFolded(mesh, kFolded[i].x_mm, kFolded[i].y_mm, kFolded[i].size);
    addThumb(mesh);
    if (left)
        mirror(mesh);
    return mesh;
}

} // namespace chiron::scene3d
