// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/friction_identification.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::mechanisms {

namespace {

constexpr std::array<std::size_t, 3> kMotorAxes{0, 1, 3};
/// Bandwidth of the position servo that moves and holds the axes: well below that of the amplifiers' lag.
constexpr double kServo_Hz = 8.0;
constexpr double kServoDamping = 0.8;    ///< of critical
constexpr double kSpeedLag_s = 0.005;    ///< lag of the speed that the servo computes from counts
constexpr double kMetresPerRadian = 0.2; ///< depth relative to heading and pitch: the tip's distance from
                                         ///< the pivot
constexpr double kTurn_s = 0.3;          ///< pause at rest at each end

double unitOf(std::size_t axis) {
    return axis == 3 ? kMetresPerRadian : 1.0;
}

std::array<double, 4> valuesOf(const GimbalCoordinates& q) {
    return {q.h, q.p, q.r, q.d};
}

/// The plant under a position servo that sees only counts.
class Servo {
public:
    Servo(GimbalPlant& plant, const GimbalCoordinates& middle) : m_plant(plant), m_wanted(valuesOf(middle)) {
        plant.reset(middle);
        const GimbalVector inertia = plant.inertia(middle);
        const double w = 2.0 * core::kPi * kServo_Hz;
        for (const std::size_t axis : kMotorAxes) {
            m_stiffness[axis] = inertia[static_cast<int>(axis)] * w * w;
            m_damping[axis] = 2.0 * kServoDamping * inertia[static_cast<int>(axis)] * w;
        }
        m_seen = sensed();
    }
    /// Runs one tick that moves `axis` at `speed` and holds the others; returns the effort of that axis.
    double tick(std::size_t axis, double speed) {
        m_wanted[axis] += speed * core::kTickSeconds;
        const std::array<double, 4> now = sensed();
        GimbalVector efforts = GimbalVector::Zero();
        for (const std::size_t a : kMotorAxes) {
            const double raw = (now[a] - m_seen[a]) / core::kTickSeconds;
            m_speed[a] += core::kTickSeconds / (core::kTickSeconds + kSpeedLag_s) * (raw - m_speed[a]);
            const double wantedSpeed = a == axis ? speed : 0.0;
            efforts[static_cast<int>(a)] =
                m_stiffness[a] * (m_wanted[a] - now[a]) + m_damping[a] * (wantedSpeed - m_speed[a]);
        }
        m_seen = now;
        m_plant.beginTick(efforts, true);
        for (int step = 0; step < m_plant.substeps(); ++step)
            m_plant.integrate(core::kTickSeconds / m_plant.substeps(), core::Vec3::Zero());
        m_plant.endTick();
        m_saturated = m_saturated || m_plant.saturated();
        return efforts[static_cast<int>(axis)];
    }
    bool saturated() const { return m_saturated; }

private:
    std::array<double, 4> sensed() const {
        std::array<double, 4> values{};
        for (std::size_t a = 0; a < 4; ++a)
            values[a] = m_plant.counts()[a] * m_plant.parameters().resolution[a];
        return values;
    }
    GimbalPlant& m_plant;
    std::array<double, 4> m_wanted;
    std::array<double, 4> m_seen{};
    std::array<double, 4> m_speed{};
    std::array<double, 4> m_stiffness{};
    std::array<double, 4> m_damping{};
    bool m_saturated = false;
};

/// Returns the mean effort over the settled middle of a movement of `length` at `speed`, at the same
/// positions forwards and backwards.
double meanEffort(Servo& servo, std::size_t axis, double speed, double length, double settled) {
    const int ticks = static_cast<int>(std::lround(length / std::abs(speed) / core::kTickSeconds));
    const int margin = static_cast<int>(0.5 * settled * ticks);
    double sum = 0.0;
    for (int n = 0; n < ticks; ++n) {
        const double effort = servo.tick(axis, speed);
        if (n >= margin && n < ticks - margin)
            sum += effort;
    }
    for (int n = 0; n < static_cast<int>(kTurn_s / core::kTickSeconds); ++n)
        servo.tick(axis, 0.0);
    return sum / std::max(ticks - 2 * margin, 1);
}

/// Measures F(v): first moves to an end and rests there, then moves forth and back.
double frictionAt(Servo& servo, std::size_t axis, double speed, double half, double settled) {
    (void)meanEffort(servo, axis, -speed, half, settled);
    const double forwards = meanEffort(servo, axis, speed, 2.0 * half, settled);
    const double backwards = meanEffort(servo, axis, -speed, 2.0 * half, settled);
    (void)meanEffort(servo, axis, speed, half, settled);
    return 0.5 * (forwards - backwards);
}

core::Result<void> check(const GimbalPlantParameters& p, const GimbalCoordinates& middle,
                         const FrictionSweep& sweep) {
    if (!(sweep.slow > 0.0 && sweep.fast > sweep.slow && sweep.fast <= 1.0 && sweep.halfTravel > 0.0 &&
          sweep.settled >= 0.0 && sweep.settled <= 0.9))
        return core::fail(core::ErrorCode::badInput, "friction sweep: expected 0 < slow < fast <= 1 rad/s, a "
                                                     "travel above 0, and a settled share of 0 to 0.9");
    const std::array<double, 4> q = valuesOf(middle);
    for (const std::size_t axis : kMotorAxes)
        if (const double half = sweep.halfTravel * unitOf(axis);
            !(q[axis] - half >= p.minimum[axis] && q[axis] + half <= p.maximum[axis]))
            return core::fail(core::ErrorCode::badInput,
                              "friction sweep: axis " + std::to_string(axis) +
                                  " (h, p, r, d) would leave its travel; expected it inside");
    return {};
}

} // namespace

core::Result<std::array<std::optional<AxisFriction>, 4>>
identifyFriction(GimbalPlant& plant, const GimbalCoordinates& middle, const FrictionSweep& sweep) {
    CHIRON_TRY(check(plant.parameters(), middle, sweep));
    std::array<std::optional<AxisFriction>, 4> found;
    for (const std::size_t axis : kMotorAxes) {
        Servo servo(plant, middle);
        const double unit = unitOf(axis);
        const double slow =
            frictionAt(servo, axis, sweep.slow * unit, sweep.halfTravel * unit, sweep.settled);
        const double fast =
            frictionAt(servo, axis, sweep.fast * unit, sweep.halfTravel * unit, sweep.settled);
        if (servo.saturated())
            return core::fail(core::ErrorCode::doesNotHold,
                              "friction sweep: the motor of axis " + std::to_string(axis) +
                                  " (h, p, r, d) ran at its limit; expected less friction than it overcomes");
        AxisFriction friction;
        friction.viscous = (fast - slow) / ((sweep.fast - sweep.slow) * unit);
        friction.coulomb = slow - friction.viscous * sweep.slow * unit;
        found[axis] = friction;
    }
    plant.reset(middle);
    return found;
}

} // namespace chiron::mechanisms
