// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "database/database.h"
#include "session/exercise_kind.h"
#include "session/session_view.h"
#include "session/training_run.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <string_view>

namespace chiron::tests {

/// A shipped level of sphere_apex with fewer trials and a shorter limit, so that a test takes seconds.
inline catalogue::ExerciseLevel shortLevel(int number, int trials, double limit_s) {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    const catalogue::ExerciseLevel* level = catalogue->find("sphere_apex", number);
    QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(level->resolvedJson)).object();
    QJsonObject inner = json["level"].toObject();
    QJsonObject parameters = inner["parameters"].toObject();
    if (!parameters.contains("trials") || !parameters.contains("trial_limit_s"))
        qFatal("the resolved level does not say how many trials it has, or how long they may take");
    parameters["trials"] = trials;
    parameters["trial_limit_s"] = limit_s;
    inner["parameters"] = parameters;
    json["level"] = inner;
    auto changed =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
    if (!changed)
        qFatal("%s", changed.error().message.c_str());
    return *changed;
}

/// A fresh database in a folder of its own.
class SessionFixture {
public:
    SessionFixture() {
        database::DatabaseOptions options;
        options.passwordCost = database::PasswordCost::minimalForTests();
        auto created = database::Database::create(file(), options);
        if (!created)
            qFatal("%s", created.error().message.c_str());
        database = std::move(*created);
    }

    std::string file() const { return m_folder.filePath("test.db").toStdString(); }
    std::string folder() const { return m_folder.path().toStdString(); }

    /// `mechanism`, `hand`: as in scriptedStation().
    session::TrainingRequest request(const catalogue::ExerciseLevel& level, const std::string& operatorName,
                                     std::uint64_t seed, std::string_view mechanism = {},
                                     const mechanisms::HandParameters* hand = nullptr) const {
        session::TrainingRequest request;
        request.level = level;
        request.seed = seed;
        request.ringFolder =
            recording::defaultRingFolder(); // memory: a ring on a disk makes ticks wait for write-back
        const auto kind = session::exerciseKind(level.exercise);
        auto station = session::scriptedStation(**kind, level, operatorName, seed,
                                                {.mechanism = mechanism, .hand = hand});
        if (!station)
            qFatal("%s", station.error().message.c_str());
        request.station = std::move(*station);
        return request;
    }

    core::Result<session::TrainingResult> run(session::TrainingRequest request) {
        return session::runTraining(*database, database::Actor::simulated(), std::move(request));
    }

private:
    QTemporaryDir m_folder;

public:
    /// After the folder: it must still be there when this closes.
    std::unique_ptr<database::Database> database;
};

/// A stored session with the connection it lives on.
struct OpenStored {
    OpenStored(database::Database& database, database::SessionId id) {
        auto opened = database.openReader();
        if (!opened)
            qFatal("%s", opened.error().message.c_str());
        connection = std::move(*opened);
        auto stored = session::SessionView::open(*connection, database::Actor::simulated(), id);
        if (!stored)
            qFatal("%s", stored.error().message.c_str());
        session = std::move(*stored);
    }
    std::unique_ptr<database::Connection> connection;
    std::unique_ptr<session::SessionView> session;
};

} // namespace chiron::tests
