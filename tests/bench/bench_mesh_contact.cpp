// SPDX-License-Identifier: GPL-3.0-or-later
// What contact with a mesh costs: a 1 mm tool on a bumpy organ along a recorded path, beside Bullet's rays (a
// god-object) and Embree's point query, in turn; whether the cost grows with the mesh; and how far any tick
// is from looking at every triangle.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "bench/mesh_peers.h"
#include "core/clock.h"
#include "core/fp_environment.h"
#include "core/random.h"
#include "realtime/tick_guard.h"
#include "simulation/geometry/mesh/mesh_contact.h"
#include "unit/simulation/mesh/mesh_shapes.h"

#include <cmath>
#include <cstdio>

using namespace chiron;
using namespace chiron::bench;
using namespace chiron::simulation;
using core::Vec3;

namespace {

constexpr int kRepeats = 9;
constexpr int kTicks = 20'000;
constexpr double kRadius_m = 0.001;
constexpr double kChai3d_ns = 42'800.0; // CHAI3D 3.3, dynamic proxy, published in speed.md; not measured here

ObjectAttributes plain() {
    ObjectAttributes attributes;
    attributes.damping_Ns_per_m = 0.0;
    return attributes;
}

struct Recorded {
    std::vector<Vec3> tool;  ///< the centre of the tip
    std::vector<Vec3> point; ///< its lowest place: what a point must do to touch alike
};

/// The default hand (0.45 kg with the device, 300 N/m, 6.5 N·s/m; models.md §4) wanders over the organ at 20
/// to 60 mm/s, wants to be up to 6 mm inside, now and then lifts, trembles at 9 Hz, and meets the organ: its
/// places, once a millisecond.
Recorded record(const TriangleMesh& mesh) {
    const MeshContact contact(plain(), kRadius_m);
    MeshContactState state;
    Recorded out;
    Vec3 x(0.0, 0.0, 0.030), v = Vec3::Zero(), held = Vec3::Zero();
    core::Random random(17);
    for (int n = 0; n < kTicks; ++n) {
        const double t = 0.001 * n, theta = 1.57 - 1.3 * std::cos(0.9 * t),
                     phi = 1.3 * t + 0.5 * std::sin(2.3 * t);
        const Vec3 axes(0.040, 0.030, 0.025),
            on = Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta))
                     .cwiseProduct(axes);
        const Vec3 up = on.cwiseQuotient(axes.cwiseProduct(axes)).normalized();
        const double inside = 0.0025 + 0.0035 * std::sin(2.9 * t);
        const Vec3 wanted =
            on + (kRadius_m - inside) * up +
            1e-4 * Vec3(std::sin(56.0 * t), std::sin(57.0 * t + 1.0), std::sin(55.0 * t + 2.0));
        for (int i = 0; i < 8; ++i) {
            v += 0.000125 * (300.0 * (wanted - x) - 6.5 * v + held) / 0.45;
            x += 0.000125 * v;
        }
        const MeshResponse now = contact.respond(mesh, x, v, static_cast<std::uint64_t>(n), state);
        held = now.contact.force;
        out.tool.push_back(x);
        out.point.push_back(x - kRadius_m * (now.foot.within() ? now.foot.normal : up));
    }
    return out;
}

/// CPU time of one tick over the path, ns.
template <class Tick> double nsEach(const std::vector<Vec3>& path, Tick&& tick) {
    double sum = 0.0;
    const double spent_s = cpuSeconds([&] {
        for (const Vec3& p : path)
            sum += tick(p);
    });
    volatile double sink = sum;
    (void)sink;
    return 1e9 * spent_s / static_cast<double>(path.size());
}

double contactOnce(const MeshContact& contact, const TriangleMesh& mesh, const std::vector<Vec3>& path) {
    MeshContactState state;
    std::uint64_t n = 0;
    return nsEach(path, [&](const Vec3& p) {
        return contact.respond(mesh, p, Vec3::Zero(), n++, state).contact.force.x();
    });
}

/// The largest distance (N) of any tick's force from that of the nearest place of all triangles, and how many
/// ticks touch.
std::pair<double, int> agreement(const MeshContact& contact, const TriangleMesh& mesh,
                                 const std::vector<Vec3>& path) {
    simulation::testing::BruteForce brute(mesh);
    MeshContactState state;
    double worst = 0.0;
    int touching = 0;
    std::uint64_t n = 0;
    for (const Vec3& p : path) {
        const MeshResponse mine = contact.respond(mesh, p, Vec3::Zero(), n++, state);
        const MeshPlace place = brute.nearest(p);
        const Vec3 way = pointAt(mesh, place) - p;
        const double side = way.dot(pseudoNormal(mesh, place)) > 0.0 ? 1.0 : -1.0,
                     depth = side * way.norm() + kRadius_m;
        const Vec3 theirs = depth > 0.0 && way.norm() > 1e-6
                                ? Vec3(500.0 * depth * side * way.normalized())
                                : Vec3(500.0 * std::max(0.0, depth) * mine.contact.normal);
        worst = std::max(worst, (mine.contact.force - theirs).norm());
        touching += mine.contact.inContact ? 1 : 0;
    }
    return {worst, touching};
}

void againstPeers(std::vector<BenchRow>& rows) {
    const TriangleMesh mesh = *makeMesh(simulation::testing::bumpyOrgan());
    const Recorded path = record(mesh);
    const MeshContact contact(plain(), kRadius_m);
    BulletGodObject world(mesh, false), bare(mesh, true);
    EmbreeNearest embree(mesh);
    std::vector<double> ours, bullet, bulletBare, embrees, single;
    tests::resetForbiddenCounts();
    for (int r = 0; r < kRepeats; ++r) {
        if (BulletGodObject::available()) {
            world.start(path.point.front());
            bullet.push_back(nsEach(path.point, [&](const Vec3& p) { return world.force(p, 500.0).x(); }));
            bare.start(path.point.front());
            bulletBare.push_back(nsEach(path.point, [&](const Vec3& p) { return bare.force(p, 500.0).x(); }));
        }
        if (EmbreeNearest::available())
            embrees.push_back(nsEach(path.tool, [&](const Vec3& p) { return embree.nearest(p).x(); }));
        double spent = 0.0;
        {
            const tests::TickGuard guard;
            spent = contactOnce(contact, mesh, path.tool);
        }
        ours.push_back(spent);
    }
    const std::uint64_t allocations = tests::forbiddenCounts().of(tests::Forbidden::allocate);
    MeshContactState state;
    for (std::size_t n = 0; n < path.tool.size(); ++n) {
        const std::int64_t start_ns = core::monotonicNow_ns();
        const MeshResponse now = contact.respond(mesh, path.tool[n], Vec3::Zero(), n, state);
        single.push_back(static_cast<double>(core::monotonicNow_ns() - start_ns) + 0.0 * now.contact.depth_m);
    }
    const auto [worst, touching] = agreement(contact, mesh, path.tool);
    BenchRow row{.work = "50,000 triangles, bumpy, 1 mm tool"};
    row.oursMedian = median(ours);
    row.p99 = percentile(single, 0.99);
    row.p999 = percentile(single, 0.999);
    row.allocations = allocations;
    row.agreement = text("%.3f N", worst);
    const auto add = [&](const char* peer, std::optional<double> ns, const char* goal,
                         std::optional<double> atLeast) {
        BenchRow one = row;
        one.peer = peer;
        one.peerMedian = ns;
        one.goal = goal;
        one.reached = atLeast ? verdict(ns ? std::optional<bool>(*one.ratio() >= *atLeast &&
                                                                 allocations == 0 && worst <= 0.2)
                                           : std::nullopt)
                              : "–";
        rows.push_back(one);
    };
    const auto measured = [](const std::vector<double>& values) {
        return values.empty() ? std::nullopt : std::optional<double>(median(values));
    };
    add("Bullet, god-object, world's rays", measured(bullet), "≥ 8, 0 alloc., ≤ 0.2 N", 8.0);
    add("Bullet, god-object, shape's rays", measured(bulletBare), "≥ 8, 0 alloc., ≤ 0.2 N", 8.0);
    add("Embree, point query", measured(embrees), "–", std::nullopt);
    add("CHAI3D (published)", kChai3d_ns, "≥ 300", 300.0);
    std::printf("%d of %d ticks touch; p50 of single ticks %.0f ns, each with one clock read\n\n", touching,
                kTicks, percentile(single, 0.5));
}

void bySize(std::vector<BenchRow>& rows) {
    std::vector<TriangleMesh> meshes;
    std::vector<Recorded> paths;
    for (const double edge : {0.00226, 0.0007, 0.000222}) {
        meshes.push_back(*makeMesh(simulation::testing::bumpyOrgan(edge)));
        paths.push_back(record(meshes.back()));
    }
    const MeshContact contact(plain(), kRadius_m);
    std::vector<std::vector<double>> spent(meshes.size());
    for (int r = 0; r < kRepeats; ++r)
        for (std::size_t m = 0; m < meshes.size(); ++m)
            spent[m].push_back(contactOnce(contact, meshes[m], paths[m].tool));
    const double small = median(spent[0]);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        BenchRow row{.work = text("the same, %zu triangles", meshes[m].triangles().size())};
        row.oursMedian = median(spent[m]);
        row.agreement = text("%.2f times the least", *row.oursMedian / small);
        if (m == 2) {
            row.goal = "≤ 2 times";
            row.reached = verdict(*row.oursMedian <= 2.0 * small);
        }
        rows.push_back(row);
    }
    const TriangleMesh& mesh = meshes[1];
    std::vector<double> query;
    for (int r = 0; r < kRepeats; ++r)
        query.push_back(
            nsEach(paths[1].tool, [&](const Vec3& p) { return nearestOnMesh(mesh, p).signedDistance_m; }));
    BenchRow row{.work = "our tree's query every tick (to acquire), 50,000"};
    row.oursMedian = median(query);
    rows.push_back(row);
}

} // namespace

int main() {
    core::setModelFloatingPointEnvironment();
    printHeading("Contact with a triangle mesh, a tick");
    std::vector<BenchRow> rows;
    againstPeers(rows);
    bySize(rows);
    printTable(rows);
    std::printf(
        "%d repeats of %d ticks in turn, processor time; Bullet's path is that of the tip's lowest point.\n",
        kRepeats, kTicks);
    return 0;
}
