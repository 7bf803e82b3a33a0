// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_progress_state.h"

#include "core/random.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace chiron::session {

using psychophysics::Condition;
using psychophysics::Task;

namespace {

const Condition* find(const psychophysics::StudyDesign& design, const std::string& id) {
    for (const Condition& condition : design.conditions)
        if (condition.id == id)
            return &condition;
    return nullptr;
}

constexpr std::string_view kLimitWord = "limit@";

/// The shortest digits that read back as the same number, independently of the locale.
std::string limitWord(double limit) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), limit).ptr;
    return "," + std::string(kLimitWord) + std::string(digits.data(), end);
}

} // namespace

StudyProgress::StudyProgress(std::unique_ptr<State> state) : m_state(std::move(state)) {}
StudyProgress::StudyProgress(StudyProgress&&) noexcept = default;
StudyProgress& StudyProgress::operator=(StudyProgress&&) noexcept = default;
StudyProgress::~StudyProgress() = default;

core::Result<StudyProgress> StudyProgress::begin(const psychophysics::StudyDesign& design,
                                                 const std::string& condition, std::uint64_t seed,
                                                 double limit) {
    const Condition* found = find(design, condition);
    if (!found || found->procedures.empty() || found->stimulus.differences.empty())
        return core::fail(core::ErrorCode::badInput,
                          "condition \"" + condition +
                              "\": one of the study's, with differences and a procedure, is expected");
    auto state = std::make_unique<State>();
    state->condition = *found;
    state->rules = design.trial;
    state->repeatsAtMost = std::max(1, design.fidelity.repeatsAtMost);
    state->seed = seed;
    state->limit = limit;
    for (std::size_t i = 0; i < found->stimulus.differences.size(); ++i)
        if (std::abs(found->stimulus.differences[i]) <= limit &&
            std::isfinite(state->scaled(found->stimulus.differences[i])))
            state->allowed.push_back(static_cast<int>(i));
    if (state->allowed.empty())
        return core::fail(core::ErrorCode::badInput,
                          "condition \"" + condition + "\": the device renders none of its differences");
    for (std::size_t i = 0; i < found->procedures.size(); ++i) {
        auto procedure = psychophysics::makeProcedure(
            found->procedures[i], core::Random::mix(seed, "study.procedure " + std::to_string(i)));
        if (!procedure)
            return core::fail(procedure.error().code,
                              "condition \"" + condition + "\": " + procedure.error().message);
        if (const int told = (*procedure)->outcomes();
            told != 2 && told != psychophysics::outcomes(found->task))
            return core::fail(core::ErrorCode::badInput,
                              "condition \"" + condition + "\": this procedure is of " +
                                  std::to_string(told) + " outcomes, the task has " +
                                  std::to_string(psychophysics::outcomes(found->task)));
        state->procedures.push_back(std::move(*procedure));
    }
    state->asked.assign(state->procedures.size(), 0);
    return StudyProgress(std::move(state));
}

core::Result<StudyProgress> StudyProgress::resume(const psychophysics::StudyDesign& design,
                                                  const std::string& condition, std::uint64_t seed,
                                                  const std::vector<database::StudyTrial>& trials,
                                                  double limit) {
    auto progress = begin(design, condition, seed, limit);
    CHIRON_TRY(progress);
    for (const database::StudyTrial& trial : trials) {
        if (progress->needsExperimenter())
            // The run continued, since otherwise there would be no further trial.
            progress->experimenterSays(true);
        CHIRON_TRY(progress->m_state->apply(trial));
    }
    State& state = *progress->m_state;
    // The interruption counts as a break.
    state.breaksTaken = state.rules.breakEvery > 0 ? state.scored / state.rules.breakEvery : 0;
    if (state.asksExperimenter)
        progress->experimenterSays(true); // resuming the run implies that it goes on
    return progress;
}

bool StudyProgress::done() const {
    return m_state->allDone();
}

bool StudyProgress::practising() const {
    return !done() && m_state->practises();
}

bool StudyProgress::breakDue() const {
    const int every = m_state->rules.breakEvery;
    return every > 0 && !done() && m_state->scored / every > m_state->breaksTaken;
}

void StudyProgress::breakTaken() {
    ++m_state->breaksTaken;
}

StudyPresentation StudyProgress::next() const {
    return m_state->present();
}

int StudyProgress::presentable(double difference) const {
    const auto& table = m_state->condition.stimulus.differences;
    return *std::min_element(m_state->allowed.begin(), m_state->allowed.end(), [&](int a, int b) {
        return std::abs(table[static_cast<std::size_t>(a)] - difference) <
               std::abs(table[static_cast<std::size_t>(b)] - difference);
    });
}

core::Result<database::StudyTrial> StudyProgress::record(const StudyAnswer& answer) {
    if (done())
        return core::fail(core::ErrorCode::wrongUse, "the run is done");
    const StudyPresentation shown = next();
    const Task task = m_state->condition.task;
    if (answer.answer >= psychophysics::answers(task))
        return core::fail(core::ErrorCode::badInput, "answer " + std::to_string(answer.answer) + ": 0 to " +
                                                         std::to_string(psychophysics::answers(task) - 1) +
                                                         " is expected");
    database::StudyTrial trial;
    trial.ordinal = shown.ordinal;
    trial.procedure = shown.procedure;
    trial.session = answer.session;
    trial.firstTick = answer.firstTick;
    trial.lastTick = answer.lastTick;
    trial.candidate = shown.candidate;
    trial.arrangement = shown.arrangement;
    trial.difference = shown.difference;
    trial.entropyMargin = shown.entropyMargin;
    trial.answer = std::max(-1, answer.answer);
    trial.value = answer.value;
    trial.exploration_s = answer.exploration_s;
    trial.answer_s = answer.answer_s;
    trial.practice = shown.practice;
    trial.spoiled = !answer.spoiled.empty() ? answer.spoiled
                    : answer.answer < 0     ? "time"
                                            : answer.fidelity.outside;
    trial.fidelityJson = fidelityJson(answer.fidelity);
    const bool counts = !trial.practice && trial.spoiled.empty();
    if (counts)
        trial.outcome = psychophysics::correctAnswer(task, shown.arrangement) < 0
                            ? 1
                            : psychophysics::outcomeOf(task, shown.arrangement, answer.answer);
    CHIRON_TRY(m_state->apply(trial));
    return trial;
}

std::vector<psychophysics::ProcedureEstimate> StudyProgress::estimates() const {
    std::vector<psychophysics::ProcedureEstimate> out;
    for (const auto& procedure : m_state->procedures)
        out.push_back(procedure->estimate());
    return out;
}

std::vector<const psychophysics::Procedure*> StudyProgress::procedures() const {
    std::vector<const psychophysics::Procedure*> out;
    for (const auto& procedure : m_state->procedures)
        out.push_back(procedure.get());
    return out;
}

bool StudyProgress::needsExperimenter() const {
    return m_state->asksExperimenter && !m_state->stopped;
}

void StudyProgress::experimenterSays(bool goOn) {
    m_state->asksExperimenter = false;
    m_state->repeat = 0;
    m_state->stopped = m_state->stopped || !goOn;
}

bool StudyProgress::gaveUp() const {
    return m_state->stopped;
}
int StudyProgress::scored() const {
    return m_state->scored;
}
int StudyProgress::spoiledTrials() const {
    return m_state->spoiled;
}

int StudyProgress::toCome() const {
    const int of = m_state->present().ofAtMost;
    return done() || of == 0 ? 0
                             : std::max(0, m_state->rules.practiceTrials - m_state->practised) +
                                   std::max(0, of - m_state->scored);
}

std::string StudyProgress::procedureIds() const {
    std::string ids;
    for (const auto& procedure : m_state->procedures)
        ids += (ids.empty() ? "" : ",") + std::string(procedure->id());
    return std::isfinite(m_state->limit) ? ids + limitWord(m_state->limit) : ids;
}

double StudyProgress::limitOf(const std::string& procedureIds) {
    const auto at = procedureIds.find(kLimitWord);
    double limit = kNoLimit;
    if (at != std::string::npos)
        std::from_chars(procedureIds.data() + at + kLimitWord.size(),
                        procedureIds.data() + procedureIds.size(), limit);
    return limit;
}

} // namespace chiron::session
