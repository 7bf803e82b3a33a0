// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_repository.h"

#include "catalogue/canonical_json.h"
#include "catalogue/study_json.h"
#include "core/clock.h"
#include "database/access/writer_only.h"
#include "database/accounts/account_rules.h"
#include "database/audit/audit_trail.h"
#include "database/audit/site_key.h"
#include "database/integrity/digested_row.h"
#include "database/repositories/study_rules.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>
#include <set>

// Designing a study: drafts, freezing, closing, unblinding. Participants are in study_participants.cpp, runs
// in study_runs.cpp.
namespace chiron::database {
namespace {

constexpr int kMaximumTitle = 500;
constexpr int kMaximumReason = 500;

core::Result<void> checkKey(const std::string& key) {
    static const QRegularExpression kKey(QStringLiteral("^[a-z][a-z0-9_]{0,63}$"));
    return kKey.match(QString::fromStdString(key)).hasMatch()
               ? core::Result<void>()
               : core::fail(core::ErrorCode::badInput,
                            "study \"" + key + "\": expected an id in snake_case of at most 64 characters");
}

// A condition's code is derived from the site's key, so that a reader of the design cannot tell which is
// which.
RowDigest conditionDigest(const SiteKey& key, const StoredStudy& study, const QJsonObject& design,
                          const std::string& condition) {
    const std::string text = "chiron-sealed-condition-1\n" + std::to_string(study.id) + "\n" + study.key +
                             "\n" + catalogue::canonicalJson(design["seed"]) + "\n" + condition;
    return key.mac({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

core::Result<void> sealConditions(Connection& connection, const StoredStudy& study,
                                  const QJsonObject& design) {
    const SiteKey* key = connection.siteKey();
    if (key == nullptr) {
        return core::fail(core::ErrorCode::storage,
                          connection.file() + ": no site key, so nothing can be sealed");
    }
    std::set<std::string> taken;
    std::int64_t ordinal = 0;
    for (const std::string& condition : conditionIds(design)) {
        RowDigest digest = conditionDigest(*key, study, design, condition);
        int attempt = 0;
        while (!taken.insert(codeFrom(digest, attempt)).second) {
            digest = ++attempt % 5 == 0 ? key->mac(digest) : digest;
        }
        const auto row = insertRow(connection, "study_condition",
                                   {{"study_id", study.id},
                                    {"ordinal", ordinal++},
                                    {"condition", condition},
                                    {"sealed_code", codeFrom(digest, attempt)}});
        CHIRON_TRY(row);
    }
    return {};
}

// Refuses designs that cannot be blinded: with an order fixed by the design, or with exercises that are
// visible in any list of sessions.
core::Result<void> canBeBlind(const psychophysics::StudyDesign& design) {
    if (!design.blindExperimenter || design.conditions.size() < 2) {
        return {};
    }
    if (design.order == psychophysics::OrderDesign::fixed) {
        return core::fail(core::ErrorCode::badInput,
                          "study " + design.id +
                              ": $.order: \"fixed\": expected another order where "
                              "experimenters are blind: a fixed one tells which code is which condition");
    }
    const auto apex = [](const psychophysics::Condition& each) {
        return each.stimulus.attribute == psychophysics::Attribute::apex;
    };
    const auto apexes = std::count_if(design.conditions.begin(), design.conditions.end(), apex);
    if (apexes != 0 && apexes != static_cast<std::ptrdiff_t>(design.conditions.size())) {
        return core::fail(core::ErrorCode::badInput,
                          "study " + design.id +
                              ": $.conditions: \"apex\" beside other attributes: expected "
                              "one exercise where experimenters are blind: the list of sessions names it");
    }
    return {};
}

// Returns the JSON to be frozen: the design as the program understands it, written out. A study that could
// not be run is not frozen.
core::Result<std::string> frozenJson(const StoredStudy& study) {
    const auto design =
        catalogue::readStudy(QByteArray::fromStdString(study.designJson), "study " + study.key);
    CHIRON_TRY(design);
    if (design->id != study.key) {
        return core::fail(core::ErrorCode::badInput, "study " + study.key + ": $.id: \"" + design->id +
                                                         "\": expected \"" + study.key +
                                                         "\", the key it was made with");
    }
    CHIRON_TRY(canBeBlind(*design));
    return catalogue::studyJson(*design).toStdString();
}

// Changes a state or mark of a study and audits it.
core::Result<void> changeStudy(Connection& connection, const Actor& actor, StudyNumber study,
                               std::string_view action, std::vector<Column> changes,
                               const std::string& detail = "{}") {
    const auto row = updateRow(connection, "study", {{"id", study}}, std::move(changes));
    CHIRON_TRY(row);
    return appendAudit(connection, actor, {action, "study", study, *row, detail});
}

} // namespace

core::Result<StudyNumber> StudyRepository::createStudy(const std::string& key, const std::string& title,
                                                       const std::string& designJson) {
    CHIRON_TRY(requireWriter(m_connection));
    auto good = authoriseFor(m_connection, m_actor, Action::createStudy, m_actor.personId());
    good = good ? checkKey(key) : good;
    good = good ? checkText("title", title, kMaximumTitle) : good;
    CHIRON_TRY(good);
    const auto design = designObject(designJson);
    CHIRON_TRY(design);
    const bool simulated = m_actor.personId() == Actor::kSimulatedPerson;
    const auto taken =
        selectInteger(m_connection, "SELECT id FROM study WHERE key = ? AND (author_id = 1) = ?",
                      {key, std::int64_t{simulated}});
    const auto last = selectInteger(m_connection, "SELECT max(id) FROM study");
    const auto demonstration = selectText(m_connection, "SELECT value FROM meta WHERE key = 'demonstration'");
    CHIRON_TRY(taken);
    CHIRON_TRY(last);
    CHIRON_TRY(demonstration);
    if (*taken) {
        return core::fail(core::ErrorCode::badInput, "study \"" + key + "\": there is one already (number " +
                                                         std::to_string(**taken) + "); expected another id");
    }
    const StudyNumber id = last->value_or(0) + 1;
    const auto row = insertRow(m_connection, "study",
                               {{"id", id},
                                {"key", key},
                                {"title", title},
                                {"state", std::string("draft")},
                                {"design_json", catalogue::canonicalJson(*design)},
                                {"author_id", m_actor.personId()},
                                {"created_utc", core::utcNowIso8601()},
                                {"frozen_utc", std::string()},
                                {"unblinded", std::int64_t{0}},
                                {"archived", std::int64_t{0}},
                                {"demonstration", std::int64_t{demonstration->value_or("0") == "1"}}});
    CHIRON_TRY(row);
    auto audited = appendAudit(m_connection, m_actor, {"createStudy", "study", id, *row, "{}"});
    CHIRON_TRY(audited);
    return id;
}

core::Result<void> StudyRepository::saveDraft(StudyNumber study, const std::string& designJson) {
    auto allowed = mayWriteStudy(m_connection, m_actor, Action::saveDraft, StudyPart::study, study);
    CHIRON_TRY(allowed);
    const auto stored = studyInState(m_connection, study, "draft");
    CHIRON_TRY(stored);
    const auto design = designObject(designJson);
    CHIRON_TRY(design);
    std::vector<Column> changes{{"design_json", catalogue::canonicalJson(*design)}};
    const std::string title = (*design)["title"].toObject()["en"].toString().toStdString();
    if (!title.empty() && checkText("title", title, kMaximumTitle)) {
        changes.push_back({"title", title});
    }
    return changeStudy(m_connection, m_actor, study, "saveDraft", std::move(changes));
}

core::Result<std::string> StudyRepository::freezeStudy(StudyNumber study) {
    auto done = mayWriteStudy(m_connection, m_actor, Action::freezeStudy, StudyPart::study, study);
    CHIRON_TRY(done);
    const auto stored = studyInState(m_connection, study, "draft");
    CHIRON_TRY(stored);
    const auto json = frozenJson(*stored);
    CHIRON_TRY(json);
    const auto design = designObject(*json);
    CHIRON_TRY(design);
    done = sealConditions(m_connection, *stored, *design);
    CHIRON_TRY(done);
    const auto seal = conditionSeal(m_connection, study);
    CHIRON_TRY(seal);
    const std::string sha256 = catalogue::sha256Hex(*json);
    const QByteArray bytes = QByteArray::fromHex(QByteArray::fromStdString(sha256));
    done = changeStudy(m_connection, m_actor, study, "freezeStudy",
                       {{"state", std::string("frozen")},
                        {"design_json", *json},
                        {"title", (*design)["title"].toObject()["en"].toString().toStdString()},
                        {"sha256", Blob(bytes.begin(), bytes.end())},
                        {"frozen_utc", core::utcNowIso8601()}},
                       "{\"conditions\":\"" + hex(seal->data(), seal->size()) + "\",\"sha256\":\"" + sha256 +
                           "\"}");
    CHIRON_TRY(done);
    return sha256;
}

core::Result<void> StudyRepository::closeStudy(StudyNumber study) {
    auto allowed = mayWriteStudy(m_connection, m_actor, Action::closeStudy, StudyPart::study, study);
    CHIRON_TRY(allowed);
    const auto stored = studyInState(m_connection, study, "frozen");
    CHIRON_TRY(stored);
    return changeStudy(m_connection, m_actor, study, "closeStudy", {{"state", std::string("closed")}});
}

core::Result<void> StudyRepository::setStudyArchived(StudyNumber study, bool archived) {
    auto allowed = mayWriteStudy(m_connection, m_actor, Action::setStudyArchived, StudyPart::study, study);
    return allowed ? changeStudy(m_connection, m_actor, study, archived ? "archiveStudy" : "unarchiveStudy",
                                 {{"archived", std::int64_t{archived}}})
                   : allowed;
}

core::Result<void> StudyRepository::unblindStudy(StudyNumber study, const std::string& reason) {
    auto allowed = mayWriteStudy(m_connection, m_actor, Action::unblindStudy, StudyPart::study, study);
    CHIRON_TRY(allowed);
    const auto stored = storedStudy(m_connection, study);
    CHIRON_TRY(stored);
    if (stored->state == "draft") {
        return core::fail(core::ErrorCode::wrongUse,
                          "study " + stored->key + " is a draft: there is nothing to unblind");
    }
    CHIRON_TRY(checkText("reason", reason, kMaximumReason));
    if (QString::fromStdString(reason).trimmed().isEmpty()) {
        return core::fail(core::ErrorCode::badInput,
                          "reason: none given; expected why study " + stored->key + " is unblinded now");
    }
    const QJsonObject detail{{"reason", QString::fromStdString(reason)}};
    return changeStudy(m_connection, m_actor, study, "unblindStudy", {{"unblinded", std::int64_t{1}}},
                       QJsonDocument(detail).toJson(QJsonDocument::Compact).toStdString());
}

} // namespace chiron::database
