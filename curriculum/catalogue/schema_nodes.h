// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/json_node.h"

#include <QByteArray>

namespace chiron::catalogue {

/// Parts of the files of content/schema (schema.h has the keywords), for code that writes such a file from
/// rows.

/// Returns the type and the range of a number or the lengths of a list, to which the caller adds the rest.
JsonNode numberType(const char* type, const QString& unit, double minimum, double maximum);
JsonNode arrayType(int fewest, int most);

/// Returns the whole description of an object.
JsonNode objectNode(const QString& description, JsonNode properties, const QStringList& required = {});

/// Returns the bytes of a file that describes an object.
QByteArray schemaFile(const QString& title, const QString& description, JsonNode properties,
                      const QStringList& required, JsonLayout layout);

} // namespace chiron::catalogue
