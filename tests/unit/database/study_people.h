// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study_site.h"

#include <memory>
#include <string>

namespace chiron::test {

using namespace chiron::database;

/// A new database with an administrator and a researcher, for each test of studies.
class StudyPeople {
protected:
    void begin() {
        m = std::make_unique<DatabaseFixture>();
        REQUIRE(m->create());
        const auto admin = m->administrator();
        REQUIRE(admin);
        m_admin = *admin;
        const auto ruth = m->person(m_admin, "ruth", {Role::researcher});
        REQUIRE(ruth);
        m_ruth = *ruth;
    }
    template <class F> auto write(const Actor& actor, F job) {
        return m->database->write([&](WriteContext& w) {
            StudyRepository studies(w.connection(), actor);
            return job(studies);
        });
    }
    std::unique_ptr<Connection> reader() { return *m->database->openReader(); }
    StudyNumber frozen(const std::string& key) {
        const auto made = write(m_ruth, [&](StudyRepository& s) -> core::Result<StudyNumber> {
            const auto study = s.createStudy(key, "Title", someDesign(key));
            const auto sha = study ? s.freezeStudy(*study) : tl::unexpected(study.error());
            return sha ? study : tl::unexpected(sha.error());
        });
        return made.value_or(0);
    }
    ParticipantNumber consented(StudyNumber study) {
        return write(m_ruth, [&](StudyRepository& s) { return enrol(s, m_ruth, study, true); }).value_or(0);
    }

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous();
    Actor m_ruth = Actor::anonymous();
};

} // namespace chiron::test
