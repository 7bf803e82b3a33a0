// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/geometry/mesh/triangle_mesh.h"

#include <memory>

namespace chiron::bench {

/// Bullet as a haptic god-object: the proxy goes towards the tool by rays against a btBvhTriangleMeshShape; a
/// ray that hits gives a plane along which the goal is projected, three at most (Zilles & Salisbury 1995). In
/// millimetres, single precision, as Debian builds it. Without Bullet, available() is false.
class BulletGodObject {
public:
    /// `bare`: rays against the shape itself (its quickest way); else through btCollisionWorld::rayTest.
    BulletGodObject(const simulation::TriangleMesh& mesh, bool bare);
    ~BulletGodObject();
    BulletGodObject(const BulletGodObject&) = delete;
    BulletGodObject& operator=(const BulletGodObject&) = delete;
    static bool available();
    void start(const core::Vec3& p);
    core::Vec3 force(const core::Vec3& p, double stiffness_N_per_m); ///< of a point, N

private:
    struct World;
    std::unique_ptr<World> m_world;
};

/// Embree's point query: the nearest triangle every tick, by its tree, begun with the radius that the last
/// tick left. High build quality.
class EmbreeNearest {
public:
    explicit EmbreeNearest(const simulation::TriangleMesh& mesh);
    ~EmbreeNearest();
    EmbreeNearest(const EmbreeNearest&) = delete;
    EmbreeNearest& operator=(const EmbreeNearest&) = delete;
    static bool available();
    core::Vec3 nearest(const core::Vec3& p);

private:
    struct Scene;
    std::unique_ptr<Scene> m_scene;
};

} // namespace chiron::bench
