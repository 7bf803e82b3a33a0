// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "database/repositories/privacy_repository.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::session {

/// [{decision ("void" or "reinstate"), person, utc, reason}], oldest first.
QJsonArray decisionsJson(const std::vector<database::SessionDecision>& decisions);
/// id, name, display_name, code, roles, enabled, must_change_password, created.
QJsonObject personJson(const database::Person& person);
/// Everything held about a person, as `person export` and the People screen hand it out; samples are exported per session.
QJsonObject personExportJson(const database::PersonExport& everything);

} // namespace chiron::session
