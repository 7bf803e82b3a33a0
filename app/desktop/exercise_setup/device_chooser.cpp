// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/device_chooser.h"

#include "desktop/exercise_setup/choice_tile.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/station/station_words.h"
#include "desktop/training/training_words.h"
#include "desktop/widgets/kit.h"
#include "devices/kinematics_catalogue.h"
#include "scoring/trace_csv.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFileDialog>
#include <QStackedWidget>
#include <QStyle>
#include <algorithm>

namespace chiron::desktop {

namespace {

/// What matters about a trace file before it is played.
struct TraceCheck {
    int rows = 0;
    double length_s = 0.0;
};

core::Result<TraceCheck> readTrace(const QString& file, session::PointerTool tool, int tools) {
    auto rows = scoring::readTraceCsvFile(file.toStdString());
    CHIRON_TRY(rows);
    CHIRON_TRY(session::traceStation(*rows, tool, tools));
    return TraceCheck{static_cast<int>(rows->rows.size()), rows->rows.back().t_s - rows->rows.front().t_s};
}

/// The force maps among which the mechanism of the exercise's demonstration offers a choice, or null.
const devices::ForceMaps* forceMapsOf(const session::ExerciseKind* kind) {
    const auto* kinematics = devices::findKinematics(kind ? kind->mechanism() : session::kUsualMechanism);
    return kinematics ? kinematics->forceMaps : nullptr;
}

/// The person's own devices first, then demonstrations, then recordings, each group in the catalogue's order.
/// A driver whose device is not here is not offered; the station screen lists it.
std::vector<const devices::Driver*> driversInOrder() {
    std::vector<const devices::Driver*> drivers;
    for (const devices::Driver* driver : devices::driverCatalogue())
        if (driver->movedBy != devices::MovedBy::person || !driver->discover().empty())
            drivers.push_back(driver);
    std::stable_sort(drivers.begin(), drivers.end(),
                     [](const auto* a, const auto* b) { return a->movedBy < b->movedBy; });
    return drivers;
}

/// Lets paths and lists of columns, which are one long word, wrap after a slash or a comma.
QString breakable(QString text) {
    for (const char16_t mark : {u'/', u','})
        text.replace(QChar(mark), QString(QChar(mark)) + QChar(0x200B));
    return text;
}

} // namespace

DeviceChooser::DeviceChooser(AppContext& context, const session::ExerciseKind* kind, QWidget* parent)
    : QWidget(parent), m_context(context), m_tool(kind ? kind->pointerTool() : session::PointerTool::point),
      m_drivers(driversInOrder()), m_group(new QButtonGroup(this)), m_pages(new QStackedWidget) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(context.theme().px(8));
    const std::vector<std::string> operators = kind ? kind->operatorNames() : std::vector<std::string>();
    for (int i = 0; i < static_cast<int>(m_drivers.size()); ++i) {
        const devices::Driver& driver = *m_drivers[static_cast<std::size_t>(i)];
        QWidget* tile = addTile(i, healthOf(driver, kind));
        tile->setEnabled(driver.movedBy != devices::MovedBy::scriptedOperator || !operators.empty());
        column->addWidget(tile);
    }
    m_pages->addWidget(new QWidget); // one page per MovedBy, in its order
    m_pages->addWidget(demonstrationPage(operators, forceMapsOf(kind)));
    m_pages->addWidget(tracePage());
    column->addWidget(m_pages);
    connect(m_group, &QButtonGroup::idClicked, this, [this](int id) {
        show(*m_drivers.at(static_cast<std::size_t>(id)));
        emit changed();
    });
    show(*m_drivers.front());
}

QString DeviceChooser::titleOf(const devices::Driver& driver) const {
    switch (driver.movedBy) {
    case devices::MovedBy::scriptedOperator:
        return tr("Demonstrate");
    case devices::MovedBy::recording:
        return tr("Replay a file");
    case devices::MovedBy::person:
        break;
    }
    return StationWords::driver(driver);
}

QString DeviceChooser::healthOf(const devices::Driver& driver, const session::ExerciseKind* kind) const {
    switch (driver.movedBy) {
    case devices::MovedBy::scriptedOperator:
        return demonstratedOn(driver, kind);
    case devices::MovedBy::recording:
        return m_tool == session::PointerTool::endoscope
                   ? tr("A recorded movement (CSV, with orientation) moves the endoscope.")
               : m_tool == session::PointerTool::grasper
                   ? tr("A recorded movement (CSV, with the jaw) moves the instruments.")
                   : tr("A recorded movement (CSV) moves the tool.");
    case devices::MovedBy::person:
        break;
    }
    return driver.deviceClass == devices::DeviceClass::shown ? tr("Ready. Force is shown, not felt.")
                                                             : StationWords::needs(driver);
}

QString DeviceChooser::demonstratedOn(const devices::Driver& driver,
                                      const session::ExerciseKind* kind) const {
    if (!kind || kind->operatorNames().empty())
        return tr("There is no demonstration of this exercise on this station.");
    return tr("Ready. Watch a scripted operator. Device: %1.")
        .arg(StationWords::device(driver, kind->mechanism()));
}

QWidget* DeviceChooser::addTile(int index, const QString& health) {
    const devices::Driver& driver = *m_drivers.at(static_cast<std::size_t>(index));
    auto* tile = new ChoiceTile(m_context.theme(), titleOf(driver), health, deviceIcon(driver.movedBy));
    tile->setObjectName(QStringLiteral("setup.device.%1").arg(index));
    m_group->addButton(tile, index);
    return tile;
}

QWidget* DeviceChooser::demonstrationPage(const std::vector<std::string>& operators,
                                          const devices::ForceMaps* forceMaps) {
    const Theme& theme = m_context.theme();
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    auto* label = kit::label(theme, tr("Operator"), TextStyle::label);
    m_operator = new QComboBox;
    m_operator->setObjectName(QStringLiteral("setup.operator"));
    m_operator->setAccessibleName(tr("Operator"));
    label->setBuddy(m_operator);
    for (const std::string& name : operators)
        m_operator->addItem(operatorTitle(name), QString::fromStdString(name));
    m_operator->setCurrentIndex(std::max(m_operator->findData(QStringLiteral("expert")), 0));
    column->addWidget(label);
    column->addWidget(m_operator);
    if (forceMaps)
        addForceMap(*column, *forceMaps);
    column->addWidget(kit::label(theme,
                                 tr("The session is listed as simulated and does not count for anyone."),
                                 TextStyle::small, "muted"));
    connect(m_operator, &QComboBox::currentIndexChanged, this, &DeviceChooser::changed);
    return page;
}

void DeviceChooser::addForceMap(QVBoxLayout& column, const devices::ForceMaps& forceMaps) {
    const QString title = StationWords::text(forceMaps.title);
    auto* label = kit::label(m_context.theme(), title, TextStyle::label);
    m_forceMap = new QComboBox;
    m_forceMap->setObjectName(QStringLiteral("setup.force_map"));
    m_forceMap->setAccessibleName(title);
    label->setBuddy(m_forceMap);
    for (const devices::ForceMap& map : forceMaps.maps)
        m_forceMap->addItem(StationWords::text(map.name),
                            QString::fromUtf8(map.id.data(), static_cast<qsizetype>(map.id.size())));
    column.addWidget(label);
    column.addWidget(m_forceMap);
    connect(m_forceMap, &QComboBox::currentIndexChanged, this, &DeviceChooser::changed);
}

void DeviceChooser::setTools(int tools) {
    if (tools == m_tools)
        return;
    m_tools = tools;
    if (!m_traceFile.isEmpty())
        checkTrace();
}

QWidget* DeviceChooser::tracePage() {
    const Theme& theme = m_context.theme();
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    auto* choose = kit::button(theme, tr("Choose a file …"), "", QStringLiteral("document-open"));
    choose->setObjectName(QStringLiteral("setup.trace.choose"));
    column->addWidget(choose, 0, Qt::AlignLeft);
    m_traceName = kit::label(theme, {}, TextStyle::body);
    m_traceName->setObjectName(QStringLiteral("setup.trace.name"));
    column->addWidget(m_traceName);
    m_traceWords = kit::label(theme, {}, TextStyle::small);
    m_traceWords->setObjectName(QStringLiteral("setup.trace.words"));
    column->addWidget(m_traceWords);
    setTraceWords(tr("No file is chosen yet."), "muted");
    connect(choose, &QPushButton::clicked, this, &DeviceChooser::askTrace);
    return page;
}

const devices::Driver& DeviceChooser::driver() const {
    return *m_drivers.at(static_cast<std::size_t>(std::max(m_group->checkedId(), 0)));
}

void DeviceChooser::show(const devices::Driver& driver) {
    const auto at = std::find(m_drivers.begin(), m_drivers.end(), &driver);
    if (QAbstractButton* tile = m_group->button(static_cast<int>(at - m_drivers.begin())))
        tile->setChecked(true);
    m_pages->setCurrentIndex(static_cast<int>(driver.movedBy));
    m_pages->setVisible(driver.movedBy != devices::MovedBy::person);
}

void DeviceChooser::setPlan(const TrainingPlan& plan) {
    if (const int at = m_operator->findData(plan.operatorName); at >= 0)
        m_operator->setCurrentIndex(at);
    if (m_forceMap)
        m_forceMap->setCurrentIndex(std::max(m_forceMap->findData(plan.forceMap), 0));
    m_traceFile = plan.traceFile;
    if (!m_traceFile.isEmpty())
        checkTrace();
    const bool offered = std::find(m_drivers.begin(), m_drivers.end(), plan.driver) != m_drivers.end();
    const bool possible =
        offered && (!plan.movedBy(devices::MovedBy::scriptedOperator) || m_operator->count() > 0);
    show(possible ? *plan.driver : *m_drivers.front());
}

void DeviceChooser::fillPlan(TrainingPlan& plan) const {
    plan.driver = &driver();
    plan.operatorName = m_operator->currentData().toString();
    plan.forceMap = m_forceMap ? m_forceMap->currentData().toString() : QString();
    plan.traceFile = m_traceFile;
}

bool DeviceChooser::ready() const {
    return driver().movedBy != devices::MovedBy::recording || m_traceReady;
}

void DeviceChooser::askTrace() {
    auto* dialog = new QFileDialog(this, tr("Choose a recorded movement"), QString(), tr("Traces (*.csv)"));
    dialog->setObjectName(QStringLiteral("setup.trace.dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    beginInLastFolder(m_context.settings(), *dialog, QStringLiteral("traces"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
        m_traceFile = file;
        checkTrace();
    });
    dialog->open();
}

void DeviceChooser::checkTrace() {
    m_traceReady = false;
    m_traceName->setText(breakable(m_traceFile));
    setTraceWords(tr("Reading the file …"), "muted");
    emit changed();
    const QString file = m_traceFile;
    m_context.background().run(
        this, [file, tool = m_tool, tools = m_tools](WorkToken&) { return readTrace(file, tool, tools); },
        [this, file, tools = m_tools](core::Result<TraceCheck> read) {
            if (file != m_traceFile || tools != m_tools)
                return; // another file or level was chosen in the meantime
            m_traceReady = read.has_value();
            if (read)
                setTraceWords(tr("Ready: %n rows, %1 s.", nullptr, read->rows)
                                  .arg(m_context.locale().toString(read->length_s, 'f', 1)),
                              "good");
            else
                setTraceWords(tr("This file cannot be played. Correct it or choose another.\n%1")
                                  .arg(breakable(QString::fromStdString(read.error().message))),
                              "bad");
            emit changed();
        });
}

void DeviceChooser::setTraceWords(const QString& words, const char* kind) {
    m_traceWords->setText(words);
    m_traceWords->setProperty("kind", QLatin1String(kind));
    m_traceWords->style()->unpolish(m_traceWords);
    m_traceWords->style()->polish(m_traceWords);
}

} // namespace chiron::desktop
