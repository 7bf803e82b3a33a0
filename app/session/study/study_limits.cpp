// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_limits.h"

#include "core/units.h"
#include "simulation/attributes/object_attributes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::session {

namespace {

constexpr double kArmDamping_Ns_per_m = 2.0; ///< b in the example of devices.md §6
constexpr double kSiteForce_N = 4.0;         ///< models.md §5
/// Fraction of the force limit for the weight of a lifted object; the rest is left for lifting it.
constexpr double kWeightShare = 0.75;

/// The damping of the objects in addition to the attribute, N·s/m.
double contactDamping(const psychophysics::StimulusDesign& stimulus) {
    const auto fixed = stimulus.fixed.find("damping_Ns_per_m");
    return fixed != stimulus.fixed.end() ? fixed->second : simulation::ObjectAttributes{}.damping_Ns_per_m;
}

/// The largest value of the attribute, SI; infinite if nothing limits it.
double largestValue(const psychophysics::StimulusDesign& stimulus, const RenderingLimits& limits,
                    std::string& why) {
    using psychophysics::Attribute;
    switch (stimulus.attribute) {
    case Attribute::stiffness:
        why = "stiffness";
        return limits.largestStiffness_N_per_m;
    case Attribute::mass:
        why = "weight";
        return kWeightShare * limits.largestForce_N / core::kStandardGravity;
    case Attribute::viscosity:
        why = "viscosity";
        // Both act on the same velocity.
        return std::max(0.0, limits.largestViscosity_Ns_per_m - contactDamping(stimulus));
    case Attribute::deformation:
    case Attribute::roughness:
    case Attribute::friction:
    case Attribute::apex:
        break;
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

RenderingLimits renderingLimits(const devices::DeviceDescriptor& device, double delay_s) {
    RenderingLimits limits;
    const double infinite = std::numeric_limits<double>::infinity();
    if (!device.rendersForce)
        return {infinite, infinite, infinite, 0.0, false};
    const double period_s = device.inProcess ? 0.0 : device.period_us * 1e-6;
    limits.delay_s = delay_s > 0.0 ? delay_s : period_s;
    limits.largestStiffness_N_per_m = kArmDamping_Ns_per_m / (0.5 * core::kTickSeconds + limits.delay_s);
    limits.largestViscosity_Ns_per_m = device.maximumDamping_Ns_per_m;
    limits.largestForce_N =
        device.maximumForce_N > 0.0 ? std::min(device.maximumForce_N, kSiteForce_N) : kSiteForce_N;
    return limits;
}

double statedDelay_s(const devices::DeviceDescriptor& device) {
    return device.packetDelay_us() * 1e-6;
}

RenderingLimits limitsAt(const devices::DeviceDescriptor& device, std::optional<double> measuredDelay_s) {
    const bool measured = measuredDelay_s && std::isfinite(*measuredDelay_s) && *measuredDelay_s > 0.0;
    RenderingLimits limits = renderingLimits(device, measured ? *measuredDelay_s : statedDelay_s(device));
    limits.measured = measured;
    return limits;
}

LimitedTable limitedTable(const psychophysics::Condition& condition, const RenderingLimits& limits) {
    LimitedTable table;
    std::string why;
    const psychophysics::StimulusDesign& stimulus = condition.stimulus;
    const double largest = largestValue(stimulus, limits, why);
    int multiple = 1;
    for (const psychophysics::Places& places : psychophysics::arrangements(condition.task))
        for (const int m : places)
            multiple = std::max(multiple, m);
    const bool fixedTooStiff = stimulus.fixed.contains("stiffness_N_per_m") &&
                               stimulus.fixed.at("stiffness_N_per_m") > limits.largestStiffness_N_per_m;
    for (const double difference : stimulus.differences) {
        const double value = stimulus.reference * std::pow(10.0, std::max(0.0, multiple * difference));
        if (fixedTooStiff || value > largest)
            continue;
        table.limit = std::max(table.limit, std::abs(difference));
        ++table.candidates;
    }
    if (table.candidates == static_cast<int>(stimulus.differences.size()))
        table.limit = std::numeric_limits<double>::infinity();
    else
        table.why = table.candidates == 0 ? "reference" : why;
    return table;
}

LimitedTable blindTable(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                        const RenderingLimits& limits) {
    const std::vector<double>& differences = condition.stimulus.differences;
    LimitedTable table = limitedTable(condition, limits);
    for (const psychophysics::Condition& each : design.conditions)
        if (each.stimulus.differences == differences)
            if (LimitedTable other = limitedTable(each, limits); other.limit < table.limit)
                table = std::move(other);
    return table;
}

} // namespace chiron::session
