// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/first_start/site_maker.h"
#include "desktop/frame/screen.h"

#include <QPointer>

class QPushButton;
class QComboBox;
class QVBoxLayout;

namespace chiron::desktop {

class AdministratorPage;
class PageFooter;
class RecoveryCodePanel;
class ScrollPage;
class StatePanel;

/// The first screen on a new station: set up a site with its administrator, or open the demonstration. It
/// also appears if the database contains no people yet.
class FirstStartScreen final : public Screen {
    Q_OBJECT
public:
    FirstStartScreen(AppContext& context, const Place& place);
    ~FirstStartScreen() override; ///< cancels a demonstration that is being made

    QString title() const override;
    QString help() const override;
    void enter() override;
    bool mayLeave() override;

    /// The file of this station's demonstration. It lies beside the site's own database, so that both can
    /// exist.
    static QString demonstrationFile(const QString& siteFile);

private:
    void showWelcome();
    void showAdministrator();
    void showDemonstration();
    void showRecoveryCode(const QString& name, const QString& code);
    QWidget* choice(const QString& icon, const QString& title, const QString& text, QPushButton* button);
    /// `foot`: the page's buttons, which stay in sight below it.
    void setPage(QWidget* page, QWidget* foot = nullptr);
    void makeSiteFor(const AdministratorRequest& request);
    void siteMade(const AdministratorRequest& request, core::Result<MadeSite> made);
    void demonstrationMade(core::Result<MadeSite> made);

    std::shared_ptr<WorkToken> m_work; ///< of the demonstration being made
    QComboBox* m_language;
    ScrollPage* m_scroll;
    PageFooter* m_footer;
    QVBoxLayout* m_room = nullptr;
    QWidget* m_page = nullptr;
    QPointer<AdministratorPage> m_administrator;
    QPointer<RecoveryCodePanel> m_code;
    QPointer<StatePanel> m_progress;
    QPointer<QWidget> m_back; ///< shown if the demonstration failed
    database::Actor m_actor = database::Actor::anonymous();
};

} // namespace chiron::desktop
