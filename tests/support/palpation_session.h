// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/cues/report_word.h"
#include "modules/exercises/palpation/simulation/palpation_plan.h"
#include "simulation/palpation/tissue_surface.h"
#include "support/desktop_fixture.h"

#include <vector>

namespace chiron::tests {

/// A hand that palpates by a plan of its own, as a trace: what it does is known to the millimetre and the
/// millisecond.
class PalpatingHand {
public:
    static constexpr double kTrial_s = 6.0; ///< from one trial's beginning to the next one's
    static constexpr double kDone_s = 4.5;  ///< in each trial; the level's second between two trials follows

    PalpatingHand(const simulation::PalpationParameters& level, std::uint64_t seed)
        : m_surface(level.tissue.shape), m_trials(simulation::planPalpationTrials(level, seed)) {}

    /// Presses on every trial's first lump, marks it and says how sure (5, then 4, 3 ...); in the second
    /// trial marks a lump-free corner too, as a guess, and in the third takes its finding back.
    scoring::TraceRows rows() {
        for (std::size_t i = 0; i < m_trials.size(); ++i)
            addTrial(i);
        scoring::TraceRows rows;
        rows.columns.buttons = true;
        rows.rows = std::move(m_rows);
        rows.source = "palpating hand";
        return rows;
    }
    const std::vector<simulation::PalpationTrial>& trials() const { return m_trials; }

private:
    static constexpr double kAbove_m = 0.012;
    static constexpr double kDepth_m = 0.003;

    void to(double t_s, const core::Vec2& p_m, double height_m, std::uint32_t buttons = 0) {
        scoring::TraceRow row;
        row.t_s = t_s;
        row.p_WT_m = m_surface.pointAt(p_m) + core::Vec3(0.0, 0.0, height_m);
        row.buttons = buttons;
        m_rows.push_back(row);
    }
    void say(double t_s, const core::Vec2& p_m, std::uint32_t buttons) {
        to(t_s, p_m, -kDepth_m, buttons);
        to(t_s + 0.05, p_m, -kDepth_m);
    }
    void report(double t_s, const core::Vec2& p_m, simulation::ReportField field, unsigned value) {
        say(t_s, p_m, core::reportButtons(simulation::reportWord(field, value)));
    }
    void addTrial(std::size_t i) {
        const double t = kTrial_s * static_cast<double>(i);
        const core::Vec2 corner(0.030, -0.030);
        const bool lump = m_trials[i].lumps > 0;
        const core::Vec2 first = lump ? m_trials[i].lump[0].place_m : core::Vec2(-0.01, 0.01);
        to(t, first, kAbove_m);
        to(t + 0.4, first, kAbove_m);
        to(t + 0.8, first, -kDepth_m);
        if (lump) {
            say(t + 1.2, first, core::kButtonMark);
            report(t + 1.5, first, simulation::ReportField::confidence, static_cast<unsigned>(5 - i % 5));
        }
        if (i == 2)
            report(t + 1.8, first, simulation::ReportField::remove, 0);
        to(t + 2.2, first, -kDepth_m);
        to(t + 2.5, first, kAbove_m);
        to(t + 2.8, corner, kAbove_m);
        to(t + 3.1, corner, -kDepth_m);
        if (i == 1) {
            say(t + 3.5, corner, core::kButtonMark);
            report(t + 3.7, corner, simulation::ReportField::confidence, 1);
        }
        to(t + 4.0, corner, -kDepth_m);
        to(t + 4.3, corner, kAbove_m);
        to(t + kDone_s, corner, kAbove_m,
           core::reportButtons(simulation::reportWord(simulation::ReportField::done, 0)));
        to(t + kDone_s + 0.05, corner, kAbove_m);
    }

    simulation::TissueSurface m_surface;
    std::vector<simulation::PalpationTrial> m_trials;
    std::vector<scoring::TraceRow> m_rows;
};

inline constexpr std::uint64_t kPalpationSeed = 7;

/// A session of the first level by that hand, in the name of a person; 0 where the catalogue has no
/// palpation.
inline database::SessionId addPalpation(DesktopFixture& desktop, const std::string& person,
                                        std::uint64_t seed = kPalpationSeed) {
    const catalogue::ExerciseLevel* shipped = desktop.context.site().catalogue().find("palpation", 1);
    if (!shipped)
        return 0;
    session::TrainingRequest request;
    request.level = *shipped;
    request.seed = seed;
    request.ringFolder = recording::defaultRingFolder();
    auto station = session::traceStation(
        PalpatingHand(shipped->parameters.as<simulation::PalpationParameters>(), seed).rows());
    if (!station)
        qFatal("%s", station.error().message.c_str());
    request.station = std::move(*station);
    request.station.operatorName.clear();
    auto result = session::runTraining(desktop.database(), desktop.actor(person), std::move(request));
    if (!result)
        qFatal("%s", result.error().message.c_str());
    return result->session;
}

} // namespace chiron::tests
