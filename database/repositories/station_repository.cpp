// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/station_repository.h"

#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/audit/audit_trail.h"
#include "database/query.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace chiron::database {

namespace {

constexpr std::size_t kLongest = 200;

/// Returns whether a text is printable ASCII: tokens and versions, no free text.
bool isPlain(const std::string& word) {
    return word.size() <= kLongest &&
           std::all_of(word.begin(), word.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

} // namespace

core::Result<std::int64_t> StationRepository::recordStationCheck(const StationCheck& check) {
    CHIRON_TRY(requireWriter(m_connection));
    CHIRON_TRY(authorise(m_connection, m_actor, Action::recordStationCheck));
    if (check.what.empty() || check.build.empty() || !isPlain(check.what) || !isPlain(check.driver) ||
        !isPlain(check.build) || !isPlain(check.serial)) {
        return core::fail(
            core::ErrorCode::badInput,
            "station check: expected what was checked and the program's build, in printable ASCII");
    }
    QJsonObject detail{{"what", QString::fromStdString(check.what)},
                       {"driver", QString::fromStdString(check.driver)},
                       {"build", QString::fromStdString(check.build)},
                       {"passed", check.passed}};
    if (!check.serial.empty()) {
        detail.insert("serial", QString::fromStdString(check.serial));
    }
    const auto added = appendAudit(m_connection, m_actor,
                                   {"recordStationCheck", "meta", 0, std::nullopt,
                                    QJsonDocument(detail).toJson(QJsonDocument::Compact).toStdString()});
    CHIRON_TRY(added);
    const auto last = selectInteger(m_connection, "SELECT max(sequence) FROM audit");
    CHIRON_TRY(last);
    return last->value_or(0);
}

} // namespace chiron::database
