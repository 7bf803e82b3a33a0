// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/command_groups.h"
#include "cli/text_table.h"
#include "devices/driver_catalogue.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

namespace {

core::Result<CommandOutput> list(const Arguments&) {
    QJsonArray drivers;
    TextTable table({QStringLiteral("driver"), QStringLiteral("class"), QStringLiteral("title"),
                     QStringLiteral("needs")});
    for (const devices::DriverEntry& driver : devices::driverCatalogue()) {
        const QString id = QString::fromStdString(std::string(driver.id));
        const QString title = QString::fromStdString(std::string(driver.title));
        const QString needs = QString::fromStdString(std::string(driver.needs));
        const QString kind = driver.deviceClass == devices::DeviceClass::felt ? QStringLiteral("felt")
                                                                              : QStringLiteral("shown");
        drivers.append(QJsonObject{{QStringLiteral("id"), id},
                                   {QStringLiteral("title"), title},
                                   {QStringLiteral("class"), kind},
                                   {QStringLiteral("needs"), needs}});
        table.add({id, kind, title, needs});
    }
    return CommandOutput{QJsonDocument(drivers), table.toText(), 0};
}

} // namespace

std::vector<CommandSpec> deviceCommands() {
    CommandSpec command;
    command.group = QStringLiteral("device");
    command.verb = QStringLiteral("list");
    command.summary = QStringLiteral("the devices that this build can drive");
    command.example = QStringLiteral("chiron-cli device list --json");
    command.run = list;
    return {command};
}

} // namespace chiron::cli
