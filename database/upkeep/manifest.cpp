// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/upkeep/manifest.h"

#include "catalogue/whole_file.h"
#include "database/interruptible.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <sodium.h>

namespace chiron::database {
namespace {

std::string signatureOf(const QJsonObject& json, const SiteKey& key) {
    const QByteArray text =
        "chiron-manifest-1" + QJsonDocument(json).toJson(QJsonDocument::Compact); // keys are sorted
    const RowDigest mac = key.mac(
        {reinterpret_cast<const std::uint8_t*>(text.constData()), static_cast<std::size_t>(text.size())});
    return hex(mac.data(), mac.size());
}

} // namespace

core::Result<std::string> fileDigest(const std::string& name, const std::atomic<bool>* cancel) {
    QFile file(QString::fromStdString(name));
    if (!QFileInfo(file).isFile() || !file.open(QIODevice::ReadOnly)) { // a device has no end
        return core::fail(core::ErrorCode::storage, name + ": cannot be read");
    }
    RowDigest digest{};
    crypto_generichash_state state;
    crypto_generichash_init(&state, nullptr, 0, digest.size());
    while (!file.atEnd()) {
        if (isSet(cancel)) {
            return core::fail(core::ErrorCode::cancelled, name + ": stopped");
        }
        const QByteArray part = file.read(1 << 20);
        if (part.isEmpty()) {
            return core::fail(core::ErrorCode::storage, name + ": cannot be read to its end");
        }
        crypto_generichash_update(&state, reinterpret_cast<const unsigned char*>(part.constData()),
                                  static_cast<unsigned long long>(part.size()));
    }
    crypto_generichash_final(&state, digest.data(), digest.size());
    return hex(digest.data(), digest.size());
}

core::Result<void> writeManifest(const std::string& folder, const Manifest& manifest, const SiteKey& key) {
    QJsonObject files;
    for (const auto& [name, digest] : manifest.files) {
        files[QString::fromStdString(name)] = QString::fromStdString(digest);
    }
    QJsonObject json{{"kind", QString::fromStdString(manifest.kind)},
                     {"created_utc", QString::fromStdString(manifest.createdUtc)},
                     {"schema_version", manifest.schemaVersion},
                     {"audit_count", static_cast<qint64>(manifest.head.count)},
                     {"audit_hash", QString::fromStdString(manifest.head.hash)},
                     {"files", files}};
    if (manifest.automaticNumber > 0) {
        json["automatic_number"] = static_cast<qint64>(manifest.automaticNumber);
    }
    json["signature"] = QString::fromStdString(signatureOf(json, key));
    const std::string name = folder + "/manifest.json";
    QSaveFile file(QString::fromStdString(name));
    const QByteArray text = QJsonDocument(json).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        return core::fail(core::ErrorCode::storage, name + ": cannot be written (disk full?)");
    }
    return {};
}

core::Result<Manifest> readSignedManifest(const std::string& folder, const SiteKey& key) {
    const std::string name = folder + "/manifest.json";
    const auto text = catalogue::readWholeFile(QString::fromStdString(name), kLargestManifest_bytes);
    if (core::failedAs(text, core::ErrorCode::notFound)) {
        return core::fail(core::ErrorCode::notFound, name + ": there is no backup (no manifest)");
    }
    CHIRON_TRY(text);
    QJsonObject json = QJsonDocument::fromJson(*text).object();
    const std::string signature = json.take("signature").toString().toStdString();
    if (json.isEmpty() || signature.empty()) {
        return core::fail(core::ErrorCode::badInput, name + ": malformed");
    }
    if (signature != signatureOf(json, key)) {
        return core::fail(core::ErrorCode::doesNotHold,
                          name + ": not signed with this site's key, or changed");
    }
    Manifest manifest{json["kind"].toString().toStdString(),
                      json["created_utc"].toString().toStdString(),
                      json["schema_version"].toInt(),
                      {json["audit_count"].toInteger(), json["audit_hash"].toString().toStdString()},
                      {},
                      json["automatic_number"].toInteger()};
    const QJsonObject files = json["files"].toObject();
    for (auto it = files.begin(); it != files.end(); ++it) {
        manifest.files[it.key().toStdString()] = it.value().toString().toStdString();
    }
    return manifest;
}

core::Result<Manifest> readManifest(const std::string& folder, const SiteKey& key,
                                    const std::atomic<bool>* cancel) {
    auto manifest = readSignedManifest(folder, key);
    CHIRON_TRY(manifest);
    for (const auto& [path, expected] : manifest->files) {
        const auto digest = fileDigest(folder + "/" + path, cancel);
        if (core::failedAs(digest, core::ErrorCode::cancelled)) {
            CHIRON_TRY(digest);
        }
        if (!digest || *digest != expected) {
            return core::fail(core::ErrorCode::doesNotHold,
                              folder + "/" + path + ": missing or changed since the backup was made");
        }
    }
    return manifest;
}

} // namespace chiron::database
