// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_rules.h"

#include "core/clock.h"
#include "database/access/writer_only.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/query.h"

#include <array>
#include <sodium.h>

namespace chiron::database {
namespace {

// Without symbols that look alike: 0 O, 1 I L, 2 Z, 5 S, 8 B, U V.
constexpr std::string_view kLetters = "ACDEFGHJKMNPQRTWXY34679";
constexpr std::array<std::string_view, 4> kStudyStates{"draft", "frozen", "closed", "archived"};
constexpr std::array<std::string_view, 4> kParticipantStates{"enrolled", "consented", "completed",
                                                             "withdrawn"};
constexpr std::array<std::string_view, 3> kRunStates{"open", "completed", "stopped"};

template <class State, std::size_t n>
std::optional<State> stateOf(const std::array<std::string_view, n>& words, std::string_view word) noexcept {
    for (std::size_t i = 0; i < n; ++i) {
        if (words[i] == word) {
            return static_cast<State>(i);
        }
    }
    return std::nullopt;
}

core::Result<RowDigest> sealOf(Connection& connection, const std::string& sql, std::int64_t number) {
    auto query = Query::run(connection, sql, {number});
    CHIRON_TRY(query);
    Blob bytes;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        const Blob digest = query->blob(0);
        bytes.insert(bytes.end(), digest.begin(), digest.end());
    }
    CHIRON_TRY(row);
    return bytesDigest(bytes);
}

} // namespace

std::string_view token(StudyState state) noexcept {
    return kStudyStates[static_cast<std::size_t>(state)];
}
std::string_view token(ParticipantState state) noexcept {
    return kParticipantStates[static_cast<std::size_t>(state)];
}
std::string_view token(StudyRunState state) noexcept {
    return kRunStates[static_cast<std::size_t>(state)];
}
std::optional<StudyState> studyStateFromToken(std::string_view word) noexcept {
    return stateOf<StudyState>(kStudyStates, word);
}
std::optional<ParticipantState> participantStateFromToken(std::string_view word) noexcept {
    return stateOf<ParticipantState>(kParticipantStates, word);
}
std::optional<StudyRunState> studyRunStateFromToken(std::string_view word) noexcept {
    return stateOf<StudyRunState>(kRunStates, word);
}

core::Result<void> mayWriteStudy(Connection& connection, const Actor& actor, Action action, StudyPart part,
                                 std::int64_t number) {
    CHIRON_TRY(requireWriter(connection));
    return authoriseForStudy(connection, actor, action, part, number);
}

core::Result<StoredStudy> storedStudy(Connection& connection, StudyNumber study) {
    auto query =
        Query::run(connection, "SELECT id, key, state, design_json FROM study WHERE id = ?", {study});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row) {
        return core::fail(core::ErrorCode::notFound, "there is no study " + std::to_string(study));
    }
    return StoredStudy{query->integer(0), query->text(1), query->text(2), query->text(3)};
}

core::Result<StoredStudy> studyInState(Connection& connection, StudyNumber study, std::string_view state) {
    auto stored = storedStudy(connection, study);
    if (stored && stored->state != state) {
        return core::fail(core::ErrorCode::wrongUse,
                          "study " + stored->key + " is " +
                              (stored->state == "draft" ? "a draft" : stored->state) +
                              ": expected it to be " + (state == "draft" ? "a draft" : std::string(state)));
    }
    return stored;
}

core::Result<StoredParticipant> storedParticipant(Connection& connection, ParticipantNumber participant) {
    auto query = Query::run(connection,
                            "SELECT id, study_id, code, state, simulated FROM study_participant WHERE id = ?",
                            {participant});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    if (!*row) {
        return core::fail(core::ErrorCode::notFound,
                          "there is no participant " + std::to_string(participant));
    }
    return StoredParticipant{query->integer(0), query->integer(1), query->text(2),
                             participantStateFromToken(query->text(3)).value_or(ParticipantState::withdrawn),
                             query->integer(4) != 0};
}

std::string randomCode() {
    std::string code;
    for (int i = 0; i < 6; ++i) {
        code += i == 3 ? "-" : "";
        code += kLetters[randombytes_uniform(static_cast<std::uint32_t>(kLetters.size()))];
    }
    return code;
}

std::string codeFrom(const RowDigest& digest, int attempt) {
    std::string code;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t at = (static_cast<std::size_t>(attempt) * 6 + 2 * i) % (digest.size() - 1);
        const unsigned number = digest[at] * 256U + digest[at + 1];
        code += kLetters[number % kLetters.size()];
    }
    return code;
}

std::string randomNonce() {
    Blob bytes(16);
    randombytes_buf(bytes.data(), bytes.size());
    return hex(bytes);
}

core::Result<RowDigest> runSeal(Connection& connection, StudyRunNumber run) {
    return sealOf(connection, "SELECT digest FROM study_trial WHERE run_id = ? ORDER BY ordinal", run);
}

core::Result<RowDigest> conditionSeal(Connection& connection, StudyNumber study) {
    return sealOf(connection, "SELECT digest FROM study_condition WHERE study_id = ? ORDER BY ordinal",
                  study);
}

core::Result<void> endRun(Connection& connection, const Actor& actor, StudyRunNumber run,
                          StudyRunState state) {
    const auto seal = runSeal(connection, run);
    const auto trials = selectInteger(connection, "SELECT count(*) FROM study_trial WHERE run_id = ?", {run});
    CHIRON_TRY(seal);
    CHIRON_TRY(trials);
    const auto row = updateRow(connection, "study_run", {{"id", run}},
                               {{"state", std::string(token(state))},
                                {"ended_utc", core::utcNowIso8601()},
                                {"trials", trials->value_or(0)},
                                {"seal", toBlob(*seal)}});
    CHIRON_TRY(row);
    return appendAudit(connection, actor,
                       {"finishRun", "study_run", run, *row,
                        "{\"seal\":\"" + hex(seal->data(), seal->size()) + "\",\"state\":\"" +
                            std::string(token(state)) + "\"}"});
}

} // namespace chiron::database
