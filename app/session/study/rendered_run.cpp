// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/rendered_run.h"

#include "core/fp_environment.h"
#include "core/presentation_word.h"
#include "core/random.h"
#include "haptics/haptic_loop.h"
#include "haptics/scene_exchange.h"
#include "realtime/periodic_runner.h"
#include "session/study/study_director.h"
#include "session/study/study_setup.h"
#include "session/training_run.h"
#include "simulation/comparison/comparison_scene.h"

#include <atomic>
#include <cmath>

namespace chiron::session {

namespace {

/// Runs a loop from its first tick to its last, with a director as its only listener.
core::Result<void> runDirected(Station& station, const catalogue::ExerciseLevel& level, std::uint64_t seed,
                               ITickDirector& director) {
    const auto& parameters = level.parameters.as<simulation::ComparisonParameters>();
    CHIRON_TRY(station.tools.front().device->open());
    haptics::LiveInputs inputs;
    director.connect(inputs);
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene =
        std::make_unique<simulation::ComparisonScene>(parameters, seed);
    scenes.offer(scene);
    const haptics::LoopTool tool{*station.tools.front().device, station.tools.front().mapping};
    auto loop = haptics::HapticLoop::create(
        {{&tool, 1}, inputs, supervisor, headlessSafety(level), scenes, director});
    CHIRON_TRY(loop);
    core::setModelFloatingPointEnvironment();
    realtime::TickSource ticks;
    realtime::AsFastRunner runner(ticks);
    std::atomic<bool> stop{false};
    struct Task {
        haptics::HapticLoop& loop;
        bool tick(const realtime::HapticTick& now) noexcept { return loop.tick(now); }
    } task{**loop};
    runner.run(task, stop);
    station.tools.front().device->close();
    return {};
}

/// Presents one candidate in all arrangements in turn and collects the estimates of the participant's
/// decision model.
class NoiseDirector final : public ITickDirector {
public:
    NoiseDirector(operators::IParticipantMind& mind, const simulation::ComparisonParameters& p, int candidate,
                  int trials)
        : m_mind(mind), m_parameters(p), m_candidate(candidate), m_left(trials) {}
    void connect(haptics::LiveInputs& inputs) noexcept override { m_inputs = &inputs; }
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        ++ticks;
        const auto phase = frame.header.phase;
        const bool waits = phase == core::TrialPhase::idle || phase == core::TrialPhase::between;
        if (waits && !m_presented) {
            m_presented = true;
            m_arrangement = static_cast<std::size_t>(m_left) % m_parameters.arrangements.size();
            if (m_left-- == 0)
                m_inputs->postOwn({core::CommandKind::answer, simulation::kAnswerFinish});
            else
                m_inputs->postOwn({core::CommandKind::present,
                                   core::encode({m_candidate, static_cast<int>(m_arrangement)})});
        } else if (phase == core::TrialPhase::running && m_presented && m_mind.explored()) {
            m_presented = false;
            keep();
            m_inputs->postOwn({core::CommandKind::answer, 0});
        }
        return true;
    }
    std::vector<double> found[3];
    int missed = 0;
    std::uint64_t ticks = 0;

private:
    void keep() {
        for (int place = 0; place < m_parameters.places; ++place) {
            const auto multiple = static_cast<std::size_t>(
                m_parameters.arrangements[m_arrangement][static_cast<std::size_t>(place)]);
            const double truth = m_parameters.values[static_cast<std::size_t>(m_candidate)][multiple];
            const double estimate = m_mind.estimate(place);
            if (estimate > 0.0)
                found[multiple].push_back(std::log10(estimate / truth));
            else
                ++missed;
        }
    }
    operators::IParticipantMind& m_mind;
    const simulation::ComparisonParameters& m_parameters;
    int m_candidate;
    int m_left;
    std::size_t m_arrangement = 0;
    bool m_presented = false;
    haptics::LiveInputs* m_inputs = nullptr;
};

} // namespace

std::vector<psychophysics::ScoredTrial> scoredTrials(const psychophysics::Condition& condition,
                                                     const std::vector<database::StudyTrial>& trials) {
    std::vector<psychophysics::ScoredTrial> out;
    for (const database::StudyTrial& trial : trials) {
        if (trial.practice || !trial.spoiled.empty() || trial.outcome < 0)
            continue;
        psychophysics::ScoredTrial scored;
        scored.procedure = trial.procedure;
        scored.arrangement = trial.arrangement;
        scored.answer = trial.answer;
        scored.outcome = trial.outcome;
        const auto candidate = static_cast<std::size_t>(trial.candidate);
        scored.difference = candidate < condition.stimulus.differences.size()
                                ? condition.stimulus.differences[candidate]
                                : trial.difference;
        scored.value = trial.value;
        out.push_back(scored);
    }
    return out;
}

core::Result<RenderedRun> runRendered(const RenderedRunRequest& request) {
    const psychophysics::Condition* condition = conditionOf(request.design, request.condition);
    if (!condition)
        return core::fail(core::ErrorCode::badInput,
                          "condition \"" + request.condition + "\" is not one of the study's");
    auto level = studyLevel(request.design, *condition, request.control);
    CHIRON_TRY(level);
    auto participant = participantStation(*level, core::Random::mix(request.seed, "participant"));
    CHIRON_TRY(participant);
    auto progress = StudyProgress::begin(request.design, request.condition, request.seed);
    CHIRON_TRY(progress);
    psychophysics::SimulatedObserver observer(request.observer, core::Random::mix(request.seed, "observer"));
    FidelityMeter meter(level->parameters.as<simulation::ComparisonParameters>(), request.design.fidelity,
                        request.design.trial.mustTouchAll);
    RenderedRun run;
    int scored = 0;
    StudyDirector director({*progress, *condition, *participant->mind, observer, meter,
                            [&](database::StudyTrial trial) {
                                scored += trial.outcome >= 0 ? 1 : 0;
                                run.trials.push_back(std::move(trial));
                                return true;
                            },
                            [&] { return request.trialsAtMost > 0 && scored >= request.trialsAtMost; },
                            request.design.trial.exploreLimit_s});
    CHIRON_TRY(runDirected(participant->station, *level, request.seed, director));
    CHIRON_TRY(director.recorded());
    run.ticks = director.ticks();
    run.completed = progress->done() && !progress->gaveUp();
    run.procedures = progress->procedureIds();
    if (const auto own = progress->estimates().front(); own.known && !own.parameters.empty())
        run.threshold = own.parameters.front().mean;
    run.estimate = psychophysics::estimateRun(*condition, scoredTrials(*condition, run.trials), request.seed);
    return run;
}

core::Result<RenderingNoise> renderingNoise(const psychophysics::StudyDesign& design,
                                            const std::string& condition, int candidate, int trials,
                                            std::uint64_t seed) {
    const psychophysics::Condition* found = conditionOf(design, condition);
    if (!found || candidate < 0 ||
        static_cast<std::size_t>(candidate) >= found->stimulus.differences.size() || trials < 1)
        return core::fail(
            core::ErrorCode::badInput,
            "a condition of the study, one of its candidates and at least one trial are expected");
    auto level = studyLevel(design, *found);
    CHIRON_TRY(level);
    auto participant = participantStation(*level, core::Random::mix(seed, "participant"));
    CHIRON_TRY(participant);
    NoiseDirector director(*participant->mind, level->parameters.as<simulation::ComparisonParameters>(),
                           candidate, trials);
    CHIRON_TRY(runDirected(participant->station, *level, seed, director));
    RenderingNoise out;
    out.missed = director.missed;
    out.seconds = static_cast<double>(director.ticks) * 1e-3 / trials;
    double squares = 0.0;
    int freedom = 0;
    for (std::size_t m = 0; m < 3; ++m) {
        const auto& values = director.found[m];
        const auto n = static_cast<double>(values.size());
        for (const double value : values)
            out.mean[m] += value / n;
        double sum = 0.0;
        for (const double value : values)
            sum += (value - out.mean[m]) * (value - out.mean[m]);
        if (n > 1.0)
            out.sd[m] = std::sqrt(sum / (n - 1.0));
        squares += sum;
        freedom += std::max(0, static_cast<int>(values.size()) - 1);
        out.explored += static_cast<int>(values.size());
    }
    if (freedom > 0)
        out.pooledSd = std::sqrt(squares / freedom);
    return out;
}

} // namespace chiron::session
