// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "core/haptic_frame.h"
#include "devices/drivers/simulated/simulated_fingertip_device.h"
#include "devices/drivers/simulated/simulated_second_finger.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "haptics/safety_supervisor.h"
#include "modules/exercises/palpation/cues/findings_book.h"
#include "modules/exercises/palpation/operators/palpation_operator.h"
#include "modules/exercises/palpation/simulation/palpation_plan.h"
#include "modules/exercises/palpation/simulation/palpation_quantities.h"
#include "modules/exercises/palpation/simulation/palpation_scene.h"
#include "support/palpation_detection.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// A whole session of a scripted palpator at any level of the catalogue, through the real loop, scene,
/// supervisor and P3's simulated arm and platform, with the ways of deceiving that the level's control has;
/// what was found is read back from the recorded quantities.
namespace chiron::support {

struct PalpationTrialHeard {
    simulation::FindingsBook book;
    double coverage = 0.0;
    double searching_s = 0.0, pressing_s = 0.0, band_s = 0.0, over_s = 0.0;
    double maximum_N = 0.0; ///< of one finger's tissue force
    bool completed = false;
    bool moved = false;
};

/// Hears of every frame of a session of at most `trials` trials.
class PalpationListener final : public core::IFrameSink {
public:
    explicit PalpationListener(const simulation::PalpationParameters& p)
        : m_parameters(p), m_trials(static_cast<std::size_t>(p.trials)) {}
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        m_finished = m_finished || (frame.header.events & core::event_bits::kFinished) != 0;
        if (frame.header.trial >= m_trials.size() || frame.header.phase != core::TrialPhase::running)
            return true;
        for (std::uint32_t tool = 0; tool < frame.tools; ++tool)
            for (const std::int32_t count : frame.tool[tool].counts)
                m_digest = (m_digest ^ static_cast<std::uint32_t>(count)) * 0x100000001b3ULL;
        PalpationTrialHeard& trial = m_trials[frame.header.trial];
        trial.searching_s += 0.001;
        trial.completed = trial.completed || (frame.header.events & core::event_bits::kCompleted) != 0;
        force(frame, trial);
        namespace q = simulation::palpation_quantity;
        const auto& told = frame.header.quantities;
        trial.coverage = told[q::kCoverage];
        trial.moved = trial.moved || told[q::kLumpsMoved] > 0.5;
        if (told[q::kReportCount] > m_reports) {
            const int finding = static_cast<int>(told[q::kReportFinding]);
            const auto field = static_cast<simulation::ReportField>(static_cast<int>(told[q::kReportField]));
            if (field == simulation::ReportField::found)
                trial.book.place(finding, {told[q::kFindingPlace], told[q::kFindingPlace + 1],
                                           told[q::kFindingPlace + 2]});
            else
                trial.book.rate(finding, field, static_cast<unsigned>(told[q::kReportValue]));
        }
        m_reports = told[q::kReportCount];
        return true;
    }
    const std::vector<PalpationTrialHeard>& trials() const { return m_trials; }
    bool finished() const { return m_finished; }
    std::uint64_t digest() const { return m_digest; } ///< FNV over all counts: two runs alike

private:
    void force(const core::HapticFrame& frame, PalpationTrialHeard& trial) const noexcept {
        bool presses = false, inBand = false, over = false;
        for (std::uint32_t tool = 0; tool < frame.tools; ++tool) {
            const auto& f = frame.tool[tool].tissue;
            const double size = std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
            trial.maximum_N = std::max(trial.maximum_N, size);
            presses = presses || size > 0.02;
            inBand = inBand || (size >= m_parameters.bandLow_N && size <= m_parameters.bandHigh_N);
            over = over || size > m_parameters.maximumForce_N;
        }
        trial.pressing_s += presses ? 0.001 : 0.0;
        trial.band_s += inBand ? 0.001 : 0.0;
        trial.over_s += over ? 0.001 : 0.0;
    }

    const simulation::PalpationParameters m_parameters;
    std::vector<PalpationTrialHeard> m_trials;
    double m_reports = 0.0;
    bool m_finished = false;
    std::uint64_t m_digest = 0xcbf29ce484222325ULL;
};

struct PalpationOutcome {
    bool ran = false;
    std::uint64_t digest = 0;
    std::vector<PalpationTrialHeard> trials;
    std::vector<std::vector<simulation::Lump>> lumps; ///< of each trial, where they were at its end
};

/// The parameters of a level of the content, with another number of trials if that is not 0.
inline simulation::PalpationParameters palpationLevel(int number, int trials = 0) {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    const catalogue::ExerciseLevel* level = catalogue->find("palpation", number);
    if (level == nullptr)
        qFatal("palpation has no level %d", number);
    auto p = level->parameters.as<simulation::PalpationParameters>();
    if (trials > 0) {
        p.catchTrials = std::min(p.catchTrials, trials / 2);
        p.trials = trials;
    }
    return p;
}

inline operators::PalpationBriefing briefingOf(const simulation::PalpationParameters& p) {
    operators::PalpationBriefing briefing;
    briefing.surface = p.tissue.shape;
    briefing.normal = p.tissue.regions;
    briefing.areaHalf_m = p.areaHalf_m;
    briefing.hands = p.hands;
    briefing.fingers = p.fingers;
    briefing.fingerSpacing_m = p.fingerSpacing_m;
    briefing.bandLow_N = p.bandLow_N;
    briefing.bandHigh_N = p.bandHigh_N;
    briefing.asksSize = p.asksSize;
    briefing.asksHardness = p.asksHardness;
    briefing.asksConfidence = p.asksConfidence;
    for (int tool = 0; tool < p.tools(); ++tool) { // two hands come from the right and the left
        devices::WorkspaceMapping place;
        place.origin_m[0] = p.hands < 2 ? 0.0 : (tool < p.fingers ? 0.5 : -0.5) * p.areaHalf_m.x();
        briefing.places.push_back(place);
    }
    return briefing;
}

/// Fingers in the order of the tools: a hand's first one moves its arm, the second rides on it.
inline std::vector<std::unique_ptr<devices::IDevice>>
palpatingDevices(const simulation::PalpationParameters& p,
                 const operators::PalpationOperatorSettings& settings, std::uint64_t seed) {
    const operators::PalpationBriefing briefing = briefingOf(p);
    auto minds = operators::makePalpationOperator(settings, briefing, seed);
    if (!minds)
        qFatal("%s", minds.error().message.c_str());
    std::vector<std::unique_ptr<devices::IDevice>> out;
    const devices::SimulatedFingertipDevice* hand = nullptr;
    for (std::size_t i = 0; i < minds->size(); ++i) {
        const int finger = static_cast<int>(i) % p.fingers;
        const std::uint64_t own = core::Random::mix(seed, "device " + std::to_string(i));
        if (finger > 0) {
            auto device = devices::SimulatedSecondFinger::create(
                *hand, {finger * p.fingerSpacing_m, 0.0, 0.0}, own, std::move((*minds)[i]));
            if (!device)
                qFatal("%s", device.error().message.c_str());
            out.push_back(std::move(*device));
            continue;
        }
        devices::SimulatedFingertipDevice::Configuration configuration;
        configuration.seed = own;
        configuration.hand = settings.hand;
        configuration.mapping = briefing.places[i];
        auto device = devices::SimulatedFingertipDevice::create(configuration, std::move((*minds)[i]));
        if (!device)
            qFatal("%s", device.error().message.c_str());
        hand = device->get();
        out.push_back(std::move(*device));
    }
    return out;
}

inline PalpationOutcome runPalpation(const simulation::PalpationParameters& p, const std::string& name,
                                     std::uint64_t seed) {
    const auto settings = operators::palpationOperatorSettings(name);
    const auto fingers = palpatingDevices(p, *settings, seed);
    std::vector<haptics::LoopTool> tools;
    const operators::PalpationBriefing briefing = briefingOf(p);
    for (std::size_t i = 0; i < fingers.size(); ++i) {
        if (auto opened = fingers[i]->open(); !opened)
            qFatal("%s", opened.error().message.c_str());
        tools.push_back({*fingers[i], briefing.places[i]});
    }
    PalpationListener listener(p);
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene = std::make_unique<simulation::PalpationScene>(p, seed);
    scenes.offer(scene);
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SafetySettings safety;
    safety.exerciseForce_N = p.maximumForce_N;
    safety.heartbeatWatched = false;
    auto loop = haptics::HapticLoop::create({tools, inputs, supervisor, safety, scenes, listener});
    if (!loop)
        qFatal("%s", loop.error().message.c_str());
    inputs.post({core::CommandKind::start, 0});
    realtime::TickSource source;
    const auto longest =
        static_cast<std::uint64_t>(1000.0 * p.trials * (p.trialLimit_s + p.betweenTrials_s + 20.0));
    while (source.executed() < longest &&
           (*loop)->tick(source.next(static_cast<std::int64_t>(source.executed()) * 1'000'000)))
        ;
    PalpationOutcome out{listener.finished(), listener.digest(), listener.trials(), {}};
    for (const simulation::PalpationTrial& planned : simulation::planPalpationTrials(p, seed)) {
        std::vector<simulation::Lump> lumps(planned.list().begin(), planned.list().end());
        if (out.lumps.size() < out.trials.size() && out.trials[out.lumps.size()].moved)
            for (simulation::Lump& lump : lumps)
                lump.place_m = simulation::palpationMovedPlace_m(p, lump.place_m);
        out.lumps.push_back(std::move(lumps));
    }
    return out;
}

/// What a session adds to the counts.
inline void countSession(Detection& d, const simulation::PalpationParameters& p,
                         const PalpationOutcome& outcome) {
    for (std::size_t i = 0; i < outcome.trials.size() && i < outcome.lumps.size(); ++i)
        countTrial(d, p, outcome.lumps[i], outcome.trials[i].book.list());
}

} // namespace chiron::support
