// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sound/cue_source.h"
#include "desktop/sound/cue_synthesiser.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace chiron;
using desktop::CueSynthesiser;
using desktop::SoundCues;

namespace {

constexpr double kRate_Hz = 48'000.0;

std::vector<float> rendered(CueSynthesiser& synthesiser, double seconds) {
    std::vector<float> samples(static_cast<std::size_t>(seconds * kRate_Hz));
    synthesiser.render(samples);
    return samples;
}

float peak(const std::vector<float>& samples) {
    float most = 0.0f;
    for (const float sample : samples)
        most = std::max(most, std::abs(sample));
    return most;
}

/// The largest step from one sample to the next: a jump is heard as a crack.
float largestStep(const std::vector<float>& samples, float before = 0.0f) {
    float most = 0.0f;
    for (const float sample : samples) {
        most = std::max(most, std::abs(sample - before));
        before = sample;
    }
    return most;
}

/// Cycles a second, from the upward crossings of zero.
double pitch_Hz(const std::vector<float>& samples) {
    int crossings = 0;
    for (std::size_t i = 1; i < samples.size(); ++i)
        crossings += samples[i - 1] < 0.0f && samples[i] >= 0.0f ? 1 : 0;
    return crossings * kRate_Hz / static_cast<double>(samples.size());
}

// What the parts' own sines may step at most: 2 pi f / rate times their peak, and the onset of a level.
constexpr float kSmooth = 0.16f;

} // namespace

class TestCueSynthesiser : public QObject {
    Q_OBJECT
private slots:
    void silentAtRest();
    void aTouchClicksOnce();
    void pitchRisesWithForce();
    void theWarningSoundsAboveTheLimitOnly();
    void eachCueCanBeSwitchedOffAlone();
    void leaningMakesTheToneBrighter();
    void everythingStaysContinuousAndUnclipped();
    void fadesToNothing();
    void nonsenseIsHarmless();
    void theStreamIsWholeFramesOnEveryChannel();
};

void TestCueSynthesiser::silentAtRest() {
    CueSynthesiser synthesiser(kRate_Hz);
    QCOMPARE(peak(rendered(synthesiser, 0.1)), 0.0f);
    synthesiser.set(
        {.force_N = 0.0, .limit_N = 4.0, .contacts = 7, .audible = true}); // contacts of before are old news
    QCOMPARE(peak(rendered(synthesiser, 0.5)), 0.0f);
    synthesiser.set({.force_N = 3.0, .limit_N = 4.0, .contacts = 8, .audible = false});
    QCOMPARE(peak(rendered(synthesiser, 0.5)), 0.0f);
}

void TestCueSynthesiser::aTouchClicksOnce() {
    CueSynthesiser synthesiser(kRate_Hz);
    synthesiser.set({.contacts = 0, .audible = true});
    (void)rendered(synthesiser, 0.05);
    synthesiser.set({.contacts = 1, .audible = true});
    const auto click = rendered(synthesiser, 0.15);
    QVERIFY(peak(click) > 0.08f);
    QVERIFY(peak(click) <= CueSynthesiser::kClickPeak);
    QVERIFY(largestStep(click) < kSmooth);
    synthesiser.set({.contacts = 1, .audible = true});
    QCOMPARE(peak(rendered(synthesiser, 0.3)), 0.0f);
}

void TestCueSynthesiser::pitchRisesWithForce() {
    double before = 0.0;
    for (const double force_N : {0.1, 1.0, 2.0, 3.0, 3.9}) {
        CueSynthesiser synthesiser(kRate_Hz);
        synthesiser.set({.force_N = force_N, .limit_N = 4.0, .contacts = 0, .audible = true});
        (void)rendered(synthesiser, 0.2);
        const double pitch = pitch_Hz(rendered(synthesiser, 1.0));
        QVERIFY2(pitch > before, qPrintable(QString::number(pitch)));
        QVERIFY(std::abs(pitch - 220.0 * std::exp2(2.0 * force_N / 4.0)) < 3.0);
        before = pitch;
    }
}

void TestCueSynthesiser::theWarningSoundsAboveTheLimitOnly() {
    CueSynthesiser synthesiser(kRate_Hz);
    synthesiser.set({.force_N = 4.0, .limit_N = 4.0, .contacts = 0, .audible = true});
    (void)rendered(synthesiser, 0.2);
    const float atLimit = peak(rendered(synthesiser, 0.5));
    QVERIFY(atLimit <= CueSynthesiser::kTonePeak + 1e-3f);
    synthesiser.set({.force_N = 4.2, .limit_N = 4.0, .contacts = 0, .audible = true});
    const auto warned = rendered(synthesiser, 0.6);
    QVERIFY(peak(warned) > atLimit + 0.15f);
    // It beats: somewhere in between the tone is alone again.
    bool quiet = false;
    for (std::size_t at = 4800; at + 2400 < warned.size(); at += 240)
        quiet = quiet || peak({warned.begin() + static_cast<long>(at),
                               warned.begin() + static_cast<long>(at) + 2400}) < atLimit + 0.02f;
    QVERIFY(quiet);
}

void TestCueSynthesiser::eachCueCanBeSwitchedOffAlone() {
    const auto loudness = [](desktop::SoundSwitches on, double force_N, std::uint32_t contacts) {
        CueSynthesiser synthesiser(kRate_Hz);
        synthesiser.set({.on = on, .audible = true});
        (void)rendered(synthesiser, 0.05);
        synthesiser.set(
            {.force_N = force_N, .limit_N = 4.0, .contacts = contacts, .on = on, .audible = true});
        return peak(rendered(synthesiser, 0.1));
    };
    const desktop::SoundSwitches none{false, false, false, false};
    QCOMPARE(loudness(none, 6.0, 1), 0.0f);
    QVERIFY(loudness({true, false, false, false}, 6.0, 1) > 0.08f);
    QCOMPARE(loudness({true, false, false, false}, 6.0, 0), 0.0f);
    QVERIFY(loudness({false, true, false, false}, 2.0, 1) > 0.1f);
    QCOMPARE(loudness({false, false, true, false}, 2.0, 1), 0.0f); // lean has no voice of its own
    QVERIFY(loudness({false, false, false, true}, 6.0, 1) > 0.2f);
    QCOMPARE(loudness({false, false, false, true}, 3.9, 1), 0.0f);
}

/// The third harmonic, and nothing else: the same pitch, more of it the farther the force leans.
void TestCueSynthesiser::leaningMakesTheToneBrighter() {
    const auto harmonic = [](double lean, bool on, int times) {
        CueSynthesiser synthesiser(kRate_Hz);
        synthesiser.set(
            {.force_N = 2.0, .limit_N = 4.0, .lean = lean, .on = {true, true, on, true}, .audible = true});
        (void)rendered(synthesiser, 0.5);
        const auto samples = rendered(synthesiser, 1.0);
        const double frequency_Hz = times * 220.0 * std::exp2(1.0);
        double re = 0.0, im = 0.0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double angle = 2.0 * 3.141592653589793 * frequency_Hz * static_cast<double>(i) / kRate_Hz;
            re += static_cast<double>(samples[i]) * std::cos(angle);
            im += static_cast<double>(samples[i]) * std::sin(angle);
        }
        return 2.0 * std::hypot(re, im) / static_cast<double>(samples.size());
    };
    QVERIFY(harmonic(0.0, true, 3) < 1e-3);
    QVERIFY(harmonic(1.0, false, 3) < 1e-3);
    double before = harmonic(0.0, true, 3);
    for (const double lean : {0.25, 0.5, 1.0}) {
        const double now = harmonic(lean, true, 3);
        QVERIFY(now > before + 0.01);
        before = now;
    }
    QCOMPARE(harmonic(5.0, true, 3), before); // it ends where the platform does
    QVERIFY(harmonic(1.0, true, 2) < 1e-3);
    QVERIFY(harmonic(1.0, true, 1) > harmonic(1.0, true, 3));
}

void TestCueSynthesiser::everythingStaysContinuousAndUnclipped() {
    CueSynthesiser synthesiser(kRate_Hz);
    std::uint32_t seed = 1;
    std::uint32_t contacts = 0;
    float last = 0.0f;
    float most = 0.0f;
    for (int block = 0; block < 2000; ++block) { // as jumpy as a window that stalls: any cue after any other
        seed = seed * 1664525u + 1013904223u;
        contacts += seed >> 31;
        synthesiser.set({.force_N = ((seed >> 8) % 900) / 100.0,
                         .limit_N = 4.0,
                         .contacts = contacts,
                         .lean = ((seed >> 12) % 5) / 4.0,
                         .audible = (seed >> 4) % 5 != 0});
        const auto samples = rendered(synthesiser, 256 / kRate_Hz);
        QVERIFY(largestStep(samples, last) < 0.35f); // the steepest sum of sines: 14 kHz never comes up
        most = std::max(most, peak(samples));
        last = samples.back();
    }
    QVERIFY(most > 0.3f);
    QVERIFY(most < 1.0f);
    QVERIFY(CueSynthesiser::kTonePeak + CueSynthesiser::kClickPeak + CueSynthesiser::kWarningPeak < 1.0);
}

void TestCueSynthesiser::fadesToNothing() {
    CueSynthesiser synthesiser(kRate_Hz);
    synthesiser.set({.force_N = 6.0, .limit_N = 4.0, .contacts = 0, .audible = true});
    const float last = rendered(synthesiser, 0.333).back();
    synthesiser.set({.force_N = 6.0, .limit_N = 4.0, .contacts = 0, .audible = false});
    const auto fading = rendered(synthesiser, 0.2);
    QVERIFY(largestStep(fading, last) < kSmooth);
    QCOMPARE(peak(rendered(synthesiser, 0.2)), 0.0f);
}

void TestCueSynthesiser::nonsenseIsHarmless() {
    CueSynthesiser synthesiser(0.0);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0, 1e300}) {
        synthesiser.set({.force_N = bad, .limit_N = bad, .contacts = 0, .audible = true});
        for (const float sample : rendered(synthesiser, 0.01))
            QVERIFY(std::isfinite(sample) && std::abs(sample) < 1.0f);
    }
}

void TestCueSynthesiser::theStreamIsWholeFramesOnEveryChannel() {
    realtime::LatestValue<SoundCues> cues;
    desktop::CueSource source(cues, 48'000, 2);
    QVERIFY(source.open(QIODevice::ReadOnly | QIODevice::Unbuffered));
    QVERIFY(source.isSequential() && source.bytesAvailable() > 0);
    cues.publish({.force_N = 2.0, .limit_N = 4.0, .contacts = 0, .audible = true});
    std::vector<std::int16_t> samples(2 * 4801);
    QCOMPARE(source.read(reinterpret_cast<char*>(samples.data()), 4 * 4800 + 3),
             qint64{4 * 4800}); // no half frame
    int loudest = 0;
    for (std::size_t i = 0; i < 2 * 4800; i += 2) {
        QCOMPARE(samples[i], samples[i + 1]);
        loudest = std::max(loudest, std::abs(int(samples[i])));
    }
    QVERIFY(loudest > 3000 && loudest < 12000);
    cues.publish({.force_N = 2.0, .limit_N = 4.0, .contacts = 0, .audible = false});
    (void)source.read(reinterpret_cast<char*>(samples.data()), 4 * 4800);
    QCOMPARE(source.read(reinterpret_cast<char*>(samples.data()), 4 * 4800), qint64{4 * 4800});
    for (std::size_t i = 0; i < 2 * 4800; ++i)
        QCOMPARE(samples[i], std::int16_t{0});
}

QTEST_APPLESS_MAIN(TestCueSynthesiser)
#include "test_cue_synthesiser.moc"
