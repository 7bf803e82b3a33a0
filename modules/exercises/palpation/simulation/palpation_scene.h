// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/findings_book.h"
#include "modules/exercises/palpation/simulation/palpation_plan.h"
#include "modules/exercises/palpation/simulation/palpation_quantities.h"
#include "modules/exercises/palpation/simulation/report_queue.h"
#include "simulation/palpation/surface_map.h"
#include "simulation/palpation/tissue_contact.h"
#include "simulation/palpation/tissue_pinch.h"
#include "simulation/scene.h"
#include "simulation/trial_course.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// The running palpation exercise (P3; models.md §3). The trials follow the course of TrialCourse; kCompleted
/// (the report `done`) or kTimedOut ends one. In idle, between and finished there is no tissue, and force is
/// zero. There is no kMarked, because it would end the trial for any reader of the recording.
///
/// A mark is a finding at the surface under the finger whose button was pressed. For the mark command it is
/// the finger that presses hardest or, without contact, the one nearest to the surface. Report words come as
/// commands or with kButtonReport. Reports are taken in order, one every kReportTicks, and the quantities
/// (palpation_quantities.h) state a report if it had an effect. At the time limit waiting reports are still
/// taken, and the trial ends once the last one has been stated for that long, too. While paused, clocks, map
/// and reports stand still; contact still produces forces.
///
/// Tissue that is pressed harder than the level's yield force gives way under that finger and stays open
/// until the finger has left.
///
/// Where the level has a pinch, the first finger of a hand belongs to the hand's grasper. Jaws that were open
/// as they went into the tissue squeeze the tissue between them as they close (tissue_pinch.h). The squeeze
/// presses that finger's pad in addition to the tissue's force, and it gives way as the tissue does under a
/// finger.
///
/// Tool i is finger i: finger i % fingers of hand i / fingers. All fingers touch one tissue, so all energy
/// belongs to body 0. The scene does not report energy by body: an excess is then answered by damping and not
/// by softer tissue, because the person is asked to judge how soft the tissue is.
///
/// Deterministic; all trials are planned at construction. Not copyable.
/// Thread: haptic for respond(); any for construction.
class PalpationScene final : public IScene {
public:
    /// Least time between two reports, ms. A device that sends a packet every 8 ms (125 Hz) then has a
    /// recorded sample of each.
    static constexpr std::uint64_t kReportTicks = 10;

    PalpationScene(const PalpationParameters& parameters, std::uint64_t seed);
    ~PalpationScene() override;
    PalpationScene(const PalpationScene&) = delete;
    PalpationScene& operator=(const PalpationScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;
    bool conservative() const noexcept override { return m_parameters.tissue.conservative(); }

    /// The truth, for scoring.
    const std::vector<PalpationTrial>& trials() const noexcept { return m_trials; }
    const SurfaceMap& map() const noexcept { return m_map; } ///< of this trial; for tests and tables
    const FindingsBook& findings() const noexcept { return m_findings; } ///< of this trial
    const TissueContact& tissue() const noexcept { return m_tissue; }

private:
    struct Finger {
        TissueTouch touch;
        TissueResponse response;
        double above_m = 0.0;   ///< distance of the tip from its nearest surface point; 0 in contact
        bool used = false;      ///< in this tick: the finger exists and its pose is finite
        bool touching = false;  ///< in the previous tick
        TissueYield yield;      ///< how much the tissue under it still bears
        PinchTouch pinched;     ///< of a hand's first finger
        TissueYield pinchYield; ///< how much the tissue between its jaws still bears
        double squeeze_N = 0.0;
    };

    void prepare() noexcept;
    void leave() noexcept;
    void endTrial(SceneOutput& out) noexcept;
    void moveLumps() noexcept;

    void touch(const SceneInput& in, int count, SceneOutput& out) noexcept;
    void touchWith(Finger& finger, bool jaw, const core::ToolState& tool,
                   double mostDamping_Ns_per_m) const noexcept;
    void giveWay(Finger& finger, double dt_s) const noexcept;
    void pinch(Finger& finger, const core::ToolState& tool, double dt_s) const noexcept;
    bool hasJaw(std::size_t finger) const noexcept {
        return m_parameters.pinch && static_cast<int>(finger) % std::max(1, m_parameters.fingers) == 0;
    }
    void follow(const SceneInput& in) noexcept;
    void search() noexcept;

    void takeReports(const SceneInput& in) noexcept;
    void mark(const Finger& finger) noexcept;
    void report(std::uint16_t word) noexcept;
    const Finger* markingFinger() const noexcept;
    void passReport() noexcept;
    int enter(const PalpationReport& report) noexcept;

    double squeezeOf(std::size_t hand) const noexcept; ///< N, of its jaws
    void fillQuantities(SceneOutput& out) const noexcept;
    void fillCues(SceneOutput& out) const noexcept;
    void showLumps(PalpationCues& cues) const noexcept;
    void showBars(PalpationCues& cues) const noexcept;

    PalpationParameters m_parameters;
    std::vector<PalpationTrial> m_trials;
    TissueContact m_tissue;
    SurfaceMap m_map;
    TrialCourse m_course;
    std::uint64_t m_moveTicks; ///< clock value at which the control moves the lumps; 0: never
    bool m_showsLumps;
    bool m_showsCoverage;
    bool m_showsBars;

    bool m_moved = false; ///< the control has moved this trial's lumps
    std::array<Finger, core::kMaxTools> m_fingers{};

    FindingsBook m_findings;
    ReportButtons m_buttons;
    ReportQueue m_waiting;
    std::uint64_t m_nextReport = 0; ///< clock value of the trial from which on the next report may be taken
    /// The last report as the quantities state it, and the count.
    std::array<double, palpation_quantity::kCoverage> m_told{};
};

} // namespace chiron::simulation
