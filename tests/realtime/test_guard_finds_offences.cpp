// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/guarded_run.h"

#include <QtTest>
#include <memory>
#include <mutex>
#include <new>
#include <unistd.h>

using namespace chiron;
using namespace chiron::tests;

namespace {

/// Does one forbidden thing in each tick.
class Offender final : public simulation::IScene {
public:
    explicit Offender(Forbidden kind) : m_kind(kind) {}
    void respond(const realtime::HapticTick&, const simulation::SceneInput&,
                 simulation::SceneOutput& out) noexcept override {
        out = {};
        switch (m_kind) {
        case Forbidden::allocate:
            m_kept.reset(static_cast<char*>(::operator new(8)));
            break;
        case Forbidden::release:
            ::operator delete(m_kept.release());
            break;
        case Forbidden::lock:
            m_mutex.lock();
            m_mutex.unlock();
            break;
        case Forbidden::notify:
            pthread_cond_signal(&m_condition);
            break;
        case Forbidden::raise:
            raiseAndCatch();
            break;
        case Forbidden::write:
            (void)!::write(-1, "x", 1);
            break;
        }
    }

private:
    struct Raw {
        void operator()(char* p) const { ::operator delete(p); }
    };
    static void raiseAndCatch() noexcept {
        try {
            throw 1;
        } catch (int) {
        }
    }
    Forbidden m_kind;
    std::unique_ptr<char, Raw> m_kept{static_cast<char*>(::operator new(8))};
    std::mutex m_mutex;
    pthread_cond_t m_condition = PTHREAD_COND_INITIALIZER;
};

} // namespace

/// The test of the test: each kind of offence, done in a tick, must be counted.
class TestGuardFindsOffences : public QObject {
    Q_OBJECT
private slots:
    void theGuardFindsEachOffence_data() {
        QTest::addColumn<int>("kind");
        for (std::size_t i = 0; i < kForbiddenNames.size(); ++i)
            QTest::newRow(kForbiddenNames[i]) << static_cast<int>(i);
    }
    void theGuardFindsEachOffence() {
        QFETCH(int, kind);
        BenchDevice device(highPath);
        haptics::LiveInputs inputs;
        FrameStore store;
        LoopBench bench({{device, {}}}, inputs, store,
                        std::make_unique<Offender>(static_cast<Forbidden>(kind)));
        const ForbiddenCounts counts = guardedRun(*bench.loop, inputs, nullptr);
        QVERIFY2(counts.of(static_cast<Forbidden>(kind)) >= 1, words(counts));
    }
};

QTEST_APPLESS_MAIN(TestGuardFindsOffences)
#include "test_guard_finds_offences.moc"
