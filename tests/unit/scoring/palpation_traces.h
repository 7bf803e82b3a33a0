// SPDX-License-Identifier: GPL-3.0-or-later
// Trials of a palpation that were made up, as a recording tells them.
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/cues/report_word.h"
#include "scoring/trace.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace chiron::tests {

/// A lump on a flat surface at z = 0.
struct MadeLump {
    double x_m = 0.0;
    double y_m = 0.0;
    double radius_m = 0.0075;
    int hardness = 5;
};

/// Three seconds of one or more fingers at 100 Hz over a search area of 60 × 60 mm in 3 × 3 regions of 20 mm;
/// hit radius 12 mm, band 0.8 to 2.5 N. Reports come one a sample from the 100th on.
class MadeTrial {
public:
    static constexpr std::size_t kSamples = 301;
    static constexpr double kStep_s = 0.01;

    explicit MadeTrial(const std::vector<MadeLump>& lumps = {}, std::size_t fingers = 1) {
        for (std::size_t f = 0; f < fingers; ++f)
            m_trial.tools.push_back(finger());
        for (const char* id : {"report_count", "report_field", "report_finding", "report_value",
                               "finding_x_m", "finding_y_m", "finding_z_m", "coverage"})
            m_trial.quantities.push_back({id, std::vector<double>(kSamples, 0.0)});
        m_trial.truth = {{"area_half_x_m", 0.03},
                         {"area_half_y_m", 0.03},
                         {"region_columns", 3.0},
                         {"region_rows", 3.0},
                         {"hit_radius_m", 0.012},
                         {"band_low_N", 0.8},
                         {"band_high_N", 2.5},
                         {"cover_force_N", 0.5},
                         {"asks_size", 1.0},
                         {"asks_hardness", 1.0},
                         {"lumps", static_cast<double>(lumps.size())}};
        for (std::size_t i = 0; i < lumps.size(); ++i)
            addLump(i, lumps[i]);
        m_trial.completed = true;
    }

    /// A finding in place `number`, with what is said of it (0: nothing).
    MadeTrial& found(int number, double x_m, double y_m, int confidence = 0, int hardness = 0,
                     unsigned size = 0) {
        say(simulation::ReportField::found, number, 0, x_m, y_m);
        if (confidence > 0)
            say(simulation::ReportField::confidence, number, static_cast<unsigned>(confidence), x_m, y_m);
        if (hardness > 0)
            say(simulation::ReportField::hardness, number, static_cast<unsigned>(hardness), x_m, y_m);
        if (size > 0)
            say(simulation::ReportField::size, number, size, x_m, y_m);
        return *this;
    }
    MadeTrial& say(simulation::ReportField field, int finding, unsigned value = 0, double x_m = 0.0,
                   double y_m = 0.0) {
        const double told[] = {++m_count,
                               static_cast<double>(field),
                               static_cast<double>(finding),
                               static_cast<double>(value),
                               x_m,
                               y_m,
                               0.0};
        for (std::size_t q = 0; q < 7; ++q)
            for (std::size_t i = m_next; i < kSamples; ++i)
                m_trial.quantities[q].values[i] = told[q];
        ++m_next;
        return *this;
    }
    MadeTrial& at(std::size_t sample) { // the next report is made then
        m_next = sample;
        return *this;
    }
    MadeTrial& press(std::size_t finger, std::size_t begin, std::size_t end, double force_N) {
        for (std::size_t i = begin; i < end; ++i)
            m_trial.tools[finger].tissue_N[i] = core::Vec3(0.0, 0.0, force_N);
        return *this;
    }
    MadeTrial& pause(std::size_t begin, std::size_t end) {
        for (scoring::ToolTrace& tool : m_trial.tools)
            for (std::size_t i = begin; i < end; ++i)
                tool.paused[i] = 1;
        return *this;
    }
    MadeTrial& covered(double share) {
        m_trial.quantities[7].values.back() = share;
        return *this;
    }
    MadeTrial& timedOut() {
        m_trial.completed = false;
        m_trial.timedOut = true;
        return *this;
    }
    scoring::TrialTrace& trial() { return m_trial; }
    operator scoring::TrialTrace() const { return m_trial; }

private:
    static scoring::ToolTrace finger() {
        scoring::ToolTrace tool;
        for (std::size_t i = 0; i < kSamples; ++i) {
            tool.t_s.push_back(kStep_s * static_cast<double>(i));
            tool.p_WT_m.push_back(core::Vec3(1e-4 * static_cast<double>(i), 0.0, -0.001));
            tool.tissue_N.push_back(core::Vec3::Zero());
            tool.paused.push_back(0);
        }
        return tool;
    }
    void addLump(std::size_t i, const MadeLump& lump) {
        const std::string name = "lump_" + std::to_string(i) + "_";
        for (const auto& [id, value] : {std::pair<const char*, double>{"x_m", lump.x_m},
                                        {"y_m", lump.y_m},
                                        {"z_m", 0.0},
                                        {"depth_m", 0.012},
                                        {"radius_m", lump.radius_m},
                                        {"hardness", static_cast<double>(lump.hardness)}})
            m_trial.truth.push_back({name + id, value});
    }

    scoring::TrialTrace m_trial;
    double m_count = 0.0;
    std::size_t m_next = 100;
};

inline scoring::SessionTrace palpationSession(const std::vector<scoring::TrialTrace>& trials) {
    scoring::SessionTrace trace;
    trace.exercise = "palpation";
    trace.trials = trials;
    for (std::size_t i = 0; i < trials.size(); ++i)
        trace.trials[i].trial = static_cast<int>(i);
    return trace;
}

} // namespace chiron::tests
