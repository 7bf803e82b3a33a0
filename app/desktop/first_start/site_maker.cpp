// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/first_start/site_maker.h"

#include "database/accounts/account_service.h"
#include "session/demo_site.h"

#include <QFileInfo>

namespace chiron::desktop {

namespace {

constexpr std::uint64_t kDemonstrationSeed = 1;

core::Result<catalogue::Catalogue> loadContent() {
    return catalogue::findContentDirectory().and_then([](const std::string& folder) { return catalogue::Catalogue::load(folder); });
}

} // namespace

core::Result<MadeSite> makeSite(const std::string& file, const database::DatabaseOptions& options, database::Database* open,
                                const AdministratorRequest& request) {
    auto content = loadContent();
    if (!content)
        return tl::unexpected(content.error());
    MadeSite made;
    made.catalogue = std::move(*content);
    if (open == nullptr) {
        auto site = session::openSite(file, options);
        if (!site)
            return tl::unexpected(site.error());
        made.database = std::move(site->database);
        open = made.database.get();
    }
    database::AccountService accounts(*open);
    const auto first = accounts.createFirstAdministrator(request.name, request.password, request.displayName);
    if (!first)
        return tl::unexpected(first.error());
    const auto actor = accounts.login(request.name, request.password);
    if (!actor)
        return tl::unexpected(actor.error());
    made.actor = *actor;
    made.recoveryCode = first->recoveryCode;
    return made;
}

core::Result<MadeSite> makeDemonstration(const std::string& file, const database::DatabaseOptions& options, WorkToken& token) {
    auto content = loadContent();
    if (!content)
        return tl::unexpected(content.error());
    MadeSite made;
    made.catalogue = std::move(*content);
    if (QFileInfo::exists(QString::fromStdString(file))) {
        auto site = session::openSite(file, options);
        if (!site)
            return tl::unexpected(site.error());
        if (!site->database->isDemonstration())
            return core::fail(core::ErrorCode::badInput, file + ": holds a site that is no demonstration; it was left as it is");
        made.database = std::move(site->database);
        return made;
    }
    auto site = session::createDemoSite(
        file, options, made.catalogue, kDemonstrationSeed,
        [&token](const session::DemoProgress& now) { token.setProgress(now.step - 1, now.of); }, &token.flag());
    if (!site)
        return tl::unexpected(site.error());
    made.database = std::move(*site);
    return made;
}

} // namespace chiron::desktop
