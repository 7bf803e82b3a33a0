// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_pad_identification.h"

#include "mechanisms/fingertip_sensors.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::mechanisms {

namespace {

constexpr double kMost_N = 2.2;   ///< above P3's palpations, and half of what the pad may get
constexpr double kLeast_N = 0.05; ///< below it the readings are noise
/// A press in an eighth of a second, as in palpation: little has relaxed by then.
constexpr double kSpeed_m_per_s = 0.012;
constexpr int kPresses = 3;

core::Error refusal(const char* what) {
    return {core::ErrorCode::badInput, std::string("finger pad: ") + what};
}

/// F = A e^{β(z − z_m)} − B at one β, and the residual of the readings.
struct LinearFit {
    double a = 0.0, b = 0.0, residual = 0.0;
};
LinearFit fitAt(const std::vector<PadReading>& readings, double beta, double middle_m) {
    double n = 0.0, e1 = 0.0, e2 = 0.0, f1 = 0.0, ef = 0.0;
    for (const PadReading& r : readings) {
        const double e = std::exp(beta * (r.height_m - middle_m));
        n += 1.0;
        e1 += e;
        e2 += e * e;
        f1 += r.force_N;
        ef += e * r.force_N;
    }
    LinearFit fit;
    fit.a = (n * ef - e1 * f1) / (n * e2 - e1 * e1);
    fit.b = (fit.a * e1 - f1) / n;
    for (const PadReading& r : readings) {
        const double error = fit.a * std::exp(beta * (r.height_m - middle_m)) - fit.b - r.force_N;
        fit.residual += error * error;
    }
    return fit;
}

/// A stiff servo on the drives' encoders, with the same command for all three, like the position loop.
class SlowPress {
public:
    SlowPress(const FingertipPlatformParameters& parameters, std::uint64_t seed)
        : m_p(parameters), m_kinematics(parameters.geometry), m_plant(parameters),
          m_force(parameters.force, seed) {
        m_pose.z_m = parameters.geometry.minimumZ_m + 0.002;
        m_plant.reset(m_pose);
        m_before = encoders();
        m_heights.fill(m_pose.z_m);
    }
    /// Runs one tick with the platform's height moving at this speed.
    PadReading tick(double speed_m_per_s) {
        m_pose.z_m += core::kTickSeconds * speed_m_per_s;
        const core::Vec3 at = encoders();
        const core::Vec3 error = m_kinematics.loop(m_pose).drives - at;
        m_integral += core::kTickSeconds * m_p.control.integral_N_per_ms * error;
        m_speed += 0.5 * ((at - m_before) / core::kTickSeconds - m_speed);
        m_before = at;
        const core::Vec3 force =
            m_p.control.proportional_N_per_m * error + m_integral +
            m_p.control.derivative_Ns_per_m * (core::Vec3::Constant(speed_m_per_s) - m_speed);
        for (int n = 0; n < m_p.substeps; ++n)
            m_plant.step(core::kTickSeconds / m_p.substeps, force);
        m_force.tick(m_plant.padForce_N(), m_plant.padPlace());
        FingertipPose sensed = m_pose;
        m_kinematics.forward(encoders(), sensed);
        // The reading below belongs to an earlier height (by the stated delay of the sensors), so heights go
        // through a delay line.
        m_heights[m_now] = sensed.z_m;
        const std::size_t late = static_cast<std::size_t>(
            std::clamp(m_p.control.senseDelay_ticks, 0, static_cast<int>(kLine) - 1));
        const double height_m = m_heights[(m_now + kLine - late) % kLine];
        m_now = (m_now + 1) % kLine;
        return {height_m, m_force.force_N() / (1.0 - m_p.control.sensorHysteresis)};
    }
    double height_m() const { return m_pose.z_m; }

private:
    core::Vec3 encoders() const {
        core::Vec3 sensed;
        for (int i = 0; i < 3; ++i)
            sensed[i] = m_p.drive.encoder_m * std::floor(m_plant.motors()[i] / m_p.drive.encoder_m + 0.5);
        return sensed;
    }
    FingertipPlatformParameters m_p;
    FingertipKinematics m_kinematics;
    FingertipPlant m_plant;
    FingertipForceSensors m_force;
    FingertipPose m_pose;
    static constexpr std::size_t kLine = 64;
    std::array<double, kLine> m_heights{};
    std::size_t m_now = 0;
    core::Vec3 m_integral = core::Vec3::Zero();
    core::Vec3 m_before = core::Vec3::Zero();
    core::Vec3 m_speed = core::Vec3::Zero();
};

} // namespace

core::Result<FingerPadParameters> fitPad(const std::vector<PadReading>& readings, double most_N,
                                         const FingerPadParameters& nominal) {
    std::vector<PadReading> used;
    double middle = 0.0;
    for (const PadReading& r : readings) {
        if (!std::isfinite(r.height_m) || !(r.force_N >= kLeast_N && r.force_N <= most_N))
            continue;
        used.push_back(r);
        middle += r.height_m;
    }
    if (used.size() < 20)
        return tl::unexpected(refusal("at least 20 readings of a finger that is pressed are expected"));
    middle /= static_cast<double>(used.size());
    double low = 100.0, high = 8000.0; // golden section over ln β, where the residual has one minimum
    constexpr double kGolden = 0.6180339887498949;
    for (int n = 0; n < 60; ++n) {
        const double left = high * std::pow(low / high, kGolden), right = low * std::pow(high / low, kGolden);
        if (fitAt(used, left, middle).residual < fitAt(used, right, middle).residual)
            high = right;
        else
            low = left;
    }
    const double beta = std::sqrt(low * high);
    const LinearFit fit = fitAt(used, beta, middle);
    if (!(fit.a > 0.0 && fit.b > 0.0))
        return tl::unexpected(refusal("a force that rises ever faster with the height is expected"));
    FingerPadParameters pad = nominal;
    pad.hardening_per_m = beta;
    pad.stiffness_N_per_m = fit.b * beta;
    pad.surface_m = middle + std::log(fit.b / fit.a) / beta;
    return pad;
}

core::Result<FingerPadParameters> identifyPad(const FingertipPlatformParameters& parameters,
                                              std::uint64_t seed) {
    SlowPress press(parameters, seed);
    std::vector<PadReading> readings;
    bool met = false;
    for (int n = 0; n < kPresses; ++n) {
        for (PadReading r = press.tick(0.0); r.force_N < kMost_N; readings.push_back(r)) {
            met = met || r.force_N > 2.0 * kLeast_N;
            if (press.height_m() >= parameters.geometry.maximumZ_m)
                return tl::unexpected(refusal(met ? "the motors do not press it up to 2.2 N"
                                                  : "no finger was met within the platform's travel"));
            r = press.tick(kSpeed_m_per_s);
        }
        while (press.tick(-kSpeed_m_per_s).force_N > 0.5 * kLeast_N &&
               press.height_m() > parameters.geometry.minimumZ_m) {
        }
    }
    return fitPad(readings, kMost_N, parameters.control.pad);
}

core::Result<FingertipPlatformParameters> worn(FingertipPlatformParameters parameters, std::uint64_t seed) {
    auto pad = identifyPad(parameters, seed);
    CHIRON_TRY(pad);
    parameters.control.pad = *pad;
    return parameters;
}

} // namespace chiron::mechanisms
