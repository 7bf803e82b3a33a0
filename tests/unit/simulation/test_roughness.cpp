// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/attributes/roughness.h"
#include "simulation/objects/object_contact.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

constexpr double kRms = 40e-6;
constexpr double kWavelength = 0.003;
constexpr int kSamples = 8192; ///< of a track, a power of two
constexpr int kPerWave = 8;    ///< samples a shortest wavelength: up to four times the cut-off is seen
constexpr int kBands = 8;      ///< from 0 to the cut-off

Vec3 randomDirection(core::Random& random, bool inPlane) {
    const double around = random.uniform(0.0, 2.0 * core::kPi);
    const double z = inPlane ? 0.0 : random.uniform(-1.0, 1.0);
    const double rho = std::sqrt(1.0 - z * z);
    return {rho * std::cos(around), rho * std::sin(around), z};
}

std::vector<double> track(const Roughness& rough, const Vec3& from, const Vec3& along) {
    std::vector<double> heights;
    for (int i = 0; i < kSamples; ++i)
        heights.push_back(
            rough.sample(from + along * (i * rough.shortestWavelength_m() / kPerWave)).height_m);
    return heights;
}

void fft(std::vector<std::complex<double>>& x) {
    const std::size_t n = x.size();
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1;
        for (; (j & bit) != 0; bit >>= 1)
            j ^= bit;
        j ^= bit;
        if (i < j)
            std::swap(x[i], x[j]);
    }
    for (std::size_t length = 2; length <= n; length <<= 1) {
        const std::complex<double> turn = std::polar(1.0, -2.0 * core::kPi / static_cast<double>(length));
        for (std::size_t i = 0; i < n; i += length) {
            std::complex<double> w = 1.0;
            for (std::size_t j = 0; j < length / 2; ++j, w *= turn) {
                const auto a = x[i + j];
                const auto b = x[i + j + length / 2] * w;
                x[i + j] = a + b;
                x[i + j + length / 2] = a - b;
            }
        }
    }
}

/// Hann-windowed periodogram of heights (m²), one value a bin 0..n/2.
std::vector<double> periodogram(const std::vector<double>& heights) {
    std::vector<std::complex<double>> x;
    for (std::size_t i = 0; i < heights.size(); ++i)
        x.push_back(heights[i] * (0.5 - 0.5 * std::cos(2.0 * core::kPi * static_cast<double>(i) /
                                                       static_cast<double>(heights.size()))));
    fft(x);
    std::vector<double> power;
    for (std::size_t i = 0; i <= heights.size() / 2; ++i)
        power.push_back(std::norm(x[i]));
    return power;
}

struct Spectrum {
    std::array<double, kBands>
        band_dB{};          ///< mean density in the band over the mean density up to the cut-off
    double beyond_dB = 0.0; ///< largest density of a bin beyond 1.02 of the cut-off, over the same mean
};

/// Of the mean periodogram of the tracks.
Spectrum spectrum(const Roughness& rough, core::Random& random, int tracks, bool inPlane) {
    std::vector<double> mean(kSamples / 2 + 1, 0.0);
    for (int t = 0; t < tracks; ++t) {
        const Vec3 from(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0);
        const auto one = periodogram(track(rough, from, randomDirection(random, inPlane)));
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += one[i];
    }
    const std::size_t cutOff = kSamples / kPerWave;
    double inside = 0.0;
    for (std::size_t i = 0; i < cutOff; ++i)
        inside += mean[i] / static_cast<double>(cutOff);
    Spectrum out;
    for (std::size_t b = 0; b < kBands; ++b) {
        double sum = 0.0;
        for (std::size_t i = b * cutOff / kBands; i < (b + 1) * cutOff / kBands; ++i)
            sum += mean[i];
        out.band_dB[b] = 10.0 * std::log10(sum / static_cast<double>(cutOff / kBands) / inside);
    }
    double beyond = 0.0;
    for (std::size_t i = cutOff + cutOff / 50; i < mean.size(); ++i)
        beyond = std::max(beyond, mean[i]);
    out.beyond_dB = 10.0 * std::log10(beyond / inside);
    return out;
}

QByteArray told(const Spectrum& s) {
    QByteArray text;
    for (const double band : s.band_dB)
        text += QByteArray::number(band, 'f', 2) + ' ';
    return text + "| beyond " + QByteArray::number(s.beyond_dB, 'f', 1) + " dB";
}

} // namespace

class TestRoughness : public QObject {
    Q_OBJECT
private slots:
    void spectrumIsWhiteToTheCutOff_data();
    void spectrumIsWhiteToTheCutOff();
    void everyTrackIsWhite();
    void rmsIsWhatWasAsked();
    void heightsAreNearGaussian();
    void seedsAreOtherSurfacesOfTheSameKind();
    void gradientIsTheHeightsOwn();
    void sineIsOne();
    void noPlaceIsHigherThanTheBound();
    void stillProbeFeelsAConstant();
    void feltMoreWhenPressedHarder();
    void smoothIsSmooth();
};

void TestRoughness::spectrumIsWhiteToTheCutOff_data() {
    QTest::addColumn<double>("wavelength");
    QTest::addColumn<bool>("inPlane");
    QTest::newRow("3 mm, on a plane") << 0.003 << true;
    QTest::newRow("1 mm, on a plane") << 0.001 << true;
    QTest::newRow("3 mm, any direction") << 0.003 << false;
}

void TestRoughness::spectrumIsWhiteToTheCutOff() {
    QFETCH(double, wavelength);
    QFETCH(bool, inPlane);
    core::Random random(11);
    for (const std::uint64_t seed : {1u, 7u, 20261122u}) {
        const Spectrum s = spectrum(Roughness(kRms, wavelength, seed), random, 16, inPlane);
        for (const double band : s.band_dB)
            QVERIFY2(std::abs(band) < 1.0, told(s).constData());
        QVERIFY2(s.beyond_dB < -20.0, told(s).constData());
    }
}

// Not only in the mean over directions: along each single track, in quarters of the cut-off (16 of its 64
// lines each).
void TestRoughness::everyTrackIsWhite() {
    core::Random random(12);
    double worst = 0.0;
    for (int t = 0; t < 60; ++t) {
        const Spectrum s = spectrum(Roughness(kRms, kWavelength, random.next()), random, 1, t % 2 == 0);
        for (std::size_t b = 0; b < kBands; b += 2) {
            const double quarter =
                0.5 * (std::pow(10.0, 0.1 * s.band_dB[b]) + std::pow(10.0, 0.1 * s.band_dB[b + 1]));
            worst = std::max(worst, std::abs(10.0 * std::log10(quarter)));
        }
        QVERIFY2(s.beyond_dB < -20.0, told(s).constData());
    }
    QVERIFY2(worst < 2.5, qPrintable(QString::number(worst)));
}

void TestRoughness::rmsIsWhatWasAsked() {
    core::Random random(13);
    for (const double rms : {5e-6, 40e-6, 200e-6})
        for (const std::uint64_t seed : {3u, 4u, 5u}) {
            const Roughness rough(rms, kWavelength, seed);
            double sum2 = 0.0;
            double sum = 0.0;
            constexpr int kPlaces = 40000; // over a metre square
            for (int n = 0; n < kPlaces; ++n) {
                const double h = rough.sample({random.uniform(), random.uniform(), 0.0}).height_m;
                sum += h;
                sum2 += h * h;
            }
            const double found = std::sqrt(sum2 / kPlaces);
            QVERIFY2(std::abs(found / rms - 1.0) < 0.05, qPrintable(QString::number(found / rms)));
            QVERIFY(std::abs(sum / kPlaces) < 0.05 * rms);
        }
}

void TestRoughness::heightsAreNearGaussian() {
    core::Random random(14);
    const Roughness rough(kRms, kWavelength, 9);
    int within = 0;
    double fourth = 0.0;
    constexpr int kPlaces = 40000;
    for (int n = 0; n < kPlaces; ++n) {
        const double h = rough.sample({random.uniform(), random.uniform(), 0.0}).height_m / kRms;
        within += std::abs(h) < 1.0 ? 1 : 0;
        fourth += h * h * h * h / kPlaces;
    }
    QVERIFY2(std::abs(within / static_cast<double>(kPlaces) - 0.683) < 0.02,
             qPrintable(QString::number(within)));
    QVERIFY2(std::abs(fourth - 3.0) < 0.25, qPrintable(QString::number(fourth)));
}

void TestRoughness::seedsAreOtherSurfacesOfTheSameKind() {
    const Roughness a(kRms, kWavelength, 1);
    const Roughness again(kRms, kWavelength, 1);
    const Roughness b(kRms, kWavelength, 2);
    core::Random random(15);
    double product = 0.0;
    for (int n = 0; n < 20000; ++n) {
        const Vec3 p(random.uniform(), random.uniform(), 0.0);
        QCOMPARE(a.sample(p).height_m, again.sample(p).height_m);
        product += a.sample(p).height_m * b.sample(p).height_m / (20000 * kRms * kRms);
    }
    QVERIFY2(std::abs(product) < 0.05, qPrintable(QString::number(product)));
}

void TestRoughness::gradientIsTheHeightsOwn() {
    const Roughness rough(kRms, kWavelength, 21);
    core::Random random(16);
    const double e = 1e-7;
    for (int n = 0; n < 5000; ++n) {
        const Vec3 p(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
        const RoughnessSample at = rough.sample(p);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = e * Vec3::Unit(axis);
            const double slope =
                (rough.sample(p + step).height_m - rough.sample(p - step).height_m) / (2.0 * e);
            QVERIFY2(std::abs(slope - at.gradient[axis]) < 1e-6,
                     qPrintable(QString::number(slope - at.gradient[axis])));
        }
    }
}

void TestRoughness::sineIsOne() {
    // h and its Laplacian: every wave has |k| = 2π/λ, so ∇²h = −(2π/λ)² h exactly for sines; a wrong
    // polynomial would not.
    const Roughness rough(kRms, kWavelength, 22);
    core::Random random(17);
    const double e = 2e-6;
    const double k2 = std::pow(2.0 * core::kPi / kWavelength, 2);
    for (int n = 0; n < 2000; ++n) {
        const Vec3 p(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1));
        double laplacian = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = e * Vec3::Unit(axis);
            laplacian +=
                (rough.sample(p + step).gradient[axis] - rough.sample(p - step).gradient[axis]) / (2.0 * e);
        }
        QVERIFY2(std::abs(laplacian + k2 * rough.sample(p).height_m) < 1e-5 * k2 * kRms,
                 qPrintable(QString::number((laplacian + k2 * rough.sample(p).height_m) / (k2 * kRms))));
    }
}

void TestRoughness::noPlaceIsHigherThanTheBound() {
    const Roughness rough(kRms, kWavelength, 23);
    QVERIFY(std::abs(rough.bound_m() - kRms * std::sqrt(2.0 * Roughness::kWaves)) < 1e-18);
    core::Random random(18);
    double highest = 0.0;
    for (int n = 0; n < 100000; ++n)
        highest =
            std::max(highest, std::abs(rough.sample({random.uniform(), random.uniform(), 0.0}).height_m));
    QVERIFY(highest < rough.bound_m() && highest > 3.0 * kRms);
}

// models.md §2.2: a still probe feels a constant, and coming back it feels the same.
void TestRoughness::stillProbeFeelsAConstant() {
    ObjectAttributes rough;
    rough.roughness_m = kRms;
    rough.roughnessWavelength_m = kWavelength;
    rough.damping_Ns_per_m = 0.0;
    const ObjectContact contact(rough);
    ObjectContactState state;
    const auto press = [&](double x, double y) {
        ContactPlace place;
        place.depth_m = 0.002;
        place.foot = Vec3(x, y, 0.0);
        place.position = Vec3(x, y, -0.002);
        return contact.respond(place, core::kTickSeconds, state).force;
    };
    const Vec3 first = press(0.012, -0.007);
    for (int n = 0; n < 10000; ++n)
        QCOMPARE((press(0.012, -0.007) - first).norm(), 0.0);
    press(0.013, 0.0);
    QCOMPARE((press(0.012, -0.007) - first).norm(), 0.0);
    QVERIFY((press(0.0135, -0.007) - first).norm() > 1e-3); // elsewhere it is another
}

void TestRoughness::feltMoreWhenPressedHarder() {
    ObjectAttributes rough;
    rough.roughness_m = kRms;
    rough.roughnessWavelength_m = kWavelength;
    const ObjectContact contact(rough);
    const auto lateralRms = [&](double depth) {
        ObjectContactState state;
        core::Random random(19);
        double sum = 0.0;
        for (int n = 0; n < 5000; ++n) {
            ContactPlace place;
            place.depth_m = depth;
            place.foot = Vec3(random.uniform(), random.uniform(), 0.0);
            sum += contact.respond(place, core::kTickSeconds, state).force.head<2>().squaredNorm();
        }
        return std::sqrt(sum / 5000);
    };
    // k d times the rms slope in the plane, 2π rms/λ · √(2/3)
    const double slope = 2.0 * core::kPi * kRms / kWavelength * std::sqrt(2.0 / 3.0);
    for (const double depth : {0.001, 0.002, 0.004})
        QVERIFY2(std::abs(lateralRms(depth) / (500.0 * depth * slope) - 1.0) < 0.1,
                 qPrintable(QString::number(lateralRms(depth) / (500.0 * depth * slope))));
}

void TestRoughness::smoothIsSmooth() {
    QVERIFY(Roughness().smooth());
    QCOMPARE(Roughness().sample({1, 2, 3}).height_m, 0.0);
    QVERIFY(Roughness(0.0, 0.002, 1).smooth());
    QCOMPARE(Roughness(1e-5, 0.0001, 1).shortestWavelength_m(),
             Roughness::kShortestWavelength_m); // never finer than 1 mm
}

QTEST_APPLESS_MAIN(TestRoughness)
#include "test_roughness.moc"
