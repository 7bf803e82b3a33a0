// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "cues/laparoscopy_cues.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "haptics/safety_supervisor.h"
#include "scoring/score_calculator.h"
#include "session/channels.h"
#include "session/recorded_quantities.h"
#include "session/session_setup.h"
#include "session/station.h"
#include "session/tool_positions.h"
#include "session/trace_assembler.h"
#include "session/training_run.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

/// A whole session of a scripted laparoscopist at any level of the catalogue, through the real loop, scenes,
/// supervisor and devices, scored as every session is, without a database; with the ways of deceiving that
/// the blind tests need.
namespace chiron::support {

/// What stands between the scene and the laparoscopist.
struct LaparoscopyDeception {
    bool mute = false;   ///< the force channel is zero
    bool hidden = false; ///< objects, tube and target are not shown
    bool noBars = false; ///< tension, squeeze and bands are not shown
};

class DeceivedLaparoscopyScene final : public simulation::IScene {
public:
    DeceivedLaparoscopyScene(std::unique_ptr<simulation::IScene> scene, const LaparoscopyDeception& deception)
        : m_scene(std::move(scene)), m_deception(deception) {}
    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        m_scene->respond(now, in, out);
        core::LaparoscopyCues& cues = out.cues.exercise.own<core::LaparoscopyCues>();
        if (m_deception.hidden) {
            const core::LaparoscopyStep step = cues.step;
            const double dwell = cues.dwell;
            const bool present = cues.present;
            cues = {};
            cues.present = present;
            cues.step = step;
            cues.dwell = dwell;
            out.cues.objectShown = false;
        }
        if (m_deception.noBars) {
            cues.tensionShown = cues.squeezeShown = false;
            cues.tension_N = cues.bandLow_N = cues.bandHigh_N = cues.squeezeLimit_N = 0.0;
            cues.squeeze_N = {};
        }
        if (m_deception.mute) { // what the supervisor knows of the contact goes with the force, or its
                                // damping would tell of it
            for (core::Wrench& tool : out.tissue.tools)
                tool = {};
            out.storedEnergy_J = out.contactStiffness_N_per_m = 0.0;
            out.bodyEnergy_J = {};
            out.bodyStiffness_N_per_m = {};
        }
    }
    simulation::ISlowModel* slowModel() noexcept override { return m_scene->slowModel(); }

private:
    std::unique_ptr<simulation::IScene> m_scene;
    LaparoscopyDeception m_deception;
};

/// A level of the content, with another number of trials if that is not 0.
inline catalogue::ExerciseLevel contentLevel(const std::string& exercise, int number, int trials = 0) {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    const catalogue::ExerciseLevel* level = catalogue->find(exercise, number);
    if (level == nullptr)
        qFatal("%s has no level %d", exercise.c_str(), number);
    if (trials == 0)
        return *level;
    QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(level->resolvedJson)).object();
    QJsonObject inner = json["level"].toObject();
    QJsonObject parameters = inner["parameters"].toObject();
    parameters["trials"] = trials;
    inner["parameters"] = parameters;
    json["level"] = inner;
    auto changed =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
    if (!changed)
        qFatal("%s", changed.error().message.c_str());
    return *changed;
}

struct LaparoscopyOutcome {
    bool ran = false; ///< the session came to its own end
    scoring::SessionTrace trace;
    scoring::ScoreCard card;
    std::uint64_t digest = 0xcbf29ce484222325ULL; ///< FNV over all counts: two runs alike

    int completed() const {
        int n = 0;
        for (const auto& trial : trace.trials)
            n += trial.completed ? 1 : 0;
        return n;
    }
    int failed() const {
        int n = 0;
        for (const auto& trial : trace.trials)
            n += trial.failed ? 1 : 0;
        return n;
    }
    int trials() const { return static_cast<int>(trace.trials.size()); }
    /// The session's value of a metric; NaN where it has none.
    double metric(const std::string& id) const {
        for (const auto& value : card.metrics)
            if (value.id == id && value.value)
                return *value.value;
        return std::numeric_limits<double>::quiet_NaN();
    }
};

struct LaparoscopySession {
    catalogue::ExerciseLevel level;
    std::string operatorName = "expert";
    std::uint64_t seed = 1;
    LaparoscopyDeception deception;
};

/// Hears of every frame; `more` also does, for tables that tell a session's story.
class LaparoscopyRecorder final : public core::IFrameSink {
public:
    LaparoscopyRecorder(session::TraceAssembler& assembler, core::IFrameSink* more)
        : m_assembler(assembler), m_more(more) {
        m_frames.reserve(kChunk);
    }
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        for (std::uint32_t tool = 0; tool < frame.tools; ++tool)
            for (const std::int32_t count : frame.tool[tool].counts)
                digest = (digest ^ static_cast<std::uint32_t>(count)) * 0x100000001b3ULL;
        finished = finished || (frame.header.events & core::event_bits::kFinished) != 0;
        m_frames.push_back(frame);
        if (m_frames.size() == kChunk)
            flush();
        return m_more == nullptr || m_more->tryPush(frame);
    }
    void flush() {
        m_assembler.add(m_frames);
        m_frames.clear();
    }
    std::uint64_t digest = 0xcbf29ce484222325ULL;
    bool finished = false;

private:
    static constexpr std::size_t kChunk = 1000;
    session::TraceAssembler& m_assembler;
    core::IFrameSink* m_more;
    std::vector<core::HapticFrame> m_frames;
};

inline LaparoscopyOutcome runLaparoscopy(const LaparoscopySession& asked, core::IFrameSink* more = nullptr) {
    const auto kind = session::exerciseKind(asked.level.exercise);
    if (!kind)
        qFatal("%s", kind.error().message.c_str());
    auto station = session::scriptedStation(**kind, asked.level, asked.operatorName, asked.seed);
    if (!station)
        qFatal("%s", station.error().message.c_str());
    session::SessionSetup setup;
    setup.level = asked.level;
    setup.seed = asked.seed;
    setup.mappings = station->mappings();
    setup.safety = session::headlessSafety(asked.level);
    std::vector<haptics::LoopTool> tools;
    for (std::size_t i = 0; i < station->tools.size(); ++i) {
        setup.devices.push_back(station->tools[i].device->descriptor());
        tools.push_back({*station->tools[i].device, station->tools[i].mapping});
        if (auto opened = station->tools[i].device->open(); !opened)
            qFatal("%s", opened.error().message.c_str());
    }
    const auto positions = session::ToolPositions::create(setup);
    if (!positions)
        qFatal("%s", positions.error().message.c_str());
    const auto table = session::channelTableFor(setup);
    if (!table)
        qFatal("%s", table.error().message.c_str());
    session::TraceAssembler assembler(**positions, (*positions)->tools(), positions->get(),
                                      session::RecordedQuantities(*table));
    LaparoscopyRecorder recorder(assembler, more);
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene =
        std::make_unique<DeceivedLaparoscopyScene>((*kind)->makeScene(setup), asked.deception);
    scenes.offer(scene);
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    auto loop = haptics::HapticLoop::create({tools, inputs, supervisor, setup.safety, scenes, recorder});
    if (!loop)
        qFatal("%s", loop.error().message.c_str());
    inputs.post({core::CommandKind::start, 0});
    realtime::TickSource source;
    while (source.executed() < (*kind)->tickLimit(asked.level) &&
           (*loop)->tick(source.next(static_cast<std::int64_t>(source.executed()) * 1'000'000)))
        ;
    recorder.flush();
    LaparoscopyOutcome outcome;
    outcome.ran = recorder.finished;
    outcome.digest = recorder.digest;
    outcome.trace.exercise = asked.level.exercise;
    outcome.trace.forceLimit_N = (*kind)->forceLimit_N(asked.level);
    outcome.trace.trials = assembler.takeTrials();
    for (scoring::TrialTrace& trial : outcome.trace.trials)
        (*kind)->addTruth(asked.level, asked.seed, trial);
    std::vector<scoring::MetricRequest> requests;
    for (const catalogue::MetricChoice& metric : asked.level.metrics)
        requests.push_back({metric.id, metric.version});
    auto card = scoring::calculateScore(outcome.trace, requests, asked.level.gates, outcome.ran);
    if (!card)
        qFatal("%s", card.error().message.c_str());
    outcome.card = std::move(*card);
    return outcome;
}

} // namespace chiron::support
