// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/person_json.h"

#include <QString>
#include <vector>

namespace chiron::cli {

using session::personExportJson;
using session::personJson;

QString peopleText(const std::vector<database::Person>& people);

} // namespace chiron::cli
