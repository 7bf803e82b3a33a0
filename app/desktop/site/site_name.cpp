// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/site/site_name.h"

#include "database/repositories/site_repository.h"

namespace chiron::desktop {

core::Result<QString> readSiteName(database::Database& database, const database::Actor& actor) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    const auto name = database::SiteRepository(**reader, actor).siteName();
    CHIRON_TRY(name);
    return QString::fromStdString(*name);
}

} // namespace chiron::desktop
