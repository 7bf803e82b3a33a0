// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/flat_shapes.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr int kRound = 96;
constexpr float kInFront = -0.998F;

std::uint32_t add(TriangleMesh& mesh, double x, double y, float z = 0.0F) {
    MeshVertex vertex;
    vertex.position_mm[0] = float(x);
    vertex.position_mm[1] = float(y);
    vertex.position_mm[2] = z;
    vertex.texture[0] = float(0.5 + 0.5 * x);
    vertex.texture[1] = float(0.5 + 0.5 * y);
    mesh.vertices.push_back(vertex);
    return std::uint32_t(mesh.vertices.size() - 1);
}

void addTriangle(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Adds a straight bar of this half width.
void addBar(TriangleMesh& mesh, double x0, double y0, double x1, double y1, double half) {
    const double length = std::hypot(x1 - x0, y1 - y0);
    const double dx = -(y1 - y0) / length * half;
    const double dy = (x1 - x0) / length * half;
    const std::uint32_t a = add(mesh, x0 - dx, y0 - dy);
    const std::uint32_t b = add(mesh, x1 - dx, y1 - dy);
    const std::uint32_t c = add(mesh, x1 + dx, y1 + dy);
    const std::uint32_t d = add(mesh, x0 + dx, y0 + dy);
    addTriangle(mesh, a, b, c);
    addTriangle(mesh, a, c, d);
}

} // namespace

TriangleMesh roundPicture() {
    TriangleMesh mesh;
    const std::uint32_t middle = add(mesh, 0.0, 0.0);
    for (int i = 0; i <= kRound; ++i) {
        const double angle = 2.0 * core::kPi * i / kRound;
        const std::uint32_t next = add(mesh, std::cos(angle), std::sin(angle));
        if (i > 0)
            addTriangle(mesh, middle, next - 1, next);
    }
    return mesh;
}

TriangleMesh roundWindow() {
    TriangleMesh mesh;
    for (int i = 0; i <= kRound; ++i) {
        const double angle = 2.0 * core::kPi * i / kRound;
        const double x = std::cos(angle), y = std::sin(angle);
        const double out = 1.001 / std::max(std::abs(x), std::abs(y));
        const std::uint32_t inner = add(mesh, 0.9985 * x, 0.9985 * y, kInFront);
        add(mesh, out * x, out * y, kInFront);
        if (i == 0)
            continue;
        addTriangle(mesh, inner - 2, inner - 1, inner + 1);
        addTriangle(mesh, inner - 2, inner + 1, inner);
    }
    return mesh;
}

TriangleMesh flatSquare(double depth) {
    TriangleMesh mesh;
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
        add(mesh, x, y, float(depth));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TriangleMesh flatRing(double radius, double half) {
    TriangleMesh mesh;
    for (int i = 0; i <= kRound; ++i) {
        const double angle = 2.0 * core::kPi * i / kRound;
        const double x = std::sin(angle), y = std::cos(angle); // from the top, clockwise
        const std::uint32_t inner = add(mesh, (radius - half) * x, (radius - half) * y);
        add(mesh, (radius + half) * x, (radius + half) * y);
        mesh.vertices[inner].texture[0] = mesh.vertices[inner + 1].texture[0] = float(i) / kRound;
        if (i == 0)
            continue;
        addTriangle(mesh, inner - 2, inner - 1, inner + 1);
        addTriangle(mesh, inner - 2, inner + 1, inner);
    }
    return mesh;
}

TriangleMesh flatBar(double half) {
    TriangleMesh mesh;
    addBar(mesh, 0.0, 0.0, 1.0, 0.0, half);
    return mesh;
}

TriangleMesh flatHead(double half) {
    TriangleMesh mesh;
    addTriangle(mesh, add(mesh, 0.0, -half), add(mesh, 1.0, 0.0), add(mesh, 0.0, half));
    return mesh;
}

TriangleMesh flatTick(double half) {
    TriangleMesh mesh;
    addBar(mesh, -0.60, 0.05, -0.12, -0.48, half);
    addBar(mesh, -0.20, -0.52, 0.68, 0.56, half);
    return mesh;
}

} // namespace chiron::scene3d
