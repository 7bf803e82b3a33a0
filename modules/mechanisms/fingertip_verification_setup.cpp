// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_verification.h"

#include "core/random.h"
#include "mechanisms/fingertip_platform.h"

#include <cmath>

namespace chiron::mechanisms {

namespace {

constexpr double kTick = core::kTickSeconds;

core::Result<void> checked(const FingertipVerificationSettings& s) {
    const auto refuse = [](const char* what) { return core::fail(core::ErrorCode::badInput, std::string("fingertip verification: ") + what); };
    if (!(s.frequency_Hz >= 0.05 && s.frequency_Hz <= 5.0))
        return refuse("a frequency of 0.05 to 5 Hz is expected");
    if (!(s.peak_N > 0.0 && s.peak_N <= 4.0))
        return refuse("a peak above 0 and up to 4 N is expected");
    if (!(s.poses >= 1 && s.poses <= 10000))
        return refuse("1 to 10000 poses are expected");
    if (!(s.settle_s >= 0.1 && s.settle_s <= 5.0))
        return refuse("0.1 to 5 s for a pose are expected");
    return {};
}

void followSine(const FingertipPlatformParameters& parameters, std::uint64_t seed, FingertipVerification& out) {
    FingertipPlatform platform(parameters, seed);
    const double period_s = 1.0 / out.settings.frequency_Hz;
    const int cycle = static_cast<int>(std::lround(period_s / kTick));
    for (std::size_t c = 0; c < 3; ++c) {
        double measured2 = 0.0, true2 = 0.0;
        for (int n = 0; n < cycle; ++n) {
            const double t = (static_cast<double>(c) * cycle + n) * kTick;
            const double reference = 0.5 * out.settings.peak_N * (1.0 - std::cos(2.0 * core::kPi * out.settings.frequency_Hz * t));
            platform.tick({reference, 0.0, 0.0}, true);
            const double sensed = platform.sensedForce_N(), real = platform.truth().normalForce_N;
            measured2 += (reference - sensed) * (reference - sensed);
            true2 += (reference - real) * (reference - real);
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
}

struct MeanAndSd {
    double mean = 0.0, sd = 0.0;
};
template <class Error>
MeanAndSd overPoses(const std::vector<FingertipPosed>& poses, Error error) {
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

void takePoses(const FingertipPlatformParameters& parameters, std::uint64_t seed, FingertipVerification& out) {
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
        return core::degFromRad(std::hypot(p.referencePitch_rad - p.measuredPitch_rad, p.referenceRoll_rad - p.measuredRoll_rad));
    });
    const MeanAndSd real = overPoses(out.poses, [](const FingertipPosed& p) {
        return core::degFromRad(std::hypot(p.referencePitch_rad - p.truePitch_rad, p.referenceRoll_rad - p.trueRoll_rad));
    });
    out.meanError_deg = measured.mean;
    out.sdError_deg = measured.sd;
    out.meanErrorTrue_deg = real.mean;
    out.sdErrorTrue_deg = real.sd;
}

/// Mean of several steps, since friction lets each begin a little differently.
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
        p.force.adcBits = factor == 0.0 ? 16 : p.force.adcBits - static_cast<int>(std::lround(std::log2(factor)));
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

/// Mean of the motor forces asked while all three drives are pushed up or down at one speed by a stiff servo.
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

core::Result<FingertipVerification> verifyFingertip(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                                                    const FingertipVerificationSettings& settings) {
    if (auto sound = checked(settings); !sound)
        return tl::unexpected(sound.error());
    FingertipVerification out;
    out.settings = settings;
    followSine(parameters, seed, out);
    takePoses(parameters, seed, out);
    out.latency_s = latencyOf(parameters, seed);
    return out;
}

core::Result<std::vector<FingertipDegradation>> degradeFingertip(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                                                                 const FingertipVerificationSettings& settings) {
    std::vector<FingertipDegradation> table;
    for (const char* what : {"force_noise", "adc", "delay", "friction", "backlash", "imu"}) {
        for (const double factor : {0.0, 1.0, 2.0, 4.0}) {
            const auto verified = verifyFingertip(degraded(parameters, what, factor), seed, settings);
            if (!verified)
                return tl::unexpected(verified.error());
            table.push_back({what, factor, verified->meanRmse_N, verified->meanRmseTrue_N, verified->meanError_deg,
                             verified->meanErrorTrue_deg, verified->holds()});
        }
    }
    return table;
}

FingertipFriction identifyFingertipFriction(const FingertipPlatformParameters& parameters) {
    constexpr double kSlow = 0.005, kFast = 0.02; // m/s
    // There and back over the same travel: what the bands pull cancels.
    const double slow = 0.5 * (effortAt(parameters, kSlow) - effortAt(parameters, -kSlow));
    const double fast = 0.5 * (effortAt(parameters, kFast) - effortAt(parameters, -kFast));
    const double viscous = (fast - slow) / (kFast - kSlow);
    return {slow - viscous * kSlow, viscous};
}

} // namespace chiron::mechanisms
