// SPDX-License-Identifier: GPL-3.0-or-later
// A whole loop of three instruments (a gimbal whose friction is compensated and whose base is turned, an
// endoscope's linkage, a tool that is only shown) round a scene that says a little of everything: what is
// recorded of each block, and what the screen gets. Against what was looked at and kept. A change that is
// meant is kept anew, and its difference is read in review: CHIRON_STORE_OUTLINES=1 ctest --test-dir
// build/release -R "^test_kept_loop$"
#include "core/fp_environment.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "mechanisms/rotation_vector.h"
#include "mechanisms/scripted_motion.h"
#include "support/cue_numbers.h"
#include "support/haptic_bench.h"
#include "support/kept_numbers.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::CommandKind;
using core::Vec3;
using tests::NumberLines;

namespace {

/// What an exercise would show.
struct OwnCues {
    double first = 0.0;
    double second = 0.0;
    double third = 0.0;
};

constexpr int kTicks = 3600, kBlock = 150;

/// Walls at z = 0 of each tool's start, and in every field something that goes with tick and tool.
class TalkingScene final : public simulation::IScene {
public:
    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        out = {};
        const auto n = static_cast<double>(now.index());
        out.tissue.count = in.tools.count;
        out.trial = static_cast<std::uint16_t>(now.index() / 1000 + 10U * static_cast<unsigned>(in.reports) +
                                               (in.mark ? 100U : 0U));
        out.phase = !in.started      ? core::TrialPhase::idle
                    : !in.forceReady ? core::TrialPhase::ready
                    : in.paused      ? core::TrialPhase::between
                                     : core::TrialPhase::running;
        out.events = now.index() % 700 == 0 && now.index() > 0 ? core::event_bits::kMarked : 0U;
        out.quantities[0] = in.present ? in.presented : 0.0;
        out.quantities[1] = in.answer ? in.answered : 0.0;
        out.quantities[2] = in.reports > 0 ? in.report[0] : 0.0;
        out.quantities[3] = static_cast<double>(in.force);
        out.quantities[4] = 0.01 * n;
        for (int i = 0; i < in.tools.count; ++i) {
            const auto t = static_cast<std::size_t>(i);
            const core::ToolState& tool = in.tools.tools[t];
            if (!m_known[t])
                m_start[t] = tool.p_WT;
            m_known[t] = true;
            out.quantities[5 + t] = in.dampingBudget_Ns_per_m[t] > 1e6 ? -1.0 : in.dampingBudget_Ns_per_m[t];
            out.quantities[8 + t] = tool.buttons + tool.jaw_rad;
            const Vec3 depth = m_start[t] - tool.p_WT;
            const double pressed = std::max(0.0, depth.z());
            out.tissue.tools[t].force = 150.0 * pressed * Vec3(0.2, -0.1, 1.0);
            out.tissue.tools[t].torque = 0.6 * pressed * Vec3(1.0, 0.5, -0.3);
            out.storedEnergy_J += 75.0 * pressed * pressed;
            out.contactStiffness_N_per_m = pressed > 0.0 ? 150.0 : out.contactStiffness_N_per_m;
            out.damping_Ns_per_m[t] = 1.0;
            out.load_N[t] = 155.0 * pressed;
            out.display[t] = {100.0 * pressed, 0.1, -0.05};
            out.p_WProxy[t] = tool.p_WT + 0.5 * depth;
            out.contact[t] = pressed > 0.004 ? 5 : 0;
        }
        core::VisibleCues& cues = out.cues;
        cues.timeLeft_s = 60.0 - 0.001 * n;
        cues.objectShown = now.index() % 2 == 0;
        cues.p_WObject = Vec3(0.01, 0.02, 1e-5 * n);
        cues.objectRadius_m = 0.02;
        cues.exercise.own<OwnCues>() = {1e-4 * n, 2e-4 * n, 3e-4 * n};
    }

private:
    std::array<bool, core::kMaxTools> m_known{};
    std::array<Vec3, core::kMaxTools> m_start{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

std::unique_ptr<mechanisms::HandStrategy> swinging(const Vec3& centre_D, double wide_m) {
    return std::make_unique<mechanisms::ScriptedMotion>(
        centre_D, std::vector<mechanisms::ScriptedMotion::Term>{{Vec3(wide_m, 0.0, 0.0), 0.7, 0.0},
                                                                {Vec3(0.0, wide_m, 0.0), 0.5, 1.0},
                                                                {Vec3(0.0, 0.0, wide_m), 0.9, 0.3}});
}

template <class Values> void addAll(std::vector<double>& out, const Values& values) {
    for (const auto& value : values)
        out.push_back(static_cast<double>(value));
}

std::vector<double> numbersOf(const core::HapticFrame& frame) {
    const core::TickHeader& h = frame.header;
    std::vector<double> out{static_cast<double>(frame.tools),
                            static_cast<double>(h.index),
                            static_cast<double>(h.now_ns) * 1e-6,
                            static_cast<double>(h.events),
                            static_cast<double>(h.guards),
                            static_cast<double>(h.trial),
                            static_cast<double>(h.heartbeatAge_ms),
                            static_cast<double>(h.phase),
                            static_cast<double>(h.force),
                            static_cast<double>(h.paused),
                            h.energySupplied_J,
                            h.energyStored_J};
    for (const core::Command& command : h.commands) {
        out.push_back(static_cast<double>(command.kind));
        out.push_back(static_cast<double>(command.argument));
    }
    addAll(out, h.quantities);
    for (std::uint32_t t = 0; t < frame.tools; ++t) {
        const core::ToolFrame& tool = frame.tool[t];
        addAll(out, tool.counts);
        addAll(out, std::array<double, 6>{
                        static_cast<double>(tool.jawCounts), static_cast<double>(tool.buttons),
                        static_cast<double>(tool.packet), static_cast<double>(tool.status % 1024),
                        static_cast<double>(tool.status >> 28), static_cast<double>(tool.deviceTime_us)});
        out.push_back(static_cast<double>(tool.age_us));
        addAll(out, tool.tissue);
        addAll(out, tool.commanded);
        addAll(out, tool.measured);
        addAll(out, tool.display);
    }
    return out;
}

std::vector<double> numbersOf(const haptics::DisplayState& s) {
    std::vector<double> out{static_cast<double>(s.tick),
                            static_cast<double>(s.now_ns) * 1e-6,
                            static_cast<double>(s.tools),
                            static_cast<double>(s.force),
                            static_cast<double>(s.waitsFor),
                            static_cast<double>(s.guards),
                            static_cast<double>(s.guardsSeen),
                            s.gain,
                            s.forceReady ? 1.0 : 0.0,
                            static_cast<double>(s.trial),
                            static_cast<double>(s.phase),
                            static_cast<double>(s.events),
                            s.timeLeft_s,
                            s.started ? 1.0 : 0.0,
                            s.paused ? 1.0 : 0.0,
                            s.ended ? 1.0 : 0.0,
                            s.objectShown ? 1.0 : 0.0,
                            s.objectRadius_m,
                            s.exercise.of<OwnCues>().first,
                            s.exercise.of<OwnCues>().second,
                            s.exercise.of<OwnCues>().third,
                            s.energySupplied_J,
                            s.energyStored_J,
                            static_cast<double>(s.lateTicks),
                            static_cast<double>(s.skippedDeadlines),
                            static_cast<double>(s.droppedFrames)};
    addAll(out, s.p_WObject_m);
    for (const haptics::ToolDisplay& tool : s.tool) {
        addAll(out, tool.p_WT_m);
        addAll(out, tool.q_WT);
        addAll(out, tool.v_WT_m_per_s);
        addAll(out, tool.p_WProxy_m);
        out.push_back(tool.jaw_rad);
        addAll(out, tool.tissue);
        addAll(out, tool.commanded);
        addAll(out, tool.measured);
        addAll(out, tool.displayPose);
        addAll(out, tool.safeDisplay);
        addAll(out, std::array<double, 6>{static_cast<double>(tool.buttons), static_cast<double>(tool.age_us),
                                          tool.measuredValid ? 1.0 : 0.0, tool.rendersForce ? 1.0 : 0.0,
                                          tool.enabled ? 1.0 : 0.0, tool.noMovement ? 1.0 : 0.0});
    }
    return out;
}

QString lineOf(const QString& name, const std::vector<double>& numbers) {
    QString line = name;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (std::abs(numbers[i]) > 1e-13)
            line += QStringLiteral(" %1 %2").arg(i).arg(numbers[i], 0, 'g', 10);
    return line;
}

} // namespace

class TestKeptLoop : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void aLoopIsAsItWasKept();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/haptics/kept_loop.txt"),
                           &tests::sameNumbers};
};

void TestKeptLoop::aLoopIsAsItWasKept() {
    devices::SimulatedDevice::Configuration gimbalSet;
    gimbalSet.jaw = mechanisms::JawParameters{};
    gimbalSet.frictionCompensation = 0.7;
    gimbalSet.mapping.origin_m = {0.01, -0.02, 0.0};
    gimbalSet.mapping.leftHanded = true;
    gimbalSet.mapping.scale = 1.4;
    const core::Quat turn = mechanisms::turned(core::Quat::Identity(), {0.1, -0.2, 0.3});
    gimbalSet.mapping.q_WD = {turn.w(), turn.x(), turn.y(), turn.z()};
    auto gimbal = devices::SimulatedDevice::create(gimbalSet, swinging(gimbalSet.start_D, 0.01));
    devices::SimulatedEndoscopeDevice::Configuration scopeSet;
    auto scope = devices::SimulatedEndoscopeDevice::create(scopeSet, swinging(scopeSet.start_D, 0.006));
    tests::BenchDevice shown(
        [](std::uint64_t tick) {
            return Vec3(0.01 * std::sin(0.004 * static_cast<double>(tick)), 0.0,
                        0.02 * std::cos(0.003 * static_cast<double>(tick)));
        },
        false);
    shown.arrivedBefore_ns = 2'345'678;
    QVERIFY(gimbal && scope && (*gimbal)->open() && (*scope)->open());
    haptics::LiveInputs inputs;
    tests::FrameStore frames(3000); // the last ones are dropped
    haptics::SafetySettings safety;
    safety.armingRamp_ms = 200;
    safety.pauseRamp_ms = 100;
    tests::LoopBench bench({{**gimbal, gimbalSet.mapping}, {**scope, {}}, {shown, {}}}, inputs, frames,
                           std::make_unique<TalkingScene>(), safety);
    NumberLines lines;
    lines.add(
        lineOf(QStringLiteral("shown before the first tick:"), numbersOf(bench.loop->display().latest())));
    realtime::TickSource source;
    std::vector<double> sums;
    bool goesOn = true;
    for (int tick = 0; tick < kTicks && goesOn; ++tick) {
        const std::int64_t now_ns = 7'000'000'000 + 1'000'000LL * tick + tick % 13 * 1000;
        const auto post = [&](int at, CommandKind kind, std::uint16_t argument = 0) {
            if (tick == at)
                QVERIFY(inputs.post({kind, argument}));
        };
        post(20, CommandKind::start);
        post(30, CommandKind::confirmHold);
        post(900, CommandKind::mark);
        post(901, CommandKind::report, 0x1046);
        post(902, CommandKind::present, 17);
        post(903, CommandKind::answer, 2);
        post(1300, CommandKind::pause);
        post(1500, CommandKind::resume);
        post(1500, CommandKind::confirmHold);
        post(2000, CommandKind::stopForce);
        post(2200, CommandKind::rearm);
        post(2201, CommandKind::confirmHold);
        post(3580, CommandKind::end);
        if (tick == 50)
            QVERIFY(inputs.postOwn({CommandKind::mark, 3}));
        if (tick % 20 == 0 && tick < 2700)
            inputs.beat(now_ns);
        shown.buttons = tick % 500 > 480 ? core::kButtonMark : 0U;
        goesOn = bench.loop->tick(source.next(now_ns));
        bench.loop->timing({tick % 100 == 7 ? 150'000 : 20'000, 90'000, tick % 400 == 9 ? 2U : 0U});
        if (tick < static_cast<int>(frames.frames.size())) {
            const std::vector<double> numbers = numbersOf(frames.frames.back());
            sums.resize(numbers.size(), 0.0);
            for (std::size_t i = 0; i < numbers.size(); ++i)
                sums[i] += numbers[i] * (1.0 + static_cast<double>(tick % kBlock) / kBlock) / kBlock;
        }
        if ((tick + 1) % kBlock != 0)
            continue;
        lines.add(lineOf(QStringLiteral("frames to %1:").arg(tick + 1), sums));
        sums.clear();
        lines.add(
            lineOf(QStringLiteral("shown at %1:").arg(tick + 1), numbersOf(bench.loop->display().latest())));
    }
    QVERIFY(!goesOn);
    lines.add(lineOf(QStringLiteral("shown at the end:"), numbersOf(bench.loop->display().latest())));
    lines.add(QStringLiteral("what the tool that is shown was told"),
              {shown.seen.shownForce_N, shown.seen.timeLeft_s, shown.received.back().enabled ? 1.0 : 0.0});
    const QString differs = m_kept.differs(QStringLiteral("loop"), lines.lines());
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
}

QTEST_APPLESS_MAIN(TestKeptLoop)
#include "test_kept_loop.moc"
