// SPDX-License-Identifier: GPL-3.0-or-later
// What a finger on tissue costs: P3's contact with lumps on the flat pad and on curved tissue, beside the
// same law in plain code (coordinates, library functions) in turn.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "core/clock.h"
#include "core/fp_environment.h"
#include "core/random.h"
#include "core/units.h"
#include "realtime/tick_guard.h"
#include "simulation/palpation/tissue_contact.h"

#include <cmath>
#include <cstdio>

using namespace chiron;
using namespace chiron::bench;
using namespace chiron::simulation;
using core::Vec2;
using core::Vec3;

namespace {

constexpr int kRepeats = 15;
constexpr int kTicks = 20'000;       // 20 s at 1 kHz
constexpr double kChai3d_ns = 220.0; // CHAI3D's sphere, published in speed.md; not measured here

TissueParameters pad() {
    TissueParameters p;
    p.layers = {{"skin", 0.002, 40e3}, {"fat", 0.006, 8e3}, {"gland", 1.0, 17e3}};
    return p;
}

TissueParameters curved(int bumps) {
    TissueParameters p = pad();
    p.shape.bumps = {{Vec2(0, 0), Vec2(0.045, 0.040), 0.3, 0.012}};
    if (bumps > 1)
        p.shape.bumps.push_back({Vec2(0.002, 0.0), Vec2(0.010, 0.030), 0.1, -0.0015});
    return p;
}

/// A finger that wanders over the tissue with 20 to 60 mm/s, 0 to 4 mm deep, never off it, with a tremor of 9
/// Hz.
std::vector<core::ToolState> wandering(const TissueContact& contact) {
    std::vector<core::ToolState> path;
    for (int n = 0; n < kTicks; ++n) {
        const double t = 0.001 * n;
        const Vec2 xy(0.022 * std::sin(1.1 * t) + 1e-4 * std::sin(57.0 * t), 0.018 * std::cos(1.7 * t));
        core::ToolState tool;
        tool.p_WT = contact.surface().pointAt(xy) -
                    (0.00205 + 0.002 * std::sin(2.9 * t)) * contact.surface().normalAt(xy);
        tool.v_WT = path.empty() ? Vec3(Vec3::Zero()) : Vec3((tool.p_WT - path.back().p_WT) / 0.001);
        tool.q_WT = core::Quat(Eigen::AngleAxisd(0.3 * std::sin(0.7 * t), Vec3(0.6, 0.8, 0.0)));
        path.push_back(tool);
    }
    return path;
}

/// The flat pad with one lump as models.md §3 writes it down.
struct PlainPad {
    double k, a = 0.005, R = 0.0075, h = 0.012, m = 10.0, lambda = 0.25, mu = 0.2, b = 2.0;
    double zx = 0.0, zy = 0.0, px = 0.0, py = 0.0;
    bool touching = false;

    Vec3 respond(const core::ToolState& tool, double& alpha, core::DisplayPose& shown) {
        const double d = -tool.p_WT.z();
        if (d <= 0.0) {
            touching = false;
            zx = zy = 0.0;
            return Vec3::Zero();
        }
        const double x = tool.p_WT.x(), y = tool.p_WT.y(), rho = std::sqrt(x * x + y * y);
        const double c = h - lambda * d, H2 = c * c + 5.0 / 3.0 * a * a, S = rho * rho + H2;
        const double strength = 8.0 / core::kPi * a * std::pow(R, 3) * (m - 1.0) / (1.0 + 0.4 * (m - 1.0));
        const double chi = strength * H2 / std::pow(S, 3);
        const double byDepth =
            -2.0 * lambda * c * strength * (1.0 / std::pow(S, 3) - 3.0 * H2 / std::pow(S, 4));
        const double byPlace = -6.0 * rho * strength * H2 / std::pow(S, 4);
        const double lateral = -0.5 * k * d * d * byPlace;
        const double fe = k * d * (1.0 + chi) + 0.5 * k * d * d * byDepth;
        const double u = std::min(1.0, d / 0.001), w = u * u * (3.0 - 2.0 * u);
        const double fn = std::max(0.0, fe - w * b * tool.v_WT.z()), drag = w * b * std::min(1.0, fn / fe);
        if (touching) {
            zx += x - px;
            zy += y - py;
        }
        touching = true;
        px = x;
        py = y;
        const double pull = std::hypot(800.0 * zx, 700.0 * zy);
        if (pull > mu * fn) {
            zx *= mu * fn / pull;
            zy *= mu * fn / pull;
        }
        const double ux = rho > 0.0 ? x / rho : 0.0, uy = rho > 0.0 ? y / rho : 0.0;
        const Vec3 f(lateral * ux - drag * tool.v_WT.x() - 800.0 * zx,
                     lateral * uy - drag * tool.v_WT.y() - 700.0 * zy, fn);
        const double size = f.norm(), s = std::min(1.0, size / 0.05);
        const double t = std::hypot(f.x(), f.y());
        alpha = std::atan2(t, fn) * s * s * (3.0 - 2.0 * s);
        const Vec3 xT = tool.q_WT * Vec3::UnitX();
        const double flat = std::hypot(xT.x(), xT.y());
        if (t > 0.0 && flat > 0.0) {
            shown.roll_rad = alpha * (f.x() * xT.x() + f.y() * xT.y()) / (t * flat);
            shown.pitch_rad = -alpha * (f.y() * xT.x() - f.x() * xT.y()) / (t * flat);
            const double over = std::max({1.0, std::abs(shown.pitch_rad) / (core::kPi / 6),
                                          std::abs(shown.roll_rad) / (core::kPi / 9)});
            shown.roll_rad /= over;
            shown.pitch_rad /= over;
        }
        shown.normalForce_N = fn;
        return f;
    }
};

template <class Respond> double nsEach(const std::vector<core::ToolState>& path, Respond&& respond) {
    double sum = 0.0;
    const double spent_s = cpuSeconds([&] {
        for (const core::ToolState& tool : path)
            sum += respond(tool);
    });
    volatile double sink = sum;
    (void)sink;
    return 1e9 * spent_s / static_cast<double>(path.size());
}

double nsOf(const TissueContact& contact, const std::vector<core::ToolState>& path) {
    TissueTouch touch;
    const tests::TickGuard guard;
    return nsEach(path, [&](const core::ToolState& tool) {
        const TissueResponse r = contact.respond(tool, touch);
        return r.force.x() + r.display.roll_rad;
    });
}

void flatPad(std::vector<BenchRow>& rows) {
    TissueContact contact(pad());
    const Lump lump;
    contact.setLumps(std::span(&lump, 1));
    const auto path = wandering(contact);
    std::vector<double> ours, peers;
    tests::resetForbiddenCounts();
    for (int r = 0; r < kRepeats; ++r) {
        PlainPad plain{contact.normalStiffness_N_per_m()};
        peers.push_back(nsEach(path, [&](const core::ToolState& tool) {
            double alpha = 0.0;
            core::DisplayPose shown;
            return plain.respond(tool, alpha, shown).x() + shown.roll_rad;
        }));
        ours.push_back(nsOf(contact, path));
    }
    PlainPad plain{contact.normalStiffness_N_per_m()};
    TissueTouch touch;
    double worst = 0.0;
    for (const core::ToolState& tool : path) {
        double alpha = 0.0;
        core::DisplayPose shown;
        const Vec3 theirs = plain.respond(tool, alpha, shown);
        const TissueResponse r = contact.respond(tool, touch);
        worst = std::max({worst, (r.force - theirs).norm(), std::abs(r.lean_rad - alpha),
                          std::abs(r.display.roll_rad - shown.roll_rad),
                          std::abs(r.display.pitch_rad - shown.pitch_rad)});
    }
    BenchRow row{.work = "flat pad, three layers, one lump, friction, lean", .peer = "plain code"};
    row.peerMedian = median(peers);
    row.oursMedian = median(ours);
    row.allocations = tests::forbiddenCounts().of(tests::Forbidden::allocate);
    row.agreement = text("%.1g N, rad", worst);
    row.goal = "≤ 10 ns, 0 allocations";
    row.reached = verdict(*row.oursMedian <= 10.0 && *row.allocations == 0);
    rows.push_back(row);
    BenchRow published{.work = "the same", .peer = "CHAI3D's sphere, published, not measured here"};
    published.peerMedian = kChai3d_ns;
    published.oursMedian = row.oursMedian;
    rows.push_back(published);
}

void other(std::vector<BenchRow>& rows, const char* name, const TissueParameters& parameters, int lumps) {
    TissueContact contact(parameters);
    const std::array<Lump, 6> all{{{Vec2(0, 0), 0.012, 0.0075, 10},
                                   {Vec2(0.02, 0), 0.012, 0.0075, 3},
                                   {Vec2(0, 0.015), 0.01, 0.005, 10},
                                   {Vec2(-0.02, 0), 0.012, 0.0075, 5},
                                   {Vec2(0, -0.015), 0.01, 0.005, 8},
                                   {Vec2(0.015, 0.015), 0.01, 0.004, 12}}};
    contact.setLumps(std::span(all).first(static_cast<std::size_t>(lumps)));
    const auto path = wandering(contact);
    std::vector<double> ours;
    tests::resetForbiddenCounts();
    for (int r = 0; r < kRepeats; ++r)
        ours.push_back(nsOf(contact, path));
    BenchRow row{.work = name};
    row.oursMedian = median(ours);
    row.allocations = tests::forbiddenCounts().of(tests::Forbidden::allocate);
    rows.push_back(row);
}

} // namespace

int main() {
    core::setModelFloatingPointEnvironment();
    printHeading("Palpation: force and lean of one finger, a call");
    std::vector<BenchRow> rows;
    flatPad(rows);
    other(rows, "flat pad, no lump", pad(), 0);
    other(rows, "flat pad, six lumps", pad(), 6);
    TissueParameters ball = pad();
    ball.lumps = LumpLaw::secondSurface;
    other(rows, "flat pad, P3's second surface, one lump", ball, 1);
    other(rows, "one bump, one lump", curved(1), 1);
    other(rows, "dome with a furrow, three lumps", curved(2), 3);
    printTable(rows);
    std::printf("%d repeats of %d ticks in turn; throughput: CPU time of all divided by their number.\n",
                kRepeats, kTicks);
    return 0;
}
