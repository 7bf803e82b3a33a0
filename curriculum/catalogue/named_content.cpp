// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/named_content.h"

#include "catalogue/json_file.h"

#include <QDir>
#include <QFileInfo>

namespace chiron::catalogue {

namespace {

Problem unknownName(const QString& path, const QString& name, const std::map<QString, QJsonObject>& named) {
    std::vector<QString> known;
    for (const auto& [one, ignored] : named)
        known.push_back(one);
    const QString all = QStringList(known.begin(), known.end()).join(QStringLiteral(", "));
    return {path, quoted(name), QStringLiteral("one of ") + all + didYouMean(name, known)};
}

} // namespace

core::Result<NamedContent> NamedContent::read(const QString& directory,
                                              const std::vector<std::string>& languages) {
    NamedContent content;
    for (const NamedKind& kind : kNamedKinds)
        CHIRON_TRY(content.readFolder(directory, languages, kind));
    return content;
}

core::Result<void> NamedContent::readFolder(const QString& directory,
                                            const std::vector<std::string>& languages,
                                            const NamedKind& kind) {
    const QDir folder(directory + '/' + QLatin1String(kind.folder));
    m_named[QLatin1String(kind.key)] = {};
    const QFileInfoList files = folder.entryInfoList({"*.json"}, QDir::Files, QDir::Name);
    if (files.empty())
        return {};
    const auto file = readSchema(directory + "/schema", QLatin1String(kind.key));
    const auto content = readSchema(directory + "/schema", QLatin1String(kind.contentSchema));
    for (const auto* schema : {&file, &content})
        CHIRON_TRY(*schema);
    auto texts = ContentTexts::read(folder.path(), languages);
    CHIRON_TRY(texts);
    for (const QFileInfo& path : files)
        CHIRON_TRY(readNamed(QDir::cleanPath(path.filePath()), kind, *file, *content, *texts));
    m_missing.insert(m_missing.end(), texts->missing().begin(), texts->missing().end());
    return texts->finish();
}

core::Result<void> NamedContent::readNamed(const QString& path, const NamedKind& kind, const Schema& file,
                                           const Schema& content, ContentTexts& texts) {
    const auto json = JsonFile::read(path, JsonFile::kMeshMebibytes);
    CHIRON_TRY(json);
    const QString member = QLatin1String(kind.member);
    const QString at = memberPath(QStringLiteral("$"), member);
    const QString key = QLatin1String(kind.key);
    const QString id = QFileInfo(path).completeBaseName();
    Problems problems;
    QJsonObject root = json->root();
    QJsonObject numbers = root[member].toObject();
    if (numbers.contains(key))
        problems.push_back(
            {memberPath(at, key), QStringLiteral("given"), QStringLiteral("none: it names no other")});
    numbers.insert(key, id);
    const QJsonObject full = validated(numbers, content, at, problems).toObject();
    if (root[member].isObject())
        root[member] = QJsonObject{}; // the file's own schema knows only that it is an object
    root = validated(root, file, QStringLiteral("$"), problems).toObject();
    if (problems.empty())
        root = texts.laid(root, file, {id}, path, QStringLiteral("$"), problems);
    if (problems.empty() && root["id"].toString() != id)
        problems.push_back({QStringLiteral("$.id"), quoted(root["id"].toString()),
                            QStringLiteral("the name of its file, %1").arg(quoted(id))});
    if (problems.empty()) {
        const ObjectReader text(root, QStringLiteral("$"), problems);
        const ObjectReader typed(full, at, problems);
        if (key == QLatin1String(kNamedObject.key)) {
            m_objects.push_back(
                {text.text("id"), text.translated("title"), text.text("source"), readObject(typed)});
            checkObject(m_objects.back().attributes, at, problems);
        } else if (key == QLatin1String(kNamedMesh.key)) {
            m_meshes.push_back(
                {text.text("id"), text.translated("title"), text.text("source"), readMesh(typed)});
            checkMesh(m_meshes.back().mesh, at, problems);
        } else {
            m_tissues.push_back(
                {text.text("id"), text.translated("title"), text.text("source"), readTissue(typed)});
            checkTissue(m_tissues.back().parameters, at, problems);
        }
    }
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    m_named[key][id] = numbers;
    return {};
}

QJsonObject NamedContent::filledIn(const QJsonObject& parameters, const Schema& schema, const QString& path,
                                   Problems& problems) const {
    QJsonObject out = parameters;
    for (const auto& [member, property] : schema.properties)
        for (const auto& [key, named] : m_named) {
            if (property->type != Schema::Type::object || !property->properties.contains(key))
                continue;
            QJsonValue given = parameters.contains(member) ? parameters[member] : property->defaultValue;
            QString at = memberPath(path, member);
            if (given.isString())
                given = QJsonObject{{key, given}};
            else
                at = memberPath(at, key);
            if (!given.isObject() || !given.toObject()[key].isString())
                continue; // left out, refused by its own schema, or entirely its own numbers
            const QString name = given.toObject()[key].toString();
            const auto found = named.find(name);
            if (found == named.end()) {
                problems.push_back(unknownName(at, name, named));
                out[member] = QJsonObject{{key, QStringLiteral("unknown")}}; // reported once, not again by
                                                                             // its schema
                continue;
            }
            QJsonObject full = found->second;
            const QJsonObject over = given.toObject();
            for (auto it = over.begin(); it != over.end(); ++it)
                full.insert(it.key(), it.value());
            out[member] = full;
        }
    return out;
}

} // namespace chiron::catalogue
