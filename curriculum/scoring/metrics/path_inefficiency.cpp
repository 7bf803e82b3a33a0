// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/endoscope_cues.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace chiron::scoring {

namespace {

constexpr double kShortest_m = 0.005; // models.md §6: below, the ratio says nothing

Measurement measurePathInefficiency(std::span<const PreparedTrial> trials) {
    double sum_percent = 0.0;
    int counted = 0;
    for (const PreparedTrial& trial : trials) {
        double length_m = 0.0;
        core::Vec3 displacement_m =
            core::Vec3::Zero(); // run by run: what happens in a pause is no one's path
        for (const MotionRun& run : trial.motion.runs) {
            displacement_m += run.p_WT_m.back() - run.p_WT_m.front();
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i)
                length_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
        }
        if (displacement_m.norm() < kShortest_m)
            continue;
        sum_percent += 100.0 * (length_m / displacement_m.norm() - 1.0);
        ++counted;
    }
    return counted > 0 ? Measurement::of(sum_percent / counted)
                       : Measurement::undefined("start and end are less than 5 mm apart");
}

/// Way of the tip and its own way along the centre-line in the stages of one trial that go along it, m.
class StagesOfCanal {
public:
    explicit StagesOfCanal(const PreparedTrial& trial) : m_trial(trial), m_series(*trial.trial->insertion) {}

    /// 100 (L/D − 1) over the way in and the way out, as far as each is 5 mm long; nothing where none is.
    std::optional<double> percent() {
        double length_m = 0.0, own_m = 0.0;
        for (const auto stage : {core::ProcedureStage::insertion, core::ProcedureStage::withdrawal}) {
            const double own = ownWay_m(stage);
            if (own < kShortest_m)
                continue;
            own_m += own;
            length_m += length(stage);
        }
        if (own_m < kShortest_m)
            return std::nullopt;
        return 100.0 * (length_m / own_m - 1.0);
    }

private:
    bool is(std::size_t i, core::ProcedureStage stage) const {
        return m_trial.tool->paused[i] == 0 && m_series.stage[i] == static_cast<std::uint8_t>(stage);
    }
    double ownWay_m(core::ProcedureStage stage) const {
        std::optional<double> first_m;
        double last_m = 0.0;
        for (std::size_t i = 0; i < m_trial.tool->t_s.size(); ++i)
            if (is(i, stage)) {
                last_m = m_series.s_m[i];
                first_m = first_m.value_or(last_m);
            }
        return first_m ? std::abs(last_m - *first_m) : 0.0;
    }
    double length(core::ProcedureStage stage) const {
        double length_m = 0.0;
        std::size_t at = 0;
        const auto now = [&](double t_s) {
            while (at + 1 < m_trial.tool->t_s.size() && m_trial.tool->t_s[at + 1] <= t_s)
                ++at;
            return is(at, stage);
        };
        for (const MotionRun& run : m_trial.motion.runs)
            for (std::size_t i = 0; i + 1 < run.p_WT_m.size(); ++i) {
                const bool begins = now(run.t_s[i]);
                if (begins && now(run.t_s[i + 1]))
                    length_m += (run.p_WT_m[i + 1] - run.p_WT_m[i]).norm();
            }
        return length_m;
    }

    const PreparedTrial& m_trial;
    const InsertionSeries& m_series;
};

/// In a canal by its stages, elsewhere as version 1.
Measurement measurePathInefficiency2(std::span<const PreparedTrial> trials) {
    const auto inCanal = [](const PreparedTrial& trial) { return trial.tool != nullptr && trial.trial->insertion; };
    if (trials.empty() || !std::all_of(trials.begin(), trials.end(), inCanal))
        return measurePathInefficiency(trials);
    double sum_percent = 0.0;
    int counted = 0;
    for (const PreparedTrial& trial : trials)
        if (const auto percent = StagesOfCanal(trial).percent()) {
            sum_percent += *percent;
            ++counted;
        }
    return counted > 0 ? Measurement::of(sum_percent / counted) : Measurement::undefined("start and end are less than 5 mm apart");
}

} // namespace

MetricDefinition pathInefficiencyMetric() {
    return {.id = "path_inefficiency",
            .version = 1,
            .unit = "%",
            .direction = Direction::lowerIsBetter,
            .wrench = MetricWrench::none,
            .aggregate = Aggregate::mean,
            .tools = MetricTools::first,
            .definition =
                "100 (L/D - 1), D the straight distance between the trial's ends; the mean over the trials "
                "where D is at least 5 mm.",
            .source = "models.md §6",
            .measure = measurePathInefficiency};
}

MetricDefinition pathInefficiencyMetric2() {
    MetricDefinition metric = pathInefficiencyMetric();
    metric.version = 2;
    metric.definition = "100 (L/D - 1). In a canal of the stages insertion and withdrawal together: L the tip's path, D its way along the "
                        "centre-line, stages of at least 5 mm. Elsewhere D is the straight distance between the trial's ends; the mean over the "
                        "trials where D is at least 5 mm.";
    metric.source = "models.md §6 and §8";
    metric.measure = measurePathInefficiency2;
    return metric;
}

} // namespace chiron::scoring
