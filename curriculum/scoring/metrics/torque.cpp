// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric.h"
#include "scoring/metrics/metric_rows.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace chiron::scoring {

namespace {

/// Calls visit(‖tissue torque about the tip‖ N·m) for each unpaused sample of the first tool. Returns the
/// reason if a trial has no torques (a device or a file without orientation).
template <class Visit>
std::optional<Measurement> forEachTorque(std::span<const PreparedTrial> trials, Visit&& visit) {
    for (const PreparedTrial& trial : trials) {
        if (trial.tool == nullptr)
            continue;
        if (trial.tool->tissueTorque_Nm.empty())
            return Measurement::undefined(reasons::kNoTorques);
        for (std::size_t i = 0; i < trial.tool->t_s.size(); ++i)
            if (trial.tool->paused[i] == 0)
                visit(trial.tool->tissueTorque_Nm[i].norm());
    }
    return std::nullopt;
}

Measurement measureTorqueMax(std::span<const PreparedTrial> trials) {
    double largest_Nm = -1.0;
    if (auto why =
            forEachTorque(trials, [&](double torque_Nm) { largest_Nm = std::max(largest_Nm, torque_Nm); }))
        return *why;
    return largest_Nm < 0.0 ? Measurement::undefined(reasons::kNoSamples) : Measurement::of(1e3 * largest_Nm);
}

Measurement measureTorqueRms(std::span<const PreparedTrial> trials) {
    double squares = 0.0;
    std::size_t samples = 0;
    const auto why = forEachTorque(trials, [&](double torque_Nm) {
        squares += torque_Nm * torque_Nm;
        ++samples;
    });
    if (why)
        return *why;
    return samples == 0 ? Measurement::undefined(reasons::kNoSamples)
                        : Measurement::of(1e3 * std::sqrt(squares / static_cast<double>(samples)));
}

} // namespace

std::vector<MetricDefinition> torqueMetrics() {
    MetricRows rows;
    rows.add({.id = "torque_max",
              .unit = "mN·m",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .title = QT_TRANSLATE_NOOP("Metrics", "Largest torque"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "The largest torque between endoscope and tissue at any moment."),
              .definition = "Largest |torque| of the tissue about the tip.",
              .source = "models.md §1.2, §6; P1 eq. 4–6",
              .measure = measureTorqueMax});
    rows.add(
        {.id = "torque_rms",
         .unit = "mN·m",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::pooled,
         .title = QT_TRANSLATE_NOOP("Metrics", "Torque, root mean square"),
         .meaning =
             QT_TRANSLATE_NOOP("Metrics", "The root mean square of the torque between endoscope and tissue."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Largest torque"),
         .definition = "Square root of the mean of |torque|^2 of the tissue about the tip over all samples.",
         .source = "models.md §1.2, §6; P1 eq. 4–6",
         .measure = measureTorqueRms});
    return rows.take();
}

} // namespace chiron::scoring
