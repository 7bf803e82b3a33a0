// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "database/repositories/privacy_repository.h"

#include <QJsonObject>
#include <QString>
#include <vector>

namespace chiron::cli {

/// id, name, display_name, code, roles, enabled, must_change_password, created.
QJsonObject personJson(const database::Person& person);
QString peopleText(const std::vector<database::Person>& people);
/// Everything held about a person; samples are exported per session.
QJsonObject personExportJson(const database::PersonExport& everything);

} // namespace chiron::cli
