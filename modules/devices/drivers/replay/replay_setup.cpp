// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and resamples a trace. This allocates, so it is kept apart from the code that the tick calls.
#include "devices/drivers/replay/replay_device.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::devices {

namespace {

constexpr double kFarthest_m = 10.0; // keeps counts of 1 µm inside 32 bits

tl::unexpected<core::Error> badRow(std::size_t row, const std::string& what) {
    return core::fail(core::ErrorCode::badInput, "trace row " + std::to_string(row + 1) + ": " + what);
}

core::Result<void> checkRow(const std::vector<TracePoint>& trace, std::size_t row) {
    const TracePoint& point = trace[row];
    if (!std::isfinite(point.t_s))
        return badRow(row, "time is not finite");
    if (row > 0 && point.t_s <= trace[row - 1].t_s)
        return badRow(row, "time " + std::to_string(point.t_s) + " s does not come after " +
                               std::to_string(trace[row - 1].t_s) + " s");
    if (point.t_s - trace[0].t_s > ReplayDevice::kMaximumLength_s)
        return badRow(row, "the trace is longer than 4 h");
    if (!point.p_WT_m.allFinite())
        return badRow(row, "position is not finite");
    if (!(point.p_WT_m.cwiseAbs().maxCoeff() <= kFarthest_m))
        return badRow(row, "position is farther than 10 m");
    if (!(std::abs(point.jaw_rad) <= 2.0 * core::kPi))
        return badRow(row, "jaw angle " + std::to_string(point.jaw_rad) + " rad is not within a turn");
    if (point.q_WT.has_value() != trace[0].q_WT.has_value())
        return badRow(row, "orientation is given in some rows only");
    if (point.q_WT && !(std::abs(point.q_WT->norm() - 1.0) <= 0.01)) // the supervisor's tolerance
        return badRow(row, "orientation is not a unit quaternion");
    return {};
}

/// Returns the rotation vector of q nearest to `previous`: the same rotation, without the jump at half a
/// turn.
core::Vec3 rotationVectorNear(const core::Quat& q, const core::Vec3& previous) {
    const double sine = q.vec().norm();
    const double angle = 2.0 * std::atan2(sine, q.w());
    core::Vec3 axis = previous.norm() > 0.0 ? core::Vec3(previous.normalized()) : core::Vec3::UnitX();
    if (sine > 0.0)
        axis = q.vec() / sine;
    const double turn = 2.0 * core::kPi;
    const double k = std::round((previous.dot(axis) - angle) / turn);
    return (angle + k * turn) * axis;
}

std::int32_t countsOf(double value, double grid) {
    return static_cast<std::int32_t>(std::lround(value / grid));
}

DeviceDescriptor describe(bool turns) {
    DeviceDescriptor d;
    d.driver = "replay";
    d.model = "Recorded trace";
    d.kinematics = "cartesian";
    for (const char* id : {"x", "y", "z"})
        d.axes.push_back({.id = id,
                          .unit = AxisUnit::metre,
                          .resolution = ReplayDevice::kGrid_m,
                          .minimum = -kFarthest_m,
                          .maximum = kFarthest_m});
    if (turns)
        for (const char* id : {"rotation_x", "rotation_y", "rotation_z"})
            d.axes.push_back({.id = id,
                              .unit = AxisUnit::radian,
                              .resolution = ReplayDevice::kGrid_rad,
                              .minimum = -1000.0,
                              .maximum = 1000.0});
    d.jawResolution_rad = ReplayDevice::kGrid_rad;
    d.inProcess = true;
    d.period_us = 1000;
    return d;
}

} // namespace

std::vector<ReplayDevice::Step> ReplayDevice::resample(const std::vector<TracePoint>& trace) {
    // The tolerance of one ten-thousandth of a tick keeps the last row of a trace whose times were rounded
    // when written.
    const double length_s = trace.back().t_s - trace.front().t_s;
    const auto count = static_cast<std::size_t>(std::floor(length_s / core::kTickSeconds + 1e-4)) + 1;
    std::vector<Step> steps(count);
    core::Vec3 turned = core::Vec3::Zero();
    std::size_t row = 0; // the last row at or before the tick
    for (std::size_t k = 0; k < count; ++k) {
        const double t_s = trace.front().t_s + static_cast<double>(k) * core::kTickSeconds;
        std::uint32_t passed = 0;
        while (row + 1 < trace.size() && trace[row + 1].t_s <= t_s + 1e-4 * core::kTickSeconds)
            passed |= trace[++row].buttons;
        const TracePoint& a = trace[row];
        const TracePoint& b = trace[std::min(row + 1, trace.size() - 1)];
        const double share = b.t_s > a.t_s ? std::clamp((t_s - a.t_s) / (b.t_s - a.t_s), 0.0, 1.0) : 0.0;
        const core::Vec3 p = a.p_WT_m + share * (b.p_WT_m - a.p_WT_m);
        for (int axis = 0; axis < 3; ++axis)
            steps[k].counts[static_cast<std::size_t>(axis)] = countsOf(p[axis], kGrid_m);
        if (a.q_WT) {
            turned = rotationVectorNear(a.q_WT->normalized().slerp(share, b.q_WT->normalized()), turned);
            for (int axis = 0; axis < 3; ++axis)
                steps[k].counts[static_cast<std::size_t>(axis) + 3] = countsOf(turned[axis], kGrid_rad);
        }
        steps[k].jawCounts = countsOf(a.jaw_rad + share * (b.jaw_rad - a.jaw_rad), kGrid_rad);
        steps[k].buttons = passed | a.buttons;
    }
    return steps;
}

core::Result<std::unique_ptr<ReplayDevice>> ReplayDevice::create(const std::vector<TracePoint>& trace) {
    if (trace.empty())
        return core::fail(core::ErrorCode::badInput, "the trace has no rows");
    for (std::size_t row = 0; row < trace.size(); ++row)
        CHIRON_TRY(checkRow(trace, row));
    DeviceDescriptor descriptor = describe(trace.front().q_WT.has_value());
    auto kinematics = CartesianKinematics::create(descriptor);
    CHIRON_TRY(kinematics);
    return std::unique_ptr<ReplayDevice>(
        new ReplayDevice(std::move(descriptor), *kinematics, resample(trace)));
}

ReplayDevice::ReplayDevice(DeviceDescriptor descriptor, const CartesianKinematics& kinematics,
                           std::vector<Step> samples)
    : m_descriptor(std::move(descriptor)), m_kinematics(kinematics), m_samples(std::move(samples)) {}

core::Result<void> ReplayDevice::open() {
    m_next = 0;
    m_packet = 0;
    m_finished.store(false, std::memory_order_release);
    return {};
}

} // namespace chiron::devices
