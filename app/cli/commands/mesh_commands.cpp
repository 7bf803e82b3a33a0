// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/input_file.h"
#include "simulation/geometry/mesh/mesh_import.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>

namespace chiron::cli {

namespace {

using simulation::MeshFinding;
using simulation::MeshFormat;
using simulation::MeshImport;
using simulation::MeshReport;

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

core::Result<double> metresPerUnit(const Arguments& arguments) {
    const auto unit = arguments.choice(QStringLiteral("unit"),
                                       {QStringLiteral("mm"), QStringLiteral("cm"), QStringLiteral("m")},
                                       QStringLiteral("mm"));
    CHIRON_TRY(unit);
    return *unit == QLatin1String("m") ? 1.0 : *unit == QLatin1String("cm") ? 0.01 : 0.001;
}

/// Reads the mesh of the file.
/// Errors: badInput with the file, the place in it, what was found and what was expected.
core::Result<MeshImport> readMeshFile(const Arguments& arguments) {
    const auto unit_m = metresPerUnit(arguments);
    CHIRON_TRY(unit_m);
    constexpr qint64 kLargest = qint64{256} << 20;
    const QString path = arguments.operand(0);
    const auto file = readInputFile(path, kLargest);
    CHIRON_TRY(file);
    const std::string_view bytes(file->constData(), static_cast<std::size_t>(file->size()));
    // If the format of a damaged file cannot be guessed, its name or its beginning decides; a file with
    // binary data is not OBJ.
    const bool stl = bytes.substr(0, 5) == "solid" ||
                     path.endsWith(QLatin1String(".stl"), Qt::CaseInsensitive) ||
                     bytes.substr(0, 4096).find('\0') != std::string_view::npos;
    const auto format = simulation::guessMeshFormat(bytes).value_or(stl ? MeshFormat::stl : MeshFormat::obj);
    MeshImport import = simulation::importMesh(bytes, format, *unit_m);
    const auto refused = std::find_if(import.report.findings.begin(), import.report.findings.end(),
                                      [](const MeshFinding& finding) { return !finding.repaired; });
    if (refused == import.report.findings.end())
        return import;
    const QString such = refused->count > 1 ? QStringLiteral(" (%1 such)").arg(refused->count) : QString();
    return badInput(
        QStringLiteral("%1: %2: %3%4; expected %5")
            .arg(path, text(refused->place), text(refused->found), such, text(refused->expected)));
}

QJsonObject reportJson(const QString& path, const MeshReport& report) {
    QJsonArray findings;
    for (const MeshFinding& finding : report.findings)
        findings.append(QJsonObject{{QStringLiteral("place"), text(finding.place)},
                                    {QStringLiteral("found"), text(finding.found)},
                                    {QStringLiteral("expected"), text(finding.expected)},
                                    {QStringLiteral("count"), static_cast<qint64>(finding.count)},
                                    {QStringLiteral("put_right"), finding.repaired}});
    QJsonArray size;
    for (const double axis_m : report.size_m)
        size.append(1e3 * axis_m);
    return {{QStringLiteral("file"), path},
            {QStringLiteral("findings"), findings},
            {QStringLiteral("triangles"), static_cast<qint64>(report.triangles)},
            {QStringLiteral("vertices"), static_cast<qint64>(report.vertices)},
            {QStringLiteral("shells"), static_cast<qint64>(report.shells)},
            {QStringLiteral("size_mm"), size},
            {QStringLiteral("volume_ml"), 1e6 * report.volume_m3}};
}

core::Result<CommandOutput> check(const Arguments& arguments) {
    const auto import = readMeshFile(arguments);
    CHIRON_TRY(import);
    return CommandOutput{QJsonDocument(reportJson(arguments.operand(0), import->report)),
                         text(import->report.text()), 0};
}

/// The id must match schema/mesh.json: lower-case letters, digits and _, beginning with a letter, at most 40
/// characters.
core::Result<QString> meshId(const Arguments& arguments) {
    constexpr qsizetype kLongest = 40;
    const QString id = arguments.value(QStringLiteral("id"));
    const bool letters = std::all_of(id.begin(), id.end(), [](QChar c) {
        return c == u'_' || (c >= u'a' && c <= u'z') || (c >= u'0' && c <= u'9');
    });
    if (id.isEmpty() || id.size() > kLongest || !letters || id[0] < u'a' || id[0] > u'z')
        return badInput(
            QStringLiteral("--id: %1: expected lower-case letters, digits and _, a letter first, at most %2")
                .arg(quoted(id))
                .arg(kLongest));
    return id;
}

template <class Whole> QJsonArray wholes(const std::vector<Whole>& values) {
    QJsonArray array;
    for (const Whole value : values)
        array.append(static_cast<qint64>(value));
    return array;
}

core::Result<CommandOutput> import(const Arguments& arguments) {
    const auto id = meshId(arguments);
    CHIRON_TRY(id);
    const auto read = readMeshFile(arguments);
    CHIRON_TRY(read);
    const auto stored = simulation::storedMesh(read->shape, id->toStdString());
    if (!stored)
        return badInput(QStringLiteral("%1: %2").arg(arguments.operand(0), text(stored.error().message)));
    const QString title =
        arguments.has(QStringLiteral("title")) ? arguments.value(QStringLiteral("title")) : *id;
    const QString source =
        arguments.has(QStringLiteral("source"))
            ? arguments.value(QStringLiteral("source"))
            : QStringLiteral("Imported from %1.").arg(QFileInfo(arguments.operand(0)).fileName());
    const QJsonObject shape{{QStringLiteral("shape"), QStringLiteral("stored")},
                            {QStringLiteral("vertices_um"), wholes(stored->vertices_um)},
                            {QStringLiteral("triangles"), wholes(stored->triangles)}};
    const QJsonDocument json(QJsonObject{{QStringLiteral("id"), *id},
                                         {QStringLiteral("title"), title},
                                         {QStringLiteral("source"), source},
                                         {QStringLiteral("shape"), shape}});
    return CommandOutput{json, QString::fromUtf8(json.toJson(QJsonDocument::Indented)), 0};
}

} // namespace

std::vector<CommandSpec> meshCommands() {
    CommandSpec checking;
    checking.group = QStringLiteral("mesh");
    checking.verb = QStringLiteral("check");
    checking.summary = QStringLiteral("what is found in a mesh file (OBJ, STL), and what is put right");
    checking.operands = {{QStringLiteral("FILE"), QStringLiteral("an OBJ or STL file (ASCII or binary)")}};
    checking.options = {{QStringLiteral("unit"), QStringLiteral("WORD"),
                         QStringLiteral("what a 1 in the file is: mm, cm or m; default: mm")}};
    checking.example = QStringLiteral("chiron-cli mesh check organ.stl --json");
    checking.run = check;
    CommandSpec importing = checking;
    importing.verb = QStringLiteral("import");
    importing.summary = QStringLiteral("a mesh file as content: the JSON of meshes/ID.json on stdout");
    importing.options.push_back({QStringLiteral("id"), QStringLiteral("ID"),
                                 QStringLiteral("by which levels name it: lower-case letters, digits and _"),
                                 true});
    importing.options.push_back({QStringLiteral("title"), QStringLiteral("TEXT"),
                                 QStringLiteral("its English title; default: the id")});
    importing.options.push_back({QStringLiteral("source"), QStringLiteral("TEXT"),
                                 QStringLiteral("where the shape comes from; default: the file's name")});
    importing.example = QStringLiteral(
        "chiron-cli mesh import organ.stl --id my_organ > curriculum/content/meshes/my_organ.json");
    importing.run = import;
    return {checking, importing};
}

} // namespace chiron::cli
