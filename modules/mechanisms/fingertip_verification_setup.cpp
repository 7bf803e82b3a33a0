// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_verification.h"

#include "core/random.h"
#include "mechanisms/fingertip_pad_identification.h"
#include "mechanisms/fingertip_platform.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::mechanisms {

namespace {

constexpr double kTick = core::kTickSeconds;
constexpr double kFingerMoves_Hz = 0.3;

core::Result<void> checked(const FingertipVerificationSettings& s) {
    const auto refuse = [](const char* what) {
        return core::fail(core::ErrorCode::badInput, std::string("fingertip verification: ") + what);
    };
    if (!(s.frequency_Hz >= 0.05 && s.frequency_Hz <= 5.0))
        return refuse("a frequency of 0.05 to 5 Hz is expected");
    if (!(s.peak_N > 0.0 && s.peak_N <= 4.0))
        return refuse("a peak above 0 and up to 4 N is expected");
    if (!(s.poses >= 1 && s.poses <= 10000))
        return refuse("1 to 10000 poses are expected");
    if (!(s.settle_s >= 0.1 && s.settle_s <= 5.0))
        return refuse("0.1 to 5 s for a pose are expected");
    if (!(s.fingerMoves_m >= 0.0 && s.fingerMoves_m <= 0.001))
        return refuse("a finger that moves by 0 to 1 mm is expected");
    return {};
}

void followSine(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                FingertipVerification& out) {
    FingertipPlatform platform(parameters, seed);
    const double period_s = 1.0 / out.settings.frequency_Hz;
    const int cycle = static_cast<int>(std::lround(period_s / kTick));
    core::Vec2 wanted = core::Vec2::Zero(), given = core::Vec2::Zero(); // first harmonics
    for (std::size_t c = 0; c < 3; ++c) {
        double measured2 = 0.0, true2 = 0.0;
        for (int n = 0; n < cycle; ++n) {
            const double t = (static_cast<double>(c) * cycle + n) * kTick;
            const double reference =
                0.5 * out.settings.peak_N * (1.0 - std::cos(2.0 * core::kPi * out.settings.frequency_Hz * t));
            platform.shiftFinger(out.settings.fingerMoves_m *
                                 std::sin(2.0 * core::kPi * kFingerMoves_Hz * t));
            platform.tick({reference, 0.0, 0.0}, true);
            const double turn = 2.0 * core::kPi * out.settings.frequency_Hz * t;
            const double sensed = platform.sensedForce_N(), real = platform.truth().normalForce_N;
            measured2 += (reference - sensed) * (reference - sensed);
            true2 += (reference - real) * (reference - real);
            wanted += reference * core::Vec2(std::cos(turn), std::sin(turn));
            given += real * core::Vec2(std::cos(turn), std::sin(turn));
            out.series.time_s.push_back(t);
            out.series.reference_N.push_back(reference);
            out.series.measured_N.push_back(sensed);
            out.series.true_N.push_back(real);
            out.series.height_m.push_back(platform.plant().pose().z_m);
        }
        out.rmse_N[c] = std::sqrt(measured2 / cycle);
        out.rmseTrue_N[c] = std::sqrt(true2 / cycle);
        out.meanRmse_N += out.rmse_N[c] / 3.0;
        out.meanRmseTrue_N += out.rmseTrue_N[c] / 3.0;
    }
    out.gain = given.norm() / wanted.norm();
    out.phase_deg = core::degFromRad(std::remainder(
        std::atan2(wanted.y(), wanted.x()) - std::atan2(given.y(), given.x()), 2.0 * core::kPi));
}

double heldFor(FingertipPlatform& platform, const core::DisplayPose& wanted, int ticks, double& mean_N) {
    double most = 0.0;
    mean_N = 0.0;
    const int settled = 3 * ticks / 4;
    for (int n = 0; n < ticks; ++n) {
        platform.tick(wanted, true);
        most = std::max(most, platform.truth().normalForce_N);
        mean_N += n >= settled ? platform.truth().normalForce_N / (ticks - settled) : 0.0;
    }
    return most;
}

void takeSteps(const FingertipPlatformParameters& parameters, std::uint64_t seed,
               FingertipVerification& out) {
    FingertipPlatform platform(parameters, seed);
    constexpr int kHold = 1200, kTimes = 3;
    constexpr std::array<std::array<double, 2>, 3> kSteps{{{0.0, 1.0}, {1.0, 1.5}, {2.0, 3.0}}};
    double before = 0.0, settled = 0.0;
    for (int n = 0; n < kTimes; ++n) {
        for (const auto& [from, to] : kSteps) {
            heldFor(platform, {from, 0.0, 0.0}, kHold, before);
            const double most = heldFor(platform, {to, 0.0, 0.0}, kHold, settled);
            const double beyond = std::max(0.0, most - std::max(to, settled));
            out.overshoot = std::max(out.overshoot, beyond / (to - from));
            out.overshootOfForce = std::max(out.overshootOfForce, beyond / to);
            out.staticError = std::max(out.staticError, std::abs(settled / to - 1.0));
            if (from == 0.0)
                out.oneNewton_N = std::max(out.oneNewton_N, most);
        }
    }
}

/// Makes the largest permitted requests: P3's 4 N at once, from 2 N, leaning to the corners, and as a sine of
/// 0.5 Hz.
void askTheMost(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                FingertipVerification& out) {
    FingertipPlatform platform(parameters, seed);
    constexpr double kMost = FingertipBounds::kLimit_N;
    const FingertipGeometry& g = parameters.geometry;
    double mean = 0.0;
    const auto ask = [&](const core::DisplayPose& wanted) {
        out.largest_N = std::max(out.largest_N, heldFor(platform, wanted, 800, mean));
    };
    ask({0.0, 0.0, 0.0});
    ask({kMost, 0.0, 0.0});
    ask({2.0, 0.0, 0.0});
    ask({kMost, 0.0, 0.0});
    for (const double side : {1.0, -1.0}) {
        ask({kMost, side * g.maximumPitch_rad, -side * g.maximumRoll_rad});
        ask({0.5, 0.0, 0.0});
    }
    for (int n = 0; n < 4000; ++n) {
        platform.tick({0.5 * kMost * (1.0 - std::cos(2.0 * core::kPi * 0.5 * n * kTick)), 0.0, 0.0}, true);
        out.largest_N = std::max(out.largest_N, platform.truth().normalForce_N);
    }
}

struct MeanAndSd {
    double mean = 0.0, sd = 0.0;
};
template <class Error> MeanAndSd overPoses(const std::vector<FingertipPosed>& poses, Error error) {
    MeanAndSd result;
    const auto count = static_cast<double>(poses.size());
    for (const FingertipPosed& pose : poses)
        result.mean += error(pose) / count;
    double sum2 = 0.0;
    for (const FingertipPosed& pose : poses)
        sum2 += (error(pose) - result.mean) * (error(pose) - result.mean);
    result.sd = poses.size() > 1 ? std::sqrt(sum2 / (count - 1.0)) : 0.0;
    return result;
}

void takePoses(const FingertipPlatformParameters& parameters, std::uint64_t seed,
               FingertipVerification& out) {
    FingertipPlatform platform(parameters, seed);
    core::Random random = core::Random::stream(seed, "fingertip/poses");
    const FingertipGeometry& g = parameters.geometry;
    const int ticks = static_cast<int>(std::lround(out.settings.settle_s / kTick));
    for (int i = 0; i < out.settings.poses; ++i) {
        FingertipPosed pose;
        pose.referencePitch_rad = random.uniform(-g.maximumPitch_rad, g.maximumPitch_rad);
        pose.referenceRoll_rad = random.uniform(-g.maximumRoll_rad, g.maximumRoll_rad);
        for (int n = 0; n < ticks; ++n)
            platform.tick({0.0, pose.referencePitch_rad, pose.referenceRoll_rad}, true);
        pose.measuredPitch_rad = platform.sensedPitch_rad();
        pose.measuredRoll_rad = platform.sensedRoll_rad();
        pose.truePitch_rad = platform.truth().pitch_rad;
        pose.trueRoll_rad = platform.truth().roll_rad;
        out.poses.push_back(pose);
    }
    const MeanAndSd measured = overPoses(out.poses, [](const FingertipPosed& p) {
        return core::degFromRad(
            std::hypot(p.referencePitch_rad - p.measuredPitch_rad, p.referenceRoll_rad - p.measuredRoll_rad));
    });
    const MeanAndSd real = overPoses(out.poses, [](const FingertipPosed& p) {
        return core::degFromRad(
            std::hypot(p.referencePitch_rad - p.truePitch_rad, p.referenceRoll_rad - p.trueRoll_rad));
    });
    out.meanError_deg = measured.mean;
    out.sdError_deg = measured.sd;
    out.meanErrorTrue_deg = real.mean;
    out.sdErrorTrue_deg = real.sd;
}

/// Returns the mean over several steps, since friction lets each start a little differently.
double latencyOf(const FingertipPlatformParameters& parameters, std::uint64_t seed) {
    FingertipPlatform platform(parameters, seed);
    constexpr int kSteps = 8, kMost = 300;
    double sum = 0.0;
    for (int step = 0; step < kSteps; ++step) {
        double before = 0.0;
        for (int n = 0; n < 800; ++n) {
            platform.tick({1.0, 0.0, 0.0}, true);
            before += n >= 700 ? platform.truth().normalForce_N / 100.0 : 0.0;
        }
        int ticks = 0;
        while (ticks < kMost && platform.truth().normalForce_N < before + 0.05) {
            platform.tick({1.5, 0.0, 0.0}, true);
            ++ticks;
        }
        sum += ticks * kTick;
    }
    return sum / kSteps;
}

FingertipPlatformParameters degraded(FingertipPlatformParameters p, const std::string& what, double factor) {
    if (what == "force_noise") {
        p.force.noise_N *= factor;
        p.force.hysteresis *= factor;
        p.force.creep *= factor;
    } else if (what == "adc") {
        p.force.adcBits =
            factor == 0.0 ? 16 : p.force.adcBits - static_cast<int>(std::lround(std::log2(factor)));
    } else if (what == "delay") {
        p.force.delay_ticks = static_cast<int>(std::lround(p.force.delay_ticks * factor));
    } else if (what == "friction") {
        p.drive.friction.coulomb *= factor;
        p.drive.friction.viscous *= factor;
    } else if (what == "imu") {
        p.imu.bias_rad *= factor;
        p.imu.noise_rad *= factor;
    } else {
        p.drive.backlash_m *= factor;
    }
    return p;
}

/// Returns the mean of the requested motor forces while a stiff servo pushes all three drives up or down at
/// one speed.
double effortAt(const FingertipPlatformParameters& parameters, double speed) {
    FingertipPlant plant(parameters);
    plant.reset({parameters.geometry.minimumZ_m + 0.004 - (speed > 0.0 ? 0.0015 : -0.0015), 0.0, 0.0});
    const double start = plant.motors().mean();
    const double dt = kTick / parameters.substeps;
    const int steps = static_cast<int>(0.003 / std::abs(speed) / dt);
    double sum = 0.0, integral = 0.0;
    int counted = 0;
    double before = start;
    for (int n = 0; n < steps; ++n) {
        const double target = start + speed * dt * n, q = plant.motors().mean();
        integral += dt * 2.0e5 * (target - q);
        const double force = 5000.0 * (target - q) + 30.0 * (speed - (q - before) / dt) + integral;
        before = q;
        plant.step(dt, core::Vec3::Constant(force));
        if (n > steps / 2) {
            sum += force;
            ++counted;
        }
    }
    return sum / counted;
}

} // namespace

core::Result<FingertipVerification> verifyFingertip(const FingertipPlatformParameters& parameters,
                                                    std::uint64_t seed,
                                                    const FingertipVerificationSettings& settings) {
    CHIRON_TRY(checked(settings));
    auto identified = worn(parameters, seed);
    CHIRON_TRY(identified);
    FingertipPlatformParameters& plant = *identified;
    FingertipVerification out;
    out.settings = settings;
    out.pad = plant.pad;
    out.identified = plant.control.pad;
    if (!settings.feedback)
        plant.control.forceBandwidth_rad_per_s = 0.0;
    followSine(plant, seed, out);
    takePoses(plant, seed, out);
    takeSteps(plant, seed, out);
    askTheMost(plant, seed, out);
    out.latency_s = latencyOf(plant, seed);
    return out;
}

std::vector<FingertipFinger> otherFingers(const FingerPadParameters& assumed) {
    const auto other = [&assumed](double stiffness, double hardening, double radius, double surface_m,
                                  double damping, double relaxation) {
        FingerPadParameters p = assumed;
        p.stiffness_N_per_m *= stiffness;
        p.hardening_per_m *= hardening;
        p.radius_m *= radius;
        p.surface_m += surface_m;
        p.damping_Ns_per_m *= damping;
        p.relaxation = relaxation;
        return p;
    };
    return {{"half", other(0.5, 1.0, 1.0, 0.0, 1.0, 0.1)},
            {"double", other(2.0, 1.0, 1.0, 0.0, 1.0, 0.1)},
            {"thick", other(1.0, 0.7, 1.2, -0.0008, 1.0, 0.1)},
            {"thin", other(1.0, 1.4, 0.85, 0.0006, 1.0, 0.1)},
            {"relaxing", other(1.0, 1.0, 1.0, 0.0, 1.0, 0.4)},
            {"softest", other(0.5, 0.7, 1.2, -0.0008, 2.0, 0.2)},
            {"stiffest", other(2.0, 1.4, 0.85, 0.0006, 0.5, 0.2)}};
}

core::Result<std::vector<FingertipOnFinger>>
verifyFingertipOnFingers(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                         const FingertipVerificationSettings& settings) {
    std::vector<FingertipOnFinger> table;
    for (const auto& [name, pad] : otherFingers(parameters.control.pad)) { // the finger that the controller
                                                                           // starts with
        FingertipPlatformParameters on = parameters;
        on.pad = pad;
        auto verified = verifyFingertip(on, seed, settings);
        CHIRON_TRY(verified);
        table.push_back({name, std::move(*verified)});
    }
    return table;
}

bool holdsOnAll(const std::vector<FingertipOnFinger>& fingers) noexcept {
    return !fingers.empty() && std::all_of(fingers.begin(), fingers.end(),
                                           [](const FingertipOnFinger& f) { return f.verified.holds(); });
}

core::Result<std::vector<FingertipDegradation>>
degradeFingertip(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                 const FingertipVerificationSettings& settings) {
    std::vector<FingertipDegradation> table;
    for (const char* what : {"force_noise", "adc", "delay", "friction", "backlash", "imu"}) {
        for (const double factor : {0.0, 1.0, 2.0, 4.0}) {
            const auto verified = verifyFingertip(degraded(parameters, what, factor), seed, settings);
            CHIRON_TRY(verified);
            table.push_back({what, factor, verified->meanRmse_N, verified->meanRmseTrue_N,
                             verified->meanError_deg, verified->meanErrorTrue_deg, verified->largest_N,
                             verified->holds()});
        }
    }
    return table;
}

FingertipFriction identifyFingertipFriction(const FingertipPlatformParameters& parameters) {
    constexpr double kSlow = 0.005, kFast = 0.02; // m/s
    // Both directions over the same travel, so that the pull of the bands cancels.
    const double slow = 0.5 * (effortAt(parameters, kSlow) - effortAt(parameters, -kSlow));
    const double fast = 0.5 * (effortAt(parameters, kFast) - effortAt(parameters, -kFast));
    const double viscous = (fast - slow) / (kFast - kSlow);
    return {slow - viscous * kSlow, viscous};
}

} // namespace chiron::mechanisms
