// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/mesh_peers.h"

#include "simulation/geometry/mesh/mesh_place.h"

#include <vector>

#ifdef CHIRON_HAS_BULLET
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>
#endif
#ifdef CHIRON_HAS_EMBREE
#include <embree3/rtcore.h>
#endif

namespace chiron::bench {

using core::Vec3;

#ifdef CHIRON_HAS_BULLET

namespace {
constexpr double kMm = 1e3;
constexpr float kSkin_mm = 1e-3F; // the proxy stays so far above the surface, or the next ray starts inside

btVector3 toBullet(const Vec3& p) {
    return {static_cast<btScalar>(kMm * p.x()), static_cast<btScalar>(kMm * p.y()),
            static_cast<btScalar>(kMm * p.z())};
}

struct NearestHit : btTriangleRaycastCallback {
    NearestHit(const btVector3& from, const btVector3& to)
        : btTriangleRaycastCallback(from, to, kF_FilterBackfaces) {}
    btScalar reportHit(const btVector3& hitNormal, btScalar fraction, int, int) override {
        normal = hitNormal;
        return fraction;
    }
    btVector3 normal{0, 0, 0};
};
} // namespace

struct BulletGodObject::World {
    std::vector<btScalar> vertices;
    std::vector<int> indices;
    std::unique_ptr<btTriangleIndexVertexArray> array;
    std::unique_ptr<btBvhTriangleMeshShape> shape;
    btCollisionObject object;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btCollisionWorld world{&dispatcher, &broadphase, &configuration};
    btVector3 proxy{0, 0, 0};
    bool bare = false;

    bool ray(const btVector3& from, const btVector3& to, btVector3& normal, btScalar& fraction) {
        if (bare) {
            NearestHit hit(from, to);
            shape->performRaycast(&hit, from, to);
            normal = hit.normal;
            fraction = hit.m_hitFraction;
            return hit.m_hitFraction < 1;
        }
        btCollisionWorld::ClosestRayResultCallback hit(from, to);
        hit.m_flags |= btTriangleRaycastCallback::kF_FilterBackfaces;
        world.rayTest(from, to, hit);
        normal = hit.m_hitNormalWorld;
        fraction = hit.m_closestHitFraction;
        return hit.hasHit();
    }
};

BulletGodObject::BulletGodObject(const simulation::TriangleMesh& mesh, bool bare)
    : m_world(std::make_unique<World>()) {
    World& w = *m_world;
    w.bare = bare;
    for (const auto& v : mesh.vertices()) {
        const btVector3 p = toBullet(v.position);
        w.vertices.insert(w.vertices.end(), {p.x(), p.y(), p.z()});
    }
    for (const auto& t : mesh.triangles())
        for (const std::uint32_t v : t.vertex)
            w.indices.push_back(static_cast<int>(v));
    w.array = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(mesh.triangles().size()), w.indices.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(mesh.vertices().size()), w.vertices.data(), static_cast<int>(3 * sizeof(btScalar)));
    w.shape = std::make_unique<btBvhTriangleMeshShape>(w.array.get(), true);
    w.object.setCollisionShape(w.shape.get());
    w.world.addCollisionObject(&w.object);
}

BulletGodObject::~BulletGodObject() {
    if (m_world)
        m_world->world.removeCollisionObject(&m_world->object);
}

bool BulletGodObject::available() {
    return true;
}

void BulletGodObject::start(const Vec3& p) {
    m_world->proxy = toBullet(p);
}

Vec3 BulletGodObject::force(const Vec3& p, double stiffness_N_per_m) {
    World& w = *m_world;
    const btVector3 device = toBullet(p);
    btVector3 goal = device, normals[3];
    int planes = 0;
    for (; planes < 3; ++planes) {
        btScalar fraction = 1;
        btVector3 normal;
        if (!w.ray(w.proxy, goal, normal, fraction)) {
            w.proxy = goal;
            break;
        }
        normal.normalize();
        const btVector3 hit = w.proxy.lerp(goal, fraction) + kSkin_mm * normal;
        w.proxy = hit;
        normals[planes] = normal;
        if (planes == 0) {
            goal = device - normal * normal.dot(device - hit);
        } else if (planes == 1) {
            btVector3 along = normals[0].cross(normals[1]);
            const btScalar length = along.length();
            goal = length > 1e-6F ? hit + along * (along.dot(device - hit) / (length * length)) : hit;
        }
    }
    const btVector3 stretch = w.proxy - device;
    return stiffness_N_per_m / kMm *
           Vec3(static_cast<double>(stretch.x()), static_cast<double>(stretch.y()),
                static_cast<double>(stretch.z()));
}

#else

struct BulletGodObject::World {};
BulletGodObject::BulletGodObject(const simulation::TriangleMesh&, bool) {}
BulletGodObject::~BulletGodObject() = default;
bool BulletGodObject::available() {
    return false;
}
void BulletGodObject::start(const Vec3&) {}
Vec3 BulletGodObject::force(const Vec3&, double) {
    return Vec3::Zero();
}

#endif

#ifdef CHIRON_HAS_EMBREE

struct EmbreeNearest::Scene {
    struct Best {
        const simulation::TriangleMesh* mesh = nullptr;
        Vec3 p, point;
        double distance2 = 0.0;
    };
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    Best best;
    Vec3 last = Vec3::Zero();
    double distance = -1.0;

    static bool look(RTCPointQueryFunctionArguments* arguments) {
        auto* best = static_cast<Best*>(arguments->userPtr);
        const simulation::SurfaceTriangle& t = best->mesh->triangle(arguments->primID);
        const Vec3 &a = best->mesh->position(t.vertex[0]), &b = best->mesh->position(t.vertex[1]),
                   &c = best->mesh->position(t.vertex[2]);
        const Vec3 w = simulation::nearestWeights(a, b, c, best->p);
        const Vec3 point = w[0] * a + w[1] * b + w[2] * c;
        const double d2 = (point - best->p).squaredNorm();
        if (d2 >= best->distance2)
            return false;
        best->distance2 = d2;
        best->point = point;
        arguments->query->radius = static_cast<float>(std::sqrt(d2) * 1.000001);
        return true;
    }
};

EmbreeNearest::EmbreeNearest(const simulation::TriangleMesh& mesh) : m_scene(std::make_unique<Scene>()) {
    Scene& s = *m_scene;
    s.device = rtcNewDevice("threads=1");
    s.scene = rtcNewScene(s.device);
    rtcSetSceneBuildQuality(s.scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices().size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles().size()));
    for (const auto& v : mesh.vertices())
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            *vertices++ = static_cast<float>(v.position[axis]);
    for (const auto& t : mesh.triangles())
        for (const std::uint32_t v : t.vertex)
            *indices++ = v;
    rtcSetGeometryPointQueryFunction(geometry, &Scene::look);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(s.scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(s.scene);
    s.best.mesh = &mesh;
}

EmbreeNearest::~EmbreeNearest() {
    rtcReleaseScene(m_scene->scene);
    rtcReleaseDevice(m_scene->device);
}

bool EmbreeNearest::available() {
    return true;
}

Vec3 EmbreeNearest::nearest(const Vec3& p) {
    Scene& s = *m_scene;
    const double within = s.distance < 0.0 ? 1e3 : 1.00001 * (s.distance + (p - s.last).norm()) + 1e-6;
    s.best.p = p;
    s.best.distance2 = within * within;
    RTCPointQuery query{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), 0.0F,
                        static_cast<float>(within)};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(s.scene, &query, &context, nullptr, &s.best);
    s.distance = std::sqrt(s.best.distance2);
    s.last = p;
    return s.best.point;
}

#else

struct EmbreeNearest::Scene {};
EmbreeNearest::EmbreeNearest(const simulation::TriangleMesh&) {}
EmbreeNearest::~EmbreeNearest() = default;
bool EmbreeNearest::available() {
    return false;
}
Vec3 EmbreeNearest::nearest(const Vec3&) {
    return Vec3::Zero();
}

#endif

} // namespace chiron::bench
