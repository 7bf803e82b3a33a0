// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/new_study_dialog.h"

#include "catalogue/study_catalogue.h"
#include "desktop/accounts/form.h"
#include "desktop/studies/procedure_form.h"
#include "desktop/studies/study_store.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/tile_button.h"

#include <QButtonGroup>
#include <QLineEdit>
#include <QRegularExpression>
#include <cmath>

namespace chiron::desktop {

namespace {

constexpr int kDifferences = 40;
constexpr double kSmallest_percent = 2.0;
constexpr double kLargest_percent = 60.0;
constexpr double kUsualStiffness_N_per_m = 300.0;

bool isKey(const QString& key) {
    static const QRegularExpression kKey(QStringLiteral("^[a-z][a-z0-9_]{0,62}$"));
    return kKey.match(key).hasMatch();
}

} // namespace

psychophysics::StudyDesign plainStudy() {
    psychophysics::StudyDesign study;
    study.id = "new_study";
    study.title["en"] = "New study";
    study.objective["en"] = "What is to be found out.";
    study.instructions["en"] = "Explore all objects, then answer.";
    study.consent["en"] = "I take part of my own free will and may stop at any time.";
    psychophysics::Condition condition;
    condition.id = "stiffness";
    condition.title["en"] = "Stiffness";
    condition.stimulus.reference = kUsualStiffness_N_per_m;
    for (int i = 0; i < kDifferences; ++i) {
        const double part = static_cast<double>(i) / (kDifferences - 1);
        condition.stimulus.differences.push_back(study_words::differenceOf(0.01 * kSmallest_percent * std::pow(kLargest_percent / kSmallest_percent, part)));
    }
    condition.procedures = {usualProcedure("rank3_quest_plus", condition)};
    study.conditions = {condition};
    return study;
}

NewStudyDialog::NewStudyDialog(AppContext& context, QWidget* parent) : FormDialog(context, QStringLiteral("new_study"), tr("New study"), parent) {
    m_list = new QWidget;
    auto* rows = new QVBoxLayout(m_list);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(theme().px(8));
    m_choice = new QButtonGroup(this);
    connect(m_choice, &QButtonGroup::idClicked, this, &NewStudyDialog::choose);
    column()->addWidget(kit::label(theme(), tr("Begin with"), TextStyle::label));
    column()->addWidget(m_list);
    m_title = form::textField(theme(), column(), tr("Title"), QStringLiteral("new_study.title"));
    m_key = form::textField(theme(), column(), tr("Key (in files and commands)"), QStringLiteral("new_study.key"));
    column()->addWidget(kit::label(theme(), tr("Lower-case letters, digits and _ only. It cannot be changed later."), TextStyle::small, "muted"));
    setAccept(tr("Create draft"));
    connect(m_title, &QLineEdit::textEdited, this, &NewStudyDialog::renew);
    connect(m_key, &QLineEdit::textEdited, this, &NewStudyDialog::renew);
    renew();
    loadTemplates();
}

void NewStudyDialog::loadTemplates() {
    context().background().run(
        this, [](WorkToken&) { return catalogue::StudyCatalogue::load(); },
        [this](const core::Result<catalogue::StudyCatalogue>& studies) {
            if (!studies)
                say("warning", tr("The templates could not be read.\n%1").arg(inWords(studies.error())));
            showTemplates(studies ? studies->studies() : std::vector<psychophysics::StudyDesign>());
        });
}

void NewStudyDialog::showTemplates(std::vector<psychophysics::StudyDesign> templates) {
    m_templates = std::move(templates);
    m_templates.push_back(plainStudy());
    for (std::size_t i = 0; i < m_templates.size(); ++i) {
        const bool plain = i + 1 == m_templates.size();
        const QString title = plain ? tr("A simple study") : study_words::text(m_templates[i].title, context().language());
        const QString objective = plain ? tr("One condition: three objects are ranked by stiffness.") : study_words::text(m_templates[i].objective, context().language());
        auto* tile = new TileButton(theme());
        tile->setCheckable(true);
        tile->setObjectName(QStringLiteral("new_study.template.%1").arg(QString::fromStdString(m_templates[i].id)));
        tile->setAccessibleName(tr("%1. %2").arg(title, objective));
        auto* words = new QVBoxLayout;
        words->addWidget(kit::label(theme(), title, TextStyle::strong));
        words->addWidget(kit::label(theme(), objective, TextStyle::small, "muted"));
        tile->row()->addLayout(words, 1);
        tile->seal();
        m_choice->addButton(tile, static_cast<int>(i));
        m_list->layout()->addWidget(tile);
    }
    m_choice->button(0)->setChecked(true);
    m_choice->button(0)->setFocus();
    choose(0);
}

void NewStudyDialog::choose(int index) {
    const psychophysics::StudyDesign& design = m_templates[static_cast<std::size_t>(index)];
    m_title->setText(study_words::text(design.title, QStringLiteral("en")));
    m_key->setText(QString::fromStdString(design.id));
    renew();
}

void NewStudyDialog::renew() {
    form::setKind(m_key, isKey(m_key->text()) || m_key->text().isEmpty() ? "" : "bad");
    setAcceptable(m_choice->checkedId() >= 0 && isKey(m_key->text()) && !m_title->text().trimmed().isEmpty());
}

void NewStudyDialog::submit() {
    setWorking(true);
    psychophysics::StudyDesign design = m_templates[static_cast<std::size_t>(m_choice->checkedId())];
    design.id = m_key->text().toStdString();
    design.title["en"] = m_title->text().trimmed().toStdString();
    writeStudies(
        context(), this,
        [design](database::StudyRepository& studies) {
            return studies.createStudy(design.id, design.title.at("en"), catalogue::studyJson(design).toStdString());
        },
        [this](const core::Result<database::StudyNumber>& study) {
            setWorking(false);
            if (!study) {
                say("bad", tr("The study was not created. Its key may already be in use.\n%1").arg(inWords(study.error())));
                return;
            }
            emit created(*study);
            accept();
        });
}

} // namespace chiron::desktop
