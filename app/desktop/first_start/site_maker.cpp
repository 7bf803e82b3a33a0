// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/first_start/site_maker.h"

#include "database/accounts/account_service.h"
#include "database/repositories/site_repository.h"
#include "database/write_context.h"
#include "session/demo_site.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace chiron::desktop {

namespace {

constexpr std::uint64_t kDemonstrationSeed = 1;

core::Result<catalogue::Catalogue> loadContent() {
    return catalogue::findContentDirectory().and_then(
        [](const std::string& folder) { return catalogue::Catalogue::load(folder); });
}

/// Describes a step: "Find the apex, level 1, by Ines Improving, attempt 3 of 5".
QString doingWords(const session::DemoProgress& now, const catalogue::Catalogue& content,
                   const std::string& language) {
    const auto words = [](const char* text) { return QCoreApplication::translate("SiteMaker", text); };
    const catalogue::Exercise* exercise = content.find(now.exercise);
    if (!exercise)
        return words(QT_TRANSLATE_NOOP("SiteMaker", "A study with simulated participants"));
    const QString title = QString::fromStdString(catalogue::textIn(exercise->title, language));
    const QString level = QString::number(now.level);
    const QString person = QString::fromStdString(now.person);
    if (now.person.empty())
        return words(QT_TRANSLATE_NOOP("SiteMaker", "%1, level %2, by a scripted operator"))
            .arg(title, level);
    if (now.attempts == 1)
        return words(QT_TRANSLATE_NOOP("SiteMaker", "%1, level %2, by %3")).arg(title, level, person);
    return words(QT_TRANSLATE_NOOP("SiteMaker", "%1, level %2, by %3, attempt %4 of %5"))
        .arg(title, level, person, QString::number(now.attempt), QString::number(now.attempts));
}

} // namespace

core::Result<MadeSite> makeSite(const std::string& file, const database::DatabaseOptions& options,
                                database::Database* open, const AdministratorRequest& request) {
    auto content = loadContent();
    CHIRON_TRY(content);
    CHIRON_TRY(database::checkedSiteName(request.siteName)); // before anything is created
    MadeSite made;
    made.catalogue = std::move(*content);
    if (open == nullptr) {
        auto site = session::openSite(file, options);
        CHIRON_TRY(site);
        made.database = std::move(site->database);
        open = made.database.get();
    }
    database::AccountService accounts(*open);
    const auto first = accounts.createFirstAdministrator(request.name, request.password, request.displayName);
    CHIRON_TRY(first);
    const auto actor = accounts.login(request.name, request.password);
    CHIRON_TRY(actor);
    if (!request.siteName.empty()) {
        const auto named = open->write([&](database::WriteContext& writing) {
            return database::SiteRepository(writing.connection(), *actor).setSiteName(request.siteName);
        });
        CHIRON_TRY(named);
    }
    made.actor = *actor;
    made.recoveryCode = first->recoveryCode;
    return made;
}

core::Result<MadeSite> makeDemonstration(const std::string& file, const database::DatabaseOptions& options,
                                         WorkToken& token, const std::string& language) {
    auto content = loadContent();
    CHIRON_TRY(content);
    MadeSite made;
    made.catalogue = std::move(*content);
    if (QFileInfo::exists(QString::fromStdString(file))) {
        auto site = session::openSite(file, options);
        CHIRON_TRY(site);
        if (!site->database->isDemonstration())
            return core::fail(core::ErrorCode::badInput,
                              file + ": holds a site that is no demonstration; it was left as it is");
        made.database = std::move(site->database);
        return made;
    }
    auto site = session::createDemoSite(
        file, options, made.catalogue, kDemonstrationSeed,
        [&token, &content = made.catalogue, &language](const session::DemoProgress& now) {
            token.setProgress(now.step - 1, now.of);
            token.setDoing(doingWords(now, content, language));
        },
        &token.flag());
    CHIRON_TRY(site);
    made.database = std::move(*site);
    return made;
}

} // namespace chiron::desktop
