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
#include "session_report/tool_words.h"

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

QString nameOf(const devices::FoundDevice& found) {
    const QString model = QString::fromStdString(found.model),
                  serial = QString::fromStdString(found.serialNumber);
    if (model.isEmpty()) // the maker gave it none
        return QString::fromStdString(found.address);
    return serial.isEmpty() ? model : DeviceChooser::tr("%1, serial number %2").arg(model, serial);
}

/// Lets paths and lists of columns, which are one long word, wrap after a slash or a comma.
QString breakable(QString text) {
    for (const char16_t mark : {u'/', u','})
        text.replace(QChar(mark), QString(QChar(mark)) + QChar(0x200B));
    return text;
}

} // namespace

/// The person's own devices first, then demonstrations, then recordings, each group in the catalogue's order.
/// A driver whose device is not here is not offered; the station screen lists it.
std::vector<DeviceChooser::Offered> DeviceChooser::offeredInOrder() {
    std::vector<Offered> all;
    for (const devices::Driver* driver : devices::driverCatalogue()) {
        Offered offered{driver, driver->discover()};
        if (driver->movedBy != devices::MovedBy::person || !offered.found.empty())
            all.push_back(std::move(offered));
    }
    std::stable_sort(all.begin(), all.end(), [](const Offered& a, const Offered& b) {
        return a.driver->movedBy < b.driver->movedBy;
    });
    return all;
}

DeviceChooser::DeviceChooser(AppContext& context, const session::ExerciseKind* kind, QWidget* parent)
    : QWidget(parent), m_context(context), m_tool(kind ? kind->pointerTool() : session::PointerTool::point),
      m_drivers(offeredInOrder()), m_group(new QButtonGroup(this)), m_pages(new QStackedWidget) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(context.theme().px(8));
    const std::vector<std::string> operators = kind ? kind->operatorNames() : std::vector<std::string>();
    for (int i = 0; i < static_cast<int>(m_drivers.size()); ++i) {
        const Offered& each = m_drivers[static_cast<std::size_t>(i)];
        const devices::Driver& driver = *each.driver;
        QWidget* tile = addTile(i, healthOf(each, kind));
        tile->setEnabled(driver.movedBy != devices::MovedBy::scriptedOperator || !operators.empty());
        column->addWidget(tile);
    }
    auto* connected = new QWidget;
    m_connected = new QVBoxLayout(connected);
    m_connected->setContentsMargins(0, 0, 0, 0);
    m_connected->setSpacing(context.theme().px(6));
    m_pages->addWidget(connected); // one page per MovedBy, in its order
    m_pages->addWidget(demonstrationPage(operators, forceMapsOf(kind)));
    m_pages->addWidget(tracePage());
    column->addWidget(m_pages);
    connect(m_group, &QButtonGroup::idClicked, this, [this](int id) {
        show(*m_drivers.at(static_cast<std::size_t>(id)).driver);
        emit changed();
    });
    show(*m_drivers.front().driver);
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

QString DeviceChooser::healthOf(const Offered& offered, const session::ExerciseKind* kind) const {
    const devices::Driver& driver = *offered.driver;
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
    if (driver.deviceClass == devices::DeviceClass::shown)
        return tr("Ready. Force is shown, not felt.");
    return offered.connected() ? tr("Ready. Force is felt. %n device(s) connected.", nullptr,
                                    static_cast<int>(offered.found.size()))
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
    const devices::Driver& driver = *m_drivers.at(static_cast<std::size_t>(index)).driver;
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
    showConnected();
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

const DeviceChooser::Offered& DeviceChooser::offered() const {
    return m_drivers.at(static_cast<std::size_t>(std::max(m_group->checkedId(), 0)));
}

const devices::Driver& DeviceChooser::driver() const {
    return *offered().driver;
}

/// One choice for each instrument, of the connected devices; or how many are missing.
void DeviceChooser::showConnected() {
    while (QLayoutItem* old = m_connected->takeAt(0)) {
        delete old->widget();
        delete old;
    }
    m_addresses.clear();
    if (!offered().connected())
        return;
    const Theme& theme = m_context.theme();
    const std::vector<devices::FoundDevice>& found = offered().found;
    if (static_cast<int>(found.size()) < m_tools) {
        auto* missing = kit::label(theme, hindrance(), TextStyle::small, "bad");
        missing->setObjectName(QStringLiteral("setup.connected.missing"));
        m_connected->addWidget(missing);
        return;
    }
    for (int tool = 0; tool < m_tools; ++tool) {
        const QString title = m_tools == 1 ? tr("Device") : session_report::instrumentName(tool, m_tools);
        auto* label = kit::label(theme, title, TextStyle::label);
        auto* choice = new QComboBox;
        choice->setObjectName(QStringLiteral("setup.connected.%1").arg(tool));
        choice->setAccessibleName(title);
        label->setBuddy(choice);
        for (const devices::FoundDevice& each : found)
            choice->addItem(nameOf(each), QString::fromStdString(each.address));
        const int wanted = choice->findData(m_wanted.value(tool));
        choice->setCurrentIndex(wanted >= 0 ? wanted : tool);
        m_connected->addWidget(label);
        m_connected->addWidget(choice);
        m_addresses.push_back(choice);
        connect(choice, &QComboBox::currentIndexChanged, this, [this] {
            m_wanted = chosenAddresses();
            m_same->setVisible(chosenAddresses().removeDuplicates() > 0);
            emit changed();
        });
    }
    m_same = kit::label(theme, tr("Choose a different device for each instrument."), TextStyle::small, "bad");
    m_same->setObjectName(QStringLiteral("setup.connected.same"));
    m_same->setVisible(chosenAddresses().removeDuplicates() > 0);
    m_connected->addWidget(m_same);
}

QStringList DeviceChooser::chosenAddresses() const {
    QStringList addresses;
    for (const QComboBox* choice : m_addresses)
        addresses << choice->currentData().toString();
    return addresses;
}

void DeviceChooser::show(const devices::Driver& driver) {
    const auto at = std::find_if(m_drivers.begin(), m_drivers.end(),
                                 [&driver](const Offered& each) { return each.driver == &driver; });
    if (QAbstractButton* tile = m_group->button(static_cast<int>(at - m_drivers.begin())))
        tile->setChecked(true);
    m_pages->setCurrentIndex(static_cast<int>(driver.movedBy));
    m_pages->setVisible(driver.movedBy != devices::MovedBy::person || offered().connected());
    showConnected();
}

void DeviceChooser::setPlan(const TrainingPlan& plan) {
    if (const int at = m_operator->findData(plan.operatorName); at >= 0)
        m_operator->setCurrentIndex(at);
    if (m_forceMap)
        m_forceMap->setCurrentIndex(std::max(m_forceMap->findData(plan.forceMap), 0));
    m_traceFile = plan.traceFile;
    if (!m_traceFile.isEmpty())
        checkTrace();
    m_wanted = plan.addresses;
    const bool present = std::any_of(m_drivers.begin(), m_drivers.end(),
                                     [&plan](const Offered& each) { return each.driver == plan.driver; });
    const bool possible =
        present && (!plan.movedBy(devices::MovedBy::scriptedOperator) || m_operator->count() > 0);
    show(possible ? *plan.driver : *m_drivers.front().driver);
}

void DeviceChooser::fillPlan(TrainingPlan& plan) const {
    plan.driver = &driver();
    plan.operatorName = m_operator->currentData().toString();
    plan.forceMap = m_forceMap ? m_forceMap->currentData().toString() : QString();
    plan.traceFile = m_traceFile;
    plan.addresses = chosenAddresses();
}

QString DeviceChooser::hindrance() const {
    if (driver().movedBy == devices::MovedBy::recording)
        return m_traceReady ? QString() : m_traceWords->text();
    if (!offered().connected())
        return {};
    if (const int found = static_cast<int>(offered().found.size()); found < m_tools)
        return tr("This level takes %1 devices. Connect %2 more, then open this screen again.")
            .arg(m_context.locale().toString(m_tools), m_context.locale().toString(m_tools - found));
    if (chosenAddresses().removeDuplicates() > 0)
        return tr("Choose a different device for each instrument.");
    return {};
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
