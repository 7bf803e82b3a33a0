// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/privacy/erasure.h"

#include "catalogue/whole_file.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <algorithm>

namespace chiron::database {
namespace {

QJsonObject jsonOf(const Erasure& erasure) {
    QJsonObject json{{"person", static_cast<qint64>(erasure.person)},
                     {"person_created_utc", QString::fromStdString(erasure.personCreated_utc)},
                     {"utc", QString::fromStdString(erasure.utc)},
                     {"reason", QString::fromStdString(erasure.reason)},
                     {"administrator", static_cast<qint64>(erasure.administrator)},
                     {"recordings_withdrawn", erasure.recordingsWithdrawn},
                     {"digests", QString::fromStdString(erasure.digestsJson)}};
    if (!erasure.participantCode.empty()) {
        json["participant_code"] = QString::fromStdString(erasure.participantCode);
    }
    return json;
}

} // namespace

core::Result<std::vector<Erasure>> readErasureList(const std::string& name) {
    constexpr qint64 kLargest_bytes = 64 << 20; // at 300 bytes per erasure
    if (!QFile::exists(QString::fromStdString(name))) {
        return std::vector<Erasure>();
    }
    const auto text = catalogue::readWholeFile(QString::fromStdString(name), kLargest_bytes);
    if (!text) {
        // Whatever the reason, the erasure can continue later.
        return core::fail(core::ErrorCode::storage, text.error().message);
    }
    const QJsonDocument document = QJsonDocument::fromJson(*text);
    if (!document.isArray()) {
        return core::fail(core::ErrorCode::badInput, name + ": expected a JSON array of erasures");
    }
    std::vector<Erasure> erasures;
    for (const QJsonValue& value : document.array()) {
        const QJsonObject json = value.toObject();
        const Erasure erasure{json["person"].toInteger(),
                              json["person_created_utc"].toString().toStdString(),
                              json["utc"].toString().toStdString(),
                              json["reason"].toString().toStdString(),
                              json["administrator"].toInteger(),
                              json["recordings_withdrawn"].toBool(),
                              json["digests"].toString().toStdString(),
                              json["participant_code"].toString().toStdString()};
        if (erasure.participantCode.empty() && erasure.person <= Actor::kSimulatedPerson) {
            return core::fail(core::ErrorCode::badInput, name + ": an erasure names no person");
        }
        erasures.push_back(erasure);
    }
    return erasures;
}

void putErasure(std::vector<Erasure>& list, const Erasure& erasure) {
    std::erase_if(list, [&](const Erasure& e) {
        return e.participantCode == erasure.participantCode &&
               isAbout(e, erasure.person, erasure.personCreated_utc);
    });
    list.push_back(erasure);
}

core::Result<void> saveErasureList(const std::string& name, const std::vector<Erasure>& erasures) {
    QJsonArray array;
    for (const Erasure& erasure : erasures) {
        array.append(jsonOf(erasure));
    }
    QSaveFile file(QString::fromStdString(name));
    const QByteArray text = QJsonDocument(array).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        return core::fail(core::ErrorCode::storage, name + ": the list of erasures cannot be written");
    }
    return {};
}

core::Result<void> writeErasureList(const std::string& siteFolder, const Erasure& erasure) {
    auto erasures = readErasureList(erasureListFile(siteFolder));
    CHIRON_TRY(erasures);
    putErasure(*erasures, erasure);
    return saveErasureList(erasureListFile(siteFolder), *erasures);
}

} // namespace chiron::database
