// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand.h"
#include "modules/exercises/palpation/cues/findings_book.h"
#include "modules/exercises/palpation/operators/palpation_operator.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "simulation/palpation/surface_map.h"
#include "simulation/palpation/tissue_contact.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// A scripted palpator on a tissue and nothing else: hands that no tissue pushes (P3's arm), a platform that
/// shows exactly what the tissue answers a tick later. The quick way to many trials; the whole stack is in
/// support/palpator_session.h.
namespace chiron::support {

inline constexpr double kBenchArm_kg = 0.15;

/// What one trial of the bench is about.
struct BenchTrial {
    std::vector<simulation::Lump> lumps;
    simulation::PalpationControl control;
    bool shown = false; ///< the lumps are drawn
};

struct BenchOutcome {
    std::array<simulation::Finding, simulation::kMaxFindings> findings{};
    bool done = false;
    double time_s = 0.0;
    double coverage = 0.0;  ///< 0..1
    double maximum_N = 0.0; ///< of ‖tissue force‖
    double pressing_s = 0.0;
    double band_s = 0.0; ///< of it, in the band
    double over_s = 0.0; ///< over the exercise's limit

    int marks() const {
        int n = 0;
        for (const simulation::Finding& finding : findings)
            n += finding.present ? 1 : 0;
        return n;
    }
};

class PalpationBench {
public:
    PalpationBench(const simulation::PalpationParameters& parameters,
                   const operators::PalpationOperatorSettings& settings, std::uint64_t seed,
                   bool anatomyTold = true)
        : m_parameters(parameters), m_contact(parameters.tissue) {
        operators::PalpationBriefing briefing;
        briefing.surface = parameters.tissue.shape;
        if (anatomyTold)
            briefing.normal = parameters.tissue.regions;
        briefing.areaHalf_m = parameters.areaHalf_m;
        briefing.hands = parameters.hands;
        briefing.fingers = parameters.fingers;
        briefing.fingerSpacing_m = parameters.fingerSpacing_m;
        briefing.bandLow_N = parameters.bandLow_N;
        briefing.bandHigh_N = parameters.bandHigh_N;
        briefing.asksSize = parameters.asksSize;
        briefing.asksHardness = parameters.asksHardness;
        briefing.asksConfidence = parameters.asksConfidence;
        auto made = operators::makePalpationOperator(settings, briefing, seed);
        if (!made)
            throw std::runtime_error(made.error().message);
        for (std::size_t tool = 0; tool < made->size(); ++tool) {
            m_fingers.push_back({std::move((*made)[tool]),
                                 mechanisms::Hand(settings.hand, seed + 977 * tool, kBenchArm_kg),
                                 {},
                                 {},
                                 {},
                                 0});
            m_fingers.back().hand.reset(
                {0.02 * static_cast<double>(tool), 0.0, m_contact.surface().highest_m() + 0.02});
            m_fingers.back().seen.p_DT = m_fingers.back().hand.p_D();
        }
    }

    /// One trial after another, half a second between.
    BenchOutcome run(const BenchTrial& trial) {
        m_contact.setLumps(trial.lumps);
        simulation::FindingsBook book;
        simulation::SurfaceMap map(m_parameters.areaHalf_m, m_parameters.tissue.contactRadius_m,
                                   m_parameters.coverForce_N);
        BenchOutcome out;
        for (int i = 0; i < 500; ++i)
            tick(trial, core::TrialPhase::between, 0.0, book, map, out);
        book.clear();
        out = {};
        map.clear();
        bool moved = trial.control.moveAfter_s <= 0.0;
        const int limit = static_cast<int>(std::lround(1000.0 * m_parameters.trialLimit_s));
        int i = 0;
        for (; i < limit && !book.done(); ++i) {
            if (!moved && 0.001 * i >= trial.control.moveAfter_s && !inContact()) {
                moved = true;
                std::vector<simulation::Lump> lumps = trial.lumps;
                for (simulation::Lump& lump : lumps)
                    lump.place_m += trial.control.move_m;
                m_contact.setLumps(lumps);
            }
            tick(trial, core::TrialPhase::running, 0.001 * (limit - i), book, map, out);
        }
        ++m_trial;
        out.findings = book.list();
        out.done = book.done();
        out.time_s = 0.001 * i;
        out.coverage = map.coverage();
        return out;
    }
    std::uint64_t digest() const { return m_digest; } ///< FNV over all intentions: two runs alike

private:
    struct Finger {
        std::unique_ptr<mechanisms::HandStrategy> mind;
        mechanisms::Hand hand;
        simulation::TissueTouch touch;
        simulation::TissueResponse felt;
        mechanisms::HandPerception seen;
        std::uint32_t buttons = 0;
    };

    bool inContact() const {
        for (const Finger& finger : m_fingers)
            if (finger.felt.inContact)
                return true;
        return false;
    }

    void tick(const BenchTrial& trial, core::TrialPhase phase, double left_s, simulation::FindingsBook& book,
              simulation::SurfaceMap& map, BenchOutcome& out) {
        core::Vec3 total = core::Vec3::Zero();
        for (std::size_t number = 0; number < m_fingers.size(); ++number) {
            Finger& finger = m_fingers[number];
            finger.seen.time_s = 0.001 * static_cast<double>(m_ticks);
            finger.seen.fingertip = true;
            finger.seen.pad = trial.control.forceOff ? core::DisplayPose{} : finger.felt.display;
            finger.seen.cues.trial = m_trial;
            finger.seen.cues.phase = phase;
            finger.seen.cues.force = core::ForceState::on;
            finger.seen.cues.timeLeft_s = left_s;
            finger.seen.cues.exercise.own<simulation::PalpationCues>().present = true;
            finger.seen.cues.exercise.own<simulation::PalpationCues>().lumps =
                trial.shown ? m_contact.lumps() : 0;
            for (int i = 0; i < finger.seen.cues.exercise.of<simulation::PalpationCues>().lumps; ++i) {
                const core::Vec3 centre = m_contact.lumpCentre_W(i);
                finger.seen.cues.exercise.own<simulation::PalpationCues>().lump[static_cast<std::size_t>(i)] =
                    {{centre.x(), centre.y(), centre.z()}, trial.lumps[static_cast<std::size_t>(i)].radius_m};
            }
            const mechanisms::HandIntention wanted = finger.mind->decide(finger.seen);
            remember(wanted);
            finger.hand.beginTick(wanted);
            const core::ToolState tool = move(number);
            finger.felt = m_contact.respond(tool, finger.touch);
            if (finger.felt.inContact)
                map.press(finger.felt.surfacePoint.head<2>(), finger.felt.normalForce_N);
            hear(finger, book);
            total += finger.felt.force;
            out.maximum_N = std::max(out.maximum_N, finger.felt.force.norm());
        }
        count(total.norm(), out);
        ++m_ticks;
    }

    /// A hand's other fingers go where its first one takes them, the wrist being as it was wanted.
    core::ToolState move(std::size_t number) {
        Finger& finger = m_fingers[number];
        const std::size_t which = number % static_cast<std::size_t>(m_parameters.fingers);
        const Finger& first = m_fingers[number - which];
        if (which == 0)
            for (int step = 0; step < 4; ++step)
                finger.hand.integrate(0.00025, core::Vec3::Zero());
        core::ToolState tool;
        tool.q_WT = first.hand.acting().q_DDesired;
        tool.p_WT =
            first.hand.p_D() +
            tool.q_WT * core::Vec3(static_cast<double>(which) * m_parameters.fingerSpacing_m, 0.0, 0.0);
        tool.v_WT = first.hand.v_D();
        finger.seen.p_DT = tool.p_WT;
        finger.seen.v_DT = tool.v_WT;
        finger.seen.q_DT = tool.q_WT;
        return tool;
    }

    void count(double force_N, BenchOutcome& out) const {
        if (force_N <= 0.02)
            return;
        out.pressing_s += 0.001;
        out.band_s += force_N >= m_parameters.bandLow_N && force_N <= m_parameters.bandHigh_N ? 0.001 : 0.0;
        out.over_s += force_N > m_parameters.maximumForce_N ? 0.001 : 0.0;
    }

    static void hear(Finger& finger, simulation::FindingsBook& book) {
        const std::uint32_t now = finger.hand.acting().buttons, pressed = now & ~finger.buttons;
        finger.buttons = now;
        const core::Vec3& p = finger.felt.surfacePoint;
        if ((pressed & core::kButtonMark) != 0)
            book.found({p.x(), p.y(), p.z()});
        if ((pressed & core::kButtonReport) != 0) {
            const auto word = static_cast<std::uint16_t>(now >> 16);
            book.report(simulation::reportField(word), simulation::reportValue(word));
        }
    }

    void remember(const mechanisms::HandIntention& wanted) {
        for (const double x : {wanted.p_DDesired.x(), wanted.p_DDesired.y(), wanted.p_DDesired.z()})
            m_digest = (m_digest ^ static_cast<std::uint64_t>(std::llround(1e12 * x))) * 0x100000001b3ULL;
        m_digest = (m_digest ^ wanted.buttons) * 0x100000001b3ULL;
    }

    simulation::PalpationParameters m_parameters;
    simulation::TissueContact m_contact;
    std::vector<Finger> m_fingers;
    std::uint64_t m_ticks = 0;
    std::uint16_t m_trial = 0;
    std::uint64_t m_digest = 0xcbf29ce484222325ULL;
};

} // namespace chiron::support
