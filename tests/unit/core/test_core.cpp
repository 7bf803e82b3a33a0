// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"
#include "core/fp_environment.h"
#include "core/haptic_frame.h"
#include "core/random.h"

#include <QtTest>
#include <bit>
#include <cmath>

using namespace chiron::core;

class TestCore : public QObject {
    Q_OBJECT
private slots:
    void xoshiroMatchesPublishedVector();
    void streamsDiffer();
    void normalHasUnitMoments();
    void belowIsUnbiased();
    void denormalsAreFlushed();
    void utcHasIsoForm();
};

// Reference: xoshiro256++ seeded with the state {1,2,3,4} yields 41943041 first (published in the authors' and in other
// implementations' tests); through SplitMix64 from seed 0 the state words are 0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4 ...
void TestCore::xoshiroMatchesPublishedVector() {
    Random r(0);
    const std::uint64_t s0 = 0xe220a8397b1dcdafULL;
    const std::uint64_t s3 = 0xf88bb8a8724c81ecULL;
    QCOMPARE(r.next(), std::rotl(s0 + s3, 23) + s0);
}

void TestCore::streamsDiffer() {
    Random a = Random::stream(7, "hand");
    Random b = Random::stream(7, "scene");
    Random c = Random::stream(7, "hand");
    const auto first = a.next();
    QVERIFY(first != b.next());
    QCOMPARE(first, c.next());
}

void TestCore::normalHasUnitMoments() {
    Random r(11);
    double sum = 0.0;
    double squares = 0.0;
    const int n = 200000;
    for (int i = 0; i < n; ++i) {
        const double x = r.normal();
        sum += x;
        squares += x * x;
    }
    QVERIFY(std::abs(sum / n) < 0.01);        // 4.5 standard errors
    QVERIFY(std::abs(squares / n - 1.0) < 0.02); // 6 standard errors
}

void TestCore::belowIsUnbiased() {
    Random r(3);
    std::array<int, 3> seen{};
    for (int i = 0; i < 30000; ++i)
        ++seen[r.below(3)];
    for (const int count : seen)
        QVERIFY(std::abs(count - 10000) < 400); // 4.9 standard deviations
}

void TestCore::denormalsAreFlushed() {
    setModelFloatingPointEnvironment();
    volatile double tiny = 1e-300;
    volatile double tinier = tiny * 1e-15;
    QCOMPARE(static_cast<double>(tinier), 0.0);
}

void TestCore::utcHasIsoForm() {
    const QString text = QString::fromStdString(utcNowIso8601());
    QVERIFY(QDateTime::fromString(text, Qt::ISODateWithMs).isValid());
}

QTEST_APPLESS_MAIN(TestCore)
#include "test_core.moc"
