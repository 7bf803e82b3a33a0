// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "scoring/metric.h"
#include "scoring/metrics/metric_rows.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace chiron::scoring {

namespace {

/// The samples that version 1 of a metric measures: calls visit(‖tissue force‖ N, seconds it was held) for
/// each unpaused sample of the first tool. The force of a sample holds until the next one, as the loop holds
/// it for a tick. The trial's last sample holds for no time.
struct ForceOfFirstTool {
    template <class Visit> static void forEach(std::span<const PreparedTrial> trials, Visit&& visit) {
        for (const PreparedTrial& trial : trials) {
            if (trial.tool == nullptr)
                continue;
            const ToolTrace& tool = *trial.tool;
            for (std::size_t i = 0; i < tool.t_s.size(); ++i)
                if (!tool.paused[i])
                    visit(tool.tissue_N[i].norm(),
                          i + 1 < tool.t_s.size() ? tool.t_s[i + 1] - tool.t_s[i] : 0.0);
        }
    }
};

/// The samples that version 2 measures: calls visit(load N, seconds it was held, whether anything was
/// touched) for each unpaused sample of every tool. The load is the tissue force. After tissue has given way,
/// and until the tool is out of it, the load is at least the force at which it gave way, because breaking
/// tissue must not count as being gentle. Touched means over 0.02 N, or broken.
struct LoadOfEveryTool {
    template <class Visit> static void forEach(std::span<const PreparedTrial> trials, Visit&& visit) {
        for (const PreparedTrial& trial : trials)
            for (const ToolTrace& tool : trial.trial->tools) {
                double broke_N = 0.0;
                for (std::size_t i = 0; i < tool.t_s.size(); ++i) {
                    const double force_N = tool.tissue_N[i].norm();
                    const bool broken =
                        i < tool.contact.size() && (tool.contact[i] & core::contact_bits::kThrough) != 0;
                    broke_N = broken ? std::max(broke_N, force_N) : 0.0;
                    if (tool.paused[i])
                        continue;
                    const double load_N = std::max(force_N, broke_N);
                    visit(load_N, i + 1 < tool.t_s.size() ? tool.t_s[i + 1] - tool.t_s[i] : 0.0,
                          broken || load_N > kContactForce_N);
                }
            }
    }
};

Measurement noSamples() {
    return Measurement::undefined(reasons::kNoSamples);
}

template <class Of> Measurement measureForceMax(std::span<const PreparedTrial> trials) {
    double largest_N = -1.0;
    Of::forEach(trials, [&](double f_N, auto...) { largest_N = std::max(largest_N, f_N); });
    return largest_N < 0.0 ? noSamples() : Measurement::of(largest_N);
}

Measurement measureForceMean(std::span<const PreparedTrial> trials) {
    double sum_N = 0.0;
    std::size_t samples = 0;
    ForceOfFirstTool::forEach(trials, [&](double f_N, double) {
        if (f_N > kContactForce_N) {
            sum_N += f_N;
            ++samples;
        }
    });
    return samples == 0 ? Measurement::undefined(reasons::kNoContact)
                        : Measurement::of(sum_N / static_cast<double>(samples));
}

Measurement measureForceMean2(std::span<const PreparedTrial> trials) {
    double impulse_Ns = 0.0, time_s = 0.0;
    LoadOfEveryTool::forEach(trials, [&](double load_N, double held_s, bool touched) {
        impulse_Ns += touched ? load_N * held_s : 0.0;
        time_s += touched ? held_s : 0.0;
    });
    return time_s > 0.0 ? Measurement::of(impulse_Ns / time_s) : Measurement::undefined(reasons::kNoContact);
}

Measurement measureForceRms(std::span<const PreparedTrial> trials) {
    double squares = 0.0;
    std::size_t samples = 0;
    ForceOfFirstTool::forEach(trials, [&](double f_N, double) {
        squares += f_N * f_N;
        ++samples;
    });
    return samples == 0 ? noSamples() : Measurement::of(std::sqrt(squares / static_cast<double>(samples)));
}

Measurement measureForceRms2(std::span<const PreparedTrial> trials) {
    double squares_N2s = 0.0, time_s = 0.0;
    LoadOfEveryTool::forEach(trials, [&](double load_N, double held_s, bool touched) {
        squares_N2s += touched ? load_N * load_N * held_s : 0.0;
        time_s += touched ? held_s : 0.0;
    });
    return time_s > 0.0 ? Measurement::of(std::sqrt(squares_N2s / time_s))
                        : Measurement::undefined(reasons::kNoContact);
}

Measurement measureForceP95(std::span<const PreparedTrial> trials) {
    std::vector<double> forces_N;
    ForceOfFirstTool::forEach(trials, [&](double f_N, double) { forces_N.push_back(f_N); });
    if (forces_N.empty())
        return noSamples();
    std::sort(forces_N.begin(), forces_N.end());
    const double place = 0.95 * static_cast<double>(forces_N.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, forces_N.size() - 1);
    return Measurement::of(forces_N[below] +
                           (place - static_cast<double>(below)) * (forces_N[above] - forces_N[below]));
}

/// Returns the load below which 95 % of the contact time lies.
Measurement measureForceP95Of2(std::span<const PreparedTrial> trials) {
    std::vector<std::pair<double, double>> loads; // N, s
    double time_s = 0.0;
    LoadOfEveryTool::forEach(trials, [&](double load_N, double held_s, bool touched) {
        if (touched && held_s > 0.0) {
            loads.emplace_back(load_N, held_s);
            time_s += held_s;
        }
    });
    if (loads.empty())
        return Measurement::undefined(reasons::kNoContact);
    std::sort(loads.begin(), loads.end());
    double below_s = 0.0;
    for (const auto& [load_N, held_s] : loads)
        if ((below_s += held_s) >= 0.95 * time_s)
            return Measurement::of(load_N);
    return Measurement::of(loads.back().first);
}

Measurement measureForcePeakRate(std::span<const PreparedTrial> trials) {
    double largest = -1.0;
    for (const PreparedTrial& trial : trials) {
        if (trial.tool == nullptr)
            continue;
        const ToolTrace& tool = *trial.tool;
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (!tool.paused[i] && !tool.paused[i + 1])
                largest = std::max(largest, std::abs(tool.tissue_N[i + 1].norm() - tool.tissue_N[i].norm()) /
                                                (tool.t_s[i + 1] - tool.t_s[i]));
    }
    return largest < 0.0 ? Measurement::undefined(reasons::kTooFewSamples) : Measurement::of(largest);
}

template <class Of> Measurement measureForceImpulseOverLimit(std::span<const PreparedTrial> trials) {
    double impulse_Ns = 0.0;
    bool any = false;
    const double limit_N = trials.empty() ? 0.0 : trials.front().forceLimit_N;
    Of::forEach(trials, [&](double f_N, double held_s, auto...) {
        any = true;
        impulse_Ns += f_N > limit_N ? f_N * held_s : 0.0;
    });
    return any ? Measurement::of(impulse_Ns) : noSamples();
}

template <class Of> Measurement measureForceTimeOverLimit(std::span<const PreparedTrial> trials) {
    double time_s = 0.0;
    bool any = false;
    const double limit_N = trials.empty() ? 0.0 : trials.front().forceLimit_N;
    Of::forEach(trials, [&](double f_N, double held_s, auto...) {
        any = true;
        time_s += f_N > limit_N ? held_s : 0.0;
    });
    return any ? Measurement::of(time_s) : noSamples();
}

} // namespace

std::vector<MetricDefinition> forceMetrics() {
    MetricRows rows;
    rows.add({.id = "force_max",
              .unit = "N",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::maximum,
              .needsForces = true,
              .title = QT_TRANSLATE_NOOP("Metrics", "Largest force"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "The largest force on the tissue at any moment."),
              .definition = "Largest |f|.",
              .source = "models.md §6",
              .measure = measureForceMax<ForceOfFirstTool>});
    rows.next({.tools = MetricTools::all,
               .definition = "Largest |f| of any tool.",
               .measure = measureForceMax<LoadOfEveryTool>});
    rows.add(
        {.id = "force_mean",
         .unit = "N",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::pooled,
         .needsForces = true,
         .title = QT_TRANSLATE_NOOP("Metrics", "Mean force in contact"),
         .meaning = QT_TRANSLATE_NOOP("Metrics", "The mean force on the tissue while the tool touched it."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Largest force"),
         .definition = "Mean of |f| over the samples above 0.02 N.",
         .source = "models.md §6",
         .measure = measureForceMean});
    rows.next({.tools = MetricTools::all,
               .definition = "Mean over time of the load |f| of every tool while it touches (over 0.02 N); "
                             "broken tissue counts with the force that "
                             "broke it.",
               .source = "models.md §6; data.md, Range of a law",
               .measure = measureForceMean2});
    rows.add(
        {.id = "force_rms",
         .unit = "N",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::pooled,
         .needsForces = true,
         .title = QT_TRANSLATE_NOOP("Metrics", "Force, root mean square"),
         .meaning = QT_TRANSLATE_NOOP(
             "Metrics",
             "The root mean square of the force on the tissue: high forces weigh more than in the mean."),
         .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Largest force"),
         .definition = "Square root of the mean of |f|^2 over all samples.",
         .source = "models.md §6",
         .measure = measureForceRms});
    rows.next({.tools = MetricTools::all,
               .definition = "Square root of the mean over time of the squared load |f|^2 of every tool "
                             "while it touches (over 0.02 N); broken "
                             "tissue counts with the force that broke it.",
               .source = "models.md §6; data.md, Range of a law",
               .measure = measureForceRms2});
    rows.add({.id = "force_p95",
              .unit = "N",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::pooled,
              .needsForces = true,
              .title = QT_TRANSLATE_NOOP("Metrics", "Force, 95th percentile"),
              .meaning = QT_TRANSLATE_NOOP("Metrics",
                                           "The force on the tissue was below this for 95 % of the time."),
              .titleAtMoment = QT_TRANSLATE_NOOP("Metrics", "Largest force"),
              .definition = "95th percentile of |f| over all samples, linear between order statistics.",
              .source = "models.md §6; Hyndman & Fan 1996, definition 7",
              .measure = measureForceP95});
    rows.next({.tools = MetricTools::all,
               .definition = "Load |f| under which 95 % of the time lies for which a tool touches (over 0.02 "
                             "N); broken tissue counts with the "
                             "force that broke it.",
               .source = "models.md §6; data.md, Range of a law",
               .measure = measureForceP95Of2});
    rows.add({.id = "force_peak_rate",
              .unit = "N/s",
              .wrench = MetricWrench::tissue,
              .aggregate = Aggregate::maximum,
              .needsForces = true,
              .title = QT_TRANSLATE_NOOP("Metrics", "Peak force rate"),
              .meaning = QT_TRANSLATE_NOOP("Metrics", "The fastest rise or fall of the force on the tissue."),
              .definition = "Largest |d|f|/dt| between neighbouring samples as recorded.",
              .source = "models.md §6",
              .measure = measureForcePeakRate});
    rows.add(
        {.id = "force_impulse_over_limit",
         .unit = "N·s",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::sum,
         .needsForces = true,
         .title = QT_TRANSLATE_NOOP("Metrics", "Impulse over the limit"),
         .meaning = QT_TRANSLATE_NOOP("Metrics",
                                      "Force times time while the force was over the limit of this level."),
         .definition =
             "Integral of |f| dt while |f| is over the level's force limit, each sample held until the next.",
         .source = "models.md §6",
         .measure = measureForceImpulseOverLimit<ForceOfFirstTool>});
    rows.next({.tools = MetricTools::all,
               .definition = "Integral of the load |f| dt of a tool while it is over the level's force "
                             "limit, all tools added; broken tissue counts "
                             "with the force that broke it.",
               .source = "models.md §6; data.md, Range of a law",
               .measure = measureForceImpulseOverLimit<LoadOfEveryTool>});
    rows.add(
        {.id = "force_time_over_limit",
         .unit = "s",
         .wrench = MetricWrench::tissue,
         .aggregate = Aggregate::sum,
         .needsForces = true,
         .title = QT_TRANSLATE_NOOP("Metrics", "Time over the force limit"),
         .meaning = QT_TRANSLATE_NOOP("Metrics",
                                      "How long the force on the tissue was over the limit of this level."),
         .definition = "Time for which |f| is over the level's force limit, each sample held until the next.",
         .source = "models.md §6",
         .measure = measureForceTimeOverLimit<ForceOfFirstTool>});
    rows.next({.tools = MetricTools::all,
               .definition = "Time for which the load |f| of a tool is over the level's force limit, all "
                             "tools added; broken tissue counts with the "
                             "force that broke it.",
               .source = "models.md §6; data.md, Range of a law",
               .measure = measureForceTimeOverLimit<LoadOfEveryTool>});
    return rows.take();
}

} // namespace chiron::scoring
