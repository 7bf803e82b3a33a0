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
/// All stored data of a person, as output by `person export` and the People screen; samples are exported per
/// session.
QJsonObject personExportJson(const database::PersonExport& everything);

} // namespace chiron::session
